//! Lesson 16's scene, without what a page would have to load: the head in one level, among spheres, one of them of glass, on a
//! floor.

use std::sync::{Arc, LazyLock, Mutex};

use common::{Color, Method, Vec2, Vec3};
use filtering::MIPMAPS;
use live_loops::looks::FewLooks;
use perspective::scene::Loaded;
use scene::levels::{Sizes, spheres};
use scene::version_11::{GROUND, VERSION, lit};
use scene::{Entity, Levels, METHODS, Mesh, Orbit, Paint, Scene, Shape, Target, render_scene};
use sheet::short;
use transforms::inverse::rigid;

use crate::head::{self, HEAD, method};
use crate::input::named;
use crate::{Figure, Input, Values, View, packed};

/// Width and height of the picture.
const SIDE: u16 = 240;

pub(crate) const SCENE: Figure = Figure {
    name: "scene-default",
    stays: true,
    hint: "Take the eye around by dragging, or by the sliders, and nearer. Choose how many triangles the spheres have.",
    inputs: &[
        Input::Turn { from: [-24.0, 4.0] },
        Input::Slider { label: "Distance", from: 7.0, range: [2.0, 28.0], step: 0.5 },
        method(|| Method::rows(METHODS), "by-size"),
    ],
    draw,
};

/// A model with its texture and the levels of that.
fn textured(loaded: &Loaded, wrap: filtering::Wrap) -> Arc<Levels> {
    let texture = Arc::new(MIPMAPS[1].run.texture(&loaded.texture, wrap));
    Levels::one(Mesh::new(&Shape::of(&loaded.model, &loaded.normals), Paint::Texture(texture)))
}

/// The head and the floor.
static MODELS: LazyLock<[Arc<Levels>; 2]> = LazyLock::new(|| {
    [textured(&HEAD, filtering::Wrap::Clamp), textured(&packed::few_slabs(), filtering::Wrap::Repeat)]
});

fn scene(sizes: Sizes) -> Scene {
    let [head, floor] = &*MODELS;
    let [gold, cyan] =
        [(245, 180, 50), (120, 220, 235)].map(|(r, g, b)| spheres(sizes, &Paint::Color(Color::rgb(r, g, b))));
    let at = |levels: &Arc<Levels>, position: [f32; 3], size: f32| Entity {
        position: position.into(),
        scale: Vec3::splat(size),
        ..Entity::new(levels.clone())
    };
    lit(vec![
        at(head, [0.0; 3], 1.0),
        at(&gold, [1.35, GROUND + 0.4, 0.35], 0.4),
        Entity { alpha: 0.4, ..at(&cyan, [0.75, GROUND + 0.3, 1.25], 0.3) },
        at(floor, [0.0; 3], 1.0),
    ])
}

/// The scene with the spheres that were asked for last: to make them takes longer than to draw them.
static KEPT: Mutex<Option<(&str, Scene)>> = Mutex::new(None);

fn draw(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let distance = values.number();
    let method = values.choice(named!(METHODS));
    let mut kept = KEPT.lock().expect("no drawing fails");
    let (_, scene) = match kept.take() {
        Some((name, scene)) if name == method.name => kept.insert((name, scene)),
        _ => kept.insert((method.name, scene(method.run))),
    };
    // No wireframe is asked for, and what draws one would be loaded with the page.
    let side = values.side(SIDE);
    let mut target = Target::with_both([Box::new(FewLooks), Box::new(FewLooks)], side, side);
    let counts = seen(scene, turn, distance, &mut target);
    let rest = format!(
        "the eye is {} away; entities outside: {}, triangles filled: {}",
        short(distance),
        counts.outside,
        counts.triangles.filled,
    );
    head::view(target.into_picture(), method.name, "the scene", turn, &rest)
}

/// Draws the scene as a camera sees it that goes around it, so far away.
fn seen(scene: &Scene, turn: [f32; 2], distance: f32, target: &mut Target) -> scene::Counts {
    let projection = (VERSION.projection)(Vec2::ONE);
    let camera = Orbit::new(-turn[0], turn[1], distance).above(0.9 * GROUND).camera();
    render_scene(scene, target, &projection, &rigid(&camera))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scene_is_as_the_lesson_draws_it() {
        for (turn, distance) in [([-24.0, 4.0], 7.0), ([90.0, 45.0], 3.0), ([180.0, -30.0], 2.0)] {
            let scene = scene(METHODS[0].run);
            let [mut own, mut lesson] =
                [Target::with(Box::new(FewLooks), SIDE, SIDE), Target::new(SIDE, SIDE)];
            let counts = [&mut own, &mut lesson].map(|target| seen(&scene, turn, distance, target));
            assert_eq!(counts[0], counts[1], "{turn:?}");
            assert!(own.picture() == lesson.picture(), "{turn:?}");
        }
    }
}
