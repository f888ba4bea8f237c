//! What made-up scenes have in common: an eye at the origin, and corners put where they are to be seen.

use std::f32::consts::SQRT_2;
use std::path::Path;

use common::program::model::DEFAULT_TEXTURE;
use common::{Image, Mat4, Model, Vec2, Vec3};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Wrap};
use perspective::perspective;
use perspective::scene::Loaded;

use crate::{FULL, Scene};

/// Degrees seen from the bottom to the top of the picture, near and far plane: as by default in lesson 13.
const CAMERA: [f32; 3] = [45.0, 0.1, 100.0];
/// tan(45°/2).
const HALF_HEIGHT: f32 = SQRT_2 - 1.0;

/// Towards the light, as by default in lesson 13.
pub(crate) fn light() -> Vec3 {
    Vec3::new(0.4, 0.8, 0.8).normalize()
}

/// From eye space to clip space.
pub(crate) fn projection(size: [u16; 2]) -> Mat4 {
    let [fov, near, far] = CAMERA;
    let aspect = f32::from(size[0]) / f32::from(size[1]);
    perspective(fov, aspect, near, far).expect("there is such a camera")
}

/// A model with its texture, and all that is smaller of that, ready to be drawn. The texture is repeated only where the
/// model wants it to be: nobody should pay for what a scene does not need.
pub(crate) fn object(model: Model, normals: Vec<[Vec3; 3]>, texture: Image) -> Filterable {
    let inside = |uv: &Vec2| uv.cmpge(Vec2::ZERO).all() && uv.cmple(Vec2::ONE).all();
    let wrap = if model.face_uvs().flatten().all(|uv| inside(&uv)) { Wrap::Clamp } else { Wrap::Repeat };
    let box_linear = common::Method::find(MIPMAPS, "box-linear").expect("it is a row of the table");
    let loaded = Loaded { model, normals, texture, wrap: textures::Wrap::default() };
    Filterable::new(loaded, box_linear.run, wrap)
}

/// The head's texture, 1024×1024.
pub(crate) fn head_texture() -> Image {
    read(DEFAULT_TEXTURE)
}

/// A picture of the course's.
pub(crate) fn read(path: &str) -> Image {
    Image::read(Path::new(path)).unwrap_or_else(|error| panic!("{error}"))
}

/// A corner as it is to be seen.
#[derive(Clone, Copy)]
pub(crate) struct Corner {
    /// Its place in the picture, in pixels from the bottom left.
    pub(crate) at: Vec2,
    /// One over its depth: what is linear in the picture where the surface is flat.
    pub(crate) inverse_depth: f32,
    /// Its texture coordinates.
    pub(crate) uv: Vec2,
    /// Its normal, of any length.
    pub(crate) normal: Vec3,
}

impl Corner {
    /// Where an eye at the origin that looks along −z sees it there.
    fn position(&self, size: Vec2) -> Vec3 {
        let aspect = Vec2::new(size.x / size.y, 1.0);
        let ndc = 2.0 * self.at / size - 1.0;
        (ndc * aspect * HALF_HEIGHT).extend(-1.0) / self.inverse_depth
    }
}

/// The corners and triangles of a made-up scene.
#[derive(Default)]
pub(crate) struct Stage {
    pub(crate) corners: Vec<Corner>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Stage {
    /// Adds a flat or folded four-sided surface in two triangles, its corners counterclockwise.
    pub(crate) fn add_square(&mut self, corners: [Corner; 4]) {
        let [a, b, c, d] = [0, 1, 2, 3].map(|n| self.corners.len() as u32 + n);
        self.corners.extend(corners);
        self.triangles.extend([[a, b, c], [a, c, d]]);
    }

    /// The scene, with the head's texture.
    pub(crate) fn scene(self) -> Scene {
        let Self { corners, triangles } = self;
        let size = Vec2::new(FULL[0].into(), FULL[1].into());
        let positions = corners.iter().map(|corner| corner.position(size)).collect();
        let uvs = corners.iter().map(|corner| corner.uv).collect();
        let normals = triangles
            .iter()
            .map(|triangle| triangle.map(|corner| corners[corner as usize].normal.normalize()));
        let normals = normals.collect();
        let model = Model::from_triangles(positions, triangles.clone())
            .and_then(|model| model.with_uvs(uvs, triangles))
            .unwrap_or_else(|error| panic!("{error}"));
        Scene {
            size: FULL,
            object: object(model, normals, head_texture()),
            to_clip: projection(FULL),
            light: light(),
        }
    }
}
