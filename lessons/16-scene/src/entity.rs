//! An entity: a mesh at its place in the world.

use std::sync::Arc;

use common::{Mat3, Mat4, Vec3};
use transforms::affine::model;
use transforms::normal_matrix;

use crate::frustum::{ROUNDING, Sphere};
use crate::levels::Levels;

/// A mesh, which others may share, and where it stands.
// ANCHOR: entity
#[derive(Clone)]
pub struct Entity {
    /// The mesh, in one or several resolutions.
    pub levels: Arc<Levels>,
    /// Where its origin is in the world.
    pub position: Vec3,
    /// How it is turned, in degrees: about z first, then x, then y.
    pub degrees: Vec3,
    /// How large it is along its own axes. A negative number mirrors it.
    pub scale: Vec3,
    /// Its alpha, times that of its colours, from 0 to 1.
    pub alpha: f32,
}
// ANCHOR_END: entity

impl Entity {
    /// At the origin, as the mesh is.
    #[must_use]
    pub fn new(levels: Arc<Levels>) -> Self {
        Self { levels, position: Vec3::ZERO, degrees: Vec3::ZERO, scale: Vec3::ONE, alpha: 1.0 }
    }

    /// From the model's space to the world: T·Ry·Rx·Rz·S.
    #[must_use]
    pub fn to_world(&self) -> Mat4 {
        model(self.position, self.degrees, self.scale)
    }

    /// What turns normals likewise, but for their length; `None` where it is flat.
    #[must_use]
    pub fn normals_to_world(&self) -> Option<Mat3> {
        // Of a scale of 10¹³ the determinant is no `f32`; lengths do not matter here.
        let scale = self.scale / self.scale.abs().max_element();
        normal_matrix(&model(Vec3::ZERO, self.degrees, scale))
    }

    /// A sphere in the world that it is within, however its vertices are rounded: turns leave lengths alone, and the largest
    /// scale along an axis is the largest there is.
    // ANCHOR: bounds
    #[must_use]
    pub fn bounds(&self) -> Sphere {
        let (center, radius) = self.levels.bounds();
        let largest = self.scale.abs().max_element();
        let rounding =
            ROUNDING * (self.position.abs().max_element() + 2.0 * largest * (center.length() + radius));
        let center = self.to_world().transform_point3(center);
        Sphere { center, radius: radius * largest + rounding }
    }
    // ANCHOR_END: bounds

    /// Whether it is mirrored: its triangles run the other way round.
    #[must_use]
    pub fn is_mirrored(&self) -> bool {
        self.scale.to_array().iter().filter(|&&scale| scale < 0.0).count() % 2 == 1
    }

    /// Whether nothing is seen through it.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.alpha >= 1.0 && self.levels.finest().is_opaque()
    }
}

#[cfg(test)]
mod tests {
    use common::Color;

    use super::*;
    use crate::mesh::{Mesh, Paint};
    use crate::shapes::sphere;

    fn placed(scale: Vec3) -> Entity {
        let sphere = Levels::one(Mesh::new(&sphere(7, 9), Paint::Color(Color::RED)));
        let (position, degrees) = (Vec3::new(3.0, -20.0, 0.7), Vec3::new(25.0, -70.0, 130.0));
        Entity { position, degrees, scale, ..Entity::new(sphere) }
    }

    /// Whatever the scale, normals point out of the surface and stand upright on it: on a side of a triangle in the plane that
    /// touches the sphere, as it is placed.
    #[test]
    fn normals_stay_upright_and_point_outwards() {
        for scale in [[1.0, 1.0, 1.0], [2.0, 0.1, 5.0], [-1.0, 2.0, 3.0], [-1.0, -2.0, -0.3]] {
            for size in [1.0, 1e-15, 1e15] {
                let entity = placed(Vec3::from(scale) * size);
                let turns = entity.normals_to_world().unwrap();
                let to_world = entity.to_world();
                let side = |v: Vec3| (to_world.transform_vector3(v / size)).as_dvec3();
                for vertex in sphere(7, 9).vertices {
                    let normal = (turns * vertex.normal).as_dvec3().normalize();
                    let along = vertex.normal.any_orthonormal_pair();
                    for tangent in [along.0, along.1].map(|v| side(v).normalize()) {
                        assert!(normal.dot(tangent).abs() < 1e-5, "{scale:?} {size}");
                    }
                    assert!(normal.dot(side(vertex.position)) > 0.0, "{scale:?} {size}");
                }
            }
        }
    }

    #[test]
    fn a_scale_of_0_flattens_and_an_odd_number_of_negative_ones_mirrors() {
        for scale in [[0.0, 1.0, 1.0], [1.0, -0.0, 3.0], [0.0; 3], [f32::NAN, 1.0, 1.0]] {
            assert_eq!(placed(scale.into()).normals_to_world(), None, "{scale:?}");
        }
        for (scale, mirrored) in
            [([1.0, 2.0, 3.0], false), ([-1.0, 2.0, 3.0], true), ([-1.0, -2.0, 3.0], false)]
        {
            assert_eq!(placed(scale.into()).is_mirrored(), mirrored, "{scale:?}");
        }
        assert!(placed(Vec3::splat(-2.0)).is_mirrored());
    }
}
