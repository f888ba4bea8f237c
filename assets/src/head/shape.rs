//! The shape of the head: a signed distance field of smoothly blended primitives.
//!
//! Lengths are in head heights: chin to crown is 1. The origin lies between the ears at the height of the
//! eyes, which are half-way up the head, so the crown is at y = ½ and the chin at y = −½; +z is where the face
//! looks, +x its left. The field is symmetric: every function takes a point with x ≥ 0 but [`head`].
//!
//! Proportions are a drawing school's: the head is about five eyes wide, the base of the nose is half-way from brow to
//! chin, the mouth a third of the way from there to the chin, the ears stand between brow and base of the nose.
//! How primitives are measured and blended: Quilez, "Distance functions" and "Smooth minimum".

use glam::{DVec2, DVec3};

/// Height of the brows.
pub const BROW: f64 = 0.095;
/// Height of the base of the nose: half-way from brow to chin.
pub const NOSE_BASE: f64 = -0.2;
/// Height of the line between the lips: a third of the way from the nose to the chin.
pub const MOUTH: f64 = -0.3;
/// Half the width of the mouth: it ends below the pupils' inner rims.
pub const MOUTH_HALF: f64 = 0.108;
/// The left eyeball's centre: one eye's width between the two eyes.
pub const EYE: DVec3 = DVec3::new(0.137, 0.0, 0.298);
/// Radius of an eyeball.
pub const EYE_RADIUS: f64 = 0.058;
/// Half the width of the opening between the lids.
pub const EYE_HALF: f64 = 0.064;
/// The plane that cuts the bust off.
pub const BASE: f64 = -0.95;

/// A point of three numbers.
const fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// The signed distance from the surface of the whole bust but the eyeballs, negative inside. It is a bound
/// close to the distance, not the distance itself: blending bends it.
#[must_use]
pub fn head(p: DVec3) -> f64 {
    body(p).max(BASE - p.y)
}

/// [`head`] without the cut at its base.
#[must_use]
pub fn body(p: DVec3) -> f64 {
    let p = at(p.x.abs(), p.y, p.z);
    // Parts out of reach of each other are not asked.
    let skin = if p.y < -0.62 { f64::INFINITY } else { skin(p) };
    let neck = if p.y > 0.1 { f64::INFINITY } else { neck(bent(p)) };
    let torso = if p.y > -0.35 { f64::INFINITY } else { torso(bent(p)) };
    let bare = union(union(skin, neck, 0.05), torso, 0.12);
    union(hair(p, bare), ear(p), 0.012)
}

/// Where the halves of a part meet, its mirror image must leave no crease: x turns back in a curve, not at once.
fn bent(p: DVec3) -> DVec3 {
    at((p.x * p.x + 4e-4).sqrt(), p.y, p.z)
}

/// Head without neck, ears and hair.
fn skin(p: DVec3) -> f64 {
    let mut d = face(bent(p));
    if p.z < 0.2 {
        return d;
    }
    d = union(d, nose(p), 0.055);
    d = cut(d, nostril(p), 0.008);
    d = eyelids(p, d);
    cut(union(d, lips(p), 0.016), mouth(p), 0.006)
}

/// Skull, jaw and cheeks, with hollows for the eyes.
fn face(p: DVec3) -> f64 {
    let skull = ellipsoid(p, at(0.0, 0.13, -0.055), at(0.32, 0.37, 0.385));
    let forehead = ellipsoid(p, at(0.0, 0.15, 0.16), at(0.235, 0.24, 0.245));
    let middle = ellipsoid(p, at(0.0, -0.13, 0.15), at(0.235, 0.33, 0.235));
    let mut d = union(union(skull, forehead, 0.1), middle, 0.1);
    // The jaw: from the joint below the ear to its angle, and along its edge to the chin.
    let angle = at(0.188, -0.295, 0.065);
    d = union(d, cone(p, at(0.21, -0.12, 0.02), 0.06, angle, 0.05), 0.16);
    d = union(d, cone(p, angle, 0.045, at(0.05, -0.435, 0.32), 0.05), 0.16);
    d = union(d, ellipsoid(p, at(0.0, -0.432, 0.34), at(0.085, 0.065, 0.066)), 0.09);
    // Cheekbone and its arch back to the ear; the cheek below.
    d = union(d, ellipsoid(p, at(0.165, -0.09, 0.245), at(0.085, 0.065, 0.09)), 0.09);
    d = union(d, cone(p, at(0.19, -0.075, 0.2), 0.045, at(0.27, -0.03, 0.02), 0.03), 0.1);
    d = union(d, ellipsoid(p, at(0.115, -0.22, 0.235), at(0.115, 0.14, 0.115)), 0.1);
    // What the lips lie on.
    d = union(d, ellipsoid(p, at(0.0, -0.285, 0.3), at(0.125, 0.1, 0.115)), 0.05);
    // The brow ridge, then the hollow under it.
    let ridge =
        [at(0.03, 0.075, 0.372), at(0.125, 0.093, 0.352), at(0.205, 0.065, 0.275), at(0.25, 0.0, 0.19)];
    d = union(d, chain(p, &ridge, &[0.035, 0.034, 0.028, 0.02]), 0.06);
    cut(d, ellipsoid(p, at(0.137, 0.005, 0.435), at(0.085, 0.052, 0.085)), 0.05)
}

/// Bridge, tip and wings of the nose.
fn nose(p: DVec3) -> f64 {
    let bridge = [at(0.0, 0.05, 0.365), at(0.0, -0.06, 0.41), at(0.0, -0.145, 0.468)];
    let mut d = chain(p, &bridge, &[0.03, 0.035, 0.038]);
    d = union(d, ellipsoid(p, at(0.0, -0.152, 0.476), at(0.037, 0.034, 0.038)), 0.03);
    d = union(d, ellipsoid(p, at(0.045, -0.17, 0.424), at(0.025, 0.026, 0.042)), 0.04);
    // What all of it stands on.
    d = union(d, cone(p, at(0.0, 0.0, 0.33), 0.045, at(0.0, -0.165, 0.39), 0.045), 0.03);
    // The bridge between the nostrils.
    union(d, cone(p, at(0.0, -0.174, 0.483), 0.013, at(0.0, -0.189, 0.43), 0.014), 0.02)
}

/// What is taken out of the nose.
#[must_use]
pub fn nostril(p: DVec3) -> f64 {
    cone(p, at(0.026, -0.205, 0.458), 0.012, at(0.03, -0.165, 0.436), 0.012)
}

/// Lids over the eyeballs, cut open, around a skin with hollows for the eyes.
fn eyelids(p: DVec3, skin: f64) -> f64 {
    let q = p - EYE;
    if q.length() > 0.2 {
        return skin;
    }
    // Wider than the ball, so that they are thick enough where they meet.
    let lids = union(skin, ellipsoid(q, DVec3::ZERO, at(0.077, 0.067, 0.067)), 0.03);
    // The opening ends on a floor, behind the eyeball's surface but wider than the ball: no pit in the corners.
    let floor = ellipsoid(q, DVec3::ZERO, at(0.07, 0.046, 0.046));
    cut(lids, eye_opening(q).max(-floor), 0.008)
}

/// The almond between the lids, a prism along z: negative inside. `q` is relative to the eye's centre.
#[must_use]
pub fn eye_opening(q: DVec3) -> f64 {
    let u = q.x / EYE_HALF;
    // The corners are rounded. The slope of the lids there would stretch the field; 0.8 keeps it a bound.
    let d = cut(q.y - upper_lid(u), q.y - lower_lid(u), 0.018) * 0.8;
    d.max(-q.z)
}

/// Height of the upper lid's edge over the eye's centre; `u` is −1 at the inner corner and 1 at the outer one.
/// It covers the top of the iris, and is highest a little inside of the middle.
#[must_use]
pub fn upper_lid(u: f64) -> f64 {
    0.0185 * (1.0 - u * u) * (1.0 - 0.15 * u) + corner(u)
}

/// Height of the lower lid's edge, which is lowest a little outside of the middle.
#[must_use]
pub fn lower_lid(u: f64) -> f64 {
    -0.02 * (1.0 - u * u) * (1.0 + 0.2 * u) + corner(u)
}

/// The outer corner stands a little higher than the inner one.
fn corner(u: f64) -> f64 {
    0.004 * u - 0.003
}

/// Upper and lower lip.
#[must_use]
pub fn lips(p: DVec3) -> f64 {
    if p.distance(at(0.0, MOUTH, 0.4)) > 0.3 {
        return 0.1;
    }
    // Rolls along curves: their height, and their thickness from the middle (t = 0) to the corner (t = 1).
    let t = (p.x / MOUTH_HALF).min(1.0);
    let rest = 1.0 - t * t;
    let bow = 1.0 / (1.0 + 40.0 * (t - 0.27) * (t - 0.27));
    let beyond = (p.x - MOUTH_HALF).max(0.0);
    let roll = |y: f64, r: f64| at(beyond, p.y - MOUTH - y, p.z - 0.412 + 0.062 * t * t).length() - r;
    let upper = roll(0.002 + 0.0095 * rest + 0.0045 * bow, 0.0045 + 0.0125 * rest);
    let lower = roll(0.002 - 0.029 * rest, 0.0045 + 0.018 * rest);
    // The curves' slope would stretch the field; 0.75 keeps it a bound.
    union(upper, lower, 0.006) * 0.75
}

/// Height of the line between the lips at a distance from the middle.
#[must_use]
pub fn mouth_line(x: f64) -> f64 {
    MOUTH - 0.004 + 0.4 * x * x
}

/// What is taken out between and behind the lips.
#[must_use]
pub fn mouth(p: DVec3) -> f64 {
    // A slit with pointed ends, and the room behind it.
    let across = 0.2 * (p.x - 0.03).max(0.0);
    let y = p.y - mouth_line(p.x);
    let deep = (p.z - 0.38).abs() - 0.06;
    let slit = DVec3::new(across, y, deep.max(0.0)).length() - 0.005;
    union(slit, ellipsoid(p, at(0.0, MOUTH - 0.012, 0.325), at(0.08, 0.04, 0.055)), 0.01)
}

/// An ear: a bent plate with a rim, a ridge inside the rim, a hollow and a lobe.
#[must_use]
pub fn ear(p: DVec3) -> f64 {
    let q = p - at(0.322, -0.045, -0.03);
    if q.length() > 0.3 {
        return q.length() - 0.2;
    }
    // In the plate's own frame: x to the front, y up, z outwards; it leans back and stands off the head.
    let (lean, off) = (DVec2::new(0.978, 0.208), DVec2::new(0.88, 0.475));
    let (y, z) = (q.y * lean.x - q.z * lean.y, q.z * lean.x + q.y * lean.y);
    let q = at(z * off.x - (-q.x) * off.y, y, q.x * off.x - z * off.y);
    let plate = ellipsoid(q, at(-0.02, 0.01, 0.0), at(0.07, 0.13, 0.022));
    let rim = [
        at(0.012, -0.01, 0.008),
        at(0.04, 0.045, 0.012),
        at(0.03, 0.11, 0.016),
        at(-0.015, 0.138, 0.018),
        at(-0.065, 0.115, 0.018),
        at(-0.088, 0.055, 0.018),
        at(-0.08, -0.015, 0.016),
        at(-0.05, -0.075, 0.014),
        at(-0.02, -0.115, 0.012),
    ];
    let mut d =
        union(plate, chain(q, &rim, &[0.007, 0.011, 0.013, 0.014, 0.014, 0.013, 0.012, 0.011, 0.014]), 0.012);
    // The hollow that leads inwards, and the groove under the rim.
    d = cut(d, ellipsoid(q, at(-0.003, -0.022, 0.022), at(0.034, 0.048, 0.034)), 0.012);
    let groove =
        [at(0.005, 0.088, 0.034), at(-0.035, 0.098, 0.036), at(-0.06, 0.05, 0.036), at(-0.057, -0.01, 0.036)];
    d = cut(d, chain(q, &groove, &[0.011, 0.015, 0.015, 0.008]), 0.012);
    let ridge =
        [at(-0.018, 0.06, 0.014), at(-0.035, 0.02, 0.018), at(-0.04, -0.035, 0.018), at(-0.02, -0.07, 0.016)];
    d = union(d, chain(q, &ridge, &[0.01, 0.011, 0.01, 0.009]), 0.012);
    // Lobe, and the flap in front of the hollow.
    d = union(d, ellipsoid(q, at(-0.004, -0.118, 0.008), at(0.03, 0.034, 0.015)), 0.02);
    union(d, ellipsoid(q, at(0.034, -0.025, 0.012), at(0.016, 0.026, 0.014)), 0.014)
}

/// The neck, with the muscles that run from behind the ears to the pit between the collarbones.
fn neck(p: DVec3) -> f64 {
    let column = cone(p, at(0.0, -0.25, -0.09), 0.185, at(0.0, -0.95, -0.15), 0.205);
    let muscle = cone(p, at(0.2, -0.2, -0.07), 0.04, at(0.035, -0.77, 0.045), 0.025);
    let larynx = ellipsoid(p, at(0.0, -0.62, 0.06), at(0.04, 0.06, 0.05));
    let nape = cone(p, at(0.07, -0.25, -0.27), 0.075, at(0.2, -0.75, -0.22), 0.1);
    union(union(union(column, muscle, 0.06), larynx, 0.08), nape, 0.1)
}

/// Shoulders, collarbones and the top of the chest.
fn torso(p: DVec3) -> f64 {
    let chest = ellipsoid(p, at(0.0, -1.11, -0.1), at(0.62, 0.36, 0.3));
    let shoulder = ellipsoid(p, at(0.57, -0.98, -0.14), at(0.165, 0.2, 0.18));
    let slope = cone(p, at(0.1, -0.65, -0.22), 0.1, at(0.52, -0.87, -0.16), 0.1);
    let collarbone = cone(p, at(0.05, -0.79, 0.06), 0.025, at(0.42, -0.755, -0.05), 0.025);
    union(union(union(chest, shoulder, 0.12), slope, 0.12), collarbone, 0.08)
}

/// Short hair: a coat on the skin above the hairline.
fn hair(p: DVec3, bare: f64) -> f64 {
    if bare > 0.15 || p.y < -0.5 {
        return bare;
    }
    // Thinner around the ear, so that the ear stands free.
    let ear = step((at(0.33, 0.0, -0.05).distance(p) - 0.08) / 0.15);
    bare - (0.012 + 0.024 * ear) * hairiness(p)
}

/// How far a point is inside the hairline: 0 on bare skin, 1 where the hair is full.
#[must_use]
pub fn hairiness(p: DVec3) -> f64 {
    step(above_hairline(p) / 0.2)
}

/// Height over the hairline, negative below it.
#[must_use]
pub fn above_hairline(p: DVec3) -> f64 {
    // Height of the hairline by the angle from the front, in degrees: brow, temple, sideburn, ear, nape.
    const LINE: [(f64, f64); 10] = [
        (0.0, 0.3),
        (20.0, 0.31),
        (38.0, 0.27),
        (52.0, 0.19),
        (66.0, 0.08),
        (76.0, -0.05),
        (88.0, -0.06),
        (104.0, -0.1),
        (130.0, -0.3),
        (180.0, -0.34),
    ];
    let angle = libm::atan2(p.x.abs(), p.z + 0.02).to_degrees();
    let next = LINE.iter().position(|&(a, _)| a >= angle).unwrap_or(LINE.len() - 1).max(1);
    let ((a, low), (b, high)) = (LINE[next - 1], LINE[next]);
    p.y - (low + (high - low) * (angle - a) / (b - a))
}

/// 0 up to 0, 1 from 1 on, smooth between.
#[must_use]
pub fn step(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Both bodies; where they meet, rounded over a width of `k`.
fn union(a: f64, b: f64, k: f64) -> f64 {
    let near = k - (a - b).abs();
    if near > 0.0 { a.min(b) - near * near / (4.0 * k) } else { a.min(b) }
}

/// The first body without the second one, the edge rounded over a width of `k`.
fn cut(a: f64, b: f64, k: f64) -> f64 {
    -union(-a, b, k)
}

/// An ellipsoid; a bound that is exact at its surface.
fn ellipsoid(p: DVec3, center: DVec3, radii: DVec3) -> f64 {
    let q = (p - center) / radii;
    let slope = (q / radii).length();
    if slope == 0.0 { -radii.min_element() } else { q.length() * (q.length() - 1.0) / slope }
}

/// The balls of radii from `r` to `s` along the segment from `a` to `b`.
fn cone(p: DVec3, a: DVec3, r: f64, b: DVec3, s: f64) -> f64 {
    let (q, along) = (p - a, b - a);
    let t = (q.dot(along) / along.length_squared()).clamp(0.0, 1.0);
    (q - along * t).length() - (r + (s - r) * t)
}

/// Cones from point to point.
fn chain(p: DVec3, points: &[DVec3], radii: &[f64]) -> f64 {
    let parts = (1..points.len()).map(|n| cone(p, points[n - 1], radii[n - 1], points[n], radii[n]));
    parts.fold(f64::INFINITY, f64::min)
}
