//! Chapter 16: a scene.

use std::sync::Arc;

use clipping::Cull;
use clipping::clip::{ClipVertex, Polygon, clip};
use common::{Color, Image, Mat4, Vec2, Vec3, Vec4, Vec4Swizzles};
use lighting::PointLight;
use perspective::perspective;
use scene::head::{STAGES, Stage};
use scene::levels::{Sizes, spheres};
use scene::versions::orthographic;
use scene::{
    Entity, Filtering, Levels, METHODS, Mesh, Paint, Scene, Shading, Shape, Style, Target, VERSIONS, Version,
    orbit, render_scene, sphere,
};
use transforms::inverse::rigid;

use super::sketches::{around, chord, frustum, handed, held, levels, parts, rows};
use crate::figures::picture::{cut, method, model, painted, texture};
use crate::figures::{Drawing, Figure};
use crate::lessons::filtering::figures::{THIRD, rows_of};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "scene-default",
        "A head on a floor that reaches to the horizon, with crates and spheres around it, one of them of glass.",
        default,
    ),
    Figure::new(
        "scene-parts",
        "A box for the scene with three entities and two lights in it. Arrows lead from two of the entities to one mesh, a cube, \
         and from the third to a sphere. The camera stands outside.",
        parts,
    ),
    Figure::new(
        "scene-versions-0",
        "Four pictures: a white rectangle and a white ellipse; a small triangle between red, green and blue; a red rectangle \
         that runs into a blue ellipse; the same with light on the ellipse.",
        || versions([0, 1, 2, 3]),
    ),
    Figure::new(
        "scene-versions-4",
        "Four pictures: a red cube and a blue sphere, turned, with a highlight; the same in perspective, the sphere round; a \
         wooden crate; the lines of a crate and of a sphere.",
        || versions([4, 5, 6, 7]),
    ),
    Figure::new(
        "scene-versions-8",
        "Four pictures: a large crate and a small one before it that one sees through; crates and a sphere from above; the same \
         with smooth sides; the course's own scene.",
        || versions([8, 9, 10, 11]),
    ),
    Figure::new(
        "scene-cut",
        "A cube and a sphere from the side, twice. On the left the half that is turned away from the camera is missing and one \
         sees into both; on the right both are whole.",
        cut_in_half,
    ),
    Figure::new(
        "scene-fifths",
        "A white rectangle and a white ellipse, twice. On the right they are twice as large and half outside of the picture.",
        fifths,
    ),
    Figure::new(
        "scene-handed",
        "Two spaces with x to the right and y up. On the left z points away, and a cube and a ball stand at z = 3 and 5. On the \
         right z points towards the reader, and they stand at −3 and −5.",
        handed,
    ),
    Figure::new(
        "scene-negative",
        "A head, its mirror image with the inside of its back showing, and its mirror image as it should be.",
        negative,
    ),
    Figure::new(
        "scene-orbit",
        "Three axes, a circle around them, and a camera above it. An arc on the ground from z towards x is marked φ, an arc \
         upwards ε, and the line to the camera r. At the camera two arrows: right, which is level, and up.",
        around,
    ),
    Figure::new(
        "scene-rows",
        "A ball of triangles, and the same laid flat as a rectangle of twelve columns and six rows; the first and the last row \
         are single triangles. The dots of the first and of the last column, and those of the poles, are marked.",
        rows,
    ),
    Figure::new(
        "scene-seam",
        "A globe in the colours of the rainbow with a net of lines, three times: as it should be; with all its colours once more \
         within one column; with colours that run together askew at the pole.",
        seam,
    ),
    Figure::new(
        "scene-chord",
        "An arc with one chord, and the same arc with two. The distances between arc and chord are marked; on the right they are \
         a quarter of that on the left.",
        chord,
    ),
    Figure::new(
        "scene-silhouettes",
        "The upper part of a bright ball on a dark ground, three times: with corners, and twice round.",
        silhouettes,
    ),
    Figure::new(
        "scene-levels",
        "Error in pixels against distance, both logarithmic. Three slanted lines, one below the other, and a saw whose teeth \
         stay below a dashed line at half a pixel.",
        levels,
    ),
    Figure::new(
        "scene-heads",
        "A head in wireframe, six times, from few triangles to so many that no gap between the lines is left.",
        heads,
    ),
    Figure::new(
        "scene-frustum",
        "A frustum from above, and twelve discs: those that touch it are blue, those outside grey, and one beside a far corner is \
         orange.",
        frustum,
    ),
    Figure::new(
        "scene-held",
        "Two charts of a distance that falls over a second. On the left three stairs that end at different heights; on the right \
         three stairs along one curve, which end at one height.",
        held,
    ),
    Figure::new(
        "scene-leaning",
        "Crates and a sphere from above, upright, and the same scene leaning to one side.",
        leaning,
    ),
];

/// Those of a row of the lesson's table.
pub(crate) fn sizes(name: &str) -> anyhow::Result<Sizes> {
    Ok(*method(METHODS, name)?)
}

/// A picture of a scene from a camera's own matrix.
fn picture(
    scene: &Scene,
    projection: Mat4,
    camera: Mat4,
    [width, height]: [u16; 2],
    wireframe: bool,
) -> anyhow::Result<Image> {
    let mut target = Target::new(width, height);
    (target.antialiased, target.wireframe) = (true, wireframe);
    let inverse = rigid(&camera);
    render_scene(scene, &mut target, &projection, &inverse);
    Ok(target.into_picture())
}

/// The ratio of width to height.
fn aspect([width, height]: [u16; 2]) -> f32 {
    f32::from(width) / f32::from(height)
}

/// A version at a second, as its camera sees it at first.
fn version(number: usize, seconds: f64, size: [u16; 2], wireframe: bool) -> anyhow::Result<Image> {
    let version: &Version = &VERSIONS[number];
    let mut scene = (version.scene)(sizes("by-size")?)?;
    if let Some(animate) = version.animate {
        animate(&mut scene, seconds);
    }
    let camera = version.camera.map_or(Mat4::IDENTITY, |orbit| orbit.camera());
    let projection = (version.projection)(Vec2::new(size[0].into(), size[1].into()));
    let mut target = Target::new(size[0], size[1]);
    target.antialiased = version.antialiasing;
    target.wireframe = wireframe;
    let inverse = rigid(&camera);
    render_scene(&scene, &mut target, &projection, &inverse);
    Ok(target.into_picture())
}

fn default() -> anyhow::Result<Drawing> {
    Ok(Drawing::Pixels(version(11, 0.0, [896, 672], false)?, 1))
}

/// Four versions, two in a row.
fn versions(numbers: [usize; 4]) -> anyhow::Result<Drawing> {
    // Each drawn in the size in which it is stated.
    let draw = |number| version(number, 1.0, [1024, 768], number == 7).map(|image| image.scale(446, 334));
    let [a, b, c, d] = numbers.map(draw);
    rows_of(&[vec![a?, b?], vec![c?, d?]])
}

/// What of an entity's mesh lies before a plane of the world, all in the world's coordinates.
fn cut_by(shape: &Shape, to_world: Mat4, plane: Vec4) -> Shape {
    let mut cut = Shape { vertices: Vec::new(), triangles: Vec::new() };
    for triangle in &shape.triangles {
        let corners = triangle.map(|n| {
            let vertex = shape.vertices[n as usize];
            ClipVertex { position: to_world * vertex.position.extend(1.0), varying: vertex.normal }
        });
        let left = clip(&Polygon::new(&corners), plane);
        let first = cut.vertices.len() as u32;
        let corners = left.corners();
        cut.vertices.extend(corners.iter().map(|corner| scene::Vertex {
            position: corner.position.xyz(),
            normal: to_world.transform_vector3(corner.varying).normalize_or_zero(),
            uv: Vec2::ZERO,
        }));
        cut.triangles.extend((2..corners.len() as u32).map(|n| [first, first + n - 1, first + n]));
    }
    cut
}

fn cut_in_half() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [446, 334];
    let version = &VERSIONS[4];
    let shapes = [scene::cube(), sphere(24, 48)];
    let draw = |far: f32| {
        let mut scene = (version.scene)(sizes("32x64")?)?;
        if let Some(animate) = version.animate {
            animate(&mut scene, 0.9);
        }
        scene.style.cull = Cull::None;
        // Looked at from aside, where the plane is seen from its edge.
        let lamp = PointLight { position: Vec3::new(2.0, 5.0, -7.0), ambient: 0.35, ..PointLight::default() };
        scene.lights = vec![lamp];
        scene.background = Color::rgb(0xd9, 0xd6, 0xcc);
        for (entity, shape) in scene.entities.iter_mut().zip(&shapes) {
            let Paint::Color(color) = *entity.levels.finest().paint() else { continue };
            let before = cut_by(shape, entity.to_world(), Vec4::new(0.0, 0.0, 1.0, far));
            *entity = Entity::new(Levels::one(Mesh::new(&before, Paint::Color(color))));
        }
        let projection = perspective(34.0, aspect(SIZE), 0.1, 100.0)?;
        let camera = Mat4::from_translation(Vec3::NEG_Z * 2.0) * orbit(194.0, 30.0, 4.6);
        picture(&scene, projection, camera, SIZE, false)
    };
    rows_of(&[vec![draw(2.0)?, draw(4.0)?]])
}

fn fifths() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [446, 334];
    let scene = (VERSIONS[0].scene)(sizes("32x64")?)?;
    let fifth = orthographic(Vec2::new(446.0, 334.0));
    let two = Mat4::from_scale(Vec3::new(2.0, 2.0, 1.0)) * fifth;
    rows_of(&[vec![
        picture(&scene, fifth, Mat4::IDENTITY, SIZE, false)?,
        picture(&scene, two, Mat4::IDENTITY, SIZE, false)?,
    ]])
}

/// The course's head, textured.
fn head() -> anyhow::Result<Arc<Levels>> {
    let model = model()?;
    let mipmap = *method(filtering::MIPMAPS, "box-linear")?;
    let texture = mipmap.texture(&texture()?, filtering::Wrap::Clamp);
    let shape = Shape::of(&model, &gouraud::corner_normals(&model));
    Ok(Levels::one(Mesh::new(&shape, Paint::Texture(Arc::new(texture)))))
}

/// How the figures of this chapter are drawn.
const LIT: Style = Style { shading: Shading::BlinnPhong, filter: Filtering::Trilinear, cull: Cull::Back };

/// Entities before a dark ground, lit from the upper right.
fn before_dark(entities: Vec<Entity>, style: Style) -> Scene {
    Scene {
        entities,
        lights: vec![PointLight {
            position: Vec3::new(2.0, 2.0, 3.0),
            ambient: 0.4,
            ..PointLight::default()
        }],
        background: Color::rgb(0x18, 0x1c, 0x24),
        style,
    }
}

fn negative() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [THIRD, 340];
    let head = head()?;
    let draw = |scale: Vec3, cull: Cull| {
        let entity = Entity { scale, ..Entity::new(head.clone()) };
        let scene = before_dark(vec![entity], Style { cull, ..LIT });
        picture(&scene, perspective(45.0, aspect(SIZE), 0.1, 100.0)?, orbit(25.0, 8.0, 2.6), SIZE, false)
    };
    let mirrored = Vec3::new(-1.0, 1.0, 1.0);
    // Without the swap, what the scene leaves out is what is left out: its opposite, after the swap.
    rows_of(&[vec![draw(Vec3::ONE, Cull::Back)?, draw(mirrored, Cull::Front)?, draw(mirrored, Cull::Back)?]])
}

/// A rainbow around the globe, with a net of meridians and parallels.
fn globe() -> Image {
    const SIZE: [u16; 2] = [1024, 512];
    painted(SIZE[0], SIZE[1], |x, y| {
        let [u, v] = [x as f32 / f32::from(SIZE[0]), y as f32 / f32::from(SIZE[1])];
        let near_line = |t: f32, lines: f32, width: f32| {
            let off = (t * lines - (t * lines).round()).abs() / lines;
            off < width
        };
        let hue = |shift: f32| 0.5 + 0.5 * ((u + shift) * std::f32::consts::TAU).cos();
        let color = [hue(0.0), hue(1.0 / 3.0), hue(2.0 / 3.0)].map(|part| 0.4 + 0.6 * part);
        let line = near_line(u, 12.0, 0.0022) || near_line(v, 6.0, 0.0044);
        let [r, g, b] = color.map(|part| (255.0 * if line { 0.25 * part } else { part }) as u8);
        Color::rgb(r, g, b)
    })
}

fn seam() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [THIRD; 2];
    let right = sphere(12, 24);
    let mipmap = *method(filtering::MIPMAPS, "box-linear")?;
    let texture = Arc::new(mipmap.texture(&globe(), filtering::Wrap::Repeat));
    // The last column's vertices are those of the first one.
    let mut without_seam = right.clone();
    for triangle in &mut without_seam.triangles {
        for n in triangle {
            let vertex = right.vertices[*n as usize];
            let first = |other: &scene::Vertex| other.position == vertex.position && other.uv.x == 0.0;
            if vertex.uv.x == 1.0 {
                *n = right.vertices.iter().position(first).unwrap_or(0) as u32;
            }
        }
    }
    let mut one_pole = right.clone();
    for vertex in one_pole.vertices.iter_mut().filter(|vertex| [0.0, 1.0].contains(&vertex.uv.y)) {
        vertex.uv.x = 0.5;
    }
    let draw = |shape: &Shape| {
        let mesh = Mesh::new(shape, Paint::Texture(texture.clone()));
        let mut scene = before_dark(vec![Entity::new(Levels::one(mesh))], LIT);
        (scene.lights[0].ambient, scene.lights[0].specular) = (0.75, 0.1);
        picture(&scene, perspective(30.0, 1.0, 0.1, 100.0)?, orbit(12.0, 42.0, 4.3), SIZE, false)
    };
    rows_of(&[[right, without_seam, one_pole].iter().map(draw).collect::<anyhow::Result<Vec<Image>>>()?])
}

fn silhouettes() -> anyhow::Result<Drawing> {
    const SIDE: u16 = 400;
    // Of radius 180 in a picture of 400, seen from so far away that the outline is nearly the equator.
    let distance: f32 = 40.0;
    let half = ((1.0 / distance).asin().tan() * 200.0 / 180.0).atan();
    let projection = perspective(2.0 * half.to_degrees(), 1.0, 1.0, 100.0)?;
    let draw = |name: &str| -> anyhow::Result<Image> {
        let ball = spheres(sizes(name)?, &Paint::Color(Color::rgb(0xf2, 0xc1, 0x4e)));
        let mut scene =
            before_dark(vec![Entity { degrees: Vec3::new(90.0, 0.0, 0.0), ..Entity::new(ball) }], LIT);
        scene.lights[0] = PointLight {
            position: Vec3::new(10.0, 60.0, 30.0),
            ambient: 0.4,
            diffuse: 0.6,
            ..scene.lights[0]
        };
        let image = picture(&scene, projection, orbit(0.0, 0.0, distance), [SIDE; 2], false)?;
        let part = cut(&image, [126, 316], [148, 72]);
        Ok(part.scale(THIRD, 144))
    };
    rows_of(&[["8x16", "32x64", "by-size"].into_iter().map(draw).collect::<anyhow::Result<Vec<Image>>>()?])
}

fn heads() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [THIRD, 330];
    let draw = |stage: &Stage| {
        let mesh = stage.mesh(&Paint::Color(Color::rgb(0xf2, 0xc1, 0x4e)))?;
        // Where lines lie close, one sees that they are many.
        let scene = before_dark(vec![Entity { alpha: 0.45, ..Entity::new(Levels::one(mesh)) }], LIT);
        picture(&scene, perspective(45.0, aspect(SIZE), 0.1, 100.0)?, orbit(25.0, 8.0, 2.6), SIZE, true)
    };
    let all = STAGES.iter().map(draw).collect::<anyhow::Result<Vec<Image>>>()?;
    rows_of(&all.chunks(3).map(<[Image]>::to_vec).collect::<Vec<_>>())
}

fn leaning() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [446, 334];
    let version = &VERSIONS[9];
    let scene = (version.scene)(sizes("by-size")?)?;
    let projection = (version.projection)(Vec2::new(446.0, 334.0));
    let [turn, lift] = [Mat4::from_rotation_y(0.7), Mat4::from_rotation_x(-0.5)];
    let back = Mat4::from_translation(Vec3::Z * 5.0);
    rows_of(&[vec![
        picture(&scene, projection, turn * lift * back, SIZE, false)?,
        picture(&scene, projection, lift * turn * back, SIZE, false)?,
    ]])
}
