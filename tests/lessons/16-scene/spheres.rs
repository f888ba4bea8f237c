//! What holds for a sphere of any size.

use std::collections::BTreeMap;

use common::{DVec3, Vec2, Vec3};
use proptest::prelude::*;
use scene::{Shape, sphere};

/// A sphere's vertices at their places, each place once, whatever the texture has there.
fn places(shape: &Shape) -> Vec<[[u32; 3]; 3]> {
    let key = |vertex: u32| shape.vertices[vertex as usize].position.to_array().map(|c| (c + 0.0).to_bits());
    shape.triangles.iter().map(|triangle| triangle.map(key)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Each side of a triangle is another one's, walked the other way: no gap, no overlap, not even at the seam.
    #[test]
    fn it_is_closed(latitudes in 2usize..30, longitudes in 3usize..40) {
        let mut sides = BTreeMap::new();
        for [a, b, c] in places(&sphere(latitudes, longitudes)) {
            for side in [[a, b], [b, c], [c, a]] {
                *sides.entry(side).or_insert(0) += 1;
            }
        }
        for ([from, to], count) in &sides {
            prop_assert_eq!(*count, 1);
            prop_assert_eq!(sides.get(&[*to, *from]), Some(&1));
        }
        // Euler: one surface without a hole.
        let vertices = sides.keys().map(|[from, _]| from).collect::<std::collections::BTreeSet<_>>().len();
        prop_assert_eq!(vertices, longitudes * (latitudes - 1) + 2);
        prop_assert_eq!(vertices + sides.len() / 3, sides.len() / 2 + 2);
    }

    /// Triangles face outwards, and none is without an area, however thin the slices at the poles.
    #[test]
    fn it_faces_outwards(latitudes in 2usize..40, longitudes in 3usize..300) {
        let shape = sphere(latitudes, longitudes);
        prop_assert_eq!(shape.triangles.len(), 2 * longitudes * (latitudes - 1));
        for triangle in &shape.triangles {
            let [a, b, c] = triangle.map(|vertex| shape.vertices[vertex as usize].position.as_dvec3());
            let (normal, middle): (DVec3, DVec3) = ((b - a).cross(c - a), (a + b + c) / 3.0);
            prop_assert!(normal.dot(middle) > 0.99 * normal.length() * middle.length() * cos_of_half_a_cell(latitudes, longitudes), "{:?}", triangle);
        }
    }

    /// A vertex is on the sphere and its normal points out of it; (u, v) is the angles, v up and u to the right seen from outside,
    /// and no triangle reaches around the seam.
    #[test]
    fn vertices_know_where_they_are(latitudes in 2usize..30, longitudes in 3usize..40) {
        let shape = sphere(latitudes, longitudes);
        prop_assert_eq!(shape.vertices.len(), (longitudes + 1) * (latitudes - 1) + 2 * longitudes);
        for vertex in &shape.vertices {
            prop_assert_eq!(vertex.normal, vertex.position);
            prop_assert!((vertex.position.as_dvec3().length() - 1.0).abs() < 1e-7);
            prop_assert!(vertex.uv.cmpge(Vec2::ZERO).all() && vertex.uv.cmple(Vec2::ONE).all());
            let [u, v] = vertex.uv.as_dvec2().to_array();
            let (theta, phi) = (std::f64::consts::PI * (1.0 - v), std::f64::consts::TAU * u);
            let place = DVec3::new(theta.sin() * phi.sin(), theta.cos(), theta.sin() * phi.cos());
            prop_assert!(vertex.position.as_dvec3().distance(place) < 1e-6, "{:?}", vertex);
        }
        for triangle in &shape.triangles {
            let corners = triangle.map(|vertex| shape.vertices[vertex as usize]);
            let uvs = corners.map(|corner| corner.uv);
            // Counterclockwise on the sphere, counterclockwise in the texture: nothing is mirrored.
            prop_assert!((uvs[1] - uvs[0]).perp_dot(uvs[2] - uvs[0]) > 0.0, "{:?}", uvs);
            let [low, high] = [uvs.into_iter().reduce(Vec2::min), uvs.into_iter().reduce(Vec2::max)].map(Option::unwrap);
            prop_assert!((high - low).x < 1.001 / longitudes as f32 && (high - low).y < 1.001 / latitudes as f32);
        }
    }
}

/// The least cosine between a facet's normal and the way to a point of it.
fn cos_of_half_a_cell(latitudes: usize, longitudes: usize) -> f64 {
    let [half_up, half_across] = [latitudes, longitudes].map(|n| std::f64::consts::PI / n as f64 / 2.0);
    half_up.cos() * half_across.cos() * half_across.cos()
}

/// The poles are vertices for each slice; u is in its middle.
#[test]
fn poles_have_as_many_vertices_as_slices() {
    let shape = sphere(4, 6);
    for (pole, v) in [(Vec3::Y, 1.0), (Vec3::NEG_Y, 0.0)] {
        let there: Vec<Vec2> =
            shape.vertices.iter().filter(|vertex| vertex.position == pole).map(|vertex| vertex.uv).collect();
        let expected: Vec<Vec2> = (0..6).map(|n| Vec2::new((n as f32 + 0.5) / 6.0, v)).collect();
        assert_eq!(there, expected);
    }
}

/// Less is not a sphere.
#[test]
fn less_than_two_latitudes_or_three_longitudes_are_refused() {
    for [latitudes, longitudes] in [[1, 8], [0, 8], [8, 2], [8, 0]] {
        assert!(
            std::panic::catch_unwind(|| sphere(latitudes, longitudes)).is_err(),
            "{latitudes}x{longitudes}"
        );
    }
}
