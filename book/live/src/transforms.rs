//! Lesson 7: matrices, viewport and projection.

use common::{Color, Format, Image, Mat4, Vec2, Vec3};
use gouraud::{Scene, Wrap, gouraud};
use sheet::{BLACK, BLUE, GREY, Ink, ORANGE, SKY, Sheet};
use transforms::affine::rotate_z;
use transforms::{place, projection, translate, viewport};

use crate::head::{SIDE, Turned};
use crate::{Drawing, Figure, Input, Values, View, number};

/// The order of a turn and a move.
pub(crate) const ORDER: Figure = Figure {
    name: "transforms-order",
    hint: "Change the turn R and the move T.",
    inputs: &[
        Input::Slider { label: "R turns by, in degrees", from: 90.0, range: [-180.0, 180.0], step: 5.0 },
        Input::Slider { label: "T moves to the right by", from: 2.6, range: [-1.0, 3.0], step: 0.1 },
    ],
    draw: order,
};

/// The letter F, from (0, 0) to (1, 1.5).
pub const LETTER: [(f32, f32); 10] = [
    (0.0, 0.0),
    (0.3, 0.0),
    (0.3, 0.6),
    (0.8, 0.6),
    (0.8, 0.9),
    (0.3, 0.9),
    (0.3, 1.2),
    (1.0, 1.2),
    (1.0, 1.5),
    (0.0, 1.5),
];

fn order(mut values: Values) -> View {
    let [degrees, by] = [values.number(), values.number()];
    let (turned, moved) = (Mat4::from_mat3(rotate_z(degrees)), translate(Vec3::new(by, 0.0, 0.0)));
    let mut sheet = Sheet::new((-4.6, -4.9), (14.2, 5.3));
    let mut corners = Vec::new();
    for (x, words, first, both) in [
        (0.0, "move, then turn: R · T", moved, turned * moved),
        (9.6, "turn, then move: T · R", turned, moved * turned),
    ] {
        let origin = Vec2::new(x, 0.0);
        sheet.axes(origin, Vec2::new(-4.4, -4.2), Vec2::new(4.4, 4.7), 1.4);
        for (m, fill, outline) in [(Mat4::IDENTITY, "none", GREY), (first, "none", ORANGE), (both, SKY, BLUE)]
        {
            letter(&mut sheet, origin, &m, fill, outline);
        }
        sheet.text(origin + Vec2::new(0.0, -4.55), words, BLACK);
        corners.push(place(&both, Vec3::ZERO).unwrap_or_default());
    }
    let [left, right] =
        [corners[0], corners[1]].map(|corner| format!("({}, {})", number(corner.x), number(corner.y)));
    let told = format!(
        "A turn by {}° and a move by {}: R · T takes the letter's lower left corner to {left}, T · R to {right}.",
        number(degrees),
        number(by),
    );
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}

/// Draws the letter as a matrix has it, with the origin at a place of the sheet.
fn letter(sheet: &mut Sheet, origin: Vec2, m: &Mat4, fill: Ink, outline: Ink) {
    let points = LETTER.iter().filter_map(|&(x, y)| place(m, Vec3::new(x, y, 0.0)));
    let corners: Vec<Vec2> = points.map(|point| origin + point.truncate()).collect();
    sheet.polygon(&corners, fill, outline);
}

/// The head from near and from far.
pub(crate) const DISTANCES: Figure = Figure {
    name: "transforms-distances",
    hint: "Bring the eye nearer by the slider: at its left end d is infinite. Turn the head by dragging it.",
    inputs: &[
        Input::Turn { from: [0.0, 0.0] },
        Input::Slider { label: "Nearness of the eye, 1/d", from: 0.5, range: [0.0, 0.9], step: 0.01 },
    ],
    draw: distances,
};

fn distances(mut values: Values) -> View {
    let head = Turned::by([values.number(), values.number()]);
    let nearness = values.number();
    let side = f32::from(SIDE);
    let all = viewport(side, side, 0.4) * projection(1.0 / nearness);
    let mut texture = Image::new(1, 1, Format::Rgb);
    texture.set(0, 0, Color::WHITE);
    let Turned { model, normals } = &head;
    let scene = Scene { model, normals, texture: &texture, wrap: Wrap::Clamp, light: Vec3::Z };
    let mut image = Image::new(SIDE, SIDE, Format::Rgb);
    gouraud(&scene, &mut image, |point| place(&all, point));
    let reach = model.positions().iter().map(|position| position.z).fold(f32::NEG_INFINITY, f32::max);
    let d = if nearness > 0.0 { number(1.0 / nearness) } else { "∞".into() };
    let told = format!(
        "d = {d}: what is nearest, at z = {}, is drawn {} times as large as what is at z = 0.",
        number(reach),
        number(1.0 / (1.0 - reach * nearness)),
    );
    View { drawing: Drawing::Pixels(image), told, table: Vec::new() }
}
