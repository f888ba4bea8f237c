//! The head, turned: the model of many figures, in the fewest triangles that there is, 638.

use std::sync::LazyLock;

use common::{Color, Format, Image, Mat4, Method, Model, Vec3};
use gouraud::{Scene, Wrap};
use live_loops::shades::Shade;
use perspective::scene::Loaded;
use transforms::affine::euler;
use transforms::place;
use triangles::flat_intensity;

use crate::{Drawing, Input, View, packed, whole};

/// Width and height of the pictures.
pub(crate) const SIDE: u16 = 360;
/// The head's size, so that it stays within them however it is turned.
const SIZE: f32 = 0.86;

pub(crate) const HINT: &str = "Turn the head by dragging it, or by the sliders. Choose another method.";
pub(crate) const TURN: Input = Input::Turn { from: [25.0, 0.0] };

/// The head as it stands.
pub(crate) static HEAD: LazyLock<Loaded> = LazyLock::new(packed::head);

/// A table of methods, to be chosen from.
pub(crate) const fn method(rows: fn() -> Vec<Method<()>>, from: &'static str) -> Input {
    Input::Choice { label: "Method", rows, from }
}

/// The model turned, the normals with it.
pub(crate) struct Turned {
    pub(crate) model: Model,
    pub(crate) normals: Vec<[Vec3; 3]>,
}

impl Turned {
    /// By so many degrees to the right and down.
    pub(crate) fn by([right, down]: [f32; 2]) -> Self {
        let turn = euler(Vec3::new(down, right, 0.0));
        let Loaded { model, normals, .. } = &*HEAD;
        Self {
            model: moved(model, |position| turn * position * SIZE),
            normals: normals.iter().map(|corners| corners.map(|normal| turn * normal)).collect(),
        }
    }

    /// A picture of it, smoothly lit, its points placed by a matrix.
    pub(crate) fn placed(&self, m: &Mat4, light: Vec3) -> Image {
        let Self { model, normals } = self;
        smooth(&Scene { model, normals, texture: &white(), wrap: Wrap::Clamp, light }, m)
    }

    /// How many of its triangles face an eye in front of it, told.
    pub(crate) fn facing(&self) -> String {
        let towards = self.model.faces().filter(|&corners| flat_intensity(corners, Vec3::Z) > 0.0).count();
        format!("{towards} of its {} triangles face the eye", self.model.triangles().len())
    }
}

/// A picture of a scene, smoothly lit, its points placed by a matrix.
pub(crate) fn smooth(scene: &Scene, m: &Mat4) -> Image {
    let mut image = canvas(SIDE);
    Shade::Gouraud.draw(scene, &mut image, &|point| place(m, point));
    image
}

/// A model with its positions moved.
fn moved(model: &Model, to: impl Fn(Vec3) -> Vec3) -> Model {
    let positions = model.positions().iter().map(|&position| to(position)).collect();
    let uvs = model.face_uvs().flatten().collect();
    let corners = (0..model.triangles().len() as u32).map(|face| [0, 1, 2].map(|corner| 3 * face + corner));
    let moved = Model::from_triangles(positions, model.triangles().to_vec());
    sound(moved.and_then(|moved| moved.with_uvs(uvs, corners.collect())))
}

/// A model that is one of ours. `expect` would show what is wrong with it, by much code.
pub(crate) fn sound<E>(model: Result<Model, E>) -> Model {
    let Ok(model) = model else { unreachable!("it is one of ours") };
    model
}

/// An eye at a distance from a centre, where what is there is seen turned by so many degrees to the right and down.
pub(crate) fn eye(center: Vec3, distance: f32, turn: [f32; 2]) -> Vec3 {
    let [right, down] = turn.map(|degrees| degrees.to_radians().sin_cos());
    center + distance * Vec3::new(-right.0 * down.1, down.0, right.1 * down.1)
}

/// A picture with nothing in it yet.
pub(crate) fn canvas(side: u16) -> Image {
    Image::new(side, side, Format::Rgb)
}

/// A texture of one white texel.
pub(crate) fn white() -> Image {
    let mut texture = canvas(1);
    texture.set(0, 0, Color::WHITE);
    texture
}

/// A picture of what was turned, by methods of these names, and what else is to be told of it.
pub(crate) fn view(image: Image, methods: &str, what: &str, turn: [f32; 2], rest: &str) -> View {
    let [right, down] = turn.map(whole);
    let told = format!("{methods}: {what}, turned by {right}° to the right and {down}° down; {rest}.");
    View { drawing: Drawing::Pixels(image), told, table: Vec::new() }
}
