//! Lesson 8: looking at a point.

use camera::METHODS;
use common::{Color, Method, Vec2, Vec3};
use transforms::{place, projection, translate, viewport};

use crate::head::{SIDE, Turned};
use crate::input::named;
use crate::{Drawing, Figure, Input, Values, View, number, whole};

/// An eye that climbs in front of the head, passes over it, and goes down behind it.
pub(crate) const POLE: Figure = Figure {
    name: "camera-pole",
    stays: true,
    hint: "Take the eye over the top, past 90°. Choose another method: what becomes of a centre that is not the origin?",
    inputs: &[
        Input::Slider { label: "Height of the eye, in degrees", from: 60.0, range: [0.0, 180.0], step: 1.0 },
        Input::Slider {
            label: "Centre, from the origin (0) to the face (1)",
            from: 1.0,
            range: [0.0, 1.0],
            step: 0.1,
        },
        Input::Choice { label: "Method", rows: || Method::rows(METHODS), from: "lookat" },
    ],
    draw: pole,
};

fn pole(mut values: Values) -> View {
    const DISTANCE: f32 = 2.6;
    let [degrees, share] = [values.number(), values.number()];
    let method = values.choice(named!(METHODS));
    let center = Vec3::new(0.0, 0.1, 0.5) * share;
    let (sin, cos) = degrees.to_radians().sin_cos();
    let eye = center + Vec3::new(0.0, sin, cos) * DISTANCE;
    let view = (method.run)(eye, center, Vec3::Y).expect("the eye is not at the centre");
    let side = f32::from(SIDE);
    let all = viewport(side, side, 0.42) * projection(DISTANCE) * view.matrix * translate(-view.origin);
    // Over the viewer's shoulder.
    let light = (eye - center).normalize() + Vec3::new(0.3, 0.5, 0.0);
    let mut image = Turned::by([0.0, 0.0]).placed(&all, light.normalize());
    // The middle, marked.
    let middle = i32::from(SIDE / 2);
    for n in -10..=10 {
        for (x, y) in [(n, 0), (n, -1), (0, n), (-1, n)] {
            image.set(middle + x, middle + y, Color::rgb(240, 140, 40));
        }
    }
    let off = place(&all, center).map_or(f32::INFINITY, |at| at.truncate().distance(Vec2::splat(side / 2.0)));
    let told = format!(
        "{}: the eye is at {}°. The centre is drawn {} px from the picture's middle, which is marked. \
         The world's x axis points to the {}.",
        method.name,
        whole(degrees),
        number(off),
        if view.matrix.row(0).x > 0.0 { "right" } else { "left" },
    );
    View { drawing: Drawing::Pixels(image), told, table: Vec::new() }
}
