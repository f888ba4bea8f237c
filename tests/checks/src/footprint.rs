//! What a pixel sees of a textured plane, in `f64`: the mean of the light of as many rays as wanted, no levels, no
//! derivatives, no tables.
//!
//! Between the centres of its texels a texture is linear in light, in both directions; its codes are sRGB
//! (IEC 61966-2-1:1999).

use common::{Color, DVec2, DVec3, Image};

use crate::ray::Screen;

/// What a texture is outside of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outside {
    /// Its border, without end.
    Border,
    /// The same again and again.
    Again,
    /// The same and its mirror image in turn.
    Mirrored,
}

/// A texture, with the light of its texels, from 0 to 1.
#[derive(Clone, Debug)]
pub struct Texture {
    width: i64,
    height: i64,
    outside: Outside,
    light: Vec<[f64; 3]>,
}

/// A plane before an eye at the origin that looks along −z.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// Where u = v = 0.
    pub origin: DVec3,
    /// The way along which u grows by 1.
    pub u: DVec3,
    /// The way along which v grows by 1.
    pub v: DVec3,
}

/// The light, from 0 to 1, of a code from 0 to 255, which need not be whole.
#[must_use]
pub fn light(code: f64) -> f64 {
    let code = code / 255.0;
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

/// The code of a light.
#[must_use]
pub fn code(light: f64) -> f64 {
    let code = if light <= 0.04045 / 12.92 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    255.0 * code
}

impl Texture {
    /// Of a picture, which has pixels.
    #[must_use]
    pub fn new(image: &Image, outside: Outside) -> Self {
        Self::by(image, outside, light)
    }

    /// Of a picture whose codes are light in themselves, or whatever `light` says.
    #[must_use]
    pub fn by(image: &Image, outside: Outside, light: fn(f64) -> f64) -> Self {
        Self::of(image, outside, |Color { r, g, b, .. }| [r, g, b].map(|code| light(code.into())))
    }

    /// Of a picture each of whose pixels stands for three numbers.
    #[must_use]
    pub fn of(image: &Image, outside: Outside, numbers: impl Fn(Color) -> [f64; 3]) -> Self {
        let light = image.pixels().map(|(_, _, color)| numbers(color)).collect();
        Self { width: image.width().into(), height: image.height().into(), outside, light }
    }

    /// The texel that stands for texel i of a row of n, any whole number.
    fn inside(&self, i: i64, n: i64) -> i64 {
        match self.outside {
            Outside::Border => i.max(0).min(n - 1),
            Outside::Again => i.rem_euclid(n),
            // Walked to and fro: of 2n steps the second n lead back.
            Outside::Mirrored => match i.rem_euclid(2 * n) {
                there if there < n => there,
                back => 2 * n - 1 - back,
            },
        }
    }

    /// The light at a point.
    #[must_use]
    pub fn at(&self, uv: DVec2) -> [f64; 3] {
        let (x, y) = (uv.x * self.width as f64 - 0.5, uv.y * self.height as f64 - 0.5);
        let (i, j) = (x.floor() as i64, y.floor() as i64);
        let columns = [i, i + 1].map(|i| self.inside(i, self.width));
        let rows = [j, j + 1].map(|j| self.inside(j, self.height));
        let (s, t) = (x - x.floor(), y - y.floor());
        let mut sum = [0.0; 3];
        for (row, up) in rows.into_iter().zip([1.0 - t, t]) {
            for (column, right) in columns.into_iter().zip([1.0 - s, s]) {
                let texel = self.light[(row * self.width + column) as usize];
                (0..3).for_each(|channel| sum[channel] += up * right * texel[channel]);
            }
        }
        sum
    }

    /// The mean light of a parallelogram about a point, with these sides, by n×n points evenly spread over it.
    #[must_use]
    pub fn mean(&self, uv: DVec2, [right, up]: [DVec2; 2], n: u32) -> [f64; 3] {
        let off = |k: u32| (f64::from(k) + 0.5) / f64::from(n) - 0.5;
        mean([n; 2], |i, j| Some(self.at(uv + right * off(i) + up * off(j)))).unwrap_or_default()
    }
}

impl Plane {
    /// (u, v) of what a ray from the eye meets; `None` where it does not meet the plane.
    ///
    /// By Cramer's rule for O + u·U + v·V = s·d.
    #[must_use]
    pub fn met(&self, direction: DVec3) -> Option<DVec2> {
        let &Self { origin, u, v } = self;
        let along = u.cross(v).dot(direction);
        let far = u.cross(v).dot(origin) / along;
        let point = direction * far - origin;
        let normal = u.cross(v);
        let uv = DVec2::new(point.cross(v).dot(normal), u.cross(point).dot(normal)) / normal.length_squared();
        (far > 0.0 && far.is_finite()).then_some(uv)
    }

    /// How far (u, v) move at a point of the picture, in pixels, for a step of one pixel to the right and one up: by rays
    /// 10⁻⁵ px to either side.
    #[must_use]
    pub fn moves(&self, screen: &Screen, at: DVec2) -> Option<[DVec2; 2]> {
        let step = 1e-5;
        let along = |axis: DVec2| {
            let [to, from] = [at + axis * step, at - axis * step].map(|at| self.met(screen.direction(at)));
            Some((to? - from?) / (2.0 * step))
        };
        Some([along(DVec2::X)?, along(DVec2::Y)?])
    }

    /// The mean light of what the rays through a pixel meet, so many columns and rows of them, evenly spread over it; `None`
    /// where one meets nothing.
    #[must_use]
    pub fn seen(
        &self,
        texture: &Texture,
        screen: &Screen,
        [x, y]: [i32; 2],
        rays: [u32; 2],
    ) -> Option<[f64; 3]> {
        let at = |low: i32, k: u32, n: u32| f64::from(low) + (f64::from(k) + 0.5) / f64::from(n);
        let [columns, rows] = rays;
        mean(rays, |i, j| {
            let at = DVec2::new(at(x, i, columns), at(y, j, rows));
            Some(texture.at(self.met(screen.direction(at))?))
        })
    }
}

/// The mean of values in so many columns and rows.
fn mean([columns, rows]: [u32; 2], value: impl Fn(u32, u32) -> Option<[f64; 3]>) -> Option<[f64; 3]> {
    let mut sum = [0.0; 3];
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        let value = value(i, j)?;
        (0..3).for_each(|channel| sum[channel] += value[channel]);
    }
    Some(sum.map(|channel| channel / (f64::from(columns) * f64::from(rows))))
}

/// Half as many columns and rows, rounded down, of values in rows, but at least one: each the mean of the rectangle that
/// it takes the place of, in which each value fills a square.
#[must_use]
pub fn halved(values: &[f64], width: usize) -> (Vec<f64>, usize) {
    let height = values.len() / width;
    let [columns, rows] = [width, height].map(|n| (n / 2).max(1));
    let overlap = |k: usize, from: f64, to: f64| (to.min(k as f64 + 1.0) - from.max(k as f64)).max(0.0);
    let span = |k: usize, n: usize, m: usize| [k, k + 1].map(|end| end as f64 * n as f64 / m as f64);
    let mut result = Vec::new();
    for j in 0..rows {
        for i in 0..columns {
            let ([left, right], [low, high]) = (span(i, width, columns), span(j, height, rows));
            let mut sum = 0.0;
            for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
                sum += values[y * width + x] * overlap(x, left, right) * overlap(y, low, high);
            }
            result.push(sum / ((right - left) * (high - low)));
        }
    }
    (result, columns)
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::Format;

    /// Black and white, in a row.
    fn pair(outside: Outside) -> Texture {
        let mut image = Image::new(2, 1, Format::Rgb);
        image.set(1, 0, Color::WHITE);
        Texture::new(&image, outside)
    }

    fn grey(texture: &Texture, u: f64) -> f64 {
        let [r, g, b] = texture.at(DVec2::new(u, 0.3));
        assert!(r == g && g == b);
        r
    }

    #[test]
    fn half_the_light_of_white_is_188() {
        assert!((code(0.5) - 187.516).abs() < 1e-3);
        for n in 0..=255 {
            assert!((code(light(n.into())) - f64::from(n)).abs() < 1e-5, "{n}");
        }
        assert_eq!([light(0.0), light(255.0), code(0.0), code(1.0).round()], [0.0, 1.0, 0.0, 255.0]);
    }

    #[test]
    fn between_centres_it_is_linear_and_outside_as_asked() {
        for outside in [Outside::Border, Outside::Again, Outside::Mirrored] {
            let texture = pair(outside);
            assert_eq!([0.25, 0.5, 0.75, 0.625].map(|u| grey(&texture, u)), [0.0, 0.5, 1.0, 0.75]);
        }
        // The border, and the centres of the texels to either side of it.
        let around = |outside| [-1.25, -0.75, -0.25, 0.0, 1.0, 1.25, 1.75].map(|u| grey(&pair(outside), u));
        assert_eq!(around(Outside::Border), [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
        assert_eq!(around(Outside::Again), [1.0, 0.0, 1.0, 0.5, 0.5, 0.0, 1.0]);
        assert_eq!(around(Outside::Mirrored), [1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0]);
    }

    #[test]
    fn a_plane_straight_ahead_is_seen_as_it_is() {
        // 4 pixels a texture, from (0, 0) at the left border of the picture on.
        let screen = Screen::ahead(90.0, DVec2::splat(8.0));
        let plane = Plane { origin: DVec3::new(-2.0, -2.0, -2.0), u: DVec3::X * 2.0, v: DVec3::Y * 2.0 };
        let uv = plane.met(screen.through(1, 6)).unwrap();
        assert!((uv - DVec2::new(0.375, 1.625)).length() < 1e-12);
        let [right, up] = plane.moves(&screen, DVec2::new(3.0, 5.0)).unwrap();
        assert!(
            (right - DVec2::new(0.25, 0.0)).length() < 1e-9 && (up - DVec2::new(0.0, 0.25)).length() < 1e-9
        );
        // From a centre to the next and on: 0 to ½ of the way, then ½ to 1.
        let seen = plane.seen(&pair(Outside::Border), &screen, [1, 0], [64; 2]).unwrap();
        assert!((seen[0] - 0.25).abs() < 1e-12);
        assert_eq!(plane.met(DVec3::X), None);
        assert_eq!(plane.met(DVec3::Z), None);
    }

    #[test]
    fn three_texels_become_one_and_five_become_two() {
        assert_eq!(halved(&[3.0, 6.0, 0.0], 3), (vec![3.0], 1));
        let (two, width) = halved(&[1.0, 2.0, 3.0, 4.0, 5.0], 5);
        assert_eq!(width, 2);
        // (1 + 2 + 3/2) / 2.5 and (3/2 + 4 + 5) / 2.5.
        assert!((two[0] - 1.8).abs() < 1e-12 && (two[1] - 4.2).abs() < 1e-12);
        assert_eq!(halved(&[7.0], 1), (vec![7.0], 1));
        assert_eq!(halved(&[1.0, 2.0, 3.0, 6.0], 1), (vec![1.5, 4.5], 1));
    }
}
