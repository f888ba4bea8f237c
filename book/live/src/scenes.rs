//! The head on a floor and by itself in the openings of the chapters that have a camera, by their methods.

use std::sync::LazyLock;

use blending::TRANSPARENCY;
use blending::scene::Entity;
use clipping::{Counts, Cull};
use common::{Image, Mat4, Method, Vec3};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Surface};
use lighting::{PointLight, Scene};
use live_loops::counted::{self, Shaded};
use live_loops::filters::{self, AnyFilter};
use live_loops::layers;
use live_loops::lights::{self, MAKES, Make};
use perspective::lighting::Clamped;
use perspective::scene::Loaded;
use perspective::{Framebuffer, Planes, perspective, render, view};
use shaders::source::Texture;
use shaders::{Lit, Uniforms};
use sheet::fixed;
use speed::Picture;
use transforms::affine::euler;

use crate::head::{self, HEAD, canvas, eye, method};
use crate::input::{named, with};
use crate::kept::{self, Kept};
use crate::ways::{WAYS, Way};
use crate::{Figure, Input, Values, View, packed};

/// Where a camera is: what it looks at, from how far, and its field of view.
type Camera = (Vec3, f32, f32);

/// Width and height of most pictures.
const SIDE: u16 = 320;

const PLANES: Planes = Planes { near: 0.1, far: 100.0 };

/// From the world to clip space, for a square picture, and the eye.
pub(crate) fn camera((center, distance, fov): Camera, turn: [f32; 2]) -> (Mat4, Vec3) {
    let eye = eye(center, distance, turn);
    // Straight from above, another up stands in for y.
    let view = view(eye, center, Vec3::Y).unwrap_or_default();
    (perspective(fov, 1.0, PLANES.near, PLANES.far).unwrap_or_default() * view, eye)
}

/// Lesson 10's floor.
static FLOOR: LazyLock<Loaded> = LazyLock::new(packed::floor);

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
        Input::Choice { label: "Depths", rows: || Method::rows(perspective::DEPTHS), from: "z-f32" },
    ],
    draw: in_perspective,
};

fn in_perspective(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let way = values.choice(WAYS);
    let keep = values.choice(kept::DEPTHS);
    let (to_clip, _) = camera((Vec3::new(0.0, -0.1, 0.0), 3.6, 45.0), turn);
    let light = Vec3::new(0.5, 0.8, 0.9).normalize();
    let uniforms: [Uniforms; 2] = [&*HEAD, &*FLOOR].map(|loaded| loaded.uniforms(light, to_clip));
    let mut image = canvas(values.side(SIDE));
    let left_out = interpolated(&uniforms, way.run, (keep.run)(PLANES), &mut image);
    let rest = format!("triangles left out since they reach behind the eye: {left_out}");
    head::view(image, &format!("{}, {}", way.name, keep.name), "head and floor", turn, &rest)
}

/// Draws models as lesson 10 does, and returns how many triangles are left out.
fn interpolated(models: &[Uniforms], way: Way, depth: Kept, image: &mut Image) -> usize {
    let mut target = Framebuffer::new(image, depth);
    let mut left_out = 0;
    for uniforms in models {
        let (vertices, triangles) = (uniforms.model.positions().len(), uniforms.model.triangles());
        let shader = Lit::new(*uniforms, Texture, Clamped);
        left_out += render(&shader, vertices, triangles, way, depth, &mut target);
    }
    left_out
}

/// The head and lesson 11's floor, with their meshes and the levels of their textures.
pub(crate) static SCENE: LazyLock<[Filterable; 2]> = LazyLock::new(|| {
    let mipmap = const { MIPMAPS[1].run };
    [
        Filterable::new(packed::head(), mipmap, filtering::Wrap::Clamp),
        Filterable::new(packed::few_slabs(), mipmap, filtering::Wrap::Repeat),
    ]
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
    let method = values.choice(named!(clipping::METHODS));
    let (to_clip, _) = camera((Vec3::new(0.0, -0.2, 0.0), 3.07, 45.0), turn);
    let light = Vec3::new(0.4, 0.8, 0.8).normalize();
    let models = SCENE.each_ref().map(|model| (model.surface(light, to_clip).uniforms, model.mesh()));
    let mut image = canvas(values.side(SIDE));
    let Counts { left_out, cut, filled, .. } =
        clipping::draw(&models, Cull::Back, method.run, &mut image).counts;
    let rest = format!("triangles left out: {left_out}, cut: {cut}, filled: {filled}");
    head::view(image, method.name, "head and floor", turn, &rest)
}

/// Lesson 12's methods.
const LIGHTS: &[Method<Make>] = &with(lighting::METHODS, MAKES);

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
    let method = values.choice(LIGHTS);
    let (camera, eye) = camera((Vec3::new(0.0, 0.12, 0.0), 2.4, 45.0), [-13.0, 5.0]);
    let to_world = Mat4::from_mat3(euler(Vec3::new(turn[1], turn[0], 0.0)));
    let scene = Scene::placed(&HEAD, to_world, camera, eye, PointLight::default()).expect("it is not flat");
    let mut image = canvas(values.side(SIDE));
    let counts = lights::draw(&scene, method.run, SCENE[0].mesh(), &mut image);
    head::view(image, method.name, "the head", turn, &format!("triangles filled: {}", counts.filled))
}

/// Lesson 13's methods.
const FILTERS: &[Method<AnyFilter>] = &with(
    filtering::METHODS,
    [
        AnyFilter::Nearest,
        AnyFilter::Bilinear,
        AnyFilter::Bilinear8,
        AnyFilter::Trilinear,
        AnyFilter::Anisotropic,
    ],
);

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
    let method = values.choice(FILTERS);
    let mut image = canvas(values.side(SIDE));
    let counts = filters::draw(&on_a_floor(turn), method.run, &mut image);
    let rest = format!("triangles filled: {}", counts.filled);
    head::view(image, method.name, "head and floor", turn, &rest)
}

/// What lesson 13 draws, and 17 again.
fn on_a_floor(turn: [f32; 2]) -> [Surface<'static>; 2] {
    let (to_clip, _) = camera((Vec3::new(0.3, -0.35, 0.0), 3.75, 45.0), turn);
    let light = Vec3::new(0.4, 0.8, 0.8).normalize();
    SCENE.each_ref().map(|model| model.surface(light, to_clip))
}

/// Lesson 17's head.
pub(crate) const SPEED: Figure = Figure {
    name: "speed-default",
    stays: true,
    hint: "Take the eye around by dragging, or by the sliders. Choose another method: the picture stays the same, and the sentence \
           below tells how its pixels were shaded. Then time all methods. There is one thread here, so the method threads draws \
           as deferred does.",
    inputs: &[
        Input::Turn { from: [-31.0, 8.0] },
        method(|| Method::rows(speed::METHODS), "deferred"),
        Input::Times,
    ],
    draw: fast,
};

fn fast(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let method = values.choice(named!(speed::METHODS));
    let picture = Picture { surfaces: &on_a_floor(turn), cull: Cull::Back };
    let mut image = canvas(values.side(SIDE));
    let Shaded { fragments, calls } = counted::draw(method, &picture, &mut image);
    let by =
        if calls == fragments { "one by one".into() } else { format!("in {calls} groups of at most eight") };
    head::view(image, method.name, "head and floor", turn, &format!("{fragments} fragments are shaded, {by}"))
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
    let method = values.choice(named!(TRANSPARENCY));
    let (to_clip, eye) = camera((Vec3::new(0.0, -0.1, 0.0), 3.6, 45.0), turn);
    let view = blending::scene::View { to_clip, eye, light: PointLight::default() };
    let [head, slabs] = &*SCENE;
    let entity = |model, alpha| Entity { model, to_world: Mat4::IDENTITY, alpha };
    let entities = [&entity(slabs, 1.0), &entity(head, alpha)];
    let mut image = canvas(values.side(200));
    let Counts { filled, .. } = layers::draw(method.run, entities, &view, &mut image);
    let rest = format!("the head's alpha is {}; triangles filled: {filled}", fixed(alpha, 1));
    head::view(image, method.name, "head and floor", turn, &rest)
}

#[cfg(test)]
mod tests {
    use blending::scene::draw_by;
    use blending::{Over, TwoShift};

    use super::*;

    #[test]
    fn scenes_are_as_the_lessons_draw_them() {
        let (to_clip, _) = camera((Vec3::ZERO, 3.6, 45.0), [-18.0, 3.0]);
        let uniforms = [&*HEAD, &*FLOOR].map(|loaded| loaded.uniforms(Vec3::Z, to_clip));
        for (own, way) in WAYS.iter().zip(perspective::METHODS) {
            for (kept, keep) in kept::DEPTHS.iter().zip(perspective::DEPTHS) {
                let [mut drawn, mut meant] = [canvas(SIDE), canvas(SIDE)];
                interpolated(&uniforms, own.run, (kept.run)(PLANES), &mut drawn);
                (way.run.draw)(&keep.run)(&uniforms, PLANES, &mut meant);
                assert!(drawn == meant, "{}, {}", own.name, kept.name);
            }
        }
        let scene = Scene::placed(&HEAD, Mat4::IDENTITY, to_clip, Vec3::Z, PointLight::default()).unwrap();
        for (own, lesson) in LIGHTS.iter().zip(lighting::METHODS) {
            let [mut drawn, mut meant] = [canvas(SIDE), canvas(SIDE)];
            lights::draw(&scene, own.run, SCENE[0].mesh(), &mut drawn);
            (lesson.run)(&scene, SCENE[0].mesh(), Cull::Back, &mut meant);
            assert!(drawn == meant, "{}", own.name);
        }
        let surfaces = SCENE.each_ref().map(|model| model.surface(Vec3::Z, to_clip));
        for (own, lesson) in FILTERS.iter().zip(filtering::METHODS) {
            let [mut drawn, mut meant] = [canvas(SIDE), canvas(SIDE)];
            filters::draw(&surfaces, own.run, &mut drawn);
            (lesson.run.draw)(&surfaces, Cull::Back, &mut meant);
            assert!(drawn == meant, "{}", own.name);
        }
    }

    #[test]
    fn all_of_lesson_17s_methods_draw_the_same_and_count_what_they_shade() {
        let all = on_a_floor([-31.0, 8.0]);
        let shaded = |surfaces: &[Surface], method: &Method<speed::Renderer>| {
            let [mut drawn, mut meant] = [canvas(SIDE), canvas(SIDE)];
            filters::draw(surfaces, AnyFilter::Nearest, &mut meant);
            let shaded = counted::draw(method, &Picture { surfaces, cull: Cull::Back }, &mut drawn);
            assert!(drawn == meant, "{}", method.name);
            let is_narrow = ["simple", "blocks"].contains(&method.name);
            let Shaded { fragments, calls } = shaded;
            assert!(
                calls == fragments || calls < fragments && fragments <= 8 * calls,
                "{}: {shaded:?}",
                method.name
            );
            assert_eq!(calls == fragments, is_narrow, "{}: {shaded:?}", method.name);
            (fragments, meant)
        };
        let simple = shaded(&all, &speed::METHODS[0]).0;
        for method in speed::METHODS {
            let is_deferred = ["deferred", "threads"].contains(&method.name);
            let fragments = shaded(&all, method).0;
            assert_eq!(fragments < simple, is_deferred, "{}: {fragments}, not {simple}", method.name);
            // Nothing of the floor is behind another part of it, and nothing of it is black.
            let (fragments, floor) = shaded(&all[1..], method);
            let seen = floor.buffer().as_chunks().0.iter().filter(|&&pixel| pixel != [0; 3]).count();
            assert_eq!(fragments as usize, seen, "{}", method.name);
        }
    }

    #[test]
    fn layers_are_as_the_lesson_draws_them() {
        let (to_clip, eye) = camera((Vec3::new(0.0, -0.1, 0.0), 3.6, 45.0), [-31.0, 8.0]);
        let view = blending::scene::View { to_clip, eye, light: PointLight::default() };
        let [head, slabs] = &*SCENE;
        let entities = [(slabs, 1.0), (head, 0.5)].map(|(model, alpha)| Entity {
            model,
            to_world: Mat4::IDENTITY,
            alpha,
        });
        for method in TRANSPARENCY {
            let [mut drawn, mut meant] = [canvas(100), canvas(100)];
            let counts = layers::draw(method.run, entities.each_ref(), &view, &mut drawn);
            let lesson = draw_by(method.run, &entities, &view, Cull::None, Over(TwoShift), &mut meant).counts;
            assert_eq!(counts, lesson, "{}", method.name);
            assert!(drawn == meant, "{}", method.name);
        }
    }
}
