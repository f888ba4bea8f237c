//! Lesson 6: what its methods draw, where they fail, what its program is asked.

mod snapshots;
mod stability;
mod usage;

use common::{Attributes, Color, Format, Image, Model, Vec3};
use gouraud::{METHODS, Scene, Wrap, corner_normals};
use verify::method;

const BOTH: Attributes = Attributes { normals: true, uvs: true };

/// Draws a model, white, by one method.
fn draw(model: &Model, light: Vec3, name: &str, picture: &mut Image) {
    let mut white = Image::new(1, 1, Format::Gray);
    white.set(0, 0, Color::WHITE);
    method(METHODS, name)(
        &Scene { model, normals: &corner_normals(model), texture: &white, wrap: Wrap::Clamp, light },
        picture,
    );
}
