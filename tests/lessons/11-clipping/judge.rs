//! Mission 11: which side of a triangle is seen, and what a plane leaves of a polygon, judged.

mod faults;

use std::process::ExitCode;

use clipping::{ClipVertex, Polygon};
use clipping_tasks::{Clipping, MISSION, given};
use common::{Vec2, Vec4};
use judge::Judge;

const JUDGE: Judge<Clipping> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Clipping = Clipping { facing: clipping::facing, clip };

/// The lesson's clipper, for the mission's corners.
fn clip(polygon: &[given::ClipVertex], plane: Vec4) -> Vec<given::ClipVertex> {
    if polygon.is_empty() {
        return Vec::new();
    }
    let corners: Vec<ClipVertex<Vec2>> =
        polygon.iter().map(|corner| ClipVertex { position: corner.position, varying: corner.uv }).collect();
    let left = clipping::clip(&Polygon::new(&corners), plane);
    left.corners()
        .iter()
        .map(|corner| given::ClipVertex { position: corner.position, uv: corner.varying })
        .collect()
}

fn main() -> ExitCode {
    JUDGE.run()
}
