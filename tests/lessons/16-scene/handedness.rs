//! The assignment's space is left-handed, the course's is not: `versions::ours` is where the one becomes the other.

use checks::assignment::{Placement, mirrored};
use clipping::Cull;
use common::{DVec3, Vec3};
use proptest::prelude::*;
use scene::versions::ours;
use scene::{Entity, Levels, Mesh, Paint, cube};

use crate::versions::{drawn, scene_at};

fn entity(position: Vec3, degrees: Vec3, scale: Vec3) -> Entity {
    let cube = Levels::one(Mesh::new(&cube(), Paint::Color(common::Color::WHITE)));
    Entity { position, degrees, scale, ..Entity::new(cube) }
}

fn vector(most: f32) -> impl Strategy<Value = Vec3> {
    let one = move || -most..most;
    [one(), one(), one()].prop_map(Vec3::from)
}

/// Where the assignment's own pipeline brings a point of a mesh, seen from the course's space.
fn theirs(position: Vec3, degrees: Vec3, scale: Vec3, point: Vec3) -> DVec3 {
    let [position, degrees, scale, point] = [position, degrees, scale, point].map(Vec3::as_dvec3);
    mirrored(Placement { position, degrees, scale }.place(mirrored(point)))
}

proptest! {
    /// Every point is where it belongs. Sums of a few numbers of up to 10 are off by some ten ulps of 10, 10⁻⁵.
    #[test]
    fn every_placement_is_the_assignments(
        position in vector(5.0), degrees in vector(720.0), scale in vector(2.0), point in vector(1.0),
    ) {
        let (at, turned) = ours(position, degrees);
        let got = entity(at, turned, scale).to_world().transform_point3(point).as_dvec3();
        let expected = theirs(position, degrees, scale, point);
        prop_assert!((got - expected).length() < 3e-5, "{got}, not {expected}");
    }
}

/// What else one might write: z turned round and the angles left, all angles turned round, or those about z.
#[test]
fn other_signs_are_other_places() {
    let (position, degrees) = (Vec3::new(0.5, -0.25, 2.0), Vec3::new(20.0, 50.0, -35.0));
    let point = Vec3::new(0.5, 0.5, -0.5);
    let expected = theirs(position, degrees, Vec3::ONE, point);
    let off = |signs: Vec3| {
        let at = position * Vec3::new(1.0, 1.0, -1.0);
        let got = entity(at, degrees * signs, Vec3::ONE).to_world().transform_point3(point);
        (got.as_dvec3() - expected).length()
    };
    assert!(off(Vec3::new(-1.0, -1.0, 1.0)) < 1e-6);
    for signs in [Vec3::ONE, Vec3::NEG_ONE, Vec3::new(1.0, 1.0, -1.0), Vec3::new(-1.0, 1.0, 1.0)] {
        assert!(off(signs) > 0.2, "{signs}: {}", off(signs));
    }
}

/// With a quarter turn about x only the difference of the other two angles counts: different angles, one matrix. Whoever keeps the
/// matrix alone cannot turn on about one of them.
#[test]
fn a_matrix_does_not_tell_its_angles() {
    let matrix = |x, y, z| entity(Vec3::ZERO, Vec3::new(x, y, z), Vec3::ONE).to_world();
    assert!(matrix(90.0, 50.0, 20.0).abs_diff_eq(matrix(90.0, 100.0, 70.0), 1e-6));
    assert!(!matrix(80.0, 50.0, 20.0).abs_diff_eq(matrix(80.0, 100.0, 70.0), 0.1));
    // One step on about x from either: they part.
    assert!(!matrix(91.0, 50.0, 20.0).abs_diff_eq(matrix(91.0, 100.0, 70.0), 1e-3));
}

/// The usual perspective looks along −z: of what stands at z = +2, as the numbers are written, it shows nothing.
#[test]
fn with_its_own_numbers_all_is_behind_the_eye() {
    let mut scene = scene_at(5, 0.0);
    assert!(drawn(&scene, 5).0.pixels().any(|pixel| pixel.2 != scene.background));
    scene.entities.iter_mut().for_each(|entity| entity.position.z *= -1.0);
    let (picture, counts) = drawn(&scene, 5);
    assert!(picture.pixels().all(|pixel| pixel.2 == scene.background));
    assert_eq!(counts.outside, 2);
}

/// Meshes are closed and opaque and their outside is in front: to leave out backs changes nothing, to leave out fronts does,
/// in every version, whether things turn or not. Without depths both would be wrong.
#[test]
fn the_outside_is_in_front() {
    for number in [0, 2, 3, 4, 5, 6] {
        for seconds in [0.0, 1.7, 4.0] {
            let by = |cull| {
                let mut scene = scene_at(number, seconds);
                scene.style.cull = cull;
                drawn(&scene, number).0
            };
            let [all, fronts, backs] = [Cull::None, Cull::Back, Cull::Front].map(by);
            assert!(all == fronts, "version {number}, {seconds} s");
            assert!(all != backs || number == 0, "version {number}, {seconds} s");
        }
    }
}
