//! Whatever is drawn, by whatever plan: lesson 13's pixels, all of them.

use clipping::{Counts, Cull};
use common::Color;
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::RngAlgorithm;
use speed::Plan;

use crate::canvas::{Canvas, Way, again, differing, drawn, frame, levels};
use crate::soup::{Corner, Drops, Soup};

/// Widths and heights: one pixel, less than a block, a block, a pixel more than some, and one much wider than high.
const SIZES: [[u16; 2]; 9] =
    [[1, 1], [7, 5], [8, 8], [9, 8], [16, 17], [33, 24], [65, 63], [64, 64], [300, 3]];

/// Meshes that are drawn one after the other.
#[derive(Clone, Debug)]
struct Picture {
    soups: Vec<(Soup, Cull)>,
    background: Color,
}

impl Picture {
    fn draw(&self, canvas: &mut Canvas) -> Counts {
        let mut counts = Counts::default();
        for (soup, cull) in &self.soups {
            counts += canvas.draw(&soup.shader(), &soup.mesh(), *cull);
        }
        counts
    }
}

/// A place in 1/256 px, for a picture that is so many pixels wide or high.
fn place(side: u16) -> impl Strategy<Value = i32> {
    let end = 256 * i32::from(side);
    prop_oneof![
        4 => -end / 4..end + end / 4,
        // Centres of pixels, and borders of pixels, blocks and tiles; or next to them.
        2 => (-1..=2 * i32::from(side), -1..=1).prop_map(|(n, off)| 128 * n + off),
        2 => (-1..=i32::from(side) / 8 + 1, -1..=1).prop_map(|(n, off)| 2048 * n + off),
        2 => (-1..=i32::from(side) / 8 + 1, -1..=1).prop_map(|(n, off)| 2048 * n + 128 + off),
        1 => -(1 << 24)..1 << 24,
    ]
}

type Points = [[i32; 2]; 3];

/// The corners of a triangle.
fn points([width, height]: [u16; 2]) -> BoxedStrategy<Points> {
    let point = || [place(width).boxed(), place(height).boxed()];
    let around = |reach: i32| {
        let steps = prop::array::uniform3(prop::array::uniform2(-reach..=reach));
        (point(), steps).prop_map(|([x, y], steps)| steps.map(|[right, up]| [x + right, y + up]))
    };
    // The third corner on the side between the others, or next to it.
    let sliver = (point(), point(), 0.0..1.0_f64, -300..300).prop_map(|([ax, ay], [bx, by], share, off)| {
        let on = |a: i32, b: i32| a + (f64::from(b - a) * share) as i32;
        [[ax, ay], [bx, by], [on(ax, bx) + off, on(ay, by)]]
    });
    prop_oneof![
        4 => [point(), point(), point()],
        2 => around(300),
        2 => around(2500),
        1 => around(100_000),
        1 => sliver,
        // No area.
        1 => (point(), point()).prop_map(|(a, b)| [a, b, a]),
    ]
    .boxed()
}

/// The depths of corners.
fn depths() -> BoxedStrategy<[f32; 3]> {
    let same = select(vec![0.0, -0.0, 0.25, 0.5, 1.0 - f32::EPSILON / 2.0, 1.0]).prop_map(|z| [z; 3]);
    // So near each other that rounding decides.
    let near = (select(vec![0.0, 0.1, 0.5, 0.75, 0.999_999]), prop::array::uniform3(0..4_u32));
    let near = near.prop_map(|(z, steps)| steps.map(|n| f32::from_bits(f32::to_bits(z) + n)));
    prop_oneof![
        3 => prop::array::uniform3(0.0..1.0_f32),
        2 => same,
        2 => near,
        // Cut by near and far.
        1 => prop::array::uniform3(-0.5..1.5_f32),
        1 => prop::array::uniform3(select(vec![0.0, 0.5, 1.0, f32::NAN, f32::INFINITY, -1e30, 1e-40])),
    ]
    .boxed()
}

/// The w of corners.
fn ws() -> BoxedStrategy<[f32; 3]> {
    let odd = vec![1.0, 0.0, -1.0, 1e-6, 1.1e-6, -1e-7, 1e-30, 1e30, f32::NAN, f32::INFINITY];
    prop_oneof![
        4 => Just([1.0; 3]),
        3 => prop::array::uniform3(0.1..10.0_f32),
        1 => prop::array::uniform3(-1.0..1.0_f32),
        1 => prop::array::uniform3(prop_oneof![3 => Just(1.0), 2 => 1e-5..1e3_f32, 1 => select(odd)]),
    ]
    .boxed()
}

fn corners(points: Points, z: [f32; 3], w: [f32; 3]) -> [Corner; 3] {
    [0, 1, 2].map(|n| Corner { x: points[n][0], y: points[n][1], z: z[n], w: w[n] })
}

fn triangle(size: [u16; 2]) -> impl Strategy<Value = [Corner; 3]> {
    (points(size), depths(), ws()).prop_map(|(points, z, w)| corners(points, z, w))
}

/// Triangles that share no vertices, some of them twice.
fn apart(size: [u16; 2]) -> impl Strategy<Value = Soup> {
    (prop::collection::vec(triangle(size), 0..12), any::<bool>()).prop_map(move |(mut triangles, twice)| {
        if twice {
            triangles.extend(triangles.clone().into_iter().step_by(2));
        }
        Soup::apart(&triangles, size)
    })
}

/// Layers, each as large as the picture or larger, of depths that grow, shrink, or are nearly the same.
fn layers(size: [u16; 2]) -> impl Strategy<Value = Soup> {
    let step = select(vec![0.01_f32, -0.01, 1e-7, -1e-7, 0.0]);
    (points(size), step, 1..12_u8, prop::array::uniform3(-3e-7..3e-7_f32)).prop_map(
        move |(points, step, count, tilt)| {
            let layer = |n: u8| corners(points, tilt.map(|z| 0.5 + z + step * f32::from(n)), [1.0; 3]);
            Soup::apart(&(0..count).map(layer).collect::<Vec<_>>(), size)
        },
    )
}

/// A grid over the picture, whose corners are moved at random.
fn grid(size: [u16; 2]) -> impl Strategy<Value = Soup> {
    let [width, height] = size.map(|side| 256 * i32::from(side));
    (2..6_usize, 2..6_usize, select(vec![0, 1, 128, 3000])).prop_flat_map(move |(across, up, reach)| {
        let moved = (prop::array::uniform2(-reach..=reach), 0.0..1.0_f32, 0.5..2.0_f32);
        prop::collection::vec(moved, across * up).prop_map(move |moves| {
            let corner = |(n, &([right, above], z, w)): (usize, &([i32; 2], f32, f32))| {
                let (column, row) = ((n % across) as i32, (n / across) as i32);
                let x = width * column / (across as i32 - 1) + right;
                let y = height * row / (up as i32 - 1) + above;
                Corner { x, y, z, w }
            };
            Soup::grid(&moves.iter().enumerate().map(corner).collect::<Vec<_>>(), across, size)
        })
    })
}

/// One number of a position, if any, and what it is instead.
fn odd() -> impl Strategy<Value = Option<(prop::sample::Index, usize, f32)>> {
    let number = select(vec![f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30, -1e-30]);
    prop_oneof![15 => Just(None), 1 => (any::<prop::sample::Index>(), 0..4_usize, number).prop_map(Some)]
}

fn soup(size: [u16; 2]) -> impl Strategy<Value = Soup> {
    let drops = vec![Drops::Checker, Drops::Some, Drops::All, Drops::Nan, Drops::Triangles];
    let drops = prop_oneof![1 => Just(Drops::Nothing), 1 => select(drops)];
    let soup = prop_oneof![4 => apart(size).boxed(), 2 => layers(size).boxed(), 1 => grid(size).boxed()];
    (soup, drops, odd()).prop_map(|(mut soup, drops, odd)| {
        if let Some((index, axis, number)) = odd.filter(|_| !soup.positions.is_empty()) {
            index.get_mut(&mut soup.positions)[axis] = number;
        }
        soup.dropping(drops)
    })
}

fn picture(size: [u16; 2]) -> impl Strategy<Value = Picture> {
    let cull = select(vec![Cull::None, Cull::None, Cull::Back, Cull::Front]);
    let color = any::<[u8; 4]>().prop_map(|[r, g, b, a]| Color { r, g, b, a });
    (prop::collection::vec((soup(size), cull), 1..4), color)
        .prop_map(|(soups, background)| Picture { soups, background })
}

/// By any plan, with any instructions that there are.
pub(crate) fn tiled() -> impl Strategy<Value = Way> {
    let tile = prop_oneof![
        1 => Just(None),
        3 => (1..10).prop_map(|blocks| Some(8 * blocks)),
        1 => select(vec![Some(64), Some(1024)]),
    ];
    let threads = prop_oneof![40 => Just(1), 6 => 2..5_usize, 1 => select(vec![8, 64])];
    let ideas = (tile, any::<bool>(), any::<bool>(), threads);
    (ideas, select(levels())).prop_map(|((tile, hierarchical, deferred, threads), level)| {
        Way::Tiled(Plan { tile, hierarchical, deferred, threads }, level)
    })
}

fn scene() -> impl Strategy<Value = ([u16; 2], Vec<Picture>, Way)> {
    select(SIZES.to_vec())
        .prop_flat_map(|size| (Just(size), prop::collection::vec(picture(size), 1..3), tiled()))
}

proptest! {
    // Scenes are made of many numbers, most of the time with the usual generator.
    #![proptest_config(ProptestConfig {
        cases: 10_000, rng_algorithm: RngAlgorithm::XorShift, ..ProptestConfig::default()
    })]

    /// One picture after the other in the same frame; and by blocks.
    #[test]
    fn any_scene_is_drawn_as_by_lesson_13((size, pictures, way) in scene()) {
        let Way::Tiled(plan, level) = way else { unreachable!() };
        let mut frame = frame(size, plan).at_level(level);
        for picture in &pictures {
            let draw = |canvas: &mut Canvas| picture.draw(canvas);
            let (expected, counts) = drawn(Way::Simple, size, picture.background, draw);
            let (tiled, tiled_counts) = again(&mut frame, size, picture.background, draw);
            let (blocks, block_counts) = drawn(Way::Blocks, size, picture.background, draw);
            prop_assert_eq!(differing(&expected, &tiled), None, "{:?}", way);
            prop_assert_eq!(differing(&expected, &blocks), None, "blocks");
            prop_assert_eq!([tiled_counts, block_counts], [counts; 2]);
        }
    }
}
