//! What a surface brings to the light besides its colour, as a table.

use std::path::{Path, PathBuf};

use clipping::{Cull, Drawn, Mesh};
use common::program::UsageError;
use common::{Color, Format, Image, Method};

use crate::normal_map::ObjectNormals;
use crate::reflection::{Halfway, PointLit};
use crate::scene::Scene;
use crate::shader::{PerPixel, draw};
use crate::specular_map::Shining;
use crate::surface::{Smooth, Surface};
use crate::tangent::TangentNormals;
use crate::toon;

/// The maps of a surface. A look reads only those that it needs.
pub struct Maps {
    /// Normals, in the space that the look takes them for.
    pub normals: Image,
    /// What of a highlight is shown, in grey.
    pub shine: Image,
}

impl Default for Maps {
    /// Of one texel each, and without effect: normals in tangent space that do not lean, and all of each highlight.
    fn default() -> Self {
        let one = |color| {
            let mut image = Image::new(1, 1, Format::Rgb);
            image.set(0, 0, color);
            image
        };
        Self { normals: one(Color::rgb(128, 128, 255)), shine: one(Color::WHITE) }
    }
}

/// What a surface looks like, lit at each pixel by Blinn's model.
pub struct Look {
    /// The head's map of normals for this look, where it reads one.
    pub normals: Option<&'static str>,
    /// The head's map of highlights, where it reads one.
    pub shine: Option<&'static str>,
    /// Draws a scene with maps, its model handed over as a mesh, into a black picture.
    pub draw: fn(&Scene, &Maps, &Mesh, Cull, &mut Image) -> Drawn,
}

const OBJECT_NORMALS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/head-normals.png");
const TANGENT_NORMALS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/head-tangents.png");
const SHINE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/head-shine.png");

/// The looks, from the plain one on.
pub const LOOKS: &[Method<Look>] = &[
    Method {
        name: "plain",
        run: Look {
            normals: None,
            shine: None,
            draw: |scene, _, mesh, cull, image| lit(scene, Smooth, mesh, cull, image),
        },
        promise: "the corners' normals, interpolated; reads no map",
        failure: "what is smaller than a triangle is not there",
    },
    Method {
        name: "object-normals",
        run: Look {
            normals: Some(OBJECT_NORMALS),
            shine: None,
            draw: |scene, maps, mesh, cull, image| {
                lit(scene, ObjectNormals(&maps.normals), mesh, cull, image)
            },
        },
        promise: "each texel a normal of the fine shape, whatever the triangles; interpolates none",
        failure: "wrong where two sides share a patch of the map, as the ears do, and where a surface bends",
    },
    Method {
        name: "tangent-normals",
        run: Look {
            normals: Some(TANGENT_NORMALS),
            shine: None,
            draw: |scene, maps, mesh, cull, image| {
                lit(scene, TangentNormals(&maps.normals), mesh, cull, image)
            },
        },
        promise: "each texel a normal as seen from its triangle; mirrored patches are right, too",
        failure: "right for the mesh that it was made for; plain where (u, v) do not tell a direction",
    },
    Method {
        name: "specular-map",
        run: Look {
            normals: Some(TANGENT_NORMALS),
            shine: Some(SHINE),
            draw: |scene, maps, mesh, cull, image| {
                let surface = TangentNormals(&maps.normals);
                lit(scene, Shining { surface, map: &maps.shine }, mesh, cull, image)
            },
        },
        promise: "tangent-normals, and each texel's own share of the highlight: lips shine, a beard does not",
        failure: "as tangent-normals",
    },
    Method {
        name: "toon",
        run: Look {
            normals: None,
            shine: None,
            draw: |scene, _, mesh, cull, image| toon::draw(scene, mesh, cull, image),
        },
        promise: "light in four steps inside a black outline; reads no map",
        failure: "the mesh is drawn twice; no outline where the model lies against the picture's border or has a hole",
    },
];

fn lit(scene: &Scene, surface: impl Surface, mesh: &Mesh, cull: Cull, image: &mut Image) -> Drawn {
    draw(&PerPixel::<PointLit<Halfway>, _>::new(scene, surface), mesh, cull, image)
}

/// `--look`, `--normal-map` and `--specular-map`.
#[derive(Clone, Debug, clap::Args)]
pub struct LookFlags {
    /// What the surface brings besides its colour, a row of `looks`; all but plain are lit by blinn-phong at each pixel
    #[arg(long, value_name = "NAME", default_value = "plain")]
    pub look: String,

    /// Normals for the look, .tga or .png, in the space that it takes them for [default: the head's]
    #[arg(long, value_name = "FILE")]
    pub normal_map: Option<PathBuf>,

    /// What each part shows of a highlight, in grey, .tga or .png [default: the head's]
    #[arg(long, value_name = "FILE")]
    pub specular_map: Option<PathBuf>,
}

impl LookFlags {
    /// Reads the maps that a look needs: those that were asked for, or the head's where the model is the course's own.
    ///
    /// # Errors
    /// Where one cannot be read, or another model has none.
    pub fn read(&self, look: &Look, own_model: bool) -> anyhow::Result<Maps> {
        let Maps { normals, shine } = Maps::default();
        let read =
            |needed: Option<&str>, given: &Option<PathBuf>, flag: &str| -> anyhow::Result<Option<Image>> {
                let Some(head) = needed else { return Ok(None) };
                let file = match given {
                    Some(file) => file,
                    None if own_model => Path::new(head),
                    None => {
                        let look = &self.look;
                        return Err(UsageError(format!(
                            "--look {look}: the head's map fits no other model; give one by --{flag} FILE"
                        ))
                        .into());
                    }
                };
                Ok(Some(Image::read(file)?))
            };
        Ok(Maps {
            normals: read(look.normals, &self.normal_map, "normal-map")?.unwrap_or(normals),
            shine: read(look.shine, &self.specular_map, "specular-map")?.unwrap_or(shine),
        })
    }
}
