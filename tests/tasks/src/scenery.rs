//! What missions draw: the course's model and texture, small random ones, and random numbers.

use std::path::Path;
use std::sync::LazyLock;

use common::program::model::DEFAULT_MODEL;
use common::{Attributes, Color, Format, Image, Model, Vec3};
use fastrand::Rng;

/// Sides of the pictures of models.
pub const SIDE: u16 = 400;

/// The light of those pictures that say nothing of another: from the right, above, in front.
pub const LIGHT: Vec3 = Vec3::new(0.48, 0.6, 0.64);

/// A light within 40° of that one: whoever knows the picture under one of them knows none of the others.
pub fn light(rng: &mut Rng) -> Vec3 {
    (LIGHT + 0.4 * point(rng)).normalize()
}

/// The size of a picture of a model that is wider than high: another one for each seed.
pub fn wide(rng: &mut Rng) -> [u16; 2] {
    [SIDE - rng.u16(0..60), 300 - rng.u16(0..60)]
}

/// The course's model.
pub static MODEL: LazyLock<Model> = LazyLock::new(|| {
    let wanted = Attributes { normals: true, uvs: true };
    Model::read(Path::new(DEFAULT_MODEL), wanted).expect("the course's model is in its place")
});

/// That model as Rust.
pub const MODEL_CODE: &str = "let model = Model::read(\n    common::program::model::DEFAULT_MODEL.as_ref(),\n    \
                              common::Attributes { normals: true, uvs: true },\n)\n.expect(\"it is in its \
                              place\");\n";

/// That texture as Rust.
pub const TEXTURE_CODE: &str = "let path = concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/../../../assets/crate.png\");\n\
                                let texture = Image::read(path.as_ref()).expect(\"it is in its place\");\n";

/// The painted wooden box.
pub static TEXTURE: LazyLock<Image> = LazyLock::new(|| {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/crate.png");
    Image::read(Path::new(path)).expect("the course's texture is in its place")
});

/// A black picture.
#[must_use]
pub fn canvas(width: u16, height: u16) -> Image {
    Image::new(width, height, Format::Rgb)
}

/// A picture in which no two pixels are likely to be alike, and none is black.
pub fn noise(rng: &mut Rng, side: u16) -> Image {
    let mut image = canvas(side, side);
    for (x, y, _) in image.clone().pixels() {
        let Color { r, g, b, .. } = Color::random(rng.u64(..));
        image.set(x, y, Color::rgb(r | 1, g, b));
    }
    image
}

/// Four by four squares, each of another colour than its neighbours.
#[must_use]
pub fn pattern() -> Image {
    let mut image = canvas(4, 4);
    for (x, y, _) in image.clone().pixels() {
        let dark = (x + y) % 2 == 0;
        let shade = if dark { [40, 60] } else { [210, 170] }.map(|base: u8| base + 10 * x as u8);
        image.set(x, y, Color::rgb(shade[0], shade[1], 60 + 30 * y as u8));
    }
    image
}

/// A number from −1 to 1.
pub fn signed(rng: &mut Rng) -> f32 {
    rng.f32() * 2.0 - 1.0
}

/// A point in [−1, 1]³.
pub fn point(rng: &mut Rng) -> Vec3 {
    Vec3::new(signed(rng), signed(rng), signed(rng))
}

/// A direction, 1 long.
pub fn direction(rng: &mut Rng) -> Vec3 {
    (0..).find_map(|_| Some(point(rng)).filter(|p| p.length() > 0.1)).map_or(Vec3::Z, Vec3::normalize)
}

/// A square in space, seen as [left, right] × [bottom, top] in model units, as two triangles, with a normal and
/// corners of a texture. As OBJ text, since this is the way in which a model gets normals.
pub struct Square {
    /// left, bottom, right, top, z.
    pub place: [f32; 5],
    /// The normals at bottom-left, bottom-right, top-right, top-left.
    pub normals: [Vec3; 4],
}

/// A model of squares as Rust.
#[must_use]
pub fn squares_code(squares: &[Square]) -> String {
    format!(
        "let text = \"{}\";\nlet model = Model::parse(\n    text.as_bytes(),\n    \
         common::Attributes {{ normals: true, uvs: true }},\n)\n.expect(\"the text is an OBJ file\");\n",
        obj(squares).replace('\n', "\\n")
    )
}

/// A model of squares.
///
/// # Panics
/// Where a number is not finite.
#[must_use]
pub fn squares(squares: &[Square]) -> Model {
    Model::parse(obj(squares).as_bytes(), Attributes { normals: true, uvs: true })
        .expect("the text is an OBJ file")
}

fn obj(squares: &[Square]) -> String {
    let mut text = String::from("vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n");
    for (n, Square { place: [left, bottom, right, top, z], normals }) in squares.iter().enumerate() {
        for (x, y) in [(left, bottom), (right, bottom), (right, top), (left, top)] {
            text += &format!("v {x} {y} {z}\n");
        }
        for normal in normals {
            text += &format!("vn {} {} {}\n", normal.x, normal.y, normal.z);
        }
        let corner = |k: usize| format!("{0}/{k}/{0}", 4 * n + k);
        text += &format!("f {} {} {} {}\n", corner(1), corner(2), corner(3), corner(4));
    }
    text
}
