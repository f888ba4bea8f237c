//! A scene as a file, for painters that are not written in Rust.

use std::io::{BufWriter, Write};
use std::path::Path;

use anyhow::Context;
use filtering::Wrap;
use speed_scenes::Scene;

use crate::buffers::{Corner, buffers};

/// Writes a scene, all numbers in the machine's own order of bytes: width, height, how many vertices and indices there
/// are, the texture's width and height and whether it is repeated, 0 or 1, as `u32`; the matrix to clip space by columns and the direction of the light,
/// as `f32`; each vertex's position, normal, u and v, as `f32`; the indices of the triangles' corners, as `u32`; the
/// texture in rows from the bottom, four bytes a texel.
///
/// # Errors
/// Where it cannot be written.
pub(crate) fn write(scene: &Scene, path: &Path) -> anyhow::Result<()> {
    let (corners, indices) = buffers(scene);
    let texture = scene.surface().texture.base();
    let file = std::fs::File::create(path).with_context(|| path.display().to_string())?;
    let mut file = BufWriter::new(file);
    let [width, height] = scene.size.map(u32::from);
    let [columns, rows] = [texture.width(), texture.height()];
    let repeats = u32::from(scene.surface().texture.wrap == Wrap::Repeat);
    let sizes =
        [width, height, corners.len() as u32, indices.len() as u32, columns as u32, rows as u32, repeats];
    for number in sizes {
        file.write_all(&number.to_ne_bytes())?;
    }
    let mut floats =
        |floats: &[f32]| floats.iter().try_for_each(|float| file.write_all(&float.to_ne_bytes()));
    floats(&scene.to_clip.to_cols_array())?;
    floats(&scene.light.to_array())?;
    for Corner { position, normal, uv } in corners {
        floats(&position.to_array())?;
        floats(&normal.to_array())?;
        floats(&uv.to_array())?;
    }
    for index in indices {
        file.write_all(&index.to_ne_bytes())?;
    }
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        let color = texture.texel(i, j);
        file.write_all(&[color.r, color.g, color.b, color.a])?;
    }
    Ok(file.flush()?)
}
