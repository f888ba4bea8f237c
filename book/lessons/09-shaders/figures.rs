//! Chapter 9: any look from one loop.

use std::fmt::Write;

use anyhow::Context;
use camera::lookat;
use common::{Color, Format, Image, Mat4, Model, Vec2, Vec3, Vec4};
use gouraud::corner_normals;
use shaders::lighting::{Lighting, Quantized};
use shaders::shader::{Fragment, Shader, render};
use shaders::{Framebuffer, METHODS, SHADERS, Uniforms, fit};
use transforms::{projection, scale, translate};
use zbuffer::fill_nearest;

use crate::figures::picture::{all_beside, beside, canvas, chequered, method, model, paste, texture};
use crate::figures::shape::{ball, parsed};
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREEN, GREY, ORANGE, SKY, Sheet};
use crate::figures::{Drawing, Figure};
use crate::lessons::transforms::figures::TILES;

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "shaders-sheet",
        "The model four times in a square: white with facets, textured with facets, white and smooth, textured \
         and smooth.",
        four_looks,
    ),
    Figure::new(
        "shaders-steps",
        "A column of steps, by turns the shader's and the loop's: the position of every vertex, the division by w, \
         the triangle, its three corners, the pixels and the test, the fragment, and at last the writing of colour \
         and depth.",
        loop_steps,
    ),
    Figure::new(
        "shaders-parts",
        "A table of two colour sources, white and texture, and three lightings, flat, Gouraud and quantized. Five \
         of its six places have a name.",
        parts,
    ),
    Figure::new(
        "shaders-calls",
        "On the left one loop that calls one of three shaders through a table, at every pixel. On the right three \
         loops, each with its shader inside.",
        calls,
    ),
    Figure::new(
        "shaders-stairs",
        "A stair of six steps that follows the diagonal from below. It ends at 1; below 0 lies what is dropped.",
        stairs,
    ),
    Figure::new(
        "shaders-levels",
        "The model in 1, 2, 3 and 6 steps of grey. With one step it is black.",
        levels,
    ),
    Figure::new(
        "shaders-floor",
        "A chequered floor three times, from top to bottom: of two triangles, where the pattern is bent along a \
         diagonal; of 18, where it wavers; of 8,192, where it is straight.",
        floors,
    ),
    Figure::new(
        "shaders-warp",
        "An eye above a floor, from the side. Equal steps in the picture are short steps on the near floor and long \
         ones on the far floor; the middle of the picture shows a place that is nearer than the floor's middle.",
        warp,
    ),
    Figure::new(
        "shaders-share",
        "The true place on the floor against the place in the picture: curves that sag below the diagonal, deeper \
         the farther the far end is.",
        share,
    ),
    Figure::new(
        "shaders-discard",
        "A ball behind a screen with square holes. On the left it can be seen through the holes. On the right the \
         holes are black: they have left their depth.",
        discard,
    ),
];

/// The lesson's camera, in a square picture.
fn to_clip(eye: Vec3, zoom: f32) -> anyhow::Result<Mat4> {
    let view = lookat(eye, Vec3::ZERO, Vec3::Y).context("the eye is at the centre")?;
    Ok(fit(zoom, Vec2::ONE) * projection(eye.length()) * view)
}

/// What one of the lesson's shaders draws, over what is there.
fn draw(shader: &str, uniforms: &Uniforms, target: &mut Framebuffer) -> anyhow::Result<()> {
    method(METHODS, "generic")?(method(SHADERS, shader)?)(uniforms, target);
    Ok(())
}

/// The model by a shader, from the lesson's eye.
fn look(shader: &str, side: u16, levels: u16, light: Vec3) -> anyhow::Result<Image> {
    let (model, texture) = (model()?, texture()?);
    let to_clip = to_clip(Vec3::new(1.0, 1.0, 2.0), 0.42)?;
    let normals = corner_normals(&model);
    let uniforms = Uniforms {
        normals: &normals,
        texture: Some(&texture),
        light,
        to_clip,
        levels,
        ..Uniforms::new(&model)
    };
    let mut target = Framebuffer::new(canvas(side));
    draw(shader, &uniforms, &mut target)?;
    Ok(target.image)
}

fn four_looks() -> anyhow::Result<Drawing> {
    let mut sheet = canvas(720);
    for (n, shader) in SHADERS.iter().take(4).enumerate() {
        // Drawn larger, so that it is smooth when it is made smaller.
        let cell = look(shader.name, 1080, 1, Vec3::new(0.5, 0.3, 0.8).normalize())?.scale(360, 360);
        paste(&cell, &mut sheet, [360 * (n as i32 % 2), 360 * (1 - n as i32 / 2)]);
    }
    Ok(Drawing::Pixels(sheet, 1))
}

fn loop_steps() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-2.6, -9.4), (9.4, 1.5));
    let at = Vec2::new;
    let steps = [
        (AMBER, "position", "of every vertex, once"),
        (SKY, "÷ w", "place in the picture, or none"),
        (AMBER, "triangle", "a constant, or next triangle"),
        (AMBER, "corner, 3 times", "varyings"),
        (SKY, "fill, test", "pixels, weights"),
        (AMBER, "fragment", "a colour, or nothing"),
        (SKY, "write", "colour and depth"),
    ];
    for (n, (fill, words, result)) in steps.iter().enumerate() {
        let center = at(0.0, -1.4 * n as f32);
        if n > 0 {
            sheet.arrow(center + at(0.0, 0.95), center + at(0.0, 0.46), BLACK);
        }
        sheet.labelled(center, at(2.4, 0.45), fill, words);
        sheet.text_right_of(center + at(2.7, 0.0), result, GREY);
    }
    sheet.text((0.0, 1.05), "amber: the shader's", BLACK);
    sheet.text_right_of((2.7, 1.05), "blue: the loop's", BLUE);
    sheet.finish()
}

fn parts() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-3.4, -3.3), (12.6, 1.3));
    let at = Vec2::new;
    let half = at(2.2, 0.62);
    for (column, words) in ["Flat", "Gouraud", "Quantized"].iter().enumerate() {
        sheet.text((1.2 + 4.6 * column as f32, 0.75), words, BLUE);
        for (row, names) in
            [["flat", "gouraud", "quantized"], ["flat-texture", "gouraud-texture", ""]].iter().enumerate()
        {
            let name = names[column];
            anyhow::ensure!(
                name.is_empty() || SHADERS.iter().any(|shader| shader.name == name),
                "there is no shader `{name}`"
            );
            let center = at(1.2 + 4.6 * column as f32, -0.6 - 1.8 * row as f32);
            sheet.labelled(center, half, if name.is_empty() { "none" } else { SKY }, name);
        }
    }
    for (row, words) in ["White", "Texture"].iter().enumerate() {
        sheet.text((-2.25, -0.6 - 1.8 * row as f32), words, ORANGE);
    }
    sheet.finish()
}

fn calls() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.9, -5.0), (10.9, 1.9));
    let at = Vec2::new;
    sheet.text((1.9, 1.45), "dyn", ORANGE);
    sheet.labelled(at(-0.3, -1.4), at(1.4, 0.7), SKY, "one loop");
    sheet.text((8.4, 1.45), "generic", GREEN);
    for (n, name) in ["flat", "gouraud", "…"].iter().enumerate() {
        let y = 0.4 - 1.8 * n as f32;
        sheet.arrow((1.15, -1.4), (2.9, y), ORANGE);
        sheet.labelled(at(4.0, y), at(1.05, 0.55), AMBER, name);
        sheet.labelled(at(8.4, y), at(2.3, 0.7), SKY, "");
        sheet.text((7.2, y), "loop", BLACK);
        sheet.labelled(at(9.25, y), at(1.15, 0.48), AMBER, name);
    }
    sheet.text((1.5, -4.65), "a call at every pixel", ORANGE);
    sheet.text((8.4, -4.65), "no call at all", GREEN);
    sheet.finish()
}

fn stairs() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.55, -0.38), (1.5, 1.2));
    let at = Vec2::new;
    sheet.rectangle((-0.5, -0.3), (0.0, 1.1), FAINT, "none");
    sheet.axes((0.0, 0.0), (-0.5, -0.3), (1.45, 1.15), 1.5);
    sheet.dashed((-0.3, -0.3), (1.1, 1.1), GREY, 1.6);
    // From the middle of one step to that of the next there is a jump in between.
    let mut last: Option<Vec2> = None;
    for n in -50..=145 {
        let i = n as f32 / 100.0 + 0.001;
        let point = at(i, Quantized.intensity(6.0, i).max(-0.3));
        if let Some(last) = last.filter(|last| (last.y - point.y).abs() < 0.01) {
            sheet.line(last, point, if point.y < 0.0 { ORANGE } else { BLUE }, 3.2);
        }
        last = Some(point);
    }
    sheet.text((1.0, -0.12), "1", BLACK);
    sheet.text_left_of((-0.04, 1.0), "1", BLACK);
    sheet.text((1.32, -0.12), "i", GREY);
    sheet.text((-0.26, 0.6), "dropped", ORANGE);
    sheet.text_right_of((0.62, 0.3), "six steps", BLUE);
    sheet.finish()
}

fn levels() -> anyhow::Result<Drawing> {
    let light = Vec3::new(0.5, 0.3, 0.8).normalize();
    all_beside([1, 2, 3, 6].map(|levels| look("quantized", 500, levels, light)))
}

/// A level square from −1 to 1, at a height of −1, of so many squares each way, with one texture on all.
fn floor(squares: usize) -> anyhow::Result<Model> {
    let mut text = String::from("vn 0 1 0\n");
    let at = |n: usize| n as f32 / squares as f32;
    for (row, column) in (0..=squares).flat_map(|row| (0..=squares).map(move |column| (row, column))) {
        let (u, v) = (at(column), at(row));
        writeln!(text, "v {} -1 {}\nvt {u} {v}", 2.0 * u - 1.0, 1.0 - 2.0 * v)?;
    }
    let corner = |row: usize, column: usize| format!("{0}/{0}/1", row * (squares + 1) + column + 1);
    for (row, column) in (0..squares).flat_map(|row| (0..squares).map(move |column| (row, column))) {
        let near = [corner(row, column), corner(row, column + 1)];
        let far = [corner(row + 1, column + 1), corner(row + 1, column)];
        writeln!(text, "f {} {} {} {}", near[0], near[1], far[0], far[1])?;
    }
    parsed(&text)
}

fn floors() -> anyhow::Result<Drawing> {
    let chequers = chequered(8, 8, TILES);
    const SIZE: [u16; 2] = [560, 212];
    let mut sheet = Image::new(SIZE[0], 3 * SIZE[1], Format::Rgb);
    for (n, squares) in [64, 3, 1].into_iter().enumerate() {
        let model = floor(squares)?;
        let mut target = Framebuffer::new(Image::new(SIZE[0], SIZE[1], Format::Rgb));
        let [width, height] = SIZE.map(f32::from);
        // From a distance of 2, as wide as the picture; moved up until the floor is in it.
        let up = translate(Vec3::Y * ((width + 16.0) / height - 1.0));
        let to_clip = up * scale(Vec3::new(0.49, 0.49 * width / height, 1.0)) * projection(2.0);
        let uniforms =
            Uniforms { texture: Some(&chequers), light: Vec3::Y, to_clip, ..Uniforms::new(&model) };
        draw("flat-texture", &uniforms, &mut target)?;
        paste(&target.image, &mut sheet, [0, n as i32 * i32::from(SIZE[1])]);
    }
    Ok(Drawing::Pixels(sheet, 1))
}

fn warp() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.5, -0.75), (9.2, 2.3));
    let at = Vec2::new;
    let (eye, near, far, picture) = (at(0.0, 1.7), 2.2, 8.6, 1.3);
    // Where the ray to a point of the floor meets the picture.
    let seen = |x: f32| eye.y + (0.0 - eye.y) * picture / x;
    let steps = 6;
    sheet.line((-0.3, 0.0), (9.1, 0.0), GREY, 1.6);
    sheet.line((near, 0.0), (far, 0.0), BLUE, 4.0);
    sheet.line((picture, 0.1), (picture, 1.9), BLACK, 2.2);
    for n in 0..=steps {
        let height = seen(near) + (seen(far) - seen(near)) * n as f32 / steps as f32;
        let x = eye.y * picture / (eye.y - height);
        let middle = n * 2 == steps;
        sheet.line(eye, (x, 0.0), if middle { ORANGE } else { FAINT }, if middle { 2.2 } else { 1.6 });
        sheet.dot((picture, height), if middle { ORANGE } else { BLUE });
        sheet.dot((x, 0.0), if middle { ORANGE } else { BLUE });
    }
    let middle = at((near + far) / 2.0, 0.0);
    sheet.arrow(middle + at(0.0, 0.8), middle + at(0.0, 0.1), BLACK);
    sheet.text_right_of(middle + at(-0.1, 1.0), "the floor's middle", BLACK);
    sheet.dot(eye, BLACK);
    sheet.text(eye + at(0.0, 0.28), "eye", BLACK);
    sheet.text((picture, 2.08), "picture", BLACK);
    sheet.text((near, -0.3), "near", BLUE);
    sheet.text((far, -0.3), "far", BLUE);
    sheet.text_right_of((3.3, -0.55), "the middle of the picture", ORANGE);
    sheet.finish()
}

fn share() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.2, -0.2), (1.55, 1.12));
    sheet.axes((0.0, 0.0), (0.0, 0.0), (1.08, 1.08), 1.5);
    sheet.dashed((0.0, 0.0), (1.0, 1.0), GREY, 1.8);
    for (ratio, ink) in [(1.5_f32, GREEN), (3.0, BLUE), (9.0, ORANGE)] {
        let curve = (0..=60).map(|n| n as f32 / 60.0).map(|s| (s, s / (s + (1.0 - s) * ratio)));
        sheet.polyline(curve, ink, 2.8);
        let root = ratio.sqrt();
        let s = root / (root + 1.0);
        sheet.line((s, s / root), (s, s), ink, 1.8);
    }
    sheet.text((1.0, -0.1), "1", BLACK);
    sheet.text_left_of((-0.04, 1.0), "1", BLACK);
    sheet.text((0.5, -0.1), "s, in the picture", GREY);
    sheet.text_right_of((0.05, 1.06), "t, on the floor", GREY);
    sheet.text_right_of((1.1, 0.9), "r = 1.5", GREEN);
    sheet.text_right_of((1.1, 0.75), "r = 3", BLUE);
    sheet.text_right_of((1.1, 0.6), "r = 9", ORANGE);
    sheet.finish()
}

/// A square screen before everything else, with holes; corners in pixels, and (u, v).
struct Screen {
    side: f32,
    corners: [(Vec3, Vec2); 4],
}

impl Screen {
    /// In a picture of that side.
    fn new(side: f32) -> Self {
        let corner = |u: f32, v: f32| {
            (Vec3::new(side * (0.08 + 0.84 * u), side * (0.08 + 0.84 * v), 5.0), Vec2::new(u, v))
        };
        Self { side, corners: [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)] }
    }

    /// Of its two triangles.
    const TRIANGLES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

    /// Nothing in a hole.
    fn color(uv: Vec2) -> Option<Color> {
        let place = (uv * 9.0).fract();
        let hole = (0.25..0.9).contains(&place.x) && (0.25..0.9).contains(&place.y);
        (!hole).then_some(Color::rgb(0xf2, 0xc1, 0x4e))
    }
}

impl Shader for Screen {
    type Constant = ();
    type Varying = Vec2;
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        let Vec3 { x, y, z } = self.corners[vertex].0;
        Vec4::new(2.0 * x / self.side - 1.0, 2.0 * y / self.side - 1.0, z, 1.0)
    }

    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    fn corner(&self, face: usize, corner: usize) -> Vec2 {
        self.corners[Self::TRIANGLES[face][corner] as usize].1
    }

    fn fragment(&self, (): (), fragment: Fragment<Vec2>) -> Option<Color> {
        Self::color(fragment.varying)
    }
}

fn discard() -> anyhow::Result<Drawing> {
    const SIDE: u16 = 480;
    let ball = ball(48, 80)?;
    let light = Vec3::new(0.4, 0.5, 0.8).normalize();
    let to_clip = fit(0.38, Vec2::ONE);
    let normals = corner_normals(&ball);
    let uniforms = Uniforms { normals: &normals, light, to_clip, ..Uniforms::new(&ball) };
    let screen = Screen::new(f32::from(SIDE));
    let [mut right, mut wrong] = [(); 2].map(|()| Framebuffer::new(canvas(SIDE)));
    render(&screen, 4, &Screen::TRIANGLES, &mut right);
    // The fault: the depth is kept before the fragment is asked.
    for triangle in Screen::TRIANGLES {
        let corners = triangle.map(|vertex| screen.corners[vertex as usize]);
        let Framebuffer { image, depths } = &mut wrong;
        fill_nearest(
            corners.map(|corner| corner.0),
            depths,
            |depth| depth,
            |x, y, weights| {
                let uv = textures::interpolate(corners.map(|corner| corner.1), weights);
                if let Some(color) = Screen::color(uv) {
                    image.set(x, y, color);
                }
            },
        );
    }
    draw("gouraud", &uniforms, &mut right)?;
    draw("gouraud", &uniforms, &mut wrong)?;
    beside([&right.image, &wrong.image])
}
