//! The exponents that make the highlights of Phong and Blinn alike: "four times" is right where light and eye are in one
//! direction, and in the plane of the two. Across it the ratio is 4 cos² of half the angle between them, so that Blinn's
//! highlight is longer than wide where Phong's is round.

use checks::lamp::alike;
use common::Vec3;
use lighting::{PointLight, Reflected, blinn_phong, phong};

/// Phong's exponent, the degrees between light and eye, across their plane or in it; the best ratio, and how many of 255 grey
/// levels the two curves then differ by at most.
const ALIKE: &[(f64, f64, bool, f64, f64)] = &[
    (1.0, 0.0, false, 6.38, 27.9),
    (2.0, 0.0, false, 4.91, 11.2),
    (4.0, 0.0, false, 4.39, 4.74),
    (8.0, 0.0, false, 4.18, 2.18),
    (32.0, 0.0, false, 4.04, 0.511),
    (128.0, 0.0, false, 4.01, 0.126),
    (1000.0, 0.0, false, 4.00, 0.0160),
    (32.0, 0.0, true, 4.04, 0.511),
    (32.0, 60.0, false, 4.04, 0.511),
    (32.0, 60.0, true, 3.02, 0.342),
    (32.0, 90.0, false, 4.04, 0.511),
    (32.0, 90.0, true, 2.00, 0.0),
    (32.0, 120.0, false, 4.04, 0.511),
    (32.0, 120.0, true, 0.978, 1.07),
];

#[test]
fn blinns_exponent_is_about_four_times_phongs() {
    for &(exponent, degrees, across, ratio, levels) in ALIKE {
        let [best, left] = alike(exponent, degrees.to_radians(), across);
        let near = |a: f64, b: f64| (a - b).abs() <= 0.005 * b + 1e-3;
        assert!(
            near(best / exponent, ratio) && near(255.0 * left, levels),
            "{exponent}, {degrees}°, {across}: {} times, {} levels",
            best / exponent,
            255.0 * left
        );
        // No more than the rule of four, and of the cosine across, and the more exact the smaller the highlight.
        let rule = if across { 4.0 * (degrees.to_radians() / 2.0).cos().powi(2) } else { 4.0 };
        assert!((best / exponent - rule).abs() <= 2.5 / exponent, "{exponent}, {degrees}°, {across}: {rule}");
    }
}

/// The lesson's two models with these exponents: their highlights differ by what is left, and with one exponent by far more.
#[test]
fn with_four_times_the_exponent_the_models_agree() {
    let light = PointLight { position: Vec3::Z, specular: 1.0, ..PointLight::default() };
    let [best, left] = alike(32.0, 0.0, false);
    let worst = |exponent: f64| {
        let difference = |n: i32| {
            let tilt = f64::from(n) / 1000.0 * std::f64::consts::FRAC_PI_4;
            let normal = Vec3::new(tilt.sin() as f32, 0.0, tilt.cos() as f32);
            let blinn = PointLight { shininess: exponent as f32, ..light };
            let [r, h] = [
                phong(Vec3::ZERO, normal, Vec3::Z, &PointLight { shininess: 32.0, ..light }),
                blinn_phong(Vec3::ZERO, normal, Vec3::Z, &blinn),
            ];
            f64::from((r.highlight - h.highlight).abs())
        };
        (0..1000).map(difference).fold(0.0, f64::max)
    };
    assert!((worst(best) - left).abs() < 1e-4, "{} instead of {left}", worst(best));
    assert!(worst(128.0) < 0.005 && worst(32.0) > 0.4, "{} {}", worst(128.0), worst(32.0));
}

/// Degrees between light and eye, the exponent, and by how many of 255 levels a white highlight jumps where the light just
/// grazes the surface, on one side of which it is cut off: Phong's and Blinn's. The surface turns in the plane of the two.
const EDGES: &[(f64, f32, f64, f64)] = &[
    (60.0, 1.0, 0.0, 127.5),
    (60.0, 8.0, 0.0, 1.0),
    (90.0, 1.0, 0.0, 180.3),
    (90.0, 8.0, 0.0, 15.9),
    (90.0, 32.0, 0.0, 0.0),
    (120.0, 8.0, 1.0, 80.7),
    (120.0, 32.0, 0.0, 2.6),
    (150.0, 32.0, 2.6, 84.1),
    (150.0, 128.0, 0.0, 3.0),
];

#[test]
fn a_highlight_ends_in_an_edge_where_the_light_just_grazes() {
    for &(degrees, shininess, phongs, blinns) in EDGES {
        let apart = degrees.to_radians();
        let light = PointLight { position: Vec3::X * 1e3, specular: 1.0, shininess, ..PointLight::default() };
        let eye = Vec3::new(apart.cos() as f32, apart.sin() as f32, 0.0) * 1e3;
        let jump = |model: fn(Vec3, Vec3, Vec3, &PointLight) -> Reflected| {
            let [lit, dark] =
                [1e-5, -1e-5].map(|x| model(Vec3::ZERO, Vec3::new(x, 1.0, 0.0), eye, &light).highlight);
            255.0 * f64::from(lit - dark)
        };
        let found = [jump(phong), jump(blinn_phong)];
        assert!(
            (found[0] - phongs).abs() < 0.06 && (found[1] - blinns).abs() < 0.06,
            "{degrees}°, E = {shininess}: {found:?}"
        );
    }
}
