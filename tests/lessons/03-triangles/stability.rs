use checks::coverage::Triangle;
use common::{Bounds, IVec2, Method, Vec2, Vec3};
use triangles::edges::Setup;
use triangles::{LESSON, METHODS, fill, flat_intensity};
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, Row, counted, every_method};
use verify::window;

/// A triangle's corners, and where a window of 24×24 px begins.
type Given = ([f32; 6], [i32; 2]);

const ALL_EXACT: &[Row] = &[("outline, sweep, barycentric, edges", Exact)];

/// Up to where `edges` computes in `f64`, and up to where it computes at all.
const NARROW: f32 = (1 << 16) as f32;
const WIDE: f32 = (1_u64 << 52) as f32;
const HALF_WIDE: f32 = (1_u64 << 51) as f32;

/// Half of 1/256 px, to which corners are rounded.
const TIE: f32 = 1.0 / 512.0;

/// The triangles, and what each method must do in the window: exact are the pixels of the reference, each once.
const TABLE: &[Case<Given>] = &[
    (
        "the slides' small triangle",
        ([120.0, 160.0, 130.0, 180.0, 135.0, 165.0], [118, 158]),
        &[
            ("outline", Fails("missing 101, extra 31, visited twice 3")),
            ("sweep", Fails("extra 26, visited twice 14")),
            ("barycentric", Fails("extra 10")),
            ("edges", Exact),
        ],
    ),
    (
        "real corners",
        ([2.3, 1.7, 20.1, 8.4, 6.6, 19.9], [0, 0]),
        &[
            ("outline", Fails("missing 119, extra 21, visited twice 3")),
            ("sweep", Fails("missing 3, extra 25, visited twice 18")),
            ("barycentric, edges", Exact),
        ],
    ),
    (
        "the same, clockwise",
        ([2.3, 1.7, 6.6, 19.9, 20.1, 8.4], [0, 0]),
        &[
            ("outline", Fails("missing 119, extra 21, visited twice 3")),
            ("sweep", Fails("missing 3, extra 25, visited twice 18")),
            ("barycentric, edges", Exact),
        ],
    ),
    (
        "centres on all sides",
        ([2.5, 2.5, 18.5, 2.5, 2.5, 18.5], [0, 0]),
        &[
            ("outline", Fails("missing 93, extra 21, visited twice 3")),
            ("sweep", Fails("missing 15, extra 48")),
            ("barycentric", Fails("extra 33")),
            ("edges", Exact),
        ],
    ),
    ("a point", ([5.5, 5.5, 5.5, 5.5, 5.5, 5.5], [0, 0]), ALL_EXACT),
    ("a line", ([2.0, 3.0, 8.0, 6.0, 14.0, 9.0], [0, 0]), ALL_EXACT),
    ("a horizontal line through centres", ([2.0, 3.5, 8.0, 3.5, 14.0, 3.5], [0, 0]), ALL_EXACT),
    (
        "a sliver between centres",
        ([2.0, 3.0, 20.0, 3.0, 20.0, 3.25], [0, 0]),
        &[("outline", Fails("extra 19, visited twice 20")), ("sweep, barycentric, edges", Exact)],
    ),
    (
        "a sliver across centres",
        ([2.0, 3.0, 20.0, 3.0, 20.0, 3.75], [0, 0]),
        &[
            ("outline", Fails("extra 22, visited twice 12")),
            ("sweep", Fails("extra 14")),
            ("barycentric, edges", Exact),
        ],
    ),
    (
        "smaller than a pixel, beside its centre",
        ([4.6, 4.6, 4.9, 4.6, 4.6, 4.9], [0, 0]),
        &[("outline", Fails("extra 1, visited twice 2")), ("sweep, barycentric, edges", Exact)],
    ),
    (
        "smaller than a pixel, about its centre",
        ([4.25, 4.25, 4.75, 4.5, 4.5, 4.75], [0, 0]),
        &[
            ("outline", Fails("extra 1, visited twice 3")),
            ("sweep", Fails("extra 1")),
            ("barycentric, edges", Exact),
        ],
    ),
    ("outside the window", ([-30.0, -30.0, -10.0, -28.0, -28.0, 5.0], [0, 0]), ALL_EXACT),
    (
        "at 10^4",
        ([10_000.25, 10_000.5, 10_016.5, 10_003.75, 10_004.25, 10_018.5], [9_998, 9_998]),
        &[
            ("outline", Fails("missing 115, extra 26, visited twice 3")),
            ("sweep", Fails("missing 11, extra 38, visited twice 18")),
            ("barycentric, edges", Exact),
        ],
    ),
    (
        "at 10^7",
        (
            [10_000_000.0, 10_000_001.0, 10_000_017.0, 10_000_004.0, 10_000_005.0, 10_000_019.0],
            [9_999_998, 9_999_998],
        ),
        &[
            ("outline", Fails("missing 117, extra 22, visited twice 3")),
            ("sweep", Fails("missing 5, extra 25, visited twice 17")),
            ("barycentric", Fails("missing 12, extra 11")),
            ("edges", Exact),
        ],
    ),
    (
        "all around the window, to 10^7",
        ([-1e7, -1e7, 1e7, -9_999_990.0, 13.0, 1e7], [0, 0]),
        &[("outline", Fails("missing 576")), ("sweep, barycentric, edges", Exact)],
    ),
    (
        "a side through the window, from -10^7 to 10^7",
        ([-9_999_989.0, -1e7, 1e7, 9_999_995.0, -1e7, 1e7], [0, 0]),
        &[
            ("outline", Fails("missing 440, extra 16")),
            ("sweep", Fails("missing 1, extra 2")),
            ("barycentric", Fails("extra 8")),
            ("edges", Exact),
        ],
    ),
    (
        "corners at 2^16, the last for f64",
        ([-NARROW, -NARROW, NARROW, NARROW - 7.0, -NARROW, NARROW], [0, 0]),
        &[("outline", Fails("missing 366, extra 20")), ("sweep, barycentric, edges", Exact)],
    ),
    (
        "a corner just beyond 2^16",
        ([-NARROW - 1.0, -NARROW, NARROW, NARROW - 7.0, -NARROW, NARROW], [0, 0]),
        &[("outline", Fails("missing 345")), ("sweep, barycentric, edges", Exact)],
    ),
    (
        "corners at 2^52, the last for i128",
        ([-WIDE, -WIDE, WIDE, WIDE, -WIDE, WIDE], [0, 0]),
        &[
            ("outline", Fails("missing 276, extra 24")),
            ("sweep", Fails("missing 253, extra 1")),
            ("barycentric", Fails("extra 300")),
            ("edges", Exact),
        ],
    ),
    (
        "a side 2^51 px high and 1/256 px wide, beside a centre that f64's quotient leaves out",
        ([7.5, 351.0 / 256.0, 7.5 + 1.0 / 256.0, HALF_WIDE, -4096.0, 0.0], [0, 0]),
        &[
            ("outline", Fails("missing 176, extra 23, visited twice 1")),
            ("sweep", Fails("extra 23, visited twice 9")),
            ("barycentric, edges", Exact),
        ],
    ),
    (
        "corners beyond 2^52",
        ([-2.0 * WIDE, -WIDE, 2.0 * WIDE, -WIDE, 7.0, WIDE], [0, 0]),
        &[("outline, edges", Fails("missing 576")), ("sweep, barycentric", Exact)],
    ),
    ("NaN", ([2.0, 3.0, f32::NAN, 9.0, 14.0, 2.0], [0, 0]), ALL_EXACT),
    ("infinite", ([2.0, 3.0, f32::INFINITY, 9.0, 14.0, 2.0], [0, 0]), ALL_EXACT),
    (
        "a side 1/512 px beyond centres: as near to them as to the next 1/256 px, and rounded to even",
        ([2.5 + TIE, 1.0, 20.0, 1.0, 2.5 + TIE, 20.0], [0, 0]),
        &[
            ("outline", Fails("missing 143, extra 21, visited twice 3")),
            ("sweep", Fails("missing 19, extra 23")),
            ("barycentric", Fails("missing 19")),
            ("edges", Exact),
        ],
    ),
    (
        "a side 1/512 px before the next 1/256 px, which is even",
        ([1.0, 2.5 + 3.0 * TIE, 20.0, 2.5 + 3.0 * TIE, 1.0, 20.0], [0, 0]),
        &[
            ("outline", Fails("missing 124, extra 21, visited twice 3")),
            ("sweep", Fails("extra 23")),
            ("barycentric, edges", Exact),
        ],
    ),
];

#[test]
fn every_method_does_what_it_must() {
    every_method(LESSON.name, METHODS, TABLE, |method, &(numbers, start)| {
        faults(method, corners(numbers), IVec2::from(start))
    });
}

fn corners([x0, y0, x1, y1, x2, y2]: [f32; 6]) -> [Vec2; 3] {
    [Vec2::new(x0, y0), Vec2::new(x1, y1), Vec2::new(x2, y2)]
}

/// All that is wrong with a method's pixels in a window.
fn faults(method: &Method<triangles::Triangle>, corners: [Vec2; 3], start: IVec2) -> Vec<String> {
    let window = Bounds { min: start, max: start + 23 };
    let mut got = Vec::new();
    (method.run.visit)(corners, window, &mut |x, y, _| got.push((x, y)));
    let visits = got.len();
    got.sort_unstable();
    got.dedup();
    let finite = corners.iter().all(|corner| corner.is_finite());
    let expected = if finite { Triangle::new(corners).pixels(window) } else { Vec::new() };
    counted([
        ("missing", expected.iter().filter(|pixel| !got.contains(pixel)).count()),
        ("extra", got.iter().filter(|pixel| !expected.contains(pixel)).count()),
        ("visited twice", visits - got.len()),
    ])
}

/// A square of 24×24 px, cut into squares of 4 px and those along their diagonal; its corners
/// moved by `shift`.
fn grid(shift: f32) -> Vec<[Vec2; 3]> {
    let corner = |i: u8, j: u8| Vec2::new(f32::from(i), f32::from(j)) * 4.0 + shift;
    let fields = (0..6).flat_map(|j| (0..6).map(move |i| (i, j)));
    fields
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

/// A square of 24×24 px, cut into a fan of slivers about a point near one corner.
fn fan(shift: f32) -> Vec<[Vec2; 3]> {
    let rim: Vec<Vec2> = (0..96_u8)
        .map(|n| {
            let (side, along) = (n / 24, f32::from(n % 24));
            let [x, y] =
                [[along, 0.0], [24.0, along], [24.0 - along, 24.0], [0.0, 24.0 - along]][usize::from(side)];
            Vec2::new(x, y) + shift
        })
        .collect();
    (0..96).map(|n| [Vec2::new(1.25, 2.5) + shift, rim[n], rim[(n + 1) % 96]]).collect()
}

/// How a mesh is made, moved by so much.
type Mesh = (fn(f32) -> Vec<[Vec2; 3]>, f32);

/// Meshes that cover each of the 576 pixels of a window once, and what each method makes of them.
const MESHES: &[Case<Mesh>] = &[
    (
        "grid, whole corners",
        (grid, 0.0),
        &[
            ("outline", Fails("holes 216, doubled 324")),
            ("sweep", Fails("doubled 324")),
            ("barycentric", Fails("doubled 144")),
            ("edges", Exact),
        ],
    ),
    (
        "grid, corners on centres",
        (grid, 0.5),
        &[
            ("outline", Fails("holes 228, doubled 313")),
            ("sweep", Fails("holes 24, doubled 313")),
            ("barycentric", Fails("doubled 323")),
            ("edges", Exact),
        ],
    ),
    (
        "grid at 10^7",
        (grid, 1e7),
        &[
            ("outline", Fails("holes 216, doubled 324")),
            ("sweep", Fails("doubled 324")),
            ("barycentric", Fails("doubled 396")),
            ("edges", Exact),
        ],
    ),
    (
        "fan of slivers",
        (fan, 0.0),
        &[("outline", Fails("doubled 576")), ("sweep", Fails("doubled 535")), ("barycentric, edges", Exact)],
    ),
    (
        "fan of slivers at 10^6",
        (fan, 1e6),
        &[("outline", Fails("doubled 576")), ("sweep", Fails("doubled 535")), ("barycentric, edges", Exact)],
    ),
];

#[test]
fn neighbours_share_no_pixel_and_leave_no_hole_only_in_edges() {
    every_method(LESSON.name, METHODS, MESHES, |method, &(make, shift)| {
        // With corners on centres, the top row and the left column belong to the square, others do not.
        let start = IVec2::new(shift as i32, (shift + 0.5) as i32);
        let window = Bounds { min: start, max: start + 23 };
        let mut visits = vec![0; 24 * 24];
        for triangle in make(shift) {
            (method.run.visit)(triangle, window, &mut |x, y, _| {
                visits[((y - start.y) * 24 + x - start.x) as usize] += 1;
            });
        }
        counted([
            ("holes", visits.iter().filter(|&&n| n == 0).count()),
            ("doubled", visits.iter().filter(|&&n| n > 1).count()),
        ])
    });
}

/// A row of some 2¹⁹ px that ends with a centre on a right side, which is not covered. The edge function is 0 there and
/// above 2⁵³ at the row's first pixel, where f64 does not tell it from 1 less: such corners are for i128. (Within 2¹⁷ px
/// f64 would still do. And no picture is so wide that its rows would show 2¹⁸.)
#[test]
fn a_centre_on_a_right_side_is_out_at_the_end_of_the_longest_row() {
    let corners = corners([200_000.5, -262_144.0, 200_000.5, 262_144.0, -262_144.0, 0.0]);
    let row = Bounds { min: IVec2::new(-262_144, 0), max: IVec2::new(262_143, 0) };
    let mut last = None;
    fill(corners, row, |x, _, _| last = Some((x, 0)));
    assert_eq!(last, Some((199_999, 0)));
    assert_eq!(last, Triangle::new(corners).pixels(row).last().copied());
}

/// Sides 2^51 px high and 1/256 px wide, each beside the centres of a column: there a weight is so small that the rounding
/// of the sums before it would bring it below 0.
#[test]
fn no_weight_of_a_wide_triangle_is_below_0() {
    for (x, y) in [(18.5, 285.0 / 256.0), (0.5, 383.0 / 256.0), (-999.5, 383.0 / 256.0)] {
        let corners = corners([x, y, x + 1.0 / 256.0, HALF_WIDE, -4096.0, 0.0]);
        let start = IVec2::new(if x < 0.0 { -1000 } else { 0 }, 0);
        let mut last = None;
        fill(corners, Bounds { min: start, max: start + 23 }, |x, _, weights| {
            assert!(weights.cmpge(Vec3::ZERO).all(), "{x}: {weights}");
            last = last.max(Some(x));
        });
        assert_eq!(last, Some(x.floor() as i32));
    }
}

/// Whatever pixels a method finds, their weights are those of their centres.
#[test]
fn weights_are_those_of_the_pixels_centre() {
    let corners = corners([2.3, 1.7, 20.1, 8.4, 6.6, 19.9]);
    for method in METHODS {
        (method.run.visit)(corners, window(24, 24), &mut |x, y, weights| {
            let exact = Triangle::new(corners).weights(x, y);
            // What rounding the corners to 1/256 px changes.
            let close = weights.to_array().iter().zip(exact).all(|(&a, b)| (f64::from(a) - b).abs() < 1e-3);
            assert!(close, "{}: ({x}, {y}) has {weights}", method.name);
        });
    }
}

/// Beside the window, above it, and between the pixels' centres of one row or column.
#[test]
fn a_triangle_whose_box_holds_no_centre_is_no_set_up() {
    for numbers in [
        [30.0, 5.0, 40.0, 6.0, 31.0, 19.0],
        [5.0, 30.0, 19.0, 31.0, 6.0, 40.0],
        [-9.0, -9.0, 0.25, -2.0, -5.0, 0.25],
        [2.75, 3.0, 3.25, 9.0, 3.0, 17.0],
        [3.0, 2.75, 9.0, 3.25, 17.0, 3.0],
    ] {
        assert!(Setup::new(corners(numbers), window(24, 24)).is_none(), "{numbers:?}");
    }
}

#[test]
fn edges_allocates_nothing() {
    for numbers in [[1.5, 2.0, 20.0, 1.0, 16.5, 14.5], [-1e7, -1e7, 1e7, -9_999_990.0, 13.0, 1e7]] {
        let mut visits = 0;
        let counted =
            allocation_counter::measure(|| fill(corners(numbers), window(24, 24), |_, _, _| visits += 1));
        assert!(
            visits > 0 && counted.count_total == 0,
            "{visits} pixels, {} allocations",
            counted.count_total
        );
    }
}

/// Triangles about the window, so large that f32 does not hold their area: nothing is drawn, rather than all with
/// made-up weights. Beyond what `checks` holds as well, but plain to see: every pixel is covered.
const HUGE: &[Case<f32>] = &[
    ("corners at 10^18", 1e18, &[("outline, edges", Fails("missing 576")), ("sweep, barycentric", Exact)]),
    ("corners at 10^19", 1e19, &[("outline, sweep, barycentric, edges", Fails("missing 576"))]),
    ("corners at 10^30", 1e30, &[("outline, sweep, barycentric, edges", Fails("missing 576"))]),
];

#[test]
fn where_the_area_is_infinite_nothing_is_covered() {
    every_method(LESSON.name, METHODS, HUGE, |method, &size| {
        let mut visits = 0;
        let corners = corners([-size, -size, size, -size, 7.0, size]);
        (method.run.visit)(corners, window(24, 24), &mut |_, _, _| visits += 1);
        counted([("missing", 576 - visits)])
    });
}

/// A triangle's brightness is the same at any size, however large or small the products of its sides.
#[test]
fn brightness_does_not_depend_on_size() {
    let corners = [Vec3::new(-0.5, -0.5, 0.0), Vec3::new(0.5, -0.5, 0.25), Vec3::new(0.0, 0.5, 0.5)];
    let expected = flat_intensity(corners, Vec3::Z);
    for exponent in (-120..=120).step_by(10) {
        let got = flat_intensity(corners.map(|corner| corner * 2f32.powi(exponent)), Vec3::Z);
        assert_eq!(got, expected, "2^{exponent}");
    }
    let far = [Vec3::new(-5e9, -5e9, 0.0), Vec3::new(5e9, -5e9, 0.0), Vec3::new(0.0, 5e9, 0.0)];
    assert_eq!(flat_intensity(far, Vec3::Z), 1.0);
    let sliver = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(1.0, 1e-20, 0.0), Vec3::new(1.0, 0.0, 1e-20)];
    assert_eq!(flat_intensity(sliver, Vec3::X), 1.0);
    assert_eq!(flat_intensity([Vec3::ONE; 3], Vec3::Z), 0.0);
}
