//! What each version shows, against a ray through each pixel, and that it is what the assignment asks for.

use std::time::Duration;

use checks::assignment::mirrored;
use common::{Color, DVec3, Image, Mat4};
use scene::keys::Key;
use scene::{Counts, Paint, Scene, Shading, Simulation, Target, VERSIONS, Version, render_scene};
use transforms::inverse::elimination;

use crate::truth::{Eye, Truth, placement};

/// Degrees from the bottom of a version's picture to its top, from version 5 on.
pub(crate) fn field_of_view(number: usize) -> f64 {
    match number {
        5 => 75.0,
        6..=8 => 60.0,
        _ => 50.0,
    }
}

/// Small, and of the window's proportions.
pub(crate) const SIZE: [u16; 2] = [160, 120];

/// Spheres of few triangles, so that sides are few.
pub(crate) const COARSE: &[[usize; 2]] = &[[8, 16]];

/// A version's scene after so many seconds.
pub(crate) fn scene_at(number: usize, seconds: f64) -> Scene {
    let Version { scene, animate, .. } = &VERSIONS[number];
    let mut scene = scene(COARSE).expect("the assets are there");
    if let Some(animate) = animate {
        animate(&mut scene, seconds);
    }
    scene
}

/// What the program shows of a version at that time, with one sample a pixel or, where the version has them, with sixteen.
pub(crate) fn picture_at(number: usize, seconds: f64, antialiased: bool) -> Image {
    let mut simulation = Simulation::new(&VERSIONS[number], COARSE).expect("the assets are there");
    simulation.advance(Duration::from_secs_f64(seconds));
    if VERSIONS[number].antialiasing && !antialiased {
        simulation.press(Key::F2);
    }
    let mut target = Target::new(SIZE[0], SIZE[1]);
    simulation.draw(&mut target);
    target.into_picture()
}

/// What is seen of a scene as a version looks at its own, and what became of it.
pub(crate) fn drawn(scene: &Scene, number: usize) -> (Image, Counts) {
    let mut target = Target::new(SIZE[0], SIZE[1]);
    let Version { projection, camera, .. } = &VERSIONS[number];
    let camera = camera.map_or(Mat4::IDENTITY, |orbit| orbit.camera());
    let inverse = elimination(&camera).expect("a camera that has an inverse");
    let projection = projection(target.picture().size());
    let counts = render_scene(scene, &mut target, &projection, &inverse);
    (target.into_picture(), counts)
}

/// Who looks at a version.
pub(crate) fn eye(number: usize) -> Eye {
    match VERSIONS[number].camera {
        None if number < 5 => Eye::Orthographic,
        None => Eye::Ahead(field_of_view(number)),
        Some(orbit) => Eye::Around(orbit, field_of_view(number)),
    }
}

/// What stands where: the assignment's words, in its own space. A side of 1 and a radius of 1 are as large as a unit.
#[test]
fn things_stand_where_the_assignment_says() {
    let cube_and_sphere = |x: f64| vec![[-x, 0.0, 2.0], [x, 0.0, 2.0]];
    for (number, places) in [
        (0, cube_and_sphere(2.5)),
        (1, vec![[0.0, 0.0, 2.0]]),
        (2, cube_and_sphere(0.5)),
        (3, cube_and_sphere(0.5)),
        (4, cube_and_sphere(0.5)),
        (5, cube_and_sphere(0.5)),
    ] {
        let scene = scene_at(number, 0.0);
        let found: Vec<[f64; 3]> =
            scene.entities.iter().map(|entity| placement(entity).position.to_array()).collect();
        assert_eq!(found, places, "version {number}");
        for entity in &scene.entities {
            let placement = placement(entity);
            assert_eq!((placement.degrees, placement.scale, entity.alpha), (DVec3::ZERO, DVec3::ONE, 1.0));
        }
    }
    let triangle = scene_at(1, 0.0);
    let mesh = triangle.entities[0].levels.finest();
    let corners = [0, 1, 2].map(|corner| mesh.positions()[mesh.vertex(0, corner)].to_array());
    assert_eq!(corners, [[-0.5, -0.5, 0.0], [0.5, -0.5, 0.0], [0.0, 0.5, 0.0]]);
    let Paint::Colors(colors) = mesh.paint() else { panic!("a colour at each corner") };
    let found = [0, 1, 2].map(|corner| colors[mesh.vertex(0, corner)]);
    assert_eq!(found, [Color::RED, Color::GREEN, Color::rgb(0, 0, 255)]);
    for number in 2..=5 {
        let paints =
            scene_at(number, 0.0).entities.iter().map(|entity| entity.levels.clone()).collect::<Vec<_>>();
        let color = |n: usize| match paints[n].finest().paint() {
            Paint::Color(color) => *color,
            Paint::Colors(_) | Paint::Texture(_) => panic!("one colour"),
        };
        assert_eq!([color(0), color(1)], [Color::RED, Color::rgb(0, 0, 255)], "version {number}");
    }
}

/// At the eye, with its three shares; not lit before version 3, at the corners there, at each pixel from 4 on.
#[test]
fn the_light_is_the_assignments() {
    for number in 0..=5 {
        let scene = scene_at(number, 0.0);
        let expected = [Shading::Unlit, Shading::Phong, Shading::BlinnPhong][number.saturating_sub(2).min(2)];
        assert_eq!(scene.style.shading, expected, "version {number}");
        if number < 3 {
            continue;
        }
        let [light] = scene.lights[..] else { panic!("one light") };
        assert_eq!(mirrored(light.position.as_dvec3()), DVec3::ZERO);
        assert_eq!([light.ambient, light.diffuse, light.specular], [0.2, 0.4, 0.4]);
    }
}

/// Pixel by pixel, all that no rounding of a corner can change.
#[test]
fn each_version_shows_what_rays_meet() {
    for number in 0..=10 {
        for seconds in [0.0, 1.7] {
            let truth = Truth::new(&scene_at(number, seconds), eye(number));
            println!("version {number} after {seconds} s");
            // The texel and its light are rounded, each by up to ½; from version 8 on what is laid over it, too.
            let tolerance = if number < 8 { 1.0 } else { 1.5 };
            truth.check(&picture_at(number, seconds, false), tolerance + 0.02, 0.1);
        }
    }
}
