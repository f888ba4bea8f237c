use allocation_counter::measure;
use blending::{Over, TRANSPARENCY, Transparency, TwoShift};
use checks::layers::{Pane, Pixel};
use common::{Color, Format, Image, Vec3};
use fastrand::Rng;
use proptest::prelude::*;
use verify::method;
use zbuffer::{DepthBuffer, Surface};

use crate::order::{Scene, UNDECIDED};

/// Those that must be exact, whatever the order.
const EXACT: [Transparency; 2] = [Transparency::Peeling, Transparency::List];

fn color() -> impl Strategy<Value = Color> {
    // Each alpha as likely as the next, and now and then the two ends.
    let alpha = prop_oneof![8 => any::<u8>(), 1 => Just(0), 1 => Just(255)];
    (any::<[u8; 3]>(), alpha).prop_map(|([r, g, b], a)| Color { r, g, b, a })
}

/// A triangle in a picture of 24×17, or partly, in either direction.
fn pane() -> impl Strategy<Value = Pane> {
    let corner = || (-12.0f32..36.0, -9.0f32..26.0, 0.0f32..1.0).prop_map(|(x, y, z)| Vec3::new(x, y, z));
    ([corner(), corner(), corner()], color())
}

fn panes(most: usize) -> impl Strategy<Value = Vec<Pane>> {
    proptest::collection::vec(pane(), 0..=most)
}

fn scene() -> impl Strategy<Value = Scene> {
    (panes(9), panes(2), color()).prop_map(|(transparent, opaque, background)| Scene {
        size: [24, 17],
        background,
        opaque,
        transparent,
    })
}

fn channels(Color { r, g, b, a }: Color) -> [f64; 4] {
    [r, g, b, a].map(f64::from)
}

/// The largest difference of a channel.
fn apart(a: [f64; 4], b: [f64; 4]) -> f64 {
    (0..4).map(|n| (a[n] - b[n]).abs()).fold(0.0, f64::max)
}

/// By how much a pixel may be off where each layer is rounded: half a level for each, of which those that are nearer let
/// through a share.
fn rounding(pixel: &Pixel) -> f64 {
    let (mut most, mut through) = (0.0, 1.0);
    for (_, color) in pixel.layers.iter().rev() {
        most += 0.5 * through;
        through *= 1.0 - f64::from(color.a) / 255.0;
    }
    most
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Peeling and list show the layers in their order, each rounded, and so are off the exact sum by no more than that takes;
    /// the weighted mean is the formula's, rounded.
    #[test]
    fn layers_are_laid_in_their_order(scene in scene()) {
        let [peeled, listed] = EXACT.map(|way| scene.drawn(way));
        let weighted = scene.drawn(Transparency::Weighted);
        for (x, y, pixel) in scene.exactly().filter(|(.., pixel)| pixel.gap > UNDECIDED) {
            let [peeled, listed, weighted] = [&peeled, &listed, &weighted].map(|image| image.get(x, y).unwrap());
            prop_assert_eq!([peeled, listed], [pixel.rounded(); 2], "({}, {}): {:?}", x, y, pixel);
            prop_assert!(apart(channels(listed), pixel.exact()) <= rounding(&pixel) + 1e-9, "{pixel:?}");
            let off = apart(channels(weighted), pixel.weighted());
            prop_assert!(off <= 0.5001, "({x}, {y}): {weighted:?}, not {:?}", pixel.weighted());
        }
    }

    /// In whatever order the triangles come, peeling and list draw the same pixels, and the sums of the weighted mean differ by
    /// rounding alone.
    #[test]
    fn the_order_does_not_matter(scene in scene(), seed in any::<u64>()) {
        let mut other = Scene { opaque: scene.opaque.clone(), transparent: scene.transparent.clone(), ..scene };
        Rng::with_seed(seed).shuffle(&mut other.transparent);
        for way in EXACT {
            let [one, other] = [&scene, &other].map(|scene| scene.drawn(way));
            for (x, y, pixel) in scene.exactly().filter(|(.., pixel)| pixel.gap > UNDECIDED) {
                prop_assert_eq!(one.get(x, y), other.get(x, y), "{:?}, ({}, {}): {:?}", way, x, y, pixel);
            }
        }
        let [one, other] = [&scene, &other].map(|scene| scene.drawn(Transparency::Weighted));
        for ((.., a), (.., b)) in one.pixels().zip(other.pixels()) {
            prop_assert!(apart(channels(a), channels(b)) <= 1.0, "{a:?}, {b:?}");
        }
    }
}

/// Where a thousand layers each add less than half a level, rounding after each holds them back; a sum in f32 does not.
#[test]
fn many_thin_layers_are_rounded_away() {
    let corners = [(-9.0, -9.0), (30.0, -9.0), (-9.0, 30.0)];
    let layer = |n: usize| {
        let corner = |(x, y)| Vec3::new(x, y, n as f32 / 1001.0);
        (corners.map(corner), Color { a: 1, ..Color::WHITE })
    };
    let off = |count: usize, way: Transparency| {
        let transparent = (1..=count).map(layer).collect();
        let scene = Scene { size: [3, 2], background: Color::BLACK, opaque: Vec::new(), transparent };
        let (.., pixel) = scene.exactly().next().unwrap();
        f64::from(scene.drawn(way).get(0, 0).unwrap().r) - pixel.exact()[0]
    };
    let rounded = [10, 100, 1000].map(|count| off(count, Transparency::List));
    // 128 is where (255 − 128)/255 is less than a half: after 128 layers no more is added. The truth is 9.8, 82.9 and 250.
    let expected = [10, 100, 128].map(f64::from);
    for ((off, shown), count) in rounded.into_iter().zip(expected).zip([10, 100, 1000]) {
        let truth = 255.0 * (1.0 - (254.0_f64 / 255.0).powi(count));
        assert!((off - (shown - truth)).abs() < 1e-9, "{count} layers: {off}");
    }
    for count in [10, 100, 1000] {
        assert!(off(count, Transparency::Weighted).abs() <= 0.51, "{count}");
    }
}

/// Memory is asked for a picture at a time, not for a triangle or a fragment; a list grows by doubling.
#[test]
fn nothing_is_allocated_for_a_fragment() {
    let surfaces = |count: usize, side: f32| -> Vec<Surface> {
        let corner = |x, y, n: usize| Vec3::new(x, y, n as f32 / (count + 1) as f32);
        let corners = |n| [corner(0.0, 0.0, n), corner(side, 0.0, n), corner(0.0, side, n)];
        (0..count).map(|n| Surface { corners: corners(n), color: Color { a: 90, ..Color::RED } }).collect()
    };
    for row in TRANSPARENCY {
        let allocations = |surfaces: &[Surface]| {
            let mut image = Image::new(64, 64, Format::Rgb);
            let depths = DepthBuffer::new(&image, 1.0);
            measure(|| row.run.draw(surfaces, Over(TwoShift), &mut image, &depths)).count_total
        };
        let [few, many] = [(2, 9.0), (40, 64.0)].map(|(count, side)| allocations(&surfaces(count, side)));
        // From about 80 fragments to 80,000: the array doubles some ten times, and so does that of one pixel's layers.
        let more = if row.run == Transparency::List { 20 } else { 0 };
        assert!(many <= few + more && many <= 30, "{}: {few}, {many}", row.name);
    }
}

/// The rows of the table stand for the ways that their names say.
#[test]
fn each_name_is_its_way() {
    let ways = ["drawn", "sorted", "peeling", "list", "weighted"].map(|name| *method(TRANSPARENCY, name));
    let expected = [
        Transparency::Drawn,
        Transparency::Sorted,
        Transparency::Peeling,
        Transparency::List,
        Transparency::Weighted,
    ];
    assert_eq!(ways, expected);
}
