//! Pictures with a fault put in, each beside the right one.

use anyhow::Context;
use blending::blend::BlendStage;
use blending::{Blend, Factor};
use common::{Color, Image, Mat4, Model, Quat, Vec2, Vec3};
use gouraud::corner_normals;
use textures::{interpolate, texel};
use transforms::{normal_matrix, place, projection, scale, translate, viewport};
use triangles::barycentric::weights;
use triangles::{flat_intensity, to_screen};
use zbuffer::{DepthBuffer, fill_nearest};

use crate::figures::picture::{all_beside, beside, canvas, chequered as squares, model, painted};
use crate::figures::{Drawing, Figure};
use crate::lessons::filtering::figures::to_the_horizon;
use crate::lessons::perspective::figures::{ball_before, two_floors, two_triangles};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new("wrong-upside-down", "A model, and the same standing on its head.", upside_down),
    Figure::new(
        "wrong-farthest",
        "A box of which three sides can be seen, and the same box with the three far sides in front, as if seen from \
         inside.",
        farthest,
    ),
    Figure::new(
        "wrong-light",
        "A model lit from the right, and the same model lit from the left, though the light stands on the right.",
        light,
    ),
    Figure::new(
        "wrong-wrapped",
        "A model that is dark on one side, and the same model with bands of bright grey where it should be black.",
        wrapped,
    ),
    Figure::new(
        "wrong-facets",
        "A smoothly shaded model, and the same model with a visible facet for every triangle.",
        facets,
    ),
    Figure::new(
        "wrong-holes",
        "A model enlarged until single pixels show, and the same with black pixels along the triangles' sides.",
        holes,
    ),
    Figure::new(
        "wrong-texture",
        "A model that wears a chequered texture with a letter F, and the same with the letters upside down.",
        texture_upside_down,
    ),
    Figure::new(
        "wrong-corners",
        "A model that wears a chequered texture, and the same with the texture torn into turned pieces.",
        corners,
    ),
    Figure::new(
        "wrong-order",
        "A small box that stands on the right, turned where it stands, and the same box higher up, since it was \
         turned about the origin after it had been moved.",
        order,
    ),
    Figure::new(
        "wrong-perspective",
        "A box in perspective, its near side larger than its far side, and the same box with its near side smaller.",
        perspective,
    ),
    Figure::new(
        "wrong-normals",
        "A model pressed flat and lit from above, and the same model whose light and shade are those of a round one.",
        normals,
    ),
    Figure::new(
        "wrong-center",
        "A model in the middle of the picture, and the same model at the picture's border.",
        off_center,
    ),
    Figure::new(
        "wrong-affine",
        "A chequered floor of two triangles with straight lines, and the same floor with lines that break at a diagonal.",
        || all_beside(["per-pixel", "affine"].map(two_triangles)),
    ),
    Figure::new(
        "wrong-fighting",
        "A blue floor to the horizon, and the same floor with orange stripes in its far half.",
        || all_beside(["reversed-z-f32", "z24"].map(|keep| two_floors(keep, 440))),
    ),
    Figure::new(
        "wrong-sparkles",
        "A chequered floor that fades evenly towards the horizon, and the same floor with grains and false patterns there.",
        || all_beside(["trilinear", "nearest"].map(to_the_horizon)),
    ),
    Figure::new(
        "wrong-exchanged",
        "A solid red disc, a half-solid yellow one and a faint blue one over squares of grey; and the same with the red one gone and \
         the blue one nearly solid.",
        exchanged,
    ),
    Figure::new(
        "wrong-aspect",
        "A ball in a wide picture, and the same ball as wide as the picture is.",
        aspect,
    ),
];

/// Width and height of a picture.
const SIDE: u16 = 440;

/// Where a picture's light comes from, unless the fault is about light.
const LIGHT: Vec3 = Vec3::new(0.577_350_26, 0.577_350_26, 0.577_350_26);

fn size() -> Vec2 {
    Vec2::splat(f32::from(SIDE))
}

/// Draws a model, the nearest surface in front: `put` places a point, `color` colours a pixel by the number of
/// the triangle and its weights there, or leaves it out.
fn picture(
    model: &Model,
    put: impl Fn(Vec3) -> Option<Vec3>,
    color: impl Fn(usize, Vec3) -> Option<Color>,
) -> Image {
    let mut image = canvas(SIDE);
    let mut depths = DepthBuffer::new(&image, f32::NEG_INFINITY);
    for (n, corners) in model.faces().enumerate() {
        if let [Some(a), Some(b), Some(c)] = corners.map(&put) {
            let store = |depth| depth;
            fill_nearest([a, b, c], &mut depths, store, |x, y, weights| {
                if let Some(color) = color(n, weights) {
                    image.set(x, y, color);
                }
            });
        }
    }
    image
}

/// Places points without perspective, as lessons 4 to 6 do.
fn straight(point: Vec3) -> Option<Vec3> {
    Some(zbuffer::to_screen(point, size()))
}

/// Places points by a matrix in front of the viewport.
fn by(m: Mat4) -> impl Fn(Vec3) -> Option<Vec3> {
    let m = viewport(f32::from(SIDE), f32::from(SIDE), 0.4) * m;
    move |point: Vec3| place(&m, point)
}

/// Gouraud's brightness under a light.
fn smooth(model: &Model, light: Vec3) -> impl Fn(usize, Vec3) -> f32 {
    let normals = corner_normals(model);
    move |n, weights| gouraud::intensities(normals[n], light).dot(weights)
}

/// Greys by a brightness.
fn gray(intensity: impl Fn(usize, Vec3) -> f32) -> impl Fn(usize, Vec3) -> Option<Color> {
    move |n, weights| Some(Color::gray(intensity(n, weights)))
}

fn flat(model: &Model, light: Vec3) -> Vec<f32> {
    model.faces().map(|corners| flat_intensity(corners, light)).collect()
}

fn upside_down() -> anyhow::Result<Drawing> {
    let model = model()?;
    let right = picture(&model, straight, gray(smooth(&model, LIGHT)));
    let mut wrong = right.clone();
    wrong.flip_vertically();
    beside([&right, &wrong])
}

fn farthest() -> anyhow::Result<Drawing> {
    let model = cube()?;
    let right = by(tilted());
    let wrong = |point: Vec3| right(point).map(|p| p.with_z(-p.z));
    beside([&picture(&model, &right, sides), &picture(&model, wrong, sides)])
}

fn light() -> anyhow::Result<Drawing> {
    let model = model()?;
    let from = Vec3::new(0.8, 0.0, 0.6);
    let right = picture(&model, straight, gray(smooth(&model, from)));
    let wrong = picture(&model, straight, gray(smooth(&model, from.with_x(-from.x))));
    beside([&right, &wrong])
}

fn wrapped() -> anyhow::Result<Drawing> {
    let model = model()?;
    let from = Vec3::new(0.96, 0.0, 0.28);
    let right = picture(&model, straight, gray(smooth(&model, from)));
    let intensity = smooth(&model, from);
    let wrong = picture(&model, straight, |n, weights| {
        // Below 0 the last eight bits of a negative integer are left.
        let level = (intensity(n, weights) * 255.0) as i32 as u8;
        Some(Color::rgb(level, level, level))
    });
    beside([&right, &wrong])
}

fn facets() -> anyhow::Result<Drawing> {
    let model = model()?;
    let flat = flat(&model, LIGHT);
    let right = picture(&model, straight, gray(smooth(&model, LIGHT)));
    beside([&right, &picture(&model, straight, gray(|n, _| flat[n]))])
}

fn holes() -> anyhow::Result<Drawing> {
    const SMALL: u16 = 110;
    let model = model()?;
    let size = Vec2::splat(f32::from(SMALL));
    let [mut right, mut wrong] = [(); 2].map(|()| canvas(SMALL));
    for corners in model.faces() {
        let intensity = flat_intensity(corners, Vec3::Z);
        if intensity < 0.0 {
            continue;
        }
        let color = Color::gray(intensity);
        let screen = corners.map(|corner| to_screen(corner, size));
        triangles::fill(screen, right.bounds(), |x, y, _| right.set(x, y, color));
        // Corners cut down to whole pixels, and a centre on a side counted as outside on both sides of it.
        let corners = screen.map(Vec2::floor);
        let bounds = wrong.bounds();
        triangles::barycentric(corners, bounds, |x, y, _| {
            let inside = weights(corners, Vec2::new(x as f32, y as f32));
            if inside.is_some_and(|weights| weights.cmpgt(Vec3::ZERO).all()) {
                wrong.set(x, y, color);
            }
        });
    }
    beside([&right.scale(SIDE, SIDE), &wrong.scale(SIDE, SIDE)])
}

/// A texture that tells its directions: squares, redder to the right, greener to the top, with a letter F.
fn chequered() -> Image {
    const CELLS: i32 = 6;
    const CELL: i32 = 24;
    const SIDE: i32 = CELLS * CELL;
    painted(SIDE as u16, SIDE as u16, |x, y| {
        let (u, v) = (x % CELL, y % CELL);
        let letter = (6..10).contains(&u) && (4..20).contains(&v)
            || (6..18).contains(&u) && (16..20).contains(&v)
            || (6..15).contains(&u) && (10..13).contains(&v);
        let share = |n: i32| (60 + n * 195 / SIDE) as u8;
        let dark = (x / CELL + y / CELL) % 2 == 0;
        let ground = if dark { Color::rgb(share(x), share(y), 120) } else { Color::rgb(235, 230, 215) };
        if letter { Color::rgb(30, 30, 40) } else { ground }
    })
}

/// The chequered texture under light; `look` says where to look it up.
fn textured(model: &Model, look: impl Fn([Vec2; 3], Vec3) -> Vec2) -> Image {
    let texture = chequered();
    let uvs: Vec<[Vec2; 3]> = model.face_uvs().collect();
    let intensity = smooth(model, Vec3::Z);
    picture(model, straight, |n, weights| {
        let uv = look(*uvs.get(n)?, weights);
        Some(texel(&texture, uv).shaded(intensity(n, weights)))
    })
}

fn texture_upside_down() -> anyhow::Result<Drawing> {
    let model = model()?;
    let wrong = |uvs, weights| {
        let uv = interpolate(uvs, weights);
        uv.with_y(1.0 - uv.y)
    };
    beside([&textured(&model, interpolate), &textured(&model, wrong)])
}

fn corners() -> anyhow::Result<Drawing> {
    let model = model()?;
    let wrong = |[a, b, c]: [Vec2; 3], weights| interpolate([b, c, a], weights);
    beside([&textured(&model, interpolate), &textured(&model, wrong)])
}

fn order() -> anyhow::Result<Drawing> {
    let model = cube()?;
    let turn = Mat4::from_quat(Quat::from_rotation_z(0.6));
    let away = translate(Vec3::new(0.6, 0.0, 0.0));
    let small = scale(Vec3::splat(0.5)) * tilted();
    let draw = |m: Mat4| picture(&model, by(m * small), sides);
    beside([&draw(away * turn), &draw(turn * away)])
}

/// A box whose corners have whole coordinates ±1, as twelve triangles.
fn cube() -> anyhow::Result<Model> {
    let corner = |n: u32| {
        let side = |bit: u32| if n & bit == 0 { -1.0 } else { 1.0 };
        Vec3::new(side(1), side(2), side(4))
    };
    // Each face counterclockwise, seen from outside.
    let faces = [[1, 3, 7, 5], [2, 0, 4, 6], [3, 2, 6, 7], [0, 1, 5, 4], [5, 7, 6, 4], [0, 2, 3, 1]];
    let triangles = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Model::from_triangles((0..8).map(corner).collect(), triangles.collect()).map_err(anyhow::Error::msg)
}

/// A colour for each side of the box, two triangles a side.
fn sides(n: usize, _: Vec3) -> Option<Color> {
    const SIDES: [u32; 6] = [0xe69f00, 0x999999, 0xf0e442, 0x009e73, 0x0072b2, 0xd55e00];
    let [_, r, g, b] = SIDES.get(n / 2)?.to_be_bytes();
    Some(Color::rgb(r, g, b))
}

/// A turn in which three sides of the box can be seen.
fn tilted() -> Mat4 {
    Mat4::from_quat(Quat::from_rotation_x(0.5) * Quat::from_rotation_y(-0.6)) * scale(Vec3::splat(0.6))
}

fn perspective() -> anyhow::Result<Drawing> {
    let model = cube()?;
    let draw = |d: f32| picture(&model, by(projection(d) * tilted()), sides);
    beside([&draw(2.0), &draw(-2.0)])
}

fn normals() -> anyhow::Result<Drawing> {
    let model = model()?;
    let flat = Mat4::from_scale(Vec3::new(1.0, 0.4, 1.0));
    let light = Vec3::new(0.0, 0.8, 0.6);
    let normals = corner_normals(&model);
    let upright = normal_matrix(&flat).context("the scale has an inverse")?;
    let draw = |m: common::Mat3| {
        picture(&model, by(flat), |n, weights| {
            let turned = normals[n].map(|normal| (m * normal).normalize_or_zero());
            Some(Color::gray(gouraud::intensities(turned, light).dot(weights)))
        })
    };
    beside([&draw(upright), &draw(common::Mat3::from_mat4(flat))])
}

fn off_center() -> anyhow::Result<Drawing> {
    let model = model()?;
    let (eye, center) = (Vec3::new(2.5, 1.0, 1.5), Vec3::new(0.9, 0.0, 0.3));
    let away = translate(center) * scale(Vec3::splat(0.6));
    let shade = smooth(&model, LIGHT);
    let draw = |view: Option<Mat4>| -> anyhow::Result<Image> {
        let view = view.context("eye and centre are apart")?;
        let m = projection(eye.distance(center)) * view * away;
        Ok(picture(&model, by(m), gray(&shade)))
    };
    let [right, wrong] = [camera::lookat, camera::listing].map(|view| view(eye, center, Vec3::Y));
    beside([&draw(right)?, &draw(wrong)?])
}

fn aspect() -> anyhow::Result<Drawing> {
    all_beside([2.0, 1.0].map(ball_before))
}

fn exchanged() -> anyhow::Result<Drawing> {
    let ground = squares(11, 11, [Color::gray(0.82), Color::gray(0.96)]).scale(SIDE, SIDE);
    let discs = [
        (Vec2::new(165.0, 285.0), Color { a: 255, ..Color::rgb(0xd5, 0x3e, 0x2a) }),
        (Vec2::new(275.0, 270.0), Color { a: 150, ..Color::rgb(0xf2, 0xb1, 0x34) }),
        (Vec2::new(215.0, 165.0), Color { a: 60, ..Color::rgb(0x1f, 0x77, 0xb4) }),
    ];
    let draw = |blend: Blend| {
        painted(SIDE, SIDE, |x, y| {
            let at = Vec2::new(x as f32, y as f32) + 0.5;
            let covering = discs.iter().filter(|(middle, _)| middle.distance(at) < 105.0);
            let below = ground.get(x, y).unwrap_or(Color::WHITE);
            covering.fold(below, |below, &(_, color)| blend.color(color, below))
        })
    };
    let right = Blend::OVER;
    let mut wrong = right;
    (wrong.color.source, wrong.color.destination) = (Factor::OneMinusSrcAlpha, Factor::SrcAlpha);
    beside([&draw(right), &draw(wrong)])
}
