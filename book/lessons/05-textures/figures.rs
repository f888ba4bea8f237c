//! Chapter 5: colour from a picture.

use std::path::Path;

use anyhow::Context;
use common::program::model::DEFAULT_MODEL;
use common::{Attributes, Color, Format, Image, Model, Vec2, Vec3};
use textures::{METHODS, interpolate, texel};
use triangles::{barycentric::weights, fill};
use zbuffer::{DepthBuffer, fill_nearest, surfaces, to_screen, z_f32};

use crate::figures::picture::{
    all_beside, beside, canvas, chequered, method, model, painted, paste, texture,
};
use crate::figures::shape::parsed;
use crate::figures::sheet::{BLACK, BLUE, GREY, ORANGE, PALE, SKY, Sheet};
use crate::figures::{Drawing, Figure};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "textures-head",
        "The head three times: in the greys of its light, in the colours of its texture alone, and in both \
         multiplied.",
        head,
    ),
    Figure::new(
        "textures-uv",
        "Left the texture, a face spread out flat. Right the head, redder the larger u is and greener the larger \
         v is.",
        coordinates,
    ),
    Figure::new(
        "textures-second",
        "A knotted tube three times: in grey, chequered, and with the boards of a crate along it.",
        second,
    ),
    Figure::new(
        "textures-map",
        "A triangle in the picture and a triangle of another shape in the unit square of the texture. A point in \
         the one belongs to a point in the other.",
        map,
    ),
    Figure::new(
        "textures-texels",
        "A texture of four by three squares, each with its two numbers. Below it u from 0 to 1, on its left v. A \
         dot marks the middle of one texel.",
        texels,
    ),
    Figure::new(
        "textures-strips",
        "The same row of four texels as four methods see it, from u = −½ to 1½. Truncate is black from 1 on and \
         begins a quarter early; round lies half a texel to the left; nearest goes on with the border's texels; \
         repeat begins again.",
        || live::strips().finish(),
    ),
    Figure::new(
        "textures-borders",
        "A small texture of the letter F and what is around it, by truncate, round, nearest and repeat. Beside \
         it, the first two are black, the third smears its border, the fourth repeats the letter.",
        borders,
    ),
    Figure::new(
        "textures-blocks",
        "Two parts of the texture, the second one much enlarged: there each texel has become a square block.",
        blocks,
    ),
    Figure::new(
        "textures-sparkle",
        "Rings that become finer outwards, drawn small. On the left, by nearest, rings appear where there are \
         none; on the right, by averaging, the fine ones fade to grey.",
        sparkle,
    ),
    Figure::new(
        "textures-seam",
        "A band of six fields with a numbered texture around it. Above, one field holds the whole texture, \
         squeezed and mirrored. Below, the texture goes on without a break.",
        seam,
    ),
    Figure::new(
        "textures-warp",
        "A chequered floor that runs into the distance. On the left its lines have a kink along the diagonal; \
         on the right they are straight.",
        warp,
    ),
];

/// What lesson 5 draws of a model.
fn nearest(model: &Model, texture: &Image, mut image: Image) -> anyhow::Result<Image> {
    (method(METHODS, "nearest")?.draw)(model, texture, Vec3::Z, &mut image);
    Ok(image)
}

fn head() -> anyhow::Result<Drawing> {
    let (model, texture) = (model()?, texture()?);
    let [mut light, mut color] = [(); 2].map(|()| canvas(600));
    z_f32(&surfaces(&model, Vec3::Z, &light), &mut light);
    let mut depths = DepthBuffer::new(&color, f32::NEG_INFINITY);
    for (corners, uvs) in model.faces().zip(model.face_uvs()) {
        let screen = corners.map(|corner| to_screen(corner, color.size()));
        let store = |depth| depth;
        fill_nearest(screen, &mut depths, store, |x, y, weights| {
            color.set(x, y, texel(&texture, interpolate(uvs, weights)));
        });
    }
    beside([&light, &color, &nearest(&model, &texture, canvas(600))?])
}

fn coordinates() -> anyhow::Result<Drawing> {
    // A texture whose colour at (u, v) says (u, v).
    let gradient = painted(256, 256, |x, y| Color::rgb(x as u8, y as u8, 64));
    beside([&texture()?.scale(600, 600), &nearest(&model()?, &gradient, canvas(600))?])
}

/// Another model: the same places in two textures.
fn second() -> anyhow::Result<Drawing> {
    let beside_head = |name: &str| Path::new(DEFAULT_MODEL).with_file_name(name);
    let knot = Model::read(&beside_head("torus-knot.obj"), Attributes { normals: false, uvs: true })?;
    let white = painted(1, 1, |_, _| Color::WHITE);
    let board = chequered(64, 16, [Color::rgb(250, 235, 200), Color::rgb(20, 90, 130)]);
    let wood = Image::read(&beside_head("crate.png"))?;
    all_beside([white, board, wood].map(|texture| nearest(&knot, &texture, canvas(600))))
}

fn map() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.4, -0.75), (10.0, 4.5));
    let picture = [at(0.2, 0.3), at(3.9, 0.9), at(1.3, 3.7)];
    let origin = at(5.6, 0.0);
    let side = 3.8;
    let uvs = [at(0.1, 0.55), at(0.75, 0.1), at(0.85, 0.9)];
    let square = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)].map(|uv| origin + side * uv);
    let flat = uvs.map(|uv| origin + side * uv);
    sheet.polygon(&square, PALE, GREY);
    let p = at(1.9, 1.6);
    let shares = weights(picture, p).context("the triangle has an area")?;
    let q = origin + side * interpolate(uvs, shares);
    for (triangle, point) in [(picture, p), (flat, q)] {
        sheet.polygon(&triangle, SKY, BLUE);
        triangle.iter().for_each(|&corner| sheet.dashed(point, corner, GREY, 1.2));
        triangle.iter().for_each(|&corner| sheet.dot(corner, BLACK));
        sheet.dot(point, ORANGE);
    }
    for (n, name) in ["A", "B", "C"].into_iter().enumerate() {
        sheet.text(picture[n] + [at(-0.3, -0.1), at(0.25, -0.2), at(-0.32, 0.0)][n], name, BLACK);
        sheet.text(flat[n] + [at(-0.1, 0.32), at(0.3, -0.15), at(0.1, -0.38)][n], name, BLACK);
    }
    sheet.text(p + at(0.3, 0.2), "P", ORANGE);
    sheet.text(q + at(-0.15, 0.36), "(u, v)", ORANGE);
    sheet.text((1.9, 4.3), "the picture", BLACK);
    sheet.text(origin + at(side / 2.0, 4.3), "the texture", BLACK);
    sheet.text(origin + at(0.0, -0.35), "0", GREY);
    sheet.text(origin + at(side, -0.35), "1", GREY);
    sheet.text(origin + at(side / 2.0, -0.35), "u", GREY);
    sheet.text(origin + at(-0.3, side / 2.0), "v", GREY);
    sheet.text(origin + at(-0.3, side), "1", GREY);
    sheet.finish()
}

fn texels() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.1, -1.0), (4.9, 3.3));
    for (x, y) in (0..3).flat_map(|y| (0..4).map(move |x| (x, y))) {
        sheet.pixel(x, y, if (x + y) % 2 == 0 { SKY } else { PALE });
        let low = if (x, y) == (2, 1) { 0.28 } else { 0.0 };
        sheet.text((x as f32 + 0.5, y as f32 + 0.5 - low), &format!("({x}, {y})"), BLACK);
    }
    for (x, name) in [(0.0, "0"), (1.0, "¼"), (2.0, "½"), (3.0, "¾"), (4.0, "1")] {
        sheet.line((x, 0.0), (x, -0.12), BLACK, 1.5);
        sheet.text((x, -0.36), name, BLACK);
    }
    for (y, name) in [(0.0, "0"), (1.0, "⅓"), (2.0, "⅔"), (3.0, "1")] {
        sheet.line((0.0, y), (-0.12, y), BLACK, 1.5);
        sheet.text((-0.36, y), name, BLACK);
    }
    sheet.text((2.0, -0.78), "u", BLUE);
    sheet.text((-0.8, 1.5), "v", BLUE);
    sheet.dot((2.5, 1.5), ORANGE);
    sheet.text((2.5, 1.75), "(⅝, ½)", ORANGE);
    sheet.finish()
}

/// The letter F in 8×8 texels.
fn letter() -> Image {
    const ROWS: [&str; 8] =
        ["........", ".#####..", ".#......", ".####...", ".#......", ".#......", ".#......", "........"];
    painted(8, 8, |x, y| {
        let ground = Color::rgb(60 + 20 * x as u8, 110 + 8 * y as u8, 190);
        let is_letter = ROWS[7 - y as usize].as_bytes()[x as usize] == b'#';
        if is_letter { Color::rgb(250, 225, 140) } else { ground }
    })
}

fn borders() -> anyhow::Result<Drawing> {
    let texture = letter();
    all_beside(METHODS.iter().map(|method| {
        let uv = |x, y| center(x, y) / 100.0 - 0.5;
        Ok(painted(200, 200, |x, y| (method.run.sample)(&texture, uv(x, y))))
    }))
}

/// A pixel's centre.
fn center(x: i32, y: i32) -> Vec2 {
    Vec2::new(x as f32, y as f32) + 0.5
}

/// A picture of part of a texture.
fn part(texture: &Image, low: Vec2, high: Vec2, side: u16) -> Image {
    painted(side, side, |x, y| texel(texture, low + (high - low) * (center(x, y) / f32::from(side))))
}

fn blocks() -> anyhow::Result<Drawing> {
    let texture = texture()?;
    // A corner of the head's mouth.
    let middle = Vec2::new(0.465, 0.52);
    let part = |half: f32| part(&texture, middle - half, middle + half, 300);
    beside([&part(0.12), &part(0.015)])
}

/// Rings that get finer outwards, 1024×1024 texels, in 128×128 pixels.
fn sparkle() -> anyhow::Result<Drawing> {
    const TEXELS: u16 = 1024;
    let rings = painted(TEXELS, TEXELS, |x, y| {
        let from_middle = center(x, y) / f32::from(TEXELS) - 0.5;
        let light = (from_middle.length_squared() * 90.0).fract() < 0.5;
        if light { Color::rgb(250, 235, 200) } else { Color::rgb(20, 60, 110) }
    });
    let nearest = part(&rings, Vec2::ZERO, Vec2::ONE, 100);
    let mean = painted(100, 100, |x, y| {
        let mut sums = [0_u32; 3];
        for (i, j) in (0..10).flat_map(|j| (0..10).map(move |i| (i, j))) {
            let uv = (Vec2::new(x as f32, y as f32) + center(i, j) / 10.0) / 100.0;
            let Color { r, g, b, .. } = texel(&rings, uv);
            sums = [sums[0] + u32::from(r), sums[1] + u32::from(g), sums[2] + u32::from(b)];
        }
        let [r, g, b] = sums.map(|sum| (sum / 100) as u8);
        Color::rgb(r, g, b)
    });
    beside([&nearest, &mean])
}

/// Six colours side by side, each with a light stripe at its left.
fn stripes() -> Image {
    let colors =
        [(86, 160, 211), (242, 193, 78), (0, 122, 90), (213, 94, 0), (168, 72, 127), (120, 125, 130)];
    painted(48, 16, |x, y| {
        let (r, g, b) = colors[x as usize / 8];
        // A ramp, so that one sees in which direction the texture runs.
        if x % 8 <= y / 2 { Color::rgb(250, 245, 230) } else { Color::rgb(r, g, b) }
    })
}

/// A band around the model, seen from where the texture ends and begins again.
fn seam() -> anyhow::Result<Drawing> {
    let draw = |apart: bool| -> anyhow::Result<Image> {
        let mut text = String::new();
        for n in 0..=6 {
            let x = n as f32 / 3.0 - 1.0;
            text += &format!("v {x} -1 0\nv {x} 1 0\n");
        }
        // u at the left and right end of each field.
        for n in 0..6 {
            let sixth = |n: i32| ((n + 3) % 6) as f32 / 6.0;
            let (left, right) = (sixth(n), if apart && sixth(n + 1) == 0.0 { 1.0 } else { sixth(n + 1) });
            text += &format!("vt {left} 0\nvt {right} 0\nvt {right} 1\nvt {left} 1\n");
        }
        for n in 0..6 {
            let (v, t) = (2 * n + 1, 4 * n + 1);
            text += &format!("f {}/{} {}/{} {}/{} {}/{}\n", v, t, v + 2, t + 1, v + 3, t + 2, v + 1, t + 3);
        }
        nearest(&parsed(&text)?, &stripes(), Image::new(450, 75, Format::Rgb))
    };
    // What neither covers is transparent, and shows the page.
    let mut both = Image::new(450, 160, Format::Rgba);
    paste(&draw(false)?, &mut both, [0, 85]);
    paste(&draw(true)?, &mut both, [0, 0]);
    Ok(Drawing::Pixels(both, 2))
}

/// A chequered square that runs into the distance, as two triangles: (u, v) interpolated in the picture, and
/// in space.
fn warp() -> anyhow::Result<Drawing> {
    // Corners in the picture, (u, v), and the reciprocal of the distance.
    let corners = [
        (20.0, 20.0, 0.0, 0.0, 1.0),
        (280.0, 20.0, 1.0, 0.0, 1.0),
        (202.0, 180.0, 1.0, 1.0, 0.4),
        (98.0, 180.0, 0.0, 1.0, 0.4),
    ]
    .map(|(x, y, u, v, near): (f32, f32, f32, f32, f32)| (Vec2::new(x, y), Vec2::new(u, v), near));
    let board = chequered(8, 8, [Color::rgb(250, 235, 200), Color::rgb(20, 90, 130)]);
    let draw = |in_space: bool| {
        let mut image = Image::new(300, 200, Format::Rgb);
        for [a, b, c] in [[0, 1, 2], [0, 2, 3]].map(|triangle| triangle.map(|n: usize| corners[n])) {
            fill([a.0, b.0, c.0], image.bounds(), |x, y, weights| {
                let uvs = [a.1, b.1, c.1];
                let near = weights * Vec3::new(a.2, b.2, c.2);
                let shares = if in_space { near / near.element_sum() } else { weights };
                image.set(x, y, texel(&board, interpolate(uvs, shares)));
            });
        }
        image
    };
    beside([&draw(false), &draw(true)])
}
