//! All of mission 16.
use std::f32::consts::{PI, TAU};

use common::{Mat4, Vec2, Vec3};

pub use scene_given::{Shape, Vertex, after, cube, draw, rotate_x, rotate_y, rotate_z, translate};

/// Rows from the north, and the triangles between them.
pub fn sphere(latitudes: usize, longitudes: usize) -> Shape {
    let mut shape = Shape::default();
    for i in 0..=latitudes {
        let is_pole = i == 0 || i == latitudes;
        let theta = PI * i as f32 / latitudes as f32;
        for j in 0..longitudes + usize::from(!is_pole) {
            let phi = TAU * j as f32 / longitudes as f32;
            let position = Vec3::new(theta.sin() * phi.sin(), theta.cos(), theta.sin() * phi.cos());
            let middle = if is_pole { 0.5 } else { 0.0 };
            let uv = Vec2::new((j as f32 + middle) / longitudes as f32, 1.0 - i as f32 / latitudes as f32);
            shape.vertices.push(Vertex { position, normal: position, uv });
        }
    }
    // Where a row begins: the first one has `longitudes` vertices, each other before the last one more.
    let first = |i: usize| if i == 0 { 0 } else { longitudes + (i - 1) * (longitudes + 1) };
    for i in 0..latitudes {
        for j in 0..longitudes {
            let [upper, lower] = [first(i) + j, first(i + 1) + j].map(|n| n as u32);
            if i == 0 {
                shape.triangles.push([upper, lower, lower + 1]);
            } else if i == latitudes - 1 {
                shape.triangles.push([upper, lower, upper + 1]);
            } else {
                shape.triangles.extend([[upper, lower, lower + 1], [upper, lower + 1, upper + 1]]);
            }
        }
    }
    shape
}

/// First away from the origin, then up, then round it.
pub fn orbit(azimuth: f32, elevation: f32, distance: f32) -> Mat4 {
    Mat4::from_mat3(rotate_y(azimuth) * rotate_x(-elevation)) * translate(Vec3::new(0.0, 0.0, distance))
}
