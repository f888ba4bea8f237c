//! The numbers of the chapter's worked examples and of their quizzes, computed by the lesson's own code.

use clipping::assembly::Topology;
use clipping::clip::cut;
use clipping::plane::{PLANES, distance};
use clipping::{ClipVertex, facing};
use common::{Vec3, Vec4};
use perspective::perspective;

fn corner<V>(position: Vec4, varying: V) -> ClipVertex<V> {
    ClipVertex { position, varying }
}

#[test]
fn five_numbers_of_a_strip_and_of_a_fan() {
    let made = |topology: Topology| topology.triangles(&[0, 1, 2, 3, 4]).collect::<Vec<_>>();
    assert_eq!(made(Topology::Strip)[..2], [[0, 1, 2], [1, 3, 2]]);
    assert_eq!(made(Topology::Fan), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
}

/// The example of why clipping comes before the division, and its cut at the near plane.
#[test]
fn an_edge_of_the_floor() {
    let m = perspective(90.0, 1.0, 1.0, f32::INFINITY).unwrap();
    let [a, b] = [-4.0, 2.0].map(|z| (m * Vec4::new(0.0, -1.0, z, 1.0) * 1024.0).round() / 1024.0);
    assert_eq!([a, b], [Vec4::new(0.0, -1.0, 2.0, 4.0), Vec4::new(0.0, -1.0, -4.0, -2.0)]);
    assert_eq!([a.y / a.w, b.y / b.w], [-0.25, 0.5]);
    let distances = [a, b].map(|end| distance(PLANES[0], end));
    assert_eq!(distances, [6.0, -6.0]);
    let at = cut([corner(a, ()), corner(b, ())], distances).position;
    assert_eq!(at, Vec4::new(0.0, -1.0, -1.0, 1.0));
}

/// Points (x, y, 1) of the plane as (x, y, ·, w).
#[test]
fn a_segment_cut_at_three() {
    let plane = Vec4::new(-1.0, 0.0, 0.0, 3.0);
    let ends = [(1.0, 1.0, 10.0), (4.0, -2.0, 40.0)].map(|(x, y, v)| corner(Vec4::new(x, y, 0.0, 1.0), v));
    let distances = ends.map(|end| distance(plane, end.position));
    assert_eq!(distances, [2.0, -1.0]);
    let ClipVertex { position, varying } = cut(ends, distances);
    assert!(position.distance(Vec4::new(3.0, -1.0, 0.0, 1.0)) < 1e-6, "{position}");
    assert!((varying - 30.0_f32).abs() < 1e-5, "{varying}");
}

#[test]
fn the_share_from_one_to_minus_three() {
    let ends = [corner(Vec4::ZERO, 0.0_f32), corner(Vec4::ONE, 1.0)];
    assert_eq!(cut(ends, [1.0, -3.0]).varying, 0.25);
}

#[test]
fn a_corner_moved_along_its_ray_doubles_the_determinant() {
    let m = perspective(60.0, 1.0, 0.5, 20.0).unwrap();
    let corners = [Vec3::new(-1.0, -1.0, -4.0), Vec3::new(1.0, -0.5, -3.0), Vec3::new(0.0, 1.0, -5.0)];
    let clip = corners.map(|p| m * p.extend(1.0));
    let moved = [clip[0], clip[1], m * (corners[2] * 2.0).extend(1.0)];
    let ratio = facing(moved) / facing(clip);
    assert!(facing(clip) > 0.0 && (ratio - 2.0).abs() < 1e-6, "{ratio}");
}

/// With one corner behind the eye the area after the division has the wrong sign, with two the right one.
#[test]
fn the_sign_of_the_area_turns_with_each_corner_behind() {
    let area = |corners: [Vec4; 3]| {
        let [a, b, c] = corners.map(|p| common::Vec2::new(p.x, p.y) / p.w);
        f64::from((b - a).perp_dot(c - a))
    };
    let m = perspective(60.0, 1.0, 0.5, 20.0).unwrap();
    for behind in 0..4 {
        let corner = |n: usize, x: f32, y: f32| {
            let z = if n < behind { 3.0 + n as f32 } else { -3.0 - n as f32 };
            m * Vec4::new(x, y, z, 1.0)
        };
        let corners = [corner(0, -1.0, -1.0), corner(1, 1.0, -0.5), corner(2, 0.0, 1.0)];
        let same = area(corners).signum() == facing(corners).signum();
        assert_eq!(same, behind % 2 == 0, "{behind} behind");
    }
}
