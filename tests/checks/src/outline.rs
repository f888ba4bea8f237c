//! The outline of a sphere in a picture, in `f64`: an ellipse.
//!
//! A plane touches the unit sphere where its four numbers (n, d) satisfy n·n = d²: where the product ⟨p, q⟩ = p.xyz·q.xyz − p.w·q.w
//! of it with itself is 0. A line in the picture is what is seen of a plane through the eye, a sum of the rows of the matrix that
//! brings points to the picture. So a line touches the outline where that sum's product with itself is 0, whatever the matrix does
//! to the sphere before (R. Hartley and A. Zisserman, *Multiple View Geometry in Computer Vision*, 2nd edition, 2004, 8.3).

use std::f64::consts::TAU;

use common::{DVec2, DVec4};

/// An ellipse in the window, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Its middle.
    pub center: DVec2,
    /// The square of its reach from there in a direction n is n·(`spread`·n): the entries xx, xy, yy.
    spread: [f64; 3],
}

impl Ellipse {
    /// What is seen of the unit sphere under a matrix, of which these are the rows of x, y and w, from its space to clip space, in
    /// a picture of that size. `None` where it reaches the depth of the eye or is behind it, or is not finite.
    #[must_use]
    pub fn of([x, y, w]: [DVec4; 3], size: DVec2) -> Option<Self> {
        let [x, y] = [(x + w) * (size.x / 2.0), (y + w) * (size.y / 2.0)];
        let product = |p: DVec4, q: DVec4| p.truncate().dot(q.truncate()) - p.w * q.w;
        let k = product(w, w);
        if !(w.w > 0.0 && k < 0.0) {
            return None;
        }
        // The line n·p = h touches where k·h² − 2·(b·n)·h + n·(A·n) = 0.
        let b = DVec2::new(product(x, w), product(y, w));
        let entry = |b: f64, a: f64| (b - k * a) / (k * k);
        let spread = [
            entry(b.x * b.x, product(x, x)),
            entry(b.x * b.y, product(x, y)),
            entry(b.y * b.y, product(y, y)),
        ];
        let ellipse = Self { center: b / k, spread };
        (ellipse.center.is_finite() && spread.iter().all(|entry| entry.is_finite())).then_some(ellipse)
    }

    /// How far it reaches in a direction of length 1: all its points p have n·p of at most this.
    #[must_use]
    pub fn reach(&self, n: DVec2) -> f64 {
        let [xx, xy, yy] = self.spread;
        self.center.dot(n) + (xx * n.x * n.x + 2.0 * xy * n.x * n.y + yy * n.y * n.y).max(0.0).sqrt()
    }

    /// The point that is farthest in a direction.
    #[must_use]
    pub fn point(&self, n: DVec2) -> DVec2 {
        let [xx, xy, yy] = self.spread;
        let along = DVec2::new(xx * n.x + xy * n.y, xy * n.x + yy * n.y);
        let length = along.dot(n).sqrt();
        self.center + if length > 0.0 { along / length } else { DVec2::ZERO }
    }

    /// Its area, in pixels.
    #[must_use]
    pub fn area(&self) -> f64 {
        let [xx, xy, yy] = self.spread;
        TAU / 2.0 * (xx * yy - xy * xy).sqrt()
    }

    /// Whether a point is within it.
    #[must_use]
    pub fn contains(&self, p: DVec2) -> bool {
        let [xx, xy, yy] = self.spread;
        let DVec2 { x, y } = p - self.center;
        yy * x * x - 2.0 * xy * x * y + xx * y * y < xx * yy - xy * xy
    }

    /// How far a point is from the outline: positive outside, negative inside. It is the largest n·p less the reach along n, in
    /// whatever direction n.
    #[must_use]
    pub fn distance(&self, p: DVec2) -> f64 {
        let beyond = |angle: f64| p.dot(DVec2::from_angle(angle)) - self.reach(DVec2::from_angle(angle));
        const STEPS: i32 = 180;
        let step = TAU / f64::from(STEPS);
        let best = (0..STEPS).map(|n| f64::from(n) * step).max_by(|&a, &b| beyond(a).total_cmp(&beyond(b)));
        let [mut low, mut high] = [-step, step].map(|side| best.unwrap_or(0.0) + side);
        for _ in 0..60 {
            let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if beyond(a) < beyond(b) { low = a } else { high = b }
        }
        beyond(low.midpoint(high))
    }

    /// How far, at most, a convex polygon within the ellipse is from its outline: beyond each side the ellipse reaches farthest
    /// where its tangent is parallel.
    #[must_use]
    pub fn beyond(&self, polygon: &[DVec2]) -> f64 {
        let sides = (0..polygon.len()).map(|n| [polygon[n], polygon[(n + 1) % polygon.len()]]);
        let gap = |[from, to]: [DVec2; 2]| {
            let n = -(to - from).perp().normalize();
            self.reach(n) - n.dot(from)
        };
        sides.map(gap).fold(0.0, f64::max)
    }
}

/// The convex hull of points, counterclockwise (A. Andrew, *Another efficient algorithm for convex hulls in two dimensions*, 1979).
#[must_use]
pub fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let chain = |points: &mut dyn Iterator<Item = &DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for &p in points {
            while let [.., a, b] = chain[..]
                && (b - a).perp_dot(p - a) <= 0.0
            {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let lower = chain(&mut points.iter());
    [lower, chain(&mut points.iter().rev())].concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::DVec3;

    /// A camera at the origin that looks along −z, with x and y enlarged so, before a sphere at `center` that is stretched so.
    fn rows(enlarged: DVec2, center: DVec3, radii: DVec3) -> [DVec4; 3] {
        [
            DVec4::new(enlarged.x * radii.x, 0.0, 0.0, enlarged.x * center.x),
            DVec4::new(0.0, enlarged.y * radii.y, 0.0, enlarged.y * center.y),
            DVec4::new(0.0, 0.0, -radii.z, -center.z),
        ]
    }

    const SIZE: DVec2 = DVec2::new(200.0, 100.0);

    /// Straight ahead: a circle of radius r/√(d² − r²).
    #[test]
    fn ahead_it_is_a_circle() {
        let ellipse =
            Ellipse::of(rows(DVec2::new(0.5, 1.0), DVec3::new(0.0, 0.0, -5.0), DVec3::splat(3.0)), SIZE)
                .unwrap();
        // 3/4 of half of 100 px, up and, half as much enlarged in a picture twice as wide, to the right.
        assert_eq!(ellipse.center, DVec2::new(100.0, 50.0));
        assert!((ellipse.area() - TAU / 2.0 * 37.5 * 37.5).abs() < 1e-9);
        for angle in [0.0, 0.3, 2.0, 4.5] {
            let n = DVec2::from_angle(angle);
            assert!((ellipse.reach(n) - n.dot(ellipse.center) - 37.5).abs() < 1e-12);
            assert!((ellipse.distance(ellipse.center + 40.0 * n) - 2.5).abs() < 1e-9);
            assert!(
                ellipse.contains(ellipse.center + 37.49 * n) && !ellipse.contains(ellipse.center + 37.51 * n)
            );
            assert!((ellipse.distance(ellipse.center + 30.0 * n) + 7.5).abs() < 1e-9);
        }
    }

    /// Anywhere: a ray from the eye through a point of the outline touches the sphere, by the quadratic equation along it.
    #[test]
    fn rays_through_the_outline_touch_the_sphere() {
        let enlarged = DVec2::new(1.3, 2.6);
        for (center, radii) in [
            (DVec3::new(1.0, -0.5, -4.0), DVec3::splat(1.5)),
            (DVec3::new(-3.0, 2.0, -2.0), DVec3::new(0.5, 2.0, 1.0)),
            (DVec3::new(0.1, 0.0, -2.0), DVec3::new(3.0, 0.01, 1.9)),
        ] {
            let ellipse = Ellipse::of(rows(enlarged, center, radii), SIZE).unwrap();
            for n in (0..24).map(|n| DVec2::from_angle(f64::from(n) / 4.0)) {
                let p = ellipse.point(n);
                assert!((ellipse.reach(n) - n.dot(p)).abs() < 1e-9, "{n}");
                assert!(ellipse.distance(p).abs() < 1e-6, "{n}: {}", ellipse.distance(p));
                let [within, beyond] = [0.999, 1.001].map(|share| ellipse.center.lerp(p, share));
                assert!(ellipse.contains(within) && !ellipse.contains(beyond), "{n}");
                let ray = ((p / SIZE * 2.0 - 1.0) / enlarged).extend(-1.0) / radii;
                let from = -center / radii;
                // |from + t·ray|² = 1 has one solution.
                let [a, b, c] = [ray.dot(ray), from.dot(ray), from.dot(from) - 1.0];
                assert!((b * b / (a * c) - 1.0).abs() < 1e-9, "{center}, {n}: {}", b * b / (a * c));
            }
        }
    }

    #[test]
    fn what_reaches_the_eye_has_no_outline() {
        for z in [3.0, 0.0, -0.9, -1.0] {
            assert_eq!(Ellipse::of(rows(DVec2::ONE, DVec3::new(4.0, 0.0, z), DVec3::ONE), SIZE), None);
        }
        assert_eq!(Ellipse::of(rows(DVec2::ONE, DVec3::new(f64::NAN, 0.0, -3.0), DVec3::ONE), SIZE), None);
    }

    /// A regular polygon in a circle of radius 50 is off by 50·(1 − cos(π/n)).
    #[test]
    fn a_polygon_is_off_by_the_height_of_its_segments() {
        let circle = Ellipse { center: DVec2::new(9.0, 8.0), spread: [2500.0, 0.0, 2500.0] };
        for n in [3, 4, 7, 100] {
            let corner =
                |m: i32| circle.point(DVec2::from_angle(TAU * f64::from(m * 3 % n) / f64::from(n) + 0.1));
            let mut points: Vec<DVec2> = (0..n).map(corner).chain([circle.center]).collect();
            if n % 3 == 0 {
                points.extend(
                    (0..n).map(|m| circle.point(DVec2::from_angle(TAU * f64::from(m) / f64::from(n) + 0.1))),
                );
            }
            let polygon = hull(points);
            let expected = 50.0 * (1.0 - (TAU / 2.0 / f64::from(n)).cos());
            assert!((circle.beyond(&polygon) - expected).abs() < 1e-9, "{n}: {}", circle.beyond(&polygon));
        }
    }
}
