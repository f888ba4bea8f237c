//! Triangles with normals and texture coordinates, and their OBJ file.

use std::fmt::Write;

use glam::{DVec2, DVec3};

/// The places of a corner's position, texture coordinate and normal in the mesh's lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Index into [`Mesh::positions`].
    pub position: usize,
    /// Index into [`Mesh::uvs`].
    pub uv: usize,
    /// Index into [`Mesh::normals`].
    pub normal: usize,
}

/// A triangle mesh. Corners share positions even where the texture has a seam.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Points, y up; a model's lie within [−1, 1]³.
    pub positions: Vec<DVec3>,
    /// Texture coordinates, v up; within [0, 1]² unless the texture is to be repeated.
    pub uvs: Vec<DVec2>,
    /// Unit vectors that point outwards.
    pub normals: Vec<DVec3>,
    /// Corners counterclockwise, seen from outside.
    pub triangles: Vec<[Corner; 3]>,
}

impl Mesh {
    /// The text of the mesh's OBJ file, numbers rounded to 5 decimals.
    #[must_use]
    pub fn to_obj(&self) -> String {
        let mut text = String::from("# Made by `cargo run -p assets`.\n");
        // Writing to a string cannot fail.
        for p in &self.positions {
            let _ = writeln!(text, "v {} {} {}", number(p.x), number(p.y), number(p.z));
        }
        for uv in &self.uvs {
            let _ = writeln!(text, "vt {} {}", number(uv.x), number(uv.y));
        }
        for n in &self.normals {
            let _ = writeln!(text, "vn {} {} {}", number(n.x), number(n.y), number(n.z));
        }
        for triangle in &self.triangles {
            text.push('f');
            for Corner { position, uv, normal } in triangle {
                let _ = write!(text, " {}/{}/{}", position + 1, uv + 1, normal + 1);
            }
            text.push('\n');
        }
        text
    }
}

/// Five decimals, less the zeros at their end.
fn number(value: f64) -> String {
    let text = format!("{value:.5}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_are_short() {
        let texts = [0.0, -0.000_001, 1.0, -0.5, 0.123_456, 10.0].map(number);
        assert_eq!(texts, ["0", "0", "1", "-0.5", "0.12346", "10"]);
    }
}
