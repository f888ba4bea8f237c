//! What is seen of a floor in perspective, still and in motion.

use std::sync::LazyLock;

use camera::flags::ViewFlags;
use common::{Color, DVec3, Method, Vec2, Vec3};
use filtering::filter::{Filter, Trilinear};
use filtering::layout::Layout;
use filtering::{Footprint, LESSON, METHODS, Sampler, Texture, bilinear, draw, level, trilinear};
use verify::method;
use verify::stability::Must::Between;
use verify::stability::{Case, every_method};

use crate::floor::{Eye, Floor, Picture, mean};
use crate::stability::{noise, off, square};

/// Pixels of a picture's side.
const SIDE: u16 = 64;

/// Rays a pixel in each direction, at least.
const RAYS: u32 = 32;

/// An eye from which a field of the floor is smaller than a pixel.
const HIGH: Eye = Eye::new([2.0, 20.0, 20.0], [0.3, -0.95, 0.0]);

/// The program's own eye.
const DEFAULT: Eye = Eye::new([2.0, 0.2, 3.3], [0.3, -0.35, 0.0]);

/// The floor from all angles, and by how many grey levels each method is off, in the mean.
const FLOORS: &[Case<Eye>] = &[
    (
        "straight down",
        Eye::new([0.3, 3.0, 0.2], [0.31, -0.996, 0.2]),
        &[
            ("nearest", Between(6.88, 7.46)),
            ("bilinear, bilinear-8", Between(6.44, 6.99)),
            ("trilinear, anisotropic", Between(0.764, 0.83)),
        ],
    ),
    (
        "60 degrees down",
        Eye::new([0.3, 3.0, 2.3], [0.0, -0.996, 0.0]),
        &[
            ("nearest", Between(10.0, 10.9)),
            ("bilinear, bilinear-8", Between(9.46, 10.3)),
            ("trilinear", Between(1.58, 1.73)),
            ("anisotropic", Between(1.17, 1.28)),
        ],
    ),
    (
        "30 degrees down",
        Eye::new([0.3, 1.3, 4.0], [0.0, -0.996, 0.0]),
        &[
            ("nearest, bilinear, bilinear-8", Between(20.8, 23.3)),
            ("trilinear", Between(6.23, 6.76)),
            ("anisotropic", Between(0.955, 1.04)),
        ],
    ),
    (
        "to the horizon: the program's own eye",
        DEFAULT,
        &[
            ("nearest, bilinear, bilinear-8", Between(28.1, 31.1)),
            ("trilinear", Between(8.85, 9.6)),
            ("anisotropic", Between(0.896, 0.972)),
        ],
    ),
    (
        "a tenth above the floor",
        Eye::new([2.0, -0.9, 3.3], [0.3, -0.95, 0.0]),
        &[
            ("nearest", Between(9.99, 10.9)),
            ("bilinear, bilinear-8", Between(9.53, 10.4)),
            ("trilinear", Between(3.61, 3.92)),
            ("anisotropic", Between(0.657, 0.713)),
        ],
    ),
    (
        "with the head tilted",
        Eye { up: Vec3::new(1.0, 1.0, 0.0), ..DEFAULT },
        &[
            ("nearest, bilinear, bilinear-8", Between(30.7, 33.8)),
            ("trilinear", Between(6.62, 7.18)),
            ("anisotropic", Between(2.24, 2.44)),
        ],
    ),
    (
        "from far above",
        HIGH,
        &[
            ("nearest, bilinear, bilinear-8", Between(52.2, 57.4)),
            ("trilinear", Between(4.96, 5.39)),
            ("anisotropic", Between(3.87, 4.21)),
        ],
    ),
];

/// Each as it is, by 16 and by 32 rays a pixel in each direction, and more where the floor is far.
static EXACT: LazyLock<Vec<[Picture; 2]>> = LazyLock::new(|| {
    let floor = Floor::new();
    FLOORS.iter().map(|case| [16, RAYS].map(|rays| floor.exact(case.1, SIDE, rays))).collect()
});

#[test]
fn a_floor_from_any_angle() {
    let floor = Floor::new();
    every_method(LESSON.name, METHODS, FLOORS, |method: &Method<Sampler>, eye| {
        let [_, exact] = &EXACT[FLOORS.iter().position(|case| case.1 == *eye).unwrap()];
        mean([&floor.drawn(*eye, SIDE, method.run.draw), exact], |[drawn, exact]| (drawn - exact).abs())
    });
}

/// The mean of 16×16 rays a pixel is that of 32×32 to within half a grey level from anywhere but far above, where checks are
/// finer than a pixel in both directions, and on; that of 32×32 is nearer to that of 64×64.
#[test]
fn the_reference_has_converged() {
    for ((name, eye, _), [few, many]) in FLOORS.iter().zip(EXACT.iter()) {
        let off = |a: &Picture, b: &Picture| mean([a, b], |[a, b]| (a - b).abs());
        let limit = if *eye == HIGH { 0.75 } else { 0.5 };
        assert!(off(few, many) < limit, "{name}: {}", off(few, many));
        if *eye == HIGH {
            let more = Floor::new().exact(*eye, SIDE, 64);
            assert!(off(many, &more) < 0.25, "{name}: {}", off(many, &more));
        }
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

const CHOSEN: &[Case<Measure>] = &[
    (
        "how far off: straight on, 6 texels a pixel",
        |sampler| off(sampler, &square(|| noise(256, 256), 6.0)),
        &[
            ("as-it-is", Between(4.18, 4.54)),
            ("one-finer", Between(6.99, 7.58)),
            ("one-coarser", Between(6.07, 6.58)),
            ("the-nearest", Between(5.49, 5.96)),
        ],
    ),
    (
        "how much it flickers, far above",
        |sampler| flicker(sampler, &FAR),
        &[
            ("as-it-is", Between(0.623, 0.676)),
            ("one-finer", Between(11.5, 12.5)),
            ("one-coarser", Between(0.219, 0.238)),
            ("the-nearest", Between(1.68, 1.83)),
        ],
    ),
    (
        "the largest jump where the footprint grows by a percent",
        jump,
        &[
            ("as-it-is, one-finer", Between(1.92, 2.08)),
            ("one-coarser", Between(0.96, 1.04)),
            ("the-nearest", Between(66.2, 71.8)),
        ],
    ),
];

#[test]
fn a_level_one_off_flickers_or_blurs_and_a_single_one_jumps() {
    every_method(LESSON.name, LEVELS, CHOSEN, |method: &Method<Sampler>, measure| measure(&method.run));
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

/// Four pictures of a motion: where the eye is in each, and what is seen.
struct Motion {
    eyes: [Eye; 4],
    exact: [Picture; 4],
}

impl Motion {
    fn new(eye: fn(u16) -> Eye) -> Self {
        let floor = Floor::new();
        let eyes = [0, 1, 2, 3].map(eye);
        Self { eyes, exact: eyes.map(|eye| floor.exact(eye, SIDE, RAYS)) }
    }
}

/// The program's turntable, half a degree at a time.
static TURN: LazyLock<Motion> = LazyLock::new(|| {
    Motion::new(|n| {
        let (eye, center) = (DEFAULT.from.as_dvec3(), DEFAULT.to.as_dvec3());
        let flags = ViewFlags { eye, center, up: DVec3::Y }.turned(n, 720);
        Eye { from: flags.eye.as_vec3(), ..DEFAULT }
    })
});

/// A flight over the floor, straight on.
static AHEAD: LazyLock<Motion> = LazyLock::new(|| Motion::new(|n| moved(DEFAULT, n, 0.04)));

/// The same far above.
static FAR: LazyLock<Motion> = LazyLock::new(|| Motion::new(|n| moved(HIGH, n, 0.1)));

/// An eye that goes so far in each picture, to its left and on.
fn moved(eye: Eye, n: u16, by: f32) -> Eye {
    let way = Vec3::new(-0.5, 0.0, -1.0) * by * f32::from(n);
    Eye { from: eye.from + way, to: eye.to + way, ..eye }
}

/// By how many grey levels pictures change from one to the next more than what is seen does, in the mean.
fn flicker(sampler: &Sampler, Motion { eyes, exact }: &Motion) -> f64 {
    let floor = Floor::new();
    let drawn = eyes.map(|eye| floor.drawn(eye, SIDE, sampler.draw));
    let steps = [0, 1, 2].map(|n: usize| {
        let pictures = [&drawn[n], &drawn[n + 1], &exact[n], &exact[n + 1]];
        mean(pictures, |[a, b, c, d]| ((b - a).abs() - (d - c).abs()).max(0.0))
    });
    steps.iter().sum::<f64>() / 3.0
}

/// Motions, and by how many grey levels more than what is seen each method's picture changes from one to the next.
const MOTIONS: &[Case<&LazyLock<Motion>>] = &[
    (
        "a turn",
        &TURN,
        &[
            ("nearest, bilinear, bilinear-8", Between(11.7, 13.0)),
            ("trilinear", Between(0.589, 0.639)),
            ("anisotropic", Between(0.319, 0.346)),
        ],
    ),
    (
        "a flight",
        &AHEAD,
        &[
            ("nearest, bilinear, bilinear-8", Between(12.0, 13.4)),
            ("trilinear", Between(1.46, 1.59)),
            ("anisotropic", Between(0.392, 0.426)),
        ],
    ),
    (
        "a flight far above",
        &FAR,
        &[
            ("nearest, bilinear, bilinear-8", Between(32.8, 35.9)),
            ("trilinear", Between(0.623, 0.676)),
            ("anisotropic", Between(2.5, 2.72)),
        ],
    ),
];

#[test]
fn nearest_flickers_and_levels_do_not() {
    every_method(LESSON.name, METHODS, MOTIONS, |method: &Method<Sampler>, motion| {
        flicker(&method.run, motion)
    });
    // What is seen changes, too.
    for (motion, own) in [(&TURN, 5.6), (&AHEAD, 10.8), (&FAR, 14.4)] {
        let [from, to, ..] = &motion.exact;
        let changes = mean([from, to], |[from, to]| (to - from).abs());
        assert!((changes / own - 1.0).abs() < 0.05, "{changes}, not {own}");
    }
}
