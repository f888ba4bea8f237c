//! Lights as shaders take them: what is the same at all points is computed once a frame.

use common::Vec3;
use lighting::normalisation::{Exact, Normalisation};
use lighting::power::{Power, Squaring};
use lighting::reflection::{Halfway, Highlight, Mirrored, PointLit, Reflection};
use lighting::{PointLight, Reflected};

/// Powers by squaring, which are the same on every platform; an exponent is rounded to a whole one. What is below 1/1024, and
/// so at most a quarter of a level of white, is 0 and not computed: of a highlight, nearly all.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    power: Squaring,
    /// From here on powers are 1/1024 or more.
    least: f32,
}

// ANCHOR: seen
impl Power for Seen {
    fn new(exponent: f32) -> Self {
        Self { power: Squaring::new(exponent), least: libm::exp2f(-10.0 / exponent.round()) }
    }

    #[inline]
    fn of(&self, x: f32) -> f32 {
        if x >= self.least { self.power.of(x) } else { 0.0 }
    }

    #[inline]
    fn least(&self) -> f32 {
        self.least
    }
}
// ANCHOR_END: seen

/// A light with one of the two highlights.
type Lamp<H> = PointLit<H, Exact, Seen>;

/// A scene's lights, by Phong's model and by Blinn's.
#[derive(Default)]
pub struct Lamps {
    phong: Vec<Lamp<Mirrored>>,
    blinn: Vec<Lamp<Halfway>>,
}

impl Lamps {
    /// Makes them of these lights.
    pub fn set(&mut self, lights: &[PointLight]) {
        self.phong.clear();
        self.phong.extend(lights.iter().map(PointLit::new));
        self.blinn.clear();
        self.blinn.extend(lights.iter().map(PointLit::new));
    }

    /// What all of them together make a point with this normal, which need not be 1 long, send to the eye, by Phong's model.
    #[inline]
    #[must_use]
    pub fn phong(&self, point: Vec3, normal: Vec3, eye: Vec3) -> Reflected {
        reflected(&self.phong, point, normal, eye)
    }

    /// The same by Blinn's.
    #[inline(always)]
    #[must_use]
    pub fn blinn(&self, point: Vec3, normal: Vec3, eye: Vec3) -> Reflected {
        reflected(&self.blinn, point, normal, eye)
    }
}

// ANCHOR: reflected
#[inline(always)]
fn reflected<H: Highlight>(lamps: &[Lamp<H>], point: Vec3, normal: Vec3, eye: Vec3) -> Reflected {
    let (n, v) = (Exact::normal(normal), Exact::direction(eye - point));
    let mut sum = Reflected { body: 0.0, highlight: 0.0 };
    for lamp in lamps {
        let Reflected { body, highlight } = lamp.reflect_to(point, n, || v);
        sum = Reflected { body: sum.body + body, highlight: sum.highlight + highlight };
    }
    sum
}
// ANCHOR_END: reflected

#[cfg(test)]
mod tests {
    use super::*;

    /// What is left out is less than 1/1024, and nothing else is changed, whatever the exponent.
    #[test]
    fn what_is_left_out_is_not_seen() {
        for exponent in [0.0, 0.4, 1.0, 2.0, 7.0, 32.0, 33.0, 64.0, 1000.0, 10_000.0] {
            let (seen, all) = (Seen::new(exponent), Squaring::new(exponent));
            let mut left_out = 0;
            for x in (0..=100_000).map(|n| n as f32 / 100_000.0) {
                let (power, exact) = (seen.of(x), all.of(x));
                left_out += usize::from(power != exact);
                assert!(power == exact || (power == 0.0 && exact < 1.001 / 1024.0), "{exponent}, {x}");
            }
            assert_eq!(left_out > 0, exponent >= 1.0, "{exponent}");
        }
    }

    /// Where squares tell that a highlight is not seen it is not seen indeed, and whatever is seen stays as it is.
    #[test]
    fn no_highlight_is_lost_for_want_of_a_root() {
        // Directions all over the sphere, no two alike.
        let direction = |n: f32, steps: [f32; 3]| {
            Exact::direction(Vec3::from_array(steps.map(|step| (n * step).fract() - 0.5)))
        };
        for exponent in [0.0, 1.0, 2.0, 7.0, 64.0, 1000.0] {
            let seen = Seen::new(exponent);
            let (mut told, mut bright) = (0, 0);
            for n in (0..30_000).map(|n| n as f32) {
                let [normal, l, v] = [[0.618, 0.755, 0.570], [0.414, 0.236, 0.317], [0.732, 0.646, 0.873]]
                    .map(|steps| direction(n, steps));
                let cosine =
                    |least| Halfway::cosine::<Exact>(normal, l, v, normal.dot(l), least).clamp(0.0, 1.0);
                let (quick, exact) = (cosine(seen.least()), cosine(0.0));
                assert_eq!(seen.of(quick), seen.of(exact), "{exponent}, {normal}, {l}, {v}");
                told += usize::from(quick != exact);
                bright += usize::from(seen.of(exact) > 0.0);
            }
            assert!(bright > 0 && (told > 0) == (exponent >= 1.0), "{exponent}: {told}, {bright}");
        }
    }
}
