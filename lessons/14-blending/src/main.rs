//! Draws lesson 14's pictures: `cargo run --release -p blending`.
fn main() {}
