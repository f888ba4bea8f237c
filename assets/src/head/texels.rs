//! The head's textures texel by texel: which point of the surface each shows, and what is between the patches.

use common::{Color, Format, Image};
use glam::{DVec2, DVec3};

use super::atlas::SIZE;

/// A corner of a triangle of the head.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// In head heights.
    pub position: DVec3,
    /// Texture coordinates.
    pub uv: DVec2,
    /// Unit vector that points outwards.
    pub normal: DVec3,
}

/// What a texel shows of a list of triangles.
#[derive(Clone, Copy, Debug)]
pub struct Texel {
    /// In head heights.
    pub position: DVec3,
    /// Interpolated between the corners and of length 1.
    pub normal: DVec3,
    /// The number of the triangle.
    pub triangle: usize,
}

/// What each texel shows, if anything; rows from the bottom.
pub struct Texels(Vec<Option<Texel>>);

impl Texels {
    /// Every texel whose centre a triangle covers; of several triangles that which `rank` ranks highest, or the first.
    #[must_use]
    pub fn of(triangles: &[[Point; 3]], rank: impl Fn(DVec3) -> f64) -> Self {
        let mut texels = vec![None; usize::from(SIZE) * usize::from(SIZE)];
        for (n, triangle) in triangles.iter().enumerate() {
            rasterize(triangle, |x, y, position, normal| {
                let at: &mut Option<Texel> = &mut texels[y * usize::from(SIZE) + x];
                if at.is_none_or(|other| rank(position) > rank(other.position)) {
                    *at = Some(Texel { position, normal, triangle: n });
                }
            });
        }
        Self(texels)
    }

    /// The number of all texels.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a texture has texels")]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// All that show something: column, row, what.
    pub fn iter(&self) -> impl Iterator<Item = (i32, i32, Texel)> + '_ {
        let side = usize::from(SIZE);
        let placed = move |(n, texel): (usize, &Option<Texel>)| {
            Some(((n % side) as i32, (n / side) as i32, (*texel)?))
        };
        self.0.iter().enumerate().filter_map(placed)
    }
}

/// Calls `visit` for every texel whose centre a triangle covers: column, row, position, unit normal.
fn rasterize(triangle: &[Point; 3], mut visit: impl FnMut(usize, usize, DVec3, DVec3)) {
    let side = f64::from(SIZE);
    let [a, b, c] = triangle.map(|point| point.uv * side - 0.5);
    let area = (b - a).perp_dot(c - a);
    let (low, high) = (a.min(b).min(c).ceil(), a.max(b).max(c).floor().min(DVec2::splat(side - 1.0)));
    for y in low.y as usize..=high.y as usize {
        for x in low.x as usize..=high.x as usize {
            let p = DVec2::new(x as f64, y as f64);
            let weights = [(c - b).perp_dot(p - b), (a - c).perp_dot(p - c), (b - a).perp_dot(p - a)];
            let weights = weights.map(|w| w / area);
            if weights.iter().any(|w| !(-1e-9..).contains(w)) {
                continue;
            }
            let (mut position, mut normal) = (DVec3::ZERO, DVec3::ZERO);
            for (weight, point) in weights.into_iter().zip(triangle) {
                position += point.position * weight;
                normal += point.normal * weight;
            }
            visit(x, y, position, normal.normalize_or_zero());
        }
    }
}

/// A texture in the making.
pub struct Sheet {
    image: Image,
    known: Vec<bool>,
}

impl Sheet {
    /// With nothing on it.
    #[must_use]
    pub fn new(format: Format) -> Self {
        let image = Image::new(SIZE, SIZE, format);
        Self { known: vec![false; usize::from(SIZE) * usize::from(SIZE)], image }
    }

    /// Colours a texel of the texture.
    pub fn set(&mut self, x: i32, y: i32, color: Color) {
        self.image.set(x, y, color);
        self.known[index(x, y)] = true;
    }

    /// Colours a texel if it was not coloured.
    pub fn set_unknown(&mut self, x: i32, y: i32, color: impl FnOnce() -> Color) {
        if !self.known[index(x, y)] {
            self.set(x, y, color());
        }
    }

    /// Colours all texels for which there is something in a list, rows from the bottom.
    pub fn fill<T>(&mut self, list: &[Option<T>], color: impl Fn(&T) -> Color) {
        let side = usize::from(SIZE);
        for (n, value) in list.iter().enumerate() {
            if let Some(value) = value {
                self.set((n % side) as i32, (n / side) as i32, color(value));
            }
        }
    }

    /// Lets the patches grow by so many rings of texels, or until there is no texel left: each takes the colour of its
    /// neighbour in the ring before.
    pub fn grow(&mut self, rings: usize) {
        let texels = (0..i32::from(SIZE)).flat_map(|y| (0..i32::from(SIZE)).map(move |x| (x, y)));
        let mut unknown: Vec<(i32, i32)> = texels.filter(|&(x, y)| !self.known[index(x, y)]).collect();
        for _ in 0..rings {
            let mut ring = Vec::new();
            unknown.retain(|&(x, y)| {
                let inside = |&(x, y): &(i32, i32)| self.image.bounds().contains(x, y);
                let neighbours = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)].into_iter().filter(inside);
                let known = { neighbours }.find(|&(x, y)| self.known[index(x, y)]);
                ring.extend(known.and_then(|(from, row)| Some((x, y, self.image.get(from, row)?))));
                known.is_none()
            });
            if ring.is_empty() {
                break;
            }
            ring.into_iter().for_each(|(x, y, color)| self.set(x, y, color));
        }
    }

    /// The texture, in which each texel that was not coloured has the colour of the nearest that was, counted in steps
    /// along rows and columns: a smaller copy of the texture averages over the borders of its patches, and must meet
    /// nothing there that is in no patch.
    #[must_use]
    pub fn padded(mut self) -> Image {
        self.grow(usize::MAX);
        self.image
    }
}

/// Where a texel is in a list of all.
pub(super) fn index(x: i32, y: i32) -> usize {
    (y * i32::from(SIZE) + x) as usize
}
