//! All of mission 14.
use common::Color;

pub use blending_given::{Compare, DepthTest, Kept, Layer, StencilOp, StencilTest, draw};

/// Weighted sums of 255ths.
pub fn over(source: Color, destination: Color) -> Color {
    let (alpha, rest) = (u32::from(source.a), 255 - u32::from(source.a));
    let sum = |a: u8, weight: u32, b: u8| ((u32::from(a) * weight + u32::from(b) * rest + 127) / 255) as u8;
    Color {
        r: sum(source.r, alpha, destination.r),
        g: sum(source.g, alpha, destination.g),
        b: sum(source.b, alpha, destination.b),
        a: sum(source.a, 255, destination.a),
    }
}

/// Stencil, then depth; then the operation that belongs to how that ended.
pub fn test(stencil: &StencilTest, depth: &DepthTest, fragment: f32, kept: Kept) -> (bool, Kept) {
    let mask = stencil.read_mask;
    let marked = stencil.function.holds(stencil.reference & mask, kept.stencil & mask);
    let seen = marked && depth.function.holds(fragment, kept.depth);
    let operation = match (marked, seen) {
        (false, _) => stencil.fail,
        (true, false) => stencil.depth_fail,
        (true, true) => stencil.pass,
    };
    let changed = operation.apply(kept.stencil, stencil.reference);
    let value = kept.stencil & !stencil.write_mask | changed & stencil.write_mask;
    let depth = if seen && depth.write { fragment } else { kept.depth };
    (seen, Kept { stencil: value, depth })
}
