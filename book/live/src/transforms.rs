//! Lesson 7: matrices, viewport and projection.

use std::f32::consts::TAU;

use camera::lookat;
use common::{Mat4, Vec2, Vec3};
use sheet::{BLACK, BLUE, GREEN, GREY, Ink, ORANGE, PURPLE, SKY, Sheet};
use transforms::affine::{euler, rotate_x, rotate_y, rotate_z, shear_x};
use transforms::rotation::rodrigues;
use transforms::{place, projection, translate, viewport};

use crate::head::{SIDE, Turned};
use crate::{Drawing, Figure, Input, Values, View, number, whole};

/// The order of a turn and a move.
pub(crate) const ORDER: Figure = Figure {
    name: "transforms-order",
    stays: false,
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
    stays: true,
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
    let image = head.placed(&all, Vec3::Z);
    let reach = head.model.positions().iter().map(|position| position.z).fold(f32::NEG_INFINITY, f32::max);
    let d = if nearness > 0.0 { number(1.0 / nearness) } else { "∞".into() };
    let told = format!(
        "d = {d}: what is nearest, at z = {}, is drawn {} times as large as what is at z = 0.",
        number(reach),
        number(1.0 / (1.0 - reach * nearness)),
    );
    View { drawing: Drawing::Pixels(image), told, table: Vec::new() }
}

/// Points and vectors at a height w, and what a slant of the plane does to them.
pub(crate) const HOMOGENEOUS: Figure = Figure {
    name: "transforms-homogeneous",
    stays: false,
    hint: "Bring w from 2 down to 0, and change the slant.",
    inputs: &[
        Input::Slider { label: "w", from: 1.0, range: [0.0, 2.0], step: 0.05 },
        Input::Slider { label: "Slant", from: 1.6, range: [-1.0, 2.0], step: 0.1 },
    ],
    draw: homogeneous,
};

fn homogeneous(mut values: Values) -> View {
    let [w, slant] = [values.number(), values.number()];
    // Of the lesson's maps of space the one that slants x by y, which is w here.
    let m = shear_x(slant, 0.0);
    let before = Vec2::new(1.2, w);
    let after = (m * before.extend(0.0).extend(1.0)).truncate().truncate();
    let mut sheet = Sheet::new((-1.2, -0.6), (6.4, 2.8));
    sheet.axes(Vec2::ZERO, (-1.0, -0.3), (6.2, 2.5), 1.4);
    sheet.line((-1.0, 1.0), (6.2, 1.0), BLACK, 2.4);
    // Where the lines through the origin meet the line w = 1, there is the point.
    let mut met = Vec::new();
    for (at, ink) in [(before, BLUE), (after, ORANGE)] {
        // As far as the sheet goes.
        let side = if at.x < 0.0 { 1.0 } else { 6.2 } / at.x.abs();
        if w > 0.0 {
            sheet.dashed(Vec2::ZERO, at * side.min(2.5 / w), ink, 1.6);
        }
        sheet.arrow(Vec2::ZERO, at, ink);
        let meets = at.x / w;
        if (-1.0..=6.2).contains(&meets) {
            sheet.dot((meets, 1.0), ink);
        }
        met.push(meets);
    }
    sheet.arrow((3.6, 0.0), (4.8, 0.0), PURPLE);
    sheet.text((4.2, -0.28), "a vector: w = 0", PURPLE);
    sheet.text((5.6, 1.22), "w = 1", BLACK);
    sheet.text((6.2, -0.28), "x", GREY);
    sheet.text((-0.22, 2.5), "w", GREY);
    let place = |at: Vec2| format!("({}, {})", number(at.x), number(at.y));
    let told = if w > 0.0 {
        format!(
            "(x, w) = {} is the point x / w = {} (blue). Slanted it is {}, the point {} (orange): moved by {}, whatever w is.",
            place(before),
            number(met[0]),
            place(after),
            number(met[1]),
            number(met[1] - met[0]),
        )
    } else {
        format!(
            "(x, w) = {} is no point but a vector: its line never meets w = 1. Slanted it is {}, the same.",
            place(before),
            place(after),
        )
    };
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}

/// Three rings, one in another.
pub(crate) const GIMBAL: Figure = Figure {
    name: "transforms-gimbal",
    stays: false,
    hint: "Turn the three rings. With the pitch at 90° or −90°, turn the outer and the inner one.",
    inputs: &[
        Input::Slider {
            label: "Yaw, outer ring, in degrees",
            from: -20.0,
            range: [-180.0, 180.0],
            step: 5.0,
        },
        Input::Slider {
            label: "Pitch, middle ring, in degrees",
            from: 20.0,
            range: [-90.0, 90.0],
            step: 5.0,
        },
        Input::Slider { label: "Roll, inner ring, in degrees", from: 0.0, range: [-180.0, 180.0], step: 5.0 },
    ],
    draw: gimbal,
};

fn gimbal(mut values: Values) -> View {
    let [yaw, pitch, roll] = [values.number(), values.number(), values.number()];
    let view = lookat(Vec3::new(2.4, 1.3, 2.6), Vec3::ZERO, Vec3::Y).unwrap_or_default();
    let see = |point: Vec3| (view * point.extend(1.0)).truncate().truncate();
    let mut sheet = Sheet::new((-2.65, -1.75), (2.65, 2.15));
    // What the rings carry: the letter, in the plane of the inner one.
    let inside = euler(Vec3::new(pitch, yaw, roll));
    let letter = LETTER.map(|(x, y)| see(inside * (Vec3::new(x - 0.5, y - 0.75, 0.0) * 0.75)));
    sheet.polygon(&letter, SKY, BLUE);
    let axes = [Vec3::Y, rotate_y(yaw) * Vec3::X, rotate_y(yaw) * rotate_x(pitch) * Vec3::Z];
    for (axis, radius, ink, name) in [
        (axes[0], 1.5, BLUE, "outer, y"),
        (axes[1], 1.25, GREEN, "middle, x"),
        (axes[2], 1.0, ORANGE, "inner, z"),
    ] {
        let across = axis.any_orthonormal_vector() * radius;
        sheet.polyline((0..=72).map(|n| see(rodrigues(axis, TAU * n as f32 / 72.0) * across)), ink, 3.0);
        let end = see(axis * (radius + 0.35));
        sheet.arrow(Vec2::ZERO, end, ink);
        // Beside the tip, away from the rings.
        let beside = end + end.normalize_or_zero() * 0.2;
        match end.x {
            x if x > 0.3 => sheet.text_right_of(beside, name, ink),
            x if x < -0.3 => sheet.text_left_of(beside, name, ink),
            _ => sheet.text(beside, name, ink),
        }
    }
    // Of their lines, not of their directions.
    let apart = axes[0].angle_between(axes[2]).to_degrees();
    let apart = whole(apart.min(180.0 - apart).round());
    let lock = match pitch {
        90.0 => format!("They turn about one line: only yaw − roll = {}° has an effect.", whole(yaw - roll)),
        -90.0 => format!("They turn about one line: only yaw + roll = {}° has an effect.", whole(yaw + roll)),
        _ => "Each of the three angles has an effect of its own.".into(),
    };
    let told =
        format!("With a pitch of {}° the outer and the inner axis are {apart}° apart. {lock}", whole(pitch));
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}
