//! Where in a pixel a fragment is shaded, and how often.

use antialiasing::multisampled::{Multisampled, PerCenter, PerPixel, PerSample, Shading};
use antialiasing::storage::Samples;
use antialiasing::{Canvas, pattern};
use blending::State;
use checks::coverage::Triangle;
use common::{Color, DVec2, DVec3, Vec2, Vec4};
use fastrand::Rng;
use shaders::shader::Varying;

/// Width and height of the picture.
const SIZE: [usize; 2] = [11, 7];

/// The pixels of a triangle that are shaded, with what was interpolated there, each as often as it was.
fn shaded<const N: usize, H: Shading, V: Varying>(
    corners: [Vec4; 3],
    varyings: [V; 3],
) -> Vec<([i32; 2], V)> {
    let mut canvas = Multisampled::<N, Samples<N>, H>::new(SIZE);
    let mut all = Vec::new();
    canvas.fill(State::OFF, corners, varyings, |fragment| {
        all.push(([fragment.x, fragment.y], fragment.varying));
        Some(Color::WHITE)
    });
    all
}

fn pixels() -> impl Iterator<Item = [i32; 2]> {
    (0..SIZE[1] as i32).flat_map(|y| (0..SIZE[0] as i32).map(move |x| [x, y]))
}

/// Corners about the picture, on 1/256 px, and with each a depth before the eye from 1 to 8.
fn any_triangle(rng: &mut Rng) -> [Vec4; 3] {
    [(); 3].map(|()| {
        let [x, y] = [(-1024..3840), (-1024..2816)].map(|range| rng.i32(range) as f32 / 256.0);
        Vec4::new(x, y, 0.5, 1.0 / (1.0 + 7.0 * rng.f32()))
    })
}

/// The sample places of a pixel that a triangle covers, in px from the picture's lower left corner.
fn covered(triangle: &Triangle, [x, y]: [i32; 2], n: usize) -> Vec<[i32; 2]> {
    let mask = triangle.samples(x, y, pattern(n));
    (0..n).filter(|s| mask >> s & 1 == 1).map(|s| pattern(n)[s]).collect()
}

/// The weights in perspective at the mean of some places of a pixel, in f64.
fn weights(triangle: &Triangle, corners: [Vec4; 3], [x, y]: [i32; 2], places: &[[i32; 2]]) -> DVec3 {
    let at = |&[right, up]: &[i32; 2]| {
        DVec3::from_array(triangle.weights_at([(x * 256 + right * 16).into(), (y * 256 + up * 16).into()]))
    };
    let mean: DVec3 = places.iter().map(at).sum::<DVec3>() / places.len() as f64;
    let scaled = mean * DVec3::from_array(corners.map(|corner| corner.w.into()));
    scaled / scaled.element_sum()
}

/// How far two points are apart.
fn apart(got: Vec2, exact: DVec2) -> f64 {
    (got.as_dvec2() - exact).length()
}

/// Of a varying that is whatever it is at three corners, with what it should be at each shaded pixel: `pick` chooses the places
/// in whose middle that is.
fn check<const N: usize, H: Shading>(seed: u64, pick: impl Fn(bool, Vec<[i32; 2]>) -> Vec<Vec<[i32; 2]>>) {
    let mut rng = Rng::with_seed(seed);
    let mut parts = 0;
    for _ in 0..300 {
        let corners = any_triangle(&mut rng);
        let varyings = [(); 3].map(|()| Vec2::new(rng.f32(), rng.f32()));
        let triangle = Triangle::new(corners.map(|corner| Vec2::new(corner.x, corner.y)));
        let mut expected = Vec::new();
        for pixel in pixels() {
            let inside = covered(&triangle, pixel, N);
            if !inside.is_empty() {
                parts += usize::from(inside.len() < N);
                let center = triangle.covers(pixel[0], pixel[1]);
                expected.extend(pick(center, inside).into_iter().map(|places| (pixel, places)));
            }
        }
        let got = shaded::<N, H, Vec2>(corners, varyings);
        assert_eq!(got.len(), expected.len(), "{corners:?}");
        for ((pixel, varying), (expected, places)) in got.into_iter().zip(expected) {
            assert_eq!(pixel, expected);
            let mu = weights(&triangle, corners, pixel, &places);
            // Slivers extrapolate far, where 1/w may pass 0.
            let exact: DVec2 = (0..3).map(|n| varyings[n].as_dvec2() * mu[n]).sum();
            let reach = mu.abs().max_element();
            if reach < 100.0 {
                assert!(
                    apart(varying, exact) < 2e-5 * reach * reach,
                    "{corners:?}, {pixel:?}: {varying}, not {exact}"
                );
            }
        }
    }
    assert!(N == 1 || parts > 500, "{parts}");
}

const CENTER: [i32; 2] = [8, 8];

/// Once a pixel: at its centre, if that is covered, else at the centroid of the samples that are.
#[test]
fn a_pixel_is_shaded_once_at_its_centre_or_at_the_centroid() {
    let pick = |center: bool, inside: Vec<[i32; 2]>| vec![if center { vec![CENTER] } else { inside }];
    check::<1, PerPixel>(1, pick);
    check::<2, PerPixel>(2, pick);
    check::<4, PerPixel>(3, pick);
    check::<8, PerPixel>(4, pick);
    check::<16, PerPixel>(5, pick);
}

#[test]
fn supersampling_shades_at_each_covered_sample() {
    let pick = |_: bool, inside: Vec<[i32; 2]>| inside.into_iter().map(|place| vec![place]).collect();
    check::<4, PerSample>(6, pick);
    check::<16, PerSample>(7, pick);
}

#[test]
fn centre_shading_is_at_the_centre_inside_or_not() {
    let pick = |_: bool, _: Vec<[i32; 2]>| vec![vec![CENTER]];
    check::<4, PerCenter>(8, pick);
    check::<16, PerCenter>(9, pick);
}

/// A brightness from 0.2 to 0.8 at the corners stays between them at the centroid; at the centre it may be anything.
#[test]
fn what_the_centre_shows_may_be_no_corners() {
    fn range<H: Shading>(corners: [Vec4; 3]) -> [f32; 2] {
        let all = shaded::<16, H, f32>(corners, [0.2, 0.8, 0.5]);
        all.iter().fold([f32::MAX, f32::MIN], |[low, high], &(_, value)| [low.min(value), high.max(value)])
    }
    let mut rng = Rng::with_seed(10);
    let mut worst = [0.0_f32; 2];
    for _ in 0..2000 {
        let corners = any_triangle(&mut rng).map(|corner| corner.with_w(1.0));
        for [low, high] in [range::<PerPixel>(corners), range::<PerSample>(corners)] {
            assert!(low >= 0.2 - 1e-5 && high <= 0.8 + 1e-5, "{corners:?}: {low} to {high}");
        }
        let [low, high] = range::<PerCenter>(corners);
        worst = [worst[0].max(0.2 - low), worst[1].max(high - 0.8)];
    }
    assert!(worst.iter().all(|&beyond| beyond > 1.0), "{worst:?}");

    // A sliver along the bottom of a row of pixels, 1/8 px high: at the centres, half a pixel up, brightness has risen four
    // times as far as from one of its sides to the corner above.
    let sliver = [[-1.0, 3.0], [12.0, 3.0], [12.0, 3.125]].map(|[x, y]| Vec4::new(x, y, 0.5, 1.0));
    let all = |varyings| shaded::<16, PerCenter, f32>(sliver, varyings);
    let seen = all([0.2, 0.2, 0.8]);
    assert!(!seen.is_empty());
    for ([_, y], value) in seen {
        assert_eq!(y, 3);
        assert!((value - (0.2 + 0.6 * 4.0)).abs() < 1e-4, "{value}");
    }
    assert!(range::<PerPixel>(sliver)[1] <= 0.8);
}

/// What is not seen is not shaded: a pixel all of whose samples are hidden, or outside.
#[test]
fn what_is_hidden_is_not_shaded() {
    fn counts<H: Shading>() -> [usize; 3] {
        let mut canvas = Multisampled::<16, Samples<16>, H>::new(SIZE);
        let mut count = |corners: [[f32; 2]; 3], depth: f32| {
            let mut calls = 0;
            let corners = corners.map(|[x, y]| Vec4::new(x, y, depth, 1.0));
            canvas.fill(State::OFF, corners, [(); 3], |_| {
                calls += 1;
                Some(Color::WHITE)
            });
            calls
        };
        // All but one sample of the pixel (4, 3) is covered, then everything from behind, then from behind again.
        let large = [[-9.0, -9.0], [60.0, -9.0], [-9.0, 60.0]];
        // Its leftmost sample is at the border, the next 1/16 px to the right: sample 12 at 0, sample 15 at 1/16.
        [count([[4.03, -50.0], [90.0, 3.0], [4.03, 56.0]], 0.25), count(large, 0.5), count(large, 0.75)]
    }
    // 7 columns from 4 on; behind them only the column's left sample is seen, once a pixel in each of 7 rows.
    assert_eq!(counts::<PerPixel>(), [7 * 7, 7 * 4 + 7, 0]);
    assert_eq!(counts::<PerSample>(), [7 * 7 * 16 - 7, 7 * 4 * 16 + 7, 0]);
}

/// A fragment that the shader discards leaves colours and depths as they were.
#[test]
fn what_is_discarded_leaves_nothing_behind() {
    let mut canvas = Multisampled::<4, Samples<4>>::new(SIZE);
    let large =
        |depth: f32| [[-9.0, -9.0], [60.0, -9.0], [-9.0, 60.0]].map(|[x, y]| Vec4::new(x, y, depth, 1.0));
    canvas.fill(State::OFF, large(0.25), [(); 3], |_| None);
    assert!(canvas.depths.iter().flatten().all(|&depth| depth == 1.0));
    canvas.fill(State::OFF, large(0.75), [(); 3], |fragment| (fragment.x > 4).then_some(Color::WHITE));
    let kept = canvas.depths.iter().enumerate().map(|(n, depths)| (n % SIZE[0] > 4, depths));
    assert!(
        kept.into_iter()
            .all(|(drawn, depths)| depths.iter().all(|&depth| depth == if drawn { 0.75 } else { 1.0 }))
    );
}
