//! Homogeneous points and the perspective projection: what the assignment's version 5 says of w, of z, and of its parameters.

use checks::coverage::Triangle;
use common::{DVec3, Mat4, Vec2, Vec3, Vec4, Vec4Swizzles};
use perspective::{frustum, perspective, window};
use proptest::prelude::*;
use scene::{Entity, Levels, Mesh, Paint, Shape, Target, VERSIONS, Vertex, render_scene};

use crate::pictures::{covered, different, lit, patched_cube};
use crate::truth::{Eye, Truth};
use crate::versions::{SIZE, drawn, field_of_view, scene_at};

/// The window of these tests.
fn size() -> Vec2 {
    Vec2::new(SIZE[0].into(), SIZE[1].into())
}

fn matrix(near: f32, far: f32) -> Mat4 {
    perspective(field_of_view(5) as f32, size().x / size().y, near, far).expect("a frustum")
}

proptest! {
    /// Multiplied by a number, as the assignment's `Vec4 * float` does it to all four components, a point stays where it is;
    /// the sum of two is half-way between them.
    #[test]
    fn four_numbers_are_one_point(
        p in [-3.0..3.0, -3.0..3.0_f32], q in [-3.0..3.0, -3.0..3.0_f32], factor in 0.01..100.0_f32,
    ) {
        let [p, q] = [p, q].map(|[x, y]| Vec4::new(x, y, 0.25, 1.0));
        let at = |point: Vec4| window(point, size()).expect("before the eye").xy();
        prop_assert!((at(p * factor) - at(p)).length() < 1e-2);
        prop_assert!((at(p + q) - (at(p) + at(q)) / 2.0).length() < 1e-2);
    }
}

/// Divided by a negative w a point behind the eye comes to lie before it, mirrored both ways; left alone where w is 0, a
/// direction is taken for a point.
#[test]
fn behind_the_eye_a_division_mirrors() {
    let matrix = matrix(0.1, 100.0);
    let divided = |point: Vec3| {
        let clip = matrix * point.extend(1.0);
        (clip.xyz() / clip.w, window(clip, size()))
    };
    let (ahead, there) = divided(Vec3::new(0.4, 0.25, -2.0));
    let (behind, nowhere) = divided(Vec3::new(0.4, 0.25, 2.0));
    assert!(ahead.x > 0.0 && ahead.y > 0.0 && there.is_some());
    assert_eq!(behind.truncate(), -ahead.truncate());
    assert_eq!([nowhere, divided(Vec3::X).1], [None, None]);
}

/// What the assignment has behind the camera, z/w < −1, is between the eye and the near plane. Behind the eye z/w is above 1:
/// "too far", if anything.
#[test]
fn below_minus_one_is_before_the_near_plane() {
    let matrix = matrix(0.1, 100.0);
    let z = |depth: f32| {
        let clip = matrix * Vec4::new(0.0, 0.0, -depth, 1.0);
        clip.z / clip.w
    };
    let near =
        |depth: f32, expected: f32| assert!((z(depth) - expected).abs() < 1e-3, "{depth}: {}", z(depth));
    near(0.05, -3.002);
    near(0.1, -1.0);
    near(100.0, 1.0);
    near(200.0, 1.001);
    near(-1.0, 1.2022);
    near(-1e4, 1.002);
    assert!((1..10_000).all(|depth| z(-(depth as f32)) > 1.0));
}

/// A triangle that stands before the eye and reaches behind it.
fn through_the_eye() -> Entity {
    let corners = [[-0.6, -0.5, -2.0], [0.7, -0.4, -1.0], [0.3, 0.9, 1.5]];
    let vertices = corners.map(|at| Vertex { position: at.into(), normal: Vec3::Y, uv: Vec2::ZERO });
    let shape = Shape { vertices: vertices.to_vec(), triangles: vec![[0, 1, 2]] };
    let colors = [3, 4, 5].map(common::Color::random).to_vec();
    Entity::new(Levels::one(Mesh::new(&shape, Paint::Colors(colors))))
}

/// Cut before the division it is what rays meet. Divided as it is, it would be another triangle, most of it elsewhere.
#[test]
fn what_reaches_behind_the_eye_is_cut() {
    let mut scene = lit(vec![through_the_eye()]);
    scene.style.shading = scene::Shading::Unlit;
    scene.style.cull = clipping::Cull::None;
    let (picture, counts) = drawn(&scene, 5);
    assert_eq!((counts.triangles.cut, counts.triangles.left_out), (1, 0));
    let mut truth = Truth::new(&scene, Eye::Ahead(field_of_view(5)));
    truth.depths = [0.1, 100.0];
    truth.check(&picture, 1.02, 0.05);

    let corners = scene.entities[0].levels.finest().positions();
    let divided = [0, 1, 2].map(|n: usize| {
        let clip = matrix(0.1, 100.0) * corners[n].extend(1.0);
        (clip.xy() / clip.w + 1.0) / 2.0 * size()
    });
    let divided = Triangle::new(divided);
    let there = |x, y| picture.get(x, y) != Some(scene.background);
    let wrong = picture.pixels().filter(|&(x, y, _)| divided.covers(x, y) != there(x, y)).count();
    assert!(2 * wrong > covered(&picture), "{wrong} of {}", covered(&picture));
}

/// The parameters near and far are those that an orthographic matrix has with near = 0; of a perspective one with near = 0 all
/// depths are 1, and whoever is drawn first hides the others.
#[test]
fn near_0_leaves_no_depths() {
    let depth = |matrix: &Mat4, z: f32| window(*matrix * Vec4::new(0.0, 0.0, -z, 1.0), size()).map(|at| at.z);
    let flat = matrix(0.0, 100.0);
    assert_eq!([0.5, 1.0, 2.0, 50.0].map(|z| depth(&flat, z)), [Some(1.0); 4]);
    let usual = matrix(0.1, 100.0);
    assert!(depth(&usual, 1.0) < depth(&usual, 2.0));
    assert!(frustum(-1.0, 1.0, -1.0, 1.0, 0.0, 2.0).is_err());
    // Of the red cube and the blue sphere of version 5 the cube would then be seen where the sphere is before it.
    let scene = scene_at(5, 0.0);
    let through = |projection: &Mat4| {
        let mut target = Target::new(SIZE[0], SIZE[1]);
        render_scene(&scene, &mut target, projection, &Mat4::IDENTITY);
        target.into_picture()
    };
    assert!(different(&through(&flat), &through(&usual)) > 300);
}

/// `int width, int height`: their quotient, as it stands, is 1 in a window of 1024×768, and 0 if that is turned upright.
#[test]
fn whole_numbers_have_no_proportions() {
    assert_eq!([1024 / 768, 768 / 1024], [1, 0]);
    let x = |matrix: Mat4| matrix.x_axis.x / matrix.y_axis.y;
    assert_eq!(x((VERSIONS[5].projection)(Vec2::new(1024.0, 768.0))), 0.75);
    assert_eq!(x(perspective(60.0, (1024 / 768) as f32, 0.1, 100.0).expect("a frustum")), 1.0);
    assert!(perspective(60.0, (768 / 1024) as f32, 0.1, 100.0).is_err());
}

/// The field of view is in degrees, from the bottom of the picture to its top, whatever its width.
#[test]
fn the_field_of_view_is_vertical_and_in_degrees() {
    let top = (field_of_view(5).to_radians() / 2.0).tan();
    for size in [Vec2::new(1024.0, 768.0), Vec2::new(300.0, 900.0)] {
        let clip = (VERSIONS[5].projection)(size) * Vec4::new(0.0, (3.0 * top) as f32, -3.0, 1.0);
        assert!((clip.y / clip.w - 1.0).abs() < 1e-6);
    }
}

/// "The previous scene" is seen whole: nothing of it is at the picture's border, at any time of a turn.
#[test]
fn the_scene_of_version_5_is_seen_whole() {
    for step in 0..24 {
        let picture = drawn(&scene_at(5, 0.5 * f64::from(step)), 5).0;
        let [right, top] = [picture.width() - 1, picture.height() - 1];
        let at_border = |&(x, y, _): &(i32, i32, common::Color)| x == 0 || y == 0 || x == right || y == top;
        let there =
            picture.pixels().filter(at_border).filter(|pixel| pixel.2 != common::Color::BLACK).count();
        assert_eq!(there, 0, "{} s", 0.5 * f64::from(step));
    }
}

/// After the division w is 1, "and serves nothing any more". But colours and texture coordinates are interpolated by the w of
/// before: by areas in the picture, a crate's planks would be off by many texels.
#[test]
fn w_is_needed_after_the_division() {
    let scene = scene_at(6, 1.7);
    let mesh = scene.entities[0].levels.finest();
    let to_clip = (VERSIONS[6].projection)(size()) * scene.entities[0].to_world();
    let Paint::Texture(texture) = mesh.paint() else { panic!("a texture") };
    let texels = texture.base().width();
    let mut worst: f64 = 0.0;
    for face in 0..mesh.triangles() {
        let vertices = [0, 1, 2].map(|corner| mesh.vertex(face, corner));
        let at = vertices.map(|vertex| {
            window(to_clip * mesh.positions()[vertex].extend(1.0), size()).expect("before the eye")
        });
        let flat = Triangle::new(at.map(Vec4Swizzles::xy));
        let uvs = vertices.map(|vertex| mesh.uvs()[vertex].as_dvec2());
        for (x, y) in (0..i32::from(SIZE[0])).flat_map(|x| (0..i32::from(SIZE[1])).map(move |y| (x, y))) {
            if !flat.covers(x, y) {
                continue;
            }
            let shares = DVec3::from(flat.weights(x, y));
            let by_w = shares * DVec3::from(at.map(|at| f64::from(at.w)));
            let mean = |weights: DVec3| {
                (uvs[0] * weights.x + uvs[1] * weights.y + uvs[2] * weights.z) / weights.element_sum()
            };
            worst = worst.max((mean(shares) - mean(by_w)).length() * f64::from(texels));
        }
    }
    assert!(worst > 8.0, "{worst} texels");
}

/// A face has the whole texture, upright and not mirrored, on all six sides: seen straight on, its lower left texel is on the
/// lower left.
#[test]
fn each_face_shows_the_texture_as_it_is() {
    let degrees = [[0.0, 0.0], [0.0, 90.0], [0.0, 180.0], [0.0, 270.0], [90.0, 0.0], [-90.0, 0.0]];
    let mut pictures = degrees.map(|[x, y]| {
        let cube = Entity {
            position: Vec3::new(0.0, 0.0, -1.5),
            degrees: Vec3::new(x, y, 0.0),
            ..Entity::new(patched_cube())
        };
        let mut scene = lit(vec![cube]);
        (scene.style.shading, scene.style.filter) = (scene::Shading::Unlit, scene::Filtering::Nearest);
        drawn(&scene, 6).0
    });
    let [first, others @ ..] = &mut pictures;
    // Three columns and two rows of different texels.
    for (n, x, y) in [(0, 50, 30), (1, 80, 30), (2, 110, 30), (3, 50, 90), (4, 80, 90), (5, 110, 90)] {
        assert_eq!(first.get(x, y), Some(common::Color::random(n + 3)), "texel {n}");
    }
    for other in others {
        // Sines of 90° are not exact: a column or a row at a texel's side may change hands.
        assert!(different(first, other) < 120, "{}", different(first, other));
    }
}
