//! What is seen of a floor in perspective, still and in motion.

use camera::flags::ViewFlags;
use common::{Color, DVec3, Method, Vec2, Vec3};
use filtering::filter::{Filter, Trilinear};
use filtering::layout::Layout;
use filtering::{Footprint, LESSON, METHODS, Sampler, Texture, bilinear, draw, level, trilinear};
use verify::method;
use verify::stability::Must::Between;
use verify::stability::{Case, Row, every_method};

use crate::floor::{Eye, Floor, Picture, mean};
use crate::stability::noise;

/// Pixels of a picture's side.
const SIDE: u16 = 64;

/// Rays a pixel in each direction, at least.
const RAYS: u32 = 32;

/// The program's own eye.
const DEFAULT: Eye = Eye::new([2.0, 0.2, 3.3], [0.3, -0.35, 0.0]);

const Q: &[Row] = &[("nearest, bilinear, bilinear-8, trilinear, anisotropic", Between(-1.0, -1.0))];

/// The floor from all angles, and by how many grey levels each method is off, in the mean.
const FLOORS: &[Case<Eye>] = &[
    ("straight down", Eye::new([0.3, 3.0, 0.2], [0.31, -0.996, 0.2]), Q),
    ("60 degrees", Eye::new([0.3, 3.0, 2.3], [0.0, -0.996, 0.0]), Q),
    ("30 degrees", Eye::new([0.3, 1.3, 4.0], [0.0, -0.996, 0.0]), Q),
    ("default", DEFAULT, Q),
    ("graze", Eye::new([2.0, -0.9, 3.3], [0.3, -0.95, 0.0]), Q),
    ("roll", Eye { up: Vec3::new(1.0, 1.0, 0.0), ..DEFAULT }, Q),
    ("high", Eye::new([2.0, 20.0, 20.0], [0.3, -0.95, 0.0]), Q),
];

#[test]
fn a_floor_from_any_angle() {
    let floor = Floor::new();
    let exact: Vec<Picture> = FLOORS.iter().map(|case| floor.exact(case.1, SIDE, RAYS)).collect();
    every_method(LESSON.name, METHODS, FLOORS, |method: &Method<Sampler>, eye| {
        let exact = &exact[FLOORS.iter().position(|case| case.1 == *eye).unwrap()];
        let drawn = floor.drawn(*eye, SIDE, |surfaces, cull, image| {
            (method.run.draw)(surfaces, cull, image);
        });
        mean([&drawn, exact], |[drawn, exact]| (drawn - exact).abs())
    });
}

/// With twice as many rays a pixel in each direction the reference is the same.
#[test]
fn the_reference_has_converged() {
    let floor = Floor::new();
    for &(name, eye, _) in FLOORS {
        let [few, many, more] = [16, 32, 64].map(|rays| floor.exact(eye, SIDE, rays));
        let [far, near] = [[&few, &more], [&many, &more]].map(|pair| mean(pair, |[a, b]| (a - b).abs()));
        println!("{name}: {far:.4} {near:.4}");
    }
}

/// A level that is off by so many.
#[derive(Clone, Copy)]
struct Off(f32);

impl Filter for Off {
    type Footprint = Footprint;

    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, footprint: Footprint) -> Color {
        let base = texture.base();
        base.codes().color(trilinear(texture, uv, level(footprint, base.size()) + self.0))
    }
}

/// Bilinear in the one level that is nearest.
#[derive(Clone, Copy)]
struct Picked;

impl Filter for Picked {
    type Footprint = Footprint;

    fn color<L: Layout>(self, texture: &Texture<L>, uv: Vec2, footprint: Footprint) -> Color {
        let base = texture.base();
        let picked = (level(footprint, base.size()).round() as usize).min(texture.levels().len() - 1);
        base.codes().color(bilinear(&texture.levels()[picked], uv, texture.wrap))
    }
}

const fn row(name: &'static str, run: Sampler) -> Method<Sampler> {
    Method { name, run, promise: "", failure: "" }
}

/// A sampler of a filter.
macro_rules! sampler {
    ($filter:expr) => {
        Sampler {
            draw: |surfaces, cull, image| draw(surfaces, $filter, cull, image),
            color: |texture, uv, footprint| $filter.color(texture, uv, footprint),
        }
    };
}

/// Levels that are chosen as they should be, and otherwise.
const LEVELS: &[Method<Sampler>] = &[
    row("as-it-is", sampler!(Trilinear)),
    row("one-finer", sampler!(Off(-1.0))),
    row("one-coarser", sampler!(Off(1.0))),
    row("the-nearest", sampler!(Picked)),
];

/// Something that is measured of a filter.
type Measure = fn(&Sampler) -> f64;

const P: &[Row] = &[("as-it-is, one-finer, one-coarser, the-nearest", Between(-1.0, -1.0))];

const CHOSEN: &[Case<Measure>] = &[
    ("how far off, still", |sampler| still(sampler), P),
    ("how far off, moving", |sampler| flicker(sampler, turn), P),
    ("the largest jump where the footprint grows by a percent", jump, P),
];

#[test]
fn a_level_one_off_flickers_or_blurs_and_a_single_one_jumps() {
    every_method(LESSON.name, LEVELS, CHOSEN, |method: &Method<Sampler>, measure| measure(&method.run));
}

/// By how much the floor is off before the program's own eye.
fn still(sampler: &Sampler) -> f64 {
    let floor = Floor::new();
    let drawn =
        floor.drawn(DEFAULT, SIDE, |surfaces, cull, image| drop((sampler.draw)(surfaces, cull, image)));
    mean([&drawn, &floor.exact(DEFAULT, SIDE, RAYS)], |[drawn, exact]| (drawn - exact).abs())
}

/// The largest change of a colour as the footprint grows, by a percent each time, from 1 to 32 texels.
fn jump(sampler: &Sampler) -> f64 {
    let image = noise(256, 256);
    let texture = method(filtering::MIPMAPS, "box-linear").texture(&image, filtering::Wrap::Repeat);
    let mut largest = 0.0_f64;
    for place in 0..20 {
        let uv = Vec2::new(0.05 * place as f32 + 0.013, 0.37);
        let mut before: Option<f64> = None;
        for n in 0..350 {
            let side = 1.01_f32.powi(n) / 256.0;
            let footprint = Footprint { x: Vec2::new(side, 0.0), y: Vec2::new(0.0, side) };
            let now = f64::from((sampler.color)(&texture, uv, footprint).g);
            largest = largest.max(before.map_or(0.0, |before| (now - before).abs()));
            before = Some(now);
        }
    }
    largest
}

/// An eye in motion: where it is in picture n.
type Motion = fn(u16) -> Eye;

/// The program's turntable, half a degree at a time.
fn turn(n: u16) -> Eye {
    let Eye { from, to, .. } = DEFAULT;
    let flags = ViewFlags { eye: from.as_dvec3(), center: to.as_dvec3(), up: DVec3::Y }.turned(n, 720);
    Eye { from: flags.eye.as_vec3(), ..DEFAULT }
}

/// A flight over the floor, straight on.
fn ahead(n: u16) -> Eye {
    let by = Vec3::new(-0.02, 0.0, -0.04) * f32::from(n);
    Eye { from: DEFAULT.from + by, to: DEFAULT.to + by, up: Vec3::Y }
}

const MOTIONS: &[Case<Motion>] = &[("turn", turn, Q), ("ahead", ahead, Q)];

/// How much more, or less, the pictures of a motion change from one to the next than what is seen does, in grey levels: the
/// mean difference of the differences.
fn flicker(sampler: &Sampler, motion: Motion) -> f64 {
    let floor = Floor::new();
    let [mut drawn, mut exact] = [Vec::new(), Vec::new()];
    for eye in (0..4).map(motion) {
        drawn.push(
            floor.drawn(eye, SIDE, |surfaces, cull, image| drop((sampler.draw)(surfaces, cull, image))),
        );
        exact.push(floor.exact(eye, SIDE, RAYS));
    }
    let own = mean([&exact[0], &exact[1]], |[a, b]| (a - b).abs());
    println!("own {own}");
    let steps = drawn.windows(2).zip(exact.windows(2)).map(|(drawn, exact)| {
        mean([&drawn[0], &drawn[1], &exact[0], &exact[1]], |[a, b, c, d]| ((b - a) - (d - c)).abs())
    });
    steps.sum::<f64>() / 3.0
}

#[test]
fn nearest_flickers_and_levels_do_not() {
    every_method(LESSON.name, METHODS, MOTIONS, |method: &Method<Sampler>, &motion| {
        flicker(&method.run, motion)
    });
}
