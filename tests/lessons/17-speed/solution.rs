//! All of mission 17.
use common::DVec3;

pub use speed_given::{Cover, Edges, SIDE, draw};

/// Each side's least and greatest value at the four corners of the block.
pub fn cover(edges: DVec3, right: DVec3, up: DVec3, inside: DVec3) -> Cover {
    let last = f64::from(SIDE - 1);
    let mut whole = true;
    for side in 0..3 {
        let (start, x, y) = (edges[side], right[side] * last, up[side] * last);
        let corners = [start, start + x, start + y, start + x + y];
        let is_inside = corners.map(|edge| edge >= inside[side]);
        if is_inside == [false; 4] {
            return Cover::Nothing;
        }
        whole &= is_inside == [true; 4];
    }
    if whole { Cover::Whole } else { Cover::Part }
}
