//! The share of each pixel that `area` finds, against rational numbers.

use antialiasing::area::{Area, area, clipped, fill};
use antialiasing::multisampled::Multisampled;
use antialiasing::storage::Samples;
use antialiasing::{Canvas, METHODS, resolve};
use blending::{Compare, DepthTest, Over, State, TwoShift, over};
use checks::area::area as exact;
use common::{Bounds, Color, Format, IVec2, Image, Vec2, Vec3, Vec4};
use proptest::prelude::*;
use verify::{method, window};
use zbuffer::Surface;

use crate::scenes::{Scene, codes, flat, right_of};

const SIDE: i32 = 24;

/// What cuts, rounded to `f32`, may move in a picture 24 px wide: 2⁻²⁰ px at each of four sides.
const SLACK: f64 = 4e-6;

/// Corners about the window: anywhere, on whole pixels, on 1/256 px.
fn corner() -> impl Strategy<Value = Vec2> {
    let coordinate = || {
        prop_oneof![
            -8.0f32..32.0,
            (-8..32).prop_map(|n| n as f32),
            (-2048..8192).prop_map(|n| n as f32 / 256.0)
        ]
    };
    (coordinate(), coordinate()).prop_map(Vec2::from)
}

/// Corners up to 8 million px away.
fn far_corner() -> impl Strategy<Value = Vec2> {
    let coordinate = || {
        let scale = prop_oneof![Just(1e2f32), Just(1e4), Just(1e5), Just(1e6), Just(8e6)];
        prop_oneof![(scale, -1.0f32..1.0).prop_map(|(scale, c)| scale * c), -8.0f32..32.0]
    };
    (coordinate(), coordinate()).prop_map(Vec2::from)
}

/// The share of each pixel of the window, rows from the bottom; and the weights there.
fn shares(corners: [Vec2; 3]) -> Vec<(f64, Vec3)> {
    let mut all = vec![(0.0, Vec3::ZERO); (SIDE * SIDE) as usize];
    fill(corners, window(SIDE, SIDE), |x, y, share, weights| {
        let pixel = &mut all[(y * SIDE + x) as usize];
        assert!(pixel.0 == 0.0 && share > 0.0, "({x}, {y}) twice, or for nothing");
        *pixel = (share, weights);
    });
    all
}

fn pixels() -> impl Iterator<Item = (i32, i32)> {
    (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Every pixel's share is its area, and what is left out is as good as nothing.
    #[test]
    fn shares_are_areas(corners in prop_oneof![[corner(), corner(), corner()], [far_corner(), far_corner(), far_corner()]]) {
        let shares = shares(corners);
        for (x, y) in pixels() {
            let (share, weights) = shares[(y * SIDE + x) as usize];
            let exact = exact(corners, x, y);
            prop_assert!((share - exact).abs() < SLACK, "({x}, {y}): {share}, not {exact}");
            // A pixel by itself is the same but for pixels that are covered whole, which are not cut at all.
            let alone = area(corners, IVec2::new(x, y));
            prop_assert!(share == alone || (share == 1.0 && (alone - 1.0).abs() < SLACK), "({x}, {y}): {share}, {alone}");
            let [low, high] = [weights.min_element(), weights.max_element()];
            prop_assert!(share == 0.0 || (low >= -1e-5 && high <= 1.0 + 1e-5), "({x}, {y}): {weights}");
            prop_assert!(share == 0.0 || (weights.element_sum() - 1.0).abs() < 1e-5, "({x}, {y}): {weights}");
        }
    }

    /// At the far corner of a picture 1024 px wide a share is off by a fiftieth of a grey level at most.
    #[test]
    fn shares_are_areas_far_from_the_origin(corners in [corner(), corner(), corner()], x in 0..SIDE, y in 0..SIDE) {
        let far = corners.map(|corner| corner + 1000.0);
        let off = area(far, IVec2::new(x, y) + 1000) - exact(far, x + 1000, y + 1000);
        prop_assert!(off.abs() < 1.0 / 50.0 / 255.0, "{off}");
    }

    /// What is linear on the triangle has the same mean in parts as on the whole: a third of each corner.
    #[test]
    fn weights_are_those_of_the_centroid(corners in [corner(), corner(), corner()]) {
        let mut sums = [0.0; 4];
        fill(corners, Bounds { min: IVec2::splat(-9), max: IVec2::splat(33) }, |_, _, share, weights| {
            (0..3).for_each(|n| sums[n] += share * f64::from(weights[n]));
            sums[3] += share;
        });
        for n in 0..3 {
            prop_assert!((sums[n] - sums[3] / 3.0).abs() < 1e-5 * sums[3] + 1e-6, "{sums:?}");
        }
    }

    /// Where a pixel is covered whole it is seen as lesson 3 sees it, to the last bit.
    #[test]
    fn whole_pixels_are_those_of_lesson_3(corners in [corner(), corner(), corner()]) {
        let shares = shares(corners);
        triangles::fill(corners, window(SIDE, SIDE), |x, y, weights| {
            let (share, own) = shares[(y * SIDE + x) as usize];
            assert!(share > 0.0 && (share < 1.0 || own == weights), "({x}, {y}): {share}");
        });
        for (x, y) in pixels() {
            prop_assert!(exact(corners, x, y) < 1.0 || shares[(y * SIDE + x) as usize].0 == 1.0, "({x}, {y})");
        }
    }

    /// Neither the order of the corners nor the way they run matters, but for rounding.
    #[test]
    fn the_order_of_the_corners_does_not_matter(corners in [corner(), corner(), corner()]) {
        let expected = shares(corners);
        for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let got = shares(order.map(|n: usize| corners[n]));
            prop_assert!(expected.iter().zip(&got).all(|(a, b)| (a.0 - b.0).abs() < SLACK), "{order:?}");
        }
    }

    /// A part is a convex polygon in the pixel's square, of seven corners at most.
    #[test]
    fn a_part_lies_in_its_pixel((a, b, c) in (far_corner(), corner(), corner()), x in -8..32, y in -8..32) {
        let part = clipped([a, b, c], IVec2::new(x, y));
        prop_assert!(part.corners().len() <= 7);
        for corner in part.corners() {
            let off = [corner.position.x - x as f32, corner.position.y - y as f32];
            prop_assert!(off.iter().all(|n| (-1e-5..=1.0 + 1e-5).contains(n)), "{corner:?}");
        }
    }

    /// Whatever numbers it is given, nothing is drawn outside of the bounds, and nothing panics.
    #[test]
    fn nothing_is_drawn_outside(corners in any::<[f32; 6]>(), near in [corner(), corner()]) {
        let [a, b, c] = [0, 2, 4].map(|n| Vec2::new(corners[n], corners[n + 1]));
        let bounds = Bounds { min: IVec2::new(3, 2), max: IVec2::new(12, 9) };
        for corners in [[a, b, c], [a, b, near[0]], [a, near[0], near[1]]] {
            fill(corners, bounds, |x, y, share, _| {
                assert!(bounds.contains(x, y) && share > 0.0 && share <= 1.0 + SLACK, "({x}, {y}): {share}");
            });
        }
    }
}

/// Where it has no area, or a corner is nowhere, a triangle covers nothing; beyond 2⁵² px, too, as in lesson 3.
#[test]
fn what_has_no_area_covers_nothing() {
    let [a, b, c] = [(1.0, 1.0), (9.0, 5.0), (5.0, 3.0)].map(Vec2::from);
    for corners in [
        [a, b, c],
        [a, a, b],
        [a; 3],
        [a, b, Vec2::NAN],
        [a, b, Vec2::new(f32::INFINITY, 0.0)],
        [a, b, Vec2::new(0.0, 5e15)],
        // Less than 1/512 px apart.
        [a, b, a + 0.0015],
    ] {
        assert!(shares(corners).iter().all(|pixel| pixel.0 == 0.0), "{corners:?}");
    }
    assert!(shares([a, b, Vec2::new(0.0, 4e15)]).iter().any(|pixel| pixel.0 > 0.0));
}

/// Neighbours cover each pixel once in all: of a square about the window, cut into a fan about any point.
#[test]
fn neighbours_add_up_to_the_pixel() {
    let rim =
        [(-1.0, -2.0), (13.37, -1.5), (27.0, -2.0), (26.0, 25.0), (9.1, 26.0), (-3.0, 25.0)].map(Vec2::from);
    for hub in [(7.0, 9.0), (11.3, 20.7), (0.004, 0.004)].map(Vec2::from) {
        let mut sums = vec![0.0; (SIDE * SIDE) as usize];
        for n in 0..rim.len() {
            let triangle = [hub, rim[n], rim[(n + 1) % rim.len()]];
            shares(triangle).iter().zip(&mut sums).for_each(|(pixel, sum)| *sum += pixel.0);
        }
        assert!(sums.iter().all(|sum| (sum - 1.0).abs() < SLACK), "{hub}: {sums:?}");
    }
}

/// Where a side divides a pixel into shares s and 1 − s, the two triangles there leave s(1 − s) of the background: up to a
/// quarter of its light, to within the rounding of each share to 255ths. Samples leave nothing.
#[test]
fn a_quarter_of_the_background_shines_through_a_common_side() {
    for k in 0..=16 {
        let x = 4.0 + k as f32 / 16.0;
        let left = [[x, -50.0], [x, 56.0], [-90.0, 3.0]];
        let triangles = [left, right_of(x)].map(|corners| flat(corners, 0.5, Color::BLACK)).to_vec();
        let scene = Scene { size: [9, 7], background: Color::WHITE, triangles };
        let share = f64::from(k) / 16.0;
        for method in METHODS {
            let image = scene.drawn(&method.run);
            for (x, y) in scene.pixels() {
                let got = codes(image.get(x, y).unwrap());
                let leaks = method.name == "area" && x == 4;
                let expected = if leaks { 255.0 * share * (1.0 - share) } else { 0.0 };
                assert!(
                    (got[0] - expected).abs() <= if leaks { 1.0 } else { 0.0 },
                    "{}, {k}: {got:?}",
                    method.name
                );
            }
        }
    }
}

/// Where a near triangle covers a part of a pixel no depth is kept: what lies behind and comes later takes all of the pixel,
/// and what comes before is hidden as it should be.
#[test]
fn what_is_hidden_shines_through_where_a_pixel_is_covered_in_part() {
    let near = flat(right_of(4.25), 0.25, Color::BLACK);
    let far = flat(right_of(-9.0), 0.75, Color::WHITE);
    let area = |triangles: [Surface; 2]| {
        let scene = Scene { size: [9, 1], background: Color::RED, triangles: triangles.to_vec() };
        let image = scene.drawn(method(METHODS, "area"));
        [3, 4, 5].map(|x| image.get(x, 0).unwrap().r)
    };
    // A quarter of the pixel is white, as it should be; then all of it.
    assert_eq!(area([far, near]), [255, 64, 0]);
    assert_eq!(area([near, far]), [255, 255, 0]);
}

/// Alpha as coverage is a share of the share.
#[test]
fn alpha_to_coverage_is_a_share_of_the_share() {
    let mut canvas = Area::new([9, 7]);
    canvas.clear(Color::WHITE, true);
    let corners = right_of(4.5).map(|[x, y]| Vec4::new(x, y, 0.5, 1.0));
    canvas.fill(State::OFF, corners, [(); 3], |_| Some(Color { a: 102, ..Color::BLACK }));
    let mut image = Image::new(9, 7, Format::Rgb);
    canvas.resolve(resolve, &mut image);
    // 102 of 255 is 2/5: of a whole pixel, and of half a pixel.
    assert_eq!([3, 4, 5].map(|x| image.get(x, 3).unwrap().r), [255, 204, 153]);
    // A depth is kept where all of a pixel is covered, by opaque colours.
    assert!(canvas.depths(&image).bounds() == image.bounds());
    assert_eq!([4, 5].map(|x| canvas.depths(&image).get(x, 3)), [1.0, 1.0]);
    canvas.fill(State::OFF, corners, [(); 3], |_| Some(Color::BLACK));
    assert_eq!([4, 5].map(|x| canvas.depths(&image).get(x, 3)), [1.0, 0.5]);
    canvas.clear(Color::WHITE, false);
    assert_eq!(canvas.depths(&image).get(5, 3), 1.0);
}

/// The state of lesson 14 is asked: for the test, for what becomes of the colour, and whether a depth is kept.
#[test]
fn an_area_is_drawn_under_a_state() {
    let corners = right_of(4.5).map(|[x, y]| Vec4::new(x, y, 0.5, 1.0));
    let (background, red) = (Color::rgb(0, 40, 200), Color { a: 100, ..Color::RED });
    let mut canvas = Area::new([9, 7]);
    canvas.clear(background, false);
    let always = DepthTest { function: Compare::Always, write: false };
    let state =
        State { scissor: (), stencil: (), depth: always, blend: Over::<TwoShift>::default(), mask: () };
    canvas.fill(state, corners, [(); 3], |_| Some(red));
    let mut image = Image::new(9, 7, Format::Rgb);
    canvas.resolve(resolve, &mut image);
    // Where half of a pixel is covered, half of what blending makes.
    let over = over(red, background);
    let expected = [background, background.mixed(over, 128), over];
    assert_eq!([3, 4, 5].map(|x| image.get(x, 3).unwrap()), expected);
    assert_eq!(canvas.depths(&image).get(7, 3), 1.0);
}

/// Attributes are interpolated in perspective, with the weights of the centroid in the picture; where all of a pixel is covered
/// they are those of one sample, to the last bit.
#[test]
fn what_an_area_shows_is_interpolated_in_perspective() {
    let corners =
        [[0.3, 0.6, 1.0], [8.6, 1.2, 0.125], [2.1, 6.7, 0.5]].map(|[x, y, w]| Vec4::new(x, y, 0.5, w));
    let varyings = [Vec2::new(0.0, 3.0), Vec2::new(7.0, -2.0), Vec2::new(1.0, 9.0)];
    let (mut seen, mut one) = (Vec::new(), Vec::new());
    Area::new([9, 7]).fill(State::OFF, corners, varyings, |fragment| {
        seen.push((fragment.x, fragment.y, fragment.varying));
        None
    });
    Multisampled::<1, Samples<1>>::new([9, 7]).fill(State::OFF, corners, varyings, |fragment| {
        one.push((fragment.x, fragment.y, fragment.varying));
        None
    });
    let mut whole = 0;
    let mut fragments = seen.into_iter();
    fill(corners.map(|corner| Vec2::new(corner.x, corner.y)), window(9, 7), |x, y, share, weights| {
        let (at_x, at_y, varying) = fragments.next().unwrap();
        assert_eq!((at_x, at_y), (x, y));
        let scaled = [0, 1, 2].map(|n: usize| f64::from(weights[n]) * f64::from(corners[n].w));
        let sum: f64 = scaled.iter().sum();
        for axis in 0..2 {
            let exact: f64 = (0..3).map(|n| scaled[n] / sum * f64::from(varyings[n][axis])).sum();
            assert!((f64::from(varying[axis]) - exact).abs() < 1e-5, "({x}, {y}): {varying}, not {exact}");
        }
        if share == 1.0 {
            whole += 1;
            assert!(one.contains(&(x, y, varying)), "({x}, {y})");
        }
    });
    assert!(fragments.next().is_none() && whole > 10);
}
