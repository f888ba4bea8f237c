//! The lessons' pictures, drawn by the lessons' programs and brought to one size.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, ensure};
use common::Image;

/// Width and height of the pictures, in pixels.
const SIZE: u16 = 400;

/// File name, lesson and flags of each picture.
const PICTURES: &[(&str, &str, &[&str])] = &[
    ("01-lines.png", "lines", &[]),
    ("02-wireframe.png", "wireframe", &[]),
    ("03-triangles.png", "triangles", &[]),
    ("03-triangles-random.png", "triangles", &["--model", "--fill", "random"]),
    ("03-triangles-flat.png", "triangles", &["--model"]),
    ("04-zbuffer.png", "zbuffer", &[]),
    ("05-textures.png", "textures", &[]),
    ("06-gouraud.png", "gouraud", &[]),
    ("07-transforms.png", "transforms", &[]),
    ("08-camera.png", "camera", &[]),
    ("09-shaders.png", "shaders", &[]),
    ("head.png", "shaders", &["--shader", "gouraud-texture", "--eye", "1,0.3,2.2", "--light", "0.2,0.5,1"]),
];

/// Draws every picture into a folder, which must exist.
pub(crate) fn draw_all(folder: &Path) -> anyhow::Result<()> {
    for (name, lesson, flags) in PICTURES {
        draw(lesson, flags)?.write(&folder.join(name))?;
        println!("{name}");
    }
    Ok(())
}

/// The picture that a lesson's program draws, made larger or smaller.
fn draw(lesson: &str, flags: &[&str]) -> anyhow::Result<Image> {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("picture.png");
    let cargo = std::env::var_os("CARGO").unwrap_or("cargo".into());
    let run = ["run", "--quiet", "--package", lesson, "--", "--quiet", "--out"];
    let output = Command::new(cargo)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(run)
        .arg(&path)
        .args(flags)
        .output()
        .context("cannot start cargo")?;
    ensure!(output.status.success(), "{lesson}: {}", String::from_utf8_lossy(&output.stderr).trim());
    Ok(Image::read(&path)?.scale(SIZE, SIZE))
}

#[cfg(test)]
mod tests {
    use checks::picture::faults;

    use super::*;

    /// From lesson 7 on sines and fused multiplications differ between platforms by a rounding, which may give
    /// a pixel at a side to its neighbour: one in 2,000 may differ.
    #[test]
    fn the_committed_pictures_are_what_the_lessons_draw() {
        let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("pages/pictures");
        for (name, lesson, flags) in PICTURES {
            let allowed = if *name < "07" { 0 } else { usize::from(SIZE) * usize::from(SIZE) / 2000 };
            let out_of_date = match Image::read(&committed.join(name)) {
                Ok(picture) => faults(&picture, &draw(lesson, flags).unwrap(), 1).len() > allowed,
                Err(_) => true,
            };
            assert!(!out_of_date, "{name} is out of date: run cargo run -p book -- pictures, and look at it");
        }
    }
}
