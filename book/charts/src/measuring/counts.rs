//! What lesson 9's loop does for the head, and how much of that could be left out.

use std::cell::RefCell;
use std::collections::BTreeSet;

use common::{Format, Image, Vec3, Vec4Swizzles};
use shaders::lighting::{Gouraud, Lighting};
use shaders::source::Texture;
use shaders::{Framebuffer, Uniforms};

use super::models::scene_model;
use super::scene::{EYE, Subject};

/// The side of the picture: what one of the four in the lesson's sheet has.
const SIDE: u16 = 400;

/// What the loop asked the shader for.
#[derive(Default)]
struct Counts {
    /// Whether the triangle that is being drawn faces away from the eye.
    away: bool,
    triangles: usize,
    corners: usize,
    /// The corners that differ: position, normal and texture coordinates, by their bits.
    different: BTreeSet<[[u32; 3]; 3]>,
    /// Fragments that were computed, of triangles that face the eye and of others.
    fragments: [usize; 2],
}

/// Gouraud's lighting, which counts.
struct Counting<'a>(&'a RefCell<Counts>);

impl Lighting for Counting<'_> {
    type Constant = ();
    type Varying = f32;

    fn triangle(&self, uniforms: &Uniforms, face: usize) -> Option<()> {
        let mut counts = self.0.borrow_mut();
        counts.away = faces_away(uniforms, face);
        counts.triangles += 1;
        Gouraud.triangle(uniforms, face)
    }

    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> f32 {
        let mut counts = self.0.borrow_mut();
        let [position, normal] = [uniforms.model.position(face, corner), uniforms.normals[face][corner]];
        let uv = uniforms.model.uv(face, corner).extend(0.0);
        counts.corners += 1;
        counts.different.insert([position, normal, uv].map(|v| v.to_array().map(f32::to_bits)));
        Gouraud.corner(uniforms, face, corner)
    }

    fn intensity(&self, (): (), varying: f32) -> f32 {
        let mut counts = self.0.borrow_mut();
        let away = counts.away;
        counts.fragments[usize::from(away)] += 1;
        varying
    }
}

/// Whether a triangle's corners, which are counterclockwise from in front, go clockwise in the picture.
fn faces_away(uniforms: &Uniforms, face: usize) -> bool {
    let [a, b, c] = [0, 1, 2].map(|corner| {
        let at = uniforms.to_clip * uniforms.model.position(face, corner).extend(1.0);
        at.xy() / at.w
    });
    (b - a).perp_dot(c - a) < 0.0
}

/// The counts for the lesson's head under the textured Gouraud shader, as CSV.
pub(super) fn table() -> anyhow::Result<Vec<u8>> {
    let (_, model, texture) = scene_model()?;
    let counts = RefCell::default();
    let subject = Subject::new(model, texture);
    let mut target = Framebuffer::new(Image::new(SIDE, SIDE, Format::Rgb));
    shaders::draw(&subject.seen(Vec3::Z, EYE), Texture, Counting(&counts), &mut target);
    let Counts { triangles, corners, different, fragments: [towards, away], .. } = counts.into_inner();
    let share = |part: usize, all: usize| (100.0 * part as f64 / all as f64).round() as usize;
    let rows = [
        ("triangles", triangles),
        ("positions", model.positions().len()),
        ("corners", corners),
        ("different_corners", different.len()),
        ("fragments", towards + away),
        ("fragments_away", away),
        ("fragments_away_%", share(away, towards + away)),
    ];
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["what", "number"])?;
    for (what, number) in rows {
        writer.write_record([what, &number.to_string()])?;
    }
    Ok(writer.into_inner()?)
}
