use checks::coverage::Triangle;
use common::{Bounds, IVec2, Vec2, Vec3};
use triangles::{METHODS, fill, flat_intensity};
use verify::{method, window};

/// What must happen.
#[derive(Debug)]
enum Must {
    /// The pixels of the exact reference, each once.
    Exact,
    /// Just these faults.
    Fail(&'static str),
}
use Must::{Exact, Fail};

type Row = (&'static str, Must);
type Case = (&'static str, [f32; 6], [i32; 2], &'static [Row]);

/// Up to where `edges` computes in `f64`, and up to where it computes at all.
const NARROW: f32 = (1 << 16) as f32;
const WIDE: f32 = (1_u64 << 52) as f32;

/// Input, its corners, where a window of 24×24 px begins, and what each method must do in it.
const TABLE: &[Case] = &[
    (
        "the slides' small triangle",
        [120.0, 160.0, 130.0, 180.0, 135.0, 165.0],
        [118, 158],
        &[
            ("outline", Fail("missing 101, extra 31, visited twice 3")),
            ("sweep", Fail("extra 26, visited twice 14")),
            ("barycentric", Fail("extra 10")),
            ("edges", Exact),
        ],
    ),
    (
        "real corners",
        [2.3, 1.7, 20.1, 8.4, 6.6, 19.9],
        [0, 0],
        &[
            ("outline", Fail("missing 119, extra 21, visited twice 3")),
            ("sweep", Fail("missing 3, extra 25, visited twice 18")),
            ("barycentric", Exact),
            ("edges", Exact),
        ],
    ),
    (
        "the same, clockwise",
        [2.3, 1.7, 6.6, 19.9, 20.1, 8.4],
        [0, 0],
        &[
            ("outline", Fail("missing 119, extra 21, visited twice 3")),
            ("sweep", Fail("missing 3, extra 25, visited twice 18")),
            ("barycentric", Exact),
            ("edges", Exact),
        ],
    ),
    (
        "centres on all sides",
        [2.5, 2.5, 18.5, 2.5, 2.5, 18.5],
        [0, 0],
        &[
            ("outline", Fail("missing 93, extra 21, visited twice 3")),
            ("sweep", Fail("missing 15, extra 48")),
            ("barycentric", Fail("extra 33")),
            ("edges", Exact),
        ],
    ),
    (
        "a point",
        [5.5, 5.5, 5.5, 5.5, 5.5, 5.5],
        [0, 0],
        &[("outline", Exact), ("sweep", Exact), ("barycentric", Exact), ("edges", Exact)],
    ),
    (
        "a line",
        [2.0, 3.0, 8.0, 6.0, 14.0, 9.0],
        [0, 0],
        &[("outline", Exact), ("sweep", Exact), ("barycentric", Exact), ("edges", Exact)],
    ),
    (
        "a horizontal line through centres",
        [2.0, 3.5, 8.0, 3.5, 14.0, 3.5],
        [0, 0],
        &[("outline", Exact), ("sweep", Exact), ("barycentric", Exact), ("edges", Exact)],
    ),
    (
        "a sliver between centres",
        [2.0, 3.0, 20.0, 3.0, 20.0, 3.25],
        [0, 0],
        &[
            ("outline", Fail("extra 19, visited twice 20")),
            ("sweep", Exact),
            ("barycentric", Exact),
            ("edges", Exact),
        ],
    ),
    (
        "a sliver across centres",
        [2.0, 3.0, 20.0, 3.0, 20.0, 3.75],
        [0, 0],
        &[
            ("outline", Fail("extra 22, visited twice 12")),
            ("sweep", Fail("extra 14")),
            ("barycentric", Exact),
            ("edges", Exact),
        ],
    ),
    (
        "smaller than a pixel, beside its centre",
        [4.6, 4.6, 4.9, 4.6, 4.6, 4.9],
        [0, 0],
        &[
            ("outline", Fail("extra 1, visited twice 2")),
            ("sweep", Exact),
            ("barycentric", Exact),
            ("edges", Exact),
        ],
    ),
    (
        "smaller than a pixel, about its centre",
        [4.25, 4.25, 4.75, 4.5, 4.5, 4.75],
        [0, 0],
        &[
            ("outline", Fail("extra 1, visited twice 3")),
            ("sweep", Fail("extra 1")),
            ("barycentric", Exact),
            ("edges", Exact),
        ],
    ),
    (
        "outside the window",
        [-30.0, -30.0, -10.0, -28.0, -28.0, 5.0],
        [0, 0],
        &[("outline", Exact), ("sweep", Exact), ("barycentric", Exact), ("edges", Exact)],
    ),
    (
        "at 10^4",
        [10_000.25, 10_000.5, 10_016.5, 10_003.75, 10_004.25, 10_018.5],
        [9_998, 9_998],
        &[
            ("outline", Fail("missing 115, extra 26, visited twice 3")),
            ("sweep", Fail("missing 11, extra 38, visited twice 18")),
            ("barycentric", Exact),
            ("edges", Exact),
        ],
    ),
    (
        "at 10^7",
        [10_000_000.0, 10_000_001.0, 10_000_017.0, 10_000_004.0, 10_000_005.0, 10_000_019.0],
        [9_999_998, 9_999_998],
        &[
            ("outline", Fail("missing 117, extra 22, visited twice 3")),
            ("sweep", Fail("missing 5, extra 25, visited twice 17")),
            ("barycentric", Fail("missing 12, extra 11")),
            ("edges", Exact),
        ],
    ),
    (
        "all around the window, to 10^7",
        [-1e7, -1e7, 1e7, -9_999_990.0, 13.0, 1e7],
        [0, 0],
        &[("outline", Fail("missing 576")), ("sweep", Exact), ("barycentric", Exact), ("edges", Exact)],
    ),
    (
        "a side through the window, from -10^7 to 10^7",
        [-9_999_989.0, -1e7, 1e7, 9_999_995.0, -1e7, 1e7],
        [0, 0],
        &[
            ("outline", Fail("missing 440, extra 16")),
            ("sweep", Fail("missing 1, extra 2")),
            ("barycentric", Fail("extra 8")),
            ("edges", Exact),
        ],
    ),
    (
        "corners at 2^16, the last for f64",
        [-NARROW, -NARROW, NARROW, NARROW - 7.0, -NARROW, NARROW],
        [0, 0],
        &[
            ("outline", Fail("missing 366, extra 20")),
            ("sweep", Exact),
            ("barycentric", Exact),
            ("edges", Exact),
        ],
    ),
    (
        "a corner just beyond 2^16",
        [-NARROW - 1.0, -NARROW, NARROW, NARROW - 7.0, -NARROW, NARROW],
        [0, 0],
        &[("outline", Fail("missing 345")), ("sweep", Exact), ("barycentric", Exact), ("edges", Exact)],
    ),
    (
        "corners at 2^52, the last for i128",
        [-WIDE, -WIDE, WIDE, WIDE, -WIDE, WIDE],
        [0, 0],
        &[
            ("outline", Fail("missing 276, extra 24")),
            ("sweep", Fail("missing 253, extra 1")),
            ("barycentric", Fail("extra 300")),
            ("edges", Exact),
        ],
    ),
    (
        "corners beyond 2^52",
        [-2.0 * WIDE, -WIDE, 2.0 * WIDE, -WIDE, 7.0, WIDE],
        [0, 0],
        &[
            ("outline", Fail("missing 576")),
            ("sweep", Exact),
            ("barycentric", Exact),
            ("edges", Fail("missing 576")),
        ],
    ),
    (
        "NaN",
        [2.0, 3.0, f32::NAN, 9.0, 14.0, 2.0],
        [0, 0],
        &[("outline", Exact), ("sweep", Exact), ("barycentric", Exact), ("edges", Exact)],
    ),
    (
        "infinite",
        [2.0, 3.0, f32::INFINITY, 9.0, 14.0, 2.0],
        [0, 0],
        &[("outline", Exact), ("sweep", Exact), ("barycentric", Exact), ("edges", Exact)],
    ),
];

#[test]
fn every_method_does_what_it_must() {
    for (input, [x0, y0, x1, y1, x2, y2], start, rows) in TABLE {
        assert!(rows.iter().map(|row| row.0).eq(METHODS.iter().map(|method| method.name)), "{input}");
        let corners = [Vec2::new(*x0, *y0), Vec2::new(*x1, *y1), Vec2::new(*x2, *y2)];
        for (name, must) in *rows {
            let faults = examine(name, corners, IVec2::from(*start));
            let met = match *must {
                Exact => faults == "exact",
                Fail(expected) => faults == expected,
            };
            assert!(met, "{input}, {name}: {faults}, but {must:?} was expected");
        }
    }
}

/// All that is wrong with a method's pixels, in words.
fn examine(name: &str, corners: [Vec2; 3], start: IVec2) -> String {
    let window = Bounds { min: start, max: start + 23 };
    let mut got = Vec::new();
    (method(METHODS, name).visit)(corners, window, &mut |x, y, _| got.push((x, y)));
    let visits = got.len();
    got.sort_unstable();
    got.dedup();
    let finite = corners.iter().all(|corner| corner.is_finite());
    let expected = if finite { Triangle::new(corners).pixels(window) } else { Vec::new() };
    let missing = expected.iter().filter(|pixel| !got.contains(pixel)).count();
    let extra = got.iter().filter(|pixel| !expected.contains(pixel)).count();
    let faults = [("missing", missing), ("extra", extra), ("visited twice", visits - got.len())];
    let told: Vec<String> =
        faults.iter().filter(|fault| fault.1 > 0).map(|(what, count)| format!("{what} {count}")).collect();
    if told.is_empty() { "exact".into() } else { told.join(", ") }
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

/// Meshes that cover each of the 576 pixels of a window once, and what each method makes of them: how many
/// pixels are holes, and how many are covered more than once.
#[test]
fn neighbours_share_no_pixel_and_leave_no_hole_only_in_edges() {
    type Mesh = (&'static str, fn(f32) -> Vec<[Vec2; 3]>, f32, [(usize, usize); 4]);
    let table: [Mesh; 5] = [
        ("grid, whole corners", grid, 0.0, [(216, 324), (0, 324), (0, 144), (0, 0)]),
        ("grid, corners on centres", grid, 0.5, [(228, 313), (24, 313), (0, 323), (0, 0)]),
        ("grid at 10^7", grid, 1e7, [(216, 324), (0, 324), (0, 396), (0, 0)]),
        ("fan of slivers", fan, 0.0, [(0, 576), (0, 535), (0, 0), (0, 0)]),
        ("fan of slivers at 10^6", fan, 1e6, [(0, 576), (0, 535), (0, 0), (0, 0)]),
    ];
    for (mesh, make, shift, expected) in table {
        // With corners on centres, the top row and the left column belong to the square, others do not.
        let start = IVec2::new(shift as i32, (shift + 0.5) as i32);
        let window = Bounds { min: start, max: start + 23 };
        let got = METHODS.iter().map(|method| {
            let mut visits = vec![0; 24 * 24];
            for triangle in make(shift) {
                (method.run.visit)(triangle, window, &mut |x, y, _| {
                    visits[((y - start.y) * 24 + x - start.x) as usize] += 1;
                });
            }
            let holes = visits.iter().filter(|&&n| n == 0).count();
            let doubled = visits.iter().filter(|&&n| n > 1).count();
            (holes, doubled)
        });
        let got: Vec<(usize, usize)> = got.collect();
        assert_eq!(got, expected, "{mesh}");
    }
}

#[test]
fn edges_allocates_nothing() {
    for corners in [[1.5, 2.0, 20.0, 1.0, 16.5, 14.5], [-1e7, -1e7, 1e7, -9_999_990.0, 13.0, 1e7]] {
        let [x0, y0, x1, y1, x2, y2] = corners;
        let corners = [Vec2::new(x0, y0), Vec2::new(x1, y1), Vec2::new(x2, y2)];
        let mut visits = 0;
        let counted = allocation_counter::measure(|| fill(corners, window(24, 24), |_, _, _| visits += 1));
        assert!(
            visits > 0 && counted.count_total == 0,
            "{visits} pixels, {} allocations",
            counted.count_total
        );
    }
}

/// A triangle about the window, so large that f32 does not hold its area: nothing is drawn, rather than all
/// with made-up weights. Beyond what `checks` holds as well, but plain to see.
#[test]
fn where_the_area_is_infinite_barycentric_covers_nothing() {
    for (size, expected) in [(1e18, [0, 576, 576, 0]), (1e19, [0, 0, 0, 0]), (1e30, [0, 0, 0, 0])] {
        let corners = [Vec2::new(-size, -size), Vec2::new(size, -size), Vec2::new(7.0, size)];
        let got = [0, 1, 2, 3].map(|n| {
            let mut visits = 0;
            (METHODS[n].run.visit)(corners, window(24, 24), &mut |_, _, _| visits += 1);
            visits
        });
        assert_eq!(got, expected, "{size}");
    }
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
