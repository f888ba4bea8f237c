//! Lesson 11: every triangle, wherever the eye is.

use clipping::plane::{PLANES, distance};
use clipping::{ClipVertex, Polygon, clip};
use common::{Vec2, Vec3, Vec4Swizzles};
use perspective::perspective;
use sheet::{BLACK, BLUE, FAINT, GREY, ORANGE, PALE, SKY, Sheet};

use crate::{Drawing, Figure, Input, Values, View, number};

/// A triangle and the near plane, in space and in the picture.
pub(crate) const CASES: Figure = Figure {
    name: "clipping-cases",
    stays: true,
    hint: "Move the near plane, and drag a corner, behind the eye too; or move it by the arrow keys. Left from the side, right the \
           picture.",
    inputs: &[
        corner("Corner A", [-1.2, -0.9]),
        corner("Corner B", [3.2, -1.2]),
        corner("Corner C", [4.0, 1.6]),
        Input::Slider { label: "Depth of the near plane", from: 1.0, range: [0.2, 4.0], step: 0.1 },
    ],
    draw: cases,
};

/// A corner, by its depth and its height.
const fn corner(label: &'static str, from: [f64; 2]) -> Input {
    Input::Point { label, from, low: [-2.0, -2.0], high: [5.0, 2.0], step: 0.1 }
}

/// How far to the right the corners are.
const ACROSS: [f32; 3] = [-0.9, 1.1, -0.2];
/// The picture's middle on the sheet.
const PICTURE: Vec2 = Vec2::new(7.9, 0.0);
/// As large as 1 is in it.
const SCALE: f32 = 2.0;

fn cases(mut values: Values) -> View {
    let ends = [values.point(), values.point(), values.point()];
    let near = values.number();
    // So that a height of clip space is that of space.
    let to_clip = perspective(90.0, 1.0, near, 100.0).unwrap_or_default();
    let corner = |n: usize| ClipVertex {
        position: to_clip * Vec3::new(ACROSS[n], ends[n].y, -ends[n].x).extend(1.0),
        varying: (),
    };
    let triangle = Polygon::new(&[0, 1, 2].map(corner));
    let [near_plane, others @ ..] = PLANES;
    let before = clip(&triangle, near_plane);
    let seen = others.into_iter().fold(before, |rest, plane| clip(&rest, plane));

    let mut sheet = Sheet::new((-2.4, -2.7), (10.1, 2.5));
    // What is seen, as far as it is on the sheet.
    let high = 2.2;
    let height = Vec2::new(0.0, high);
    let upper = [
        Vec2::splat(near.min(high)).with_x(near),
        Vec2::splat(high).with_x(near.max(high)),
        Vec2::new(5.2, high),
    ];
    let lower = upper.map(|corner| corner * Vec2::new(1.0, -1.0));
    sheet.polygon(&[upper[0], upper[1], upper[2], lower[2], lower[1], lower[0]], PALE, "none");
    for side in [1.0, -1.0] {
        sheet.line((0.0, 0.0), (high, high * side), FAINT, 1.6);
    }
    sheet.line((-2.3, 0.0), (5.2, 0.0), FAINT, 1.4);
    let from_the_side = |polygon: &Polygon<()>| -> Vec<Vec2> {
        polygon.corners().iter().map(|corner| Vec2::new(corner.position.w, corner.position.y)).collect()
    };
    sheet.polygon(&from_the_side(&before), SKY, BLUE);
    sheet.polygon(&ends, "none", GREY);
    sheet.line(Vec2::X * near - height, Vec2::X * near + height, BLACK, 2.4);
    for corner in before.corners() {
        let is_cut = triangle.corners().iter().all(|own| own.position != corner.position);
        sheet.dot((corner.position.w, corner.position.y), if is_cut { ORANGE } else { BLUE });
    }
    sheet.dot((0.0, 0.0), BLACK);
    sheet.text_left_of((-0.15, 0.32), "eye", BLACK);
    sheet.text((near, -2.5), "near plane", BLACK);

    let in_picture: Vec<Vec2> = seen
        .corners()
        .iter()
        .map(|corner| PICTURE + corner.position.xy() / corner.position.w * SCALE)
        .collect();
    sheet.rectangle(PICTURE - SCALE, PICTURE + SCALE, PALE, GREY);
    sheet.polygon(&in_picture, SKY, BLUE);
    sheet.text(PICTURE - Vec2::Y * 2.5, "picture", BLACK);
    let inside =
        triangle.corners().iter().filter(|corner| distance(near_plane, corner.position) >= 0.0).count();
    let told = format!(
        "The inner side of the near plane, which is at the depth {}, has {inside} of the 3 corners. Cut by it, the triangle has {} \
         corners; in the picture, cut by the other five planes too, {}.",
        number(near),
        before.corners().len(),
        in_picture.len(),
    );
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}
