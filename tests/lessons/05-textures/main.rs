//! Lesson 5: what its methods draw, where they fail, what its program is asked.

mod properties;
mod snapshots;
mod stability;
mod usage;

use common::{Color, Format, Image};

/// A texture in which each texel's colour says where it is. None is black.
fn labelled(width: u16, height: u16) -> Image {
    let mut texture = Image::new(width, height, Format::Rgb);
    for (x, y, _) in texture.clone().pixels() {
        texture.set(x, y, Color::rgb(x as u8, y as u8, 255));
    }
    texture
}
