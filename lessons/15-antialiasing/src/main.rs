//! Draws lesson 15's picture: `cargo run --release -p antialiasing`.
fn main() {}
