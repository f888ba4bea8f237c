//! The pipeline of the assignment that lesson 16 follows, in its own left-handed space and in `f64`: x to the right, y up, z
//! away from the camera, which is at the origin.
//!
//! Nothing here is a product of matrices: a point goes through one step after the other, as the assignment's words name
//! them. [`mirrored`] leads from its space to the course's and back.

use common::{DVec2, DVec3};

/// Where an entity stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// What it is moved by.
    pub position: DVec3,
    /// Euler angles in degrees.
    pub degrees: DVec3,
    /// What it is stretched by along the axes.
    pub scale: DVec3,
}

impl Placement {
    /// At a place, neither turned nor stretched.
    #[must_use]
    pub const fn at(x: f64, y: f64, z: f64) -> Self {
        Self { position: DVec3::new(x, y, z), degrees: DVec3::ZERO, scale: DVec3::ONE }
    }

    /// Where it brings a point of a mesh: stretched, turned about z, about x, about y, moved.
    #[must_use]
    pub fn place(&self, point: DVec3) -> DVec3 {
        self.turn(point * self.scale) + self.position
    }

    /// What it makes of a normal of a mesh, of some length: what stretches a surface along an axis shrinks the normal there.
    #[must_use]
    pub fn normal(&self, normal: DVec3) -> DVec3 {
        self.turn(normal / self.scale)
    }

    /// About z from x to y, then about x from y to z, then about y from z to x.
    fn turn(&self, DVec3 { x, y, z }: DVec3) -> DVec3 {
        let by = |degrees: f64, [a, b]: [f64; 2]| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            [a * cos - b * sin, a * sin + b * cos]
        };
        let [x, y] = by(self.degrees.z, [x, y]);
        let [y, z] = by(self.degrees.x, [y, z]);
        let [z, x] = by(self.degrees.y, [z, x]);
        DVec3::new(x, y, z)
    }
}

/// From the assignment's space to the course's, which looks along −z, or back.
#[must_use]
pub fn mirrored(point: DVec3) -> DVec3 {
    DVec3::new(point.x, point.y, -point.z)
}

/// The place of a point in a picture by the formula of version 0, in pixels from the upper left corner, y down.
#[must_use]
pub fn pixel(point: DVec3, size: DVec2) -> DVec2 {
    DVec2::new((point.x / 5.0 + 1.0) * 0.5 * size.x, size.y - (point.y / 5.0 + 1.0) * 0.5 * size.y)
}

/// The x and y of what version 0 shows at a place of the picture, which is given likewise.
#[must_use]
pub fn shown(pixel: DVec2, size: DVec2) -> DVec2 {
    let DVec2 { x, y } = 10.0 * pixel / size;
    DVec2::new(x - 5.0, 5.0 - y)
}

/// The projection matrix of version 5, row by row.
pub const PROJECTION: [[f64; 4]; 4] =
    [[0.4, 0.0, 0.0, 0.0], [0.0, 0.4, 0.0, 0.0], [0.0, 0.0, 1.0, -1.0], [0.0, 0.0, 0.0, 1.0]];

/// What a matrix makes of a point, divided by w, whatever its sign: from −1 to 1 in what is shown.
#[must_use]
pub fn projected(rows: &[[f64; 4]; 4], point: DVec3) -> DVec3 {
    let [x, y, z, w] = rows.map(|[a, b, c, d]| a * point.x + b * point.y + c * point.z + d);
    DVec3::new(x, y, z) / w
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The two points that the assignment gives.
    #[test]
    fn the_examples_of_the_formula() {
        let size = DVec2::new(800.0, 600.0);
        assert_eq!(pixel(DVec3::new(-5.0, 5.0, 0.0), size), DVec2::ZERO);
        assert_eq!(pixel(DVec3::ZERO, size), DVec2::new(400.0, 300.0));
        assert_eq!(shown(DVec2::new(800.0, 600.0), size), DVec2::new(5.0, -5.0));
    }

    #[test]
    fn turns_come_in_their_order() {
        let near = |got: DVec3, expected: [f64; 3]| (got - DVec3::from(expected)).length() < 1e-14;
        let turned = |x: f64, y: f64, z: f64| Placement {
            degrees: DVec3::new(x, y, z),
            ..Placement::at(0.0, 0.0, 0.0)
        };
        assert!(near(turned(0.0, 0.0, 90.0).place(DVec3::X), [0.0, 1.0, 0.0]));
        assert!(near(turned(90.0, 0.0, 0.0).place(DVec3::Y), [0.0, 0.0, 1.0]));
        assert!(near(turned(0.0, 90.0, 0.0).place(DVec3::Z), [1.0, 0.0, 0.0]));
        // z takes x to y, x takes it on to z, y back to x.
        assert!(near(turned(90.0, 90.0, 90.0).place(DVec3::X), [1.0, 0.0, 0.0]));
        let placed = Placement { scale: DVec3::new(2.0, 3.0, 4.0), ..Placement::at(1.0, 0.0, -1.0) };
        assert_eq!(placed.place(DVec3::ONE), DVec3::new(3.0, 3.0, 3.0));
    }

    /// A plane's normal stays at right angles to it.
    #[test]
    fn normals_go_with_surfaces() {
        let degrees = DVec3::new(20.0, -35.0, 140.0);
        let placement =
            Placement { degrees, scale: DVec3::new(2.0, -0.5, 3.0), ..Placement::at(1.0, 2.0, 3.0) };
        let (along, normal) = (DVec3::new(1.0, 2.0, -1.0), DVec3::new(3.0, -1.0, 1.0));
        let carried = placement.place(along) - placement.place(DVec3::ZERO);
        assert!(along.dot(normal) == 0.0 && carried.dot(placement.normal(normal)).abs() < 1e-12);
    }

    #[test]
    fn the_matrix_is_twice_as_large_as_the_formula() {
        let seen = projected(&PROJECTION, DVec3::new(1.0, -0.5, 2.0));
        assert!((seen - DVec3::new(0.4, -0.2, 1.0)).length() < 1e-15);
        assert_eq!(projected(&PROJECTION, DVec3::ZERO).z, -1.0);
    }
}
