use checks::texel::{clamped, repeated};
use common::{Attributes, Color, Format, Image, Method, Model, Vec2, Vec3};
use textures::{LESSON, METHODS, Sampler, texel};
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, Row, every_method};

use crate::labelled;

/// (u, v), and the size of the texture.
type Given = ((f32, f32), (u16, u16));

const ALL_EXACT: &[Row] = &[("truncate, round, nearest, repeat", Exact)];
const JUST_BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// Where to look, and what each method must find: the exact texel, or else the column and row of another one, or
/// black. Outside, `repeat` is to find the texel of the tiled plane, the others the nearest one of the texture.
const TABLE: &[Case<Given>] = &[
    ("in the first quarter of a texel", ((0.3, 0.55), (4, 4)), ALL_EXACT),
    (
        "in the middle of a texel",
        ((0.375, 0.625), (4, 4)),
        &[("truncate, nearest, repeat", Exact), ("round", Fails("2 3"))],
    ),
    ("on the border of two texels", ((0.25, 0.5), (4, 4)), ALL_EXACT),
    ("u = 0, v = 0", ((0.0, 0.0), (4, 4)), ALL_EXACT),
    ("u = 1", ((1.0, 0.5), (4, 4)), &[("truncate, round", Fails("black")), ("nearest, repeat", Exact)]),
    ("v = 1", ((0.5, 1.0), (4, 4)), &[("truncate, round", Fails("black")), ("nearest, repeat", Exact)]),
    (
        "just below 1",
        ((JUST_BELOW_ONE, 0.0), (4, 4)),
        &[("truncate, nearest, repeat", Exact), ("round", Fails("black"))],
    ),
    (
        "0.7, which as f32 is below 7/10, but not its product with 10",
        ((0.7, 0.0), (10, 1)),
        &[("truncate, round, nearest, repeat", Fails("7 0"))],
    ),
    (
        "just below 0",
        ((-0.125, 0.0), (4, 4)),
        &[("truncate, nearest, repeat", Exact), ("round", Fails("black"))],
    ),
    (
        "far below 0",
        ((-2.625, -1.375), (4, 4)),
        &[("truncate, round", Fails("black")), ("nearest, repeat", Exact)],
    ),
    (
        "beyond 1",
        ((1.375, 7.625), (4, 4)),
        &[("truncate, round", Fails("black")), ("nearest, repeat", Exact)],
    ),
    (
        "so little below 0 that 1 is left",
        ((-1e-9, 0.0), (4, 4)),
        &[("truncate, round, nearest, repeat", Exact)],
    ),
    (
        "10^6 and some, both ways",
        ((1e6 + 0.375, -1e6 + 0.375), (4, 4)),
        &[("truncate, round", Fails("black")), ("nearest, repeat", Exact)],
    ),
    (
        "2^23 - 1/2, the last place inside a tile",
        ((8_388_607.5, 0.0), (4, 4)),
        &[("truncate, round", Fails("black")), ("nearest, repeat", Exact)],
    ),
    ("10^10", ((1e10, 1e10), (4, 4)), &[("truncate, round", Fails("black")), ("nearest, repeat", Exact)]),
    ("NaN", ((f32::NAN, f32::NAN), (4, 4)), ALL_EXACT),
    (
        "infinite",
        ((f32::INFINITY, f32::NEG_INFINITY), (4, 4)),
        &[("truncate, round", Fails("black")), ("nearest", Fails("3 0")), ("repeat", Exact)],
    ),
    (
        "1×1 texel, in its middle",
        ((0.5, 0.5), (1, 1)),
        &[("truncate, nearest, repeat", Exact), ("round", Fails("black"))],
    ),
    (
        "1×1 texel, at (1, 1)",
        ((1.0, 1.0), (1, 1)),
        &[("truncate, round", Fails("black")), ("nearest, repeat", Exact)],
    ),
    ("no texels", ((0.5, 0.5), (0, 0)), ALL_EXACT),
];

/// The exact texel's colour. What is not finite counts as 0, and without texels all is black.
fn expected(name: &str, u: f32, v: f32, (width, height): (u16, u16)) -> Color {
    if width == 0 || height == 0 {
        return Color::BLACK;
    }
    let find = if name == "repeat" { repeated } else { clamped };
    let [x, y] = [(u, width), (v, height)].map(|(c, n)| find(c, n).unwrap_or(0));
    Color::rgb(x as u8, y as u8, 255)
}

#[test]
fn every_method_does_what_it_must() {
    every_method(LESSON.name, METHODS, TABLE, |method, &((u, v), size)| {
        found(method, (u, v), size, expected(method.name, u, v, size))
    });
}

/// What a method finds in a labelled texture instead of a colour.
fn found(method: &Method<Sampler>, (u, v): (f32, f32), size: (u16, u16), expected: Color) -> Vec<String> {
    match (method.run.sample)(&labelled(size.0, size.1), Vec2::new(u, v)) {
        color if color == expected => vec![],
        Color { b: 0, .. } => vec!["black".into()],
        Color { r, g, .. } => vec![format!("{r} {g}")],
    }
}

/// The borders of a texture that is not to be repeated: at u = 1 `repeat` is at the left one again, and just below 0 at
/// the right one.
const SEAM: &[Case<Given>] = &[
    (
        "the right border",
        ((1.0, 0.5), (4, 4)),
        &[("truncate, round", Fails("black")), ("nearest", Exact), ("repeat", Fails("0 2"))],
    ),
    (
        "just beyond the left one",
        ((-1e-9, 0.5), (4, 4)),
        &[("truncate, round, nearest", Exact), ("repeat", Fails("3 2"))],
    ),
];

#[test]
fn repeat_has_a_seam() {
    every_method(LESSON.name, METHODS, SEAM, |method, &((u, v), size)| {
        found(method, (u, v), size, expected("nearest", u, v, size))
    });
}

/// How many pixels of a row fall on a texel, or how many texels on a pixel: enlarged, a texel is a block; made smaller,
/// a pixel has the colour of one texel of many.
const SCALED: &[Case<(u16, u16)>] = &[
    ("8 times as large", (8, 1), &[("truncate, round, nearest, repeat", Fails("blocks of 8 px"))]),
    ("as large as it is", (1, 1), &[("truncate, round, nearest, repeat", Exact)]),
    ("8 times smaller", (1, 8), &[("truncate, round, nearest, repeat", Fails("128 levels off the mean"))]),
];

#[test]
fn blocks_when_enlarged_and_sparkles_when_made_smaller() {
    // A row of black and white texels by turns.
    let mut texture = Image::new(64, 1, Format::Gray);
    (0..64).step_by(2).for_each(|x| texture.set(x, 0, Color::WHITE));
    every_method(LESSON.name, METHODS, SCALED, |method, &(larger, smaller)| {
        let pixels = 32 * larger / smaller;
        let level = |n: u16| {
            let u = (f32::from(n) + 0.5) / f32::from(pixels) / 2.0;
            (method.run.sample)(&texture, Vec2::new(u, 0.25)).r
        };
        let row: Vec<u8> = (0..pixels).map(level).collect();
        let longest = row.chunk_by(|a, b| a == b).map(<[u8]>::len).max().unwrap_or(0);
        let mean = row.iter().map(|&level| f64::from(level)).sum::<f64>() / f64::from(pixels);
        let off = (mean - 127.5).abs();
        let mut faults = Vec::new();
        if longest > 1 && smaller == 1 {
            faults.push(format!("blocks of {longest} px"));
        }
        if off > 0.5 {
            faults.push(format!("{off:.0} levels off the mean"));
        }
        faults
    });
}

/// How much of a texture of 16×16 texels each method gets wrong, at 64 points a texel.
const SHARES: &[Case<u16>] =
    &[("16×16 texels", 16, &[("truncate, nearest, repeat", Exact), ("round", Fails("75 % wrong"))])];

#[test]
fn round_is_wrong_in_half_of_each_texel_and_direction() {
    every_method(LESSON.name, METHODS, SHARES, |method, &side| {
        let (texture, per_side) = (labelled(side, side), 8 * side);
        let at = |n: u16| (f32::from(n) + 0.5) / f32::from(per_side);
        let points = (0..per_side).flat_map(|i| (0..per_side).map(move |j| [at(i), at(j)]));
        let wrong = points.filter(|&[u, v]| {
            (method.run.sample)(&texture, Vec2::new(u, v)) != expected(method.name, u, v, (side, side))
        });
        let share = wrong.count() * 100 / usize::from(per_side).pow(2);
        if share > 0 { vec![format!("{share} % wrong")] } else { vec![] }
    });
}

/// Without texture coordinates there is nothing to look up: nothing is drawn, and nothing panics. (The program
/// refuses such a model.)
#[test]
fn a_model_without_coordinates_draws_nothing() {
    let text = b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 1 2 3\n";
    let model = Model::parse(text, Attributes { uvs: true, normals: false }).unwrap();
    for method in METHODS {
        let mut picture = Image::new(9, 9, Format::Rgb);
        (method.run.draw)(&model, &labelled(4, 4), Vec3::Z, &mut picture);
        assert_eq!(picture, Image::new(9, 9, Format::Rgb), "{}", method.name);
    }
}

/// The rows of a texture: v = 0 is the bottom one.
#[test]
fn v_points_up() {
    let texture = labelled(3, 3);
    assert_eq!(texel(&texture, Vec2::new(0.1, 0.1)), texture.get(0, 0).unwrap());
    assert_eq!(texel(&texture, Vec2::new(0.9, 0.1)), texture.get(2, 0).unwrap());
    assert_eq!(texel(&texture, Vec2::new(0.1, 0.9)), texture.get(0, 2).unwrap());
}
