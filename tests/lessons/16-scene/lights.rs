//! The assignment's light: at the eye, at the corners, of a camera that has no eye.

use checks::lamp::{Highlight, Lamp, alike};
use clipping::Cull;
use common::{Color, DVec3, Vec3};
use lighting::{PointLight, blinn_phong, phong};
use proptest::prelude::*;
use scene::{Entity, Levels, Mesh, Paint, Shading, Shape, Vertex, cube};

use crate::pictures::{FIELD_OF_VIEW, ORBIT, cube_of, different, lit, seen, sphere_of};
use crate::truth::{Eye, Truth, lamp, placement};
use crate::versions::{drawn, scene_at};

fn point() -> impl Strategy<Value = Vec3> {
    [-3.0..3.0_f32, -3.0..3.0_f32, 1.0..3.0_f32].prop_map(Vec3::from)
}

proptest! {
    /// With the light at the eye r·v is cos 2θ and n·h is cos θ, by the angle of the normal alone: a highlight lies where a
    /// surface faces the eye, by either model.
    #[test]
    fn at_the_eye_a_light_shows_where_surfaces_face_it(at in point(), normal in point()) {
        let light = PointLight { position: Vec3::ZERO, ..PointLight::default() };
        // Of the two sides the one that is seen.
        let cosine = normal.normalize().dot(-at.normalize());
        let normal = normal * cosine.signum();
        let cosine = cosine.abs();
        prop_assume!(cosine > 0.05);
        let mirrored = (2.0 * cosine * cosine - 1.0).max(0.0);
        for (got, cosine) in [(phong(at, normal, Vec3::ZERO, &light), mirrored), (blinn_phong(at, normal, Vec3::ZERO, &light), cosine)] {
            // The power makes 32 times as much of a cosine's few ulps.
            let expected = 0.4 * f64::from(cosine).powf(32.0);
            prop_assert!((f64::from(got.highlight) - expected).abs() < 1e-4, "{}, not {expected}", got.highlight);
        }
    }
}

/// An orthographic camera looks along z from everywhere, so it has no eye; but the assignment's stands at (0, 0, 0), and that is
/// what lights are seen from here, in any projection. Seen along z instead, highlights would lie elsewhere.
#[test]
fn the_eye_is_the_cameras_place_in_an_orthographic_view_too() {
    for (number, least) in [(3, 10.0), (4, 20.0)] {
        let scene = scene_at(number, 0.0);
        let picture = drawn(&scene, number).0;
        Truth::new(&scene, Eye::Orthographic).check(&picture, 1.02, 0.1);
        let off = Truth::new(&scene, Eye::AlongZ).worst(&picture);
        assert!(off > least, "version {number}: {off}");
    }
}

/// What version 3 lights at its corners has no highlight on the cube: the four corners of its front see the light aslant, but the
/// face is nearest to it in the middle of a side. Version 4 has it.
#[test]
fn at_corners_a_highlight_is_lost() {
    // Of the red cube, green is what white there is: of the highlight alone.
    let green = |number: usize| {
        let mut scene = scene_at(number, 0.0);
        scene.entities.truncate(1);
        drawn(&scene, number).0.pixels().map(|pixel| pixel.2.g).max()
    };
    assert_eq!(green(3), Some(0));
    assert!(green(4) >= Some(95), "{:?}", green(4));
}

/// Version 3 is lit at corners, version 4 at pixels: rays that are lit the other way are off by far.
#[test]
fn corners_and_pixels_are_told_apart() {
    for (number, other) in [(3, Shading::BlinnPhong), (4, Shading::Phong)] {
        let mut scene = scene_at(number, 0.0);
        let picture = drawn(&scene, number).0;
        scene.style.shading = other;
        let off = Truth::new(&scene, Eye::Orthographic).worst(&picture);
        assert!(off > 40.0, "version {number}: {off}");
    }
}

/// Blinn's highlight is like Phong's with about four times the exponent, where light and eye are in one direction, as here; with
/// the same one it is much larger.
#[test]
fn blinns_model_is_no_approximation_with_the_same_exponent() {
    let [best, least] = alike(32.0, 0.0, false);
    assert!((3.5..4.5).contains(&(best / 32.0)) && least < 0.02, "{best} {least}");
    let [wide, narrow] = [0.2_f64.cos().powf(32.0), 0.4_f64.cos().powf(32.0)];
    assert!(wide - narrow > 0.4);
    // Versions 3 and 4 have one light: its exponent is the same.
    let [third, fourth] = [3, 4].map(|number| scene_at(number, 0.0).lights);
    assert_eq!(third, fourth);
}

/// Lights are added, and each brings its own ambient light; what is too bright for a byte is clamped, and does not begin again
/// at 0.
#[test]
fn two_lights_are_added_and_clamped() {
    let mut scene = lit(vec![Entity::new(cube_of(Color::WHITE))]);
    let light = scene.lights[0];
    let ambient = PointLight { diffuse: 0.0, specular: 0.0, ..light };
    let level = |lights: Vec<PointLight>, scene: &mut scene::Scene| {
        scene.lights = lights;
        let picture = seen(scene).0;
        picture.pixels().map(|pixel| pixel.2.r).max().expect("pixels")
    };
    assert_eq!(level(vec![ambient], &mut scene), 51);
    assert_eq!(level(vec![ambient; 2], &mut scene), 102);
    assert_eq!(level(vec![ambient; 7], &mut scene), 255);
    // Of any lights, in f64: in front, behind, inside and at the eye; fading or not.
    let positions = [[2.0, 3.0, 4.0], [-3.0, 0.5, 1.0], [0.0, 0.0, -4.0], [0.1, 0.0, 0.0]].map(Vec3::from);
    let falloffs = [
        lighting::light::Falloff::None,
        lighting::light::Falloff::Linear,
        lighting::light::Falloff::Quadratic,
    ];
    let several =
        |n: usize| PointLight { position: positions[n], falloff: falloffs[n % 3], shininess: 20.0, ..light };
    scene.lights = (0..4).map(several).collect();
    scene.entities.push(Entity {
        position: Vec3::new(1.5, 0.0, 0.0),
        ..Entity::new(sphere_of(Color::rgb(90, 60, 120)))
    });
    for shading in [Shading::Phong, Shading::BlinnPhong] {
        scene.style.shading = shading;
        let truth = Truth::new(&scene, Eye::Around(ORBIT, FIELD_OF_VIEW));
        truth.check(&seen(&scene).0, 1.02, 0.2);
    }
}

/// A normal is no point and no direction of the surface: stretched, it needs the inverse transpose.
#[test]
fn normals_go_with_the_surface() {
    let stretched = Entity {
        scale: Vec3::new(1.2, 0.4, 1.8),
        degrees: Vec3::new(20.0, -30.0, 50.0),
        ..Entity::new(sphere_of(Color::WHITE))
    };
    let scene = lit(vec![stretched.clone()]);
    for shading in [Shading::Phong, Shading::BlinnPhong] {
        let mut scene = lit(vec![stretched.clone()]);
        scene.style.shading = shading;
        Truth::new(&scene, Eye::Around(ORBIT, FIELD_OF_VIEW)).check(&seen(&scene).0, 1.02, 0.25);
    }
    // Brought along as points are, some normals would be off by tens of levels of light.
    let (placement, lamp) = (placement(&stretched), lamp(&scene.lights[0]));
    let worst = stretched.levels.finest().normals().iter().map(|normal| {
        let own = checks::assignment::mirrored(normal.as_dvec3());
        let as_point = placement.place(own) - placement.position;
        let on = |normal: DVec3| {
            let [body, shine] = Lamp::on(
                &lamp,
                DVec3::ZERO,
                checks::assignment::mirrored(normal),
                DVec3::Z * 5.0,
                Highlight::Halfway,
            );
            255.0 * (body + shine)
        };
        (on(placement.normal(own)) - on(as_point)).abs()
    });
    assert!(worst.fold(0.0, f64::max) > 60.0);
}

/// A cube of eight vertices has one normal at each, between three faces: it is lit like a ball.
#[test]
fn a_cube_needs_24_vertices() {
    let shared = Shape {
        vertices: (0..8)
            .map(|n| {
                let corner = Vec3::new((n & 1) as f32, (n >> 1 & 1) as f32, (n >> 2) as f32) - 0.5;
                Vertex { position: corner, normal: corner.normalize(), uv: common::Vec2::ZERO }
            })
            .collect(),
        triangles: vec![
            [0, 2, 3],
            [0, 3, 1],
            [4, 5, 7],
            [4, 7, 6],
            [0, 1, 5],
            [0, 5, 4],
            [2, 6, 7],
            [2, 7, 3],
            [0, 4, 6],
            [0, 6, 2],
            [1, 3, 7],
            [1, 7, 5],
        ],
    };
    let at = |levels| Entity { degrees: Vec3::new(10.0, 20.0, 0.0), ..Entity::new(levels) };
    let round = at(Levels::one(Mesh::new(&shared, Paint::Color(Color::WHITE))));
    let picture = |entity: Entity| {
        let mut scene = lit(vec![entity]);
        let all = seen(&scene).0;
        scene.style.cull = Cull::None;
        // It is closed, and its triangles run counterclockwise outside.
        assert_eq!(different(&all, &seen(&scene).0), 0);
        all
    };
    let [round, edged] = [picture(round), picture(at(cube_of(Color::WHITE)))];
    let off = round.pixels().zip(edged.pixels()).map(|(a, b)| checks::picture::distance(a.2, b.2));
    let off: Vec<u8> = off.collect();
    let [some, most] = [15, 60].map(|least| off.iter().filter(|&&off| off > least).count());
    assert!(some > 50 && most > 10, "{some} {most}");
    assert_eq!((cube().vertices.len(), cube().triangles.len()), (24, 12));
}

/// Nor can eight corners have texture coordinates that show the whole texture on each face, not even mirrored: none of all 4⁸
/// ways does.
#[test]
fn eight_corners_cannot_show_a_texture_on_each_face() {
    // A face's corners in turn; the texture's are 0, 1, 2 and 3 in turn.
    let faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let whole = |ways: u32, face: &[usize; 4]| {
        let corner = |n: usize| ways >> (2 * face[n % 4]) & 3;
        [1, 3].iter().any(|step| (0..4).all(|n| corner(n + 1) == (corner(n) + step) % 4))
    };
    let most = (0..1_u32 << 16).map(|ways| faces.iter().filter(|face| whole(ways, face)).count()).max();
    assert_eq!(most, Some(4));
}
