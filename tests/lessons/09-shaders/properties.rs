use camera::lookat;
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec2, Vec3};
use gouraud::corner_normals;
use proptest::prelude::*;
use shaders::{Framebuffer, METHODS, SHADERS, Uniforms, fit};
use transforms::{place, projection, viewport};
use verify::method;

const BOTH: Attributes = Attributes { normals: true, uvs: true };
const SIDE: u16 = 96;

/// A sphere of 440 triangles, its numbers rounded to 1/4096, so that moving it by eighths rounds nothing.
fn sphere(offset: Vec3) -> Model {
    let mesh = assets::sphere::sphere(12, 20);
    let mut text = String::new();
    for p in &mesh.positions {
        let p = (p.as_vec3() * 4096.0).round() / 4096.0 + offset;
        text += &format!("v {} {} {}\n", p.x, p.y, p.z);
    }
    for (keyword, line) in mesh.to_obj().lines().filter_map(|line| line.split_once(' ')) {
        if keyword != "v" && keyword != "#" {
            text += &format!("{keyword} {line}\n");
        }
    }
    Model::parse(text.as_bytes(), BOTH).unwrap()
}

fn texture() -> Image {
    let mut texture = Image::new(16, 16, Format::Rgb);
    for (x, y, _) in texture.clone().pixels() {
        texture.set(x, y, Color::random((x * 16 + y) as u64));
    }
    texture
}

/// An eye outside the sphere, and a centre in it.
fn eye_and_center() -> impl Strategy<Value = (Vec3, Vec3)> {
    let inside = (-0.5f32..0.5, -0.5f32..0.5, -0.5f32..0.5).prop_map(Vec3::from);
    let outside = (-3.0f32..3.0, -3.0f32..3.0, -3.0f32..3.0).prop_map(Vec3::from);
    // On a grid of 1/256, as the sphere is on one of 1/4096.
    let snapped = |v: Vec3| (v * 256.0).round() / 256.0;
    (outside.prop_filter("inside", |eye| eye.length() > 1.5), inside)
        .prop_map(move |(eye, c)| (snapped(eye), snapped(c)))
}

fn to_clip(eye: Vec3, center: Vec3) -> Mat4 {
    fit(0.4, Vec2::ONE) * projection(eye.distance(center)) * lookat(eye, center, Vec3::Y).unwrap()
}

fn draw(
    model: &Model,
    texture: &Image,
    to_clip: Mat4,
    light: Vec3,
    levels: u16,
    shader: &str,
    way: &str,
) -> (Framebuffer, usize) {
    let normals = corner_normals(model);
    let uniforms = Uniforms {
        normals: &normals,
        texture: Some(texture),
        light,
        to_clip,
        levels,
        ..Uniforms::new(model)
    };
    let mut target = Framebuffer::new(Image::new(SIDE, SIDE, Format::Rgb));
    let left_out = method(METHODS, way)(method(SHADERS, shader))(&uniforms, &mut target);
    (target, left_out)
}

/// The distance of a pixel's centre from the nearest side of a triangle.
fn distance_to_sides(corners: [Vec2; 3], x: i32, y: i32) -> f32 {
    let p = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
    let sides = [[corners[0], corners[1]], [corners[1], corners[2]], [corners[2], corners[0]]];
    let to_side = |[a, b]: [Vec2; 2]| {
        let along = b - a;
        let t = ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        p.distance(a + along * t)
    };
    sides.into_iter().map(to_side).fold(f32::INFINITY, f32::min)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// From anywhere, under any light: the same colours, the same depths, the same count.
    #[test]
    fn dyn_and_generic_agree((eye, center) in eye_and_center(), light in eye_and_center(), levels in 1..20u16) {
        let (model, texture) = (sphere(Vec3::ZERO), texture());
        for shader in SHADERS {
            let [a, b] = ["dyn", "generic"].map(|way| {
                draw(&model, &texture, to_clip(eye, center), light.0.normalize(), levels, shader.name, way)
            });
            prop_assert!(a.0.image == b.0.image && a.0.depths == b.0.depths && a.1 == b.1, "{}", shader.name);
        }
    }

    /// Model and camera moved together by eighths: corners move by less than 1/256 px, and no pixel changes but
    /// those that a side passes within 1/64 px of: a corner may be rounded to the next 1/256 px, and a side that
    /// is far longer than its distance from the pixel moves by no more than its corners do.
    #[test]
    fn moving_all_together_changes_next_to_nothing(
        (eye, center) in eye_and_center(), offset in (-64..64i32, -64..64i32, -64..64i32),
    ) {
        let offset = Vec3::new(offset.0 as f32, offset.1 as f32, offset.2 as f32) / 8.0;
        let texture = texture();
        let [(here, m), (there, n)] =
            [Vec3::ZERO, offset].map(|by| (sphere(by), to_clip(eye + by, center + by)));
        let mut sides = Vec::new();
        for (a, b) in here.faces().zip(there.faces()) {
            prop_assert!(a.iter().zip(b).all(|(a, b)| *a + offset == b), "the sums are exact");
            let window = viewport(f32::from(SIDE), f32::from(SIDE), 0.5);
            let [Some(a), Some(b)] = [(window * m, a), (window * n, b)].map(|(m, corners)| {
                let [a, b, c] = corners.map(|corner| place(&m, corner));
                Some([a?, b?, c?])
            }) else { continue };
            let moved = a.iter().zip(b).map(|(a, b)| a.truncate().distance(b.truncate())).fold(0.0, f32::max);
            // Near the eye a pixel is a long way.
            let near = a.iter().any(|corner| corner.truncate().abs().max_element() > 1e3);
            prop_assert!(moved < 1.0 / 256.0 || near, "a corner moved by {moved} px");
            sides.push(a.map(Vec3::truncate));
        }
        let [a, b] = [(&here, m), (&there, n)].map(|(model, m)| draw(model, &texture, m, Vec3::Z, 6, "flat", "generic").0);
        for (x, y, color) in a.image.pixels() {
            if b.image.get(x, y) != Some(color) {
                let nearest = sides.iter().map(|&corners| distance_to_sides(corners, x, y)).fold(f32::INFINITY, f32::min);
                prop_assert!(nearest < 1.0 / 64.0, "({x}, {y}) changed, {nearest} px from a side");
            }
        }
    }
}
