//! Primitive assembly: triangles from a row of numbers of vertices.

/// How the numbers in an index buffer make triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topology {
    /// Each three are a triangle.
    List,
    /// Each one is a triangle with the two before it.
    Strip,
    /// Each one is a triangle with the one before it and the first.
    Fan,
}

/// In an index buffer, the end of a strip or a fan: with the next number another begins. OpenGL and Vulkan call it the
/// primitive restart index.
pub const RESTART: u32 = u32::MAX;

/// The triangles of an index buffer.
#[derive(Clone, Debug)]
pub struct Triangles<'a> {
    topology: Topology,
    indices: &'a [u32],
    /// Where the strip or fan began.
    start: usize,
    /// Where the next triangle does.
    next: usize,
}

impl Topology {
    /// The triangles that an index buffer makes, all running the way that the first one of a list, strip or fan runs.
    /// What is left at the end and too short for a triangle makes none.
    #[must_use]
    pub fn triangles(self, indices: &[u32]) -> Triangles<'_> {
        Triangles { topology: self, indices, start: 0, next: 0 }
    }
}

// ANCHOR: assembly
impl Iterator for Triangles<'_> {
    type Item = [u32; 3];

    #[inline]
    fn next(&mut self) -> Option<[u32; 3]> {
        loop {
            let &[a, b, c] = self.indices.get(self.next..)?.first_chunk()?;
            if self.topology == Topology::List {
                self.next += 3;
                return Some([a, b, c]);
            }
            if let Some(end) = [a, b, c].iter().rposition(|&index| index == RESTART) {
                self.next += end + 1;
                self.start = self.next;
                continue;
            }
            let odd = (self.next - self.start) % 2 == 1;
            self.next += 1;
            return Some(match self.topology {
                Topology::Fan => [self.indices[self.start], b, c],
                // Every other triangle of a strip has its corners the other way round.
                _ if odd => [a, c, b],
                _ => [a, b, c],
            });
        }
    }
}
// ANCHOR_END: assembly

#[cfg(test)]
mod tests {
    use super::*;

    fn made(topology: Topology, indices: &[u32]) -> Vec<[u32; 3]> {
        topology.triangles(indices).collect()
    }

    /// The notes' example: five vertices as a fan are three triangles.
    #[test]
    fn five_vertices_of_a_fan_are_three_triangles() {
        assert_eq!(made(Topology::Fan, &[0, 1, 2, 3, 4]), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    }

    #[test]
    fn odd_triangles_of_a_strip_are_turned() {
        assert_eq!(made(Topology::Strip, &[0, 1, 2, 3, 4]), [[0, 1, 2], [1, 3, 2], [2, 3, 4]]);
    }

    #[test]
    fn what_is_too_short_makes_no_triangle() {
        for topology in [Topology::List, Topology::Strip, Topology::Fan] {
            for count in 0..3 {
                assert_eq!(made(topology, &[0, 1][..count.min(2)]), [[0; 3]; 0]);
            }
        }
        assert_eq!(made(Topology::List, &[0, 1, 2, 3, 4]), [[0, 1, 2]]);
    }

    #[test]
    fn a_restart_begins_another() {
        let indices = [0, 1, 2, 3, RESTART, 4, 5, RESTART, RESTART, 6, 7, 8, 9];
        assert_eq!(made(Topology::Strip, &indices), [[0, 1, 2], [1, 3, 2], [6, 7, 8], [7, 9, 8]]);
        assert_eq!(made(Topology::Fan, &indices), [[0, 1, 2], [0, 2, 3], [6, 7, 8], [6, 8, 9]]);
    }
}
