//! Chapter 14: what happens to a fragment.

use blending::blend::BlendStage;
use blending::{
    Blend, Compare, DepthTest, Equation, Factor, Formula, Framebuffer, Late, Less, METHODS, Over, State,
    StencilOp, StencilTest, TwoShift, WriteMask, plain,
};
use clipping::mesh::indexed;
use clipping::{Clipping, Cull, render};
use common::{Color, Image, Vec2, Vec3, Vec4};
use perspective::division::Exact;
use perspective::draw_triangle;
use perspective::interpolation::PerPixel;
use perspective::lighting::Clamped;
use perspective::scene::Loaded;
use shaders::Lit;
use shaders::shader::{Fragment, Shader};
use shaders::source::White;
use shaders::target::Target;
use textures::Wrap;
use zbuffer::Surface;

use super::scenes::{crates, fading, mirrored, outlined, outputs};
use super::seen_through::{crossing, fringe, peeled, rosette, seam};
use super::sketches::{areas, layers, stages};
use crate::figures::picture::{chequered, method, model, painted, texture};
use crate::figures::{Drawing, Figure};
use crate::lessons::clipping::figures::{ALL, to_clip};
use crate::lessons::filtering::figures::{HALF, THIRD, rows_of};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "blending-crates",
        "A large wooden crate with a smaller one before it, twice. On the left the small one hides what is behind it; on the right \
         the boards of the large one are seen through it.",
        crates,
    ),
    Figure::new(
        "blending-outline",
        "The shape of a head in one light colour on a dark ground, and the head in a warm glow that fades away from it.",
        outlined,
    ),
    Figure::new(
        "blending-mirror",
        "The light shape of an upright pane on a dark ground; within this shape a head and a floor, seen from their other side; and \
         a head before a mirror in a wooden frame that shows it.",
        mirrored,
    ),
    Figure::new(
        "blending-outputs",
        "Four pictures of a head on a floor: its colours without any light, its normals as colours, its distances as greys that \
         darken, and the head lit in a dark fog.",
        outputs,
    ),
    Figure::new(
        "blending-stages",
        "A column of boxes with arrows from one to the next: fragment, scissor test, stencil test, depth test, blending, write \
         mask, pixel. From each of the tests an arrow leads out, for what fails. Stencil and depths can be changed by their tests.",
        stages,
    ),
    Figure::new(
        "blending-early",
        "Three overlapping leaves; how often each pixel failed the depth test if the tests come after the shader, which is where \
         one leaf hides another; and if they come before it, where rectangles around the hidden leaves show as well.",
        early,
    ),
    Figure::new(
        "blending-areas",
        "A square in four parts. What lies left of an upright line is covered by the source, what lies below a level line by the \
         destination: both, the source alone, the destination alone, and neither.",
        areas,
    ),
    Figure::new(
        "blending-operators",
        "A blue and an orange disc with soft borders over squares of grey, eight times: the orange one in front; the blue one in \
         front; only the part of the orange one on the blue one; only its other part; the orange one as if stuck on the blue one; \
         both without what they share; both added, bright in the middle; and only the middle, dark.",
        operators,
    ),
    Figure::new(
        "blending-anaglyph",
        "A grey head with a red and a cyan outline beside each other, as for coloured glasses.",
        anaglyph,
    ),
    Figure::new(
        "blending-products",
        "Two squares. In the left one nearly all is blue, in stripes along curves; in the right one are thin curves of blue in its \
         left half and of orange in its right half.",
        products,
    ),
    Figure::new(
        "blending-layers",
        "A pixel's code against the number of layers of white with the least alpha. Over white, exact and two-shift stay at 255 \
         and shift-8 falls to 127. Over black the exact number rises to 250, two-shift only to 128, and shift-8 stays at 0.",
        layers,
    ),
    Figure::new(
        "blending-fading",
        "A large wooden crate with a smaller one before it, twice. On the left the small one has a solid top, and its sides fade \
         away downwards; on the right they do so too, and the large one is seen even through the top.",
        fading,
    ),
    Figure::new(
        "blending-crossing",
        "Three triangles in a circle and two that cross, each in five pictures. In the first two whole triangles lie on one \
         another; in the next two each triangle is in front where it is nearer; in the last one colours are mixed everywhere.",
        crossing,
    ),
    Figure::new(
        "blending-peeled",
        "A blue knot of glass in six pictures: five layers, from the farthest, which is whole, to one of a few pieces, and all of \
         them over one another.",
        peeled,
    ),
    Figure::new(
        "blending-rosette",
        "A rosette of six coloured panes around a round one, three times. In the middle picture each pane lies over the next one, all \
         around; in the left one an order shows that is not there; in the right one where panes overlap both colours are mixed.",
        rosette,
    ),
    Figure::new(
        "blending-seam",
        "Four strips. Above, from green to red through a dark olive, and from black to white, long dark. Below, from green to red \
         through a bright yellow, and from black to white, sooner bright.",
        seam,
    ),
    Figure::new(
        "blending-fringe",
        "A piece of a fern, much enlarged, four times. In the upper left picture a dark line lies around it, in the lower left one a \
         faint one; in the right ones there is none.",
        fringe,
    ),
    Figure::new(
        "blending-late",
        "A blue pane before a wooden crate, three times: the crate is seen through the pane; the crate lies over the pane; the part \
         of the crate behind the pane is missing.",
        late,
    ),
];

/// The ground of pictures.
pub(super) const PAPER: Color = Color::rgb(0xfd, 0xfc, 0xf9);
const BLUE: Color = Color::rgb(0x00, 0x72, 0xb2);
const ORANGE: Color = Color::rgb(0xd5, 0x5e, 0x00);

/// An empty picture of one colour.
pub(super) fn filled(width: u16, height: u16, color: Color) -> Image {
    painted(width, height, |_, _| color)
}

/// All products of two bytes: where the result is not the nearest whole number.
fn products() -> anyhow::Result<Drawing> {
    let picture = |name: &str| -> anyhow::Result<Image> {
        let mix = method(METHODS, name)?.mix;
        Ok(painted(256, 256, |x, y| {
            let nearest = (2 * x * y + 255) / 510;
            match i32::from(mix(y as u8, 0, x as u8)) - nearest {
                0 => PAPER,
                ..=-2 => Color::rgb(0x00, 0x2c, 0x55),
                -1 => Color::rgb(0x63, 0xb3, 0xec),
                _ => ORANGE,
            }
        }))
    };
    rows_of(&[vec![picture("shift-8")?, picture("div-256")?]])
}

/// A disc with a soft border, premultiplied.
fn disc(color: Color, middle: Vec2, radius: f32, at: Vec2) -> Color {
    let inside = ((radius - at.distance(middle)) / 24.0 + 0.5).clamp(0.0, 1.0);
    let faded = |channel: u8| (f32::from(channel) * inside + 0.5) as u8;
    Color { r: faded(color.r), g: faded(color.g), b: faded(color.b), a: faded(255) }
}

/// Two discs, combined by pairs of factors.
fn operators() -> anyhow::Result<Drawing> {
    use Factor::{DstAlpha, DstColor, One, OneMinusDstAlpha, OneMinusSrcAlpha, Zero};
    const SIDE: u16 = 220;
    let over = (One, OneMinusSrcAlpha);
    let by = |(source, destination): (Factor, Factor)| {
        let formula = Formula { equation: Equation::FuncAdd, source, destination };
        Blend { color: formula, alpha: formula, ..Blend::OVER }
    };
    let ground = chequered(11, 11, [Color::gray(0.86), Color::gray(0.99)]).scale(SIDE, SIDE);
    let picture = |factors| {
        painted(SIDE, SIDE, |x, y| {
            let at = Vec2::new(x as f32, y as f32) + 0.5;
            let destination = disc(BLUE, Vec2::new(86.0, 96.0), 62.0, at);
            let source = disc(ORANGE, Vec2::new(134.0, 124.0), 62.0, at);
            let both = by(factors).color(source, destination);
            by(over).color(both, ground.get(x, y).unwrap_or(Color::WHITE))
        })
    };
    let above = [over, (OneMinusDstAlpha, One), (DstAlpha, Zero), (OneMinusDstAlpha, Zero)];
    let below =
        [(DstAlpha, OneMinusSrcAlpha), (OneMinusDstAlpha, OneMinusSrcAlpha), (One, One), (DstColor, Zero)];
    rows_of(&[above.map(picture).to_vec(), below.map(picture).to_vec()])
}

/// A smooth grey head for the left eye in red, and for the right one in green and blue.
fn anaglyph() -> anyhow::Result<Drawing> {
    const LARGE: u16 = 3 * HALF;
    let loaded = Loaded::new(model()?, texture()?, Wrap::Clamp);
    let mesh = indexed(&loaded.model, &loaded.normals, ALL);
    let mut image = filled(LARGE, LARGE, Color::gray(0.5));
    let all = WriteMask::ALL;
    let masks = [WriteMask { g: false, b: false, ..all }, WriteMask { r: false, ..all }];
    for (mask, x) in masks.into_iter().zip([-0.09, 0.09]) {
        let to_clip = to_clip(36.0, Vec3::new(x, 0.1, 3.2), Vec3::new(0.0, 0.1, 0.4))?;
        let light = Vec3::new(-0.5, 0.5, 0.8).normalize();
        let shader = Lit::new(loaded.uniforms(light, to_clip), White, Clamped);
        // A new target has new depths.
        let mut target = Framebuffer::new(&mut image, State { mask, ..masked() });
        render(&shader, &mesh, Cull::Back, Clipping::GuardBand, &mut target);
    }
    Ok(Drawing::Pixels(image.scale(HALF, HALF), 1))
}

/// A state with a write mask.
fn masked() -> State<(), (), Less, (), WriteMask> {
    State { scissor: (), stencil: (), depth: Less, blend: (), mask: WriteMask::ALL }
}

/// A rectangle with a leaf in it; what is not leaf is dropped.
struct Leaf {
    color: Color,
}

impl Shader for Leaf {
    type Constant = ();
    type Varying = Vec2;
    type Output = Color;

    fn position(&self, _: usize) -> Vec4 {
        unreachable!("its corners are in the window")
    }

    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    fn corner(&self, _: usize, _: usize) -> Vec2 {
        unreachable!("its corners are in the window")
    }

    fn fragment(&self, (): (), fragment: Fragment<Vec2>) -> Option<Color> {
        let Vec2 { x: u, y: v } = fragment.varying;
        let half = 0.42 * (std::f32::consts::PI * u).sin().max(0.0).powf(0.75);
        let away = (v - 0.5).abs();
        (away < half).then(|| self.color.shaded(if away < 0.015 { 0.55 } else { 1.0 - 0.5 * away }))
    }
}

/// Leaves: where, how far turned, how deep, and their colour. The nearest ones come first.
const LEAVES: [(Vec2, f32, f32, Color); 3] = [
    (Vec2::new(150.0, 120.0), 0.5, 0.2, Color::rgb(0x4c, 0x9a, 0x2a)),
    (Vec2::new(120.0, 165.0), -0.7, 0.4, Color::rgb(0x7f, 0xb8, 0x3f)),
    (Vec2::new(180.0, 170.0), 1.4, 0.6, Color::rgb(0xd9, 0x8e, 0x2b)),
];

/// Draws the leaves.
fn draw_leaves(target: &mut impl Target<Color>) {
    for (middle, turn, depth, color) in LEAVES {
        let along = Vec2::from_angle(turn) * 125.0;
        let across = along.perp() * 0.62;
        let corner = |u: f32, v: f32| {
            let at = middle + along * (2.0 * u - 1.0) + across * (2.0 * v - 1.0);
            (at.extend(depth).extend(1.0), Vec2::new(u, v))
        };
        for corners in [[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)], [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0)]] {
            let corners = corners.map(|(u, v)| corner(u, v));
            let shader = Leaf { color };
            draw_triangle(
                &shader,
                (),
                corners.map(|corner| corner.0),
                corners.map(|corner| corner.1),
                PerPixel(Exact),
                target,
            );
        }
    }
}

/// Leaves, and how many fragments each pixel counted that failed the depth test, after shading and before it.
fn early() -> anyhow::Result<Drawing> {
    let counting = StencilTest { depth_fail: StencilOp::Incr, ..StencilTest::ALWAYS };
    let state = State { scissor: (), stencil: counting, depth: Less, blend: (), mask: () };
    let counts = |stencils: &[u8]| {
        painted(THIRD, THIRD, |x, y| {
            let count = stencils[y as usize * usize::from(THIRD) + x as usize];
            [PAPER, Color::rgb(0x9f, 0xd3, 0xf2), BLUE, Color::rgb(0x00, 0x2c, 0x55)]
                [usize::from(count).min(3)]
        })
    };
    let mut picture = filled(THIRD, THIRD, PAPER);
    let mut late = Late(Framebuffer::new(&mut picture, state));
    draw_leaves(&mut late);
    let after = counts(&late.0.stencils);
    let mut again = filled(THIRD, THIRD, PAPER);
    let mut early = Framebuffer::new(&mut again, state);
    draw_leaves(&mut early);
    let before = counts(&early.stencils);
    anyhow::ensure!(picture == again, "both orders draw the same leaves");
    rows_of(&[vec![picture, after, before]])
}

/// Two triangles that fill a rectangle, its depth the same everywhere.
fn quad(low: Vec2, high: Vec2, depth: f32, color: Color) -> [Surface; 2] {
    let corner = |x: f32, y: f32| Vec3::new(x, y, depth);
    let corners =
        [corner(low.x, low.y), corner(high.x, low.y), corner(high.x, high.y), corner(low.x, high.y)];
    [[0, 1, 2], [0, 2, 3]].map(|[a, b, c]| Surface { corners: [corners[a], corners[b], corners[c]], color })
}

/// A pane before a crate, in three orders.
fn late() -> anyhow::Result<Drawing> {
    const HEIGHT: u16 = 240;
    let size = Vec2::new(THIRD.into(), HEIGHT.into());
    let wood =
        quad(size * Vec2::new(0.36, 0.2), size * Vec2::new(0.86, 0.82), 0.6, Color::rgb(0xb5, 0x7a, 0x3c));
    let glass = Color { a: 110, ..BLUE };
    let pane = quad(size * Vec2::new(0.12, 0.1), size * Vec2::new(0.62, 0.64), 0.3, glass);
    let state = |write| State {
        scissor: (),
        stencil: (),
        depth: DepthTest { function: Compare::Less, write },
        blend: Over(TwoShift),
        mask: (),
    };
    let picture = |passes: [(&[Surface], bool); 2]| {
        let mut image = filled(THIRD, HEIGHT, PAPER);
        let mut target = Framebuffer::new(&mut image, state(true));
        for (surfaces, write) in passes {
            target = target.under(state(write));
            plain::draw(surfaces, &mut target);
        }
        image
    };
    let passes: [[(&[Surface], bool); 2]; 3] =
        [[(&wood, true), (&pane, false)], [(&pane, false), (&wood, true)], [(&pane, true), (&wood, true)]];
    rows_of(&[passes.map(picture).to_vec()])
}
