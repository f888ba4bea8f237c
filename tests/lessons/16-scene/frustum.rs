//! What is left out of the picture as a whole, and what a unit is in pixels.

use std::sync::Arc;

use clipping::Cull;
use common::{Color, DVec2, DVec3, DVec4, Mat4, Vec2, Vec3, Vec4};
use fastrand::Rng;
use perspective::{frustum, perspective, view};
use scene::frustum::{Sphere, pixels_per_unit, sees};
use scene::{
    Counts, Entity, Filtering, Levels, Mesh, Paint, Scene, Shading, Shape, Style, Target, Vertex, cube,
    render_scene,
};

/// Numbers from `low` to `high`.
fn between(rng: &mut Rng, low: f32, high: f32) -> f32 {
    low + (high - low) * rng.f32()
}

fn vector(rng: &mut Rng, reach: f32) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| between(rng, -reach, reach)))
}

/// A camera anywhere, in perspective or not, its far plane near or at infinity; the picture's middle need not be ahead.
fn camera(rng: &mut Rng) -> Mat4 {
    let near = 10_f32.powf(between(rng, -3.0, 1.0));
    let far = if rng.bool() { f32::INFINITY } else { near * 10_f32.powf(between(rng, 0.1, 6.0)) };
    let projection = match rng.u8(..3) {
        0 => perspective(between(rng, 1.0, 170.0), between(rng, 0.1, 10.0), near, far).unwrap(),
        1 => {
            let [l, b] = [between(rng, -2.0, 1.0), between(rng, -2.0, 1.0)].map(|side| side * near);
            let [r, t] = [l + near * between(rng, 0.1, 2.0), b + near * between(rng, 0.1, 2.0)];
            frustum(l, r, b, t, near, far).unwrap()
        }
        _ => {
            let scale =
                Vec4::new(between(rng, 0.05, 2.0), between(rng, 0.05, 2.0), -between(rng, 0.02, 1.0), 1.0);
            Mat4::from_diagonal(scale) * Mat4::from_translation(vector(rng, 3.0))
        }
    };
    let eye = vector(rng, 5.0);
    projection * view(eye, eye + vector(rng, 1.0), vector(rng, 1.0)).unwrap_or(Mat4::IDENTITY)
}

/// A mesh of a few vertices about a middle of its own.
fn mesh(rng: &mut Rng) -> Arc<Levels> {
    let (reach, middle) = (10_f32.powf(between(rng, -2.0, 1.0)), vector(rng, 3.0));
    let vertices: Vec<Vertex> = (0..rng.usize(3..9))
        .map(|_| Vertex { position: middle + vector(rng, reach), normal: Vec3::Z, uv: Vec2::ZERO })
        .collect();
    let triangles = (2..vertices.len() as u32).map(|n| [0, n - 1, n]).collect();
    Levels::one(Mesh::new(&Shape { vertices, triangles }, Paint::Color(Color::WHITE)))
}

fn entity(rng: &mut Rng) -> Entity {
    let levels = mesh(rng);
    let scale =
        Vec3::from_array(std::array::from_fn(|_| between(rng, -3.0, 3.0) * f32::from(rng.u8(..8).min(1))));
    let reach = 10_f32.powf(between(rng, 0.0, 2.0));
    let position = vector(rng, reach);
    Entity { position, degrees: vector(rng, 720.0), scale, ..Entity::new(levels) }
}

/// Where lesson 11's loop is told that the vertices of an entity are, in clip space.
fn drawn(entity: &Entity, to_clip: &Mat4) -> Vec<Vec4> {
    let to_clip = *to_clip * entity.to_world();
    entity.levels.finest().positions().iter().map(|p| to_clip * p.extend(1.0)).collect()
}

fn is_inside(p: Vec4) -> bool {
    p.truncate().abs().max_element() <= p.w
}

/// Never is an entity left out of which a vertex is drawn in the picture. And of those whose vertices are all beyond one plane,
/// which nothing is drawn of, nine in ten are left out: the others' spheres reach farther in than they do.
#[test]
fn nothing_that_is_in_the_frustum_is_left_out() {
    let mut rng = Rng::with_seed(16);
    let (mut inside, mut outside, mut left_out) = (0, 0, 0);
    for _ in 0..100_000 {
        let (to_clip, entity) = (camera(&mut rng), entity(&mut rng));
        let seen = sees(&to_clip, &entity.bounds());
        let vertices = drawn(&entity, &to_clip);
        if vertices.iter().any(|&p| is_inside(p)) {
            assert!(seen, "{to_clip} {:?} {:?} {:?}", entity.position, entity.degrees, entity.scale);
            inside += 1;
        } else {
            let beyond = |axis: usize, sign: f32| vertices.iter().all(|p| sign * p[axis] > p.w);
            outside += usize::from((0..3).any(|axis| beyond(axis, 1.0) || beyond(axis, -1.0)));
            left_out += usize::from(!seen);
        }
    }
    assert!(inside > 8_000 && left_out as f64 > 0.9 * outside as f64, "{inside}, {left_out} of {outside}");
}

/// All vertices are within the sphere, whatever the transform: by products in `f64`.
#[test]
fn an_entity_is_within_its_bounds() {
    let mut rng = Rng::with_seed(1);
    let mut fullest = 0.0_f64;
    for _ in 0..10_000 {
        let entity = entity(&mut rng);
        let Sphere { center, radius } = entity.bounds();
        let [x, y, z] = entity.degrees.as_dvec3().to_array().map(f64::to_radians);
        for p in entity.levels.finest().positions() {
            let p = about(1, z, p.as_dvec3() * entity.scale.as_dvec3());
            let p = about(0, y, about(2, x, p)) + entity.position.as_dvec3();
            let distance = p.distance(center.as_dvec3());
            // Degrees become radians in `f32`: 720 of them are known to 2⁻²¹ radians.
            assert!(distance <= f64::from(radius) * (1.0 + 1e-5) + 2e-5, "{distance}, not within {radius}");
            fullest = fullest.max(distance / f64::from(radius));
        }
    }
    assert!(fullest > 0.99, "{fullest}");
}

/// Far from the origin an `f32` knows places to 1/16 of a unit: a small entity there is as large as rounding makes it.
#[test]
fn bounds_hold_what_rounding_moves() {
    let mut rng = Rng::with_seed(2);
    let mut moved = 0;
    for _ in 0..1000 {
        let entity = entity(&mut rng);
        let entity = Entity { position: entity.position * 1e4, scale: entity.scale * 0.01, ..entity };
        let (Sphere { center, radius }, to_world) = (entity.bounds(), entity.to_world());
        let (_, unrounded) = entity.levels.bounds();
        for p in entity.levels.finest().positions() {
            let distance = to_world.transform_point3(*p).distance(center);
            assert!(distance <= radius, "{distance}, not within {radius}");
            moved += usize::from(distance > unrounded * entity.scale.abs().max_element());
        }
    }
    assert!(moved > 100, "{moved}");
}

/// Turns in the plane of two axes: 0 from z to x (about y), 1 from x to y (about z), 2 from y to z (about x).
fn about(plane: usize, angle: f64, p: DVec3) -> DVec3 {
    let (sin, cos) = angle.sin_cos();
    match plane {
        0 => DVec3::new(p.x * cos + p.z * sin, p.y, p.z * cos - p.x * sin),
        1 => DVec3::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos, p.z),
        _ => DVec3::new(p.x, p.y * cos - p.z * sin, p.y * sin + p.z * cos),
    }
}

/// A sphere that touches a plane is seen, a little farther out it is not: each of the six planes by itself.
#[test]
fn each_plane_leaves_out_what_is_beyond_it() {
    let to_clip = frustum(-0.5, 1.0, -0.75, 0.5, 1.0, 10.0).unwrap();
    // A point of each plane, and the way out of it.
    let planes = [
        ([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]),
        ([0.0, 0.0, -10.0], [0.0, 0.0, -1.0]),
        ([-2.0, 0.0, -4.0], [-1.0, 0.0, 0.5]),
        ([4.0, 0.0, -4.0], [1.0, 0.0, 1.0]),
        ([0.0, -3.0, -4.0], [0.0, -1.0, 0.75]),
        ([0.0, 2.0, -4.0], [0.0, 1.0, 0.5]),
    ];
    for (n, (on, out)) in planes.into_iter().enumerate() {
        for radius in [0.0, 1e-3, 0.7, 3.0] {
            let beside = |gap: f32| {
                let center = Vec3::from(on) + Vec3::from(out).normalize() * (radius + gap);
                sees(&to_clip, &Sphere { center, radius })
            };
            assert!(beside(-1e-6) && beside(0.0) && !beside(3e-4), "plane {n}, radius {radius}");
        }
    }
    // Without a far plane nothing is too far.
    let endless = frustum(-0.5, 1.0, -0.75, 0.5, 1.0, f32::INFINITY).unwrap();
    for far in [11.0, 1e6, 1e30] {
        let sphere = Sphere { center: Vec3::new(0.0, 0.0, -far), radius: 0.5 };
        assert!(sees(&endless, &sphere) && !sees(&to_clip, &sphere), "{far}");
    }
}

/// What is no number is looked at, and drawn or not as lesson 11 has it.
#[test]
fn no_number_is_not_left_out() {
    let to_clip = perspective(45.0, 1.0, 0.1, 100.0).unwrap();
    for (center, radius) in [(Vec3::NAN, 1.0), (Vec3::ZERO, f32::NAN), (Vec3::ZERO, f32::INFINITY)] {
        assert!(sees(&to_clip, &Sphere { center, radius }), "{center}, {radius}");
        assert_eq!(pixels_per_unit(&to_clip, &Sphere { center, radius }, Vec2::ONE), f32::INFINITY);
    }
    assert!(sees(&Mat4::NAN, &Sphere { center: Vec3::ZERO, radius: 1.0 }));
}

/// Where a point is in the window, in `f64`, if it is in the picture.
fn window(to_clip: &Mat4, p: DVec3, size: Vec2) -> Option<DVec2> {
    let clip: DVec4 = to_clip.as_dmat4() * p.extend(1.0);
    let n = DVec2::new(clip.x, clip.y) / clip.w;
    (clip.w > 0.0 && n.abs().max_element() <= 1.0).then(|| (n + 1.0) / 2.0 * size.as_dvec2())
}

/// Two points of a sphere, both in the picture, are never farther apart there than the bound says, and nearly so far where the
/// sphere is small and in a corner of the picture.
#[test]
fn no_way_in_a_sphere_is_longer_than_the_bound() {
    let mut rng = Rng::with_seed(5);
    let (mut pairs, mut tightest) = (0, 0.0_f64);
    for _ in 0..100_000 {
        let to_clip = camera(&mut rng);
        let size = Vec2::new(between(&mut rng, 1.0, 2000.0), between(&mut rng, 1.0, 2000.0));
        // Somewhere in the picture.
        let clip = Vec3::new(
            between(&mut rng, -1.2, 1.2),
            between(&mut rng, -1.2, 1.2),
            between(&mut rng, -1.0, 0.99),
        );
        let center = to_clip.inverse().project_point3(clip);
        let radius = 10_f32.powf(between(&mut rng, -3.0, 1.0));
        let bound = f64::from(pixels_per_unit(&to_clip, &Sphere { center, radius }, size));
        let mut point = || {
            let way = vector(&mut rng, 1.0).as_dvec3();
            center.as_dvec3() + way / way.length().max(1.0) * f64::from(radius)
        };
        let [p, q] = [point(), point()];
        let (Some(a), Some(b)) = (window(&to_clip, p, size), window(&to_clip, q, size)) else { continue };
        let stretched = a.distance(b) / p.distance(q);
        assert!(stretched <= bound * (1.0 + 1e-9), "{stretched} px a unit, not within {bound}: {to_clip}");
        pairs += 1;
        tightest = tightest.max(stretched / bound);
    }
    assert!(pairs > 20_000 && tightest > 0.97, "{pairs} pairs, {tightest}");
}

/// Straight ahead, a thousandth of a unit in a view of 90 degrees 200 px high: 100 px at a distance of 1, √3 times as many in the
/// corner of a square picture, where a ray is √3 as long and meets the picture at a slant.
#[test]
fn a_unit_has_the_pixels_that_similar_triangles_give_it() {
    let to_clip = perspective(90.0, 1.0, 0.1, 100.0).unwrap();
    let size = Vec2::splat(200.0);
    for (depth, radius) in [(1.0, 0.0), (4.0, 0.0), (5.0, 1.0), (50.0, 10.0)] {
        let sphere = Sphere { center: Vec3::new(0.3, -0.2, -depth), radius };
        let expected = 100.0 * 3.0_f32.sqrt() / (depth - radius);
        let bound = pixels_per_unit(&to_clip, &sphere, size);
        assert!((bound / expected - 1.0).abs() < 1e-6, "{bound}, not {expected}");
    }
    // At the eye's depth, or around the eye.
    for (depth, radius) in [(1.0, 1.0), (0.0, 0.5), (1.0, 3.0), (-5.0, 1.0)] {
        let sphere = Sphere { center: Vec3::new(2.0, 0.0, -depth), radius };
        assert_eq!(pixels_per_unit(&to_clip, &sphere, size), f32::INFINITY);
    }
    // In parallel projection it is the same everywhere: the larger of both ways.
    let parallel = Mat4::from_diagonal(Vec4::new(0.2, 0.2, -0.5, 1.0));
    let sphere = Sphere { center: Vec3::new(30.0, 0.0, 900.0), radius: 50.0 };
    let bound = pixels_per_unit(&parallel, &sphere, Vec2::new(1024.0, 768.0));
    assert!((bound - 102.4).abs() < 1e-4, "{bound}");
}

/// Ten thousand crates all around, of which the camera sees some: the others cost no vertex.
#[test]
fn what_is_not_seen_costs_no_vertex() {
    let mut rng = Rng::with_seed(10_000);
    let crates = Levels::one(Mesh::new(&cube(), Paint::Color(Color::WHITE)));
    let entities: Vec<Entity> = (0..10_000)
        .map(|_| Entity {
            position: vector(&mut rng, 300.0),
            degrees: vector(&mut rng, 180.0),
            ..Entity::new(crates.clone())
        })
        .collect();
    let projection = perspective(45.0, 4.0 / 3.0, 0.1, 200.0).unwrap();
    let inside = |entity: &&Entity| drawn(entity, &projection).into_iter().any(is_inside);
    let [all, in_picture] = [entities.len(), entities.iter().filter(inside).count()];
    let style = Style { shading: Shading::Unlit, filter: Filtering::Nearest, cull: Cull::Back };
    let scene = Scene { entities, lights: Vec::new(), background: Color::BLACK, style };
    let Counts { outside, flattened, triangles } =
        render_scene(&scene, &mut Target::new(160, 120), &projection, &Mat4::IDENTITY);
    let seen = all - outside;
    assert_eq!((flattened, triangles.vertices), (0, 24 * seen));
    // All that have a vertex in the picture, and a few more at its border.
    assert!(
        (100..200).contains(&in_picture) && (in_picture + 1..in_picture + 20).contains(&seen),
        "{in_picture}, {seen}"
    );
}
