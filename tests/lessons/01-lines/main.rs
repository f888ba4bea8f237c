//! Lesson 1: what its methods draw, where they fail, what its program is asked.

mod properties;
mod snapshots;
mod stability;
mod usage;

/// What is plotted: x, y and coverage, in the order in which it comes.
fn visited(draw: impl FnOnce(&mut dyn FnMut(i32, i32, u8))) -> Vec<(i32, i32, u8)> {
    let mut pixels = Vec::new();
    draw(&mut |x, y, coverage| pixels.push((x, y, coverage)));
    pixels
}

/// The places of pixels.
fn places(pixels: &[(i32, i32, u8)]) -> Vec<(i32, i32)> {
    pixels.iter().map(|&(x, y, _)| (x, y)).collect()
}
