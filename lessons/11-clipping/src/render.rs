//! The loop: vertices once each, triangles assembled, turned away, cut and filled.

use std::ops::AddAssign;

use common::{Vec2, Vec4, Vec4Swizzles};
use perspective::division::Exact;
use perspective::interpolation::PerPixel;
use perspective::render::{Fragments, draw_triangle};
use perspective::window;
use shaders::shader::{Shader, Varying};
use shaders::target::Target;

use crate::clip::{ClipVertex, MOST_CORNERS, Polygon, clip};
use crate::facing::{Cull, area, facing};
use crate::homogeneous;
use crate::mesh::{Mesh, Vertex};
use crate::plane::{NEAR, PLANES, guard_band, outcode, outside};

/// What is done with triangles that are not wholly in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clipping {
    /// As in lesson 10: those with a corner at w ≤ 1e-6 are left out and counted, the others filled.
    LeaveOut,
    /// They are cut by the near plane; beyond the other five the fill finds no pixels, or the depth test nothing nearer.
    Near,
    /// They are cut by all six planes of the picture.
    SixPlanes,
    /// They are cut by near and far, and by planes far outside of the picture where its numbers would not do.
    GuardBand,
    /// They are not cut: what covers a pixel is told before the division.
    Homogeneous,
}

/// What became of the vertices and triangles of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Vertices computed.
    pub vertices: usize,
    /// Triangles all of whose corners are outside of one plane.
    pub outside: usize,
    /// Triangles left out for the side that they show.
    pub culled: usize,
    /// Triangles cut by a plane.
    pub cut: usize,
    /// Triangles left out since they reach to where w ≤ 1e-6, by `leave-out` or after all cuts.
    pub left_out: usize,
    /// Triangles filled, those counted that a cut one was taken apart into.
    pub filled: usize,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.vertices += other.vertices;
        self.outside += other.outside;
        self.culled += other.culled;
        self.cut += other.cut;
        self.left_out += other.left_out;
        self.filled += other.filled;
    }
}

/// A mesh's vertices once they are computed. Who keeps them from one drawing to the next allocates memory for the largest
/// mesh once.
pub struct Vertices<V>(Vec<Computed<V>>);

impl<V> Default for Vertices<V> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<V> Vertices<V> {
    /// Makes room for a mesh of so many vertices: up to that, drawing allocates nothing.
    pub fn reserve(&mut self, vertices: usize) {
        self.0.clear();
        self.0.reserve(vertices);
    }
}

/// A vertex once it is computed.
#[derive(Clone, Copy)]
pub struct Computed<V> {
    clip: ClipVertex<V>,
    /// Its place in the window, if it has one.
    window: Option<Vec4>,
    /// The planes of the picture that it is outside of.
    outside: u8,
    /// The planes that would cut, and that it is outside of.
    beyond: u8,
}

/// Draws a mesh with any shader whose values at a corner hang on no more than what makes two corners one vertex in this
/// mesh; the shader's positions are in clip space.
///
/// # Panics
/// Where the mesh has a vertex or a face that the shader has not.
// ANCHOR: render
pub fn render<S: Shader + ?Sized>(
    shader: &S,
    mesh: &Mesh,
    cull: Cull,
    clipping: Clipping,
    target: &mut impl Target<S::Output>,
) -> Counts {
    let bounds = target.bounds();
    let size = (bounds.max + 1).as_vec2();
    if clipping == Clipping::Homogeneous {
        let stages = Stages::new(shader, cull, clipping, size);
        let vertices: Vec<_> = mesh.vertices.iter().map(|vertex| stages.vertex(vertex)).collect();
        return stages.seen(&vertices, mesh.triangles(), |counts, constant, corners| {
            let corners = corners.map(|corner| corner.clip);
            homogeneous::fill(corners, bounds, Fragments::new(shader, constant, target));
            counts.filled += 1;
        });
    }
    triangles(shader, mesh, cull, clipping, size, |constant, corners, varyings| {
        draw_triangle(shader, constant, corners, varyings, PerPixel(Exact), target);
    })
}
// ANCHOR_END: render

/// Calls `fill(constant, corners, varyings)` for each triangle that is to be filled in a picture of that size, whoever
/// fills it: with what the shader's own step for the triangle gave, with corners in the window, x and y in pixels, the
/// depth and 1/w, and with what is interpolated from them. A triangle that is cut comes as the triangles it is taken
/// apart into. [`Clipping::Homogeneous`] cuts nothing: a triangle whose corners all have a place in the window comes
/// whole, any other is left out and counted.
///
/// # Panics
/// As [`render`].
#[inline]
pub fn triangles<S: Shader + ?Sized>(
    shader: &S,
    mesh: &Mesh,
    cull: Cull,
    clipping: Clipping,
    size: Vec2,
    fill: impl FnMut(S::Constant, [Vec4; 3], [S::Varying; 3]),
) -> Counts {
    triangles_with(&mut Vertices::default(), shader, mesh, cull, clipping, size, fill)
}

/// The same with vertices that are kept: what is in them is forgotten, but their memory used again.
///
/// # Panics
/// As [`render`].
#[inline]
pub fn triangles_with<S: Shader + ?Sized>(
    vertices: &mut Vertices<S::Varying>,
    shader: &S,
    mesh: &Mesh,
    cull: Cull,
    clipping: Clipping,
    size: Vec2,
    fill: impl FnMut(S::Constant, [Vec4; 3], [S::Varying; 3]),
) -> Counts {
    let Vertices(vertices) = vertices;
    let stages = Stages::new(shader, cull, clipping, size);
    vertices.clear();
    vertices.extend(mesh.vertices.iter().map(|vertex| stages.vertex(vertex)));
    stages.triangles(vertices, mesh.triangles(), fill)
}

/// The two steps before the pixels, for whoever does them in parts: each vertex by itself, then triangles, once all their
/// vertices are computed.
pub struct Stages<'a, S: ?Sized> {
    shader: &'a S,
    cull: Cull,
    size: Vec2,
    /// The planes of the picture outside of which a triangle is left out, a bit each.
    rejects: u8,
    /// The planes that cut, the first so many of these.
    cuts: [Vec4; 6],
    cut_count: usize,
}

impl<'a, S: Shader + ?Sized> Stages<'a, S> {
    /// Of a drawing into a picture of that size.
    #[must_use]
    pub fn new(shader: &'a S, cull: Cull, clipping: Clipping, size: Vec2) -> Self {
        let (rejects, cuts, cut_count) = match clipping {
            Clipping::LeaveOut => (0, PLANES, 0),
            Clipping::Near => (NEAR, PLANES, 1),
            Clipping::SixPlanes => (u8::MAX, PLANES, 6),
            Clipping::GuardBand => (u8::MAX, guard_band(size), 6),
            Clipping::Homogeneous => (u8::MAX, PLANES, 0),
        };
        Self { shader, cull, size, rejects, cuts, cut_count }
    }

    fn cuts(&self) -> &[Vec4] {
        &self.cuts[..self.cut_count]
    }

    // ANCHOR: seen
    /// 1. A vertex.
    #[inline]
    #[must_use]
    pub fn vertex(&self, vertex: &Vertex) -> Computed<S::Varying> {
        let position = self.shader.position(vertex.position as usize);
        let varying = self.shader.corner(vertex.face as usize, vertex.corner as usize);
        let outside = outside(position) & self.rejects;
        let beyond = if outside == 0 { 0 } else { outcode(self.cuts(), position) };
        Computed {
            clip: ClipVertex { position, varying },
            window: window(position, self.size),
            outside,
            beyond,
        }
    }

    /// Calls `visit(counts, constant, corners)` for each triangle that may be seen, wherever its corners are. What is wholly
    /// outside of a plane is left out.
    #[inline]
    fn seen(
        &self,
        vertices: &[Computed<S::Varying>],
        triangles: impl Iterator<Item = (usize, [u32; 3])>,
        mut visit: impl FnMut(&mut Counts, S::Constant, [&Computed<S::Varying>; 3]),
    ) -> Counts {
        let mut counts = Counts { vertices: vertices.len(), ..Counts::default() };
        for (face, triangle) in triangles {
            // 2. What is wholly outside of a plane, or shows the wrong side.
            let corners = triangle.map(|vertex| &vertices[vertex as usize]);
            if corners.iter().fold(u8::MAX, |all, corner| all & corner.outside) != 0 {
                counts.outside += 1;
            } else if self.cull.leaves_out(facing(corners.map(|corner| corner.clip.position))) {
                counts.culled += 1;
            } else if let Some(constant) = self.shader.triangle(face) {
                visit(&mut counts, constant, corners);
            }
        }
        counts
    }
    // ANCHOR_END: seen

    // ANCHOR: stages
    /// The triangles: calls `fill(constant, corners, varyings)` as [`triangles`](fn@triangles) does.
    #[inline]
    pub fn triangles(
        &self,
        vertices: &[Computed<S::Varying>],
        triangles: impl Iterator<Item = (usize, [u32; 3])>,
        mut fill: impl FnMut(S::Constant, [Vec4; 3], [S::Varying; 3]),
    ) -> Counts {
        self.seen(vertices, triangles, |counts, constant, corners| {
            // 3. The cut, where one is needed.
            let needed = corners.iter().fold(0, |needed, corner| needed | corner.beyond);
            if needed != 0 {
                counts.cut += 1;
                let polygon = clip_by(corners.map(|corner| corner.clip), self.cuts(), needed);
                let filled =
                    fill_polygon(&polygon, self.size, |corners, varyings| fill(constant, corners, varyings));
                counts.filled += filled.unwrap_or(0);
                counts.left_out += usize::from(filled.is_none());
                return;
            }
            // 4. The pixels.
            let [Some(a), Some(b), Some(c)] = corners.map(|corner| corner.window) else {
                counts.left_out += 1;
                return;
            };
            fill(constant, [a, b, c], corners.map(|corner| corner.clip.varying));
            counts.filled += 1;
        })
    }
    // ANCHOR_END: stages
}

/// What of a triangle is inside of those planes whose bits are set.
// ANCHOR: clip_by
#[cold]
#[inline(never)]
fn clip_by<V: Varying>(corners: [ClipVertex<V>; 3], planes: &[Vec4], needed: u8) -> Polygon<V> {
    let mut polygon = Polygon::new(&corners);
    for (n, &plane) in planes.iter().enumerate() {
        if needed >> n & 1 == 1 {
            polygon = clip(&polygon, plane);
        }
    }
    polygon
}
// ANCHOR_END: clip_by

/// Calls `fill(corners, varyings)` for the triangles of a fan that covers a polygon, and returns for how many; `None` where a
/// corner has no place in the window.
// ANCHOR: fill_polygon
#[cold]
#[inline(never)]
fn fill_polygon<V: Varying>(
    polygon: &Polygon<V>,
    size: Vec2,
    mut fill: impl FnMut([Vec4; 3], [V; 3]),
) -> Option<usize> {
    let corners = polygon.corners();
    let mut windows = [Vec4::ZERO; MOST_CORNERS];
    for (place, corner) in windows.iter_mut().zip(corners) {
        *place = window(corner.position, size)?;
    }
    let mut filled = 0;
    fan(&windows[..corners.len()], &mut |triangle| {
        fill(triangle.map(|corner| windows[corner]), triangle.map(|corner| corners[corner].varying));
        filled += 1;
    });
    Some(filled)
}
// ANCHOR_END: fill_polygon

/// Calls `visit` for the triangles, three numbers of corners each, of a fan that covers a convex polygon in the window.
///
/// Any corner would do as the first, but corners are rounded to 1/256 px, and two that nearly coincide may be brought past
/// each other: then a triangle of some fans, or of all, is turned round, and its pixels would be drawn twice. That fan is taken
/// of which the least is turned round, mostly nothing, and this is not drawn.
// ANCHOR: fan
pub fn fan(windows: &[Vec4], visit: &mut dyn FnMut([usize; 3])) {
    let count = windows.len();
    let triangles = |first: usize| {
        (2..count).map(move |n| {
            let triangle = [first, (first + n - 1) % count, (first + n) % count];
            (triangle, area(triangle.map(|corner| windows[corner].xy())))
        })
    };
    let whole: f64 = triangles(0).map(|(_, area)| area).sum();
    let turned =
        |first: usize| triangles(first).map(|(_, area)| (-area * whole.signum()).max(0.0)).sum::<f64>();
    let best = (0..count).map(|first| (first, turned(first))).min_by(|a, b| a.1.total_cmp(&b.1));
    let fan = best.into_iter().flat_map(|(first, _)| triangles(first));
    fan.filter(|(_, area)| area * whole > 0.0).for_each(|(triangle, _)| visit(triangle));
}
// ANCHOR_END: fan

#[cfg(test)]
mod tests {
    use super::*;

    fn fan_of(corners: &[(f32, f32)]) -> Vec<[usize; 3]> {
        let windows: Vec<Vec4> = corners.iter().map(|&(x, y)| Vec4::new(x, y, 0.5, 1.0)).collect();
        let mut triangles = Vec::new();
        fan(&windows, &mut |triangle| triangles.push(triangle));
        triangles
    }

    #[test]
    fn a_fan_begins_at_the_first_corner() {
        let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
        assert_eq!(fan_of(&square), [[0, 1, 2], [0, 2, 3]]);
        // Two corners in one place make a triangle without area.
        assert_eq!(fan_of(&[square[0], square[1], square[1], square[2]]), [[0, 2, 3]]);
        assert_eq!(fan_of(&square[..2]), [[0; 3]; 0]);
        // Clockwise, and with a corner on a side: seen from the first corner nothing is turned round, so it stays the first.
        let clockwise = [square[0], square[3], square[2], square[1], (2.0, 0.0)];
        assert_eq!(fan_of(&clockwise), [[0, 1, 2], [0, 2, 3]]);
        // A bow tie: as much of it is turned round as is not.
        assert_eq!(fan_of(&[square[0], square[1], square[3], square[2]]), [[0; 3]; 0]);
    }

    /// The first corner and the last are brought past each other: seen from the first, a long sliver is turned round.
    #[test]
    fn no_pixel_is_drawn_twice_where_rounding_turns_a_corner_round() {
        let corners = [
            (-0.240_226_75, 5.950_766_6),
            (0.691_621_8, 13.684_174),
            (7.293_154_2, 12.665_943),
            (-0.238_324_17, 5.951_849),
        ];
        assert_eq!(fan_of(&corners), [[1, 2, 3]]);
    }

    #[test]
    fn counts_add_up_one_by_one() {
        let mut sum = Counts { vertices: 2, outside: 3, culled: 4, cut: 5, left_out: 6, filled: 7 };
        sum += Counts { vertices: 10, outside: 20, culled: 30, cut: 40, left_out: 50, filled: 60 };
        let expected = Counts { vertices: 12, outside: 23, culled: 34, cut: 45, left_out: 56, filled: 67 };
        assert_eq!(sum, expected);
    }
}
