//! Chapter 17: the same pixels, faster.

use clipping::render::{render, triangles};
use clipping::{Clipping, Cull, Mesh};
use common::{Bounds, Color, Format, IVec2, Image, Mat4, Vec2, Vec3, Vec4, Vec4Swizzles};
use filtering::Surface;
use perspective::Framebuffer;
use perspective::depth::ZF32;
use shaders::Uniforms;
use shaders::shader::{Fragment, Shader};
use shaders::target::Target;
use speed::blocks::SIDE;
use speed::eight::EachPixel;
use speed::frame::{Frame, Plan};
use speed::{METHODS, Picture};
use triangles::fill;
use zbuffer::depth_at;

use super::sketches::{amdahl, blocks, corners, groups, lanes, middles, order, roofline, schedule, tiles};
use crate::figures::picture::{method, painted};
use crate::figures::{Drawing, Figure};
use crate::lessons::clipping::figures::to_clip;
use crate::lessons::filtering::figures::{
    CENTER, EYE, HALF, LIGHT, Subject, THIRD, of_floor, of_head, rows_of,
};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new("speed-default", "A head on a chequered floor, twice, without a difference.", default),
    Figure::new(
        "speed-overdraw",
        "The head on the floor three times in shades of one colour, brighter where a pixel is drawn more often: all that is covered; \
         what passes the depth test with the head first; what passes it with the head last, where its whole outline has drawn twice.",
        overdraw,
    ),
    Figure::new(
        "speed-corners",
        "Four by four pixels and a slanted line that cuts off the lower left one. At each of the four corner pixels stands the value of the \
         edge function: −3, 9, 12 and 24.",
        corners,
    ),
    Figure::new(
        "speed-blocks",
        "A large triangle over a grid of blocks. Those within are blue, those that a side passes through amber with the covered \
         pixels darker, and those outside are grey.",
        blocks,
    ),
    Figure::new(
        "speed-lanes",
        "Rows of eight pixels over a large triangle and over a small one. In the large one most rows are full; in the small one \
         one to three of eight are used.",
        lanes,
    ),
    Figure::new(
        "speed-order",
        "Two trees of additions of the same four numbers, one leaning and one balanced, with different results at their ends.",
        order,
    ),
    Figure::new(
        "speed-tiles",
        "A grid of thirteen by thirteen tiles over the outline of a head and a floor, in each the number of triangles that reach into it: \
         a few on the floor, hundreds about the eyes.",
        tiles,
    ),
    Figure::new(
        "speed-hierarchy",
        "The depths of a head on a floor in grey, twice: pixel by pixel, and as squares of eight by eight pixels, each as dark as its \
         farthest pixel.",
        hierarchy,
    ),
    Figure::new(
        "speed-bound",
        "Two planes that cut each other along a slanted line, in three pictures: the line straight; the line in steps of eight pixels; and \
         the triangles between the two.",
        bound,
    ),
    Figure::new(
        "speed-visibility",
        "A head on a floor in random colours, one for each triangle, and the same picture textured and lit.",
        visibility,
    ),
    Figure::new(
        "speed-groups",
        "Six rows of eight pixels, each with the number of the triangle that is seen in it, and beside each row how many triangles it has: \
         several.",
        groups,
    ),
    Figure::new(
        "speed-schedule",
        "Two bars each for two threads over time. Where each thread has one half of the picture, one of them ends much later; where each takes \
         the next tile when it is free both end together.",
        schedule,
    ),
    Figure::new(
        "speed-amdahl",
        "How many times as fast, against threads, four curves: the straight line of all work shared out, and three that bend, the lowest to \
         stay under five.",
        amdahl,
    ),
    Figure::new(
        "speed-middles",
        "A triangle that is covered exactly, and the same with whole blocks filled or missing along its sides.",
        middles,
    ),
    Figure::new(
        "speed-roofline",
        "Additions and multiplications a second against those a byte, both logarithmic: a roof that rises and then is level, and the methods \
         as points below it.",
        roofline,
    ),
];

/// The side of the lesson's default picture.
pub(super) const SIZE: u16 = 800;

/// The lesson's subjects: the head, and the floor under it.
pub(super) fn subjects() -> anyhow::Result<[Subject; 2]> {
    Ok([of_head()?, of_floor()?])
}

/// The lesson's default camera.
pub(super) fn camera() -> anyhow::Result<Mat4> {
    to_clip(45.0, EYE, CENTER)
}

/// The lesson's default picture, by one of its methods.
fn by_method(name: &str, side: u16) -> anyhow::Result<Image> {
    let (subjects, to_clip) = (subjects()?, camera()?);
    let surfaces: Vec<Surface> =
        subjects.iter().map(|subject| subject.surface(LIGHT.normalize(), to_clip)).collect();
    let trilinear = filtering::METHODS.iter().position(|row| row.name == "trilinear").unwrap_or(0);
    let mut image = Image::new(side, side, Format::Rgb);
    let mut draw = method(METHODS, name)?.drawer([side.into(); 2], trilinear, 2);
    draw(&Picture { surfaces: &surfaces, cull: Cull::Back }, &mut image);
    Ok(image)
}

fn default() -> anyhow::Result<Drawing> {
    let [simple, threads] = ["simple", "threads"].map(|name| by_method(name, HALF));
    rows_of(&[vec![simple?, threads?]])
}

/// What draws each triangle in a colour of its own, or by its number.
pub(super) struct Numbered<'a> {
    uniforms: Uniforms<'a>,
    /// The number of the first triangle.
    first: usize,
}

impl Shader for Numbered<'_> {
    type Constant = usize;
    type Varying = ();
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        self.uniforms.to_clip * self.uniforms.model.positions()[vertex].extend(1.0)
    }

    fn triangle(&self, face: usize) -> Option<usize> {
        Some(self.first + face)
    }

    fn corner(&self, _: usize, _: usize) {}

    fn fragment(&self, number: usize, _: Fragment<()>) -> Option<Color> {
        Some(Color::random(number as u64))
    }
}

/// Calls `draw` with the shader and the mesh of each subject.
pub(super) fn each_subject(mut draw: impl FnMut(&Numbered, &Mesh)) -> anyhow::Result<()> {
    let (subjects, to_clip) = (subjects()?, camera()?);
    let mut first = 1;
    for subject in &subjects {
        let surface = subject.surface(LIGHT.normalize(), to_clip);
        let shader = Numbered { uniforms: surface.uniforms, first };
        first += surface.mesh.faces.len();
        draw(&shader, surface.mesh);
    }
    Ok(())
}

/// The triangle that is seen at each pixel of the default picture, as its colour.
pub(super) fn seen(side: u16) -> anyhow::Result<Image> {
    let plan = Plan { tile: Some(64), hierarchical: true, deferred: true, threads: 1 };
    let mut frame = Frame::new([side.into(); 2], plan);
    frame.clear(Color::BLACK);
    each_subject(|&Numbered { uniforms, first }, mesh| {
        let shader = EachPixel { shader: Numbered { uniforms, first }, keeps_all: true };
        frame.draw(&shader, mesh, Cull::Back);
    })?;
    let mut image = Image::new(side, side, Format::Rgb);
    frame.copy_to(&mut image);
    Ok(image)
}

fn visibility() -> anyhow::Result<Drawing> {
    rows_of(&[vec![seen(HALF)?, by_method("deferred", HALF)?]])
}

/// The triangles of the default picture as they come to be filled: their corners in the window.
pub(super) fn windows(side: u16) -> anyhow::Result<Vec<[Vec4; 3]>> {
    let mut all = Vec::new();
    each_subject(|shader, mesh| {
        triangles(
            shader,
            mesh,
            Cull::Back,
            Clipping::GuardBand,
            Vec2::splat(side.into()),
            |_, corners, _| {
                all.push(corners);
            },
        );
    })?;
    Ok(all)
}

/// How often each pixel was written to.
struct Counting {
    side: i32,
    /// Whether what is farther than what is there counts, too.
    all: bool,
    depths: Vec<f32>,
    times: Vec<u16>,
}

impl Counting {
    fn new(side: u16, all: bool) -> Self {
        let pixels = usize::from(side) * usize::from(side);
        Self { side: side.into(), all, depths: vec![1.0; pixels], times: vec![0; pixels] }
    }

    fn at(&self, x: i32, y: i32) -> usize {
        (y * self.side + x) as usize
    }

    /// Brighter where it is more.
    fn picture(&self) -> Image {
        painted(self.side as u16, self.side as u16, |x, y| {
            let t = f32::from(self.times[self.at(x, y)]);
            let shade = |most: f32| (255.0 * most * (1.0 - 0.6_f32.powf(t))) as u8;
            Color::rgb(shade(1.0), shade(0.72), shade(0.3))
        })
    }
}

impl Target<Color> for Counting {
    fn bounds(&self) -> Bounds {
        Bounds { min: IVec2::ZERO, max: IVec2::splat(self.side - 1) }
    }

    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        self.all || depth < self.depths[self.at(x, y)]
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, _: Color) {
        let at = self.at(x, y);
        self.depths[at] = depth;
        self.times[at] += 1;
    }

    fn clear(&mut self) {
        self.depths.fill(1.0);
        self.times.fill(0);
    }
}

fn overdraw() -> anyhow::Result<Drawing> {
    let draw = |all: bool, reversed: bool| -> anyhow::Result<Image> {
        let (mut subjects, to_clip) = (subjects()?, camera()?);
        if reversed {
            subjects.reverse();
        }
        let mut target = Counting::new(THIRD, all);
        for subject in &subjects {
            let surface = subject.surface(LIGHT.normalize(), to_clip);
            let shader = Numbered { uniforms: surface.uniforms, first: 0 };
            let cull = if all { Cull::None } else { Cull::Back };
            render(&shader, surface.mesh, cull, Clipping::GuardBand, &mut target);
        }
        Ok(target.picture())
    };
    rows_of(&[vec![draw(true, false)?, draw(false, false)?, draw(false, true)?]])
}

fn hierarchy() -> anyhow::Result<Drawing> {
    let mut image = Image::new(HALF, HALF, Format::Rgb);
    let mut target = Framebuffer::new(&mut image, ZF32);
    each_subject(|shader, mesh| {
        render(shader, mesh, Cull::Back, Clipping::GuardBand, &mut target);
    })?;
    let depths = target.depths;
    // Of depths near 1, what is left to 1 tells more: it is about in proportion to 1/Z.
    let grey = |depth: f32| Color::gray((18.0 * (1.0 - depth)).clamp(0.0, 1.0));
    let pixels = painted(HALF, HALF, |x, y| grey(depths.get(x, y)));
    let farthest = painted(HALF, HALF, |x, y| {
        let corner = IVec2::new(x, y) / SIDE * SIDE;
        let last = (corner + SIDE).min(IVec2::splat(HALF.into()));
        let block = (corner.y..last.y).flat_map(|y| (corner.x..last.x).map(move |x| (x, y)));
        grey(block.map(|(x, y)| depths.get(x, y)).fold(0.0, f32::max))
    });
    rows_of(&[vec![pixels, farthest]])
}

/// Two triangles that cover a square picture: a level one, and a steep one that cuts it.
const CROSSING: [[f32; 3]; 2] = [[0.5; 3], [0.1, 0.9, 0.6]];

/// In which pixels the steep triangle is seen, drawn after the level one: tested pixel by pixel, or rejected before in blocks in whose
/// middle it is no nearer than the farthest that is there.
pub(super) fn crossing(side: u16, by_middles: bool) -> Vec<bool> {
    let wide = f32::from(side);
    let corners = [(-0.25, -0.25), (2.5, -0.25), (-0.25, 2.5)].map(|(x, y)| Vec2::new(x, y) * wide);
    let bounds = Bounds { min: IVec2::ZERO, max: IVec2::splat(i32::from(side) - 1) };
    let at = |x: i32, y: i32| y as usize * usize::from(side) + x as usize;
    let [level, steep] = CROSSING.map(|z| {
        let mut depths = vec![1.0_f32; usize::from(side) * usize::from(side)];
        fill(corners, bounds, |x, y, weights| depths[at(x, y)] = depth_at(Vec3::from(z), weights));
        depths
    });
    let pixel = |(x, y): (i32, i32)| {
        let middle = (IVec2::new(x, y) / SIDE * SIDE + SIDE / 2).min(bounds.max);
        let rejected = by_middles && steep[at(middle.x, middle.y)] >= level[at(middle.x, middle.y)];
        !rejected && steep[at(x, y)] < level[at(x, y)]
    };
    (0..i32::from(side)).flat_map(|y| (0..i32::from(side)).map(move |x| (x, y))).map(pixel).collect()
}

fn bound() -> anyhow::Result<Drawing> {
    const PIXELS: u16 = 148;
    let [right, wrong] = [false, true].map(|by_middles| crossing(PIXELS, by_middles));
    let at = |x: i32, y: i32| y as usize * usize::from(PIXELS) + x as usize;
    let (one, other) = (Color::rgb(0x1f, 0x55, 0x77), Color::rgb(0xf2, 0xc1, 0x4e));
    let picture = |seen: &[bool]| painted(PIXELS, PIXELS, |x, y| if seen[at(x, y)] { other } else { one });
    let lost = painted(PIXELS, PIXELS, |x, y| {
        if right[at(x, y)] == wrong[at(x, y)] { Color::gray(0.93) } else { Color::rgb(0xd5, 0x5e, 0x00) }
    });
    rows_of(&[[picture(&right), picture(&wrong), lost].map(|image| image.scale(THIRD, THIRD)).to_vec()])
}

/// The corners of a triangle on its plane of the picture.
pub(super) fn flat(corners: [Vec4; 3]) -> [Vec2; 3] {
    corners.map(Vec4::xy)
}
