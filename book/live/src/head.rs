//! The head, turned, by the methods of several chapters.
//!
//! It is the head in the fewest triangles that there is, 638.

use std::sync::LazyLock;

use common::{Color, Format, Image, Mat4, Method, Model, Vec3};
use gouraud::{Scene, Wrap, gouraud};
use perspective::scene::Loaded;
use transforms::affine::euler;
use transforms::place;
use triangles::{draw_model, flat_intensity};

use crate::{Drawing, Figure, Input, Values, View, packed, whole};

/// Width and height of the pictures.
pub(crate) const SIDE: u16 = 360;
/// The head's size, so that it stays within them however it is turned.
const SIZE: f32 = 0.86;

/// The head as it stands.
pub(crate) static HEAD: LazyLock<Loaded> =
    LazyLock::new(|| packed::loaded(packed::HEAD, packed::texture(), Wrap::Clamp));

const HINT: &str = "Turn the head by dragging it, or by the sliders. Choose another method.";
const TURN: Input = Input::Turn { from: [25.0, 0.0] };

/// Lesson 3's head, which knows no depth: the later triangle covers the earlier one.
pub(crate) const TRIANGLES: Figure = Figure {
    name: "triangles-head",
    stays: true,
    hint: HINT,
    inputs: &[
        TURN,
        Input::Choice { label: "Method", rows: || Method::rows(triangles::METHODS), from: "edges" },
    ],
    draw: |values| {
        drawn(values, triangles::METHODS, |method, head, image| {
            draw_model(&head.model, method, image, |_, corners| {
                let intensity = flat_intensity(corners, Vec3::Z);
                (intensity >= 0.0).then(|| Color::gray(intensity))
            });
        })
    },
};

/// Lesson 4's head.
pub(crate) const ZBUFFER: Figure = Figure {
    name: "zbuffer-head",
    stays: true,
    hint: HINT,
    inputs: &[
        TURN,
        Input::Choice { label: "Method", rows: || Method::rows(zbuffer::METHODS), from: "z-f32" },
    ],
    draw: |values| {
        drawn(values, zbuffer::METHODS, |method, head, image| {
            let surfaces = zbuffer::surfaces(&head.model, Vec3::Z, image);
            (method.draw)(&surfaces, image);
        })
    },
};

/// Lesson 6's head, white instead of textured.
pub(crate) const GOURAUD: Figure = Figure {
    name: "gouraud-three",
    stays: true,
    hint: HINT,
    inputs: &[
        TURN,
        Input::Choice { label: "Method", rows: || Method::rows(gouraud::METHODS), from: "gouraud" },
    ],
    draw: |values| {
        drawn(values, gouraud::METHODS, |method, head, image| {
            let Turned { model, normals } = head;
            method(&Scene { model, normals, texture: &white(), wrap: Wrap::Clamp, light: Vec3::Z }, image);
        })
    },
};

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
        let scene = Scene { model, normals, texture: &white(), wrap: Wrap::Clamp, light };
        let mut image = Image::new(SIDE, SIDE, Format::Rgb);
        gouraud(&scene, &mut image, |point| place(m, point));
        image
    }
}

/// One white texel.
pub(crate) fn white() -> Image {
    let mut texture = Image::new(1, 1, Format::Rgb);
    texture.set(0, 0, Color::WHITE);
    texture
}

/// A model with its positions moved.
fn moved(model: &Model, to: impl Fn(Vec3) -> Vec3) -> Model {
    let positions = model.positions().iter().map(|&position| to(position)).collect();
    let uvs = model.face_uvs().flatten().collect();
    let corners = (0..model.triangles().len() as u32).map(|face| [0, 1, 2].map(|corner| 3 * face + corner));
    Model::from_triangles(positions, model.triangles().to_vec())
        .and_then(|moved| moved.with_uvs(uvs, corners.collect()))
        .expect("what is moved is as sound as before")
}

/// The head turned, drawn by the method chosen.
fn drawn<F>(mut values: Values, table: &'static [Method<F>], draw: impl Fn(&F, &Turned, &mut Image)) -> View {
    let [right, down] = [values.number(), values.number()];
    let method = values.choice(table);
    let head = Turned::by([right, down]);
    let mut image = Image::new(SIDE, SIDE, Format::Rgb);
    draw(&method.run, &head, &mut image);
    let towards = head.model.faces().filter(|&corners| flat_intensity(corners, Vec3::Z) > 0.0).count();
    let [right, down] = [right, down].map(whole);
    let told = format!(
        "{}: the head, turned by {right}° to the right and {down}° down; {towards} of its {} triangles face the eye.",
        method.name,
        head.model.triangles().len(),
    );
    View { drawing: Drawing::Pixels(image), told, table: Vec::new() }
}
