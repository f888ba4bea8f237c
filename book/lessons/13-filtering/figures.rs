//! Chapter 13: a texture without flicker.

use std::f32::consts::{PI, TAU};
use std::path::Path;

use anyhow::Context;
use clipping::mesh::indexed;
use clipping::{Cull, Mesh, SLABS};
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec2, Vec3};
use filtering::filter::{Filter, MOST_PROBES, Trilinear};
use filtering::footprint::{Axes, Gradients};
use filtering::layout::{Layout, Morton, Rows, Tiles};
use filtering::light::SRGB;
use filtering::mipmap::Mipmap;
use filtering::scene::fine;
use filtering::{
    Footprint, Level, METHODS, MIPMAPS, Sampler, Surface, Texture, WRAPS, Wrap, bilinear, bilinear_8, draw,
    level, trilinear,
};
use perspective::scene::Loaded;
use perspective::{perspective, view};

use crate::figures::picture::{chequered, method, model, painted, paste, texture};
use crate::figures::sheet::{
    AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, MINT, ORANGE, PALE, ROSE, SKY, Sheet,
};
use crate::figures::{Drawing, Figure};
use crate::lessons::clipping::figures::{ALL, CENTER, EYE, to_clip};
#[cfg(feature = "measure")]
use crate::lessons::transforms::figures::TILES;

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "filtering-head",
        "A head on a chequered floor, twice. On the left the floor breaks up into grains and curved patterns towards the \
         horizon; on the right its squares fade evenly into one tone.",
        head,
    ),
    Figure::new(
        "filtering-footprints",
        "Left a picture of a floor with seven pixels marked. Right the floor from above, with seven areas in the same \
         colours: small and square near the eye, long and narrow far away.",
        footprints,
    ),
    Figure::new(
        "filtering-samples",
        "Eleven points at equal distances, and two waves through all of them: a fast one with nine periods, and a slow one with \
         one.",
        samples,
    ),
    Figure::new(
        "filtering-folded",
        "A zigzag line: what is seen against what is there. It rises to one half at one half, falls to 0 at 1, rises again, and \
         so on. The point for 0.9 is at 0.1.",
        folded,
    ),
    Figure::new(
        "filtering-kernels",
        "Above, a rectangle one pixel wide and a triangle two pixels wide. Below, what each leaves of a wave: the curve of the \
         box falls to 0 at 1 and swings around 0 after that, that of the tent falls faster and stays near 0.",
        kernels,
    ),
    Figure::new(
        "filtering-centres",
        "Nine texels with their centres, and a place between four of these. Around it a square as large as a texel, in four \
         parts, each on another texel and each the weight of that.",
        centres,
    ),
    Figure::new(
        "filtering-enlarged",
        "Part of a face, much enlarged, twice: on the left in blocks, on the right without.",
        enlarged,
    ),
    Figure::new(
        "filtering-wraps",
        "Three strips. On top the texture's four colours with the outermost ones drawn out to both sides; in the middle the \
         four colours three times; below three times as well, in the middle forwards and on both sides backwards.",
        wraps,
    ),
    Figure::new(
        "filtering-pyramid",
        "The texture of the head in ten sizes, each half as wide and as high as the one before, down to a point.",
        pyramid,
    ),
    Figure::new(
        "filtering-odd",
        "Five texels in a row, and under them two. Of the first two and a half arrows lead to the one, of the others to the \
         other, with the weights two, two and one fifths, and one, two and two fifths.",
        odd,
    ),
    Figure::new(
        "filtering-curve",
        "A curve from code 0 to code 255 that bends upwards. At the code 128 it is at 22 percent; it is at one half at the code \
         188.",
        of_curve,
    ),
    Figure::new(
        "filtering-darkened",
        "A chequered board that leads away, twice. On the left it gets darker towards the horizon; on the right it keeps its \
         brightness.",
        darkened,
    ),
    Figure::new(
        "filtering-parallelogram",
        "A square with a circle in it, and the parallelogram and the ellipse that become of them on a grid of texels. The \
         ellipse is longer than the parallelogram's sides.",
        parallelogram,
    ),
    Figure::new(
        "filtering-bands",
        "A floor coloured by level, twice: on the left in bands with sharp borders, on the right with the colours blended.",
        bands,
    ),
    Figure::new(
        "filtering-biased",
        "A floor three times: grainy towards the horizon, even, and blurred.",
        biased,
    ),
    Figure::new(
        "filtering-ways",
        "A floor to the horizon four times: breaking up into grains; blurred long before the horizon; sharp to near the \
         horizon; and the same once more.",
        ways,
    ),
    Figure::new(
        "filtering-seams",
        "A head from behind, three times: as it should be, with thin dark lines where the texture was cut, and in large spots of \
         colour with wide dark lines.",
        seams,
    ),
    Figure::new(
        "filtering-probes",
        "A long, slanted parallelogram. Around it a large grey square as wide as it is long; along it a row of small squares.",
        probes,
    ),
    Figure::new(
        "filtering-weights",
        "Two strips from black to dark grey: the upper one smooth, the lower one in sixteen steps, of which the first is the \
         largest.",
        weights,
    ),
    Figure::new(
        "filtering-layouts",
        "Eight by eight texels three times, with a line through them in the order of memory: row after row; through squares \
         of four by four, row after row in each; in zigzags within zigzags.",
        layouts,
    ),
    Figure::new(
        "filtering-walk",
        "A slanted line of points over a grid of texels, twice. Above, each point or two lies in a level strip of its own; \
         below, the points lie in a chain of squares, and there are fewer of these.",
        walk,
    ),
    Figure::new(
        "filtering-flight",
        "Two rows of four small pictures of a floor near the horizon, each from a little farther on. In the upper row the \
         patterns differ from picture to picture; in the lower one all four are alike.",
        flight,
    ),
    Figure::new(
        "filtering-slid",
        "A letter of eight by eight texels, enlarged, with smooth borders, in the middle of its field and half a texel off.",
        slid,
    ),
];

/// A model with its mesh and a texture with all its levels.
pub(crate) struct Subject {
    loaded: Loaded,
    mesh: Mesh,
    texture: Texture,
}

impl Subject {
    fn new(model: Model, image: Image, wrap: Wrap, mipmap: Mipmap) -> Self {
        let texture = mipmap.texture(&image, wrap);
        let loaded = Loaded::new(model, image, textures::Wrap::Clamp);
        let mesh = indexed(&loaded.model, &loaded.normals, ALL);
        Self { loaded, mesh, texture }
    }

    /// The texture as it was.
    #[cfg(feature = "measure")]
    pub(crate) fn image(&self) -> &Image {
        &self.loaded.texture
    }

    #[cfg(feature = "measure")]
    pub(crate) fn model(&self) -> &Model {
        &self.loaded.model
    }

    pub(crate) fn surface(&self, light: Vec3, to_clip: Mat4) -> Surface<'_> {
        Surface { uniforms: self.loaded.uniforms(light, to_clip), mesh: &self.mesh, texture: &self.texture }
    }
}

/// The usual way to make levels.
pub(crate) fn of_light() -> anyhow::Result<Mipmap> {
    Ok(*method(MIPMAPS, "box-linear")?)
}

fn of_head() -> anyhow::Result<Subject> {
    Ok(Subject::new(model()?, texture()?, Wrap::Clamp, of_light()?))
}

/// Lesson 11's floor, with a texture.
pub(crate) fn floor_of(image: Image, mipmap: Mipmap) -> anyhow::Result<Subject> {
    let model = Model::read(Path::new(SLABS[0]), Attributes { normals: true, uvs: true })?;
    Ok(Subject::new(model, image, Wrap::Repeat, mipmap))
}

pub(crate) fn of_floor() -> anyhow::Result<Subject> {
    floor_of(fine(&Image::read(Path::new(SLABS[1]))?), of_light()?)
}

/// Subjects, filtered in one way. Not drawn larger than it is shown: what this chapter is about would be lost.
fn picture<F: Filter>(
    subjects: &[Subject],
    filter: F,
    (light, to_clip): (Vec3, Mat4),
    [width, height]: [u16; 2],
) -> Image {
    let mut image = Image::new(width, height, Format::Rgb);
    let surfaces: Vec<Surface> =
        subjects.iter().map(|subject| subject.surface(light.normalize(), to_clip)).collect();
    draw(&surfaces, filter, Cull::Back, &mut image);
    image
}

/// The same by what a row of the lesson's table has.
fn lit_by_sampler(
    sampler: &Sampler,
    subjects: &[Subject],
    (light, to_clip): (Vec3, Mat4),
    [width, height]: [u16; 2],
) -> Image {
    let mut image = Image::new(width, height, Format::Rgb);
    let surfaces: Vec<Surface> =
        subjects.iter().map(|subject| subject.surface(light.normalize(), to_clip)).collect();
    (sampler.draw)(&surfaces, Cull::Back, &mut image);
    image
}

/// Under a light from above.
#[cfg(feature = "measure")]
pub(crate) fn by_sampler(sampler: &Sampler, subjects: &[Subject], to_clip: Mat4, size: [u16; 2]) -> Image {
    lit_by_sampler(sampler, subjects, (Vec3::Y, to_clip), size)
}

/// The same by a row of the lesson's table.
fn by_method(name: &str, subjects: &[Subject], scene: (Vec3, Mat4), size: [u16; 2]) -> anyhow::Result<Image> {
    Ok(lit_by_sampler(method(METHODS, name)?, subjects, scene, size))
}

/// Between pictures.
const GAP: i32 = 6;

/// Pictures of one size in rows, one pixel for one.
fn rows_of(rows: &[Vec<Image>]) -> anyhow::Result<Drawing> {
    let first = rows.first().and_then(|row| row.first()).context("there is no picture")?;
    let [width, height] = [first.width(), first.height()];
    let whole = |side: i32, count: usize| (side * count as i32 + GAP * (count as i32 - 1)) as u16;
    let mut sheet = Image::new(whole(width, rows[0].len()), whole(height, rows.len()), Format::Rgb);
    sheet.buffer_mut().fill(96);
    for (n, row) in rows.iter().rev().enumerate() {
        for (m, image) in row.iter().enumerate() {
            paste(image, &mut sheet, [m as i32 * (width + GAP), n as i32 * (height + GAP)]);
        }
    }
    Ok(Drawing::Pixels(sheet, 1))
}

/// Pictures side by side, one pixel for one.
fn in_a_row(pictures: impl IntoIterator<Item = anyhow::Result<Image>>) -> anyhow::Result<Drawing> {
    rows_of(&[pictures.into_iter().collect::<anyhow::Result<Vec<Image>>>()?])
}

/// The size of one of two pictures, and of one of three.
const HALF: u16 = 447;
const THIRD: u16 = 296;

const LIGHT: Vec3 = Vec3::new(0.4, 0.8, 0.8);

fn head() -> anyhow::Result<Drawing> {
    let subjects = [of_head()?, of_floor()?];
    let to_clip = to_clip(45.0, EYE, CENTER)?;
    in_a_row(["nearest", "trilinear"].map(|name| by_method(name, &subjects, (LIGHT, to_clip), [HALF, HALF])))
}

fn footprints() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    const SIZE: [i32; 2] = [24, 18];
    let size = at(SIZE[0] as f32, SIZE[1] as f32);
    // A level eye one above the floor; texture coordinates are x and the depth.
    let eye = Vec3::Y;
    let look = view(eye, eye - Vec3::Z, Vec3::Y).context("it looks somewhere")?;
    let to_clip = perspective(45.0, size.x / size.y, 0.1, 100.0)? * look;
    let corners = [at(-90.0, 0.5), at(90.0, 0.5), at(0.0, 90.0)];
    let clip = corners.map(|uv| to_clip * Vec3::new(uv.x, 0.0, -uv.y).extend(1.0));
    let gradients = Gradients::new(clip, corners, size);
    let half = (45.0_f32.to_radians() / 2.0).tan();
    let seen = |x: i32, y: i32| {
        let center = (at(x as f32, y as f32) + 0.5) / size * 2.0 - 1.0;
        let depth = -1.0 / (center.y * half);
        at(center.x * half * size.x / size.y * depth, depth)
    };
    // In the picture on the left, of a place on the floor.
    let (scale, left, right) = (0.4, at(0.0, 1.5), at(13.2, -1.6));
    // Of the picture only what is below the horizon, and a little more.
    let (wide, high) = (size.x * scale, 10.6 * scale);
    let shown = |uv: Vec2| {
        let clip = to_clip * Vec3::new(uv.x, 0.0, -uv.y).extend(1.0);
        left + (at(clip.x, clip.y) / clip.w + 1.0) / 2.0 * size * scale
    };
    let mut sheet = Sheet::new((-0.1, -0.75), (16.4, 9.4));
    sheet.rectangle(left, left + at(wide, high), PALE, GREY);
    let horizon = left + at(0.0, size.y / 2.0 * scale);
    sheet.line(horizon, horizon + at(wide, 0.0), GREY, 1.4);
    // Level lines of the floor, and lines that lead away; all within the picture.
    for depth in [2.5_f32, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 24.0] {
        let y = shown(at(0.0, depth)).y;
        sheet.line((left.x, y), (left.x + wide, y), FAINT, 1.2);
    }
    for u in -5..=5 {
        let far = shown(at(u as f32, 400.0));
        let nearest = (1..400)
            .map(|n| at(u as f32, 2.42 + 0.05 * n as f32))
            .find(|uv| (left.x..=left.x + wide).contains(&shown(*uv).x));
        if let Some(near) = nearest {
            sheet.line(shown(near), far, FAINT, 1.2);
        }
    }
    for u in -2..=3 {
        let x = right.x + u as f32;
        sheet.line((x, right.y + 2.0), (x, right.y + 10.8), FAINT, 1.2);
    }
    for v in 2..=10 {
        let y = right.y + v as f32;
        sheet.line((right.x - 2.0, y), (right.x + 3.0, y), FAINT, 1.2);
    }
    let fills: [(Ink, Ink); 3] = [(SKY, BLUE), (AMBER, ORANGE), (MINT, GREEN)];
    let pixels = [(4, 0), (12, 0), (19, 1), (7, 3), (15, 4), (10, 5), (16, 6)];
    for (n, (x, y)) in pixels.into_iter().enumerate() {
        let (fill, ink) = fills[n % 3];
        let corner = left + at(x as f32, y as f32) * scale;
        sheet.rectangle(corner, corner + scale, fill, ink);
        let uv = seen(x, y);
        let Footprint { x: a, y: b } = gradients.footprint(x, y, uv);
        sheet.polygon(&[-a - b, a - b, a + b, b - a].map(|p| right + uv + p / 2.0), fill, ink);
    }
    sheet.text(left + at(wide / 2.0, -0.6), "picture", GREY);
    sheet.text(right + at(0.5, 1.2), "floor, from above", GREY);
    sheet.finish()
}
/// A wave of so many periods a pixel.
fn wave(periods: f32) -> impl Fn(f32) -> f32 {
    move |x| (TAU * periods * x).cos()
}

/// A curve over an interval, as points.
fn curve(from: f32, to: f32, f: impl Fn(f32) -> f32) -> impl Iterator<Item = Vec2> {
    (0..=400).map(move |n| from + (to - from) * n as f32 / 400.0).map(move |x| Vec2::new(x, f(x)))
}

fn samples() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.35, -2.05), (10.4, 1.75));
    let up = 1.2;
    sheet.line((0.0, 0.0), (10.2, 0.0), FAINT, 1.6);
    for n in 0..=10 {
        sheet.line((n as f32, -1.2), (n as f32, 1.2), FAINT, 1.2);
        sheet.text((n as f32, -1.5), &n.to_string(), GREY);
    }
    for (periods, ink, width) in [(0.9, BLUE, 2.0), (0.1, ORANGE, 3.0)] {
        sheet.polyline(curve(0.0, 10.0, wave(periods)).map(|p| p * Vec2::new(1.0, up)), ink, width);
    }
    for n in 0..=10 {
        sheet.dot((n as f32, up * wave(0.9)(n as f32)), BLACK);
    }
    sheet.text((5.0, -1.9), "pixels", GREY);
    sheet.text((2.6, 1.55), "the texture", BLUE);
    sheet.text((7.4, 1.55), "what is seen", ORANGE);
    sheet.finish()
}

fn folded() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.55, -0.42), (3.2, 0.86));
    let seen = |f: f32| (f - f.round()).abs();
    sheet.rectangle((0.0, 0.0), (0.5, 0.55), PALE, "none");
    sheet.axes((0.0, 0.0), (0.0, 0.0), (3.1, 0.68), 1.5);
    sheet.dashed((0.0, 0.5), (3.05, 0.5), FAINT, 1.6);
    sheet.polyline((0..=6).map(|n| n as f32 / 2.0).map(|f| (f, seen(f))), BLUE, 3.2);
    for (f, name) in [(0.5, "½"), (1.0, "1"), (1.5, "1½"), (2.0, "2"), (2.5, "2½"), (3.0, "3")] {
        sheet.line((f, -0.03), (f, 0.03), GREY, 1.6);
        sheet.text((f, -0.13), name, BLACK);
    }
    sheet.dashed((0.9, 0.0), (0.9, seen(0.9)), ORANGE, 1.8);
    sheet.dashed((0.0, seen(0.9)), (0.9, seen(0.9)), ORANGE, 1.8);
    sheet.dot((0.9, seen(0.9)), ORANGE);
    sheet.text_left_of((-0.05, 0.5), "½", BLACK);
    sheet.text_left_of((-0.05, 0.0), "0", BLACK);
    sheet.text_right_of((0.06, 0.76), "periods a pixel that are seen", GREY);
    sheet.text((1.5, -0.3), "periods a pixel", GREY);
    sheet.finish()
}

/// What is left of a wave of so many periods a pixel after the mean over a pixel.
pub(super) fn of_box(periods: f32) -> f32 {
    let x = PI * periods;
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

fn kernels() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-1.75, -4.75), (4.55, 1.75));
    // The weights.
    for (middle, ink, fill, corners, name) in [
        (at(-0.2, 0.0), BLUE, SKY, vec![at(-0.5, 0.0), at(-0.5, 1.0), at(0.5, 1.0), at(0.5, 0.0)], "box"),
        (at(3.0, 0.0), ORANGE, AMBER, vec![at(-1.0, 0.0), at(0.0, 1.0), at(1.0, 0.0)], "tent"),
    ] {
        let corners: Vec<Vec2> = corners.into_iter().map(|p| p + middle).collect();
        sheet.polygon(&corners, fill, ink);
        sheet.line(middle - at(1.4, 0.0), middle + at(1.4, 0.0), GREY, 1.5);
        for (x, name) in [(-1.0, "−1"), (0.0, "0"), (1.0, "1")] {
            sheet.line(middle + at(x, -0.05), middle + at(x, 0.05), GREY, 1.5);
            sheet.text(middle + at(x, -0.28), name, BLACK);
        }
        sheet.text(middle + at(0.0, 1.35), name, ink);
    }
    // What they leave of a wave.
    let origin = at(-1.2, -3.35);
    let (wide, high) = (1.75, 2.1);
    let place = |p: Vec2| origin + p * at(wide, high);
    sheet.polygon(&[at(0.0, -0.24), at(0.5, -0.24), at(0.5, 1.0), at(0.0, 1.0)].map(place), PALE, "none");
    sheet.axes(origin, (0.0, -0.5), (5.5, 2.3), 1.5);
    sheet.polyline(curve(0.0, 3.05, of_box).map(place), BLUE, 2.8);
    sheet.polyline(curve(0.0, 3.05, |f| of_box(f).powi(2)).map(place), ORANGE, 2.8);
    sheet.dashed(place(at(0.5, -0.24)), place(at(0.5, 1.08)), GREY, 1.6);
    for (f, name) in [(0.5, "½"), (1.0, "1"), (2.0, "2"), (3.0, "3")] {
        sheet.text(place(at(f, -0.33)), name, BLACK);
    }
    sheet.text_left_of(place(at(-0.06, 1.0)), "1", BLACK);
    sheet.text_left_of(place(at(-0.06, 0.0)), "0", BLACK);
    sheet.text_right_of(place(at(0.72, 0.78)), "what is left of a wave", GREY);
    sheet.text(place(at(1.5, -0.58)), "periods a pixel", GREY);
    sheet.finish()
}

fn centres() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-1.9, -0.35), (5.2, 3.35));
    let fills = [[SKY, AMBER, PALE], [MINT, ROSE, PALE], [PALE, PALE, PALE]];
    for (j, row) in fills.iter().enumerate() {
        for (i, fill) in row.iter().enumerate() {
            let low = at(i as f32, j as f32);
            sheet.rectangle(low, low + 1.0, fill, FAINT);
        }
    }
    // The share of the way from the centre of texel (0, 0): to the right and up.
    let (t, s) = (0.7, 0.4);
    let place = at(0.5 + t, 0.5 + s);
    let (low, high) = (place - 0.5, place + 0.5);
    for (from, to, fill) in [
        (low, at(1.0, 1.0), SKY),
        (at(1.0, low.y), at(high.x, 1.0), AMBER),
        (at(low.x, 1.0), at(1.0, high.y), MINT),
        (at(1.0, 1.0), high, ROSE),
    ] {
        sheet.rectangle(from, to, fill, BLACK);
    }
    for j in 0..3 {
        for i in 0..3 {
            sheet.dot(at(i as f32 + 0.5, j as f32 + 0.5), GREY);
        }
    }
    sheet.dot(place, ORANGE);
    for (corner, words) in [
        (at(3.25, 0.15), "(1−t)(1−s)"),
        (at(3.25, 0.75), "t (1−s)"),
        (at(3.25, 1.35), "(1−t) s"),
        (at(3.25, 1.95), "t s"),
    ]
    .into_iter()
    .zip([SKY, AMBER, MINT, ROSE])
    .map(|((corner, words), fill)| ((corner, fill), words))
    {
        let (corner, fill) = corner;
        sheet.rectangle(corner, corner + 0.35, fill, BLACK);
        sheet.text_right_of(corner + at(0.5, 0.17), words, BLACK);
    }
    sheet.text_left_of((-0.15, 0.5), "row j", GREY);
    sheet.text_left_of((-0.15, 1.5), "row j + 1", GREY);
    sheet.text((0.5, -0.22), "i", GREY);
    sheet.text((1.5, -0.22), "i + 1", GREY);
    sheet.finish()
}
fn odd() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.3, -1.0), (10.3, 3.7));
    // In halves of an old texel, as k = 2.
    for i in 0..5 {
        let fill = [SKY, SKY, PALE, AMBER, AMBER][i];
        let low = at(2.0 * i as f32, 2.0);
        sheet.rectangle(low, low + at(2.0, 1.0), fill, BLACK);
        sheet.text(low + at(1.0, 1.35), &i.to_string(), GREY);
    }
    sheet.dashed((5.0, 2.0), (5.0, 3.0), GREY, 1.6);
    for (j, (fill, weights)) in [(SKY, [2, 2, 1]), (AMBER, [1, 2, 2])].into_iter().enumerate() {
        let low = at(5.0 * j as f32, 0.0);
        sheet.rectangle(low, low + at(5.0, 1.0), fill, BLACK);
        let mut from = low.x;
        for (n, weight) in weights.into_iter().enumerate() {
            let middle = from + weight as f32 / 2.0;
            let to = at(low.x + [0.9, 2.5, 4.1][n], 1.0);
            sheet.arrow((middle, 1.93), to + at(0.0, 0.07), GREY);
            sheet.text(low + at([0.9, 2.5, 4.1][n], 0.5), &format!("{weight}/5"), BLACK);
            from += weight as f32;
        }
        sheet.text(low + at(2.5, -0.42), &j.to_string(), GREY);
    }
    sheet.finish()
}

fn parallelogram() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-4.9, -2.7), (5.6, 2.7));
    // Left the pixel, right its footprint on a grid of texels.
    let (pixel, middle) = (at(-3.7, 0.0), at(2.2, 0.0));
    let (a, b) = (at(3.4, 1.5), at(0.9, 2.3));
    let grid: Vec<i32> = (0..=6).collect();
    for &n in &grid {
        let x = -0.8 + n as f32;
        sheet.line((x, -2.5), (x, 2.5), FAINT, 1.0);
    }
    for n in 0..=5 {
        let y = -2.5 + n as f32;
        sheet.line((-0.8, y), (5.2, y), FAINT, 1.0);
    }
    sheet.rectangle(pixel - 0.8, pixel + 0.8, SKY, BLUE);
    sheet.polygon(&[-a - b, a - b, a + b, b - a].map(|p| middle + p / 2.0), SKY, BLUE);
    let circle = |n: i32| Vec2::from_angle(TAU * n as f32 / 120.0) / 2.0;
    sheet.polyline((0..=120).map(circle).map(|p| pixel + 1.6 * p), ORANGE, 2.6);
    sheet.polyline((0..=120).map(circle).map(|p| middle + p.x * a + p.y * b), ORANGE, 2.6);
    sheet.arrow(pixel, pixel + at(1.6, 0.0), BLACK);
    sheet.arrow(pixel, pixel + at(0.0, 1.6), BLACK);
    sheet.arrow(middle, middle + a, BLACK);
    sheet.arrow(middle, middle + b, BLACK);
    sheet.text(pixel + at(1.35, -0.3), "1", BLACK);
    sheet.text(pixel + at(-0.3, 1.4), "1", BLACK);
    sheet.text(middle + a + at(-0.15, -0.4), "a", BLACK);
    sheet.text(middle + b + at(0.35, 0.05), "b", BLACK);
    sheet.text(pixel + at(0.0, -1.35), "picture", GREY);
    sheet.text_left_of((-0.95, -2.3), "texture", GREY);
    sheet.finish()
}
/// A square of the head about its eye, so that a texel is many pixels.
fn enlarged() -> anyhow::Result<Drawing> {
    let head = [of_head()?];
    let eye = Vec3::new(0.18, 0.275, 4.0);
    let view = view(eye, eye.with_z(0.0), Vec3::Y).context("it looks somewhere")?;
    let to_clip = perspective(1.3, 1.0, 0.1, 100.0)? * view;
    in_a_row(["nearest", "bilinear"].map(|name| by_method(name, &head, (Vec3::Z, to_clip), [HALF, HALF])))
}

fn wraps() -> anyhow::Result<Drawing> {
    const WIDTH: i32 = 900;
    const HEIGHT: i32 = 64;
    const BETWEEN: i32 = 14;
    let colors = [(0x1f, 0x55, 0x77), (0xf2, 0xc1, 0x4e), (0xd5, 0x5e, 0x00), (0xf1, 0xee, 0xe5)]
        .map(|(r, g, b)| Color::rgb(r, g, b));
    let row = painted(4, 1, |x, _| colors[x as usize]);
    let level = Level::<Rows>::new(&row, &SRGB);
    let step = HEIGHT + BETWEEN;
    let image = painted(WIDTH as u16, (3 * step - BETWEEN) as u16, |x, y| {
        let u = (x as f32 + 0.5) / 300.0 - 1.0;
        // The first strip is the uppermost one.
        let (strip, inside) = (2 - (y / step).min(2), y % step < HEIGHT);
        let border = [299, 300, 599, 600].contains(&x);
        match inside {
            true => SRGB.color(bilinear(&level, Vec2::new(u, 0.5), WRAPS[strip as usize].run)),
            false if border => Color::rgb(0xd5, 0x5e, 0x00),
            false => Color::gray(0.99),
        }
    });
    Ok(Drawing::Pixels(image, 1))
}

fn pyramid() -> anyhow::Result<Drawing> {
    let levels = of_light()?.levels(&texture()?, Wrap::Clamp);
    let mut sheet = Image::new(512 + GAP as u16 + 256, 512, Format::Rgb);
    sheet.buffer_mut().fill(250);
    // The first one to the left, all others in a column from the bottom.
    let mut bottom = 0;
    for (n, level) in levels[1..].iter().enumerate() {
        let place = if n == 0 { [0, 0] } else { [512 + GAP, bottom] };
        paste(level, &mut sheet, place);
        if n > 0 {
            bottom += level.height();
        }
    }
    Ok(Drawing::Pixels(sheet, 1))
}

fn of_curve() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.3, -0.2), (1.5, 1.13));
    let light = |code: u8| SRGB.light(Color::rgb(code, code, code)).x / 255.0;
    let place = |code: u8| at(f32::from(code) / 255.0, light(code));
    sheet.axes((0.0, 0.0), (0.0, 0.0), (1.06, 1.06), 1.5);
    for (code, ink) in [(128, ORANGE), (188, BLUE)] {
        let p = place(code);
        sheet.dashed((p.x, 0.0), p, ink, 1.8);
        sheet.dashed((0.0, p.y), p, ink, 1.8);
    }
    sheet.polyline((0..=255).map(place), BLACK, 2.8);
    for (code, ink) in [(0, BLACK), (128, ORANGE), (188, BLUE), (255, BLACK)] {
        sheet.dot(place(code), ink);
        sheet.text((place(code).x, -0.07), &code.to_string(), ink);
    }
    sheet.text_left_of((-0.03, light(128)), "22 %", ORANGE);
    sheet.text_left_of((-0.03, light(188)), "50 %", BLUE);
    sheet.text_left_of((-0.03, 1.0), "light", GREY);
    sheet.text((1.32, -0.07), "code", GREY);
    sheet.text_right_of((0.78, 0.5), "mean of the light", BLUE);
    sheet.text_right_of((0.78, 0.2), "mean of the codes", ORANGE);
    sheet.finish()
}

/// Black and white, to be repeated.
fn board() -> Image {
    chequered(2, 2, [Color::BLACK, Color::WHITE])
}

/// Fine checks: squares of so many texels, 128 texels each way.
#[cfg(feature = "measure")]
pub(crate) fn squares(texels: u16) -> Image {
    chequered(128 / texels, 128 / texels, TILES).scale(128, 128)
}

/// A board that leads away, its levels made in one way.
pub(crate) fn led_away(mipmap: &str, size: [u16; 2]) -> anyhow::Result<Image> {
    let floor = [floor_of(fine(&board()), *method(MIPMAPS, mipmap)?)?];
    let (eye, center) = (Vec3::new(0.3, -0.5, 3.0), Vec3::new(0.3, -1.03, 0.0));
    let look = view(eye, center, Vec3::Y).context("it looks somewhere")?;
    let to_clip = perspective(24.0, f32::from(size[0]) / f32::from(size[1]), 0.1, 1000.0)? * look;
    by_method("trilinear", &floor, (Vec3::Y, to_clip), size)
}

fn darkened() -> anyhow::Result<Drawing> {
    in_a_row(["box-encoded", "box-linear"].map(|mipmap| led_away(mipmap, [HALF, 280])))
}

/// One colour a level.
fn painted_levels() -> Texture {
    let colors = [
        (0xd5, 0x5e, 0x00),
        (0xf2, 0xc1, 0x4e),
        (0x9a, 0xc3, 0x4b),
        (0x00, 0x7a, 0x5a),
        (0x2f, 0x9f, 0xc4),
        (0x00, 0x52, 0x92),
        (0x6a, 0x4c, 0x93),
        (0xa8, 0x48, 0x7f),
        (0x50, 0x50, 0x58),
    ];
    let levels: Vec<Image> = colors
        .into_iter()
        .enumerate()
        .map(|(n, (r, g, b))| painted(256 >> n, 256 >> n, |_, _| Color::rgb(r, g, b)))
        .collect();
    Texture::of_levels(&levels, Wrap::Repeat, &SRGB)
}

/// Looks into the level that is nearest to a footprint's, and no other.
#[derive(Clone, Copy)]
struct Rounded;

impl Filter for Rounded {
    type Footprint = Footprint;

    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, footprint: Footprint) -> Color {
        let level = level(footprint, texture.base().size()).round();
        texture.base().codes().color(trilinear(texture, uv, level))
    }
}

/// An eye near the floor, which fills all but the upper border of a picture of that size.
pub(crate) fn over_the_floor([width, height]: [u16; 2]) -> anyhow::Result<Mat4> {
    let eye = Vec3::new(0.3, -0.35, 3.0);
    let look = view(eye, eye + Vec3::new(0.6, -0.4, -1.8), Vec3::Y).context("it looks somewhere")?;
    Ok(perspective(30.0, f32::from(width) / f32::from(height), 0.1, 1000.0)? * look)
}

fn bands() -> anyhow::Result<Drawing> {
    let floor = [Subject { texture: painted_levels(), ..of_floor()? }];
    let size = [HALF, 240];
    let scene = (Vec3::Y, over_the_floor(size)?);
    in_a_row([Ok(picture(&floor, Rounded, scene, size)), Ok(picture(&floor, Trilinear, scene, size))])
}

/// Trilinear, so many levels off.
#[derive(Clone, Copy)]
struct Biased(f32);

impl Filter for Biased {
    type Footprint = Footprint;

    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, footprint: Footprint) -> Color {
        let level = level(footprint, texture.base().size()) + self.0;
        texture.base().codes().color(trilinear(texture, uv, level))
    }
}

fn biased() -> anyhow::Result<Drawing> {
    let floor = [of_floor()?];
    let size = [THIRD, 220];
    let scene = (Vec3::Y, over_the_floor(size)?);
    in_a_row([-1.0, 0.0, 1.0].map(|bias| Ok(picture(&floor, Biased(bias), scene, size))))
}

/// The floor by a method.
pub(crate) fn to_the_horizon(name: &str) -> anyhow::Result<Image> {
    let size = [HALF, 240];
    by_method(name, &[of_floor()?], (Vec3::Y, over_the_floor(size)?), size)
}

/// The mean of so many look-ups a pixel, each way, of light.
fn averaged(large: &Image, each: i32) -> Image {
    let [width, height] = [large.width(), large.height()].map(|side| (side / each) as u16);
    painted(width, height, |x, y| {
        let pixels = (0..each * each).filter_map(|n| large.get(x * each + n % each, y * each + n / each));
        SRGB.color(pixels.map(|color| SRGB.light(color)).sum::<common::Vec4>() / (each * each) as f32)
    })
}

fn ways() -> anyhow::Result<Drawing> {
    const EACH: u16 = 8;
    let floor = [of_floor()?];
    let size = [HALF, 240];
    let scene = (Vec3::Y, over_the_floor(size)?);
    let [bilinear, trilinear, anisotropic] = ["bilinear", "trilinear", "anisotropic"].map(to_the_horizon);
    let large = by_method("nearest", &floor, scene, size.map(|side| side * EACH))?;
    rows_of(&[vec![bilinear?, trilinear?], vec![anisotropic?, averaged(&large, EACH.into())]])
}

/// Looks into one level, whatever the footprint.
#[derive(Clone, Copy)]
struct Fixed(f32);

impl Filter for Fixed {
    type Footprint = ();

    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, (): ()) -> Color {
        texture.base().codes().color(trilinear(texture, uv, self.0))
    }
}

fn seams() -> anyhow::Result<Drawing> {
    let head = [of_head()?];
    let to_clip = to_clip(11.0, Vec3::new(-2.6, 0.7, -1.9), Vec3::new(-0.126, 0.157, 0.173))?;
    let light = Vec3::new(-0.8, 0.5, -0.3);
    in_a_row([0.0, 3.0, 5.0].map(|level| Ok(picture(&head, Fixed(level), (light, to_clip), [THIRD, THIRD]))))
}

fn probes() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-6.4, -4.9), (6.4, 4.9));
    for n in -6..=6 {
        sheet.line((n as f32, -4.8), (n as f32, 4.8), FAINT, 1.0);
    }
    for n in -4..=4 {
        sheet.line((-6.3, n as f32), (6.3, n as f32), FAINT, 1.0);
    }
    let footprint = Footprint { x: at(1.1, -0.55), y: at(7.0, 4.1) };
    let Footprint { x: a, y: b } = footprint;
    let Axes { direction, major, minor } = footprint.axes();
    let side = major.max(a.length()).max(b.length()) / 2.0;
    let square = |middle: Vec2, half: f32| {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| middle + at(x, y) * half)
    };
    sheet.polygon(&square(Vec2::ZERO, side), PALE, GREY);
    sheet.polygon(&[-a - b, a - b, a + b, b - a].map(|p| p / 2.0), SKY, BLUE);
    // As many as the filter takes, where it takes them.
    let width = minor.max(major / f32::from(MOST_PROBES));
    let count = (major / width.max(1.0)).ceil() as i32;
    for n in 0..count {
        let middle = direction * major * ((n as f32 + 0.5) / count as f32 - 0.5);
        sheet.polygon(&square(middle, width / 2.0), "none", ORANGE);
        sheet.dot(middle, ORANGE);
    }
    sheet.text_left_of((side - 0.15, -side + 0.4), "trilinear", GREY);
    sheet.text_left_of((6.2, 4.45), &format!("{count} probes"), ORANGE);
    sheet.finish()
}

fn weights() -> anyhow::Result<Drawing> {
    const WIDTH: i32 = 900;
    const HEIGHT: i32 = 90;
    const BETWEEN: i32 = 6;
    let row = painted(2, 1, |x, _| if x == 0 { Color::BLACK } else { Color::WHITE });
    let level = Level::<Rows>::new(&row, &SRGB);
    let image = painted(WIDTH as u16, (2 * HEIGHT + BETWEEN) as u16, |x, y| {
        // From the black centre on, a sixteenth of the way to the white one.
        let at = Vec2::new(0.25 + (x as f32 + 0.5) / WIDTH as f32 / 32.0, 0.5);
        if y >= HEIGHT + BETWEEN {
            SRGB.color(bilinear(&level, at, Wrap::Clamp))
        } else if y < HEIGHT {
            SRGB.color(bilinear_8(&level, at, Wrap::Clamp))
        } else {
            Color::gray(0.99)
        }
    });
    Ok(Drawing::Pixels(image, 1))
}

/// The fills of four lines of memory.
const LINES: [Ink; 4] = [SKY, AMBER, MINT, ROSE];

fn layouts() -> anyhow::Result<Drawing> {
    const SIDE: u32 = 8;
    let mut sheet = Sheet::new((-0.2, -1.4), (28.2, 8.2));
    let mut panel = |n: i32, name: &str, place: &dyn Fn(u32, u32) -> usize| {
        let left = 10 * n;
        let mut order: Vec<(usize, u32, u32)> = (0..SIDE)
            .flat_map(|y| (0..SIDE).map(move |x| (x, y)))
            .map(|(x, y)| (place(x, y), x, y))
            .collect();
        order.sort_unstable();
        for &(place, x, y) in &order {
            sheet.pixel(left + x as i32, y as i32, LINES[place / 16 % 4]);
        }
        let centre = |&(_, x, y): &(usize, u32, u32)| Vec2::new(left as f32 + x as f32 + 0.5, y as f32 + 0.5);
        sheet.polyline(order.iter().map(centre), BLACK, 1.8);
        sheet.dot(centre(&order[0]), ORANGE);
        sheet.text((left as f32 + 4.0, -0.9), name, BLACK);
    };
    let (rows, tiles, morton) = (Rows::new(SIDE, SIDE), Tiles::new(SIDE, SIDE), Morton::new(SIDE, SIDE));
    panel(0, "rows", &|x, y| rows.place(x, y));
    panel(1, "tiles-4x4", &|x, y| tiles.place(x, y));
    panel(2, "morton", &|x, y| morton.place(x, y));
    sheet.finish()
}

fn walk() -> anyhow::Result<Drawing> {
    const WIDTH: u32 = 32;
    const HEIGHT: u32 = 20;
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.2, -25.8), (32.2, 20.4));
    let step = Vec2::from_angle(36.0_f32.to_radians());
    let points: Vec<Vec2> = (0..31).map(|n| at(1.5, 1.5) + step * n as f32).collect();
    let mut panel = |bottom: i32, name: &str, line: &dyn Fn(u32, u32) -> usize| {
        let mut touched: Vec<usize> = points.iter().map(|p| line(p.x as u32, p.y as u32)).collect();
        touched.sort_unstable();
        touched.dedup();
        for (x, y) in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))) {
            if let Ok(n) = touched.binary_search(&line(x, y)) {
                sheet.pixel(x as i32, bottom + y as i32, [SKY, AMBER][n % 2]);
            }
        }
        sheet.grid((0, bottom), (WIDTH as i32, bottom + HEIGHT as i32));
        for p in &points {
            sheet.dot(*p + at(0.0, bottom as f32), BLACK);
        }
        let words = format!("{name}: {} lines for {} texels", touched.len(), points.len());
        sheet.text((16.0, bottom as f32 - 1.2), &words, BLACK);
    };
    let (rows, tiles) = (Rows::new(WIDTH, HEIGHT), Tiles::new(WIDTH, HEIGHT));
    panel(0, "rows", &|x, y| rows.place(x, y) / 16);
    panel(-23, "tiles-4x4", &|x, y| tiles.place(x, y) / 16);
    sheet.finish()
}

/// The eye's way over the floor: straight on, by so much a picture.
const PER_FRAME: f32 = 0.04;

/// The view of the flight, at a picture's number.
pub(crate) fn flying_view(frame: usize) -> anyhow::Result<Mat4> {
    let eye = Vec3::new(0.31, -0.55, 3.0 - PER_FRAME * frame as f32);
    view(eye, eye + Vec3::new(0.25, -0.12, -1.0), Vec3::Y).context("it looks somewhere")
}

/// The camera of the flight.
pub(crate) fn flying(frame: usize, ratio: f32) -> anyhow::Result<Mat4> {
    Ok(perspective(45.0, ratio, 0.1, 1000.0)? * flying_view(frame)?)
}

fn flight() -> anyhow::Result<Drawing> {
    let floor = [of_floor()?];
    let rows = ["nearest", "trilinear"].map(|name| {
        let frame = |n: usize| {
            let image = by_method(name, &floor, (Vec3::Y, flying(n, 1.0)?), [400, 400])?;
            // What lies just under the horizon, twice as large.
            let part = crate::figures::picture::cut(&image, [120, 212], [110, 40]);
            Ok(part.scale(220, 80))
        };
        (0..4).map(frame).collect::<anyhow::Result<Vec<Image>>>()
    });
    let [above, below] = rows;
    rows_of(&[above?, below?])
}

/// The letter F in 8×8 texels, enlarged, looked up so many texels off.
fn letter(off: f32) -> Image {
    const ROWS: [&str; 8] =
        ["........", ".#####..", ".#......", ".####...", ".#......", ".#......", ".#......", "........"];
    let letter = painted(8, 8, |x, y| {
        let is_letter = ROWS[7 - y as usize].as_bytes()[x as usize] == b'#';
        if is_letter { Color::rgb(0xf2, 0xc1, 0x4e) } else { Color::rgb(0x1f, 0x55, 0x77) }
    });
    let level = Level::<Rows>::new(&letter, &SRGB);
    painted(HALF, HALF, |x, y| {
        let uv = (Vec2::new(x as f32, y as f32) + 0.5) / f32::from(HALF);
        let line = |x: i32| (x * 8) % i32::from(HALF) < 8;
        let color = SRGB.color(bilinear(&level, uv + off / 8.0, Wrap::Clamp));
        if line(x) || line(y) { color.mixed(Color::BLACK, 80) } else { color }
    })
}

fn slid() -> anyhow::Result<Drawing> {
    in_a_row([0.0, 0.5].map(|off| Ok(letter(off))))
}
