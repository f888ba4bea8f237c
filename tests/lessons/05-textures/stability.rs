use checks::texel::{clamped, repeated};
use common::{Attributes, Color, Format, Image, Model, Vec2, Vec3};
use textures::{METHODS, texel};
use verify::method;

/// What must happen.
#[derive(Debug)]
enum Must {
    /// The texel that the exact reference names.
    Exact,
    /// Another one, or black.
    Fail(&'static str),
}
use Must::{Exact, Fail};

type Row = (&'static str, Must);
type Case = (&'static str, (f32, f32), (u16, u16), &'static [Row]);

const ALL_EXACT: &[Row] = &[("truncate", Exact), ("round", Exact), ("nearest", Exact), ("repeat", Exact)];
const JUST_BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// Input, (u, v), the size of the texture, and what each method must find. Outside, `repeat` is to find the
/// texel of the tiled plane, the others the nearest one of the texture.
const TABLE: &[Case] = &[
    ("in the first quarter of a texel", (0.3, 0.55), (4, 4), ALL_EXACT),
    (
        "in the middle of a texel",
        (0.375, 0.625),
        (4, 4),
        &[("truncate", Exact), ("round", Fail("2 3")), ("nearest", Exact), ("repeat", Exact)],
    ),
    ("on the border of two texels", (0.25, 0.5), (4, 4), ALL_EXACT),
    ("u = 0, v = 0", (0.0, 0.0), (4, 4), ALL_EXACT),
    (
        "u = 1",
        (1.0, 0.5),
        (4, 4),
        &[("truncate", Fail("black")), ("round", Fail("black")), ("nearest", Exact), ("repeat", Exact)],
    ),
    (
        "v = 1",
        (0.5, 1.0),
        (4, 4),
        &[("truncate", Fail("black")), ("round", Fail("black")), ("nearest", Exact), ("repeat", Exact)],
    ),
    (
        "just below 1",
        (JUST_BELOW_ONE, 0.0),
        (4, 4),
        &[("truncate", Exact), ("round", Fail("black")), ("nearest", Exact), ("repeat", Exact)],
    ),
    (
        "0.7, which as f32 is below 7/10, but not its product with 10",
        (0.7, 0.0),
        (10, 1),
        &[
            ("truncate", Fail("7 0")),
            ("round", Fail("7 0")),
            ("nearest", Fail("7 0")),
            ("repeat", Fail("7 0")),
        ],
    ),
    (
        "just below 0",
        (-0.125, 0.0),
        (4, 4),
        &[("truncate", Exact), ("round", Fail("black")), ("nearest", Exact), ("repeat", Exact)],
    ),
    (
        "far below 0",
        (-2.625, -1.375),
        (4, 4),
        &[("truncate", Fail("black")), ("round", Fail("black")), ("nearest", Exact), ("repeat", Exact)],
    ),
    (
        "beyond 1",
        (1.375, 7.625),
        (4, 4),
        &[("truncate", Fail("black")), ("round", Fail("black")), ("nearest", Exact), ("repeat", Exact)],
    ),
    (
        "so little below 0 that 1 is left",
        (-1e-9, 0.0),
        (4, 4),
        &[("truncate", Exact), ("round", Exact), ("nearest", Exact), ("repeat", Exact)],
    ),
    (
        "10^10",
        (1e10, 1e10),
        (4, 4),
        &[("truncate", Fail("black")), ("round", Fail("black")), ("nearest", Exact), ("repeat", Exact)],
    ),
    ("NaN", (f32::NAN, f32::NAN), (4, 4), ALL_EXACT),
    (
        "infinite",
        (f32::INFINITY, f32::NEG_INFINITY),
        (4, 4),
        &[("truncate", Fail("black")), ("round", Fail("black")), ("nearest", Fail("3 0")), ("repeat", Exact)],
    ),
    (
        "1×1 texel, in its middle",
        (0.5, 0.5),
        (1, 1),
        &[("truncate", Exact), ("round", Fail("black")), ("nearest", Exact), ("repeat", Exact)],
    ),
    (
        "1×1 texel, at (1, 1)",
        (1.0, 1.0),
        (1, 1),
        &[("truncate", Fail("black")), ("round", Fail("black")), ("nearest", Exact), ("repeat", Exact)],
    ),
    ("no texels", (0.5, 0.5), (0, 0), ALL_EXACT),
];

/// A texture in which each texel's colour says where it is. None is black.
fn labelled(width: u16, height: u16) -> Image {
    let mut texture = Image::new(width, height, Format::Rgb);
    for (x, y, _) in texture.clone().pixels() {
        texture.set(x, y, Color::rgb(x as u8, y as u8, 255));
    }
    texture
}

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
    for (input, (u, v), size, rows) in TABLE {
        assert!(rows.iter().map(|row| row.0).eq(METHODS.iter().map(|method| method.name)), "{input}");
        for (name, must) in *rows {
            let color = (method(METHODS, name).sample)(&labelled(size.0, size.1), Vec2::new(*u, *v));
            let got = match color {
                color if color == expected(name, *u, *v, *size) => "exact".into(),
                Color { b: 0, .. } => "black".into(),
                Color { r, g, .. } => format!("{r} {g}"),
            };
            let expected = match *must {
                Exact => "exact",
                Fail(expected) => expected,
            };
            assert!(got == expected, "{input}, {name}: {got}, but {must:?} was expected");
        }
    }
}

/// How much of a texture each method gets wrong, at 64 points a texel.
#[test]
fn round_is_wrong_in_half_of_each_texel_and_direction() {
    let texture = labelled(16, 16);
    let points = || (0..128).flat_map(|i| (0..128).map(move |j| [i, j].map(|n| (n as f32 + 0.5) / 128.0)));
    let shares = METHODS.iter().map(|method| {
        let wrong = points().filter(|&[u, v]| {
            (method.run.sample)(&texture, Vec2::new(u, v)) != expected(method.name, u, v, (16, 16))
        });
        (method.name, wrong.count() * 100 / (128 * 128))
    });
    let expected = [("truncate", 0), ("round", 75), ("nearest", 0), ("repeat", 0)];
    assert_eq!(shares.collect::<Vec<_>>(), expected);
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
