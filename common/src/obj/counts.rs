//! How much there is in an OBJ file, counted before room is made for it.

use glam::{DVec3, Vec2, Vec3};

use super::contents::Element;
use super::elements::{Corner, used};
use super::stage::Stage;
use super::words::Words;
use crate::model::Attributes;

/// The bytes of each list's element: as it is read, its place in the model, and as it is there. A position is an f64 on
/// its way, too.
const ELEMENTS: [usize; 3] = [
    size_of::<DVec3>() + size_of::<u32>() + size_of::<DVec3>() + size_of::<Vec3>(),
    size_of::<Vec2>() + size_of::<u32>() + size_of::<Vec2>(),
    size_of::<Vec3>() + size_of::<u32>() + size_of::<Vec3>(),
];

/// The most of each kind that a file can make; what is not wanted is not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    /// `v`, `vt` and `vn` lines.
    pub(super) elements: [usize; 3],
    /// `f` lines.
    pub(super) faces: usize,
    /// Their corners, and those of the one that has most.
    pub(super) corners: usize,
    pub(super) most_corners: usize,
    /// What they become.
    pub(super) triangles: usize,
    /// `l` lines.
    pub(super) polylines: usize,
    /// Their corners.
    pub(super) bends: usize,
}

impl Counts {
    pub(super) fn of(bytes: &[u8], wanted: Attributes, stage: &mut Stage) -> Self {
        let used = used(wanted);
        let mut counts = Self::default();
        let mut words = Words::new(bytes);
        loop {
            match words.word() {
                Some(b"v") => counts.elements[0] += 1,
                Some(b"vt") if used[1] => counts.elements[1] += 1,
                Some(b"vn") if used[2] => counts.elements[2] += 1,
                Some(b"f") => {
                    let corners = words.count();
                    counts.faces += 1;
                    counts.corners += corners;
                    counts.most_corners = counts.most_corners.max(corners);
                    counts.triangles += corners.saturating_sub(2);
                }
                Some(b"l") => {
                    counts.polylines += 1;
                    counts.bends += words.count();
                }
                _ => {}
            }
            stage.done(words.offset());
            if !words.next_line() {
                return counts;
            }
        }
    }

    /// An upper bound of the bytes that reading takes besides the text, in which is the model that is made. With all
    /// attributes a triangle takes 80 of them, and a position with its own normal and texture coordinates 112; without, 32
    /// and 64.
    pub(super) fn memory(&self, wanted: Attributes) -> u64 {
        let lists = used(wanted).iter().filter(|&&used| used).count();
        let place = size_of::<u32>();
        let parts = [
            (self.elements[0], ELEMENTS[0]),
            (self.elements[1], ELEMENTS[1]),
            (self.elements[2], ELEMENTS[2]),
            (self.faces + self.polylines, size_of::<Element>()),
            (self.corners, place * lists),
            (self.triangles, 3 * place * lists),
            (self.most_corners, size_of::<Corner>() + size_of::<DVec3>()),
            // As part of a polyline, and as the end of a line.
            (self.bends, place + 2 * place),
        ];
        parts.iter().map(|&(count, bytes)| count as u64 * bytes as u64).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: Attributes = Attributes { normals: false, uvs: false };
    const ALL: Attributes = Attributes { normals: true, uvs: true };

    fn counts(text: &str, wanted: Attributes) -> Counts {
        Counts::of(text.as_bytes(), wanted, &mut Stage::new(&mut |_| (), [0.0, 1.0], text.len()))
    }

    #[test]
    fn each_line_is_counted_as_what_it_may_become() {
        let text = "v 0 0 0\nv x\n vt 0\nvn\nf 1 2 \\\n 3 x # 5\nf\nf 1 2\nl 1 2\nl 1 # f 1\nvp 0\nfo 1 2 3\nf 1 2 3";
        let expected = Counts {
            elements: [2, 1, 1],
            faces: 4,
            corners: 9,
            most_corners: 4,
            triangles: 3,
            polylines: 2,
            bends: 3,
        };
        assert_eq!(counts(text, ALL), expected);
        assert_eq!(counts(text, NONE), Counts { elements: [2, 0, 0], ..expected });
        assert_eq!(counts("", ALL), Counts::default());
    }

    #[test]
    fn memory_is_stated_by_bytes_a_face() {
        let square = "v 0 0 0\nvt 0 0\nvn 0 0 1\n";
        let triangle = "f 1/1/1 1/1/1 1/1/1\n";
        for (wanted, vertex, face) in [
            (ALL, 112, 80),
            (NONE, 64, 32),
            (Attributes { uvs: true, ..NONE }, 84, 56),
            (Attributes { normals: true, ..NONE }, 92, 56),
        ] {
            for n in [1, 4] {
                assert_eq!(counts(&square.repeat(n), wanted).memory(wanted), n as u64 * vertex);
                // The corners of one face are put together.
                let expected = n as u64 * face + 3 * 36;
                assert_eq!(counts(&triangle.repeat(n), wanted).memory(wanted), expected, "{wanted:?}");
            }
        }
        assert_eq!(counts("l 1 2 3\n", ALL).memory(ALL), 8 + 3 * 12);
    }
}
