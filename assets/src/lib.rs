//! Makes every model and texture of the course; nothing in this folder comes from elsewhere.
//!
//! | module | what it makes |
//! |---|---|
//! | [`mesh`] | [`Mesh`](mesh::Mesh): triangles with normals and texture coordinates, written as OBJ |
//! | [`sphere`] | `sphere.obj`, 5,000 triangles |
//! | [`cube`] | `cube.obj`, the whole texture on each face |
//! | [`torus_knot`] | `torus-knot.obj`, a knotted tube |
//! | [`head`] | `head.obj` and `head.tga`, the face of the course; `head-low.obj`, the same in few triangles; its maps |
//! | [`wood`] | `crate.png`, a painted wooden box |
//! | [`fern`] | `fern.png`, a frond, cut out by its alpha |
//! | [`square`] | `square.obj`, two triangles to carry a picture |
//! | [`floor`] | `floor.obj`, a plane to the horizon, `slabs.obj`, the same in fewer pieces, and `checks.png` for both |
//!
//! The same bytes come out on every platform: sines come from `libm`, square roots and the four operations
//! are exact by IEEE 754, randomness is seeded. A test makes everything again and compares.

pub mod cube;
pub mod fern;
pub mod floor;
pub mod head;
pub mod mesh;
pub mod sphere;
pub mod square;
pub mod torus_knot;
pub mod wood;

use common::Image;
use common::file::Encoding;

/// A file of this folder: its name and its bytes.
pub struct Asset {
    /// File name, as `sphere.obj`.
    pub name: &'static str,
    /// Makes its bytes.
    pub make: fn() -> Vec<u8>,
}

/// Every file that this crate makes.
pub const ASSETS: &[Asset] = &[
    Asset { name: "sphere.obj", make: || sphere::sphere(51, 50).to_obj().into_bytes() },
    Asset { name: "cube.obj", make: || cube::cube().to_obj().into_bytes() },
    Asset { name: "torus-knot.obj", make: || torus_knot::torus_knot(240, 12).to_obj().into_bytes() },
    Asset { name: "head.obj", make: || head::model().to_obj().into_bytes() },
    Asset { name: "head.tga", make: || head::texture().encode(Encoding::TgaRle).expect("it has pixels") },
    Asset { name: "head-low.obj", make: || head::low_model().to_obj().into_bytes() },
    Asset { name: "head-1288.obj", make: || head::model_of(1000).to_obj().into_bytes() },
    Asset { name: "head-2688.obj", make: || head::model_of(2400).to_obj().into_bytes() },
    Asset { name: "head-11488.obj", make: || head::model_of(11_200).to_obj().into_bytes() },
    Asset { name: "head-22688.obj", make: || head::model_of(22_400).to_obj().into_bytes() },
    Asset { name: "head-normals.png", make: || png(&head::normal_map(&head::NORMALS)) },
    Asset { name: "head-tangents.png", make: || png(&head::tangent_map(&head::NORMALS)) },
    Asset { name: "head-low-tangents.png", make: || png(&head::low_tangent_map(&head::NORMALS)) },
    Asset { name: "head-shine.png", make: || png(&head::shine_map()) },
    Asset { name: "floor.obj", make: || floor::floor().to_obj().into_bytes() },
    Asset { name: "slabs.obj", make: || floor::slabs().to_obj().into_bytes() },
    Asset { name: "checks.png", make: || png(&floor::checks()) },
    Asset { name: "crate.png", make: || png(&wood::crate_side(256)) },
    Asset { name: "square.obj", make: || square::square().to_obj().into_bytes() },
    Asset { name: "fern.png", make: || png(&fern::frond(256)) },
];

fn png(image: &Image) -> Vec<u8> {
    image.encode(Encoding::Png).expect("it has pixels")
}
