use antialiasing::{METHODS, PATTERNS, RESOLVES, STORAGES, alpha_to_coverage, coverage, pattern, resolve};
use blending::{Framebuffer, State, plain};
use checks::coverage::Triangle;
use checks::footprint::{code, light};
use common::{Color, Format, IVec2, Image, Vec2, Vec3};
use proptest::prelude::*;
use verify::method;
use zbuffer::Surface;

use crate::scenes::{Scene, codes};

/// Corners about a few pixels: anywhere, on samples, on 1/256 px.
fn corner() -> impl Strategy<Value = Vec2> {
    let coordinate = || {
        prop_oneof![
            -4.0f32..12.0,
            (-64..192).prop_map(|n| n as f32 / 16.0),
            (-1024..3072).prop_map(|n| n as f32 / 256.0)
        ]
    };
    (coordinate(), coordinate()).prop_map(Vec2::from)
}

/// Corners as far out as f32 goes, most of them where lesson 3 promises to be exact.
fn far_corner() -> impl Strategy<Value = Vec2> {
    let coordinate = || {
        let scale = prop_oneof![Just(1e2f32), Just(1e4), Just(1e5), Just(1e7), Just(1e12), Just(4e15)];
        prop_oneof![(scale, -1.0f32..1.0).prop_map(|(scale, c)| scale * c), -4.0f32..12.0]
    };
    (coordinate(), coordinate()).prop_map(Vec2::from)
}

fn corners() -> impl Strategy<Value = [Vec2; 3]> {
    prop_oneof![3 => [corner(), corner(), corner()], 2 => [far_corner(), far_corner(), far_corner()]]
}

/// Any places, in any number up to 32, also on the pixel's border.
fn any_pattern() -> impl Strategy<Value = Vec<[i32; 2]>> {
    prop::collection::vec([0..=16_i32, 0..=16_i32], 1..=32)
}

fn any_color() -> impl Strategy<Value = Color> {
    any::<[u8; 4]>().prop_map(|[r, g, b, a]| Color { r, g, b, a })
}

fn opaque() -> impl Strategy<Value = Color> {
    any::<[u8; 3]>().prop_map(|[r, g, b]| Color::rgb(r, g, b))
}

/// Up to six triangles with depths of their own, some of them level, in a picture that is not square.
fn scene() -> impl Strategy<Value = Scene> {
    let depth = || prop_oneof![0.01f32..0.99, prop::sample::select(vec![0.25f32, 0.5, 0.75])];
    let surface = (corners(), [depth(), depth(), depth()], any::<bool>(), opaque()).prop_map(
        |(corners, depths, level, color)| {
            // Four times as far as this there is no triangle any more, and one way to draw makes the picture so large.
            let corner = |n: usize| {
                corners[n].clamp(Vec2::splat(-1e15), Vec2::splat(1e15)).extend(if level {
                    depths[0]
                } else {
                    depths[n]
                })
            };
            Surface { corners: [0, 1, 2].map(corner), color }
        },
    );
    let size = prop::sample::select(vec![[9, 7], [1, 1], [4, 11], [13, 2]]);
    (size, opaque(), prop::collection::vec(surface, 1..6)).prop_map(|(size, background, triangles)| Scene {
        size,
        background,
        triangles,
    })
}

/// The whole number nearest to a mean of codes, halves up.
fn rounded(mean: f64) -> f64 {
    (mean + 0.5).floor()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Exact for any corners and any pattern.
    #[test]
    fn coverage_is_exact(corners in corners(), places in any_pattern(), x in -2..10, y in -2..10) {
        let exact = Triangle::new(corners);
        for places in PATTERNS.into_iter().chain([&*places]) {
            let got = coverage(corners, IVec2::new(x, y), places);
            prop_assert_eq!(got, exact.samples(x, y, places), "({}, {}), {:?}", x, y, places);
        }
    }

    /// A sample that is moved by whole pixels is inside of a triangle that is moved by as much.
    #[test]
    fn coverage_goes_with_the_pixel(corners in [corner(), corner(), corner()], places in any_pattern(), by in [-20_000..20_000, -20_000..20_000]) {
        let by = IVec2::from(by);
        // In 1/256 px, so that moving rounds nothing.
        let corners = corners.map(|corner| (corner * 256.0).round() / 256.0);
        let moved = corners.map(|corner| corner + by.as_vec2());
        prop_assume!(moved.iter().zip(corners).all(|(moved, corner)| *moved - by.as_vec2() == corner));
        let pixel = IVec2::new(3, 2);
        prop_assert_eq!(coverage(moved, pixel + by, &places), coverage(corners, pixel, &places));
    }

    /// Four triangles about any point cover each sample of what they fill once.
    #[test]
    fn neighbours_cover_each_sample_once(hub in corner(), places in any_pattern(), turned in prop::array::uniform4(0..6_usize)) {
        let rim = [[-9.0, -8.0], [13.3, -7.1], [21.0, 20.4], [-7.7, 19.0]].map(Vec2::from);
        let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
        let triangles = [0, 1, 2, 3].map(|n: usize| {
            let triangle = [hub, rim[n], rim[(n + 1) % 4]];
            orders[turned[n]].map(|corner: usize| triangle[corner])
        });
        for places in PATTERNS.into_iter().chain([&*places]) {
            for (x, y) in [(0, 0), (3, 2), (7, 9), (1, 5)] {
                let masks = triangles.map(|triangle| coverage(triangle, IVec2::new(x, y), places));
                let all = (1_u64 << places.len()) - 1;
                prop_assert_eq!(masks.iter().map(|&mask| u64::from(mask)).sum::<u64>(), all, "{:?}", masks);
                prop_assert_eq!(masks.iter().fold(0, |or, &mask| or | u64::from(mask)), all);
            }
        }
    }

    /// The samples of one colour are that colour, however many there are.
    #[test]
    fn samples_of_one_colour_are_that_colour(color in any_color(), n in 1..=32_usize) {
        for way in RESOLVES {
            prop_assert_eq!((way.run)(&vec![color; n]), color, "{}", way.name);
        }
    }

    /// The mean of the codes is exact; that of the light is what it is in f64, but where rounding decides.
    #[test]
    fn a_resolved_colour_is_the_mean(samples in prop::collection::vec(any_color(), 1..=32)) {
        let channels = |color: Color| [color.r, color.g, color.b, color.a];
        let (got, linear) = (channels(resolve(&samples)), channels((method(RESOLVES, "linear"))(&samples)));
        for channel in 0..4 {
            let mean = |of: fn(f64) -> f64| {
                samples.iter().map(|&sample| of(channels(sample)[channel].into())).sum::<f64>() / samples.len() as f64
            };
            let sum: u32 = samples.iter().map(|&sample| u32::from(channels(sample)[channel])).sum();
            let n = samples.len() as u32;
            prop_assert_eq!(u32::from(got[channel]), (2 * sum + n) / (2 * n));
            let exact = if channel == 3 { mean(|alpha| alpha) } else { code(mean(light)) };
            prop_assert!((f64::from(linear[channel]) - exact).abs() <= 0.502, "{}, not {exact}", linear[channel]);
        }
    }

    /// In whichever order the samples come.
    #[test]
    fn the_order_of_samples_does_not_matter(samples in prop::collection::vec(any_color(), 1..=16), turn in 0..16_usize) {
        let mut turned = samples.clone();
        turned.rotate_left(turn % samples.len());
        prop_assert_eq!(resolve(&turned), resolve(&samples));
    }

    /// Alpha covers its share of the samples, to within rounding, and more alpha never fewer or others.
    #[test]
    fn alpha_covers_its_share(alpha in any::<u8>(), samples in prop::sample::select(vec![1_u32, 2, 4, 8, 16, 32])) {
        let mask = alpha_to_coverage(alpha, samples);
        prop_assert!(u64::from(mask) < 1 << samples);
        let share = f64::from(mask.count_ones()) / f64::from(samples);
        prop_assert!((share - f64::from(alpha) / 255.0).abs() <= 0.5 / f64::from(samples));
        if let Some(less) = alpha.checked_sub(1) {
            prop_assert_eq!(alpha_to_coverage(less, samples) & !mask, 0);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// White over black leaves 255·k/n, rounded to nearest, where k of the n samples are covered.
    #[test]
    fn white_over_black_is_the_share_of_the_samples(corners in corners()) {
        let white = Surface { corners: corners.map(|corner| corner.extend(0.5)), color: Color::WHITE };
        let scene = Scene { size: [8, 8], background: Color::BLACK, triangles: vec![white] };
        let exact = Triangle::new(corners);
        // A larger picture's corners are rounded there.
        for method in METHODS.iter().filter(|method| !["ordered-16", "area"].contains(&method.name)) {
            let image = scene.drawn(&method.run);
            let places = pattern(method.run.samples);
            for (x, y) in scene.pixels() {
                let (k, n) = (exact.samples(x, y, places).count_ones(), places.len() as u32);
                let expected = ((2 * 255 * k + n) / (2 * n)) as u8;
                prop_assert_eq!(image.get(x, y), Some(Color::rgb(expected, expected, expected)), "{}", method.name);
            }
        }
    }

    /// A pixel is the mean of what its samples see, each the nearest at its own place.
    #[test]
    fn each_sample_sees_the_nearest(scene in scene()) {
        for method in METHODS.iter().filter(|method| method.name != "area") {
            let image = scene.drawn(&method.run);
            for ((x, y), mean) in scene.pixels().zip(scene.sampled(method)) {
                let Some(mean) = mean else { continue };
                let got = codes(image.get(x, y).unwrap());
                prop_assert_eq!(got, mean.map(rounded), "{}, ({}, {})", method.name, x, y);
            }
        }
    }

    /// Neighbours of one colour leave nothing of the background at their common sides, however they are cut.
    #[test]
    fn nothing_shines_through_between_neighbours(hub in corner(), color in opaque(), background in opaque(), first in 0..4_usize) {
        let rim = [[-9.0, -8.0], [13.3, -7.1], [21.0, 20.4], [-7.7, 19.0]].map(Vec2::from);
        let triangle = |n: usize| {
            let corners = [hub, rim[n % 4], rim[(n + 1) % 4]];
            Surface { corners: corners.map(|corner| corner.extend(0.5)), color }
        };
        let scene = Scene { size: [9, 7], background, triangles: (first..first + 4).map(triangle).collect() };
        for method in METHODS.iter().filter(|method| method.name != "area") {
            prop_assert!(scene.drawn(&method.run).pixels().all(|pixel| pixel.2 == color), "{}", method.name);
        }
    }

    /// Where the colour is the same all over a pixel, shading once is as good as at each sample.
    #[test]
    fn shading_once_changes_no_colour_that_is_constant(scene in scene()) {
        for samples in [4, 16] {
            let [once, each] = ["msaa", "ssaa"].map(|name| scene.drawn(method(METHODS, &format!("{name}-{samples}"))));
            prop_assert!(once == each, "{samples}");
        }
    }

    /// One sample is lesson 14's loop.
    #[test]
    fn one_sample_draws_what_lesson_14_draws(scene in scene()) {
        let mut expected = Image::new(scene.size[0], scene.size[1], Format::Rgb);
        for (x, y) in scene.pixels() {
            expected.set(x, y, scene.background);
        }
        plain::draw(&scene.triangles, &mut Framebuffer::new(&mut expected, State::OFF));
        prop_assert!(scene.drawn(method(METHODS, "none")) == expected);
    }

    /// Whichever way samples are stored, the pixels are the same, also where colours are laid over others.
    #[test]
    fn storages_draw_the_same_pixels(scene in scene(), alphas in prop::array::uniform5(prop::sample::select(vec![255, 254, 128, 7, 0_u8]))) {
        let mut scene = scene;
        scene.triangles.iter_mut().zip(alphas).for_each(|(triangle, alpha)| triangle.color.a = alpha);
        let pictures: Vec<Image> = STORAGES.iter().map(|storage| scene.drawn(&storage.run)).collect();
        prop_assert!(pictures.windows(2).all(|pair| pair[0] == pair[1]));
        prop_assert!(pictures[0] == scene.drawn(method(METHODS, "msaa-16")));
    }

    /// Whatever numbers it is given, no method panics.
    #[test]
    fn no_method_panics(wild in any::<[f32; 9]>(), near in [corner(), corner()]) {
        let [a, b, c] = [0, 3, 6].map(|n| Vec3::new(wild[n], wild[n + 1], wild[n + 2]));
        let near = near.map(|corner| corner.extend(0.5));
        let surface = |corners| Surface { corners, color: Color::WHITE };
        let triangles = [surface([a, b, c]), surface([a, b, near[0]]), surface([a, near[0], near[1]])];
        for method in METHODS {
            for size in [[9, 4], [1, 1]] {
                let _ = Scene { size, background: Color::BLACK, triangles: triangles.to_vec() }.drawn(&method.run);
            }
        }
    }
}

/// The patterns are those of the specification, which counts from the upper left corner (Vulkan 1.3, *Standard sample
/// locations*): the same numbers, once more, as it prints them.
#[test]
fn the_places_are_those_of_the_specification() {
    let printed: [&[[f64; 2]]; 5] = [
        &[[0.5, 0.5]],
        &[[0.75, 0.75], [0.25, 0.25]],
        &[[0.375, 0.125], [0.875, 0.375], [0.125, 0.625], [0.625, 0.875]],
        &[
            [0.5625, 0.3125],
            [0.4375, 0.6875],
            [0.8125, 0.5625],
            [0.3125, 0.1875],
            [0.1875, 0.8125],
            [0.0625, 0.4375],
            [0.6875, 0.9375],
            [0.9375, 0.0625],
        ],
        &[
            [0.5625, 0.5625],
            [0.4375, 0.3125],
            [0.3125, 0.625],
            [0.75, 0.4375],
            [0.1875, 0.375],
            [0.625, 0.8125],
            [0.8125, 0.6875],
            [0.6875, 0.1875],
            [0.375, 0.875],
            [0.5, 0.0625],
            [0.25, 0.125],
            [0.125, 0.75],
            [0.0, 0.5],
            [0.9375, 0.25],
            [0.875, 0.9375],
            [0.0625, 0.0],
        ],
    ];
    for (n, places) in [1, 2, 4, 8, 16].into_iter().zip(printed) {
        let down: Vec<[f64; 2]> =
            pattern(n).iter().map(|&[x, y]| [f64::from(x) / 16.0, 1.0 - f64::from(y) / 16.0]).collect();
        assert_eq!(down, places, "{n}");
        // From two samples on no two are in one column or in one row.
        for axis in 0..2 {
            let mut coordinates: Vec<i32> = pattern(n).iter().map(|place| place[axis]).collect();
            coordinates.sort_unstable();
            coordinates.dedup();
            assert_eq!(coordinates.len(), n);
        }
    }
}
