//! What an eye sees, in `f64`.

use common::{DVec3, Vec3};

/// The eye's right, up and backward directions, each of length 1 and at right angles: backward from the centre
/// to the eye, up as near to `up` as that allows. NaN where eye and centre are one point or up is along the view.
#[must_use]
pub fn basis(eye: Vec3, center: Vec3, up: Vec3) -> [DVec3; 3] {
    let [eye, center, up] = [eye, center, up].map(Vec3::as_dvec3);
    let back = (eye - center) / (eye - center).length();
    // What is left of up when its part along the view is taken away.
    let across = up - back * up.dot(back);
    let upward = across / across.length();
    [upward.cross(back), upward, back]
}

/// Where a point lies before an eye that looks at a centre: right, up, and towards the eye, from the centre.
#[must_use]
pub fn seen(point: DVec3, eye: Vec3, center: Vec3, up: Vec3) -> DVec3 {
    let from_center = point - center.as_dvec3();
    DVec3::from_array(basis(eye, center, up).map(|direction| direction.dot(from_center)))
}

/// Where the ray from an eye through a point meets the level plane at a height.
#[must_use]
pub fn on_level(height: f64, eye: DVec3, through: DVec3) -> DVec3 {
    eye + (through - eye) * ((height - eye.y) / (through.y - eye.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn from_the_front_the_world_is_as_it_was() {
        let point = DVec3::new(0.25, -3.0, 7.0);
        assert_eq!(seen(point, Vec3::Z * 5.0, Vec3::ZERO, Vec3::new(0.0, 2.0, 1.0)), point);
        assert!(seen(point, Vec3::X, Vec3::X, Vec3::Y).is_nan());
    }

    #[test]
    fn a_ray_meets_the_floor_where_similar_triangles_say() {
        let eye = DVec3::new(0.0, 1.0, 4.0);
        assert_eq!(on_level(-1.0, eye, DVec3::new(1.0, 0.0, 0.0)), DVec3::new(2.0, -1.0, -4.0));
    }
}
