//! All of mission 12.
use common::Vec3;

pub use lighting_given::{PointLight, Reflected, draw};

/// Blinn's model.
pub fn blinn_phong(point: Vec3, normal: Vec3, eye: Vec3, light: &PointLight) -> Reflected {
    let n = normal.normalize_or_zero();
    let l = (light.position - point).normalize_or_zero();
    let v = (eye - point).normalize_or_zero();
    let h = (l + v).normalize_or_zero();
    let straight = n.dot(l);
    if straight <= 0.0 {
        return Reflected { body: light.ambient, highlight: 0.0 };
    }
    let highlight = light.specular * n.dot(h).max(0.0).powf(light.shininess);
    Reflected { body: light.ambient + light.diffuse * straight, highlight }
}
