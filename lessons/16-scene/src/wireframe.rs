//! The sides of triangles instead of what is within them: lesson 1's lines, between points of lesson 11's clip space.

use clipping::clip::{ClipVertex, cut};
use clipping::facing::facing;
use clipping::plane::{PLANES, distance};
use clipping::{Counts, Cull};
use common::{Color, IVec2, Image, Mat4, Vec2, Vec4, Vec4Swizzles};
use lines::{bresenham, wu};
use perspective::window;

use crate::mesh::Mesh;

/// What drawing one mesh after the other need not allocate again.
#[derive(Default)]
pub struct Wires {
    positions: Vec<Vec4>,
    lines: Vec<[IVec2; 2]>,
}

impl Wires {
    /// Makes room for a mesh: drawing it allocates nothing then.
    pub fn reserve(&mut self, mesh: &Mesh) {
        self.positions.clear();
        self.positions.reserve(mesh.assembled().vertices.len());
        self.lines.clear();
        self.lines.reserve(3 * mesh.triangles());
    }

    /// Draws each side of a mesh's triangles once, but for triangles that are left out for the side that they show. A colour's
    /// alpha counts; smooth lines are Wu's, others Bresenham's. A line ends in the pixels that its corners are in.
    // ANCHOR: wireframe
    pub fn mesh(
        &mut self,
        mesh: &Mesh,
        to_clip: &Mat4,
        cull: Cull,
        color: Color,
        smooth: bool,
        picture: &mut Image,
    ) -> Counts {
        let Self { positions, lines } = self;
        let (size, bounds) = (picture.size(), picture.bounds());
        let vertices = mesh.assembled().vertices.iter();
        positions.clear();
        positions
            .extend(vertices.map(|vertex| *to_clip * mesh.positions()[vertex.position as usize].extend(1.0)));
        let mut counts = Counts { vertices: positions.len(), ..Counts::default() };
        lines.clear();
        for (_, triangle) in mesh.assembled().triangles() {
            let corners = triangle.map(|vertex| positions[vertex as usize]);
            if cull.leaves_out(facing(corners)) {
                counts.culled += 1;
                continue;
            }
            let [a, b, c] = corners;
            lines.extend([[a, b], [b, c], [c, a]].into_iter().filter_map(|side| pixels(side, size)));
            counts.filled += 1;
        }
        // Two triangles share a side, and a line is the same from either end.
        lines.sort_unstable_by_key(|line| line.map(|end| end.to_array()));
        lines.dedup();
        for &[from, to] in &*lines {
            let plot = |x, y, coverage: u8| {
                // Exact: no product of two bytes is half-way between two multiples of 255.
                let share = (u32::from(coverage) * u32::from(color.a) + 127) / 255;
                picture.blend(x, y, color, share as u8);
            };
            if smooth { wu(from, to, bounds, plot) } else { bresenham(from, to, bounds, plot) }
        }
        counts
    }
    // ANCHOR_END: wireframe
}

/// The pixels at the ends of what is in the picture of a side, in one order whichever end comes first.
// ANCHOR: pixels
fn pixels(mut ends: [Vec4; 2], size: Vec2) -> Option<[IVec2; 2]> {
    for plane in PLANES {
        let distances = ends.map(|end| distance(plane, end));
        let is_outside = distances.map(|distance| distance < 0.0);
        if is_outside == [true; 2] {
            return None;
        }
        if let Some(outside) = is_outside.iter().position(|&is_outside| is_outside) {
            let vertices = ends.map(|position| ClipVertex { position, varying: () });
            ends[outside] = cut(vertices, distances).position;
        }
    }
    let [from, to] = ends.map(|end| window(end, size));
    let last = size.as_ivec2() - 1;
    // What is exactly on the right border belongs to the last column.
    let pixel = |end: Vec4| end.xy().floor().as_ivec2().clamp(IVec2::ZERO, last);
    let [from, to] = [pixel(from?), pixel(to?)];
    Some(if from.to_array() <= to.to_array() { [from, to] } else { [to, from] })
}
// ANCHOR_END: pixels

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Vec2 = Vec2::new(20.0, 10.0);

    fn line(from: [f32; 4], to: [f32; 4]) -> Option<[[i32; 2]; 2]> {
        let line = pixels([from, to].map(Vec4::from), SIZE);
        assert_eq!(line, pixels([to, from].map(Vec4::from), SIZE));
        line.map(|ends| ends.map(|end| end.to_array()))
    }

    #[test]
    fn a_line_is_the_same_from_either_end_and_stays_in_the_picture() {
        assert_eq!(line([-0.5, 0.0, 0.0, 1.0], [0.5, 0.5, 0.0, 1.0]), Some([[5, 5], [15, 7]]));
        // The right and the upper border belong to the last column and row.
        assert_eq!(line([-1.0, -1.0, 0.0, 1.0], [1.0, 1.0, 0.0, 1.0]), Some([[0, 0], [19, 9]]));
        assert_eq!(line([-1e10, 0.0, 0.0, 1.0], [1e10, 0.0, 0.0, 1.0]), Some([[0, 5], [19, 5]]));
        assert_eq!(line([-2.0, 0.0, 0.0, 1.0], [0.0, 2.5, 0.0, 1.0]), None);
        // From before the eye to behind it: up to the near plane, where z = −w.
        assert_eq!(line([0.0, 0.0, 0.5, 1.0], [0.0, 0.0, -2.0, -1.0]), Some([[10, 5]; 2]));
        assert_eq!(line([0.0, 0.0, 0.0, -1.0], [0.5, 0.0, 0.0, -2.0]), None);
        assert_eq!(line([f32::NAN; 4], [0.0, 0.0, 0.0, 1.0]), None);
    }
}
