use blending::{Over, TRANSPARENCY, Transparency, TwoShift, glass};
use checks::layers::{self, Pane};
use common::{Color, Format, Image, Vec3};
use fastrand::Rng;
use verify::stability::Must::{Between, Exact};
use verify::stability::{Case, every_method};
use zbuffer::{DepthBuffer, Surface};

/// Triangles over a picture.
#[derive(Debug)]
pub(crate) struct Scene {
    pub size: [u16; 2],
    pub background: Color,
    pub opaque: Vec<Pane>,
    pub transparent: Vec<Pane>,
}

/// On 40×30 pixels of one colour.
fn scene(transparent: Vec<Pane>) -> Scene {
    Scene { size: [40, 30], background: Color::rgb(200, 210, 180), opaque: Vec::new(), transparent }
}

/// The reference's triangles as the lesson has them.
fn surfaces(panes: &[Pane]) -> Vec<Surface> {
    panes.iter().map(|&(corners, color)| Surface { corners, color }).collect()
}

impl Scene {
    /// The picture, in that format, with the opaque triangles drawn, and their depths.
    fn behind(&self, format: Format) -> (Image, DepthBuffer<f32>) {
        let [width, height] = self.size;
        let mut image = Image::new(width, height, format);
        for (x, y, _) in image.clone().pixels() {
            image.set(x, y, self.background);
        }
        let mut target = blending::Framebuffer::new(&mut image, blending::State::OFF);
        blending::plain::draw(&surfaces(&self.opaque), &mut target);
        let depths = target.depths;
        (image, depths)
    }

    /// What one of the ways shows.
    pub(crate) fn drawn(&self, transparency: Transparency) -> Image {
        let (mut image, depths) = self.behind(Format::Rgba);
        transparency.draw(&surfaces(&self.transparent), Over(TwoShift), &mut image, &depths);
        image
    }

    /// The layers of each pixel.
    pub(crate) fn exactly(&self) -> impl Iterator<Item = (i32, i32, layers::Pixel)> + '_ {
        let [width, height] = self.size.map(i32::from);
        let pixels = (0..height).flat_map(move |y| (0..width).map(move |x| (x, y)));
        pixels.map(|(x, y)| (x, y, layers::at(self.background, &self.opaque, &self.transparent, x, y)))
    }
}

/// Two depths that are not equal, but nearer to each other than this, may change places: they are interpolated in f32.
pub(crate) const UNDECIDED: f64 = 1e-6;

/// By how many grey levels a channel is off the layers' exact order, each laid over the others and rounded to nearest; in the
/// mean of the pixels with layers, alpha counted.
fn off(transparency: Transparency, scene: &Scene) -> f64 {
    let image = scene.drawn(transparency);
    let (mut sum, mut count, mut undecided) = (0.0, 0.0, 0.0);
    for (x, y, pixel) in scene.exactly() {
        let got = image.get(x, y).unwrap();
        if pixel.layers.is_empty() {
            assert_eq!(got, pixel.below, "nothing is seen at ({x}, {y})");
        } else if pixel.gap > 0.0 && pixel.gap < UNDECIDED {
            undecided += 1.0;
        } else {
            let truth = pixel.rounded();
            let off = [(got.r, truth.r), (got.g, truth.g), (got.b, truth.b), (got.a, truth.a)];
            sum += off.into_iter().map(|(a, b)| f64::from(a.abs_diff(b))).sum::<f64>() / 4.0;
            count += 1.0;
        }
    }
    assert!(undecided <= 0.01 * count, "{undecided} of {count} pixels are undecided");
    if count > 0.0 { sum / count } else { 0.0 }
}

const RED: Color = Color::rgb(230, 30, 20);
const GREEN: Color = Color::rgb(20, 200, 60);
const BLUE: Color = Color::rgb(30, 60, 240);

const fn with_alpha(a: u8, color: Color) -> Color {
    Color { a, ..color }
}

/// A triangle over most of the picture, at one depth.
fn level(depth: f32, color: Color) -> Pane {
    sloping([depth; 3], color)
}

/// The same with a depth for each corner.
fn sloping(depths: [f32; 3], color: Color) -> Pane {
    let corners = [(2.3, 1.2), (38.6, 4.4), (14.1, 28.7)];
    ([0, 1, 2].map(|n| Vec3::new(corners[n].0, corners[n].1, depths[n])), color)
}

/// Its corners in the other direction.
fn turned(([a, b, c], color): Pane) -> Pane {
    ([a, c, b], color)
}

/// A bar in two triangles from one place to another, each with a depth.
fn bar(from: Vec3, to: Vec3, color: Color) -> [Pane; 2] {
    let along = (to - from).truncate().normalize();
    let aside = (3.0 * along.perp()).extend(0.0);
    let [a, b, c, d] = [from + aside, from - aside, to - aside, to + aside];
    [([a, b, c], color), ([a, c, d], color)]
}

/// Three long triangles, each with its tip behind the next one's foot.
fn circle() -> Vec<Pane> {
    let [a, b, c] = [(6.0, 5.0), (34.0, 7.0), (18.0, 26.0)].map(|(x, y)| Vec3::new(x, y, 0.0));
    let spike = |from: Vec3, to: Vec3, color| {
        let (along, depth) = ((to - from) * 0.3, Vec3::new(0.0, 0.0, 0.25));
        let aside = (4.0 * (to - from).truncate().normalize().perp()).extend(0.0);
        let foot = from - along + depth;
        ([foot + aside, foot - aside, to + along + 3.0 * depth], color)
    };
    let colors = [with_alpha(130, RED), with_alpha(150, GREEN), with_alpha(110, BLUE)];
    vec![spike(a, b, colors[0]), spike(b, c, colors[1]), spike(c, a, colors[2])]
}

/// Layers of any colour and alpha, in any order, at depths that are told apart.
fn many(count: usize, alphas: std::ops::RangeInclusive<u8>) -> Vec<Pane> {
    let mut rng = Rng::with_seed(count as u64);
    let mut depths: Vec<f32> = (1..=count).map(|n| n as f32 / (count + 1) as f32).collect();
    rng.shuffle(&mut depths);
    let mut color = || Color { r: rng.u8(..), g: rng.u8(..), b: rng.u8(..), a: rng.u8(alphas.clone()) };
    depths.into_iter().map(|depth| level(depth, color())).collect()
}

/// The rosette of the lesson, smaller.
fn rosette() -> Scene {
    let glass::Rosette { opaque, transparent } = glass::Rosette::new(common::Vec2::new(120.0, 100.0));
    let panes = |surfaces: Vec<Surface>| surfaces.iter().map(|s| (s.corners, s.color)).collect();
    Scene { size: [120, 100], opaque: panes(opaque), ..scene(panes(transparent)) }
}

/// What is drawn, and by how many grey levels each way is off.
const SCENES: &[Case<fn() -> Scene>] = &[
    ("nothing transparent", || scene(vec![]), &[("drawn, sorted, peeling, list, weighted", Exact)]),
    (
        "nothing transparent, something opaque",
        || Scene { opaque: vec![level(0.5, RED)], ..scene(vec![]) },
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "one layer",
        || scene(vec![level(0.5, with_alpha(127, RED))]),
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "one layer, clockwise",
        || scene(vec![turned(level(0.5, with_alpha(77, BLUE)))]),
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "one layer of alpha 0",
        || scene(vec![level(0.5, with_alpha(0, RED))]),
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "one layer of alpha 1",
        || scene(vec![level(0.999, with_alpha(1, RED))]),
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "one layer of alpha 254",
        || scene(vec![level(0.001, with_alpha(254, RED))]),
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "one layer of alpha 255",
        || scene(vec![level(0.5, RED)]),
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "two layers, the far first",
        || scene(vec![level(0.6, with_alpha(127, RED)), level(0.4, with_alpha(100, BLUE))]),
        &[("drawn, sorted, peeling, list", Exact), ("weighted", Between(8.57, 8.93))],
    ),
    (
        "two layers, the near first",
        || scene(vec![level(0.4, with_alpha(100, BLUE)), level(0.6, with_alpha(127, RED))]),
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(21.3, 22.2)),
            ("weighted", Between(8.57, 8.93)),
        ],
    ),
    (
        "two layers far away",
        || scene(vec![level(0.99, with_alpha(100, BLUE)), level(0.999, with_alpha(127, RED))]),
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(21.3, 22.2)),
            ("weighted", Between(14.0, 14.5)),
        ],
    ),
    (
        "two layers of one colour and one alpha",
        || scene(vec![level(0.4, with_alpha(100, BLUE)), level(0.6, with_alpha(100, BLUE))]),
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "an opaque layer before another",
        || scene(vec![level(0.4, BLUE), level(0.6, with_alpha(200, RED))]),
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(86.7, 90.3)),
            ("weighted", Between(17.1, 17.9)),
        ],
    ),
    (
        "a layer of alpha 0 before another",
        || scene(vec![level(0.2, with_alpha(0, BLUE)), level(0.6, with_alpha(200, RED))]),
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "three layers, the near first",
        || {
            let [a, b, c] = [(0.2, 90, RED), (0.5, 180, GREEN), (0.8, 130, BLUE)];
            scene([a, b, c].map(|(depth, alpha, color)| level(depth, with_alpha(alpha, color))).to_vec())
        },
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(37.5, 39.0)),
            ("weighted", Between(10.8, 11.2)),
        ],
    ),
    (
        "two cut each other",
        || {
            let one = sloping([0.2, 0.8, 0.5], with_alpha(127, RED));
            scene(vec![one, sloping([0.7, 0.35, 0.4], with_alpha(160, GREEN))])
        },
        &[
            ("peeling, list", Exact),
            ("drawn, sorted", Between(14.3, 14.9)),
            ("weighted", Between(8.61, 8.96)),
        ],
    ),
    (
        "three cut each other, some clockwise",
        || {
            let one = sloping([0.2, 0.8, 0.5], with_alpha(127, RED));
            let other = turned(sloping([0.7, 0.35, 0.4], with_alpha(160, GREEN)));
            scene(vec![one, other, sloping([0.4, 0.6, 0.3], with_alpha(99, BLUE))])
        },
        &[
            ("peeling, list", Exact),
            ("drawn, sorted", Between(20.6, 21.4)),
            ("weighted", Between(9.48, 9.87)),
        ],
    ),
    (
        "three cover each other in a circle",
        || scene(circle()),
        &[
            ("peeling, list", Exact),
            ("drawn, sorted", Between(0.648, 0.674)),
            ("weighted", Between(1.17, 1.22)),
        ],
    ),
    (
        "the same the other way round",
        || scene(circle().into_iter().rev().collect()),
        &[
            ("peeling, list", Exact),
            ("drawn, sorted", Between(1.58, 1.64)),
            ("weighted", Between(1.17, 1.22)),
        ],
    ),
    (
        "a long one is nearer in the mean, but farther here",
        || {
            let [from, to] = [Vec3::new(-60.0, 12.0, 0.05), Vec3::new(50.0, 12.0, 0.75)];
            let here = bar(Vec3::new(30.0, 2.0, 0.5), Vec3::new(34.0, 28.0, 0.5), with_alpha(127, RED));
            scene([bar(from, to, with_alpha(140, BLUE)), here].concat())
        },
        &[
            ("drawn, peeling, list", Exact),
            ("sorted", Between(0.502, 0.523)),
            ("weighted", Between(0.261, 0.272)),
        ],
    ),
    (
        "two at one depth",
        || scene(vec![level(0.5, with_alpha(127, RED)), level(0.5, with_alpha(100, BLUE))]),
        &[
            ("drawn, sorted, list", Exact),
            ("peeling", Between(37.2, 38.8)),
            ("weighted", Between(14.0, 14.5)),
        ],
    ),
    (
        "three at one depth, sloping",
        || {
            let three = [(127, RED), (100, BLUE), (80, GREEN)];
            scene(three.map(|(alpha, color)| sloping([0.2, 0.9, 0.6], with_alpha(alpha, color))).to_vec())
        },
        &[
            ("drawn, sorted, list", Exact),
            ("peeling", Between(35.5, 37.0)),
            ("weighted", Between(19.1, 19.9)),
        ],
    ),
    (
        "behind what is opaque",
        || Scene { opaque: vec![level(0.5, GREEN)], ..scene(vec![level(0.7, with_alpha(127, RED))]) },
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "at the depth of what is opaque",
        || {
            let slope = [0.2, 0.9, 0.6];
            Scene { opaque: vec![sloping(slope, GREEN)], ..scene(vec![sloping(slope, with_alpha(127, RED))]) }
        },
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "through what is opaque",
        || Scene {
            opaque: vec![sloping([0.8, 0.2, 0.5], GREEN)],
            ..scene(vec![level(0.45, with_alpha(127, RED)), sloping([0.1, 0.9, 0.6], with_alpha(90, BLUE))])
        },
        &[
            ("peeling, list", Exact),
            ("drawn", Between(3.91, 4.07)),
            ("sorted", Between(9.39, 9.77)),
            ("weighted", Between(3.76, 3.91)),
        ],
    ),
    (
        "beyond the far plane",
        || scene(vec![level(1.0, with_alpha(127, RED)), level(1.5, with_alpha(127, BLUE))]),
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "on the near plane",
        || scene(vec![level(0.0, with_alpha(127, RED)), level(0.5, with_alpha(127, BLUE))]),
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(27.2, 28.3)),
            ("weighted", Between(18.4, 19.1)),
        ],
    ),
    (
        "of no area, and of no depth",
        || {
            let (corners, color) = level(0.5, with_alpha(127, RED));
            let flat = [corners[0], corners[1], corners[0].midpoint(corners[1])];
            let none = corners.map(|corner| corner.with_z(f32::NAN));
            scene(vec![(flat, color), (none, color), level(0.4, with_alpha(127, BLUE))])
        },
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "far outside of the picture",
        || {
            let far = [(-9e4, -5e4), (9e4, -4e4), (1e4, 8e4)];
            let huge = |depth, color| (far.map(|(x, y)| Vec3::new(x, y, depth)), color);
            scene(vec![huge(0.3, with_alpha(127, RED)), huge(0.6, with_alpha(127, GREEN))])
        },
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(25.5, 26.5)),
            ("weighted", Between(13.7, 14.3)),
        ],
    ),
    (
        "a strip that shares its sides: one layer",
        || {
            let at = |n: i32| Vec3::new((4 * n) as f32 + 0.5, if n % 2 == 0 { 3.5 } else { 25.5 }, 0.5);
            scene((0..8).map(|n| ([at(n), at(n + 1), at(n + 2)], with_alpha(127, RED))).collect())
        },
        &[("drawn, sorted, peeling, list, weighted", Exact)],
    ),
    (
        "10 layers in any order",
        || scene(many(10, 0..=255)),
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(12.2, 12.8)),
            ("weighted", Between(5.39, 5.61)),
        ],
    ),
    (
        "100 layers in any order",
        || scene(many(100, 0..=60)),
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(15.2, 15.8)),
            ("weighted", Between(5.39, 5.61)),
        ],
    ),
    (
        "1000 layers in any order",
        || Scene { size: [20, 9], ..scene(many(1000, 0..=20)) },
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(8.33, 8.67)),
            ("weighted", Between(4.66, 4.84)),
        ],
    ),
    (
        "1000 layers of alpha 1: rounding holds them back",
        || Scene { size: [20, 9], ..scene(many(1000, 1..=1)) },
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(0.49, 0.51)),
            ("weighted", Between(1.96, 2.04)),
        ],
    ),
    (
        "over nothing: a picture of alpha 0",
        || {
            let layers = vec![level(0.4, with_alpha(100, BLUE)), level(0.6, with_alpha(127, RED))];
            Scene { background: Color { r: 0, g: 0, b: 0, a: 0 }, ..scene(layers) }
        },
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(21.6, 22.4)),
            ("weighted", Between(8.57, 8.93)),
        ],
    ),
    (
        "a picture of one pixel",
        || Scene { size: [1, 1], ..scene(many(5, 0..=255).into_iter().map(around_the_corner).collect()) },
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(42.1, 43.9)),
            ("weighted", Between(1.23, 1.27)),
        ],
    ),
    (
        "a picture 50 high and 1 wide",
        || Scene { size: [1, 50], ..scene(many(5, 0..=255).into_iter().map(around_the_corner).collect()) },
        &[
            ("sorted, peeling, list", Exact),
            ("drawn", Between(42.1, 43.9)),
            ("weighted", Between(1.23, 1.27)),
        ],
    ),
    (
        "the rosette",
        rosette,
        &[
            ("peeling, list", Exact),
            ("drawn", Between(13.4, 13.9)),
            ("sorted", Between(8.77, 9.13)),
            ("weighted", Between(3.3, 3.43)),
        ],
    ),
];

/// Moved so that it covers the pixel (0, 0).
fn around_the_corner((corners, color): Pane) -> Pane {
    (corners.map(|corner| corner - Vec3::new(18.0, 10.0, 0.0)), color)
}

#[test]
fn stability() {
    every_method("transparency", TRANSPARENCY, SCENES, |method, scene| off(method.run, &scene()));
}
