//! The first program: a black picture of 100×100 pixels, one of them red.
//!
//! Run it with `cargo run -p common --example pixel`; it writes `out/pixel.png`.

// ANCHOR: pixel
use common::{Color, Format, Image};
use std::path::Path;

fn main() -> anyhow::Result<()> {
    let mut image = Image::new(100, 100, Format::Rgb);
    image.set(52, 41, Color::RED);
    std::fs::create_dir_all("out")?;
    image.write(Path::new("out/pixel.png"))?;
    Ok(())
}
// ANCHOR_END: pixel
