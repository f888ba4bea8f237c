//! Mission 14: a colour over another, and the tests of a fragment, judged.

mod faults;

use std::process::ExitCode;

use blending_tasks::{Blending, MISSION, given};
use judge::Judge;

const JUDGE: Judge<Blending> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Blending = Blending { over: blending::over, test };

/// The lesson's tests, for the mission's.
fn test(
    stencil: &given::StencilTest,
    depth: &given::DepthTest,
    fragment: f32,
    kept: given::Kept,
) -> (bool, given::Kept) {
    let stencil = blending::StencilTest {
        function: compare(stencil.function),
        reference: stencil.reference,
        read_mask: stencil.read_mask,
        write_mask: stencil.write_mask,
        fail: operation(stencil.fail),
        depth_fail: operation(stencil.depth_fail),
        pass: operation(stencil.pass),
    };
    let depth = blending::DepthTest { function: compare(depth.function), write: depth.write };
    let kept = blending::Kept { stencil: kept.stencil, depth: kept.depth };
    let (passes, blending::Kept { stencil, depth }) = blending::test(&stencil, &depth, fragment, kept);
    (passes, given::Kept { stencil, depth })
}

fn compare(function: given::Compare) -> blending::Compare {
    match function {
        given::Compare::Always => blending::Compare::Always,
        given::Compare::Never => blending::Compare::Never,
        given::Compare::Less => blending::Compare::Less,
        given::Compare::Lequal => blending::Compare::Lequal,
        given::Compare::Equal => blending::Compare::Equal,
        given::Compare::Gequal => blending::Compare::Gequal,
        given::Compare::Greater => blending::Compare::Greater,
        given::Compare::Notequal => blending::Compare::Notequal,
    }
}

fn operation(operation: given::StencilOp) -> blending::StencilOp {
    match operation {
        given::StencilOp::Keep => blending::StencilOp::Keep,
        given::StencilOp::Zero => blending::StencilOp::Zero,
        given::StencilOp::Replace => blending::StencilOp::Replace,
        given::StencilOp::Incr => blending::StencilOp::Incr,
        given::StencilOp::IncrWrap => blending::StencilOp::IncrWrap,
        given::StencilOp::Decr => blending::StencilOp::Decr,
        given::StencilOp::DecrWrap => blending::StencilOp::DecrWrap,
        given::StencilOp::Invert => blending::StencilOp::Invert,
    }
}

fn main() -> ExitCode {
    JUDGE.run()
}
