//! The camera's matrix and its inverse, which `render_scene` takes.

use common::{Color, Mat4, Vec3};
use scene::{Entity, Orbit, Target, render_scene};
use transforms::affine::translate;
use transforms::inverse::INVERSES;

use crate::pictures::FIELD_OF_VIEW;
use crate::pictures::{SIZE, WAYS, ahead, cube_of, different, lit, patched_cube, seen_as, sphere_of};
use crate::truth::{Eye, Truth};

fn things() -> Vec<Entity> {
    let left = Entity {
        position: Vec3::new(-1.1, 0.2, 0.4),
        degrees: Vec3::new(20.0, 30.0, 0.0),
        ..Entity::new(patched_cube())
    };
    vec![
        left,
        Entity { position: Vec3::new(0.9, -0.1, -0.3), ..Entity::new(sphere_of(Color::rgb(40, 90, 220))) },
    ]
}

/// The matrix of an orbit is a turn and a move, which each of lesson 7's three ways inverts to the same picture. Products are
/// rounded differently: a pixel or two at a side may change hands, and a channel by a level.
#[test]
fn each_inverse_shows_the_same() {
    let scene = lit(things());
    for orbit in [(0.0, 0.0, 4.0), (25.0, 20.0, 5.0), (-130.0, 65.0, 3.0), (200.0, -89.0, 6.0)] {
        let (azimuth, elevation, distance) = orbit;
        let camera = Orbit::new(azimuth, elevation, distance).camera();
        let pictures: Vec<_> = INVERSES
            .iter()
            .map(|inverse| {
                let mut target = Target::new(SIZE[0], SIZE[1]);
                let projection = ahead(target.picture().size());
                render_scene(&scene, &mut target, &projection, &(inverse.run)(&camera).expect("an inverse"));
                target.into_picture()
            })
            .collect();
        for (picture, inverse) in pictures.iter().zip(INVERSES) {
            let off =
                picture.pixels().zip(pictures[0].pixels()).map(|(a, b)| checks::picture::distance(a.2, b.2));
            assert!(off.filter(|&off| off > 1).count() <= 2, "{} at {orbit:?}", inverse.name);
        }
    }
}

/// A camera that is moved to the left shows what one sees if all things are moved to the right, the lamp too.
#[test]
fn moving_the_camera_is_moving_all_else() {
    let by = Vec3::new(-0.75, 0.5, 4.0);
    let shown = |scene: &scene::Scene, camera: Mat4| {
        let mut target = Target::new(SIZE[0], SIZE[1]);
        let projection = ahead(target.picture().size());
        render_scene(scene, &mut target, &projection, &camera);
        target.into_picture()
    };
    let scene = lit(things());
    let mut moved = lit(things());
    moved.entities.iter_mut().for_each(|entity| entity.position -= by);
    moved.lights.iter_mut().for_each(|light| light.position -= by);
    let [a, b] = [shown(&scene, translate(-by)), shown(&moved, Mat4::IDENTITY)];
    let off = a.pixels().zip(b.pixels()).map(|(a, b)| checks::picture::distance(a.2, b.2));
    assert!(off.filter(|&off| off > 1).count() <= 2);
}

/// From all sides, as rays show it: the eye's place, which no parameter of the assignment's function tells, is that of the
/// camera, and highlights are where it sees them.
#[test]
fn highlights_are_seen_from_the_cameras_place() {
    let scene = lit(things());
    for (azimuth, elevation, distance) in [(25.0, 20.0, 5.0), (150.0, -40.0, 4.0), (-75.0, 80.0, 6.0)] {
        let orbit = Orbit::new(azimuth, elevation, distance);
        let mut target = Target::new(SIZE[0], SIZE[1]);
        crate::pictures::draw_from(&scene, orbit, &mut target);
        Truth::new(&scene, Eye::Around(orbit, FIELD_OF_VIEW)).check(target.picture(), 1.02, 0.2);
    }
}

/// Until version 8 the camera stands at (0, 0, 0), and from version 9 on it is to circle (0, 0, 0): from there no orbit
/// begins. At a distance of 0 every azimuth is in one place.
#[test]
fn no_orbit_begins_where_the_camera_was() {
    for version in &scene::VERSIONS[9..] {
        assert!(version.camera.is_some_and(|orbit| orbit.distance() > 1.0), "version {}", version.number);
    }
    assert!(scene::VERSIONS[..9].iter().all(|version| version.camera.is_none()));
    let place = |azimuth| scene::orbit(azimuth, 20.0, 0.0).w_axis.truncate();
    assert_eq!([place(0.0), place(90.0)], [Vec3::ZERO; 2]);
}

/// What each way of drawing shows of a scene is the same whether its things are opaque cubes of one or of 24 colours.
#[test]
fn one_colour_is_24_equal_ones() {
    use scene::{Levels, Mesh, Paint, cube};
    let color = Color::rgb(200, 40, 90);
    let many = Levels::one(Mesh::new(&cube(), Paint::Colors(vec![color; 24])));
    for [antialiased, wireframe] in WAYS {
        let [one, many] = [cube_of(color), many.clone()]
            .map(|levels| seen_as(&lit(vec![Entity::new(levels)]), antialiased, wireframe));
        assert_eq!(different(&one, &many), 0);
    }
}
