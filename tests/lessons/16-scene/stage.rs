//! A sphere before a camera, drawn, and its true outline.

use checks::outline::{Ellipse, hull};
use clipping::Cull;
use common::{Color, DMat3, DVec2, DVec3, DVec4, Image, Mat4, Vec3};
use perspective::{frustum, perspective};
use scene::frustum::pixels_per_unit;
use scene::{Counts, Entity, Filtering, Levels, Mesh, Paint, Scene, Shading, Style, Target, render_scene};
use std::sync::Arc;

/// Where a sphere of radius 1 is, and who looks at it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stage {
    pub(crate) position: Vec3,
    pub(crate) degrees: Vec3,
    pub(crate) scale: Vec3,
    pub(crate) projection: Mat4,
    pub(crate) inverse_camera: Mat4,
    pub(crate) size: [u16; 2],
    pub(crate) cull: Cull,
}

/// The paint of all that is drawn here.
pub(crate) const WHITE: Paint = Paint::Color(Color::WHITE);

impl Stage {
    /// At this place in eye space, in a picture of 160 × 120 px that shows 60 degrees of it.
    pub(crate) fn at(x: f32, y: f32, z: f32) -> Self {
        Self {
            position: Vec3::new(x, y, z),
            degrees: Vec3::ZERO,
            scale: Vec3::ONE,
            projection: Mat4::IDENTITY,
            inverse_camera: Mat4::IDENTITY,
            size: [160, 120],
            cull: Cull::Back,
        }
        .seen([160, 120], 60.0)
    }

    /// The same in a picture of that size that shows so many degrees from bottom to top.
    pub(crate) fn seen(self, size: [u16; 2], fov: f32) -> Self {
        let projection = perspective(fov, f32::from(size[0]) / f32::from(size[1]), 0.01, 1e4).unwrap();
        Self { size, projection, ..self }
    }

    /// The same before a camera whose sides on the near plane, at 1, are these.
    pub(crate) fn framed(self, [l, r, b, t]: [f32; 4]) -> Self {
        Self { projection: frustum(l, r, b, t, 1.0, f32::INFINITY).unwrap(), ..self }
    }

    pub(crate) fn entity(&self, levels: &Arc<Levels>) -> Entity {
        let Self { position, degrees, scale, .. } = *self;
        Entity { position, degrees, scale, ..Entity::new(levels.clone()) }
    }

    /// At most so many pixels is a unit of the sphere's space.
    pub(crate) fn pixels_per_unit(&self, levels: &Arc<Levels>) -> f32 {
        let to_clip = self.projection * self.inverse_camera;
        let pixels = pixels_per_unit(&to_clip, &self.entity(levels).bounds(), self.pixels().as_vec2());
        pixels * self.scale.abs().max_element()
    }

    /// Draws it white, without light, on black.
    pub(crate) fn drawn(&self, levels: &Arc<Levels>) -> (Image, Counts) {
        let scene = Scene {
            entities: vec![self.entity(levels)],
            lights: Vec::new(),
            background: Color::BLACK,
            style: Style { shading: Shading::Unlit, filter: Filtering::Nearest, cull: self.cull },
        };
        let mut target = Target::new(self.size[0], self.size[1]);
        let counts = render_scene(&scene, &mut target, &self.projection, &self.inverse_camera);
        (target.into_picture(), counts)
    }

    fn pixels(&self) -> DVec2 {
        DVec2::from_array(self.size.map(f64::from))
    }

    /// The rows of x, y and w of the matrix from the sphere's space to clip space, in `f64`.
    fn rows(&self) -> [DVec4; 3] {
        let to_clip = self.projection.as_dmat4() * self.inverse_camera.as_dmat4();
        let [x, y, z] = self.degrees.as_dvec3().to_array().map(f64::to_radians);
        let turned = DMat3::from_rotation_y(y) * DMat3::from_rotation_x(x) * DMat3::from_rotation_z(z);
        let columns = turned * DMat3::from_diagonal(self.scale.as_dvec3());
        [0, 1, 3].map(|row| {
            let row = to_clip.row(row);
            (columns.transpose() * row.truncate()).extend(row.dot(self.position.as_dvec3().extend(1.0)))
        })
    }

    /// The true outline; `None` where it reaches the depth of the eye.
    pub(crate) fn outline(&self) -> Option<Ellipse> {
        Ellipse::of(self.rows(), self.pixels())
    }

    /// Whether all of an outline is in the picture.
    pub(crate) fn shows(&self, outline: &Ellipse) -> bool {
        let sides = [
            (DVec2::X, self.pixels().x),
            (DVec2::NEG_X, 0.0),
            (DVec2::Y, self.pixels().y),
            (DVec2::NEG_Y, 0.0),
        ];
        sides.into_iter().all(|(n, end)| outline.reach(n) <= end)
    }

    /// How many pixels the outline of a mesh is off the true one, before it is rounded to pixels.
    pub(crate) fn off(&self, mesh: &Mesh, outline: &Ellipse) -> f64 {
        let [x, y, w] = self.rows();
        let place = |p: &Vec3| {
            let p: DVec3 = p.as_dvec3();
            let p = p.extend(1.0);
            (DVec2::new(x.dot(p), y.dot(p)) / w.dot(p) + 1.0) / 2.0 * self.pixels()
        };
        outline.beyond(&hull(mesh.positions().iter().map(place).collect()))
    }
}
