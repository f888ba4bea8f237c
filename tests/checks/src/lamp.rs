//! What a surface shows under a lamp, in `f64`: on an ellipsoid by its equation, and on triangles with normals at their
//! corners, a ray at a time.
//!
//! The eye may be anywhere; rays go from it in directions whose z is −1, as [`Screen`](crate::ray::Screen) gives them.

use common::DVec3;

use crate::ray;

/// A lamp, and how a surface shines under it.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// Where it is.
    pub position: DVec3,
    /// What of the surface's colour is seen without it.
    pub ambient: f64,
    /// What is seen more of it where light falls straight on it.
    pub diffuse: f64,
    /// What is added of white in the middle of a highlight.
    pub specular: f64,
    /// The highlight's exponent.
    pub shininess: f64,
    /// What power of 1/distance its light goes by.
    pub fading: i32,
}

/// What the exponent is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Highlight {
    /// The cosine between the mirrored light and the eye.
    Mirrored,
    /// The cosine between the normal and the direction half-way from light to eye.
    Halfway,
}

/// v made 1 long, or 0 if it is.
fn unit(v: DVec3) -> DVec3 {
    let length = v.length();
    if length > 0.0 { v / length } else { DVec3::ZERO }
}

impl Lamp {
    /// The shares of the surface's colour and of white that are seen of a point. A normal that is 0, and a lamp at the point
    /// itself, leave what is seen without it.
    ///
    /// It is the eye that is mirrored here, not the light; and the way half-way is not made 1 long, but |l + v|² is 2 + 2 l·v.
    #[must_use]
    pub fn on(&self, point: DVec3, normal: DVec3, eye: DVec3, highlight: Highlight) -> [f64; 2] {
        let (n, l, v) = (unit(normal), unit(self.position - point), unit(eye - point));
        let (facing, seen) = (n.dot(l), n.dot(v));
        if facing <= 0.0 {
            return [self.ambient, 0.0];
        }
        let cosine = match highlight {
            Highlight::Mirrored => 2.0 * facing * seen - l.dot(v),
            Highlight::Halfway if l == -v => 0.0,
            Highlight::Halfway => (facing + seen) / (2.0 + 2.0 * l.dot(v)).sqrt(),
        };
        let left = (self.position - point).length().powi(-self.fading);
        let shine = cosine.clamp(0.0, 1.0).powf(self.shininess);
        [self.ambient + self.diffuse * left * facing, self.specular * left * shine]
    }
}

/// How bright that is in one channel of a surface that has `base` of it, from 0 to 255, not rounded.
#[must_use]
pub fn level(base: f64, [body, highlight]: [f64; 2]) -> f64 {
    (base * body + 255.0 * highlight).min(255.0)
}

/// An ellipsoid about the origin along the axes, with these half-axes.
#[derive(Clone, Copy, Debug)]
pub struct Ellipsoid(pub DVec3);

impl Ellipsoid {
    /// The first point of it on a ray.
    #[must_use]
    pub fn hit(&self, eye: DVec3, direction: DVec3) -> Option<DVec3> {
        // A sphere of radius 1, if space is stretched: |e + t·d|² = 1.
        let (e, d) = (eye / self.0, direction / self.0);
        let [a, b, c] = [d.dot(d), e.dot(d), e.dot(e) - 1.0];
        let root = (b * b - a * c).sqrt();
        let t = (-b - root) / a;
        (t > 0.0).then(|| eye + t * direction)
    }

    /// The normal at a point of it, of some length: the gradient of x²/a² + y²/b² + z²/c².
    #[must_use]
    pub fn normal(&self, point: DVec3) -> DVec3 {
        point / (self.0 * self.0)
    }
}

/// A triangle with a normal at each corner.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// Its corners.
    pub corners: [DVec3; 3],
    /// The normals there.
    pub normals: [DVec3; 3],
}

impl Face {
    /// The point of it on a ray, and the normal there, interpolated; how far away it is comes first.
    #[must_use]
    pub fn hit(&self, eye: DVec3, direction: DVec3) -> Option<(f64, DVec3, DVec3)> {
        let met = ray::hit(self.corners.map(|corner| corner - eye), direction);
        let mean = |of: [DVec3; 3]| of[0] * met.weights.x + of[1] * met.weights.y + of[2] * met.weights.z;
        let inside = met.depth > 0.0 && met.weights.min_element() >= 0.0;
        inside.then(|| (met.depth, mean(self.corners), mean(self.normals)))
    }
}

/// The exponent of n·h that makes a highlight most like that of r·v with this exponent, and the largest difference between the
/// two that is left. Light and eye are `apart` radians apart, seen from the surface, and normals tilt in their plane, or `across`
/// it.
///
/// With t the tilt and a = apart/2, n·h is cos t either way; r·v is cos 2t in the plane, and 1 − 2 cos² a sin² t across it.
#[must_use]
pub fn alike(exponent: f64, apart: f64, across: bool) -> [f64; 2] {
    const STEPS: i32 = 500;
    let mirrored =
        |t: f64| if across { 1.0 - 2.0 * ((apart / 2.0).cos() * t.sin()).powi(2) } else { (2.0 * t).cos() };
    // A highlight is as wide as 1/√E, and ends where the mirrored light is seen at a right angle in the plane.
    let last = std::f64::consts::FRAC_PI_4.min(4.0 / exponent.sqrt());
    let tilts = (0..=STEPS).map(|n| last * f64::from(n) / f64::from(STEPS));
    let curve: Vec<[f64; 2]> = tilts.map(|t| [mirrored(t).max(0.0).powf(exponent), t.cos()]).collect();
    let difference = |other: f64| curve.iter().map(|[r, h]| (r - h.powf(other)).abs()).fold(0.0, f64::max);
    // The difference falls to one least value and rises again: by thirds.
    let (mut low, mut high) = (exponent / 2.0, exponent * 8.0 + 8.0);
    while high - low > 1e-6 * high {
        let third = (high - low) / 3.0;
        if difference(low + third) < difference(high - third) { high -= third } else { low += third }
    }
    let best = low.midpoint(high);
    [best, difference(best)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAMP: Lamp = Lamp {
        position: DVec3::new(0.0, 0.0, 2.0),
        ambient: 0.25,
        diffuse: 0.5,
        specular: 0.125,
        shininess: 2.0,
        fading: 0,
    };

    /// Straight ahead both are 1; with the eye 60° aside the mirrored light is 60° off, and the way half-way 30°.
    #[test]
    fn the_angles_of_a_plane() {
        let (eye, aside) = (DVec3::Z, DVec3::new(3f64.sqrt(), 0.0, 1.0));
        for (highlight, square) in [(Highlight::Mirrored, 0.25), (Highlight::Halfway, 0.75)] {
            let straight = LAMP.on(DVec3::ZERO, 3.0 * DVec3::Z, eye, highlight);
            assert_eq!(straight, [0.75, 0.125]);
            let [body, shine] = LAMP.on(DVec3::ZERO, DVec3::Z, aside, highlight);
            assert!(body == 0.75 && (shine - 0.125 * square).abs() < 1e-15, "{highlight:?}: {shine}");
            let fading = Lamp { fading: 2, ..LAMP };
            assert_eq!(fading.on(DVec3::ZERO, DVec3::Z, eye, highlight), [0.375, 0.03125]);
            assert_eq!(LAMP.on(DVec3::ZERO, DVec3::NEG_Z, eye, highlight), [0.25, 0.0]);
            assert_eq!(LAMP.on(LAMP.position, DVec3::Z, eye, highlight), [0.25, 0.0]);
            assert_eq!(LAMP.on(DVec3::ZERO, DVec3::ZERO, eye, highlight), [0.25, 0.0]);
        }
        assert_eq!(level(100.0, [0.5, 0.25]), 113.75);
        assert_eq!(level(100.0, [9.0, 9.0]), 255.0);
    }

    #[test]
    fn a_ray_meets_the_near_side() {
        let egg = Ellipsoid(DVec3::new(1.0, 2.0, 0.5));
        let met = egg.hit(DVec3::new(0.0, 0.0, 3.0), DVec3::NEG_Z).unwrap();
        assert_eq!((met, egg.normal(met)), (DVec3::Z / 2.0, DVec3::Z * 2.0));
        assert_eq!(egg.hit(DVec3::new(1.5, 0.0, 3.0), DVec3::NEG_Z), None);
        // The tangent plane leaves the ellipsoid on one side.
        let met = egg.hit(DVec3::new(0.1, 0.2, 3.0), DVec3::new(0.1, 0.2, -1.0)).unwrap();
        for step in [DVec3::X, DVec3::Y] {
            let tangent =
                step - egg.normal(met) * step.dot(egg.normal(met)) / egg.normal(met).length_squared();
            let aside = (met + 1e-4 * tangent) / egg.0;
            assert!((aside.length() - 1.0).abs() < 1e-7);
        }
        let face =
            Face { corners: [DVec3::ZERO, DVec3::X, DVec3::Y], normals: [DVec3::Z, DVec3::X, DVec3::Y] };
        let (depth, point, normal) = face.hit(DVec3::new(0.25, 0.5, 4.0), DVec3::NEG_Z).unwrap();
        assert_eq!((depth, point, normal), (4.0, DVec3::new(0.25, 0.5, 0.0), DVec3::new(0.25, 0.5, 0.25)));
        assert!(face.hit(DVec3::new(0.75, 0.5, 4.0), DVec3::NEG_Z).is_none());
    }
}
