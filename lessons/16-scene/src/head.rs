//! The head in levels.

use std::path::Path;
use std::sync::Arc;

use common::{Attributes, Model};
use gouraud::corner_normals;

use crate::levels::Levels;
use crate::mesh::{Mesh, Paint};
use crate::shapes::Shape;

/// The head in so many triangles, a file among the assets.
pub struct Stage {
    /// The file's name.
    pub file: &'static str,
    /// How many triangles it has.
    pub triangles: usize,
    /// No point of it is farther than this from the finest, and no point of that from it, in the model's units: the head is
    /// 2 units high. Measured to a tenth of it, and that tenth added. Of the finest itself it is 0.
    pub distance: f32,
}

/// The levels of the head, each of about twice the triangles of the last.
// ANCHOR: stages
pub const STAGES: &[Stage] = &[
    Stage { file: "head-low.obj", triangles: 638, distance: 0.096 },
    Stage { file: "head-1288.obj", triangles: 1288, distance: 0.053 },
    Stage { file: "head-2688.obj", triangles: 2688, distance: 0.023 },
    Stage { file: "head.obj", triangles: 5888, distance: 0.009 },
    Stage { file: "head-11488.obj", triangles: 11_488, distance: 0.0056 },
    Stage { file: "head-22688.obj", triangles: 22_688, distance: 0.0 },
];
// ANCHOR_END: stages

impl Stage {
    /// Its mesh.
    ///
    /// # Errors
    /// Where the file cannot be read.
    pub fn mesh(&self, paint: &Paint) -> anyhow::Result<Mesh> {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets")).join(self.file);
        let model = Model::read(&path, Attributes { normals: true, uvs: true })?;
        Ok(Mesh::new(&Shape::of(&model, &corner_normals(&model)), paint.clone()))
    }
}

/// The head, in all its levels.
///
/// # Errors
/// Where a file cannot be read.
pub fn head(paint: &Paint) -> anyhow::Result<Arc<Levels>> {
    let level = |stage: &Stage| Ok((stage.mesh(paint)?, stage.distance));
    Ok(Levels::new(STAGES.iter().map(level).collect::<anyhow::Result<_>>()?))
}
