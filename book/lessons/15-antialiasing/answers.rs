//! The numbers of the chapter's worked examples and of their quizzes, computed by the lesson's own code.

use antialiasing::area::{area, clipped};
use antialiasing::{alpha_to_coverage, coverage, pattern, resolve};
use common::{Color, IVec2, Vec2, Vec4Swizzles};
use filtering::light::SRGB;

use super::sketches::{CUT, grid, told_apart};

const LEVELS: f64 = 255.0;

fn close(got: f64, expected: f64, by: f64) {
    assert!((got - expected).abs() <= by, "{got}, not {expected}");
}

fn gray(code: u8) -> Color {
    Color::rgb(code, code, code)
}

fn share(corners: [Vec2; 3]) -> f64 {
    area(corners, IVec2::ZERO)
}

#[test]
fn seven_sixteenths() {
    close(share(CUT), 7.0 / 16.0, 1e-6);
    assert_eq!((LEVELS * share(CUT)).round(), 112.0);
    // By the table: sixteenths, crosswise.
    let corners: Vec<Vec2> =
        clipped(CUT, IVec2::ZERO).corners().iter().map(|corner| corner.position.xy()).collect();
    let mut crosses: Vec<f32> =
        (0..corners.len()).map(|i| 16.0 * corners[i].perp_dot(corners[(i + 1) % corners.len()])).collect();
    crosses.sort_by(f32::total_cmp);
    assert_eq!(crosses, [-3.0, -3.0, 4.0, 4.0, 12.0]);
}

/// Below the line from (0, ¼) to (1, ¾).
#[test]
fn the_mean_of_two_heights() {
    let below = [Vec2::new(-2.0, -0.75), Vec2::new(4.0, 2.25), Vec2::new(1.0, -9.0)];
    close(share(below), 0.5, 1e-6);
}

#[test]
fn a_quarter_shines_through() {
    for share in [0.1, 0.3, 0.5, 0.8] {
        let (a, b) = (share, 1.0 - share);
        close(1.0 - (1.0 - a) * (1.0 - b), 1.0 - a * b, 1e-12);
        assert!((1.0 - a) * (1.0 - b) <= 0.25);
    }
}

/// Of the round coin: the four sums, the mask, its share, and what the pixel shows.
#[test]
fn a_coin_in_the_corner() {
    let sums: Vec<i32> = pattern(4).iter().map(|[x, y]| x * x + y * y).collect();
    assert_eq!(sums, [232, 296, 40, 104]);
    let mask: u32 = (0..).zip(&sums).map(|(s, &sum)| u32::from(sum < 144) << s).sum();
    assert_eq!(mask, 0b1100);
    let quarter = std::f64::consts::FRAC_PI_4 * 9.0 / 16.0;
    close(quarter, 0.44, 0.005);
    let samples: Vec<Color> =
        (0..4).map(|s| if mask >> s & 1 == 1 { Color::WHITE } else { gray(40) }).collect();
    assert_eq!(resolve(&samples), gray(148));
    assert_eq!((quarter * 255.0 + (1.0 - quarter) * 40.0).floor(), 134.0);
}

#[test]
fn means_of_codes() {
    let codes = [200, 200, 10, 11];
    assert_eq!(resolve(&codes.map(gray)), gray(105));
    assert_eq!(codes.map(u32::from).iter().sum::<u32>(), 421);
    assert_eq!((421 + 2) / 4, 105);
}

/// How far the samples below a height are from it, in levels: the largest, the mean and the root of the mean square.
fn off(places: &[[i32; 2]]) -> [f64; 3] {
    const HEIGHTS: usize = 16_000;
    let (mut largest, mut sum, mut squares) = (0.0_f64, 0.0, 0.0);
    for n in 0..HEIGHTS {
        let height = (n as f64 + 0.5) / HEIGHTS as f64;
        let below = places.iter().filter(|[_, y]| f64::from(*y) / 16.0 < height).count();
        let error = LEVELS * (below as f64 / places.len() as f64 - height);
        largest = largest.max(error.abs());
        sum += error;
        squares += error * error;
    }
    [largest, sum / HEIGHTS as f64, (squares / HEIGHTS as f64).sqrt()]
}

#[test]
fn level_sides() {
    for samples in [2, 4, 8] {
        let [largest, mean, rms] = off(pattern(samples));
        close(largest, LEVELS / (2.0 * samples as f64), 0.1);
        close(mean, 0.0, 0.01);
        close(rms, LEVELS / (samples as f64 * 12_f64.sqrt()), 0.01);
    }
    close(off(pattern(4))[2], 18.0, 0.5);
    close(off(&grid())[2], off(pattern(4))[2], 0.01);
    // The one of 16 is too low by half a sample in the mean, and no better than the one of eight.
    let [_, mean, rms] = off(pattern(16));
    close(mean, -8.0, 0.05);
    close(LEVELS / (16.0 * 12_f64.sqrt()), 4.6, 0.05);
    close(rms, 9.2, 0.05);
    close(rms, off(pattern(8))[2], 0.05);
    // By chance.
    close(LEVELS * (0.25_f64 / 16.0).sqrt(), 32.0, 0.2);
}

/// Each pattern has a sample in each row and each column of its own.
#[test]
fn rooks_do_not_attack_each_other() {
    for samples in [1, 2, 4, 8, 16] {
        for axis in [0, 1] {
            let mut all: Vec<i32> = pattern(samples).iter().map(|at| at[axis]).collect();
            all.sort_unstable();
            all.dedup();
            assert_eq!(all.len(), samples);
        }
    }
}

/// The table of moments, by counting.
#[test]
fn chains_of_the_grid() {
    for (q, p, moments) in [(1, 0, 4), (1, 1, 7), (2, 1, 10), (3, 1, 13), (3, 2, 14), (4, 1, 16), (5, 2, 16)]
    {
        let mut met: Vec<i32> = grid().iter().map(|[x, y]| p * x - q * y).collect();
        met.sort_unstable();
        met.dedup();
        assert_eq!(met.len(), moments);
        assert_eq!(16 - (4 - p).max(0) * (4 - q).max(0), moments as i32);
    }
}

#[test]
fn greys_told_apart() {
    assert_eq!(
        [grid(), pattern(16).to_vec(), pattern(4).to_vec()].map(|places| told_apart(&places, 0.0)),
        [5, 17, 5]
    );
    // Up to 3.6 degrees the grid has five.
    close((1.0_f64 / 16.0).asin().to_degrees(), 3.6, 0.05);
    assert!(told_apart(&grid(), 3.5) == 5 && told_apart(&grid(), 3.7) > 5);
    // Two up for one to the right: three greys.
    assert_eq!(told_apart(pattern(4), 2_f32.atan().to_degrees()), 3);
    assert_eq!(told_apart(pattern(4), 45.0), 5);
    close(0.5_f64.atan().to_degrees(), 26.6, 0.05);
}

/// The pixels of which a right triangle covers something, and those whose centre it covers.
fn touched(side: f32) -> (f64, f64) {
    let (mut touched, mut area) = (0.0, 0.0);
    let steps = 5;
    for n in 0..steps * steps {
        let from = Vec2::new((n % steps) as f32, (n / steps) as f32) / steps as f32 + 0.07;
        let corners = [from, from + Vec2::X * side, from + Vec2::Y * side];
        let last = side as i32 + 2;
        for (x, y) in (0..last).flat_map(|y| (0..last).map(move |x| (x, y))) {
            let share = antialiasing::area::area(corners, IVec2::new(x, y));
            touched += f64::from(u8::from(share > 0.0));
            area += share;
        }
    }
    let all = f64::from(steps * steps);
    (touched / all, area / all)
}

#[test]
fn what_a_side_touches() {
    for side in [10.0, 40.0] {
        let (touched, area) = touched(side);
        close(area, f64::from(side * side) / 2.0, 0.1);
        // The corners are a few pixels more or less.
        close(touched / area, 1.0 + 4.0 / f64::from(side), 8.0 / f64::from(side * side));
    }
    // 20,000 of them in 800 × 800 pixels.
    let area: f64 = 640_000.0 / 20_000.0;
    let side = (2.0 * area).sqrt();
    assert_eq!((area, side, 1.0 + 4.0 / side), (32.0, 8.0, 1.5));
    let s: f64 = 100.0;
    close(4.0 * s / (s * s / 2.0 + 2.0 * s), 0.08, 0.005);
}

#[test]
fn weights_beyond_a_side() {
    let farthest = pattern(16)
        .iter()
        .map(|[x, y]| f64::from((x - 8) * (x - 8) + (y - 8) * (y - 8)).sqrt() / 16.0)
        .fold(0.0, f64::max);
    close(farthest, 0.66, 0.005);
    close(-farthest / 0.1, -6.6, 0.05);
    // A quarter of a pixel high, half a pixel below the base: the tip's weight.
    let corners = [Vec2::new(0.3, 0.25), Vec2::ZERO, Vec2::X];
    let weights = triangles::barycentric::weights(corners, Vec2::new(0.4, -0.5)).unwrap();
    close(f64::from(weights.x), -2.0, 1e-6);
}

/// The mean of places in a triangle is in it.
#[test]
fn the_centroid_is_inside() {
    let places = pattern(16);
    let corners = [Vec2::new(-0.75, 0.56), Vec2::new(1.53, 0.66), Vec2::new(1.25, 1.07)];
    let mask = coverage(corners, IVec2::ZERO, places);
    let covered: Vec<Vec2> = (0..16)
        .filter(|s| mask >> s & 1 == 1)
        .map(|s| Vec2::new(places[s][0] as f32, places[s][1] as f32) / 16.0)
        .collect();
    let mean = covered.iter().sum::<Vec2>() / covered.len() as f32;
    let weights = |at| triangles::barycentric::weights(corners, at).unwrap();
    assert!(covered.len() > 1 && weights(mean).min_element() >= 0.0);
    assert!(weights(Vec2::splat(0.5)).min_element() < 0.0);
}

#[test]
fn of_codes_and_of_light() {
    let light = |code: f64| {
        let c = code / LEVELS;
        if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    };
    let mean = |codes: &[u8]| {
        let sum: common::Vec4 = codes.iter().map(|&code| SRGB.light(gray(code))).sum();
        SRGB.color(sum / codes.len() as f32).r
    };
    assert_eq!([mean(&[108, 148]), mean(&[28, 228]), mean(&[0, 255])], [130, 168, 188]);
    assert_eq!([mean(&[255, 0, 0, 0]), resolve(&[255, 0, 0, 0].map(gray)).r], [137, 64]);
    // The square of the contrast: the difference of the two means, for little contrast.
    let derivative = |code: f64| (light(code + 1.0) - light(code - 1.0)) / 2.0;
    let second = light(129.0) - 2.0 * light(128.0) + light(127.0);
    close(200.0 * second / derivative(128.0), 1.95, 0.15);
    close(light(128.0), 0.22, 0.005);
}

/// Two leaves of half alpha, one behind the other.
#[test]
fn two_leaves() {
    let mask = alpha_to_coverage(128, 16);
    assert_eq!(mask.count_ones(), 8);
    assert_eq!((mask & !mask).count_ones(), 0, "what the one behind has that the first one has not");
    for alpha in 0..=255_u8 {
        let share = f64::from(alpha_to_coverage(alpha, 16).count_ones()) / 16.0;
        close(share, f64::from(alpha) / LEVELS, 1.0 / 32.0 + 1e-6);
    }
}

#[test]
fn bytes() {
    let bytes = |width: u64, height: u64, samples: u64| {
        (size_of::<Color>() + size_of::<f32>()) as u64 * samples * width * height
    };
    assert_eq!([bytes(800, 800, 16), bytes(800, 800, 1)].map(|n| n / 1_000_000), [81, 5]);
    assert_eq!(bytes(800, 800, 16), 81_920_000);
    assert_eq!(bytes(1920, 1080, 16), 265_420_800);
    close((3 * 60 * bytes(1920, 1080, 16)) as f64 / 1e9, 48.0, 0.5);
}
