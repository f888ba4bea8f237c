//! The loop: vertices once each, triangles assembled, turned away, cut and filled.

use std::ops::AddAssign;

use common::{Vec2, Vec4};
use perspective::division::Exact;
use perspective::interpolation::PerPixel;
use perspective::render::{Fragments, draw_triangle};
use perspective::window;
use shaders::shader::{Shader, Varying};
use shaders::target::Target;

use crate::assembly::Topology;
use crate::clip::{ClipVertex, MOST_CORNERS, Polygon, clip};
use crate::facing::{Cull, facing};
use crate::homogeneous;
use crate::mesh::Mesh;
use crate::plane::{PLANES, guard_band, outcode};

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

/// A vertex once it is computed.
struct Computed<V> {
    clip: ClipVertex<V>,
    /// Its place in the window, if it has one.
    window: Option<Vec4>,
    /// The planes of the picture that it is outside of.
    outside: u8,
    /// The planes that would cut, and that it is outside of.
    beyond: u8,
}

/// The corners of what is filled, in the window.
struct Placed<V> {
    windows: [Vec4; MOST_CORNERS],
    varyings: [V; MOST_CORNERS],
    count: usize,
}

/// The numbers of a polygon's corners.
const ORDER: [u32; MOST_CORNERS] = [0, 1, 2, 3, 4, 5, 6, 7, 8];

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
    let band = guard_band(size);
    let (rejects, cuts): (&[Vec4], &[Vec4]) = match clipping {
        Clipping::LeaveOut => (&[], &[]),
        Clipping::Near => (&PLANES[..1], &PLANES[..1]),
        Clipping::SixPlanes => (&PLANES, &PLANES),
        Clipping::GuardBand => (&PLANES, &band),
        Clipping::Homogeneous => (&PLANES, &[]),
    };
    // 1. The vertices, each once.
    let computed = mesh.vertices.iter().map(|vertex| {
        let position = shader.position(vertex.position as usize);
        let varying = shader.corner(vertex.face as usize, vertex.corner as usize);
        Computed {
            clip: ClipVertex { position, varying },
            window: window(position, size),
            outside: outcode(rejects, position),
            beyond: outcode(cuts, position),
        }
    });
    let vertices: Vec<Computed<S::Varying>> = computed.collect();
    let mut counts = Counts { vertices: vertices.len(), ..Counts::default() };
    for (face, triangle) in mesh.triangles() {
        // 2. What is wholly outside of a plane, or shows the wrong side.
        let [a, b, c] = triangle.map(|vertex| &vertices[vertex as usize]);
        if a.outside & b.outside & c.outside != 0 {
            counts.outside += 1;
            continue;
        }
        let corners = [a.clip, b.clip, c.clip];
        if cull.leaves_out(facing(corners.map(|corner| corner.position))) {
            counts.culled += 1;
            continue;
        }
        let Some(constant) = shader.triangle(face) else { continue };
        // 3. The cut, where one is needed.
        if clipping == Clipping::Homogeneous {
            let fragments = Fragments::new(shader, constant, target);
            homogeneous::fill(corners, bounds, fragments);
            counts.filled += 1;
            continue;
        }
        let needed = a.beyond | b.beyond | c.beyond;
        let placed = if needed == 0 {
            Placed::of([a, b, c])
        } else {
            counts.cut += 1;
            Placed::cut(corners, cuts, needed, size)
        };
        let Some(Placed { windows, varyings, count }) = placed else {
            counts.left_out += 1;
            continue;
        };
        // 4. The pixels.
        for triangle in Topology::Fan.triangles(&ORDER[..count]) {
            let [a, b, c] = triangle.map(|corner| corner as usize);
            let (windows, varyings) =
                ([windows[a], windows[b], windows[c]], [varyings[a], varyings[b], varyings[c]]);
            draw_triangle(shader, constant, windows, varyings, PerPixel(Exact), target);
            counts.filled += 1;
        }
    }
    counts
}
// ANCHOR_END: render

impl<V: Varying> Placed<V> {
    /// A triangle that needs no cut; `None` where a corner has no place in the window.
    #[inline]
    fn of([a, b, c]: [&Computed<V>; 3]) -> Option<Self> {
        let ([u, v, w], [i, j, k]) =
            ([a.window?, b.window?, c.window?], [a, b, c].map(|corner| corner.clip.varying));
        Some(Self { windows: [u, v, w, u, u, u, u, u, u], varyings: [i, j, k, i, i, i, i, i, i], count: 3 })
    }

    /// What is left of a triangle, cut by those of the planes whose bits are set.
    #[cold]
    #[inline(never)]
    fn cut(corners: [ClipVertex<V>; 3], planes: &[Vec4], needed: u8, size: Vec2) -> Option<Self> {
        let mut polygon = Polygon::new(corners);
        for (n, &plane) in planes.iter().enumerate() {
            if needed >> n & 1 == 1 {
                polygon = clip(&polygon, plane);
            }
        }
        let mut placed = Self {
            windows: [Vec4::ZERO; MOST_CORNERS],
            varyings: [corners[0].varying; MOST_CORNERS],
            count: 0,
        };
        for corner in polygon.corners() {
            placed.windows[placed.count] = window(corner.position, size)?;
            placed.varyings[placed.count] = corner.varying;
            placed.count += 1;
        }
        Some(placed)
    }
}
