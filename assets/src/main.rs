//! Writes the models and textures of the course into `assets/`: `cargo run -p assets`.

use std::path::Path;

use common::file::write_whole;

fn main() -> anyhow::Result<()> {
    for asset in assets::ASSETS {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(asset.name);
        let bytes = (asset.make)();
        write_whole(&path, &bytes)?;
        println!("{} ({} bytes)", asset.name, bytes.len());
    }
    Ok(())
}
