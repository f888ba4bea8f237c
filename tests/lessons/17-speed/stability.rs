//! Where drawing fast might go wrong: nowhere may a pixel differ from lesson 13's.

use clipping::{Counts, Cull};
use common::{Color, Image, Mat4, Vec3};
use perspective::{perspective, view};
use speed::{LESSON, METHODS, Plan};
use verify::stability::Must::Exact;
use verify::stability::{Case, Row, every_method};

use crate::canvas::{Canvas, Way, again, differing, drawn, frame};
use crate::soup::{Corner, Drops, Soup};

/// Pictures of one size, drawn one after the other.
struct Cell {
    size: [u16; 2],
    cull: Cull,
    /// The meshes of each picture.
    pictures: fn([u16; 2]) -> Vec<Vec<Soup>>,
    /// What of a method's plan is changed.
    plan: fn(Plan) -> Plan,
}

impl Cell {
    /// One picture.
    const fn new(size: [u16; 2], pictures: fn([u16; 2]) -> Vec<Vec<Soup>>) -> Self {
        Self { size, cull: Cull::None, pictures, plan: |plan| plan }
    }

    /// With another plan.
    const fn by(self, plan: fn(Plan) -> Plan) -> Self {
        Self { plan, ..self }
    }

    const fn culling(self, cull: Cull) -> Self {
        Self { cull, ..self }
    }
}

/// So many threads, if the method has several at all.
fn threads(plan: Plan, threads: usize) -> Plan {
    if plan.threads == 1 { plan } else { Plan { threads, ..plan } }
}

/// Tiles of that side, if the method has tiles.
fn side(plan: Plan, side: i32) -> Plan {
    Plan { tile: plan.tile.map(|_| side), ..threads(plan, 2) }
}

/// A picture of a hundred pixels a side, more or less, with blocks and tiles that are cut by its border.
const SIZE: [u16; 2] = [101, 77];

const PIXEL: i32 = 256;

/// A corner in whole pixels.
const fn px(x: i32, y: i32) -> Corner {
    Corner::at(PIXEL * x, PIXEL * y)
}

/// A corner with another depth.
const fn deep(corner: Corner, z: f32) -> Corner {
    Corner { z, ..corner }
}

/// A corner with another w.
const fn far(corner: Corner, w: f32) -> Corner {
    Corner { w, ..corner }
}

/// One mesh of these triangles in one picture.
fn one(triangles: &[[Corner; 3]], size: [u16; 2]) -> Vec<Vec<Soup>> {
    vec![vec![Soup::apart(triangles, size)]]
}

/// A triangle over most of the picture.
const LARGE: [Corner; 3] = [px(3, 2), px(95, 11), px(40, 71)];

/// A triangle that is larger than the picture.
const FULL: [Corner; 3] = [px(-200, -100), px(400, -100), px(50, 500)];

/// As many layers as that, each nearer than the one before or farther.
fn layers(count: u8, nearer: bool, size: [u16; 2]) -> Vec<Vec<Soup>> {
    let layer = |n: u8| {
        let share = f32::from(n + 1) / f32::from(count + 2);
        FULL.map(|corner| deep(corner, if nearer { 1.0 - share } else { share }))
    };
    one(&(0..count).map(layer).collect::<Vec<_>>(), size)
}

/// A grid of squares of that side in 1/256 px all over the picture, with waves in its depth.
fn grid(step: i32, size: [u16; 2]) -> Soup {
    let [across, up] = size.map(|side| i32::from(side) * PIXEL / step + 2);
    let corner = |column: i32, row: i32| Corner {
        x: column * step,
        y: row * step,
        z: 0.5 + 0.4 * ((column * 7 + row * 5) % 11) as f32 / 11.0,
        w: 1.0 + ((column + row) % 3) as f32,
    };
    let corners: Vec<Corner> = (0..up).flat_map(|y| (0..across).map(move |x| corner(x, y))).collect();
    Soup::grid(&corners, across as usize, size)
}

/// Triangles as in a wheel about a place, each with the next a side in common.
fn wheel(middle: Corner, reach: i32, count: u16, size: [u16; 2]) -> Soup {
    let rim = |n: u16| {
        let (sin, cos) = (f32::from(n) * std::f32::consts::TAU / f32::from(count)).sin_cos();
        let [x, y] = [cos, sin].map(|share| (share * reach as f32) as i32);
        Corner { x: middle.x + x, y: middle.y + y, ..middle }
    };
    Soup::apart(&(0..count).map(|n| [middle, rim(n), rim(n + 1)]).collect::<Vec<_>>(), size)
}

/// A sphere of radius 1 from an eye at that place, looking along −z.
fn sphere(eye: Vec3, near: f32, [width, height]: [u16; 2]) -> Soup {
    let shape = scene::sphere(12, 24);
    let projection = perspective(90.0, f32::from(width) / f32::from(height), near, 10.0);
    let to_clip =
        projection.unwrap_or(Mat4::IDENTITY) * view(eye, eye - Vec3::Z, Vec3::Y).unwrap_or_default();
    Soup {
        positions: shape.vertices.iter().map(|vertex| to_clip * vertex.position.extend(1.0)).collect(),
        triangles: shape.triangles,
        drops: Drops::Nothing,
    }
}

/// The same triangle again and again, at one depth.
fn equals(size: [u16; 2]) -> Vec<Vec<Soup>> {
    one(&[LARGE, [LARGE[1], LARGE[2], LARGE[0]], [LARGE[2], LARGE[1], LARGE[0]], FULL], size)
}

const ALL: &[Row] = &[("simple, blocks, simd, tiles, hierarchical-depth, deferred, threads", Exact)];

const CELLS: &[Case<Cell>] = &[
    ("no mesh", Cell::new(SIZE, |_| vec![Vec::new()]), ALL),
    ("no triangle", Cell::new(SIZE, |size| one(&[], size)), ALL),
    ("one triangle", Cell::new(SIZE, |size| one(&[LARGE], size)), ALL),
    ("one clockwise", Cell::new(SIZE, |size| one(&[[LARGE[0], LARGE[2], LARGE[1]]], size)), ALL),
    (
        "backs left out",
        Cell::new(SIZE, |size| one(&[LARGE, [FULL[0], FULL[2], FULL[1]]], size)).culling(Cull::Back),
        ALL,
    ),
    (
        "fronts left out",
        Cell::new(SIZE, |size| one(&[LARGE, [FULL[0], FULL[2], FULL[1]]], size)).culling(Cull::Front),
        ALL,
    ),
    (
        "without area",
        Cell::new(SIZE, |size| one(&[[px(3, 3), px(40, 40), px(80, 80)], [px(9, 9); 3]], size)),
        ALL,
    ),
    (
        "beside the picture",
        Cell::new(SIZE, |size| one(&[FULL.map(|c| Corner { x: c.x + (1 << 18), ..c })], size)),
        ALL,
    ),
    ("larger than the picture", Cell::new(SIZE, |size| one(&[FULL], size)), ALL),
    (
        "as far as the guard band",
        Cell::new(SIZE, |size| one(&[[px(-30_000, -20_000), px(32_000, -31_000), px(1000, 32_000)]], size)),
        ALL,
    ),
    (
        "beyond the guard band",
        Cell::new(SIZE, |size| {
            one(&[[px(-90_000, -5000), px(4_000_000, -70_000), px(-60_000, 7_000_000)]], size)
        }),
        ALL,
    ),
    (
        "thin and beyond the guard band",
        Cell::new(SIZE, |size| {
            one(&[[px(-4_000_000, -3_000_000), px(4_000_000, 3_000_100), px(4_000_000, 3_000_000)]], size)
        }),
        ALL,
    ),
    ("squares of a pixel", Cell::new(SIZE, |size| vec![vec![grid(256, size)]]), ALL),
    ("less than a pixel", Cell::new(SIZE, |size| vec![vec![grid(117, size)]]), ALL),
    ("squares of a block", Cell::new(SIZE, |size| vec![vec![grid(2048, size)]]), ALL),
    ("squares of two blocks less a bit", Cell::new(SIZE, |size| vec![vec![grid(4095, size)]]), ALL),
    ("squares of a tile", Cell::new([200, 150], |size| vec![vec![grid(64 * 256, size)]]), ALL),
    ("squares of a tile and a bit", Cell::new([200, 150], |size| vec![vec![grid(64 * 256 + 1, size)]]), ALL),
    ("a fan of slivers", Cell::new(SIZE, |size| vec![vec![wheel(px(50, 38), 256 * 200, 2000, size)]]), ALL),
    (
        "a fan about a pixel's centre",
        Cell::new(SIZE, |size| vec![vec![wheel(Corner::at(12_928, 9_856), 256 * 30, 64, size)]]),
        ALL,
    ),
    (
        "a fan about a tile's corner",
        Cell::new([128, 128], |size| vec![vec![wheel(px(64, 64), 256 * 90, 100, size)]]),
        ALL,
    ),
    (
        "sides through centres of pixels",
        Cell::new(SIZE, |size| {
            let c = |x: i32, y: i32| Corner::at(256 * x + 128, 256 * y + 128);
            one(
                &[
                    [c(8, 8), c(40, 8), c(40, 40)],
                    [c(8, 8), c(40, 40), c(8, 40)],
                    [c(40, 40), c(40, 8), c(72, 40)],
                ],
                size,
            )
        }),
        ALL,
    ),
    (
        "a block to the pixel",
        Cell::new(SIZE, |size| {
            one(&[[px(16, 16), px(24, 16), px(24, 24)], [px(16, 16), px(24, 24), px(16, 24)]], size)
        }),
        ALL,
    ),
    (
        "a pixel at a block's corner",
        Cell::new(SIZE, |size| {
            let at = |x: i32, y: i32| {
                [px(x, y), Corner::at(256 * x + 257, 256 * y), Corner::at(256 * x, 256 * y + 257)]
            };
            one(
                &[
                    at(8, 8),
                    at(15, 8),
                    at(8, 15),
                    at(15, 15),
                    at(63, 63),
                    at(64, 64),
                    at(64, 63),
                    at(100, 76),
                ],
                size,
            )
        }),
        ALL,
    ),
    ("front to back", Cell::new(SIZE, |size| layers(20, false, size)), ALL),
    ("back to front", Cell::new(SIZE, |size| layers(20, true, size)), ALL),
    (
        "a part of a block, then all of it, then a part by another mesh",
        Cell::new(SIZE, |size| {
            let small = |x: i32, z: f32| [px(x, 17), px(x + 2, 17), px(x, 22)].map(|corner| deep(corner, z));
            let full = FULL.map(|corner| deep(corner, 0.5));
            let meshes = || vec![Soup::apart(&[small(17, 0.7), full], size), Soup::apart(&[small(21, 0.3)], size)];
            vec![meshes(), meshes()]
        }),
        ALL,
    ),
    (
        "through each other",
        Cell::new(SIZE, |size| {
            let tilted = |z: [f32; 3]| [0, 1, 2].map(|n| deep(FULL[n], z[n]));
            one(&[tilted([0.1, 0.9, 0.5]), tilted([0.9, 0.1, 0.5]), tilted([0.5, 0.5, 0.2])], size)
        }),
        ALL,
    ),
    ("equal depths", Cell::new(SIZE, equals), ALL),
    (
        "equal depths in each other's plane",
        Cell::new(SIZE, |size| {
            let plane = |corner: Corner| deep(corner, (corner.x + 2 * corner.y) as f32 / 1e6 + 0.4);
            one(&[LARGE.map(plane), FULL.map(plane), [FULL[2], LARGE[0], LARGE[1]].map(plane)], size)
        }),
        ALL,
    ),
    (
        "a bit nearer each time",
        Cell::new(SIZE, |size| {
            let layer = |n: u32| FULL.map(|corner| deep(corner, f32::from_bits(0.5_f32.to_bits() - n / 2)));
            one(&(0..40).map(layer).collect::<Vec<_>>(), size)
        }),
        ALL,
    ),
    (
        "a bit nearer in a corner",
        Cell::new(SIZE, |size| {
            let z = |bits: u32| f32::from_bits(0.7_f32.to_bits() - bits);
            one(
                &[
                    FULL.map(|c| deep(c, z(0))),
                    [deep(FULL[0], z(0)), deep(FULL[1], z(1)), deep(FULL[2], z(3))],
                ],
                size,
            )
        }),
        ALL,
    ),
    (
        "at the near plane and the far one",
        Cell::new(SIZE, |size| {
            one(
                &[
                    FULL.map(|c| deep(c, 1.0)),
                    LARGE.map(|c| deep(c, 0.0)),
                    FULL.map(|c| deep(c, 1.0 - f32::EPSILON)),
                ],
                size,
            )
        }),
        ALL,
    ),
    (
        "depths beyond near and far",
        Cell::new(SIZE, |size| {
            one(
                &[
                    [deep(FULL[0], -3.0), deep(FULL[1], 0.5), deep(FULL[2], 7.0)],
                    LARGE.map(|c| deep(c, -0.1)),
                ],
                size,
            )
        }),
        ALL,
    ),
    (
        "depths that are no numbers",
        Cell::new(SIZE, |size| {
            let odd = |z| [LARGE[0], LARGE[1], deep(LARGE[2], z)];
            one(&[odd(f32::NAN), odd(f32::INFINITY), odd(f32::NEG_INFINITY), odd(f32::MAX), FULL], size)
        }),
        ALL,
    ),
    (
        "places that are no numbers",
        Cell::new(SIZE, |size| {
            let mut soup = Soup::apart(&[LARGE, LARGE, LARGE, LARGE, FULL], size);
            soup.positions[0].x = f32::NAN;
            soup.positions[3].y = f32::NAN;
            soup.positions[7].x = f32::INFINITY;
            soup.positions[11].y = f32::NEG_INFINITY;
            vec![vec![soup]]
        }),
        ALL,
    ),
    (
        "w from near to far",
        Cell::new(SIZE, |size| {
            one(
                &[
                    [far(FULL[0], 0.01), far(FULL[1], 50.0), FULL[2]],
                    [LARGE[0], far(LARGE[1], 1e-5), far(LARGE[2], 1e9)],
                ],
                size,
            )
        }),
        ALL,
    ),
    (
        "w near 0",
        Cell::new(SIZE, |size| {
            one(
                &[[far(FULL[0], 1.01e-6), FULL[1], FULL[2]], [LARGE[0], far(LARGE[1], 0.99e-6), LARGE[2]]],
                size,
            )
        }),
        ALL,
    ),
    (
        "w 0, below, and no number",
        Cell::new(SIZE, |size| {
            let odd = |w| [LARGE[0], LARGE[1], far(LARGE[2], w)];
            one(
                &[
                    odd(0.0),
                    odd(-0.0),
                    odd(-1.0),
                    odd(f32::NAN),
                    odd(f32::INFINITY),
                    odd(1e38),
                    odd(1e-38),
                    FULL,
                ],
                size,
            )
        }),
        ALL,
    ),
    ("all behind the eye", Cell::new(SIZE, |size| one(&[FULL.map(|c| far(c, -1.0))], size)), ALL),
    (
        "an eye before a mesh",
        Cell::new(SIZE, |size| vec![vec![sphere(Vec3::new(0.2, 0.1, 1.9), 0.1, size)]]),
        ALL,
    ),
    (
        "an eye inside a mesh",
        Cell::new(SIZE, |size| vec![vec![sphere(Vec3::new(0.3, -0.2, 0.4), 0.01, size)]]),
        ALL,
    ),
    (
        "an eye in a mesh's surface",
        Cell::new(SIZE, |size| vec![vec![sphere(Vec3::new(0.0, 0.0, 1.0), 0.001, size)]]),
        ALL,
    ),
    (
        "inside, and fronts left out",
        Cell::new(SIZE, |size| vec![vec![sphere(Vec3::new(0.3, -0.2, 0.4), 0.01, size)]])
            .culling(Cull::Front),
        ALL,
    ),
    (
        "every other pixel dropped",
        Cell::new(SIZE, |size| {
            vec![layers(9, false, size).remove(0).remove(0).dropping(Drops::Checker)]
                .into_iter()
                .map(|s| vec![s])
                .collect()
        }),
        ALL,
    ),
    (
        "pixels dropped before what is hidden",
        Cell::new(SIZE, |size| {
            vec![vec![
                Soup::apart(&[FULL.map(|c| deep(c, 0.1))], size).dropping(Drops::All),
                Soup::apart(&[FULL.map(|c| deep(c, 0.2))], size).dropping(Drops::Checker),
                Soup::apart(&[FULL.map(|c| deep(c, 0.9))], size),
            ]]
        }),
        ALL,
    ),
    (
        "dropped where a varying is no number",
        Cell::new(SIZE, |size| vec![vec![grid(700, size).dropping(Drops::Nan), grid(900, size)]]),
        ALL,
    ),
    (
        "triangles left out by the shader",
        Cell::new(SIZE, |size| vec![vec![grid(900, size).dropping(Drops::Triangles)]]),
        ALL,
    ),
    (
        "meshes over each other",
        Cell::new(SIZE, |size| {
            vec![vec![
                grid(900, size),
                wheel(px(50, 38), 9000, 30, size),
                grid(1700, size).dropping(Drops::Some),
                sphere(Vec3::new(0.0, 0.0, 1.6), 0.1, size),
            ]]
        }),
        ALL,
    ),
    (
        "a frame used again for fewer and for more",
        Cell::new(SIZE, |size| {
            vec![
                vec![grid(900, size), wheel(px(50, 38), 9000, 30, size)],
                vec![Soup::apart(&[[px(2, 2), px(7, 2), px(2, 7)]], size)],
                Vec::new(),
                vec![grid(500, size), grid(511, size)],
            ]
        }),
        ALL,
    ),
    ("1×1", Cell::new([1, 1], |size| vec![vec![grid(100, size)], Vec::new(), equals(size).remove(0)]), ALL),
    (
        "1×1, nothing covered",
        Cell::new([1, 1], |size| one(&[[px(0, 0), Corner::at(127, 0), Corner::at(0, 127)]], size)),
        ALL,
    ),
    ("7×5", Cell::new([7, 5], |size| vec![vec![grid(100, size)], equals(size).remove(0)]), ALL),
    ("8×8", Cell::new([8, 8], |size| vec![vec![grid(300, size)], equals(size).remove(0)]), ALL),
    ("64×64", Cell::new([64, 64], |size| vec![vec![grid(300, size)], equals(size).remove(0)]), ALL),
    ("65×63", Cell::new([65, 63], |size| vec![vec![grid(300, size)], equals(size).remove(0)]), ALL),
    (
        "1000×3",
        Cell::new([1000, 3], |size| vec![vec![grid(300, size)], layers(5, true, size).remove(0)]),
        ALL,
    ),
    (
        "3×1000",
        Cell::new([3, 1000], |size| vec![vec![grid(300, size)], layers(5, true, size).remove(0)]),
        ALL,
    ),
    (
        "as wide as an image can be",
        Cell::new([65_535, 2], |size| {
            vec![Soup::apart(
                &[
                    [px(-20, -9), px(65_000, -7), px(66_000, 40)],
                    [px(-7_000_000, -9), px(7_000_000, -7), px(65_000, 3)],
                ],
                size,
            )]
            .into_iter()
            .map(|s| vec![s])
            .collect()
        }),
        ALL,
    ),
    (
        "tiles of 8",
        Cell::new(SIZE, |size| vec![vec![grid(900, size), grid(300, size)]]).by(|plan| side(plan, 8)),
        ALL,
    ),
    (
        "tiles of 16",
        Cell::new(SIZE, |size| vec![vec![grid(900, size), grid(300, size)]]).by(|plan| side(plan, 16)),
        ALL,
    ),
    (
        "tiles of 24",
        Cell::new(SIZE, |size| vec![vec![grid(900, size), grid(300, size)]]).by(|plan| side(plan, 24)),
        ALL,
    ),
    (
        "tiles of 104, as wide as the picture",
        Cell::new(SIZE, |size| vec![vec![grid(900, size), grid(300, size)]]).by(|plan| side(plan, 104)),
        ALL,
    ),
    (
        "tiles larger than the picture",
        Cell::new(SIZE, |size| vec![vec![grid(900, size), grid(300, size)]]).by(|plan| side(plan, 4096)),
        ALL,
    ),
    (
        "large triangles in tiles of 8",
        Cell::new(SIZE, |size| layers(12, true, size)).by(|plan| side(plan, 8)),
        ALL,
    ),
    (
        "1 thread",
        Cell::new(SIZE, |size| vec![vec![grid(900, size), grid(300, size)]]).by(|plan| threads(plan, 1)),
        ALL,
    ),
    (
        "3 threads",
        Cell::new(SIZE, |size| vec![vec![grid(900, size), grid(300, size)]]).by(|plan| threads(plan, 3)),
        ALL,
    ),
    (
        "8 threads",
        Cell::new(SIZE, |size| vec![vec![grid(900, size), grid(300, size)]]).by(|plan| threads(plan, 8)),
        ALL,
    ),
    (
        "64 threads",
        Cell::new(SIZE, |size| vec![vec![grid(900, size), grid(300, size)]]).by(|plan| threads(plan, 64)),
        ALL,
    ),
    (
        "64 threads for a pixel",
        Cell::new([1, 1], |size| vec![vec![grid(100, size)]]).by(|plan| threads(plan, 64)),
        ALL,
    ),
    (
        "64 threads, tiles of 8",
        Cell::new(SIZE, |size| layers(12, true, size)).by(|plan| threads(side(plan, 8), 64)),
        ALL,
    ),
];

/// What the pixels are seen against; transparent ones would show where alpha is lost.
const BACKGROUND: Color = Color { r: 20, g: 30, b: 40, a: 50 };

#[test]
fn each_method_draws_lesson_13s_pixels() {
    every_method(LESSON.name, METHODS, CELLS, |method, cell| {
        let way = match method.run.plan {
            Some(plan) => Way::tiled((cell.plan)(threads(plan, 2))),
            None if method.name == "blocks" => Way::Blocks,
            None => Way::Simple,
        };
        wrong(cell, way)
    });
}

/// What of a cell is wrong.
fn wrong(cell: &Cell, way: Way) -> Vec<String> {
    let size = cell.size;
    let mut frame = match way {
        Way::Tiled(plan, level) => Some(frame(size, plan).at_level(level)),
        Way::Simple | Way::Blocks => None,
    };
    let picture = |soups: Vec<Soup>| {
        let draw = |canvas: &mut Canvas| {
            let mut counts = Counts::default();
            soups.iter().for_each(|soup| counts += canvas.draw(&soup.shader(), &soup.mesh(), cell.cull));
            counts
        };
        let (expected, counts) = drawn(Way::Simple, size, BACKGROUND, draw);
        let (got, got_counts) = match &mut frame {
            Some(frame) => again(frame, size, BACKGROUND, draw),
            None => drawn(way, size, BACKGROUND, draw),
        };
        let counted = (counts != got_counts).then(|| format!("{got_counts:?}, not {counts:?}"));
        [differing(&expected, &got), counted]
    };
    (cell.pictures)(size).into_iter().flat_map(picture).flatten().collect()
}

/// Most cells are about something: they cover pixels, but those that say that they do not.
#[test]
fn cells_draw_what_they_say() {
    for (name, cell, _) in CELLS {
        let covered: usize = (cell.pictures)(cell.size)
            .iter()
            .map(|soups| {
                let draw = |canvas: &mut Canvas| {
                    let mut counts = Counts::default();
                    soups
                        .iter()
                        .for_each(|soup| counts += canvas.draw(&soup.shader(), &soup.mesh(), cell.cull));
                    counts
                };
                let (image, _): (Image, Counts) = drawn(Way::Simple, cell.size, BACKGROUND, draw);
                image.pixels().filter(|pixel| pixel.2 != BACKGROUND).count()
            })
            .sum();
        let nothing = [
            "no mesh",
            "no triangle",
            "without area",
            "beside the picture",
            "all behind the eye",
            "1×1, nothing covered",
        ];
        assert_eq!(covered == 0, nothing.contains(name), "{name}: {covered}");
    }
}

/// The table's methods, each with what the one before has and one idea more.
#[test]
fn each_method_has_one_idea_more() {
    let plans: Vec<Option<Plan>> = METHODS.iter().map(|method| method.run.plan).collect();
    let ideas = |plan: &Option<Plan>| {
        plan.map_or(0, |plan| {
            1 + usize::from(plan.tile.is_some())
                + usize::from(plan.hierarchical)
                + usize::from(plan.deferred)
                + usize::from(plan.threads != 1)
        })
    };
    let counts: Vec<usize> = plans.iter().map(ideas).collect();
    assert_eq!(counts, [0, 0, 1, 2, 3, 4, 5]);
}
