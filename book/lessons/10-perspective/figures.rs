//! Chapter 10: a true camera.

use std::path::Path;

use anyhow::Context;
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec2, Vec3, Vec4};
use perspective::scene::Loaded;
use perspective::{
    DEPTHS, DIVISIONS, FLOOR, Keep, METHODS, Planes, frustum, perspective, perspective_weights, view,
};
use shaders::Uniforms;
use textures::Wrap;

use crate::figures::picture::{all_beside, canvas, chequered, method, model, painted, paste, texture};
use crate::figures::shape::{ball, parsed};
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREEN, GREY, ORANGE, PURPLE, SKY, Sheet};
use crate::figures::{Drawing, Figure};
use crate::lessons::transforms::figures::TILES;

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "perspective-head",
        "A head on a chequered floor that reaches to the horizon, twice. On the left the floor's squares are bent and \
         torn along the triangles' sides; on the right they are straight.",
        head,
    ),
    Figure::new(
        "perspective-floor",
        "The chequered floor of two triangles from chapter 9, twice: on the left bent along a diagonal, on the right \
         straight.",
        floor,
    ),
    Figure::new(
        "perspective-spaces",
        "A column of spaces with arrows between them: the world, eye space, clip space, normalized device coordinates, \
         the window. The arrows are called view, frustum, divided by w, viewport.",
        spaces,
    ),
    Figure::new(
        "perspective-frustum",
        "From the side: an eye, the near plane and, farther away, the far plane, both cut off by two rays from the eye. \
         A third ray leads from the eye through the near plane to a point between the two.",
        of_frustum,
    ),
    Figure::new(
        "perspective-interval",
        "Four number lines, one below the other. An interval from l to r is moved to begin at 0, stretched to the length \
         2, and moved to −1 to 1.",
        interval,
    ),
    Figure::new(
        "perspective-depth-curve",
        "The depth after the division against the distance from 1 to 10: a curve that rises steeply at first and is \
         nearly level at the end. At the distance 2 it is already above the middle.",
        depth_curve,
    ),
    Figure::new(
        "perspective-fov",
        "A head three times, equally large, seen with angles of 15, 40 and 90 degrees. The wider the angle, the larger are \
         nose and mouth, and the smaller the ears.",
        fields_of_view,
    ),
    Figure::new(
        "perspective-near",
        "Three curves of the depth in the window against the distance, for near planes at 1, 0.1 and 0.01. The nearer the \
         plane, the sooner the curve is close to 1.",
        near,
    ),
    Figure::new(
        "perspective-weights",
        "An eye, the picture as a line before it, and behind it the side of a triangle that leads away. The middle of its \
         image belongs to a point a quarter of the way along the side.",
        of_weights,
    ),
    Figure::new(
        "perspective-runs",
        "A chequered wall that leads away to the right, three times, enlarged. On top its squares are bent, in the middle \
         their borders ripple, below they are straight.",
        runs,
    ),
    Figure::new(
        "perspective-reciprocal",
        "The product of a number and its approximate reciprocal: without a Newton step it swings between 0.95 and 1.05, \
         with one it stays just below 1.",
        reciprocal,
    ),
    Figure::new(
        "perspective-levels",
        "Three rows of ticks from 1 to 100 on a logarithmic scale. In the first they crowd at the left end; in the second \
         they are even, in the third nearly so.",
        levels,
    ),
    Figure::new(
        "perspective-gaps",
        "Five curves: the gap that is told apart, as a share of the distance, against the distance. Two rise with the \
         distance, the others stay level far below.",
        gaps,
    ),
    Figure::new(
        "perspective-fighting",
        "A blue floor just above an orange one, five times. With 24 bits and with floats the far half is striped in both \
         colours or orange; with the three other ways it is all blue.",
        fighting,
    ),
    Figure::new(
        "perspective-behind",
        "The head on the floor from an eye close above it. The nearest triangles of the floor are missing: where they should \
         be it is black.",
        behind,
    ),
];

/// The camera of the lesson's picture.
const EYE: Vec3 = Vec3::new(1.1, 0.1, 3.4);
const CENTER: Vec3 = Vec3::new(0.0, -0.1, 0.0);
const PLANES: Planes = Planes { near: 0.1, far: 100.0 };

fn of_head() -> anyhow::Result<Loaded> {
    Ok(Loaded::new(model()?, texture()?, Wrap::Clamp))
}

fn of_floor() -> anyhow::Result<Loaded> {
    let [model, texture] = FLOOR.map(Path::new);
    let model = Model::read(model, Attributes { normals: true, uvs: true })?;
    Ok(Loaded::new(model, Image::read(texture)?, Wrap::Repeat))
}

/// Draws subjects over a picture, by rows of the lesson's tables.
fn draw(
    (way, keep): (&str, &str),
    subjects: &[Loaded],
    light: Vec3,
    to_clip: Mat4,
    planes: Planes,
    image: &mut Image,
) -> anyhow::Result<()> {
    let uniforms: Vec<Uniforms> = subjects.iter().map(|subject| subject.uniforms(light, to_clip)).collect();
    (method(METHODS, way)?.draw)(method(DEPTHS, keep)?)(&uniforms, planes, image);
    Ok(())
}

/// The view of the lesson's eye, or another.
fn looking(eye: Vec3, center: Vec3) -> anyhow::Result<Mat4> {
    view(eye, center, Vec3::Y).context("the eye is at the centre")
}

fn light() -> Vec3 {
    Vec3::new(0.5, 0.8, 0.9).normalize()
}

fn head() -> anyhow::Result<Drawing> {
    let subjects = [of_head()?, of_floor()?];
    let to_clip = perspective(45.0, 1.0, PLANES.near, PLANES.far)? * looking(EYE, CENTER)?;
    all_beside(["affine", "per-pixel"].map(|way| {
        // Drawn larger, so that it is smooth when it is made smaller.
        let mut image = canvas(1350);
        draw((way, "z-f32"), &subjects, light(), to_clip, PLANES, &mut image)?;
        Ok(image.scale(450, 450))
    }))
}

/// Chapter 9's floor of two triangles, as wide as deep, from the depth 1 to 3, interpolated in one way.
pub(crate) fn two_triangles(way: &str) -> anyhow::Result<Image> {
    let at = |x: f32, z: f32| Vec3::new(x, -1.0, z);
    let model = quad([at(-1.0, -1.0), at(1.0, -1.0), at(1.0, -3.0), at(-1.0, -3.0)], [1.0, 1.0])?;
    let subjects = [Loaded::new(model, chequered(8, 8, TILES), Wrap::Clamp)];
    let to_clip = frustum(-0.102, 0.102, -0.102, -0.032, PLANES.near, PLANES.far)?;
    let mut image = Image::new(448, 154, Format::Rgb);
    draw((way, "z-f32"), &subjects, Vec3::Z, to_clip, PLANES, &mut image)?;
    Ok(image)
}

fn floor() -> anyhow::Result<Drawing> {
    all_beside(["affine", "per-pixel"].map(two_triangles))
}

fn spaces() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-2.6, -8.9), (9.6, 0.7));
    let at = Vec2::new;
    let steps = [
        (AMBER, "the world", "where things are", "view"),
        (SKY, "eye space", "the eye is the origin", "P, the frustum"),
        (SKY, "clip space", "−w ≤ x, y, z ≤ w", "÷ w"),
        (SKY, "NDC", "the cube from −1 to 1", "viewport"),
        (SKY, "window", "pixels, depth, and 1/w", ""),
    ];
    for (n, (fill, name, what, next)) in steps.iter().enumerate() {
        let center = at(0.0, -2.0 * n as f32);
        sheet.labelled(center, at(2.2, 0.5), fill, name);
        sheet.text_right_of(center + at(2.6, 0.0), what, GREY);
        if !next.is_empty() {
            sheet.arrow(center - at(0.0, 0.5), center - at(0.0, 1.47), BLACK);
            sheet.text_right_of(center + at(0.35, -1.0), next, if *next == "÷ w" { ORANGE } else { BLUE });
        }
    }
    sheet.finish()
}

fn of_frustum() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.9, -2.2), (8.6, 3.3));
    let at = Vec2::new;
    let (near, far, top, bottom) = (2.5, 7.2, 1.0, -0.62);
    let (left, right) = (at(near, 0.0), at(far, 0.0));
    let wide = far / near;
    sheet.polygon(
        &[at(near, bottom), at(far, bottom * wide), at(far, top * wide), at(near, top)],
        "#f1eee5",
        "none",
    );
    sheet.arrow((-0.6, 0.0), (8.3, 0.0), GREY);
    sheet.text((8.3, -0.28), "−z", GREY);
    sheet.line((0.0, 0.0), at(far, top * wide), FAINT, 1.8);
    sheet.line((0.0, 0.0), at(far, bottom * wide), FAINT, 1.8);
    sheet.line(left + at(0.0, bottom), left + at(0.0, top), BLUE, 3.6);
    sheet.line(right + at(0.0, bottom * wide), right + at(0.0, top * wide), BLUE, 3.6);
    // The point and its image, with their heights.
    let point = at(5.4, 1.5);
    let image = point * near / point.x;
    sheet.line((0.0, 0.0), point, ORANGE, 2.2);
    sheet.dashed(at(point.x, 0.0), point, ORANGE, 1.8);
    sheet.dot(image, ORANGE);
    sheet.dot(point, ORANGE);
    sheet.dot((0.0, 0.0), BLACK);
    sheet.text_left_of(image + at(-0.35, 0.62), "y on the near plane", ORANGE);
    sheet.line(image + at(-0.38, 0.5), image + at(-0.08, 0.12), ORANGE, 1.2);
    sheet.text_right_of(point + at(0.15, 0.12), "point", ORANGE);
    sheet.text_right_of(at(point.x + 0.12, 0.55), "y", ORANGE);
    sheet.text((-0.05, -0.3), "eye", BLACK);
    sheet.text_right_of(at(near + 0.12, -0.3), "n", BLUE);
    sheet.text_right_of(at(far + 0.12, 0.3), "f", BLUE);
    sheet.text(at(near + 0.05, top + 0.3), "t", BLUE);
    sheet.text(at(near + 0.05, bottom - 0.3), "b", BLUE);
    sheet.text_right_of(at(near - 0.4, -1.9), "near plane", BLUE);
    sheet.text(at(far, 3.15), "far plane", BLUE);
    sheet.finish()
}

fn interval() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-2.6, -4.9), (6.4, 0.7));
    let at = Vec2::new;
    let (l, r) = (1.2, 4.8);
    let lines: [(f32, f32, &str, &str, &str); 4] = [
        (l, r, "l", "r", "on the near plane"),
        (0.0, r - l, "0", "r − l", "− l"),
        (0.0, 2.0, "0", "2", "· 2 / (r − l)"),
        (-1.0, 1.0, "−1", "1", "− 1"),
    ];
    for (n, (from, to, low, high, step)) in lines.iter().enumerate() {
        let y = -1.4 * n as f32;
        sheet.line((-1.5, y), (5.4, y), FAINT, 1.6);
        sheet.line((0.0, y - 0.1), (0.0, y + 0.1), GREY, 1.6);
        sheet.line((*from, y), (*to, y), BLUE, 4.6);
        for (x, name) in [(from, low), (to, high)] {
            sheet.dot((*x, y), BLUE);
            sheet.text((*x, y - 0.36), name, BLUE);
        }
        if n > 0 {
            sheet.text_left_of((-0.6, y + 0.7), step, ORANGE);
            sheet.arrow((-0.4, y + 1.1), (-0.4, y + 0.35), ORANGE);
        } else {
            sheet.text((3.0, y + 0.4), step, GREY);
        }
    }
    sheet.text_right_of((5.5, 0.0), "x", GREY);
    let _ = at;
    sheet.finish()
}

/// z/w of what is at a distance, by the lesson's matrix.
fn depth_at(m: Mat4, distance: f32) -> f32 {
    let p = m * Vec4::new(0.0, 0.0, -distance, 1.0);
    p.z / p.w
}

fn depth_curve() -> anyhow::Result<Drawing> {
    let (near, far) = (1.0_f32, 10.0_f32);
    let m = frustum(-1.0, 1.0, -1.0, 1.0, near, far)?;
    let up = 3.0;
    let mut sheet = Sheet::new((-0.9, -up - 0.75), (10.9, up + 0.6));
    sheet.rectangle((near, -up), (2.0 * near, up), "#f1eee5", "none");
    sheet.axes((0.0, 0.0), (0.0, -up), (10.6, up), 1.5);
    for y in [-up, up] {
        sheet.dashed((0.0, y), (10.4, y), FAINT, 1.6);
    }
    sheet.polyline(
        (0..=180).map(|n| near + (far - near) * n as f32 / 180.0).map(|z| (z, up * depth_at(m, z))),
        BLUE,
        3.0,
    );
    for z in [near, 2.0 * near, far] {
        sheet.dot((z, up * depth_at(m, z)), ORANGE);
        sheet.line((z, -0.12), (z, 0.12), GREY, 1.6);
    }
    sheet.text_left_of((-0.15, up), "1", BLACK);
    sheet.text_left_of((-0.15, -up), "−1", BLACK);
    sheet.text_left_of((-0.15, 0.0), "0", BLACK);
    sheet.text((0.82, -0.4), "n", BLACK);
    sheet.text((2.25, -0.4), "2n", BLACK);
    sheet.text((far, -0.4), "f", BLACK);
    sheet.text_right_of((5.2, -0.45), "distance", GREY);
    sheet.text_right_of((4.2, 1.4), "z after the division", BLUE);
    sheet.text_right_of((1.1, -up - 0.45), "half of all depths", ORANGE);
    sheet.finish()
}

fn fields_of_view() -> anyhow::Result<Drawing> {
    let subjects = [of_head()?];
    all_beside([15.0_f32, 40.0, 90.0].map(|fov| {
        // At this distance a length of 1.25 takes up half of the picture's height.
        let distance = 1.25 / (fov.to_radians() / 2.0).tan();
        let eye = Vec3::new(0.0, 0.0, distance + 0.1);
        let to_clip = perspective(fov, 1.0, PLANES.near, PLANES.far)? * looking(eye, Vec3::ZERO)?;
        let mut image = canvas(900);
        let light = Vec3::new(0.4, 0.5, 1.0).normalize();
        draw(("per-pixel", "z-f32"), &subjects, light, to_clip, PLANES, &mut image)?;
        Ok(image.scale(300, 300))
    }))
}

fn near() -> anyhow::Result<Drawing> {
    let up = 6.0;
    let mut sheet = Sheet::new((-0.9, -0.8), (14.6, up + 0.6));
    sheet.axes((0.0, 0.0), (0.0, 0.0), (10.5, up + 0.3), 1.5);
    sheet.dashed((0.0, up), (10.4, up), FAINT, 1.6);
    for (near, ink, name, y) in
        [(1.0_f32, GREEN, "n = 1", 4.6), (0.1, BLUE, "n = 0.1", 5.35), (0.01, ORANGE, "n = 0.01", 6.1)]
    {
        let m = perspective(45.0, 1.0, near, f32::INFINITY)?;
        let points = (0..=400).map(|n| near + (10.0 - near) * (n as f32 / 400.0).powi(3));
        sheet.polyline(points.map(|z| (z, up * (depth_at(m, z) / 2.0 + 0.5))), ink, 2.8);
        sheet.text_right_of((10.7, y), name, ink);
    }
    sheet.text_left_of((-0.2, up), "1", BLACK);
    sheet.text_left_of((-0.2, 0.0), "0", BLACK);
    sheet.text((10.0, -0.45), "10", BLACK);
    sheet.line((10.0, -0.1), (10.0, 0.1), GREY, 1.6);
    sheet.text((5.0, -0.45), "distance", GREY);
    sheet.text_right_of((3.2, 2.6), "depth in the window, f = ∞", GREY);
    sheet.finish()
}

fn of_weights() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.6, -0.5), (5.9, 3.4));
    let at = Vec2::new;
    // Distance along x, so that the picture is the upright line at 1.
    let (near, far) = (at(1.4, 0.25), at(4.2, 2.9));
    let eye = at(0.0, 0.0);
    let seen = |p: Vec2| p / p.x;
    let (a, b) = (seen(near), seen(far));
    let middle = (a + b) / 2.0;
    let weights = perspective_weights(Vec3::new(0.5, 0.5, 0.0), Vec3::new(1.0 / near.x, 1.0 / far.x, 1.0));
    let point = near * weights.x + far * weights.y;
    sheet.line((1.0, -0.3), (1.0, 1.5), BLACK, 2.2);
    sheet.line(near, far, BLUE, 4.0);
    sheet.line(eye, near, FAINT, 1.8);
    sheet.line(eye, far, FAINT, 1.8);
    sheet.line(eye, point, ORANGE, 2.2);
    for p in [a, b, near, far] {
        sheet.dot(p, BLUE);
    }
    sheet.dot(middle, ORANGE);
    sheet.dot(point, ORANGE);
    sheet.dot(eye, BLACK);
    let half = (near + far) / 2.0;
    sheet.dot(half, GREY);
    sheet.text_right_of(half + at(0.15, -0.12), "the middle", GREY);
    sheet.text_right_of(point + at(0.15, -0.16), "μ: ¾ and ¼", ORANGE);
    sheet.text_left_of(middle + at(-0.1, 0.42), "λ: ½ and ½", ORANGE);
    sheet.text((1.0, 1.68), "picture", BLACK);
    sheet.text(eye + at(0.0, -0.25), "eye", BLACK);
    sheet.text_right_of(near + at(0.12, -0.14), "near corner", BLUE);
    sheet.text_right_of(far + at(0.15, 0.0), "far corner", BLUE);
    sheet.finish()
}

/// A rectangle of two triangles, given by its corners counterclockwise, with a texture so many times each way.
fn quad(corners: [Vec3; 4], [u, v]: [f32; 2]) -> anyhow::Result<Model> {
    let lines = corners.map(|p| format!("v {} {} {}\n", p.x, p.y, p.z)).concat();
    parsed(&format!("{lines}vt 0 0\nvt {u} 0\nvt {u} {v}\nvt 0 {v}\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n"))
}

fn runs() -> anyhow::Result<Drawing> {
    let at = Vec3::new;
    let wall = quad(
        [at(-0.62, -0.5, -0.7), at(4.2, -0.5, -4.6), at(4.2, 0.5, -4.6), at(-0.62, 0.5, -0.7)],
        [6.0, 1.0],
    )?;
    let subjects = [Loaded::new(wall, chequered(4, 4, TILES), Wrap::Repeat)];
    const SIZE: [u16; 2] = [150, 58];
    let [width, height] = SIZE.map(f32::from);
    let to_clip = perspective(38.0, width / height, 0.1, 100.0)?;
    let mut sheet = Image::new(SIZE[0], 3 * SIZE[1] + 8, Format::Rgb);
    for (n, way) in ["per-pixel", "every-16", "affine"].into_iter().enumerate() {
        let mut image = Image::new(SIZE[0], SIZE[1], Format::Rgb);
        draw((way, "z-f32"), &subjects, Vec3::Z, to_clip, PLANES, &mut image)?;
        paste(&image, &mut sheet, [0, n as i32 * (i32::from(SIZE[1]) + 4)]);
    }
    Ok(Drawing::Pixels(sheet, 4))
}

fn reciprocal() -> anyhow::Result<Drawing> {
    let scale = |product: f32| (product - 1.0) * 40.0;
    let mut sheet = Sheet::new((-0.95, -2.9), (9.9, 2.9));
    sheet.axes((0.0, 0.0), (0.0, -2.5), (8.4, 2.5), 1.5);
    for (steps, ink) in [("fast-0", ORANGE), ("fast-1", BLUE)] {
        let one = method(DIVISIONS, steps)?.one;
        let points = (0..=400).map(|n| n as f32 / 200.0);
        sheet.polyline(points.map(|e| (4.0 * e, scale(e.exp2() * one(e.exp2())))), ink, 2.8);
    }
    for (e, name) in [(0, "x = 1"), (1, "2"), (2, "4")] {
        let x = 4.0 * e as f32;
        sheet.dashed((x, -2.5), (x, 2.5), FAINT, 1.4);
        sheet.text((x, -2.75), name, BLACK);
    }
    for product in [0.95, 1.0, 1.05] {
        sheet.text_left_of((-0.12, scale(product)), &format!("{product}"), BLACK);
    }
    sheet.text_right_of((8.1, 1.5), "no step", ORANGE);
    sheet.text_right_of((8.1, 0.35), "one step", BLUE);
    sheet.finish()
}

fn levels() -> anyhow::Result<Drawing> {
    let (n, f) = (1.0_f32, 100.0_f32);
    let mut sheet = Sheet::new((-0.5, -3.55), (10.5, 0.9));
    let x = |distance: f32| 5.0 * (distance / n).log10();
    let even: Vec<f32> = (0..16).map(|k| k as f32 / 15.0).collect();
    // A float with one bit after the point: 1, ¾, ½, ⅜, ¼, …
    let float = (0..7).flat_map(|e| [1.0_f32, 0.75].map(|m| m / (1 << e) as f32));
    let rows: [(&str, Vec<f32>); 3] = [
        ("1/z, even steps", even.iter().map(|d| n / (1.0 - d * (1.0 - n / f))).collect()),
        ("logarithm, even steps", even.iter().map(|d| n * (f / n).powf(*d)).collect()),
        ("1/z reversed, steps of a float", float.map(|d| n / d).filter(|z| *z <= f).collect()),
    ];
    for (row, (name, distances)) in rows.iter().enumerate() {
        let y = -1.3 * row as f32;
        sheet.line((x(n), y), (x(f), y), FAINT, 1.6);
        for &distance in distances {
            sheet.line(
                (x(distance), y - 0.2),
                (x(distance), y + 0.2),
                if row == 0 { ORANGE } else { BLUE },
                2.6,
            );
        }
        sheet.text_right_of((0.0, y + 0.5), name, GREY);
    }
    for distance in [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0] {
        sheet.text((x(distance), -3.25), &format!("{distance}"), BLACK);
    }
    sheet.finish()
}

/// The length of the distances that are not told apart from one, as a share of it; of what lies between the planes.
pub(crate) fn gap(keep: &Keep, planes: Planes, distance: f64) -> f64 {
    let alike = (keep.alike)(planes, distance);
    let (near, far) = (f64::from(planes.near), f64::from(planes.far));
    (alike.end().min(far) - alike.start().max(near)) / distance
}

fn gaps() -> anyhow::Result<Drawing> {
    let planes = Planes { near: 1.0, far: 1e6 };
    // Both axes in powers of ten.
    let mut sheet = Sheet::new((-1.6, -8.9), (12.8, 0.8));
    let x = |power: f64| 1.5 * power as f32;
    sheet.axes((0.0, -8.0), (0.0, 0.0), (9.3, 8.3), 1.5);
    for (power, name) in [(-8, "10⁻⁸"), (-6, "10⁻⁶"), (-4, "10⁻⁴"), (-2, "10⁻²"), (0, "1")] {
        sheet.dashed((0.0, power as f32), (9.2, power as f32), FAINT, 1.2);
        sheet.text_left_of((-0.15, power as f32), name, BLACK);
    }
    for (power, name) in [(0.0, "n"), (2.0, "100 n"), (4.0, "10⁴ n"), (6.0, "10⁶ n")] {
        sheet.text((x(power), -8.5), name, BLACK);
    }
    let rows = [
        // Under the next one's line, which is the same but near n.
        ("z-f32", AMBER, 5.0, -1.75),
        ("z24", ORANGE, 2.0, -1.0),
        ("reversed-z-f32", BLUE, 2.2, -7.3),
        ("logarithmic", PURPLE, 2.2, -5.9),
        ("w", GREEN, 2.2, -6.55),
    ];
    for (name, ink, width, y) in rows {
        let keep = method(DEPTHS, name)?;
        // Just behind the near plane floats tell apart more than is drawn.
        let share = |power: f64| gap(keep, planes, 10f64.powf(power)).log10().max(-8.0) as f32;
        let points = (0..=120).map(|n| f64::from(n) / 20.0).map(|power| (x(power), share(power)));
        sheet.polyline(points, ink, width);
        sheet.text_right_of((9.45, y), name, if ink == AMBER { BLACK } else { ink });
    }
    sheet.text_right_of((0.2, 0.4), "gap, as a share of the distance", GREY);
    sheet.finish()
}

/// A floor in one colour at a height of −1, brought nearer to the eye by a share of its distance.
fn plain_floor(nearer: f32, color: Color) -> anyhow::Result<Loaded> {
    let at = |x: f32, z: f32| Vec3::new(x, -1.0, z) * (1.0 - nearer);
    let model =
        quad([at(-900.0, -1.0), at(900.0, -1.0), at(900.0, -1200.0), at(-900.0, -1200.0)], [1.0, 1.0])?;
    Ok(Loaded::new(model, painted(1, 1, |_, _| color), Wrap::Clamp))
}

/// Two floors, one nearer than the other by a small share of the distance at every pixel; depths kept in one way.
pub(crate) fn two_floors(keep: &str, width: u16) -> anyhow::Result<Image> {
    const HEIGHT: u16 = 264;
    // The far one first: where the two are not told apart, it stays.
    let subjects =
        [plain_floor(0.0, Color::rgb(0xd5, 0x5e, 0x00))?, plain_floor(NEARER, Color::rgb(0x00, 0x72, 0xb2))?];
    let planes = Planes { near: 0.01, far: 2000.0 };
    // The horizon near the upper border of the picture; the head a little to the side, so that no row has one depth.
    let (low, high) = (-0.0092, 0.0004);
    let side = (high - low) * f32::from(width) / f32::from(HEIGHT) / 2.0;
    let tilted = view(Vec3::ZERO, -Vec3::Z, Vec3::new(0.1, 1.0, 0.0)).context("it looks somewhere")?;
    let to_clip = frustum(-side, side, low, high, planes.near, planes.far)? * tilted;
    let mut image = Image::new(width, HEIGHT, Format::Rgb);
    draw(("per-pixel", keep), &subjects, Vec3::Z, to_clip, planes, &mut image)?;
    Ok(image)
}

/// A ball in a picture twice as wide as high, by a camera for pictures of that ratio.
pub(crate) fn ball_before(ratio: f32) -> anyhow::Result<Image> {
    let subjects = [Loaded::new(ball(48, 80)?, painted(1, 1, |_, _| Color::WHITE), Wrap::Clamp)];
    let to_clip = perspective(30.0, ratio, PLANES.near, PLANES.far)? * looking(Vec3::Z * 5.0, Vec3::ZERO)?;
    let mut image = Image::new(900, 450, Format::Rgb);
    draw(("per-pixel", "z-f32"), &subjects, light(), to_clip, PLANES, &mut image)?;
    Ok(image.scale(450, 225))
}

fn fighting() -> anyhow::Result<Drawing> {
    all_beside(DEPTHS.iter().map(|row| two_floors(row.name, 176)))
}

/// By what share of its distance the second floor is nearer.
const NEARER: f32 = 1e-5;

fn behind() -> anyhow::Result<Drawing> {
    let subjects = [of_head()?, of_floor()?];
    let eye = Vec3::new(0.7, -0.6, 1.7);
    let to_clip =
        perspective(80.0, 1.6, PLANES.near, PLANES.far)? * looking(eye, Vec3::new(0.0, -0.75, 0.0))?;
    let mut image = Image::new(1440, 900, Format::Rgb);
    draw(("per-pixel", "z-f32"), &subjects, light(), to_clip, PLANES, &mut image)?;
    Ok(Drawing::Pixels(image.scale(720, 450), 1))
}
