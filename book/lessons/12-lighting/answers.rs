//! The numbers of the chapter's worked examples and of their quizzes, computed by the lesson's own code.

use std::f32::consts::{E, PI, TAU};

use common::{Color, Mat3, Vec2, Vec3};
use lighting::normal_map::decoded;
use lighting::tangent::{handed, tangents, turned};
use lighting::{NORMALISATIONS, POWERS, PointLight, blinn_phong, phong};
use transforms::{normal_matrix, scale};

use crate::figures::picture::method;

fn close(got: f32, expected: f32, by: f32) {
    assert!((got - expected).abs() <= by, "{got}, not {expected}");
}

/// The lamp of the example.
const LAMP: PointLight = PointLight {
    position: Vec3::new(3.0, 0.0, 4.0),
    ambient: 0.2,
    diffuse: 0.4,
    specular: 0.4,
    shininess: 2.0,
    falloff: lighting::Falloff::None,
};
const EYE: Vec3 = Vec3::new(-8.0, 0.0, 6.0);
const TEXEL: Color = Color::rgb(200, 100, 50);

#[test]
fn phong_by_hand() {
    let reflected = phong(Vec3::ZERO, Vec3::Z, EYE, &LAMP);
    close(reflected.body, 0.52, 1e-6);
    close(reflected.highlight, 0.368_64, 1e-6);
    assert_eq!(reflected.color(TEXEL), Color::rgb(198, 146, 120));
    let narrow = phong(Vec3::ZERO, Vec3::Z, EYE, &PointLight { shininess: 32.0, ..LAMP });
    close(narrow.highlight / 0.4, 0.271, 5e-4);
    close(narrow.highlight * 255.0, 28.0, 0.5);
}

#[test]
fn a_lamp_below_the_floor() {
    let below = PointLight { position: Vec3::new(3.0, 0.0, -4.0), ..LAMP };
    assert_eq!(phong(Vec3::ZERO, Vec3::Z, EYE, &below).color(TEXEL), Color::rgb(40, 20, 10));
}

/// α = 25 by Phong and 100 by Blinn, with the lamp near the eye: nowhere far apart.
#[test]
fn four_times_the_exponent() {
    let eye = Vec3::new(0.0, 0.0, 5.0);
    let light =
        |shininess: f32| PointLight { position: Vec3::new(0.5, 0.0, 5.0), shininess, specular: 1.0, ..LAMP };
    let apart = |exponent: f32| {
        (0..90).fold(0.0_f32, |most, degrees| {
            let normal =
                Vec3::new((degrees as f32).to_radians().sin(), 0.0, (degrees as f32).to_radians().cos());
            let [p, b] = [
                phong(Vec3::ZERO, normal, eye, &light(25.0)).highlight,
                blinn_phong(Vec3::ZERO, normal, eye, &light(exponent)).highlight,
            ];
            most.max((p - b).abs())
        })
    };
    assert!(apart(100.0) < 0.02, "{}", apart(100.0));
    assert!(apart(50.0) > 0.1 && apart(25.0) > 0.2, "{} {}", apart(50.0), apart(25.0));
}

/// Where a highlight is one half: 12° for α = 32.
#[test]
fn half_of_the_highlight() {
    let half = (2.0 * 2.0_f32.ln() / 32.0).sqrt();
    close(half, 0.208, 5e-4);
    close(half.to_degrees(), 12.0, 0.1);
    close(half.cos().powf(32.0), 0.5, 0.005);
}

/// 45° is where a stretch turns normals the most, and by how much.
#[test]
fn normals_lean() {
    for (stretch, degrees) in [(1.1_f32, 5.5), (1.25, 12.7), (2.0, 36.87)] {
        let m = scale(Vec3::new(stretch, 1.0, 1.0));
        let lean = |tilt: f32| {
            let normal = Vec3::new(tilt.to_radians().sin(), tilt.to_radians().cos(), 0.0);
            (Mat3::from_mat4(m) * normal).angle_between(normal_matrix(&m).unwrap() * normal).to_degrees()
        };
        close(lean(45.0), degrees, 0.06);
        close(lean(45.0), 2.0 * stretch.atan().to_degrees() - 90.0, 0.01);
        assert!((1..90).all(|tilt| lean(tilt as f32) <= lean(45.0) + 1e-3));
    }
}

/// Corners 10° apart: what the interpolated normal lacks, and what that costs.
#[test]
fn ten_degrees() {
    let [a, b] =
        [-5.0_f32, 5.0].map(|degrees| Vec3::new(degrees.to_radians().sin(), 0.0, degrees.to_radians().cos()));
    let mean = (a + b) / 2.0;
    close(mean.length(), 0.996, 5e-4);
    let [never, exact] = ["never", "exact"].map(|name| {
        // The lamp and the eye straight above: h is the middle's normal.
        let above = Vec3::new(0.0, 0.0, 9.0);
        let light = PointLight { position: above, shininess: 32.0, ..LAMP };
        (method(NORMALISATIONS, name).unwrap().reflect)(Vec3::ZERO, mean, above, &light)
    });
    close(1.0 - never.highlight / exact.highlight, 0.115, 1e-3);
    close((exact.highlight - never.highlight) * 255.0, 12.0, 0.5);
    assert!((exact.body - never.body) * 255.0 < 0.5);
    // As bright as the ends.
    close(never.highlight, 0.4 * a.z.powf(32.0), 1e-4);
}

/// Sectors of a ball, so that Phong's highlight at the corners loses 1 %; and what 16 and 36 lose.
#[test]
fn sectors() {
    let left = |sectors: f32, exponent: f32| (TAU / sectors).cos().powf(exponent);
    close(left(251.0, 32.0), 0.99, 1e-4);
    close(left(126.0, 32.0), 0.961, 1e-3);
    close(left(36.0, 32.0), 0.61, 0.005);
    close(left(16.0, 8.0), 0.53, 0.005);
    close(left(16.0, 32.0), 0.08, 0.005);
    // With Blinn's, half of the angle counts.
    close((PI / 126.0).cos().powf(32.0), 0.99, 2e-4);
}

/// The errors of the inverse root, and what the power makes of them.
#[test]
fn roots() {
    let worst = |name: &str| {
        let one = method(NORMALISATIONS, name).unwrap().one;
        let lengths = (0..4000).map(|n| (1.0 + 3.0 * n as f32 / 4000.0).sqrt());
        lengths.map(|length| (one(Vec3::X * length).x - 1.0).abs()).fold(0.0, f32::max)
    };
    close(worst("fast-0"), 0.0344, 2e-4);
    close(worst("fast-1"), 0.00175, 2e-5);
    close(worst("fast-2"), 4.7e-6, 3e-7);
    // The normal and the half vector are off alike: twice the exponent.
    close(1.0 - (1.0 - worst("fast-1")).powf(64.0), 0.106, 1e-3);
    close((1.0 - worst("fast-0")).powf(64.0), 0.106, 0.003);
    close(64.0 * worst("fast-2") * 102.0, 0.03, 0.002);
}

#[test]
fn powers() {
    let worst = |name: &str, exponent: f32| {
        let one = method(POWERS, name).unwrap().one;
        let numbers = (0..=200_000).map(|n| n as f32 / 200_000.0);
        numbers
            .map(|x| (f64::from(one(exponent, x)) - f64::from(x).powf(exponent.into())).abs())
            .fold(0.0, f64::max)
    };
    // Schlick's: whatever the exponent.
    for exponent in [64.0, 1000.0] {
        close(worst("schlick", exponent) as f32, 0.204, 0.01);
    }
    close(worst("table", 32.0) as f32, 0.063, 0.004);
    // By (α(α − 1)) / (8 · 255²), which is a bound: the second derivative is largest at the very end.
    for (exponent, bound) in [(32.0, 0.001_907), (51.0, 0.004_902)] {
        let worst = worst("table-linear", exponent);
        assert!(worst < bound && worst > 0.9 * bound, "{exponent}: {worst}");
    }
    // Half a level of S = 0.4.
    close(51.0 * 50.0 / 8.0 / 255.0_f32.powi(2) * 102.0, 0.5, 1e-4);
}

/// A triangle on which the map lies mirrored.
#[test]
fn a_mirrored_triangle() {
    let positions = [Vec3::ZERO, Vec3::new(2.0, 0.0, 0.0), Vec3::Y];
    let uvs = [Vec2::ZERO, Vec2::Y, Vec2::X];
    let [t, b] = tangents(positions, uvs).unwrap();
    assert_eq!([t.as_vec3(), b.as_vec3()], [Vec3::Y, Vec3::new(2.0, 0.0, 0.0)]);
    assert_eq!(Vec3::Z.cross(t.as_vec3()), Vec3::NEG_X);
    assert_eq!(handed(positions, uvs, [Vec3::Z; 3]), Vec3::Y.extend(-1.0));
    // A flat map changes nothing, mirrored or not.
    let flat = decoded(Color::rgb(128, 128, 255));
    assert_eq!((flat, turned(flat, Vec3::Y.extend(-1.0), Vec3::Z)), (Vec3::Z, Vec3::Z));
}

/// Half a step of 8 bits in each component: the direction of a normal, and what a highlight makes of it.
#[test]
fn eight_bits() {
    let off = 3f32.sqrt() / 254.0;
    close(off, 0.0068, 5e-5);
    close(off.to_degrees(), 0.39, 0.002);
    close((32.0 / E).sqrt() * off, 0.023, 5e-4);
    close((1000.0 / E).sqrt() * off, 0.13, 1e-3);
    // As 2c/255 − 1 has it, a flat map leans.
    let lean = 2.0 * 128.0 / 255.0 - 1.0;
    close(Vec3::new(lean, lean, 1.0).angle_between(Vec3::Z).to_degrees(), 1.0 / 3.0, 0.02);
}
