//! `head.obj` and `head.tga`: a human head, sculpted and painted in code.
//!
//! | module | what it does |
//! |---|---|
//! | [`shape`] | the shape, as a signed distance field; its numbers are in head heights |
//! | [`surface`] | a fine mesh on the field's surface |
//! | [`decimate`] | fewer triangles, most of them in the face |
//! | [`atlas`] | where each point lies in the texture |
//! | [`paint`] | the colour of each point |
//!
//! The eyeballs are spheres of their own, behind the lids. So are the inside of the mouth and the ears' backs
//! behind other surfaces: drawn without a depth buffer they shine through.

pub mod atlas;
pub mod decimate;
pub mod paint;
pub mod shape;
pub mod surface;

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::LazyLock;

use common::Image;
use glam::{DVec2, DVec3};

use crate::mesh::{Corner, Mesh};
use atlas::{Chart, chart};
use shape::{EYE, EYE_RADIUS, MOUTH, NOSE_BASE};
use surface::Surface;

/// Triangles of the head without its eyeballs.
const TRIANGLES: usize = 5600;
/// Model units per head height: the bust is 1.49 head heights tall.
const SCALE: f64 = 1.34;
/// What is in the middle of the model, in head heights.
const MIDDLE: DVec3 = DVec3::new(0.0, -0.207, 0.0);

/// The bust in few triangles, which model and texture share.
static BUST: LazyLock<Surface> = LazyLock::new(|| simplified(TRIANGLES));

/// The bust in about so many triangles.
fn simplified(triangles: usize) -> Surface {
    let mut bust = decimate::decimate(surface::surface(), triangles, importance);
    for (p, &place) in bust.positions.iter_mut().zip(&bust.places) {
        for _ in 0..3 {
            *p = surface::settle(*p, place);
        }
    }
    bust
}

/// A corner of a triangle of the head.
struct Point {
    /// In head heights.
    position: DVec3,
    uv: DVec2,
    normal: DVec3,
}

/// The model.
#[must_use]
pub fn model() -> Mesh {
    mesh_of(&BUST)
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
    let skin = bust(&BUST).map(|triangle| triangle.map(|point| (point.uv, point.position, point.normal)));
    paint::paint(skin)
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
            Point { position, uv: chart.uv(position, (a + b + c) / 3.0), normal }
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
