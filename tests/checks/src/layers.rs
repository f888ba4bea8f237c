//! The transparent layers of a pixel, one by one, in `f64` and in whole numbers.
//!
//! What is seen is a sum: each layer adds its colour times its alpha times the shares that all nearer ones let through.

use common::{Color, Vec3};

use crate::visibility::depth_at;

/// A triangle: x and y in px, z the depth, smaller is nearer; and its colour, whose alpha is straight.
pub type Pane = ([Vec3; 3], Color);

/// What is in a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Pixel {
    /// The opaque colour behind all layers.
    pub below: Color,
    /// The depth and the colour of each layer before it, the farthest first; of equals the first drawn.
    pub layers: Vec<(f64, Color)>,
    /// The smallest difference of two depths, that of the opaque surface counted and those of layers behind it; ∞ with one.
    pub gap: f64,
}

/// What is at the pixel (x, y): on a background at depth 1, the opaque triangles, of which the nearest is seen and the first of
/// equals, and the transparent ones that are nearer. A triangle's colour counts as opaque or not by where it stands, not by
/// its alpha.
#[must_use]
pub fn at(background: Color, opaque: &[Pane], transparent: &[Pane], x: i32, y: i32) -> Pixel {
    let depths = |panes: &[Pane]| -> Vec<(f64, Color)> {
        panes.iter().filter_map(|(corners, color)| Some((depth_at(corners, x, y)?, *color))).collect()
    };
    let (mut limit, mut below) = (1.0, background);
    let mut all = vec![limit];
    for (depth, color) in depths(opaque) {
        all.push(depth);
        if depth < limit {
            (limit, below) = (depth, color);
        }
    }
    let mut layers = depths(transparent);
    all.extend(layers.iter().map(|(depth, _)| depth));
    all.sort_by(f64::total_cmp);
    let gap = all.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    layers.retain(|(depth, _)| *depth < limit);
    // A stable sort: equals stay in the order in which they came.
    layers.sort_by(|a, b| b.0.total_cmp(&a.0));
    Pixel { below, layers, gap }
}

fn channels(Color { r, g, b, a }: Color) -> ([f64; 4], f64) {
    // What a layer adds to alpha is its alpha, as if its channel were full.
    ([f64::from(r), f64::from(g), f64::from(b), 255.0], f64::from(a) / 255.0)
}

fn opaque_channels(Color { r, g, b, a }: Color) -> [f64; 4] {
    [r, g, b, a].map(f64::from)
}

impl Pixel {
    /// What is seen, each channel from 0 to 255, rounded nowhere.
    #[must_use]
    pub fn exact(&self) -> [f64; 4] {
        let (mut seen, mut through) = ([0.0; 4], 1.0);
        for &(_, color) in self.layers.iter().rev() {
            let (channels, alpha) = channels(color);
            (0..4).for_each(|n| seen[n] += through * alpha * channels[n]);
            through *= 1.0 - alpha;
        }
        let below = opaque_channels(self.below);
        [0, 1, 2, 3].map(|n| seen[n] + through * below[n])
    }

    /// What is seen where after each layer every channel is rounded to the nearest whole number.
    #[must_use]
    pub fn rounded(&self) -> Color {
        let mix = |above: u8, below: u8, alpha: u8| -> u8 {
            let [above, below, alpha] = [above, below, alpha].map(i128::from);
            // 2·sum/510, and half of one more, rounded down.
            ((2 * (above * alpha + below * (255 - alpha)) + 255) / 510) as u8
        };
        self.layers.iter().fold(self.below, |below, (_, above)| Color {
            r: mix(above.r, below.r, above.a),
            g: mix(above.g, below.g, above.a),
            b: mix(above.b, below.b, above.a),
            a: mix(255, below.a, above.a),
        })
    }

    /// What the weighted mean of `McGuire` and Bavoil (2013) shows, by their equation 10, rounded nowhere.
    #[must_use]
    pub fn weighted(&self) -> [f64; 4] {
        let (mut sums, mut weights, mut through) = ([0.0; 4], 0.0, 1.0);
        for &(depth, color) in &self.layers {
            let (channels, alpha) = channels(color);
            let weight = alpha * f64::max(1e-2, 3e3 * (1.0 - depth).powi(3));
            (0..4).for_each(|n| sums[n] += channels[n] * alpha * weight);
            weights += alpha * weight;
            through *= 1.0 - alpha;
        }
        let below = opaque_channels(self.below);
        let mean = |n: usize| if weights > 0.0 { sums[n] / weights } else { 0.0 };
        [0, 1, 2, 3].map(|n| (1.0 - through) * mean(n) + through * below[n])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pane(depth: f32, color: Color) -> Pane {
        ([(0.0, 0.0), (9.0, 0.0), (0.0, 9.0)].map(|(x, y)| Vec3::new(x, y, depth)), color)
    }

    const HALF_RED: Color = Color { r: 255, g: 0, b: 0, a: 51 };
    const WHOLE_GREEN: Color = Color { r: 0, g: 255, b: 0, a: 255 };

    #[test]
    fn layers_are_sorted_and_hidden() {
        let behind = pane(0.75, WHOLE_GREEN);
        let panes = [pane(0.25, HALF_RED), pane(0.375, WHOLE_GREEN), pane(0.25, WHOLE_GREEN), behind];
        let pixel = at(Color::BLACK, &[pane(0.5, Color::WHITE), behind], &panes, 1, 1);
        let layers = vec![(0.375, WHOLE_GREEN), (0.25, HALF_RED), (0.25, WHOLE_GREEN)];
        assert_eq!(pixel, Pixel { below: Color::WHITE, layers, gap: 0.0 });
        assert_eq!(at(Color::RED, &[], &panes[..1], 1, 1).gap, 0.75);
        assert_eq!(at(Color::RED, &[], &[], 1, 1).gap, f64::INFINITY);
        assert_eq!(at(Color::RED, &[], &panes, 8, 8).layers, []);
    }

    /// By hand: a fifth of red over white is (255, 204, 204); green hides all.
    #[test]
    fn layers_are_laid_over_each_other() {
        let one = Pixel { below: Color::WHITE, layers: vec![(0.5, HALF_RED)], gap: 0.5 };
        assert_eq!([one.exact(), one.weighted()], [[255.0, 204.0, 204.0, 255.0]; 2]);
        assert_eq!(one.rounded(), Color::rgb(255, 204, 204));
        let two = Pixel { layers: vec![(0.5, WHOLE_GREEN), (0.0, HALF_RED)], ..one.clone() };
        assert_eq!(two.exact(), [51.0, 204.0, 0.0, 255.0]);
        assert_eq!(two.rounded(), Color::rgb(51, 204, 0));
        // Weights 375 and 600 · α: (51·120 : 255·75·…) by hand 255·(0.2·0.2·3000)/(0.2·0.2·3000 + 375).
        let red = 255.0 * 120.0 / 495.0;
        let off = two.weighted().into_iter().zip([red, 255.0 - red, 0.0, 255.0]).map(|(a, b)| (a - b).abs());
        assert!(off.into_iter().all(|off| off < 1e-9));
        assert_eq!(Pixel { layers: vec![], ..one }.weighted(), [255.0; 4]);
    }
}
