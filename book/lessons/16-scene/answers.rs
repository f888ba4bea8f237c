//! The numbers of the chapter's worked examples and of its quizzes, computed by the lesson's own code.

use clipping::plane::PLANES;
use common::{DVec3, Mat3, Mat4, Vec2, Vec3, Vec4};
use filtering::light::SRGB;
use perspective::perspective;
use scene::frustum::{Sphere, pixels_per_unit, sees};
use scene::levels::error;
use scene::versions::{orthographic, ours};
use scene::{orbit, sphere};
use transforms::affine::{model, rotate_y, translate};

fn close(got: f64, expected: f64, by: f64) {
    assert!((got - expected).abs() <= by, "{got}, not {expected}");
}

/// Z·M·Z, of what their matrix is and of what [`ours`] makes of it.
#[test]
fn a_mirror_on_both_sides() {
    let z = Mat4::from_scale(Vec3::new(1.0, 1.0, -1.0));
    let (position, degrees) = (Vec3::new(1.0, 0.5, 3.0), Vec3::new(20.0, 30.0, 10.0));
    let size = Vec3::new(2.0, 1.0, 0.5);
    let (here, turned) = ours(position, degrees);
    assert!((z * model(position, degrees, size) * z).abs_diff_eq(model(here, turned, size), 1e-6));
    assert!(model(here, turned, size).determinant() > 0.0);
    // The crate of the question.
    let quiz = ours(Vec3::new(1.0, 0.0, 3.0), Vec3::new(0.0, 30.0, 10.0));
    assert_eq!(quiz, (Vec3::new(1.0, 0.0, -3.0), Vec3::new(0.0, -30.0, 10.0)));
}

/// M·u × M·v = det M · M⁻ᵀ·(u × v).
#[test]
fn winding_turns_with_the_determinant() {
    let (u, v) = (Vec3::new(0.3, -1.0, 0.4), Vec3::new(1.1, 0.2, -0.6));
    for scale in [Vec3::new(2.0, 1.0, 0.5), Vec3::new(-2.0, 1.0, 0.5), Vec3::new(-1.0, -1.0, 3.0)] {
        let m = Mat3::from_mat4(model(Vec3::ZERO, Vec3::new(20.0, 30.0, 10.0), scale));
        close(m.determinant().into(), scale.element_product().into(), 1e-5);
        let of_corners = (m * u).cross(m * v);
        let of_surface = m.inverse().transpose() * u.cross(v);
        assert!(of_corners.abs_diff_eq(m.determinant() * of_surface, 1e-5));
        assert_eq!(of_corners.dot(of_surface) > 0.0, scale.element_product() > 0.0);
    }
}

#[test]
fn the_lamp_and_the_moth() {
    let lamp = Mat4::from_mat3(rotate_y(90.0)) * translate(Vec3::Y * 5.0) * translate(Vec3::X * 2.0);
    assert!(lamp.transform_point3(Vec3::ZERO).abs_diff_eq(Vec3::new(0.0, 5.0, -2.0), 1e-6));
    let turned_first = translate(Vec3::Y * 5.0) * translate(Vec3::X * 2.0) * Mat4::from_mat3(rotate_y(90.0));
    assert_eq!(turned_first.transform_point3(Vec3::ZERO), Vec3::new(2.0, 5.0, 0.0));
    let moth = lamp.inverse().transform_point3(Vec3::new(0.0, 5.0, -3.0));
    assert!(moth.abs_diff_eq(Vec3::X, 1e-6), "{moth}");
}

/// From behind, what is at +x is on the left.
#[test]
fn seen_from_behind() {
    let seen = orbit(180.0, 0.0, 5.0).inverse().transform_point3(Vec3::X);
    assert!(seen.abs_diff_eq(Vec3::new(-1.0, 0.0, -5.0), 1e-5), "{seen}");
    // Level, whatever the elevation.
    assert!(orbit(77.0, 50.0, 3.0).x_axis.y.abs() < 1e-6);
}

#[test]
fn triangles_of_spheres() {
    let counts = |m, n| [sphere(m, n).vertices.len(), sphere(m, n).triangles.len()];
    assert_eq!([counts(8, 16)[1], counts(32, 64)[1], counts(128, 256)[1]], [224, 3968, 65_024]);
    assert_eq!(counts(3, 4), [18, 16]);
    assert_eq!(counts(5, 7), [2 * 7 + 4 * 8, 2 * 7 * 4]);
}

/// The largest distance of a facet from the sphere, found at points all over each.
#[test]
fn facets_and_their_bound() {
    for (m, n) in [(3, 6), (5, 10), (8, 16), (7, 11)] {
        let shape = sphere(m, n);
        let corner = |n: u32| shape.vertices[n as usize].position;
        let mut nearest = 1.0_f32;
        for [a, b, c] in &shape.triangles {
            let [a, b, c] = [*a, *b, *c].map(corner);
            const STEPS: i32 = 40;
            for (i, j) in (0..=STEPS).flat_map(|i| (0..=STEPS - i).map(move |j| (i, j))) {
                let [s, t] = [i, j].map(|part| part as f32 / STEPS as f32);
                nearest = nearest.min((a + (b - a) * s + (c - a) * t).length());
            }
        }
        let found = 1.0 - f64::from(nearest);
        let (pi, m, n) = (std::f64::consts::PI, m as f64, n as f64);
        let bound = 1.0 - (pi / n).cos() * (pi / 2.0 / m).cos();
        assert!(found <= bound + 1e-6, "{m} {n}: {found} {bound}");
        assert!(found >= 0.9 * bound, "{m} {n}: {found} {bound}");
        if m % 2.0 == 1.0 {
            close(found, bound, 2e-4);
        }
    }
    // As much as a cell across the equator has; the lesson's take the cells beside it.
    for (m, told, by) in [(8, 0.038, 0.0005), (32, 0.0024, 0.00005), (128, 0.00015, 0.000_005)] {
        let half = std::f64::consts::PI / f64::from(2 * m);
        let bound = 1.0 - half.cos().powi(2);
        close(bound, told, by);
        close((2.0 * half / 2.0).powi(2), bound, 0.02 * bound);
        let exact = error(m as usize, 2 * m as usize);
        assert!((0.97..=1.0).contains(&(exact / bound)), "{exact} {bound}");
    }
}

/// The table of radii, and how far the fixed spheres go.
#[test]
fn longitudes_for_half_a_pixel() {
    let enough = |radius: f64| std::f64::consts::PI * (2.0 * radius).sqrt();
    for (radius, expected) in [(5.0, 9.9), (20.0, 19.9), (50.0, 31.4), (200.0, 62.8), (800.0, 125.7)] {
        close(enough(radius), expected, 0.05);
    }
    close(0.5 / error(8, 16), 13.0, 0.5);
    close(0.5 / error(32, 64), 208.0, 0.5);
    // For each pixel of a ball of ten pixels.
    close(65_024.0 / (std::f64::consts::PI * 100.0), 200.0, 10.0);
    close(enough(4.0 * 20.0) / enough(20.0), 2.0, 1e-12);
}

/// The sphere of the figure, whose radius of 180 pixels is at most 184.7 by the bound for its nearest point; and how many times
/// as long as it is wide a triangle at a pole is.
#[test]
fn half_a_pixel_and_a_sliver() {
    close(184.7 * error(24, 48), 0.79, 0.005);
    assert!(184.7 * error(32, 64) < 0.5);
    let step = std::f64::consts::PI / 128.0;
    // Of 256 columns each is as wide as a row is high, at the equator.
    let [long, wide] = [2.0 * (step / 2.0).sin(), 2.0 * (step / 2.0).sin() * step.sin()];
    close(long / wide, 40.0, 1.0);
}

/// Highlights by Phong's model and by Blinn's with four times the exponent, where light and eye are in one direction.
#[test]
fn two_models_with_the_lamp_in_the_eye() {
    let apart = |n: u32| {
        let angle = f64::from(n) * 1e-4;
        ((2.0 * angle).cos().max(0.0).powi(32) - angle.cos().powi(128)).abs()
    };
    close((0..15_708).map(apart).fold(0.0, f64::max), 0.0043, 0.000_05);
}

/// How far version 5's sphere reaches, and the field of view that shows it.
#[test]
fn a_sphere_beside_the_axis() {
    let reach = (0.5_f64 / 2.0).atan() + (1.0 / 4.25_f64.sqrt()).asin();
    close(reach.to_degrees(), 43.1, 0.05);
    close(2.0 * (reach.tan() * 3.0 / 4.0).atan().to_degrees(), 70.0, 0.05);
}

/// In the middle of the picture, and in its corner; and what the lesson says.
#[test]
fn pixels_of_a_unit() {
    let cot = 1.0 / 22.5_f64.to_radians().tan();
    close(384.0 * cot, 927.0, 0.5);
    close(512.0 * 0.75 * cot, 927.0, 0.5);
    let [a, b] = [DVec3::new(384.0 * cot, 0.0, 512.0), DVec3::new(0.0, 384.0 * cot, 384.0)];
    let (half, apart) = ((a.dot(a) + b.dot(b)) / 2.0, (a.dot(a) - b.dot(b)) / 2.0);
    let most = (half + apart.hypot(a.dot(b))).sqrt();
    close(most, (927.058_f64.powi(2) + 512.0_f64.powi(2) + 384.0_f64.powi(2)).sqrt(), 0.01);
    close(most, 1127.0, 0.5);
    let to_clip = perspective(45.0, 4.0 / 3.0, 0.1, 100.0).unwrap() * translate(Vec3::NEG_Z * 10.0);
    let point = Sphere { center: Vec3::ZERO, radius: 0.0 };
    close(pixels_per_unit(&to_clip, &point, Vec2::new(1024.0, 768.0)).into(), 112.7, 0.05);
}

/// From so far away the second coarsest head is good enough, and from near the finest is taken.
#[test]
fn heads_from_far_and_near() {
    let levels = scene::head::head(&scene::Paint::Color(common::Color::WHITE)).unwrap();
    let chosen = |distance: f32| {
        let to_clip = perspective(45.0, 4.0 / 3.0, 0.1, 1000.0).unwrap() * translate(Vec3::NEG_Z * distance);
        let bounds = scene::Entity::new(levels.clone()).bounds();
        levels.choose(pixels_per_unit(&to_clip, &bounds, Vec2::new(1024.0, 768.0))).triangles()
    };
    assert_eq!([2.0, 200.0].map(chosen), [22_688, 1288]);
}

/// The same plane in the world, and two balls.
#[test]
fn planes_of_a_matrix() {
    let to_clip = perspective(90.0, 1.0, 0.1, 100.0).unwrap();
    let left = PLANES.iter().map(|&plane| to_clip.transpose() * plane);
    let left: Vec<Vec4> = left.filter(|plane| plane.x > 0.5).collect();
    assert_eq!(left.len(), 1);
    assert!(left[0].abs_diff_eq(Vec4::new(1.0, 0.0, -1.0, 0.0), 1e-6), "{}", left[0]);
    let ball = |x: f32| Sphere { center: Vec3::new(x, 0.0, -1.0), radius: 1.0 };
    assert!(!sees(&to_clip, &ball(-3.0)) && sees(&to_clip, &ball(-2.0)));
}

#[test]
fn the_assignments_numbers() {
    let places = orthographic(Vec2::new(800.0, 600.0)) * Vec4::new(-5.0, 5.0, -2.0, 1.0);
    assert_eq!([places.x, places.y, places.w], [-1.0, 1.0, 1.0]);
    assert_eq!(1024.0 / 10.0, 102.4);
    assert_eq!(768.0 / 10.0, 76.8);
    assert_eq!(1024 / 768, 1);
    assert_eq!((127.5_f32 as u8, 255_u8.wrapping_add(1)), (127, 0));
}

/// Half the codes, and half the light.
#[test]
fn two_lamps() {
    let light = SRGB.light(common::Color::gray(128.0 / 255.0));
    assert_eq!(SRGB.color(light * 2.0).r, 176);
}

#[test]
fn what_is_left_after_a_second() {
    for (pictures, expected) in [(10, 0.3487), (30, 0.3617), (60, 0.3648), (144, 0.3666)] {
        close((1.0 - 1.0 / f64::from(pictures)).powi(pictures), expected, 0.000_05);
    }
    close((-1.0_f64).exp(), 0.3679, 0.000_05);
    close(1000.0 / 60.0, 16.7, 0.05);
}
