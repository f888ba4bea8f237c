//! The toon look: steps of light inside an outline.

use std::f32::consts::PI;

use assets::cube::cube;
use assets::mesh::{Corner, Mesh};
use clipping::Cull;
use clipping::mesh::indexed;
use common::{Color, DVec3, Format, Image, Mat4, Model, Vec3};
use lighting::reflection::Reflection;
use lighting::toon::{Toon, WIDTH};
use lighting::{LOOKS, Look, Maps, PointLight, Reflected, Scene, blinn_phong};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use textures::Wrap;
use transforms::{affine, scale};
use verify::method;

use crate::stage::BOTH;

/// Width and height of the pictures, and how far off the eye is.
const SIDE: u16 = 401;
const FAR: f32 = 1000.0;

/// Pixels to a length of 1 where the model is.
const SCALE: f32 = 180.0;

/// A model drawn by a look, seen along −z from far away, without perspective as good as.
fn drawn(look: &Look, obj: &str, to_world: Mat4, cull: Cull) -> Image {
    let mut white = Image::new(1, 1, Format::Rgb);
    white.set(0, 0, Color::WHITE);
    let loaded = Loaded::new(Model::parse(obj.as_bytes(), BOTH).unwrap(), white, Wrap::Clamp);
    let mesh = indexed(&loaded.model, &loaded.normals, BOTH);
    let eye = FAR * Vec3::Z;
    let fov = 2.0 * (f32::from(SIDE) / 2.0 / SCALE / FAR).atan().to_degrees();
    let camera =
        perspective(fov, 1.0, FAR - 10.0, FAR + 10.0).unwrap() * view(eye, Vec3::ZERO, Vec3::Y).unwrap();
    let light = PointLight { position: Vec3::new(10.0, 10.0, 30.0), ..PointLight::default() };
    let scene = Scene::placed(&loaded, to_world, camera, eye, light).unwrap();
    let mut image = Image::new(SIDE, SIDE, Format::Rgb);
    (look.draw)(&scene, &Maps::default(), &mesh, cull, &mut image);
    image
}

fn toon(obj: &str, cull: Cull) -> Image {
    drawn(method(LOOKS, "toon"), obj, Mat4::IDENTITY, cull)
}

/// Pixels of paper, of outline and of the body.
fn areas(image: &Image) -> [usize; 3] {
    let count = |wanted: fn(u8) -> bool| image.pixels().filter(|pixel| wanted(pixel.2.r)).count();
    [count(|r| r == 255), count(|r| r == 0), count(|r| r != 0 && r != 255)]
}

/// A disc and a ring around it, as wide as vertices are moved.
#[test]
fn a_sphere_has_a_ring_around_it() {
    let image = toon(&assets::sphere::sphere(60, 120).to_obj(), Cull::Back);
    let [_, ring, disc] = areas(&image);
    let round = |radius: f32| PI * (radius * SCALE).powi(2);
    // From so far away half of it is seen, in its own size.
    let near = |pixels: usize, area: f32| (pixels as f32 / area - 1.0).abs() < 0.01;
    assert!(near(disc, round(1.0)), "{disc} {}", round(1.0));
    assert!(near(disc + ring, round(1.0 + WIDTH)), "{ring}");
    assert!((ring as f32 / (round(1.0 + WIDTH) - round(1.0)) - 1.0).abs() < 0.2, "{ring}");
}

/// The line is as wide in the world, however the model is stretched and turned there.
#[test]
fn a_turned_egg_has_a_ring_as_wide() {
    let [a, b] = [0.9_f32, 0.45];
    let turn = Mat4::from_mat3(affine::euler(Vec3::new(0.0, 0.0, 50.0)));
    let obj = assets::sphere::sphere(60, 120).to_obj();
    let egg = drawn(method(LOOKS, "toon"), &obj, turn * scale(Vec3::new(a, b, b)), Cull::Back);
    let [_, ring, body] = areas(&egg);
    // S. Ramanujan's approximation of an ellipse's circumference.
    let around = PI * (3.0 * (a + b) - ((3.0 * a + b) * (a + 3.0 * b)).sqrt());
    let width = ring as f32 / (around * SCALE * SCALE);
    assert!((width / WIDTH - 1.0).abs() < 0.15 && body > 0, "{width}");
}

/// A cube whose sides have their own normals: where they meet, corners move together, and the outline is closed; since they move
/// along the diagonal, it is less wide, by √3.
#[test]
fn an_outline_has_no_gap_at_an_edge() {
    let image = toon(&cube().to_obj(), Cull::Back);
    let [_, line, body] = areas(&image);
    let sides = [body, body + line].map(|area| (area as f32).sqrt() / SCALE);
    assert!((sides[1] - sides[0] - 2.0 * WIDTH / 3f32.sqrt()).abs() < 0.003, "{sides:?}");
    // No paper touches the body, not even at a corner.
    let is = |x: i32, y: i32, wanted: u8| image.get(x, y).is_some_and(|color| color.r == wanted);
    for (x, y, color) in image.pixels() {
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy)));
        let at_paper = { around }.any(|(x, y)| is(x, y, 255));
        assert!(color.r == 0 || color.r == 255 || !at_paper, "({x}, {y})");
    }
}

/// A sheet that faces the eye has no back behind it, so no outline; from behind it is nothing but outline.
#[test]
fn a_sheet_has_no_outline() {
    let sheet = |n: i32| {
        let corners = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\n";
        let faces = if n > 0 { "f 1/1/1 2/1/1 3/1/1 4/1/1\n" } else { "f 4/1/1 3/1/1 2/1/1 1/1/1\n" };
        format!("{corners}vn 0 0 {n}\n{faces}")
    };
    let whole = (2.0 * SCALE).powi(2) as usize;
    let [_, line, body] = areas(&toon(&sheet(1), Cull::Back));
    assert_eq!((line, body), (0, whole));
    let [_, line, body] = areas(&toon(&sheet(-1), Cull::Back));
    assert_eq!((line.abs_diff(whole) < whole / 50, body), (true, 0), "{line}");
}

/// Corners counted clockwise show the eye their backs: the outline hides the model.
#[test]
fn a_model_turned_inside_out_is_all_outline() {
    let inside_out: String =
        assets::sphere::sphere(20, 40).to_obj().lines().fold(String::new(), |text, line| {
            let line = match line.split_whitespace().collect::<Vec<_>>()[..] {
                ["f", a, b, c] => format!("f {a} {c} {b}"),
                _ => line.into(),
            };
            text + &line + "\n"
        });
    let [_, line, body] = areas(&toon(&inside_out, Cull::Front));
    assert!(line > 10_000 && body == 0, "{line} {body}");
}

/// A part before another has its line there: of two cubes, one partly behind the other.
#[test]
fn what_is_in_front_has_its_line_on_what_is_behind() {
    let mut both = Mesh::default();
    for middle in [DVec3::new(-0.3, 0.0, 0.6), DVec3::new(0.3, 0.0, -0.6)] {
        let cube = cube();
        let [p, u, n] = [both.positions.len(), both.uvs.len(), both.normals.len()];
        let moved = |Corner { position, uv, normal }| Corner {
            position: position + p,
            uv: uv + u,
            normal: normal + n,
        };
        both.positions.extend(cube.positions.into_iter().map(|p| p + middle));
        both.uvs.extend(cube.uvs);
        both.normals.extend(cube.normals);
        both.triangles.extend(cube.triangles.into_iter().map(|triangle| triangle.map(moved)));
    }
    let image = toon(&both.to_obj(), Cull::Back);
    let black = |x: i32| image.get(x, i32::from(SIDE) / 2).is_some_and(|color| color.r == 0);
    let lines: Vec<i32> = (1..i32::from(SIDE)).filter(|&x| black(x) && !black(x - 1)).collect();
    // On the left, where the near one ends before the far one, on the right.
    assert_eq!(lines.len(), 3, "{lines:?}");
}

/// Light in four steps, a highlight or none: whatever the normal.
#[test]
fn light_comes_in_steps() {
    let light = PointLight { shininess: 8.0, ..PointLight::default() };
    let toon = Toon::new(&light);
    let (mut bodies, mut highlights) = (Vec::new(), Vec::new());
    for n in 0..2000 {
        let angle = n as f32 * 0.01;
        let normal = Vec3::new(angle.cos() * 0.8, (angle * 0.7).sin(), (angle * 0.31).sin());
        let [point, eye] = [Vec3::new(0.1, 0.2, 0.0), Vec3::new(0.0, 0.0, 3.0)];
        let Reflected { body, highlight } = toon.reflect(point, normal, eye);
        let smooth = blinn_phong(point, normal, eye, &light);
        // The nearest lower step, of what is there.
        let share = (smooth.body - light.ambient) / light.diffuse;
        let step = (body - light.ambient) / light.diffuse;
        assert!(step <= share + 1e-5 && share < step + 0.25 + 1e-5, "{share} {step}");
        assert_eq!(highlight > 0.0, smooth.highlight >= 0.5 * light.specular, "{smooth:?}");
        bodies.push((step * 4.0).round() as i32);
        highlights.push((highlight * 1000.0).round() as i32);
    }
    for (mut steps, expected) in [(bodies, vec![0, 1, 2, 3]), (highlights, vec![0, 400])] {
        steps.sort_unstable();
        steps.dedup();
        assert_eq!(steps, expected);
    }
}
