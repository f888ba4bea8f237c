//! What a frame costs besides time: no memory; and that a scene which uses nothing draws what lesson 15's loop does.

use std::time::Duration;

use antialiasing::Canvas;
use antialiasing::multisampled::Multisampled;
use antialiasing::storage::{Compressed, Samples};
use clipping::Cull;
use common::{Color, Format, Image, Mat4, Vec3};
use lighting::PointLight;
use perspective::{perspective, view};
use scene::head::head;
use scene::keys::Key;
use scene::levels::{Sizes, spheres};
use scene::{
    Entity, Filtering, METHODS, Paint, Scene, Shading, Simulation, Style, Target, VERSIONS, render_scene,
};
use verify::method;

use crate::plain::Plain;

/// From the second frame on drawing allocates nothing, whichever way, though the scene turns.
#[test]
fn a_frame_allocates_nothing_after_the_first() {
    for version in VERSIONS {
        for keys in [&[][..], &[Key::F1], &[Key::F2], &[Key::F1, Key::F2]] {
            let mut simulation = Simulation::new(version, method::<Sizes>(METHODS, "by-size")).unwrap();
            keys.iter().for_each(|&key| simulation.press(key));
            let mut target = Target::new(160, 120);
            let mut allocations = || {
                simulation.advance(Duration::from_millis(20));
                allocation_counter::measure(|| {
                    simulation.draw(&mut target);
                })
                .count_total
            };
            let [first, second, third] = [allocations(), allocations(), allocations()];
            assert!(first > 0, "{}, {keys:?}: a target keeps something", version.number);
            assert_eq!([second, third], [0; 2], "{}, {keys:?}", version.number);
        }
    }
}

/// Nor does it when things come nearer and finer levels take the places of coarser ones.
#[test]
fn a_finer_level_allocates_nothing() {
    for antialiased in [false, true] {
        for name in ["by-size", "8x16"] {
            let sizes: &Sizes = method(METHODS, name);
            let spheres = spheres(sizes, &Paint::Color(Color::WHITE));
            let mut scene = Scene {
                entities: vec![Entity::new(spheres)],
                lights: vec![PointLight::default()],
                background: Color::BLACK,
                style: Style { shading: Shading::BlinnPhong, filter: Filtering::Nearest, cull: Cull::Back },
            };
            let projection = perspective(60.0, 4.0 / 3.0, 0.01, 100.0).unwrap();
            let mut target = Target::new(160, 120);
            target.antialiased = antialiased;
            let mut vertices = Vec::new();
            for frame in 0..12_u8 {
                scene.entities[0].position.z = -1.01 - 40.0 / f32::from(1 + frame).powi(2);
                let mut computed = 0;
                let allocations = allocation_counter::measure(|| {
                    let counts = render_scene(&scene, &mut target, &projection, &Mat4::IDENTITY);
                    computed = counts.triangles.vertices;
                });
                vertices.push(computed);
                assert_eq!(allocations.count_total == 0, frame > 0, "{name}, frame {frame}");
            }
            vertices.dedup();
            assert_eq!(vertices.len() > 4, name == "by-size", "{vertices:?}");
        }
    }
}

/// One entity of one colour, without light: to the last pixel what lesson 15's loop draws with a shader of one line. (What it
/// takes more, at most a 20th, is measured in `bench`.)
#[test]
fn a_scene_that_uses_nothing_is_lesson_15s_loop() {
    fn check<C: Canvas<Stencil = ()>>(antialiased: bool) {
        let (color, background) = (Color { a: 255, ..Color::rgb(200, 150, 100) }, Color::rgb(9, 8, 7));
        let mut entity = Entity::new(head(&Paint::Color(color)).unwrap());
        (entity.position, entity.degrees) = (Vec3::new(0.3, -0.2, 0.1), Vec3::new(20.0, 50.0, -30.0));
        let style = Style { shading: Shading::Unlit, filter: Filtering::Trilinear, cull: Cull::Back };
        let scene = Scene { entities: vec![entity.clone()], lights: Vec::new(), background, style };
        let projection = perspective(45.0, 230.0 / 170.0, 0.1, 100.0).unwrap();
        // So near that triangles are cut, and the finest level is the one to be drawn.
        let camera = view(Vec3::new(0.4, 0.3, 1.0), Vec3::ZERO, Vec3::Y).unwrap();
        let mut target = Target::new(230, 170);
        target.antialiased = antialiased;
        let drawn = render_scene(&scene, &mut target, &projection, &camera);
        let to_clip = projection * camera * entity.to_world();
        let plain = Plain { mesh: entity.levels.finest(), to_clip, color };
        let mut picture = Image::new(230, 170, Format::Rgb);
        let counts = plain.draw(background, &mut C::new([230, 170]), &mut picture);
        assert_eq!(drawn.triangles, counts);
        assert!(counts.filled > 1000 && counts.outside > 0, "{counts:?}");
        assert!(picture == *target.picture());
    }
    check::<Multisampled<1, Samples<1>>>(false);
    check::<Multisampled<16, Compressed<16>>>(true);
}
