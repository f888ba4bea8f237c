//! What no scene should hold and some do, and what is drawn of it.

use clipping::Cull;
use common::{Color, Mat4, Vec3};
use scene::{Entity, Levels, Mesh, Paint, Shading, Shape, Target, cube, render_scene};

use crate::pictures::{
    NOWHERE, ORBIT, SIZE, SKY, WAYS, ahead, covered, cube_of, different, draw_from, lit, patched_cube, seen,
    seen_as, sphere_of,
};

/// A turned cube with a texture, scaled.
fn scaled(x: f32, y: f32, z: f32) -> Entity {
    let degrees = Vec3::new(30.0, 20.0, 10.0);
    Entity {
        scale: Vec3::new(x, y, z),
        degrees,
        position: Vec3::new(0.2, 0.1, 0.0),
        ..Entity::new(patched_cube())
    }
}

/// The same place, its mesh mirrored beforehand along some axes: made anew, with corners in the order that faces outwards.
fn remade(axes: Vec3) -> Entity {
    let Shape { mut vertices, mut triangles } = cube();
    for vertex in &mut vertices {
        (vertex.position, vertex.normal) = (vertex.position * axes, vertex.normal * axes);
    }
    if axes.x * axes.y * axes.z < 0.0 {
        triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    }
    let Entity { levels, .. } = scaled(1.0, 1.0, 1.0);
    let paint: Paint = levels.finest().paint().clone();
    let mesh = Mesh::new(&Shape { vertices, triangles }, paint);
    Entity { levels: Levels::one(mesh), ..scaled(1.5, 1.0, 0.5) }
}

/// In each way of drawing: a picture of nothing is all background.
#[test]
fn no_entity_is_the_background() {
    for [antialiased, wireframe] in WAYS {
        let picture = seen_as(&lit(Vec::new()), antialiased, wireframe);
        assert_eq!(covered(&picture), 0, "{antialiased} {wireframe}");
    }
}

/// What no light falls on is black, but it hides what is behind it; what is not to be lit needs none.
#[test]
fn without_light_things_are_black() {
    let mut scene = lit(vec![Entity::new(cube_of(Color::RED))]);
    let with = seen(&scene).0;
    scene.lights.clear();
    for shading in [Shading::Phong, Shading::BlinnPhong] {
        scene.style.shading = shading;
        let picture = seen(&scene).0;
        let pixels = || picture.pixels().map(|pixel| pixel.2);
        assert_eq!(pixels().filter(|&color| color == Color::BLACK).count(), covered(&with));
        assert!(pixels().all(|color| color == Color::BLACK || color == SKY));
    }
    scene.style.shading = Shading::Unlit;
    assert!(seen(&scene).0.pixels().all(|pixel| pixel.2 == Color::RED || pixel.2 == SKY));
}

/// A scale of 0 along any axis leaves a face or less: it is counted, and not drawn, and costs no vertex.
#[test]
fn what_is_flat_is_counted_and_not_drawn() {
    let flat = [
        [0.0, 1.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, 0.0],
        [-0.0, 1.0, -1.0],
    ];
    for [x, y, z] in flat {
        for [antialiased, wireframe] in WAYS {
            let scene = lit(vec![scaled(x, y, z)]);
            let mut target = Target::new(SIZE[0], SIZE[1]);
            (target.antialiased, target.wireframe) = (antialiased, wireframe);
            let counts = draw_from(&scene, ORBIT, &mut target);
            assert_eq!(covered(target.picture()), 0, "{x} {y} {z}");
            assert_eq!((counts.flattened, counts.outside, counts.triangles.vertices), (1, 0, 0));
        }
    }
    // What is beside it stays.
    let both = lit(vec![scaled(0.0, 1.0, 1.0), scaled(1.0, 1.0, 1.0)]);
    assert_eq!(different(&seen(&both).0, &seen(&lit(vec![scaled(1.0, 1.0, 1.0)])).0), 0);
}

/// What is merely small or thin is no such thing.
#[test]
fn thin_is_not_flat() {
    for [x, y, z] in [[1e-3, 1.0, 1.0], [1e-6, 1.0, 1.0], [1e-30, 1e-30, 1e-30], [1e12, 1e12, 1e12]] {
        let (_, counts) = seen(&lit(vec![scaled(x, y, z)]));
        assert_eq!(counts.flattened, 0, "{x} {y} {z}");
    }
    assert!(covered(&seen(&lit(vec![scaled(1e-3, 1.5, 1.5)])).0) > 0);
}

/// A negative scale mirrors. An odd number of them turns the order of corners round: without care fronts would be left out
/// instead of backs, and light would fall on the wrong side.
#[test]
fn mirrored_things_are_seen_from_outside() {
    for n in 0..8 {
        let axis = |bit: i32| if n >> bit & 1 == 1 { -1.0 } else { 1.0 };
        let axes = Vec3::new(axis(0), axis(1), axis(2));
        for cull in [Cull::Back, Cull::Front, Cull::None] {
            let picture = |entity: Entity| {
                let mut scene = lit(vec![entity]);
                scene.style.cull = cull;
                seen(&scene)
            };
            let (mirrored, counts) = picture(scaled(1.5 * axes.x, axes.y, 0.5 * axes.z));
            let (expected, expected_counts) = picture(remade(axes));
            // Corners come in another order: where a side is rounded to 1/256 px, a pixel's weights may be off by an ulp.
            let off =
                mirrored.pixels().zip(expected.pixels()).map(|(a, b)| checks::picture::distance(a.2, b.2));
            assert!(
                off.max() <= Some(1),
                "{axes} {cull:?}: {} pixels differ",
                different(&mirrored, &expected)
            );
            assert!(covered(&mirrored) > 100, "{}", covered(&mirrored));
            assert_eq!(counts.triangles.culled, expected_counts.triangles.culled);
        }
    }
    // The fault that this is about: seen are the backs.
    let mut inside_out = lit(vec![remade(Vec3::ONE)]);
    let right = seen(&inside_out).0;
    inside_out.style.cull = Cull::Front;
    let wrong = different(&right, &seen(&inside_out).0);
    assert!(wrong > 100, "{wrong}");
}

/// A camera's matrix of zeros has no inverse, and neither has the other way round: no eye, so nothing is seen.
#[test]
fn without_a_camera_nothing_is_seen() {
    let scene = lit(vec![scaled(1.0, 1.0, 1.0)]);
    let flat = Mat4::from_scale(Vec3::new(1.0, 1.0, 0.0));
    for inverse_camera in [NOWHERE, flat, Mat4::NAN, Mat4::from_translation(Vec3::splat(f32::INFINITY))] {
        for [antialiased, wireframe] in WAYS {
            let mut target = Target::new(SIZE[0], SIZE[1]);
            (target.antialiased, target.wireframe) = (antialiased, wireframe);
            let projection = ahead(target.picture().size());
            render_scene(&scene, &mut target, &projection, &inverse_camera);
            assert_eq!(covered(target.picture()), 0, "{inverse_camera}");
        }
    }
    // A projection to nothing leaves nothing to be filled, whatever the camera.
    let mut target = Target::new(SIZE[0], SIZE[1]);
    for projection in [NOWHERE, Mat4::NAN] {
        render_scene(&scene, &mut target, &projection, &Mat4::IDENTITY);
        assert_eq!(covered(target.picture()), 0);
    }
}

/// Behind the eye an entity is not there; around it one sees it from within, if backs are not left out, on all sides.
#[test]
fn entities_behind_and_around_the_camera() {
    let eye = ORBIT.camera().w_axis.truncate();
    let behind = Entity { position: 1.5 * eye, ..scaled(1.0, 1.0, 1.0) };
    let (picture, counts) = seen(&lit(vec![behind]));
    assert_eq!((covered(&picture), counts.outside, counts.triangles.vertices), (0, 1, 0));

    for levels in [cube_of(Color::WHITE), sphere_of(Color::WHITE)] {
        let around = Entity { position: eye, degrees: Vec3::new(10.0, 20.0, 30.0), ..Entity::new(levels) };
        let around = Entity { scale: Vec3::splat(3.0), ..around };
        let mut scene = lit(vec![around]);
        let (picture, counts) = seen(&scene);
        assert_eq!((covered(&picture), counts.outside), (0, 0), "backs are left out");
        for cull in [Cull::None, Cull::Front] {
            scene.style.cull = cull;
            let (picture, counts) = seen(&scene);
            assert_eq!(covered(&picture), SIZE[0] as usize * SIZE[1] as usize, "{cull:?}");
            assert_eq!(counts.triangles.left_out, 0);
        }
    }
}

/// The eye in a corner, on a face or in the middle of a cube, and at the light.
#[test]
fn the_eye_may_be_anywhere() {
    let mut scene = lit(vec![Entity::new(patched_cube()), Entity::new(sphere_of(Color::WHITE))]);
    scene.style.cull = Cull::None;
    for at in
        [Vec3::ZERO, Vec3::splat(0.5), Vec3::X / 2.0, Vec3::new(2.0, 3.0, 4.0), Vec3::new(0.0, 1.0, 0.0)]
    {
        for [antialiased, wireframe] in WAYS {
            let mut target = Target::new(SIZE[0], SIZE[1]);
            (target.antialiased, target.wireframe) = (antialiased, wireframe);
            let projection = ahead(target.picture().size());
            let counts = render_scene(&scene, &mut target, &projection, &Mat4::from_translation(-at));
            assert_eq!(counts.triangles.left_out, 0, "{at}");
        }
    }
}

/// Ten thousand cubes of one mesh: each is drawn, in a grid of as many dots as can be told apart.
#[test]
fn ten_thousand_entities_share_one_mesh() {
    let cube = cube_of(Color::WHITE);
    let at = |n: usize| Vec3::new((n % 100) as f32 - 49.5, (n / 100) as f32 - 49.5, -100.0);
    let entity = |n: usize| Entity { position: at(n), scale: Vec3::splat(0.5), ..Entity::new(cube.clone()) };
    let mut scene = lit((0..10_000).map(entity).collect());
    scene.style.shading = Shading::Unlit;
    assert_eq!(std::sync::Arc::strong_count(&cube), 10_001);
    let mut target = Target::new(400, 400);
    let projection = perspective::perspective(60.0, 1.0, 0.1, 1000.0).expect("a frustum");
    let counts = render_scene(&scene, &mut target, &projection, &Mat4::IDENTITY);
    assert_eq!((counts.outside, counts.flattened, counts.triangles.vertices), (0, 0, 240_000));
    let row: Vec<bool> = (0..400).map(|x| target.picture().get(x, 198) == Some(Color::WHITE)).collect();
    let dots = row.windows(2).filter(|pair| pair[0] != pair[1] && pair[1]).count();
    assert_eq!(dots, 100);
}

/// Ten thousand behind the eye cost no vertex.
#[test]
fn what_is_not_seen_costs_no_vertex() {
    let cube = cube_of(Color::WHITE);
    let at = |n: usize| Vec3::new((n % 100) as f32 - 49.5, (n / 100) as f32 - 49.5, 100.0);
    let scene = lit((0..10_000).map(|n| Entity { position: at(n), ..Entity::new(cube.clone()) }).collect());
    let mut target = Target::new(SIZE[0], SIZE[1]);
    let projection = ahead(target.picture().size());
    let counts = render_scene(&scene, &mut target, &projection, &Mat4::IDENTITY);
    assert_eq!((counts.outside, counts.triangles.vertices, covered(target.picture())), (10_000, 0, 0));
}

/// A picture of one pixel, one row and one column, in all ways.
#[test]
fn the_smallest_pictures() {
    let scene = lit(vec![Entity { scale: Vec3::splat(2.0), ..Entity::new(patched_cube()) }]);
    for size in [[1, 1], [1, 41], [41, 1], [3, 1]] {
        for [antialiased, wireframe] in WAYS {
            let mut target = Target::new(size[0], size[1]);
            (target.antialiased, target.wireframe) = (antialiased, wireframe);
            draw_from(&scene, ORBIT, &mut target);
            let picture = target.picture();
            assert_eq!([picture.width(), picture.height()], size.map(i32::from));
            assert!(wireframe || covered(picture) > 0, "{size:?}");
        }
    }
}

/// A resized target draws what a new one draws; resized to its own size it keeps its picture.
#[test]
fn a_resized_target_is_as_good_as_new() {
    let scene = lit(vec![scaled(1.5, 1.0, 2.0)]);
    for [antialiased, wireframe] in WAYS {
        let new = |[width, height]: [u16; 2]| {
            let mut target = Target::new(width, height);
            (target.antialiased, target.wireframe) = (antialiased, wireframe);
            draw_from(&scene, ORBIT, &mut target);
            target.into_picture()
        };
        let mut resized = Target::new(1, 1);
        (resized.antialiased, resized.wireframe) = (antialiased, wireframe);
        for size in [[64, 48], [7, 90], [90, 7], [1, 1], [64, 48], [64, 48]] {
            resized.resize(size[0], size[1]);
            assert_eq!([resized.antialiased, resized.wireframe], [antialiased, wireframe]);
            draw_from(&scene, ORBIT, &mut resized);
            assert!(*resized.picture() == new(size), "{size:?}");
            resized.resize(size[0], size[1]);
            assert!(*resized.picture() == new(size), "{size:?}");
        }
    }
}

/// A target remembers nothing of the picture before: no colour, no depth, no sample.
#[test]
fn each_picture_begins_anew() {
    let near = lit(vec![Entity { scale: Vec3::splat(3.0), ..Entity::new(cube_of(Color::WHITE)) }]);
    let far = lit(vec![scaled(1.0, 1.0, 1.0)]);
    for [antialiased, wireframe] in WAYS {
        let mut target = Target::new(SIZE[0], SIZE[1]);
        (target.antialiased, target.wireframe) = (antialiased, wireframe);
        draw_from(&near, ORBIT, &mut target);
        draw_from(&far, ORBIT, &mut target);
        assert_eq!(different(target.picture(), &seen_as(&far, antialiased, wireframe)), 0);
    }
    // Nor of another way to draw.
    let mut target = Target::new(SIZE[0], SIZE[1]);
    for [antialiased, wireframe] in WAYS.into_iter().chain(WAYS.into_iter().rev()) {
        (target.antialiased, target.wireframe) = (antialiased, wireframe);
        draw_from(&far, ORBIT, &mut target);
        assert_eq!(different(target.picture(), &seen_as(&far, antialiased, wireframe)), 0);
    }
}

/// Numbers that are none, in each of an entity's: it is not drawn, or somewhere, and what is beside it stays.
#[test]
fn numbers_that_are_none_leave_others_alone() {
    let usual = scaled(1.0, 1.0, 1.0);
    let alone = seen(&lit(vec![usual.clone()])).0;
    for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for axis in 0..3 {
            let mut vector = Vec3::ONE;
            vector[axis] = wrong;
            let entities = [
                Entity { position: vector, ..usual.clone() },
                Entity { degrees: vector, ..usual.clone() },
                Entity { scale: vector, ..usual.clone() },
            ];
            for (n, entity) in entities.into_iter().enumerate() {
                let (picture, _) = seen(&lit(vec![entity, usual.clone()]));
                assert_eq!(different(&picture, &alone), 0, "{wrong} on axis {axis} of {n}");
            }
        }
    }
}
