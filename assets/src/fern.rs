//! A fern's frond as a cut-out: leaflets on leaflets on a stem, painted by formula.
//!
//! Alpha is straight: a texel has the colour of the leaf in it, and as alpha the share of it that the leaf covers. Where there
//! is no leaf, alpha is 0 and the colour black, as most files have it.

use std::f64::consts::PI;

use common::{Color, Format, Image};
use glam::{DVec2, DVec3};

/// Samples along a side of a texel.
const SAMPLES: usize = 8;
/// Leaflets along either side of the stem.
const PINNAE: usize = 14;

/// The frond as a square picture of `size` texels, its stem's foot at the bottom.
#[must_use]
pub fn frond(size: u16) -> Image {
    let mut canvas = Canvas::new(usize::from(size) * SAMPLES);
    for n in 0..PINNAE {
        let t = 0.13 + 0.83 * n as f64 / PINNAE as f64;
        // They stand in turn, a little higher on the left.
        canvas.pinna(t, -1.0, n);
        canvas.pinna(t + 0.012, 1.0, n);
    }
    canvas.stroke(stem, 0.0095, DVec3::new(0.55, 0.48, 0.22));
    canvas.image(size)
}

/// The stem's place at t, from 0 at its foot to 1 at the tip.
fn stem(t: f64) -> DVec2 {
    DVec2::new(0.5 + 0.035 * libm::sin(PI * (1.4 * t - 0.2)) - 0.012, 0.012 + 0.965 * t)
}

/// How long the leaflet at t is: longest a third of the way up.
fn length(t: f64) -> f64 {
    0.56 * (1.0 - t) * (0.5 + 1.9 * t).min(1.0) + 0.02
}

/// Turned counterclockwise.
fn turned(direction: DVec2, degrees: f64) -> DVec2 {
    let angle = degrees * PI / 180.0;
    DVec2::new(libm::cos(angle), libm::sin(angle)).rotate(direction)
}

/// Samples of the picture, in rows from the bottom: the colour of the leaf, each channel from 0 to 1, if there is any.
struct Canvas {
    side: usize,
    samples: Vec<Option<DVec3>>,
}

impl Canvas {
    fn new(side: usize) -> Self {
        Self { side, samples: vec![None; side * side] }
    }

    /// Paints the samples within a distance of a point; `color` of a place gives `None` where nothing is.
    fn paint(&mut self, center: DVec2, reach: f64, color: impl Fn(DVec2) -> Option<DVec3>) {
        let side = self.side as f64;
        let range = |middle: f64| {
            let end = |place: f64| (place * side).clamp(0.0, side) as usize;
            end(middle - reach)..end(middle + reach)
        };
        for y in range(center.y) {
            for x in range(center.x) {
                if let Some(color) = color((DVec2::new(x as f64, y as f64) + 0.5) / side) {
                    self.samples[y * self.side + x] = Some(color);
                }
            }
        }
    }

    /// A leaflet of the first order, on the stem at t, to the left (−1) or to the right (1).
    fn pinna(&mut self, t: f64, hand: f64, number: usize) {
        let up = (stem(t + 0.01) - stem(t - 0.01)).normalize();
        let out = turned(up, -hand * (76.0 - 34.0 * t));
        let (foot, length) = (stem(t), length(t));
        let place = |s: f64| foot + length * s * (out + 0.22 * s * up);
        let count = (length / 0.0165) as usize + 3;
        for n in 0..count {
            let s = (n as f64 + 0.6) / count as f64;
            let along = (place(s + 0.01) - place(s - 0.01)).normalize();
            let size = (0.0215 + 0.036 * length) * (1.0 - 0.62 * s * s) * (0.75 + 0.25 * (6.0 * s).min(1.0));
            let tone =
                f64::from(Color::random((1000 * number + 2 * n) as u64 + u64::from(hand > 0.0)).r) / 255.0;
            for side in [-1.0, 1.0] {
                let blade = turned(along, side * 62.0) * size;
                self.blade(place(s), blade, leaf_green(0.55 * t + 0.45 * s, tone));
            }
        }
        let tip = (place(1.0) - place(0.96)).normalize() * 0.016;
        self.blade(place(0.97), tip, leaf_green(0.55 * t + 0.45, 0.5));
        self.stroke(place, 0.0032 + 0.002 * length, DVec3::new(0.62, 0.66, 0.26));
    }

    /// A pointed leaflet from its foot to its tip, with a bright rib, one half in light and one in shade.
    fn blade(&mut self, foot: DVec2, to_tip: DVec2, color: DVec3) {
        let length = to_tip.length();
        self.paint(foot + to_tip / 2.0, 0.7 * length, |place| {
            let place = place - foot;
            let along = place.dot(to_tip) / (length * length);
            let across = to_tip.perp_dot(place) / (length * length);
            let half_width = 0.7 * along.max(0.0).sqrt() * (1.0 - along);
            (across.abs() < half_width).then(|| {
                let rib = (1.0 - across.abs() / 0.07).max(0.0) * (1.0 - along);
                let half = if across * to_tip.x > 0.0 { 1.12 } else { 0.9 };
                color * half * (0.8 + 0.3 * along) + rib * DVec3::new(0.22, 0.24, 0.08)
            })
        });
    }

    /// A round line along a curve from t = 0 to 1, from a radius down to a quarter of it.
    fn stroke(&mut self, curve: impl Fn(f64) -> DVec2, radius: f64, color: DVec3) {
        for n in 0..=400 {
            let t = f64::from(n) / 400.0;
            let (center, radius) = (curve(t), radius * (1.0 - 0.75 * t));
            self.paint(center, radius, |place| {
                let from = (place - center) / radius;
                (from.length_squared() < 1.0).then(|| color * (0.92 - 0.28 * from.x + 0.12 * from.y))
            });
        }
    }

    /// Each texel the mean of its samples that are painted, and their share as its alpha.
    fn image(&self, size: u16) -> Image {
        let mut image = Image::new(size, size, Format::Rgba);
        for (x, y) in (0..usize::from(size)).flat_map(|y| (0..usize::from(size)).map(move |x| (x, y))) {
            let row = |j: usize| &self.samples[(y * SAMPLES + j) * self.side + x * SAMPLES..][..SAMPLES];
            let painted: Vec<DVec3> = (0..SAMPLES).flat_map(|j| row(j).iter().flatten().copied()).collect();
            let count = painted.len();
            if count > 0 {
                let mean = painted.into_iter().sum::<DVec3>() / count as f64;
                let [r, g, b] = mean.to_array().map(|level| (level * 255.0).round() as u8);
                let a = (count as f64 * 255.0 / (SAMPLES * SAMPLES) as f64).round() as u8;
                image.set(x as i32, y as i32, Color { r, g, b, a });
            }
        }
        image
    }
}

/// From the deep green of old leaves, at 0, to the yellow one of young tips, at 1; `tone` from 0 to 1 varies it.
fn leaf_green(age: f64, tone: f64) -> DVec3 {
    let (old, young) = (DVec3::new(0.20, 0.47, 0.15), DVec3::new(0.66, 0.82, 0.24));
    old.lerp(young, age.clamp(0.0, 1.0)) * (0.88 + 0.24 * tone)
}
