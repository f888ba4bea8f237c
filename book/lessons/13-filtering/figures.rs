//! Chapter 13: a texture without flicker.

use std::path::Path;

use anyhow::Context;
use clipping::mesh::indexed;
use clipping::{Cull, Mesh, SLABS};
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec2, Vec3};
use filtering::filter::{Filter, Trilinear};
use filtering::layout::{Layout, Rows};
use filtering::light::SRGB;
use filtering::mipmap::Mipmap;
use filtering::scene::fine;
use filtering::{
    Footprint, Level, METHODS, MIPMAPS, Sampler, Surface, Texture, WRAPS, Wrap, bilinear, bilinear_8, draw,
    level, trilinear,
};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use triangles::fill;

use super::sketches::{
    centres, folded, footprints, kernels, layouts, odd, of_curve, parallelogram, probes, samples, walk,
};
use crate::figures::picture::{chequered, cut, method, model, painted, paste, texture};
use crate::figures::{Drawing, Figure};
use crate::lessons::clipping::figures::{ALL, to_clip};
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
        "An ear, three times: sharp, blurred, and blurred with dark lines and spots along the borders of its parts.",
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

/// The camera of the lesson's picture.
pub(crate) const EYE: Vec3 = Vec3::new(2.0, 0.2, 3.3);
pub(crate) const CENTER: Vec3 = Vec3::new(0.3, -0.35, 0.0);

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

pub(crate) fn of_head() -> anyhow::Result<Subject> {
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
pub(crate) fn rows_of(rows: &[Vec<Image>]) -> anyhow::Result<Drawing> {
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
pub(crate) const HALF: u16 = 447;
pub(crate) const THIRD: u16 = 296;

pub(crate) const LIGHT: Vec3 = Vec3::new(0.4, 0.8, 0.8);

fn head() -> anyhow::Result<Drawing> {
    let subjects = [of_head()?, of_floor()?];
    let to_clip = to_clip(45.0, EYE, CENTER)?;
    in_a_row(["nearest", "trilinear"].map(|name| by_method(name, &subjects, (LIGHT, to_clip), [HALF, HALF])))
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

/// A model's texture with black where no triangle lies.
fn bare(model: &Model, image: &Image) -> Image {
    let mut bare = Image::new(image.width() as u16, image.height() as u16, Format::Rgb);
    let (bounds, size) = (bare.bounds(), image.size());
    for uvs in model.face_uvs() {
        fill(uvs.map(|uv| uv * size), bounds, |x, y, _| {
            bare.set(x, y, image.get(x, y).unwrap_or(Color::BLACK));
        });
    }
    bare
}

fn seams() -> anyhow::Result<Drawing> {
    let (model, texture) = (model()?, texture()?);
    let bare = Subject::new(model.clone(), bare(&model, &texture), Wrap::Clamp, of_light()?);
    let subjects = [[of_head()?], [bare]];
    let to_clip = to_clip(11.0, Vec3::new(-2.6, 0.7, -1.9), Vec3::new(-0.126, 0.157, 0.173))?;
    let light = Vec3::new(-0.8, 0.5, -0.3);
    let picture = |subject: usize, level| {
        Ok(picture(&subjects[subject], Fixed(level), (light, to_clip), [THIRD, THIRD]))
    };
    in_a_row([picture(0, 0.0), picture(0, 3.0), picture(1, 3.0)])
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
            let part = cut(&image, [120, 212], [110, 40]);
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
