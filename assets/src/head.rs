//! A human head, sculpted and painted in code: `head.obj` and `head.tga`, the same in few triangles, and its maps.
//!
//! | module | what it does |
//! |---|---|
//! | [`shape`] | the shape, as a signed distance field; its numbers are in head heights |
//! | [`surface`] | a fine mesh on the field's surface |
//! | [`decimate`] | fewer triangles, most of them in the face |
//! | [`atlas`] | where each point lies in the texture |
//! | [`mod@texels`] | which point each texel shows, and what is between the patches |
//! | [`paint`] | the colour of each point |
//! | [`shine`] | how much of a highlight each point shows |
//! | [`relief`] | strands, pores and creases: finer than the field |
//! | [`normals`] | the fine shape's normals, as maps for meshes with fewer triangles |
//!
//! The eyeballs are spheres of their own, behind the lids. So are the inside of the mouth and the ears' backs
//! behind other surfaces: drawn without a depth buffer they shine through.

pub mod atlas;
pub mod decimate;
pub mod noise;
pub mod normals;
pub mod paint;
pub mod relief;
pub mod shape;
pub mod shine;
pub mod surface;
pub mod texels;

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::LazyLock;

use common::Image;
use glam::{DVec2, DVec3};

use crate::mesh::{Corner, Mesh};
use atlas::{Chart, SIZE, chart};
use normals::Normals;
use shape::{EYE, EYE_RADIUS, MOUTH, NOSE_BASE};
use surface::Surface;
use texels::{Point, Texels};

/// Triangles of the head without its eyeballs.
const TRIANGLES: usize = 5600;
/// The same of the head in few triangles.
const LOW_TRIANGLES: usize = 350;
/// Model units per head height: the bust is 1.49 head heights tall.
const SCALE: f64 = 1.34;
/// What is in the middle of the model, in head heights.
const MIDDLE: DVec3 = DVec3::new(0.0, -0.207, 0.0);

/// The bust in few triangles, which model and texture share.
static BUST: LazyLock<Surface> = LazyLock::new(|| simplified(TRIANGLES));

/// The bust in very few triangles, whose texels lie a little beyond the patches of the other.
static LOW_BUST: LazyLock<Surface> = LazyLock::new(|| simplified(LOW_TRIANGLES));

/// The normals in the maps among the assets.
pub(super) static NORMALS: LazyLock<Normals> = LazyLock::new(|| fine_normals(1.0));

/// The bust in about so many triangles.
fn simplified(triangles: usize) -> Surface {
    static FINE: LazyLock<Surface> = LazyLock::new(surface::surface);
    let mut bust = decimate::decimate(FINE.clone(), triangles, importance);
    for (p, &place) in bust.positions.iter_mut().zip(&bust.places) {
        for _ in 0..3 {
            *p = surface::settle(*p, place);
        }
    }
    bust
}

/// The model.
#[must_use]
pub fn model() -> Mesh {
    mesh_of(&BUST)
}

/// The model in few triangles: 638, of which 288 are the eyeballs'.
#[must_use]
pub fn low_model() -> Mesh {
    mesh_of(&LOW_BUST)
}

/// The model with a bust of about so many triangles; more than [`surface`] makes are not to be had.
#[must_use]
pub fn model_of(triangles: usize) -> Mesh {
    mesh_of(&simplified(triangles))
}

fn mesh_of(surface: &Surface) -> Mesh {
    let mut mesh = Mesh::default();
    // Corners that agree in a value to the last digit written share it.
    let (mut positions, mut uvs, mut normals) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
    let key = |v: DVec3| (v * 1e5).round().as_ivec3().to_array();
    // The bust, then the eyes.
    for triangle in bust(surface).chain(eye(1.0)).chain(eye(-1.0)) {
        mesh.triangles.push(triangle.map(|Point { position, uv, normal }| {
            let position = (position - MIDDLE) * SCALE;
            Corner {
                position: number(&mut positions, &mut mesh.positions, key(position), position),
                uv: number(&mut uvs, &mut mesh.uvs, key(uv.extend(0.0)), uv),
                normal: number(&mut normals, &mut mesh.normals, key(normal), normal),
            }
        }));
    }
    mesh
}

/// The place of a value in a list, to which it is added if it is new.
fn number<T>(known: &mut BTreeMap<[i32; 3], usize>, list: &mut Vec<T>, key: [i32; 3], value: T) -> usize {
    *known.entry(key).or_insert_with(|| {
        list.push(value);
        list.len() - 1
    })
}

/// The texture.
#[must_use]
pub fn texture() -> Image {
    paint::paint(&texels(&BUST, from_axis), &texels(&LOW_BUST, from_axis))
}

/// The map of shares of a highlight, half as wide and high as the texture.
#[must_use]
pub fn shine_map() -> Image {
    shine::paint(&texels(&BUST, from_axis), &texels(&LOW_BUST, from_axis)).scale(SIZE / 2, SIZE / 2)
}

/// The normals of the fine shape by texel, with this share of the relief that is in no mesh. Of the ears, which share their
/// patches, they are the left one's.
#[must_use]
pub fn fine_normals(relief: f64) -> Normals {
    Normals::of(&texels(&BUST, left_first), &texels(&LOW_BUST, left_first), relief)
}

/// The map of normals in object space.
#[must_use]
pub fn normal_map(normals: &Normals) -> Image {
    normals.in_object_space()
}

/// The map of normals in the tangent space of [`model`].
#[must_use]
pub fn tangent_map(normals: &Normals) -> Image {
    tangent_map_for(&BUST, normals)
}

/// The map of normals in the tangent space of [`low_model`].
#[must_use]
pub fn low_tangent_map(normals: &Normals) -> Image {
    tangent_map_for(&LOW_BUST, normals)
}

fn tangent_map_for(surface: &Surface, normals: &Normals) -> Image {
    let triangles: Vec<[Point; 3]> = bust(surface).chain(eye(1.0)).collect();
    normals.in_tangent_space(&triangles, &Texels::of(&triangles, left_first))
}

/// What the texels show of a bust; of several points, that which is ranked highest.
fn texels(surface: &Surface, rank: fn(DVec3) -> f64) -> Texels {
    Texels::of(&bust(surface).collect::<Vec<_>>(), rank)
}

/// The square of the distance from the axis.
fn from_axis(p: DVec3) -> f64 {
    p.x * p.x + p.z * p.z
}

/// The same, but all of the left half before the right one.
fn left_first(p: DVec3) -> f64 {
    from_axis(p) + if p.x > 0.0 { 10.0 } else { 0.0 }
}

/// The triangles of the bust.
fn bust(surface: &Surface) -> impl Iterator<Item = [Point; 3]> {
    let smooth: Vec<DVec3> = surface.positions.iter().map(|&p| surface::gradient(p).normalize()).collect();
    surface.triangles.iter().map(move |&triangle| {
        let corners = triangle.map(|i| surface.positions[i]);
        let [a, b, c] = corners;
        let flat = (b - a).cross(c - a).normalize();
        let chart = chart(corners, flat);
        let point = |i: usize| {
            let position = surface.positions[i];
            // The base meets the body at an edge; and where the surface bends more sharply than triangles follow,
            // a triangle keeps its own normal.
            let bent = chart == Chart::Base || smooth[i].dot(flat) < 0.1;
            let normal = if bent { flat } else { smooth[i] };
            // A large triangle at the seam may reach a little beyond the texture.
            let uv = chart.uv(position, (a + b + c) / 3.0).clamp(DVec2::ZERO, DVec2::ONE);
            Point { position, uv, normal }
        };
        triangle.map(point)
    })
}

/// An eyeball, left (1) or right (−1): a sphere whose poles are in front and at the back, with smaller triangles
/// in front.
fn eye(side: f64) -> impl Iterator<Item = [Point; 3]> {
    const SECTORS: usize = 12;
    /// Angles of the rings from straight ahead, in degrees, the poles included.
    const RINGS: [f64; 8] = [0.0, 22.0, 44.0, 66.0, 80.0, 110.0, 145.0, 180.0];
    let point = move |ring: usize, sector: usize| {
        let angle = RINGS[ring].to_radians();
        let around = TAU * (sector % SECTORS) as f64 / SECTORS as f64;
        let (sin, cos) =
            if ring == RINGS.len() - 1 { (0.0, -1.0) } else { (libm::sin(angle), libm::cos(angle)) };
        let normal = DVec3::new(sin * libm::cos(around), sin * libm::sin(around), cos);
        let position = DVec3::new(side * EYE.x, EYE.y, EYE.z) + normal * EYE_RADIUS;
        Point { position, uv: Chart::Eye.uv(position, position), normal }
    };
    (0..RINGS.len() - 1).flat_map(move |ring| {
        (0..SECTORS).flat_map(move |s| {
            let first = (ring > 0).then(|| [point(ring, s), point(ring + 1, s), point(ring, s + 1)]);
            let second = (ring + 2 < RINGS.len())
                .then(|| [point(ring, s + 1), point(ring + 1, s), point(ring + 1, s + 1)]);
            first.into_iter().chain(second)
        })
    })
}

/// How much an error of the surface counts at a point: most around eyes and lips, least on the shoulders.
fn importance(p: DVec3) -> f64 {
    let side = DVec3::new(p.x.abs(), p.y, p.z);
    // The floor behind an eyeball and the throat are never seen.
    if side.distance(EYE) < EYE_RADIUS - 0.004 || (shape::mouth(side) < 0.003 && p.z < 0.385) {
        return 0.5;
    }
    let near = |center: DVec3, reach: f64| 1.0 - shape::step(side.distance(center) / reach - 0.5);
    let eye = near(EYE + DVec3::Z * 0.05, 0.09);
    let lips = near(DVec3::new(0.03, MOUTH, 0.41), 0.1);
    let nose = near(DVec3::new(0.02, NOSE_BASE + 0.03, 0.45), 0.1);
    let ear = near(DVec3::new(0.36, -0.04, -0.05), 0.15);
    let face = near(DVec3::new(0.0, -0.1, 0.35), 0.4);
    let bust = if p.y < -0.55 { 0.3 } else { 1.0 };
    bust + 4.0 * face + 120.0 * eye + 25.0 * lips + 12.0 * nose + 8.0 * ear
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// The texture is painted for two of the models. What others show beyond that has the colour of the nearest texel that was
    /// painted, which is hardly ever another one than it would have: looked at in those of them that show most of it.
    #[test]
    fn models_between_the_painted_ones_show_hardly_anything_else() {
        let texture = texture();
        let painted: BTreeSet<(i32, i32)> = [&BUST, &LOW_BUST]
            .iter()
            .flat_map(|bust| texels(bust, from_axis).iter().map(|(x, y, _)| (x, y)).collect::<Vec<_>>())
            .collect();
        for triangles in [1000, 22_400] {
            let shown = texels(&simplified(triangles), from_axis);
            let its_own = paint::paint(&shown, &shown);
            let beyond: Vec<u8> = shown
                .iter()
                .filter(|&(x, y, _)| !painted.contains(&(x, y)))
                .map(|(x, y, _)| {
                    let [a, b] = [&texture, &its_own].map(|image| image.get(x, y).expect("a texel"));
                    a.r.abs_diff(b.r).max(a.g.abs_diff(b.g)).max(a.b.abs_diff(b.b))
                })
                .collect();
            let off = beyond.iter().filter(|&&off| off > 30).count();
            assert!(
                (1000..12_000).contains(&beyond.len()) && off < 300,
                "{triangles}: {off} of {}",
                beyond.len()
            );
        }
    }
}
