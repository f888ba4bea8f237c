//! The lessons' tables of methods, for the pages that list them.

use common::Method;

/// A table of methods.
pub(crate) struct Methods {
    /// Of the table, as its chart is called.
    pub(crate) name: &'static str,
    /// The job that all its methods do.
    pub(crate) job: &'static str,
    /// Name, promise, failure of each.
    pub(crate) rows: fn() -> Vec<[&'static str; 3]>,
}

/// Every table of the course, in the order of the lessons.
pub(crate) const TABLES: &[Methods] = &[
    Methods { name: "01-lines", job: "Set the pixels of a segment", rows: || rows(lines::METHODS) },
    Methods { name: "02-wireframe", job: "Draw a model's edges", rows: || rows(wireframe::METHODS) },
    Methods { name: "03-triangles", job: "Find the pixels of a triangle", rows: || rows(triangles::METHODS) },
    Methods { name: "04-zbuffer", job: "Show the nearest surface", rows: || rows(zbuffer::METHODS) },
    Methods { name: "05-textures", job: "Find the texel of (u, v)", rows: || rows(textures::METHODS) },
    Methods { name: "06-gouraud", job: "Shade smoothly", rows: || rows(gouraud::METHODS) },
    Methods { name: "07-transforms", job: "Compose many rotations", rows: || rows(transforms::METHODS) },
    Methods {
        name: "07-transforms-rotations",
        job: "Turn about an axis",
        rows: || rows(transforms::rotation::ROTATIONS),
    },
    Methods {
        name: "07-transforms-inverses",
        job: "Undo a matrix",
        rows: || rows(transforms::inverse::INVERSES),
    },
    Methods { name: "08-camera", job: "Look at a point", rows: || rows(camera::METHODS) },
    Methods { name: "09-shaders", job: "Call a shader", rows: || rows(shaders::METHODS) },
    Methods { name: "09-shaders-looks", job: "Choose a look", rows: || rows(shaders::SHADERS) },
];

fn rows<F>(table: &'static [Method<F>]) -> Vec<[&'static str; 3]> {
    table.iter().map(|method| [method.name, method.promise, method.failure]).collect()
}

impl Methods {
    /// As a table in Markdown.
    pub(crate) fn markdown(&self) -> String {
        let row = |[name, promise, failure]: [&str; 3]| format!("| `{name}` | {promise} | {failure} |\n");
        let rows: String = (self.rows)().into_iter().map(row).collect();
        format!("| method | what it promises | where it fails |\n|---|---|---|\n{rows}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_breaks_its_table() {
        for table in TABLES {
            for cell in (table.rows)().iter().flatten() {
                assert!(!cell.is_empty() && !cell.contains(['|', '\n']), "{}: {cell}", table.name);
            }
        }
    }
}
