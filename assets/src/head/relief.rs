//! What is too fine for the field, as heights over its surface: strands of hair, pores, creases. Only maps of normals have it.

use std::f64::consts::PI;

use glam::DVec3;

use super::noise::{bump, noise};
use super::paint::{Strands, beard, brow, hair, lip};
use super::shape::{EYE, EYE_HALF, eye_opening, step};

/// The unit normal of a surface of which `normal` is the unit normal at a point, once it is raised by `depth` times its
/// height.
///
/// Only slopes along the surface count, to first order. Blinn, "Simulation of Wrinkled Surfaces" (SIGGRAPH 1978).
#[must_use]
pub fn raised(p: DVec3, normal: DVec3, depth: f64) -> DVec3 {
    /// Half a texel of the face: slopes are means over a texel.
    const STEP: f64 = 7.5e-4;
    let slope = |axis: DVec3| (height(p + axis * STEP) - height(p - axis * STEP)) / (2.0 * STEP);
    let slopes = DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z));
    (normal - (slopes - normal * slopes.dot(normal)) * depth).normalize()
}

/// How high the relief is at a point of the bust, in head heights.
fn height(p: DVec3) -> f64 {
    let side = DVec3::new(p.x.abs(), p.y, p.z);
    let (mut hairs, mut bare) = (0.0, 1.0);
    if let Some(Strands { cover, strand, fine, .. }) = hair(side, p) {
        // Towards the whorl strands are thinner, and so less high.
        let from = p - DVec3::new(0.03, 0.4, -0.25);
        let thick = ((from.x * from.x + from.z * from.z).sqrt() / 0.3).min(1.0);
        // Towards the back a texel is wider than a hair, and at last than a strand.
        let turn = libm::atan2(side.x, p.z + 0.02) / PI;
        let (strands, single) = (1.0 - 0.7 * step((turn - 0.6) / 0.4), 1.0 - step((turn - 0.1) / 0.3));
        hairs += cover * thick * (0.0032 * strands * strand + 0.0007 * single * fine);
        bare -= cover;
    }
    if let Some((dense, hair)) = brow(side, p) {
        hairs += 0.0022 * dense * hair;
        bare *= 1.0 - dense;
    }
    // Pores and stubble, which end on the neck.
    let face = step((p.y + 0.62) / 0.12);
    let pores = face * (0.0003 * noise(p * 130.0) + 0.0006 * beard(side, p));
    if let Some((on_lips, creases)) = lip(side, p) {
        return hairs + (pores * (1.0 - on_lips) + 0.0016 * on_lips * creases);
    }
    hairs + bare * (pores - 0.0035 * crease(side))
}

/// How deep the skin is folded over the upper lids.
fn crease(side: DVec3) -> f64 {
    let q = side - EYE;
    let u = q.x / EYE_HALF;
    if q.z < 0.0 || q.y < 0.0 || u.abs() > 1.25 {
        return 0.0;
    }
    bump((eye_opening(q) - 0.013) / 0.006) * step((1.25 - u.abs()) / 0.5)
}
