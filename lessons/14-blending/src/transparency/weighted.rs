//! A mean of all layers, which needs no order.
//!
//! How much of the background is seen is the product of all 1 − α, in whatever order. What else is seen is a mean of the
//! layers' colours, each weighted by its α and by how near it is: with n layers, sums instead of a sort (M. `McGuire` and L.
//! Bavoil, *Weighted blended order-independent transparency*, Journal of Computer Graphics Techniques 2, 2013).

use common::{Bounds, Color, Image, Vec3};
use shaders::target::Target;
use zbuffer::DepthBuffer;

use super::Fill;

// ANCHOR: weight
/// How much a layer counts: α·max(10⁻², 3·10³·(1 − z)³), z its depth in the window, from 0 to 1 (`McGuire` and Bavoil, equation
/// 10). `alpha` is from 0 to 1.
#[inline]
#[must_use]
pub fn weight(depth: f32, alpha: f32) -> f32 {
    let near = 1.0 - depth;
    alpha * (3e3 * near * near * near).max(1e-2)
}
// ANCHOR_END: weight

// ANCHOR: weighted
/// Sums up all layers, then lays their mean over the picture.
pub(super) fn draw(transparent: &[impl Fill], image: &mut Image, depths: &DepthBuffer<f32>) {
    let layers = vec![Layers::NONE; image.width() as usize * image.height() as usize];
    let mut sums = Sums { depths, layers };
    transparent.iter().for_each(|triangle| triangle.fill(&mut sums));
    let columns = 0..image.width();
    let pixels = (0..image.height()).flat_map(|y| columns.clone().map(move |x| (x, y)));
    for ((x, y), layers) in pixels.zip(&sums.layers) {
        // Where nothing is, or nothing but alphas of 0, there is no mean.
        if let Some(below) = image.get(x, y).filter(|_| layers.weight > 0.0) {
            image.set(x, y, layers.over(below));
        }
    }
}

/// The layers of a pixel: 20 bytes.
#[derive(Clone, Copy)]
struct Layers {
    /// The sums of channel · α · weight, channels from 0 to 255.
    color: Vec3,
    /// The sum of α · weight.
    weight: f32,
    /// The share of the background that they all let through.
    through: f32,
}

impl Layers {
    const NONE: Self = Self { color: Vec3::ZERO, weight: 0.0, through: 1.0 };

    #[inline]
    fn add(&mut self, depth: f32, Color { r, g, b, a }: Color) {
        let alpha = f32::from(a) / 255.0;
        let weight = alpha * weight(depth, alpha);
        self.color += weight * Vec3::new(r.into(), g.into(), b.into());
        self.weight += weight;
        self.through *= 1.0 - alpha;
    }

    /// The mean of all layers over a colour, rounded to nearest.
    fn over(&self, below: Color) -> Color {
        let mean = self.color / self.weight;
        let mix = |layers: f32, below: u8| (layers + (f32::from(below) - layers) * self.through + 0.5) as u8;
        Color {
            r: mix(mean.x, below.r),
            g: mix(mean.y, below.g),
            b: mix(mean.z, below.b),
            a: mix(255.0, below.a),
        }
    }
}

/// The sums in each pixel, rows from the bottom.
struct Sums<'a> {
    depths: &'a DepthBuffer<f32>,
    layers: Vec<Layers>,
}

impl Target<Color> for Sums<'_> {
    fn bounds(&self) -> Bounds {
        self.depths.bounds()
    }

    #[inline]
    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        depth < self.depths.get(x, y)
    }

    #[inline]
    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        let width = self.depths.bounds().max.x as usize + 1;
        self.layers[y as usize * width + x as usize].add(depth, color);
    }

    fn clear(&mut self) {
        self.layers.fill(Layers::NONE);
    }
}
// ANCHOR_END: weighted

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_takes_as_much_as_the_table_says() {
        assert_eq!(size_of::<Layers>(), 20);
    }

    /// By hand: (1 − ½)³ is an eighth, and far away the least weight counts.
    #[test]
    fn the_near_count_more() {
        assert_eq!([weight(0.5, 1.0), weight(0.5, 0.5), weight(0.0, 1.0)], [375.0, 187.5, 3000.0]);
        assert_eq!([weight(1.0, 1.0), weight(0.999, 0.5)], [0.01, 0.005]);
    }

    #[test]
    fn what_is_cleared_is_forgotten() {
        let image = Image::new(2, 3, common::Format::Rgb);
        let depths = DepthBuffer::new(&image, 1.0);
        let mut sums = Sums { depths: &depths, layers: vec![Layers::NONE; 6] };
        sums.write(1, 2, 0.5, Color { a: 51, ..Color::RED });
        assert_eq!(sums.layers[5].over(Color::BLACK), Color::rgb(51, 0, 0));
        sums.clear();
        assert!(sums.layers.iter().all(|layers| layers.weight == 0.0 && layers.through == 1.0));
    }
}
