//! What an index buffer and culling save in lesson 11.

use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh, facing, render};
use common::file::write_whole;
use common::{Attributes, Bounds, IVec2, Mat4, Model, Vec3, Vec4};
use perspective::{perspective, view};
use shaders::shader::{Fragment, Shader};
use shaders::target::Target;

use super::models::scene_model;
use super::{Comparison, Run, scene};
use crate::lessons::clipping::figures;

pub(super) const COMPARISON: Comparison =
    Comparison { name: "11-clipping-savings", works: |_| Ok(Vec::new()), measure, draw: |_| Ok(Vec::new()) };

/// The side of the picture whose fragments are counted.
const SIDE: i32 = 800;

/// A model before a camera, each fragment of which is whether its triangle faces away.
struct Sides<'a> {
    model: &'a Model,
    to_clip: Mat4,
}

impl Shader for Sides<'_> {
    type Constant = bool;
    type Varying = ();
    type Output = bool;

    fn position(&self, vertex: usize) -> Vec4 {
        self.to_clip * self.model.positions()[vertex].extend(1.0)
    }

    fn triangle(&self, face: usize) -> Option<bool> {
        let corners = self.model.triangles()[face].map(|vertex| self.position(vertex as usize));
        Some(facing(corners) <= 0.0)
    }

    fn corner(&self, _: usize, _: usize) {}

    fn fragment(&self, away: bool, _: Fragment<()>) -> Option<bool> {
        Some(away)
    }
}

/// Counts the fragments that pass the depth test, of triangles that face the eye and of others.
struct Counting {
    depths: Vec<f32>,
    fragments: [usize; 2],
}

impl Target<bool> for Counting {
    fn bounds(&self) -> Bounds {
        Bounds { min: IVec2::ZERO, max: IVec2::splat(SIDE - 1) }
    }

    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        depth < self.depths[(y * SIDE + x) as usize]
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, away: bool) {
        self.depths[(y * SIDE + x) as usize] = depth;
        self.fragments[usize::from(away)] += 1;
    }

    fn clear(&mut self) {
        *self = Self::new();
    }
}

impl Counting {
    fn new() -> Self {
        Self { depths: vec![1.0; (SIDE * SIDE) as usize], fragments: [0; 2] }
    }
}

/// The shares, in percent, of a model's triangles and of its fragments that face away.
fn away(model: &Model, mesh: &Mesh, to_clip: Mat4) -> [f64; 2] {
    let shader = Sides { model, to_clip };
    let mut target = Counting::new();
    render(&shader, mesh, Cull::None, Clipping::GuardBand, &mut target);
    let [towards, away] = target.fragments;
    let triangles = (0..mesh.faces.len()).filter(|&face| shader.triangle(face) == Some(true)).count();
    let share = |part: usize, all: usize| 100.0 * part as f64 / all as f64;
    [share(triangles, mesh.faces.len()), share(away, towards + away)]
}

/// Counts, and writes them.
fn measure(run: &mut Run) -> anyhow::Result<()> {
    let (_, model, _) = scene_model()?;
    let normals = gouraud::corner_normals(model);
    let vertices = |needs| indexed(model, &normals, needs).vertices.len();
    let all = Attributes { normals: true, uvs: true };
    let mesh = indexed(model, &normals, all);
    let mut used: Vec<u32> = model.triangles().as_flattened().to_vec();
    used.sort_unstable();
    used.dedup();
    let mut rows: Vec<(&str, String)> = [
        ("triangles", model.triangles().len()),
        ("positions", model.positions().len()),
        ("positions_used", used.len()),
        ("corners", 3 * model.triangles().len()),
        ("vertices", vertices(all)),
        ("vertices_untextured", vertices(Attributes { normals: true, uvs: false })),
    ]
    .map(|(what, number)| (what, number.to_string()))
    .to_vec();
    // The camera of lesson 9: a length of 1 at the centre takes up its zoom, which is 0.4 of the picture.
    let distance = scene::EYE.length();
    let fov = 2.0 * (0.5 / 0.4 / distance).atan().to_degrees();
    let nine = perspective(fov, 1.0, 0.1, 100.0)?
        * view(scene::EYE, Vec3::ZERO, Vec3::Y).ok_or_else(|| anyhow::anyhow!("the eye is at the centre"))?;
    let eleven = figures::to_clip(45.0, figures::EYE, figures::CENTER)?;
    for (names, to_clip) in [
        (["triangles_away_9_%", "fragments_away_9_%"], nine),
        (["triangles_away_11_%", "fragments_away_11_%"], eleven),
    ] {
        let shares = away(model, &mesh, to_clip).map(|share| format!("{share:.0}"));
        rows.extend(names.into_iter().zip(shares));
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["what", "number"])?;
    for (what, number) in &rows {
        writer.write_record([*what, number])?;
    }
    Ok(write_whole(&run.folder.join(COMPARISON.name).with_extension("csv"), &writer.into_inner()?)?)
}
