//! The same drawn by lesson 11's loop, which is lesson 13's, and by a method of this lesson.

use clipping::render::triangles;
use clipping::{Clipping, Counts, Cull, Mesh, render};
use common::{Color, Format, Image};
use fearless_simd::Level;
use perspective::depth::ZF32;
use perspective::{Framebuffer, draw_triangle};
use speed::Plan;
use speed::blocks::Blocks;
use speed::frame::{Frame, Shared};

/// Who draws.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Way {
    /// Lesson 11's loop.
    Simple,
    /// The same with blocks instead of rows.
    Blocks,
    /// A frame, with the instructions of that level.
    Tiled(Plan, Level),
}

impl Way {
    /// A frame with the best instructions that there are.
    pub(crate) fn tiled(plan: Plan) -> Self {
        Self::Tiled(plan, Level::new())
    }
}

/// The levels of instructions that this machine has, from the least one on: those that the course is compiled for.
pub(crate) fn levels() -> Vec<Level> {
    #[cfg(target_arch = "x86_64")]
    use fearless_simd::Simd;
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let others = [best.as_avx2().map(Simd::level), best.as_avx512().map(Simd::level)];
    #[cfg(not(target_arch = "x86_64"))]
    let others = [Some(best)];
    std::iter::once(Level::baseline()).chain(others.into_iter().flatten()).collect()
}

/// What is drawn to.
pub(crate) enum Canvas<'a> {
    Simple(Framebuffer<'a, ZF32>),
    Blocks(Framebuffer<'a, ZF32>),
    Frame(&'a mut Frame),
}

impl Canvas<'_> {
    /// Draws a mesh over what is there.
    pub(crate) fn draw<W: Shared>(&mut self, shader: &W, mesh: &Mesh, cull: Cull) -> Counts {
        match self {
            Self::Simple(target) => render(shader, mesh, cull, Clipping::GuardBand, target),
            Self::Blocks(target) => {
                let size = target.image.size();
                triangles(shader, mesh, cull, Clipping::GuardBand, size, |constant, corners, varyings| {
                    draw_triangle(shader, constant, corners, varyings, Blocks, target);
                })
            }
            Self::Frame(frame) => frame.draw(shader, mesh, cull),
        }
    }
}

/// A frame for pictures of that size.
pub(crate) fn frame(size: [u16; 2], plan: Plan) -> Frame {
    Frame::new(size.map(i32::from), plan)
}

/// What comes of a drawing on that background, and what became of its triangles.
pub(crate) fn drawn(
    way: Way,
    size: [u16; 2],
    background: Color,
    draw: impl FnOnce(&mut Canvas) -> Counts,
) -> (Image, Counts) {
    if let Way::Tiled(plan, level) = way {
        return again(&mut frame(size, plan).at_level(level), size, background, draw);
    }
    let mut image = Image::new(size[0], size[1], Format::Rgba);
    image.set_all(|_| background);
    let target = Framebuffer::new(&mut image, ZF32);
    let mut canvas = if matches!(way, Way::Simple) { Canvas::Simple(target) } else { Canvas::Blocks(target) };
    let counts = draw(&mut canvas);
    (image, counts)
}

/// The same by a frame in which other pictures may have been drawn before.
pub(crate) fn again(
    frame: &mut Frame,
    [width, height]: [u16; 2],
    background: Color,
    draw: impl FnOnce(&mut Canvas) -> Counts,
) -> (Image, Counts) {
    // Each pixel must be written.
    let mut image = Image::new(width, height, Format::Rgba);
    image.set_all(|pixel| Color::random(pixel as u64));
    frame.clear(background);
    let counts = draw(&mut Canvas::Frame(frame));
    frame.copy_to(&mut image);
    (image, counts)
}

/// How many pixels have another colour, and the first of them, with what it should be and is.
pub(crate) fn differing(expected: &Image, got: &Image) -> Option<String> {
    assert_eq!(expected.size(), got.size());
    let mut wrong = expected.pixels().zip(got.pixels()).filter(|(expected, got)| expected.2 != got.2);
    let ((x, y, expected), (.., got)) = wrong.next()?;
    Some(format!("{} pixels differ, ({x}, {y}) first: {got:?}, not {expected:?}", 1 + wrong.count()))
}
