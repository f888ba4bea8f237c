//! Chapter 6: smooth shading.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, TAU};
use std::fmt::Write;

use common::{Color, Image, Mat3, Model, Vec2, Vec3};
use gouraud::{METHODS, Scene, Wrap, corner_normals, gouraud, intensities};
use transforms::affine::{rotate_x, rotate_y};
use zbuffer::{DepthBuffer, fill_nearest, to_screen};

use crate::figures::picture::{all_beside, beside, canvas, cut, method, model, painted, texture};
use crate::figures::shape::{ball, parsed};
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREY, ORANGE, PAPER, Sheet};
use crate::figures::{Drawing, Figure};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "gouraud-three",
        "The same textured model three times: in flat colours without any light, with visible facets, and \
         smoothly shaded.",
        three,
    ),
    Figure::new(
        "gouraud-normals",
        "Four sides of a polygon that follows an arc. Grey arrows stand on the middle of each side; blue arrows \
         at the corners point between those of the two sides that meet there.",
        normals,
    ),
    Figure::new(
        "gouraud-profile",
        "Brightness across a sphere cut into strips: the true half circle, the stairs of flat shading, and the \
         chain of straight pieces of Gouraud's, which touches the half circle at each corner.",
        profile,
    ),
    Figure::new(
        "gouraud-weights",
        "A triangle with brightness 0.9, 0.3 and minus 0.5 at its corners. The lines of equal brightness are \
         parallel; the line of 0 cuts the triangle, and what lies beyond it is dark.",
        weights,
    ),
    Figure::new(
        "gouraud-clamp",
        "Two balls of few triangles, lit from the right. On the left one the border of the light is a chain of \
         straight pieces near its true place; on the right one it is ragged and lies too far in the dark.",
        clamp,
    ),
    Figure::new(
        "gouraud-coarse",
        "Three smoothly shaded balls of 24, 440 and 7,520 triangles. The first is a dim star, the second nearly \
         round, the third cannot be told from a sphere but by its highlight.",
        coarse,
    ),
    Figure::new(
        "gouraud-highlight",
        "A triangle that is one eighth of an octahedron, with the light straight above its middle: flat shading \
         makes it white, Gouraud's a middling grey, the sphere that it stands for is bright in the middle.",
        highlight,
    ),
    Figure::new(
        "gouraud-cube",
        "A cube twice: with mean normals its faces seem bulged and its edges soft; with a normal for each face \
         it is a cube.",
        cube,
    ),
    Figure::new(
        "gouraud-encoded",
        "The same half-lit ball twice. With the brightness written as it is, the dark takes up much of the ball; \
         with the brightness encoded as a screen expects it, the lit half is bright nearly up to its border.",
        encoded,
    ),
    Figure::new(
        "gouraud-bands",
        "A column of sixteen sides, flat and smooth. Each flat strip has one grey, yet seems to be lighter on \
         one side than on the other; on the smooth one faint bright lines stand where strips meet.",
        bands,
    ),
];

/// One white texel.
pub(crate) fn white() -> Image {
    painted(1, 1, |_, _| Color::WHITE)
}

/// A smoothly shaded model in a square picture; `put` places a point.
pub(crate) fn smooth(side: u16, scene: &Scene, put: impl Fn(Vec3) -> Option<Vec3>) -> Image {
    let mut image = canvas(side);
    gouraud(scene, &mut image, put);
    image
}

/// A white model by one of the lesson's methods.
fn by(name: &str, model: &Model, light: Vec3, side: u16) -> anyhow::Result<Image> {
    let mut image = canvas(side);
    let scene = Scene { model, normals: &corner_normals(model), texture: &white(), wrap: Wrap::Clamp, light };
    method(METHODS, name)?(&scene, &mut image);
    Ok(image)
}

/// A white model, shrunk a little and turned, smoothly shaded.
fn turned(model: &Model, turn: Mat3, light: Vec3, side: u16) -> Image {
    let normals: Vec<_> =
        corner_normals(model).iter().map(|corners| corners.map(|normal| turn * normal)).collect();
    let scene = Scene { model, normals: &normals, texture: &white(), wrap: Wrap::Clamp, light };
    smooth(side, &scene, |point| Some(to_screen(turn * point * 0.55, Vec2::splat(f32::from(side)))))
}

fn three() -> anyhow::Result<Drawing> {
    let (model, texture) = (model()?, texture()?);
    let light = Vec3::new(0.4, 0.3, 1.0).normalize();
    let scene = Scene {
        model: &model,
        normals: &corner_normals(&model),
        texture: &texture,
        wrap: Wrap::Clamp,
        light,
    };
    all_beside(["none", "flat", "gouraud"].map(|name| {
        let mut image = canvas(1200);
        method(METHODS, name)?(&scene, &mut image);
        // The head alone.
        Ok(cut(&image, [300, 300], [600, 600]))
    }))
}

fn normals() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-3.2, 0.9), (3.2, 3.7));
    let corner = |n: i32| 2.4 * Vec2::from_angle(FRAC_PI_2 - n as f32 * 0.46);
    // Of a side, outward and as long as the side.
    let side = |n: i32| (corner(n) - corner(n + 1)).perp() * -1.0;
    let arc = (-60..=60).map(|n| 2.4 * Vec2::from_angle(FRAC_PI_2 - n as f32 * 0.46 / 20.0));
    sheet.polyline(arc, FAINT, 2.0);
    for n in -3..3 {
        sheet.line(corner(n), corner(n + 1), BLACK, 2.4);
        let middle = (corner(n) + corner(n + 1)) / 2.0;
        let outward = side(n) * side(n).dot(middle).signum();
        sheet.arrow(middle, middle + outward.normalize() * 0.6, GREY);
    }
    for n in -2..=2 {
        let mean = [side(n - 1), side(n)].map(|s| s * s.dot(corner(n)).signum());
        sheet.arrow(corner(n), corner(n) + (mean[0] + mean[1]).normalize() * 0.95, BLUE);
        sheet.dot(corner(n), BLUE);
    }
    sheet.text((0.0, 3.55), "n", BLUE);
    sheet.text((0.0, 1.55), "blue: of a corner", BLUE);
    sheet.text((0.0, 1.2), "grey: of a side", GREY);
    sheet.finish()
}

/// Brightness against x in the picture, for light from the front.
fn profile() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.25, -0.22), (1.25, 1.22));
    let angles: Vec<f32> = (-2..=2).map(|n| n as f32 * FRAC_PI_4).collect();
    sheet.axes((-1.2, 0.0), (0.0, 0.0), (2.4, 1.1), 1.5);
    sheet.polyline((-45..=45).map(|n| (2.0 * n as f32).to_radians().sin_cos()), GREY, 2.4);
    for pair in angles.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let normal = |angle: f32| Vec3::new(angle.sin(), 0.0, angle.cos());
        let corners = intensities([normal(a), normal(b), normal((a + b) / 2.0)], Vec3::Z);
        sheet.line((a.sin(), corners.z), (b.sin(), corners.z), ORANGE, 2.6);
        sheet.line((a.sin(), corners.x), (b.sin(), corners.y), BLUE, 2.6);
        sheet.dot((b.sin(), corners.y.abs()), BLUE);
    }
    sheet.dot((-1.0, 0.0), BLUE);
    sheet.text_right_of((-1.17, 1.08), "brightness", GREY);
    sheet.text((1.0, -0.12), "x = 1", GREY);
    sheet.text((-1.0, -0.12), "x = −1", GREY);
    sheet.text((0.0, 1.12), "the sphere", GREY);
    sheet.text((-0.3, 0.6), "Gouraud", BLUE);
    sheet.text((0.86, 0.28), "flat", ORANGE);
    sheet.finish()
}

fn weights() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.9, -0.6), (7.3, 4.6));
    let corners = [Vec2::new(0.0, 0.2), Vec2::new(6.6, 0.2), Vec2::new(2.4, 4.2)];
    let values = [-0.5_f32, 0.3, 0.9];
    // Where a brightness is found on the sides: at two places, if anywhere.
    let line = |value: f32| -> Vec<Vec2> {
        let on_side = |n: usize| {
            let (i, j) = (n, (n + 1) % 3);
            let t = (value - values[i]) / (values[j] - values[i]);
            (0.0..=1.0).contains(&t).then(|| corners[i].lerp(corners[j], t))
        };
        (0..3).filter_map(on_side).collect()
    };
    sheet.polygon(&corners, AMBER, "none");
    let zero = line(0.0);
    sheet.polygon(&[corners[0], zero[0], zero[1]], GREY, "none");
    for tenth in [-4, -2, 2, 4, 6, 8] {
        let ends = line(tenth as f32 / 10.0);
        sheet.line(ends[0], ends[1], PAPER, 1.6);
    }
    sheet.line(zero[0], zero[1], ORANGE, 3.5);
    sheet.polygon(&corners, "none", BLACK);
    for (corner, value) in corners.iter().zip(values) {
        sheet.dot(*corner, BLACK);
        let below = if corner.y > 1.0 { 0.28 } else { -0.32 };
        let sign = if value < 0.0 { "−" } else { "" };
        sheet.text(*corner + Vec2::new(0.0, below), &format!("{sign}{}", value.abs()), BLACK);
    }
    sheet.text_left_of(zero[1] + Vec2::new(-0.12, 0.15), "0", ORANGE);
    sheet.text_right_of((4.6, 3.1), "each line: one", BLACK);
    sheet.text_right_of((4.6, 2.65), "brightness", BLACK);
    sheet.finish()
}

/// The fault: what is interpolated has been clamped before.
fn clamp() -> anyhow::Result<Drawing> {
    let model = ball(8, 12)?;
    let light = Vec3::new(1.0, 0.35, 0.1).normalize();
    let right = by("gouraud", &model, light, 500)?;
    let mut wrong = canvas(500);
    let size = wrong.size();
    let mut depths = DepthBuffer::new(&wrong, f32::NEG_INFINITY);
    for (corners, normals) in model.faces().zip(corner_normals(&model)) {
        let clamped = intensities(normals, light).max(Vec3::ZERO);
        let screen = corners.map(|corner| to_screen(corner, size));
        let store = |depth| depth;
        fill_nearest(screen, &mut depths, store, |x, y, w| wrong.set(x, y, Color::gray(clamped.dot(w))));
    }
    beside([&right, &wrong])
}

fn coarse() -> anyhow::Result<Drawing> {
    let light = Vec3::new(0.5, 0.5, 0.7).normalize();
    let sizes = [(4, 4), (12, 20), (48, 80)];
    all_beside(sizes.map(|(bands, sectors)| by("gouraud", &ball(bands, sectors)?, light, 500)))
}

fn highlight() -> anyhow::Result<Drawing> {
    let eighth =
        parsed("v 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\nf 1/1/1 2/1/2 3/1/3\n")?;
    let light = Vec3::ONE.normalize();
    // So that the triangle faces the reader, as large as the picture.
    let turn = rotate_x(35.264) * rotate_y(-45.0);
    let size = Vec2::splat(420.0);
    let place = |point: Vec3| to_screen(turn * point * 1.1 - Vec3::new(0.0, 0.2, 0.0), size);
    let [a, b, c] = [Vec3::X, Vec3::Y, Vec3::Z].map(place);
    let draw = |shade: &dyn Fn(Vec3) -> f32| {
        let mut image = canvas(420);
        triangles::fill([a, b, c].map(Vec3::truncate), image.bounds(), |x, y, w| {
            image.set(x, y, Color::gray(shade(w)));
        });
        image
    };
    let corners = intensities(corner_normals(&eighth)[0], light);
    let face = triangles::flat_intensity([Vec3::X, Vec3::Y, Vec3::Z], light);
    let flat = draw(&|_| face);
    let smooth = draw(&|w| corners.dot(w));
    // The weights are the coordinates of a point of the triangle; the sphere's normal points through it.
    let sphere = draw(&|w| w.normalize().dot(light));
    beside([&flat, &smooth, &sphere])
}

fn cube() -> anyhow::Result<Drawing> {
    let mut corners = String::from("vt 0 0\n");
    for n in 0..8 {
        let side = |bit: i32| if n >> bit & 1 == 1 { 1 } else { -1 };
        writeln!(corners, "v {} {} {}", side(0), side(1), side(2))?;
    }
    // Each face's corners counterclockwise from outside, and its normal.
    let faces = [
        ([5, 6, 8, 7], "0 0 1"),
        ([2, 1, 3, 4], "0 0 -1"),
        ([6, 2, 4, 8], "1 0 0"),
        ([1, 5, 7, 3], "-1 0 0"),
        ([7, 8, 4, 3], "0 1 0"),
        ([1, 2, 6, 5], "0 -1 0"),
    ];
    let (mut shared, mut own) = (corners.clone(), corners);
    for (n, ([a, b, c, d], normal)) in faces.iter().enumerate() {
        let k = n + 1;
        writeln!(shared, "f {a}/1 {b}/1 {c}/1 {d}/1")?;
        writeln!(own, "vn {normal}\nf {a}/1/{k} {b}/1/{k} {c}/1/{k} {d}/1/{k}")?;
    }
    let turn = rotate_x(28.0) * rotate_y(-32.0);
    let light = Vec3::new(0.25, 0.55, 0.8).normalize();
    all_beside([shared, own].map(|text| Ok(turned(&parsed(&text)?, turn, light, 500))))
}

fn bands() -> anyhow::Result<Drawing> {
    let mut text = String::from("vt 0 0\n");
    let sides = 16;
    for n in 0..sides {
        let (x, z) = (TAU * n as f32 / sides as f32).sin_cos();
        writeln!(text, "v {} -1 {}\nv {} 1 {}\nvn {x} 0 {z}", x * 0.97, z * 0.97, x * 0.97, z * 0.97)?;
    }
    for n in 0..sides {
        let (k, next) = (n + 1, (n + 1) % sides + 1);
        let [a, b, c, d] = [2 * k - 1, 2 * next - 1, 2 * next, 2 * k];
        writeln!(text, "f {a}/1/{k} {b}/1/{next} {c}/1/{next} {d}/1/{k}")?;
    }
    let model = parsed(&text)?;
    let light = Vec3::new(0.5, 0.0, 1.0).normalize();
    // Wide and low: a column needs no height to be seen.
    all_beside(["flat", "gouraud"].map(|name| Ok(by(name, &model, light, 600)?.scale(600, 400))))
}

/// What the numbers in a file mean: sRGB's curve (IEC 61966-2-1), from light to the number.
fn encoded() -> anyhow::Result<Drawing> {
    let number =
        |light: f32| if light <= 0.003_130_8 { light * 12.92 } else { light.powf(1.0 / 2.4) * 1.055 - 0.055 };
    let model = ball(48, 80)?;
    let as_written = by("gouraud", &model, Vec3::new(0.9, 0.2, 0.2).normalize(), 500)?;
    let light = |x, y| as_written.get(x, y).map_or(0.0, |color| f32::from(color.r) / 255.0);
    let right = painted(500, 500, |x, y| Color::gray(number(light(x, y))));
    beside([&as_written, &right])
}
