//! The head on a floor and by itself in the openings of the chapters that have a camera, by their methods.

use std::sync::LazyLock;

use antialiasing::World;
use blending::scene::{Entity, draw_by};
use blending::{Over, TRANSPARENCY, TwoShift};
use clipping::mesh::indexed;
use clipping::{Counts, Cull, Mesh};
use common::{Attributes, Color, Image, Mat4, Method, Vec3};
use filtering::MIPMAPS;
use filtering::scene::{Filterable, fine};
use gouraud::Wrap;
use lighting::{PointLight, Scene};
use perspective::scene::Loaded;
use perspective::{DEPTHS, Planes, perspective, view};
use shaders::Uniforms;
use transforms::affine::euler;

use crate::head::{self, HEAD, canvas, eye, method};
use crate::{Figure, Input, Values, View, packed};

/// Where a camera is: what it looks at, from how far, and its field of view.
type Camera = (Vec3, f32, f32);

/// Width and height of most pictures.
const SIDE: u16 = 320;

const PLANES: Planes = Planes { near: 0.1, far: 100.0 };

/// From the world to clip space, for a square picture, and the eye.
fn camera((center, distance, fov): Camera, turn: [f32; 2]) -> (Mat4, Vec3) {
    let eye = eye(center, distance, turn);
    // Straight from above, another up stands in for y.
    let view = view(eye, center, Vec3::Y).unwrap_or_default();
    (perspective(fov, 1.0, PLANES.near, PLANES.far).unwrap_or_default() * view, eye)
}

/// The floor's texture.
fn checks() -> Image {
    let [light, dark] = [Color::rgb(0xf2, 0xec, 0xde), Color::rgb(0x2f, 0x5d, 0x7c)];
    let mut image = canvas(2);
    for (x, y) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        image.set(x, y, if x == y { dark } else { light });
    }
    image
}

/// A model's mesh, for all looks.
fn mesh(loaded: &Loaded) -> Mesh {
    indexed(&loaded.model, &loaded.normals, Attributes { normals: true, uvs: true })
}

static FLOOR: LazyLock<Loaded> = LazyLock::new(|| packed::loaded(packed::FLOOR, checks(), Wrap::Repeat));

/// Lesson 10's head.
pub(crate) const PERSPECTIVE: Figure = Figure {
    name: "perspective-head",
    stays: true,
    hint: "Take the eye around by dragging, or by the sliders. Choose how to interpolate, and what is kept as depth.",
    inputs: &[
        Input::Turn { from: [-18.0, 3.0] },
        Input::Choice {
            label: "Interpolation",
            rows: || Method::rows(perspective::METHODS),
            from: "per-pixel",
        },
        Input::Choice { label: "Depths", rows: || Method::rows(DEPTHS), from: "z-f32" },
    ],
    draw: in_perspective,
};

fn in_perspective(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let way = values.choice(perspective::METHODS);
    let keep = values.choice(DEPTHS);
    let (to_clip, _) = camera((Vec3::new(0.0, -0.1, 0.0), 3.6, 45.0), turn);
    let light = Vec3::new(0.5, 0.8, 0.9).normalize();
    let uniforms: [Uniforms; 2] = [&*HEAD, &*FLOOR].map(|loaded| loaded.uniforms(light, to_clip));
    let mut image = canvas(SIDE);
    let drawn = (way.run.draw)(&keep.run)(&uniforms, PLANES, &mut image);
    let rest = format!("triangles left out since they reach behind the eye: {}", drawn.left_out);
    head::view(image, &format!("{}, {}", way.name, keep.name), "head and floor", turn, &rest)
}

/// The head and lesson 11's floor, with their meshes.
static SLABS: LazyLock<[(Loaded, Mesh); 2]> = LazyLock::new(|| {
    let head = packed::loaded(packed::HEAD, packed::texture(), Wrap::Clamp);
    let slabs = packed::loaded(packed::SLABS, checks(), Wrap::Repeat);
    [head, slabs].map(|loaded| {
        let mesh = mesh(&loaded);
        (loaded, mesh)
    })
});

/// Lesson 11's head.
pub(crate) const CLIPPING: Figure = Figure {
    name: "clipping-head",
    stays: true,
    hint: "Take the eye around by dragging, or by the sliders. Choose what becomes of triangles that are not wholly in the \
           picture.",
    inputs: &[Input::Turn { from: [-34.0, -10.0] }, method(|| Method::rows(clipping::METHODS), "guard-band")],
    draw: clipped,
};

fn clipped(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let method = values.choice(clipping::METHODS);
    let (to_clip, _) = camera((Vec3::new(0.0, -0.2, 0.0), 3.07, 45.0), turn);
    let light = Vec3::new(0.4, 0.8, 0.8).normalize();
    let models = SLABS.each_ref().map(|(loaded, mesh)| (loaded.uniforms(light, to_clip), mesh));
    let mut image = canvas(SIDE);
    let Counts { left_out, cut, filled, .. } =
        clipping::draw(&models, Cull::Back, method.run, &mut image).counts;
    let rest = format!("triangles left out: {left_out}, cut: {cut}, filled: {filled}");
    head::view(image, method.name, "head and floor", turn, &rest)
}

/// Lesson 12's head.
pub(crate) const LIGHTING: Figure = Figure {
    name: "lighting-head",
    stays: true,
    hint: "Turn the head by dragging it, or by the sliders; the light stays where it is. Choose another method.",
    inputs: &[Input::Turn { from: [0.0, 0.0] }, method(|| Method::rows(lighting::METHODS), "blinn-phong")],
    draw: lit,
};

fn lit(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let method = values.choice(lighting::METHODS);
    let (camera, eye) = camera((Vec3::new(0.0, 0.12, 0.0), 2.4, 45.0), [-13.0, 5.0]);
    let to_world = Mat4::from_mat3(euler(Vec3::new(turn[1], turn[0], 0.0)));
    let [(head, mesh), _] = &*SLABS;
    let scene = Scene::placed(head, to_world, camera, eye, PointLight::default()).expect("it is not flat");
    let mut image = canvas(SIDE);
    let counts = (method.run)(&scene, mesh, Cull::Back, &mut image).counts;
    head::view(image, method.name, "the head", turn, &format!("triangles filled: {}", counts.filled))
}

/// Both with the levels of their textures.
static LEVELS: LazyLock<[Filterable; 2]> = LazyLock::new(|| {
    let mipmap = MIPMAPS[1].run;
    let head = packed::loaded(packed::HEAD, packed::texture(), Wrap::Clamp);
    let slabs = packed::loaded(packed::SLABS, fine(&checks()), Wrap::Clamp);
    [
        Filterable::new(head, mipmap, filtering::Wrap::Clamp),
        Filterable::new(slabs, mipmap, filtering::Wrap::Repeat),
    ]
});

/// Lesson 13's head.
pub(crate) const FILTERING: Figure = Figure {
    name: "filtering-head",
    stays: true,
    hint: "Take the eye around by dragging, or by the sliders. Choose another method.",
    inputs: &[Input::Turn { from: [-31.0, 8.0] }, method(|| Method::rows(filtering::METHODS), "trilinear")],
    draw: filtered,
};

fn filtered(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let method = values.choice(filtering::METHODS);
    let (to_clip, _) = camera((Vec3::new(0.3, -0.35, 0.0), 3.75, 45.0), turn);
    let light = Vec3::new(0.4, 0.8, 0.8).normalize();
    let surfaces = LEVELS.each_ref().map(|model| model.surface(light, to_clip));
    let mut image = canvas(SIDE);
    let counts = (method.run.draw)(&surfaces, Cull::Back, &mut image).counts;
    let rest = format!("triangles filled: {}", counts.filled);
    head::view(image, method.name, "head and floor", turn, &rest)
}

/// Lesson 14's head, which one sees through.
pub(crate) const BLENDING: Figure = Figure {
    name: "blending-crates",
    stays: true,
    hint: "Take the eye around by dragging, or by the sliders. Choose how much is seen through the head, and how its layers are \
           drawn.",
    inputs: &[
        Input::Turn { from: [-31.0, 8.0] },
        Input::Slider { label: "Alpha", from: 0.5, range: [0.1, 0.9], step: 0.1 },
        method(|| Method::rows(TRANSPARENCY), "drawn"),
    ],
    draw: blended,
};

fn blended(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let alpha = values.number();
    let method = values.choice(TRANSPARENCY);
    let (to_clip, eye) = camera((Vec3::new(0.0, -0.1, 0.0), 3.6, 45.0), turn);
    let view = blending::scene::View { to_clip, eye, light: PointLight::default() };
    let [head, slabs] = &*LEVELS;
    let entity = |model, alpha| Entity { model, to_world: Mat4::IDENTITY, alpha };
    let entities = [entity(slabs, 1.0), entity(head, alpha)];
    let mut image = canvas(200);
    let Counts { filled, .. } =
        draw_by(method.run, &entities, &view, Cull::None, Over(TwoShift), &mut image).counts;
    let rest = format!("the head's alpha is {alpha:.1}; triangles filled: {filled}");
    head::view(image, method.name, "head and floor", turn, &rest)
}

/// Lesson 15's head, in few pixels.
pub(crate) const ANTIALIASING: Figure = Figure {
    name: "antialiasing-head",
    stays: true,
    hint: "Turn the head by dragging it, or by the sliders. Choose another method.",
    inputs: &[Input::Turn { from: [-72.0, 4.0] }, method(|| Method::rows(antialiasing::METHODS), "msaa-16")],
    draw: antialiased,
};

fn antialiased(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let method = values.choice(antialiasing::METHODS);
    let (to_clip, eye) = camera((Vec3::new(0.0, -0.03, 0.0), 3.46, 45.0), turn);
    let light = PointLight { position: eye + Vec3::Y, ambient: 0.1, diffuse: 0.9, ..PointLight::default() };
    let view = blending::scene::View { to_clip, eye, light };
    let entities = [Entity { model: &LEVELS[0], to_world: Mat4::IDENTITY, alpha: 1.0 }];
    let world = Some(World { entities: &entities, view, cull: Cull::Back });
    let mut image = canvas(120);
    (method.run.picture)(
        &antialiasing::Scene { world, ..antialiasing::Scene::of(&[], Color::BLACK) },
        &mut image,
    );
    let rest = format!("samples of each pixel: {}", method.run.samples);
    head::view(image, method.name, "the head", turn, &rest)
}
