//! What a frame costs besides time: no memory.

use std::time::Duration;

use clipping::Cull;
use common::{Color, Mat4};
use lighting::PointLight;
use perspective::perspective;
use scene::keys::Key;
use scene::levels::{Sizes, spheres};
use scene::{
    Entity, Filtering, METHODS, Paint, Scene, Shading, Simulation, Style, Target, VERSIONS, render_scene,
};
use verify::method;

/// From the second frame on drawing allocates nothing, whichever way, though the scene turns.
#[test]
fn a_frame_allocates_nothing_after_the_first() {
    for version in VERSIONS {
        for keys in [&[][..], &[Key::F1], &[Key::F2], &[Key::F1, Key::F2]] {
            let mut simulation = Simulation::new(version, *method(METHODS, "by-size")).unwrap();
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
