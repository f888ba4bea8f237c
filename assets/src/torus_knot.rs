//! A knotted tube.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use crate::mesh::{Corner, Mesh};

/// How often the knot goes around the y axis, and through the ring's hole: the trefoil.
const TURNS: (f64, f64) = (2.0, 3.0);
/// The ring's radius, how far from it the knot runs, and the tube's radius.
const RADII: [f64; 3] = [0.55, 0.22, 0.16];

/// The trefoil on a torus around the y axis, within [−1, 1]³: a tube cut into `rings` · `sides` fields of two
/// triangles.
///
/// u goes once along the whole knot, v once around the tube.
#[must_use]
pub fn torus_knot(rings: usize, sides: usize) -> Mesh {
    let mut mesh = Mesh::default();
    for ring in 0..=rings {
        let angle = TAU * (ring % rings) as f64 / rings as f64;
        let (middle, [right, up]) = (curve(angle), frame(angle));
        for side in 0..=sides {
            mesh.uvs.push(DVec2::new(ring as f64 / rings as f64, side as f64 / sides as f64));
            if ring < rings && side < sides {
                let around = TAU * side as f64 / sides as f64;
                let normal = right * libm::cos(around) + up * libm::sin(around);
                mesh.normals.push(normal);
                mesh.positions.push(middle + normal * RADII[2]);
            }
        }
    }
    let corner = |ring: usize, side: usize| {
        let position = ring % rings * sides + side % sides;
        Corner { position, uv: ring * (sides + 1) + side, normal: position }
    };
    for ring in 0..rings {
        for side in 0..sides {
            let [a, b] = [corner(ring, side), corner(ring + 1, side)];
            let [d, c] = [corner(ring, side + 1), corner(ring + 1, side + 1)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// The knot: around the axis and, meanwhile, around the ring.
fn curve(angle: f64) -> DVec3 {
    let (turn, twist) = (TURNS.0 * angle, TURNS.1 * angle);
    let radius = RADII[0] + RADII[1] * libm::cos(twist);
    DVec3::new(radius * libm::cos(turn), RADII[1] * libm::sin(twist), radius * libm::sin(turn))
}

/// Two unit vectors across the knot. The first points away from the ring, so that the frame closes where the
/// knot does.
fn frame(angle: f64) -> [DVec3; 2] {
    const STEP: f64 = 1e-4;
    let along = (curve(angle + STEP) - curve(angle - STEP)).normalize();
    let turn = TURNS.0 * angle;
    let from_ring = curve(angle) - DVec3::new(libm::cos(turn), 0.0, libm::sin(turn)) * RADII[0];
    let right = from_ring.reject_from(along).normalize();
    [right, right.cross(along)]
}
