//! The four hopes of the slides as properties of `edges`: symmetric, independent of the corners' order, no
//! hole and no doubled pixel between neighbours; and simply right.

use checks::coverage::Triangle;
use common::{Bounds, IVec2, Vec2, Vec3};
use proptest::prelude::*;
use triangles::edges::Setup;
use triangles::{METHODS, fill};
use verify::window;

/// Corners about a window of 24 px: anywhere, on whole and half pixels, and on 1/256 px.
fn corner() -> impl Strategy<Value = Vec2> {
    let coordinate = || {
        prop_oneof![
            -8.0f32..32.0,
            (-8..32).prop_map(|n| n as f32),
            (-16..64).prop_map(|n| n as f32 / 2.0),
            (-2048..8192).prop_map(|n| n as f32 / 256.0),
        ]
    };
    (coordinate(), coordinate()).prop_map(Vec2::from)
}

/// Corners as far out as f32 goes, most of them where the lesson promises to be exact.
fn far_corner() -> impl Strategy<Value = Vec2> {
    let coordinate = || {
        let scale = prop_oneof![Just(1e2f32), Just(1e4), Just(1e6), Just(1e7), Just(1e12), Just(4e15)];
        prop_oneof![(scale, -1.0f32..1.0).prop_map(|(scale, c)| scale * c), -8.0f32..32.0]
    };
    (coordinate(), coordinate()).prop_map(Vec2::from)
}

/// A coordinate to lie about: in the window, where `edges` changes integers, at the ends of i32, beyond.
fn base() -> impl Strategy<Value = f32> {
    let far = [1 << 16, 1 << 20, 1 << 24, 1 << 31, 1_u64 << 40].map(|n| n as f32);
    prop_oneof![
        Just(12.0),
        (prop::sample::select(far.to_vec()), any::<bool>()).prop_map(|(base, negative)| if negative {
            -base
        } else {
            base
        })
    ]
}

/// Any bounds, many of them empty, many as large as can be.
fn any_bounds() -> impl Strategy<Value = Bounds> {
    let coordinate = || prop_oneof![any::<i32>(), -8..32, Just(i32::MIN), Just(i32::MAX)];
    let any = [coordinate(), coordinate(), coordinate(), coordinate()]
        .prop_map(|[x0, y0, x1, y1]| Bounds { min: IVec2::new(x0, y0), max: IVec2::new(x1, y1) });
    prop_oneof![any, Just(Bounds::EVERYTHING)]
}

fn pixels(corners: [Vec2; 3], bounds: Bounds) -> Vec<(i32, i32)> {
    let mut pixels = Vec::new();
    fill(corners, bounds, |x, y, _| pixels.push((x, y)));
    pixels
}

/// How often each pixel of a window is covered, all triangles together.
fn counts(triangles: &[[Vec2; 3]], width: i32, height: i32) -> Vec<u32> {
    let mut counts = vec![0; (width * height) as usize];
    for &triangle in triangles {
        fill(triangle, window(width, height), |x, y, _| counts[(y * width + x) as usize] += 1);
    }
    counts
}

/// A rectangle of 20×14 px cut into fields whose inner corners are moved about, each field cut in two.
fn tiled_grid() -> impl Strategy<Value = Vec<[Vec2; 3]>> {
    let (columns, rows) = (5, 4);
    // Below a quarter of a field no field loses its convexity, so that either diagonal cuts it in two.
    let shifts = prop::collection::vec((-0.24f32..0.24, -0.24f32..0.24), (columns + 1) * (rows + 1));
    let cuts = prop::collection::vec((any::<bool>(), any::<bool>(), 0..3usize), columns * rows);
    (shifts, cuts).prop_map(move |(shifts, cuts)| {
        let corner = |i: usize, j: usize| {
            let (dx, dy) = shifts[j * (columns + 1) + i];
            let x = if i == 0 || i == columns { 0.0 } else { dx };
            let y = if j == 0 || j == rows { 0.0 } else { dy };
            Vec2::new((i as f32 + x) * 4.0, (j as f32 + y) * 3.5)
        };
        let mut triangles = Vec::new();
        for (n, (rising, swapped, turned)) in cuts.into_iter().enumerate() {
            let (i, j) = (n % columns, n / columns);
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            let halves = if rising { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
            for mut half in halves {
                half.rotate_left(turned);
                if swapped {
                    half.swap(0, 1);
                }
                triangles.push(half);
            }
        }
        triangles
    })
}

/// A rectangle of 16×16 px cut into a fan about any point in it, with corners anywhere on its border.
fn fan() -> impl Strategy<Value = Vec<[Vec2; 3]>> {
    let side = || prop::collection::vec((0..=4096).prop_map(|n| n as f32 / 256.0), 0..6);
    ((0.0f32..16.0, 0.0f32..16.0), side(), side(), side(), side()).prop_map(
        |(hub, south, east, north, west)| {
            let sorted = |mut side: Vec<f32>, corner: f32, down: bool| {
                side.push(corner);
                side.sort_by(f32::total_cmp);
                if down {
                    side.reverse();
                }
                side
            };
            let south = sorted(south, 0.0, false).into_iter().map(|x| Vec2::new(x, 0.0));
            let east = sorted(east, 0.0, false).into_iter().map(|y| Vec2::new(16.0, y));
            let north = sorted(north, 16.0, true).into_iter().map(|x| Vec2::new(x, 16.0));
            let west = sorted(west, 16.0, true).into_iter().map(|y| Vec2::new(0.0, y));
            let rim: Vec<Vec2> = south.chain(east).chain(north).chain(west).collect();
            (0..rim.len()).map(|n| [Vec2::from(hub), rim[n], rim[(n + 1) % rim.len()]]).collect()
        },
    )
}

proptest! {
    #[test]
    fn coverage_is_exact(corners in [corner(), corner(), corner()]) {
        prop_assert_eq!(pixels(corners, window(24, 24)), Triangle::new(corners).pixels(window(24, 24)));
    }

    #[test]
    fn coverage_is_exact_however_far_the_corners(corners in [far_corner(), far_corner(), far_corner()]) {
        prop_assert_eq!(pixels(corners, window(24, 24)), Triangle::new(corners).pixels(window(24, 24)));
    }

    #[test]
    fn weights_are_right(corners in [corner(), corner(), corner()]) {
        let exact = Triangle::new(corners);
        let mut wrong = Vec::new();
        fill(corners, window(24, 24), |x, y, weights| {
            let close = weights.to_array().iter().zip(exact.weights(x, y))
                .all(|(&weight, exact)| (f64::from(weight) - exact).abs() < 1e-6 && (0.0..=1.0).contains(&weight));
            if !close || (weights.element_sum() - 1.0).abs() > 1e-6 {
                wrong.push((x, y, weights));
            }
        });
        prop_assert!(wrong.is_empty(), "{:?}", wrong);
    }

    #[test]
    fn weights_are_right_however_far_the_corners(corners in [far_corner(), far_corner(), far_corner()]) {
        let exact = Triangle::new(corners);
        let mut wrong = Vec::new();
        fill(corners, window(24, 24), |x, y, weights| {
            let close = weights.to_array().iter().zip(exact.weights(x, y))
                .all(|(&weight, exact)| (f64::from(weight) - exact).abs() < 1e-6 && (0.0..=1.0).contains(&weight));
            if !close || (weights.element_sum() - 1.0).abs() > 1e-6 {
                wrong.push((x, y, weights));
            }
        });
        prop_assert!(wrong.is_empty(), "{:?}", wrong);
    }

    /// Rows, points and gradients of a set-up say what `fill` does.
    #[test]
    fn a_set_up_knows_its_rows_its_points_and_its_gradients(
        corners in prop_oneof![[corner(), corner(), corner()], [far_corner(), far_corner(), far_corner()]],
        near in [corner(), corner(), corner()],
    ) {
        let bounds = window(24, 24);
        let rows = |corners| {
            let setup = Setup::new(corners, bounds)?;
            // From the top, as rows do not depend on each other.
            let mut rows: Vec<_> = (setup.bounds.min.y..=setup.bounds.max.y).rev().map(|y| (y, setup.row(y))).collect();
            rows.reverse();
            Some((setup, rows))
        };
        let covered = pixels(corners, bounds);
        let Some((setup, rows_of)) = rows(corners) else {
            prop_assert_eq!(covered, []);
            return Ok(());
        };
        let by_rows: Vec<_> =
            rows_of.into_iter().flat_map(|(y, row)| row.pixels.map(move |x| (x as i32, y))).collect();
        prop_assert_eq!(&by_rows, &covered);
        let center = |n: i32| i64::from(n) * 256 + 128;
        for (x, y) in (0..24).flat_map(|y| (0..24).map(move |x| (x, y))) {
            prop_assert_eq!(setup.covers([center(x), center(y)]), covered.contains(&(x, y)), "({}, {})", x, y);
        }
        // Near by, edge functions are whole numbers, and steps lead from any pixel to any other.
        let Some((setup, rows_of)) = rows(near) else { return Ok(()) };
        let exact = Triangle::new(near);
        for (y, row) in rows_of {
            for x in row.pixels.clone() {
                let steps = [x as f64 - f64::from(setup.bounds.min.x), f64::from(y - setup.bounds.min.y)];
                let edges = setup.edges + setup.right * steps[0] + setup.up * steps[1];
                prop_assert_eq!(edges, row.edges + setup.right * (x - row.pixels.start) as f64);
                prop_assert!(edges.cmpge(setup.inside).all());
                let weights = (edges * setup.per_area).to_array();
                prop_assert!(weights.iter().zip(exact.weights(x as i32, y)).all(|(a, b)| (a - b).abs() < 1e-15));
            }
        }
    }

    /// Asked at another place than its centre, a row has the pixels of which that place is inside, however far out the corners
    /// are; the triangle has no others, whatever places it was made ready for; and from centre to place edge functions
    /// change by as much in each pixel.
    #[test]
    fn a_row_may_be_asked_at_any_place(
        corners in prop_oneof![[corner(), corner(), corner()], [far_corner(), far_corner(), far_corner()]],
        places in prop::array::uniform4(-128_i64..=128),
        more in prop::array::uniform4(0_i64..=9),
        near in [corner(), corner(), corner()],
    ) {
        let [x, y, right, up] = places;
        let all = [[x, y], [right, up], [x, up]];
        let [low, high] = [i64::min, i64::max].map(|pick| [pick(x, right), pick(y, up)]);
        let bounds = window(24, 24);
        // The places may be fewer than those that the triangle is made ready for.
        let reach = [[low[0] - more[0], low[1] - more[1]], [high[0] + more[2], high[1] + more[3]]];
        let reach = reach.map(|place| place.map(|n| n.clamp(-128, 128)));
        let exact = Triangle::new(corners);
        for [x, y] in all {
            let inside = |(i, j): &(i32, i32)| {
                let at = |pixel: i32, place: i64| i128::from(pixel) * 256 + 128 + i128::from(place);
                exact.contains([at(*i, x), at(*j, y)])
            };
            let expected: Vec<_> = (0..24).flat_map(|j| (0..24).map(move |i| (i, j))).filter(inside).collect();
            let Some(setup) = Setup::asked_at(corners, bounds, reach) else {
                prop_assert_eq!(&expected, &[]);
                continue;
            };
            let rows = setup.bounds.min.y..=setup.bounds.max.y;
            let found = rows.flat_map(|j| setup.row_at(j, [x, y]).map(move |i| (i as i32, j)));
            prop_assert_eq!(found.collect::<Vec<_>>(), expected);
            // Near by, the same from the edge functions at the centres.
            let Some(setup) = Setup::asked_at(near, bounds, reach) else { continue };
            let Bounds { min, max } = setup.bounds;
            for (i, j) in (min.y..=max.y).flat_map(|j| (min.x..=max.x).map(move |i| (i, j))) {
                let center = setup.edges + setup.right * f64::from(i - min.x) + setup.up * f64::from(j - min.y);
                let covers = (center + setup.offset([x, y])).cmpge(setup.inside).all();
                let at = |pixel: i32, place: i64| i64::from(pixel) * 256 + 128 + place;
                prop_assert_eq!(covers, setup.covers([at(i, x), at(j, y)]), "({}, {})", i, j);
            }
        }
    }

    /// A point at 1/256 px is inside as a pixel's centre is, in a picture moved by as much.
    #[test]
    fn any_point_is_inside_as_a_centre_would_be(
        corners in [corner(), corner(), corner()], at in corner(),
    ) {
        let [corners @ .., by] = [corners[0], corners[1], corners[2], at].map(|p| (p * 256.0).round() / 256.0);
        let moved = corners.map(|corner| corner - by + 0.5);
        let bounds = Bounds { min: IVec2::splat(-64), max: IVec2::splat(64) };
        if let Some(setup) = Setup::new(corners, bounds) {
            let covers = setup.covers((by * 256.0).to_array().map(|n| n as i64));
            prop_assert_eq!(covers, Triangle::new(moved).covers(0, 0));
        }
    }

    #[test]
    fn the_order_of_the_corners_does_not_matter(corners in [corner(), corner(), corner()]) {
        let run = |order: [usize; 3]| {
            let mut pixels: Vec<(i32, i32, Vec3)> = Vec::new();
            fill(order.map(|i| corners[i]), window(24, 24), |x, y, w| {
                let mut weights = Vec3::ZERO;
                (0..3).for_each(|n| weights[order[n]] = w[n]);
                pixels.push((x, y, weights));
            });
            pixels
        };
        let expected = run([0, 1, 2]);
        for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            prop_assert_eq!(&run(order), &expected);
        }
    }

    #[test]
    fn a_triangle_turned_by_half_a_turn_covers_the_same_inner_pixels(corners in [corner(), corner(), corner()]) {
        // In 1/256 px, so that turning rounds nothing.
        let corners = corners.map(|corner| (corner * 256.0).round() / 256.0);
        let turned = corners.map(|corner| Vec2::splat(24.0) - corner);
        // Centres on a side change hands when the picture is turned.
        let exact = Triangle::new(corners);
        let inner = |&(x, y): &(i32, i32)| !exact.weights(x, y).contains(&0.0);
        let expected: Vec<_> = pixels(corners, window(24, 24)).into_iter().filter(inner).collect();
        let mut got: Vec<_> = pixels(turned, window(24, 24)).iter().map(|&(x, y)| (23 - x, 23 - y)).collect();
        got.reverse();
        got.retain(inner);
        prop_assert_eq!(got, expected);
    }

    #[test]
    fn any_bounds_cut_a_triangle_exactly(
        base in [base(), base()], offsets in prop::array::uniform6(-1.0f32..1.0), bounds in any_bounds(),
    ) {
        // 20 px about the base, or one or two steps of f32 where they are longer.
        let at = |n: usize, offset: f32| {
            let step = base[n].abs().next_up() - base[n].abs();
            base[n] + offset * (1.5 * step).max(20.0)
        };
        let corners = [0, 2, 4].map(|i| Vec2::new(at(0, offsets[i]), at(1, offsets[i + 1])));
        let low = corners[0].min(corners[1]).min(corners[2]).as_ivec2();
        let high = corners[0].max(corners[1]).max(corners[2]).as_ivec2();
        let near = Bounds {
            min: low.saturating_sub(IVec2::splat(2)).max(bounds.min),
            max: high.saturating_add(IVec2::splat(2)).min(bounds.max),
        };
        prop_assert_eq!(pixels(corners, bounds), Triangle::new(corners).pixels(near));
    }

    #[test]
    fn empty_bounds_hold_nothing(corners in [far_corner(), far_corner(), far_corner()], bounds in any_bounds()) {
        let (low, high) = (bounds.min.min(bounds.max), bounds.min.max(bounds.max));
        // One side the wrong way round is enough.
        for (min, max) in [
            (IVec2::new(high.x, low.y), IVec2::new(low.x, high.y)),
            (IVec2::new(low.x, high.y), IVec2::new(high.x, low.y)),
        ] {
            if min.cmpgt(max).any() {
                prop_assert_eq!(pixels(corners, Bounds { min, max }), []);
            }
        }
    }

    #[test]
    fn a_grid_covers_every_pixel_once(triangles in tiled_grid()) {
        prop_assert_eq!(counts(&triangles, 20, 14), vec![1; 20 * 14]);
    }

    #[test]
    fn a_fan_with_slivers_covers_every_pixel_once(triangles in fan()) {
        prop_assert_eq!(counts(&triangles, 16, 16), vec![1; 16 * 16]);
    }

    #[test]
    fn no_method_panics_or_leaves_the_bounds(corners in any::<[f32; 6]>(), near in [corner(), corner()]) {
        let wild = [Vec2::new(corners[0], corners[1]), Vec2::new(corners[2], corners[3]), Vec2::new(corners[4], corners[5])];
        let bounds = Bounds { min: IVec2::new(3, 2), max: IVec2::new(12, 9) };
        for method in METHODS {
            for corners in [wild, [wild[0], near[0], near[1]], [wild[0], wild[1], near[0]]] {
                let mut outside = 0;
                (method.run.visit)(corners, bounds, &mut |x, y, _| outside += u32::from(!bounds.contains(x, y)));
                prop_assert_eq!(outside, 0, "{}", method.name);
            }
        }
    }
}
