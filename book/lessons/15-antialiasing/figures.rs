//! Chapter 15: without stairs.

use std::f32::consts::TAU;
use std::path::Path;

use ::triangles::barycentric::weights;
use antialiasing::cover::{fan, magnify};
use antialiasing::multisampled::{Multisampled, PerCenter};
use antialiasing::scene::World;
use antialiasing::storage::{Compressed, Samples, Storage};
use antialiasing::{Canvas, Draw, METHODS, RESOLVES, Scene, coverage, pattern, resolve};
use blending::cutout::{FERN, WALL};
use blending::scene::{Entity, View};
use blending::{Operations, Over, State, TwoShift};
use clipping::mesh::indexed;
use clipping::render::triangles;
use clipping::{Clipping, Cull};
use common::{Attributes, Color, Format, IVec2, Image, Mat4, Method, Model, Vec2, Vec3};
use filtering::filter::Trilinear;
use filtering::scene::Filterable;
use filtering::shader::Filtered;
use filtering::{MIPMAPS, Wrap};
use lighting::PointLight;
use perspective::scene::Loaded;
use shaders::Uniforms;
use shaders::lighting::Flat;
use shaders::shader::Shader;
use zbuffer::Surface;

use super::sketches::{centroid, heights, levels, patterns, row, shoelace};
use crate::figures::picture::{method, model, painted, texture};
use crate::figures::{Drawing, Figure};
use crate::lessons::filtering::figures::rows_of;
use crate::lessons::lighting::figures::{SEEN, Seen, camera};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "antialiasing-head",
        "A head before a night sky with thin rays of gold and rose behind it. In the lower corners a part of it, enlarged: on the \
         left its outline is a flight of stairs and the rays break up, on the right both are smooth.",
        head,
    ),
    Figure::new(
        "antialiasing-shares",
        "A slanted line across two rows of large pixels. Above, each pixel is black or white; below, those that the line runs \
         through have greys, the darker the less of them lies below the line.",
        shares,
    ),
    Figure::new(
        "antialiasing-shoelace",
        "A triangle that reaches out of a square to the right and above. What of it lies in the square has five corners, \
         numbered from P0 to P4; its area is seven sixteenths.",
        shoelace,
    ),
    Figure::new(
        "antialiasing-seam",
        "A square of two triangles and a wheel of twelve, grey on a bright ground, twice. On the left bright lines run along all \
         inner sides; on the right there are none.",
        seam,
    ),
    Figure::new(
        "antialiasing-heights",
        "Three pixels with their samples, and beside each a scale with a mark for each height that a sample has: four marks for \
         the grid, sixteen for the standard pattern of sixteen, four for the one of four.",
        heights,
    ),
    Figure::new(
        "antialiasing-patterns",
        "Six pixels with 1, 2, 4, 8 and 16 samples, scattered so that no two are in one row or column, and with a grid of four \
         by four.",
        patterns,
    ),
    Figure::new(
        "antialiasing-levels",
        "Greys told apart against the angle of a side. The grid has 5 next to 0 and 90 degrees, 8 at 45, and mostly 17 between \
         them; the pattern of sixteen has 17 next to the axes and from 11 to 17 elsewhere; the one of four has 5, and 3 or 4 at \
         some angles.",
        levels,
    ),
    Figure::new(
        "antialiasing-strips",
        "Six strips with the border between black and white, which rises by a pixel in sixty. The first has one step, the second \
         and third have four, the fourth eight, the fifth sixteen, and the last one is even.",
        strips,
    ),
    Figure::new(
        "antialiasing-crossing",
        "Two triangles that run through one another, three times, enlarged. On the left all borders are stairs; in the middle \
         the outlines are smooth and the line where the two meet is stairs; on the right all is smooth.",
        crossing,
    ),
    Figure::new(
        "antialiasing-touched",
        "A head, twice, coloured by counts. On the left it is blue, and lighter where one thing lies before another; on the right \
         lighter lines run along the sides of all triangles, and are orange where these are small.",
        touched,
    ),
    Figure::new(
        "antialiasing-centre",
        "A fan of thin triangles, each from orange to blue, twice, enlarged. On the left pale pixels are sprinkled along their \
         sides; on the right there are none.",
        centre,
    ),
    Figure::new(
        "antialiasing-centroid",
        "A pixel with sixteen samples and a thin triangle across its upper half. The pixel's centre is below the triangle; the \
         centroid of the covered samples is in it.",
        centroid,
    ),
    Figure::new(
        "antialiasing-resolves",
        "Two stars of thin rays, white on black above and black on white below, twice. On the left the white rays are thinner and \
         the black ones thicker than on the right.",
        resolves,
    ),
    Figure::new(
        "antialiasing-alpha",
        "A frond of a fern, four times, enlarged: with stairs, with few greys, with more of them, and smooth.",
        alpha,
    ),
    Figure::new(
        "antialiasing-whole",
        "A head, and a map of its pixels: pale where a pixel keeps one colour, dark along outlines and the sides of triangles.",
        whole,
    ),
    Figure::new(
        "antialiasing-row",
        "A row of pixels with four samples each, and a slanted strip across them. Below, for each sample, a bar from the first pixel \
         in which it is covered to the last one; two dashed lines mark what all four have in common.",
        row,
    ),
    Figure::new(
        "antialiasing-thin",
        "Five white strips, thinner and thinner, four times. By one sample the thin ones are dotted or missing, by four and by \
         sixteen they are broken later, and by their area they get fainter without a gap.",
        thin,
    ),
    Figure::new(
        "antialiasing-fan",
        "The tip of a fan of thin triangles, nine times, from single dots to smooth rays.",
        fans,
    ),
    Figure::new(
        "antialiasing-fat",
        "A wheel of thin triangles with smooth sides, and the same with thick spokes whose sides are stairs.",
        fat,
    ),
    Figure::new(
        "antialiasing-bytes",
        "A wheel of light triangles on a dark ground, and the same nearly black.",
        bytes,
    ),
];

/// Each pixel so many times as large.
fn enlarged(image: &Image, times: u16) -> Image {
    image.scale(image.width() as u16 * times, image.height() as u16 * times)
}

/// A triangle of one colour in the window.
pub(crate) fn flat(corners: [Vec2; 3], color: Color) -> Surface {
    Surface { corners: corners.map(|corner| corner.extend(0.5)), color }
}

/// A scene, drawn to a canvas.
fn drawn<C: Canvas<Stencil = ()>>(scene: &Scene, [width, height]: [u16; 2]) -> Image {
    let mut image = Image::new(width, height, Format::Rgb);
    scene.draw::<C>(&mut image);
    image
}

/// The same by a row of the lesson's table.
fn by_method(name: &str, scene: &Scene, [width, height]: [u16; 2]) -> anyhow::Result<Image> {
    let mut image = Image::new(width, height, Format::Rgb);
    (method(METHODS, name)?.picture)(scene, &mut image);
    Ok(image)
}

/// Sixteen samples a pixel, shaded once.
type Sixteen = Multisampled<16, Compressed<16>>;

/// One sample a pixel.
type One = Multisampled<1, Samples<1>>;

pub(crate) const GROUND: Color = Color::rgb(0xfb, 0xf3, 0xe2);
const GRAY: Color = Color::rgb(0x5a, 0x60, 0x68);
const NIGHT: Color = Color::rgb(0x14, 0x1b, 0x26);

fn shares() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [14, 5];
    const TIMES: u16 = 60;
    let (from, to) = (Vec2::new(0.0, 0.9), Vec2::new(14.0, 4.2));
    let along = (to - from) * 2.0;
    let below = [from - along, from + Vec2::NEG_Y * 60.0, to + along];
    let surfaces = [flat(below, Color::WHITE)];
    let scene = Scene::of(&surfaces, Color::BLACK);
    let picture = |image: &Image| {
        let image = enlarged(image, TIMES);
        let normal = (to - from).perp().normalize();
        painted(image.width() as u16, image.height() as u16, |x, y| {
            let place = (Vec2::new(x as f32, y as f32) + 0.5) / f32::from(TIMES);
            let grid = [x, y].iter().any(|n| n % i32::from(TIMES) < 2);
            let color = image.get(x, y).unwrap_or(Color::BLACK);
            match (place - from).dot(normal).abs() {
                off if off < 0.035 => Color::rgb(0xd5, 0x5e, 0x00),
                _ if grid => Color::rgb(0x7a, 0x80, 0x88),
                _ => color,
            }
        })
    };
    let rows = [by_method("none", &scene, SIZE)?, by_method("area", &scene, SIZE)?];
    rows_of(&rows.map(|image| vec![picture(&image)]))
}

/// A wheel of triangles about a place, each as wide as `share` of the way to the next one.
pub(crate) fn wheel(middle: Vec2, radius: f32, (count, share): (u32, f32), color: Color) -> Vec<Surface> {
    let spoke = |n: u32| {
        let at =
            |part: f32| middle + radius * Vec2::from_angle((n as f32 + part + 0.37) * TAU / count as f32);
        flat([middle, at(-share / 2.0), at(share / 2.0)], color)
    };
    (0..count).map(spoke).collect()
}

fn seam() -> anyhow::Result<Drawing> {
    let corner = |x: f32, y: f32| Vec2::new(x, y);
    let [a, b, c, d] = [corner(4.3, 10.4), corner(26.7, 6.2), corner(29.4, 28.6), corner(6.8, 32.1)];
    let mut surfaces = vec![flat([a, b, c], GRAY), flat([a, c, d], GRAY)];
    surfaces.extend(wheel(corner(47.0, 19.0), 15.0, (12, 1.0), GRAY));
    let scene = Scene::of(&surfaces, GROUND);
    let picture = |name| Ok(enlarged(&by_method(name, &scene, [63, 38])?, 7));
    let pictures: anyhow::Result<Vec<Image>> = ["area", "msaa-16"].map(picture).into_iter().collect();
    rows_of(&[pictures?])
}

fn strips() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [112, 5];
    let from = Vec2::new(0.0, 1.6);
    let below = [from - Vec2::new(60.0, 1.0), Vec2::new(50.0, -90.0), from + Vec2::new(180.0, 3.0)];
    let surfaces = [flat(below, Color::WHITE)];
    let scene = Scene::of(&surfaces, Color::BLACK);
    let strip = |name| Ok(vec![enlarged(&by_method(name, &scene, SIZE)?, 8)]);
    let rows: anyhow::Result<Vec<_>> =
        ["none", "ordered-16", "msaa-4", "msaa-8", "msaa-16", "area"].map(strip).into_iter().collect();
    rows_of(&rows?)
}

/// Two triangles that run through one another.
fn crossed() -> [Surface; 2] {
    // The planes of the two.
    let depths =
        [|x: f32, y: f32| 0.2 + (6.0 * x + y) / 360.0, |x: f32, y: f32| 0.9 - (6.0 * x + 2.0 * y) / 360.0];
    let surface = |corners: [(f32, f32); 3], depth: fn(f32, f32) -> f32, color| Surface {
        corners: corners.map(|(x, y)| Vec3::new(x, y, depth(x, y))),
        color,
    };
    [
        surface([(2.5, 5.2), (33.6, 3.1), (17.3, 34.2)], depths[0], Color::rgb(0xf2, 0xc1, 0x4e)),
        surface([(34.6, 30.1), (3.2, 27.4), (20.4, 1.8)], depths[1], Color::rgb(0x1f, 0x5f, 0x94)),
    ]
}

/// Triangles by samples that all have the depth of the pixel's centre.
fn of_one_depth(surfaces: &[Surface], background: Color, [width, height]: [u16; 2]) -> Image {
    let places = pattern(16);
    painted(width, height, |x, y| {
        let mut samples = [background; 16];
        let mut depths = [1.0; 16];
        for surface in surfaces {
            let corners = surface.corners.map(Vec3::truncate);
            let mask = coverage(corners, IVec2::new(x, y), places);
            let Some(weights) = weights(corners, Vec2::new(x as f32, y as f32) + 0.5) else { continue };
            let depth = weights.dot(Vec3::from_array(surface.corners.map(|corner| corner.z)));
            for s in (0..16).filter(|s| mask >> s & 1 == 1) {
                if depth < depths[s] {
                    (samples[s], depths[s]) = (surface.color, depth);
                }
            }
        }
        resolve(&samples)
    })
}

fn crossing() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [37, 36];
    let surfaces = crossed();
    let scene = Scene::of(&surfaces, NIGHT);
    let pictures = [
        by_method("none", &scene, SIZE)?,
        of_one_depth(&surfaces, NIGHT, SIZE),
        by_method("msaa-16", &scene, SIZE)?,
    ];
    rows_of(&[pictures.iter().map(|image| enlarged(image, 8)).collect()])
}

/// The head, as lesson 12 looks at it.
pub(crate) struct Head {
    model: Filterable,
    view: View,
}

impl Head {
    pub(crate) fn new() -> anyhow::Result<Self> {
        Self::seen(SEEN, PointLight::default())
    }

    fn seen(seen: Seen, light: PointLight) -> anyhow::Result<Self> {
        let loaded = Loaded::new(model()?, texture()?, textures::Wrap::Clamp);
        let mipmap = *method(MIPMAPS, "box-linear")?;
        let view = View { to_clip: camera(seen)?, eye: seen.0, light };
        Ok(Self { model: Filterable::new(loaded, mipmap, Wrap::Clamp), view })
    }

    pub(crate) fn entity(&self) -> Entity<'_> {
        Entity { model: &self.model, to_world: Mat4::IDENTITY, alpha: 1.0 }
    }

    /// What of the world a scene has.
    pub(crate) fn world<'a>(&self, entities: &'a [Entity<'a>]) -> World<'a> {
        World { entities, view: self.view, cull: Cull::Back }
    }

    /// Figures of its picture: how many times as often it is shaded with 16 samples as with one, counted and by the chapter's
    /// formula, and how many percent of its pixels keep one colour.
    #[cfg(feature = "measure")]
    pub(crate) fn counts(&self, side: u16) -> Vec<(&'static str, f64)> {
        let [one, many] = [counted::<One>(self, side), counted::<Sixteen>(self, side)]
            .map(|counts| counts.iter().sum::<usize>());
        let (mut area, mut across) = (0.0, 0.0);
        let entity = self.entity();
        let size = Vec2::splat(side.into());
        if let Some(shader) = entity.shader(&self.view, size) {
            triangles(&shader, entity.mesh(), Cull::Back, Clipping::GuardBand, size, |_, corners, _| {
                let [a, b, c] = corners.map(|corner| Vec2::new(corner.x, corner.y));
                area += f64::from((b - a).perp_dot(c - a).abs()) / 2.0;
                across += f64::from((a.max(b).max(c) - a.min(b).min(c)).element_sum());
            });
        }
        let mut canvas = Sixteen::new([side.into(); 2]);
        let mut seen = vec![false; usize::from(side).pow(2)];
        self.draw(&mut canvas, |x, y| seen[y as usize * usize::from(side) + x as usize] = true);
        let pixels = seen.iter().filter(|&&seen| seen).count();
        let whole = (0..seen.len()).filter(|&n| seen[n] && canvas.colors.colors(n).len() == 1).count();
        vec![
            ("calls", many as f64 / one as f64),
            ("calls_derived", 1.0 + across / area),
            ("one_colour_%", 100.0 * whole as f64 / pixels as f64),
        ]
    }

    /// Draws it to a canvas and calls `shaded` whenever a fragment of it is shaded.
    fn draw(&self, canvas: &mut impl Canvas<Stencil = ()>, mut shaded: impl FnMut(i32, i32)) {
        let entity = self.entity();
        let Some(shader) = entity.shader(&self.view, canvas.size()) else { return };
        triangles(
            &shader,
            entity.mesh(),
            Cull::Back,
            Clipping::GuardBand,
            canvas.size(),
            |constant, corners, varyings| {
                canvas.fill(State::OFF, corners, varyings, |fragment| {
                    shaded(fragment.x, fragment.y);
                    shader.fragment(constant, fragment)
                });
            },
        );
    }
}

/// The lesson's picture, as its program draws it.
fn head() -> anyhow::Result<Drawing> {
    const SIDE: u16 = 800;
    let position = Vec3::new(0.9, 1.6, 3.0);
    let light = PointLight { position, ambient: 0.1, diffuse: 0.9, ..PointLight::default() };
    let head = Head::seen((Vec3::new(3.3, 0.25, 1.05), Vec3::new(0.0, -0.03, 0.0), 45.0), light)?;
    let entities = [head.entity()];
    let rays = fan(Vec2::splat(SIDE.into()));
    let scene = Scene { world: Some(head.world(&entities)), ..Scene::of(&rays, Color::BLACK) };
    let mut picture = by_method("msaa-16", &scene, [SIDE; 2])?;
    let stairs = by_method("none", &scene, [SIDE; 2])?;
    magnify(|| stairs, &mut picture);
    Ok(Drawing::Pixels(picture, 1))
}

/// How often each pixel of a square picture of the head is shaded, by this canvas.
fn counted<C: Canvas<Stencil = ()>>(head: &Head, side: u16) -> Vec<usize> {
    let side = usize::from(side);
    let mut counts = vec![0; side * side];
    head.draw(&mut C::new([side; 2]), |x, y| counts[y as usize * side + x as usize] += 1);
    counts
}

fn touched() -> anyhow::Result<Drawing> {
    const SIDE: u16 = 440;
    let head = Head::new()?;
    let colors =
        [(0xf7, 0xf4, 0xee), (0x1f, 0x55, 0x77), (0x3f, 0x9a, 0xc9), (0xf2, 0xc1, 0x4e), (0xd5, 0x5e, 0x00)]
            .map(|(r, g, b)| Color::rgb(r, g, b));
    let counts = [counted::<One>(&head, SIDE), counted::<Sixteen>(&head, SIDE)];
    let pictures = counts.map(|counts| {
        painted(SIDE, SIDE, |x, y| colors[counts[y as usize * usize::from(SIDE) + x as usize].min(4)])
    });
    rows_of(&[pictures.into()])
}

/// A fan of thin triangles with common sides, each with a triangle of a texture, from orange on one side to blue on the other.
/// Beside that the texture is white.
fn textured_fan<C: Canvas<Stencil = ()>>([width, height]: [u16; 2]) -> Image {
    let mut image = Image::new(width, height, Format::Rgb);
    let mut canvas = C::new([width, height].map(usize::from));
    canvas.clear(NIGHT, false);
    let tip = Vec2::new(-9.0, -9.0);
    for n in 0..12 {
        let at = |part: f32| tip + 66.0 * Vec2::from_angle(0.08 + (n as f32 + part) * 0.11);
        let corners = [tip, at(0.0), at(1.0)].map(|corner| corner.extend(0.5).extend(1.0));
        canvas.fill(State::OFF, corners, [Vec2::ZERO, Vec2::X, Vec2::Y], |fragment| {
            let (uv, sum) = (fragment.varying, fragment.varying.element_sum());
            // On a side, rounding is no fault.
            let beside = uv.min_element() < -1e-3 || sum > 1.001;
            let (orange, blue) = (Vec3::new(236.0, 140.0, 30.0), Vec3::new(40.0, 120.0, 190.0));
            let [r, g, b] = orange.lerp(blue, uv.y / sum).to_array().map(|channel| channel as u8);
            Some(if beside { Color::WHITE } else { Color::rgb(r, g, b) })
        });
    }
    canvas.resolve(resolve, &mut image);
    image
}

fn centre() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [49, 44];
    let pictures =
        [textured_fan::<Multisampled<16, Compressed<16>, PerCenter>>(SIZE), textured_fan::<Sixteen>(SIZE)];
    rows_of(&[pictures.iter().map(|image| enlarged(image, 9)).collect()])
}

fn resolves() -> anyhow::Result<Drawing> {
    const SIDE: u16 = 120;
    let star = |color| wheel(Vec2::splat(60.3), 57.0, (36, 0.34), color);
    let [white, black] = [Color::WHITE, Color::BLACK].map(star);
    let row = |surfaces: &[Surface], background| {
        let by = |name| {
            let scene = Scene { resolve: *method(RESOLVES, name)?, ..Scene::of(surfaces, background) };
            Ok(enlarged(&drawn::<Sixteen>(&scene, [SIDE; 2]), 3))
        };
        ["encoded", "linear"].map(by).into_iter().collect::<anyhow::Result<Vec<Image>>>()
    };
    rows_of(&[row(&white, Color::BLACK)?, row(&black, Color::WHITE)?])
}

/// A frond of lesson 14, drawn to a canvas before its wall; `cut` may change a fragment's colour or leave it out.
fn frond<C: Canvas<Stencil = ()>>(
    [width, height]: [u16; 2],
    state: impl Operations<Stencil = ()>,
    alpha_to_coverage: bool,
    cut: impl Fn(Color) -> Option<Color>,
) -> anyhow::Result<Image> {
    let needs = Attributes { normals: false, uvs: true };
    let model = Model::read(Path::new(FERN[0]), needs)?;
    let mesh = indexed(&model, &[], needs);
    let mipmap = *method(MIPMAPS, "box-encoded")?;
    let texture = mipmap.texture(&Image::read(Path::new(FERN[1]))?, Wrap::Clamp);
    let size = Vec2::new(width.into(), height.into());
    let to_clip = Mat4::from_translation(Vec3::new(-0.25, -0.2, 0.0))
        * Mat4::from_rotation_z(0.3)
        * Mat4::from_scale(Vec3::new(2.0, 2.0 * size.x / size.y, 1.0));
    let uniforms = Uniforms { to_clip, light: Vec3::Z, ..Uniforms::new(&model) };
    let shader = Filtered { uniforms, texture: &texture, filter: Trilinear, lighting: Flat, size };
    let mut canvas = C::new([width, height].map(usize::from));
    canvas.clear(WALL, alpha_to_coverage);
    triangles(
        &shader,
        &mesh,
        Cull::None,
        Clipping::GuardBand,
        canvas.size(),
        |constant, corners, varyings| {
            canvas.fill(state, corners, varyings, |fragment| {
                shader.fragment(constant, fragment).and_then(&cut)
            });
        },
    );
    let mut image = Image::new(width, height, Format::Rgb);
    canvas.resolve(resolve, &mut image);
    Ok(image)
}

fn alpha() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [74, 64];
    let over = State::blending(Over::<TwoShift>::default());
    let pictures = [
        frond::<Sixteen>(SIZE, State::OFF, false, |color| (color.a >= 128).then_some(color))?,
        frond::<Multisampled<4, Compressed<4>>>(SIZE, State::OFF, true, Some)?,
        frond::<Sixteen>(SIZE, State::OFF, true, Some)?,
        frond::<Sixteen>(SIZE, over, false, Some)?,
    ];
    let [a, b, c, d] = pictures.map(|image| enlarged(&image, 6));
    rows_of(&[vec![a, b], vec![c, d]])
}

fn whole() -> anyhow::Result<Drawing> {
    const SIDE: u16 = 440;
    let head = Head::new()?;
    let mut canvas = Sixteen::new([SIDE.into(); 2]);
    canvas.clear(NIGHT, false);
    head.draw(&mut canvas, |_, _| {});
    let mut seen = Image::new(SIDE, SIDE, Format::Rgb);
    canvas.resolve(resolve, &mut seen);
    let map = painted(SIDE, SIDE, |x, y| {
        let kept = canvas.colors.colors(y as usize * usize::from(SIDE) + x as usize).len();
        if kept == 1 { Color::rgb(0xf1, 0xee, 0xe5) } else { Color::rgb(0x1f, 0x55, 0x77) }
    });
    rows_of(&[vec![seen, map]])
}

fn thin() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [72, 22];
    let mut surfaces = Vec::new();
    for (n, width) in [1.0, 0.5, 0.25, 0.125, 0.0625].into_iter().enumerate() {
        let from = Vec2::new(2.0, 18.2 - 4.0 * n as f32);
        let along = Vec2::new(68.0, 1.9);
        let across = along.perp().normalize() * width;
        let [a, b, c, d] = [from, from + along, from + along + across, from + across];
        surfaces.extend([flat([a, b, c], Color::WHITE), flat([a, c, d], Color::WHITE)]);
    }
    let scene = Scene::of(&surfaces, Color::BLACK);
    let picture = |name| Ok(enlarged(&by_method(name, &scene, SIZE)?, 6));
    let [a, b, c, d] = ["none", "msaa-4", "msaa-16", "area"].map(picture);
    let rows: [anyhow::Result<Vec<Image>>; 2] = [[a, b], [c, d]].map(|row| row.into_iter().collect());
    let [above, below] = rows;
    rows_of(&[above?, below?])
}

/// The tip of a fan of thin triangles.
fn fans() -> anyhow::Result<Drawing> {
    const SIZE: [u16; 2] = [37, 37];
    let surfaces = wheel(Vec2::new(-2.8, -3.3), 90.0, (44, 0.33), GROUND);
    let scene = Scene::of(&surfaces, NIGHT);
    let picture = |row: &Method<Draw>| Ok(enlarged(&by_method(row.name, &scene, SIZE)?, 8));
    let pictures: anyhow::Result<Vec<Image>> = METHODS.iter().map(picture).collect();
    let rows: Vec<Vec<Image>> = pictures?.chunks(3).map(<[Image]>::to_vec).collect();
    rows_of(&rows)
}

/// A wheel's samples, and what is made of them: right, and wrong.
fn wheels([background, color]: [Color; 2], wrong: impl Fn(&[Color]) -> Color) -> anyhow::Result<Drawing> {
    const SIDE: u16 = 63;
    let surfaces = wheel(Vec2::splat(31.3), 29.0, (18, 0.4), color);
    let mut canvas = Multisampled::<16, Samples<16>>::new([SIDE.into(); 2]);
    let mut right = Image::new(SIDE, SIDE, Format::Rgb);
    Scene::of(&surfaces, background).draw_to(&right, &mut canvas);
    canvas.resolve(resolve, &mut right);
    let wrong =
        painted(SIDE, SIDE, |x, y| wrong(canvas.colors.colors(y as usize * usize::from(SIDE) + x as usize)));
    rows_of(&[[right, wrong].map(|image| enlarged(&image, 7)).into()])
}

/// The mean of those samples that were covered.
fn fat() -> anyhow::Result<Drawing> {
    wheels([NIGHT, GROUND], |samples| {
        let covered: Vec<Color> = samples.iter().copied().filter(|&sample| sample != NIGHT).collect();
        if covered.is_empty() { NIGHT } else { resolve(&covered) }
    })
}

/// Sums that had no more room than a byte has.
fn bytes() -> anyhow::Result<Drawing> {
    wheels([NIGHT, GROUND], |samples| {
        let mean = |of: fn(&Color) -> u8| samples.iter().map(of).fold(0_u8, u8::wrapping_add) / 16;
        Color::rgb(mean(|color| color.r), mean(|color| color.g), mean(|color| color.b))
    })
}
