//! What a frame costs besides time: no memory; and that a scene which uses nothing draws what lesson 15's loop does.

use std::iter;
use std::sync::Arc;
use std::time::Duration;

use antialiasing::Canvas;
use antialiasing::multisampled::Multisampled;
use antialiasing::storage::{Compressed, Samples};
use clipping::Cull;
use common::{Color, Format, Image, Mat4, Vec3};
use filtering::light::SRGB;
use filtering::{Texture, Wrap};
use lighting::PointLight;
use perspective::{perspective, view};
use scene::head::head;
use scene::keys::Key;
use scene::levels::{Sizes, spheres};
use scene::{
    Entity, Filtering, Levels, METHODS, Mesh, Paint, Scene, Shading, Simulation, Style, Target, VERSIONS,
    render_scene, sphere,
};
use verify::method;

use crate::plain::Plain;
use crate::stage::WHITE;

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
    for (antialiased, wireframe) in [(false, false), (true, false), (false, true), (true, true)] {
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
            (target.antialiased, target.wireframe) = (antialiased, wireframe);
            let mut vertices = Vec::new();
            for frame in 0..12_u8 {
                scene.entities[0].position.z = -1.01 - 40.0 / f32::from(1 + frame).powi(2);
                let mut computed = 0;
                let allocations = allocation_counter::measure(|| {
                    let counts = render_scene(&scene, &mut target, &projection, &Mat4::IDENTITY);
                    computed = counts.triangles.vertices;
                });
                vertices.push(computed);
                assert_eq!(allocations.count_total == 0, frame > 0, "{name}, frame {frame}, {wireframe}");
            }
            vertices.dedup();
            assert_eq!(vertices.len() > 4, name == "by-size", "{vertices:?}");
        }
    }
}

/// Nor does it when something comes into the picture of which there was nothing before: finer, and with a texture or colours of
/// its own.
#[test]
fn what_comes_later_allocates_nothing() {
    let white = Image::new(4, 4, Format::Rgb);
    let texture = Paint::Texture(Arc::new(Texture::new(&white, Wrap::Clamp, &SRGB)));
    let ball = |n: usize, paint| Levels::one(Mesh::new(&sphere(n, 2 * n), paint));
    let colors = Paint::Colors(vec![Color::RED; sphere(20, 40).vertices.len()]);
    let later = [ball(20, colors), ball(30, texture), ball(40, WHITE)];
    for shading in [Shading::Unlit, Shading::Phong, Shading::BlinnPhong] {
        for (antialiased, wireframe) in [(false, false), (true, false), (false, true), (true, true)] {
            let first = Entity { position: Vec3::new(0.0, 0.0, -5.0), ..Entity::new(ball(4, WHITE)) };
            // Behind the eye.
            let hidden = |levels: &Arc<Levels>| Entity {
                position: Vec3::new(0.0, 0.0, 5.0),
                alpha: 0.5,
                ..Entity::new(levels.clone())
            };
            let mut scene = Scene {
                entities: iter::once(first).chain(later.iter().map(hidden)).collect(),
                lights: vec![PointLight::default()],
                background: Color::BLACK,
                style: Style { shading, filter: Filtering::Trilinear, cull: Cull::Back },
            };
            let projection = perspective(60.0, 4.0 / 3.0, 0.01, 100.0).unwrap();
            let mut target = Target::new(160, 120);
            (target.antialiased, target.wireframe) = (antialiased, wireframe);
            let mut outside = [0; 4];
            for (frame, outside) in outside.iter_mut().enumerate() {
                if frame > 0 {
                    scene.entities[frame].position.z = -3.0;
                }
                let allocations = allocation_counter::measure(|| {
                    *outside = render_scene(&scene, &mut target, &projection, &Mat4::IDENTITY).outside;
                });
                let what = format!("{shading:?}, {antialiased}, {wireframe}, frame {frame}");
                assert_eq!(allocations.count_total == 0, frame > 0, "{what}");
            }
            assert_eq!(outside, [3, 2, 1, 0]);
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
