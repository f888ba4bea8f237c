//! Pictures of pixels: the course's head, pictures made by hand, and several of them as one figure.

use std::path::Path;

use anyhow::Context;
use common::compare::side_by_side;
use common::program::model::{DEFAULT_MODEL, DEFAULT_TEXTURE};
use common::{Attributes, Color, Format, Image, Method, Model};

use super::Drawing;

/// The lessons' model, with all that it has.
pub(crate) fn model() -> anyhow::Result<Model> {
    Ok(Model::read(Path::new(DEFAULT_MODEL), Attributes { normals: true, uvs: true })?)
}

/// The head's texture.
pub(crate) fn texture() -> anyhow::Result<Image> {
    Ok(Image::read(Path::new(DEFAULT_TEXTURE))?)
}

/// What a table of methods has under a name.
pub(crate) fn method<F>(table: &'static [Method<F>], name: &str) -> anyhow::Result<&'static F> {
    Method::find(table, name)
        .map(|method| &method.run)
        .with_context(|| format!("there is no method `{name}`"))
}

/// An empty square picture.
pub(crate) fn canvas(side: u16) -> Image {
    Image::new(side, side, Format::Rgb)
}

/// A picture made pixel by pixel.
pub(crate) fn painted(width: u16, height: u16, color: impl Fn(i32, i32) -> Color) -> Image {
    let mut image = Image::new(width, height, Format::Rgb);
    for (x, y) in (0..i32::from(height)).flat_map(|y| (0..i32::from(width)).map(move |x| (x, y))) {
        image.set(x, y, color(x, y));
    }
    image
}

/// Squares of two colours in turn, the first one at the bottom left.
pub(crate) fn chequered(width: u16, height: u16, colors: [Color; 2]) -> Image {
    painted(width, height, |x, y| colors[((x + y) % 2) as usize])
}

/// A part of a picture.
pub(crate) fn cut(image: &Image, [left, bottom]: [i32; 2], [width, height]: [u16; 2]) -> Image {
    painted(width, height, |x, y| image.get(x + left, y + bottom).unwrap_or(Color::BLACK))
}

/// Copies a picture into another one.
pub(crate) fn paste(image: &Image, into: &mut Image, [left, bottom]: [i32; 2]) {
    image.pixels().for_each(|(x, y, color)| into.set(left + x, bottom + y, color));
}

/// Pictures side by side, as wide as a page.
pub(crate) fn beside<'a>(pictures: impl IntoIterator<Item = &'a Image>) -> anyhow::Result<Drawing> {
    const WIDTH: u16 = 900;
    let pictures: Vec<&Image> = pictures.into_iter().collect();
    let row = side_by_side(&pictures).map_err(anyhow::Error::msg)?;
    let height = row.height() * i32::from(WIDTH) / row.width().max(1);
    Ok(Drawing::Pixels(row.scale(WIDTH, height as u16), 1))
}

/// The same of pictures that may fail.
pub(crate) fn all_beside(
    pictures: impl IntoIterator<Item = anyhow::Result<Image>>,
) -> anyhow::Result<Drawing> {
    beside(&pictures.into_iter().collect::<anyhow::Result<Vec<Image>>>()?)
}
