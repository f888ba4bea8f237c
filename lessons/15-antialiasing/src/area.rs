//! The exact share of a pixel that a triangle covers: its area, once it is cut to the pixel's square.
//!
//! This is E. Catmull's way (*A hidden-surface algorithm with anti-aliasing*, SIGGRAPH 1978) without what makes it work:
//! Catmull goes on to find out which **part** of the square each triangle covers, and what of that is hidden. A number
//! does not say where it is. So here two things go wrong, and no area, however exact, mends them; a third is ours:
//!
//! - Two triangles at a common side cover the shares s and 1 − s of a pixel. The first leaves (1 − s) of the background,
//!   and the second lets its own share s of that be seen, as if it lay anywhere: s(1 − s) of the background shines through,
//!   up to a quarter.
//! - A pixel has one depth, and a part of it has none. Where a triangle covers a pixel whole, its depth is kept, as ever.
//!   Where it covers a part, it is tested against that depth, at the middle of its part, but its own is **not** kept: its
//!   neighbour at the common side, which may be a little farther there, would be refused, and the background remain. So
//!   what is drawn later, and is hidden behind such a part, shines through as well.
//! - Colours are codes, and each is mixed by a share in 255ths, so that what covers less than 1/510 of a pixel leaves it as
//!   it is, and so do any number of such triangles: 512 slivers that tile half of a pixel are not seen. Colours with more
//!   digits than codes have would show them.
//!
//! OpenGL's polygon smoothing has the first fault, too: it multiplies alpha by the coverage, and asks for a blending
//! function of its own and for polygons sorted from front to back (*OpenGL Programming Guide*, 1993, *Antialiasing*).

use std::ops::RangeInclusive;

use blending::Operations;
use clipping::{ClipVertex, Polygon, clip};
use common::{Bounds, Color, DVec3, IVec2, Image, Vec2, Vec3, Vec4, Vec4Swizzles};
use perspective::interpolation::relative;
use perspective::perspective_weights;
use shaders::shader::{Fragment, Varying};
use triangles::edges::{SUBPIXELS, Setup, WIDE, snap};
use zbuffer::{DepthBuffer, depth_at};

use crate::canvas::Canvas;
use crate::multisampled::pixels;
use crate::resolve::Resolve;

/// The part of a triangle that lies in a pixel, and what lesson 11 interpolates on it: the weights of the corners.
pub type Part = Polygon<Vec3>;

/// The planes of lesson 11 for what is above, below, to the right and to the left of the sides of a pixel's square: a
/// point of the window is (x, y, depth, 1), so a plane (1, 0, 0, −2) is the line x = 2.
// ANCHOR: square
fn square(pixel: IVec2) -> [Vec4; 4] {
    let (low, high) = (pixel.as_vec2(), (pixel + 1).as_vec2());
    [
        Vec4::new(0.0, 1.0, 0.0, -low.y),
        Vec4::new(0.0, -1.0, 0.0, high.y),
        Vec4::new(1.0, 0.0, 0.0, -low.x),
        Vec4::new(-1.0, 0.0, 0.0, high.x),
    ]
}
// ANCHOR_END: square

/// A triangle with its corners, in pixels, rounded to 1/256 px, as a polygon.
fn whole(corners: [Vec2; 3]) -> Part {
    let rounded = corners.map(|corner| Vec2::from_array(snap(corner).map(|n| n as f32 / SUBPIXELS as f32)));
    let weights = [Vec3::X, Vec3::Y, Vec3::Z];
    let corner = |n: usize| ClipVertex { position: rounded[n].extend(0.0).extend(1.0), varying: weights[n] };
    Polygon::new(&[0, 1, 2].map(corner))
}

/// What of a triangle lies in the square of a pixel; the corners are in pixels.
// ANCHOR: clipped
#[must_use]
pub fn clipped(corners: [Vec2; 3], pixel: IVec2) -> Part {
    square(pixel).into_iter().fold(whole(corners), |part, plane| clip(&part, plane))
}
// ANCHOR_END: clipped

/// The area of a polygon, and the mean of what is interpolated on it: the value at its centroid.
///
/// As a fan of triangles about the first corner, each counted by its area, where what is interpolated has the mean of
/// its three corners (the shoelace formula, from a corner next to which nothing is lost by subtraction).
// ANCHOR: area
fn moments(part: &Part) -> (f64, DVec3) {
    let [first, rest @ ..] = part.corners() else { return (0.0, DVec3::ZERO) };
    let (mut doubled, mut sum) = (0.0, DVec3::ZERO);
    for [b, c] in rest.array_windows() {
        let [to_b, to_c] =
            [b, c].map(|corner| corner.position.xy().as_dvec2() - first.position.xy().as_dvec2());
        let cross = to_b.perp_dot(to_c);
        doubled += cross;
        sum += (first.varying + b.varying + c.varying).as_dvec3() / 3.0 * cross;
    }
    (doubled.abs() / 2.0, sum / doubled)
}

/// The share of a pixel that a triangle covers, from 0 to 1; its corners are in pixels.
///
/// Cuts are rounded to `f32`: in a picture up to 1024 px wide to 2⁻¹⁵ px, which is less than 1/50 of a grey level.
#[must_use]
pub fn area(corners: [Vec2; 3], pixel: IVec2) -> f64 {
    moments(&clipped(corners, pixel)).0
}
// ANCHOR_END: area

/// Calls `visit(x, y, share, weights)` for each pixel in `bounds` of which a triangle covers some share, rows from the
/// bottom, with the weights of its corners at the centroid of the covered part: the pixel's centre, where it is covered
/// whole. Corners are in pixels, in any order. As in lesson 3, a triangle with one beyond ±2⁵² px, or NaN, is left out.
///
/// A row is cut from the triangle once, its pixels from the row. Pixels that are covered whole are not cut at all: each
/// of lesson 3's edge functions is least at one of the square's corners, half a step right or left and half a step up or
/// down from the centre.
// ANCHOR: fill
pub fn fill(corners: [Vec2; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, f64, Vec3)) {
    if !corners.iter().all(|corner| corner.abs().cmple(Vec2::splat(WIDE)).all()) {
        return;
    }
    let triangle = whole(corners);
    let setup = Setup::new(corners, bounds);
    for y in span(&triangle, 1, bounds.min.y, bounds.max.y) {
        let [bottom, top, ..] = square(IVec2::new(0, y));
        let row = clip(&clip(&triangle, bottom), top);
        for x in span(&row, 0, bounds.min.x, bounds.max.x) {
            if let Some(weights) = setup.and_then(|setup| inner(&setup, x, y)) {
                visit(x, y, 1.0, weights);
                continue;
            }
            let [.., left, right] = square(IVec2::new(x, y));
            let (share, weights) = moments(&clip(&clip(&row, left), right));
            if share > 0.0 {
                visit(x, y, share, weights.as_vec3());
            }
        }
    }
}
// ANCHOR_END: fill

/// The rows or columns of pixels, within bounds, that a polygon reaches into along an axis.
fn span(polygon: &Part, axis: usize, min: i32, max: i32) -> RangeInclusive<i32> {
    let all = polygon.corners().iter().map(|corner| corner.position[axis]);
    let (low, high) =
        all.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), n| (low.min(n), high.max(n)));
    (low.floor() as i32).max(min)..=(high.ceil() as i32).saturating_sub(1).min(max)
}

/// The weights at the centre of a pixel, where the triangle covers all of it.
fn inner(setup: &Setup, x: i32, y: i32) -> Option<Vec3> {
    let [right, up] =
        [f64::from(x) - f64::from(setup.bounds.min.x), f64::from(y) - f64::from(setup.bounds.min.y)];
    let edges = setup.edges + setup.right * right + setup.up * up;
    let farthest = (setup.right.abs() + setup.up.abs()) / 2.0;
    edges.cmpge(farthest).all().then(|| (edges * setup.per_area).as_vec3())
}

/// A picture with one colour and one depth in each pixel, mixed by the share that a triangle covers.
///
/// A pixel covered whole is drawn as in lesson 14. One covered in part is shaded once, at the centroid of that part; its
/// depth there is tested but not kept, and the colours are mixed in 255ths. So opaque surfaces only: what blending makes of
/// others takes the place of the covered share. Samples there are none, and nothing to resolve: codes are mixed as they come.
pub struct Area {
    colors: Vec<Color>,
    depths: Vec<f32>,
    bounds: Bounds,
    alpha_to_coverage: bool,
}

impl Canvas for Area {
    type Stencil = ();

    fn new([width, height]: [usize; 2]) -> Self {
        let pixels = width * height;
        let bounds = Bounds { min: IVec2::ZERO, max: IVec2::new(width as i32, height as i32) - 1 };
        Self {
            colors: vec![Color::BLACK; pixels],
            depths: vec![1.0; pixels],
            bounds,
            alpha_to_coverage: false,
        }
    }

    fn clear(&mut self, background: Color, alpha_to_coverage: bool) {
        self.alpha_to_coverage = alpha_to_coverage;
        self.colors.fill(background);
        self.depths.fill(1.0);
    }

    fn size(&self) -> Vec2 {
        (self.bounds.max + 1).as_vec2()
    }

    // ANCHOR: mixed
    fn fill<V: Varying>(
        &mut self,
        state: impl Operations<Stencil = ()>,
        corners: [Vec4; 3],
        varyings: [V; 3],
        mut shade: impl FnMut(Fragment<V>) -> Option<Color>,
    ) {
        let z = Vec3::from_array(corners.map(|corner| corner.z));
        let Some(inverse_w) = relative(corners).filter(|_| z.is_finite()) else { return };
        let width = self.bounds.max.x as usize + 1;
        fill(corners.map(Vec4::xy), self.bounds, |x, y, share, weights| {
            let (pixel, depth) = (y as usize * width + x as usize, depth_at(z, weights));
            let (color, kept) = (&mut self.colors[pixel], &mut self.depths[pixel]);
            if !state.test(IVec2::new(x, y), depth, *kept, &mut ()) {
                return;
            }
            let varying = V::interpolate(varyings, perspective_weights(weights, inverse_w));
            let Some(source) = shade(Fragment { x, y, depth, varying }) else { return };
            let alpha = if self.alpha_to_coverage { f64::from(source.a) / 255.0 } else { 1.0 };
            let coverage = (share * alpha * 255.0).round() as u8;
            *color = color.mixed(state.color(source, *color), coverage);
            if coverage == u8::MAX && state.writes_depth() {
                *kept = depth;
            }
        });
    }
    // ANCHOR_END: mixed

    fn resolve(&self, _: Resolve, picture: &mut Image) {
        picture.set_all(|pixel| self.colors[pixel]);
    }

    fn depths(&self, picture: &Image) -> DepthBuffer<f32> {
        let mut depths = DepthBuffer::new(picture, 1.0);
        for ((x, y), &depth) in pixels(self.bounds).zip(&self.depths) {
            depths.set(x, y, depth);
        }
        depths
    }
}
