//! Lines instead of surfaces: the sides of all triangles, where a line through two points in space is seen.

use clipping::Cull;
use common::{Color, DVec2, DVec4, Mat4, Vec3};
use scene::{Counts, Entity, Levels, Mesh, Paint, Scene, Shape, Target, cube, render_scene};

use crate::pictures::{ORBIT, SKY, ahead, cube_of, different, lit, patched_cube, sphere_of};

/// Wide enough for lines to lie apart.
const SIZE: [u16; 2] = [200, 150];

/// What is seen of a line between two points of clip space, in pixels: the part that is inside of all six planes.
fn seen(ends: [DVec4; 2], size: DVec2) -> Option<[DVec2; 2]> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let [a, b] = ends.map(|end| end.w + sign * end[axis]);
            let crossing = a / (a - b);
            match [a < 0.0, b < 0.0] {
                [true, true] => return None,
                [true, false] => from = from.max(crossing),
                [false, true] => to = to.min(crossing),
                [false, false] => {}
            }
        }
    }
    let place = |t: f64| {
        let point = ends[0] + (ends[1] - ends[0]) * t;
        (DVec2::new(point.x, point.y) / point.w + 1.0) / 2.0 * size
    };
    (from < to).then(|| [place(from), place(to)])
}

/// The lines that should be there: each side of each triangle that is not left out, once.
fn lines(scene: &Scene, to_clip: &Mat4) -> Vec<[DVec2; 2]> {
    let size = DVec2::new(SIZE[0].into(), SIZE[1].into());
    let mut lines = Vec::new();
    for entity in &scene.entities {
        let (mesh, matrix) = (entity.levels.finest(), (*to_clip * entity.to_world()).as_dmat4());
        for face in 0..mesh.triangles() {
            let corners = [0, 1, 2]
                .map(|corner| matrix * mesh.positions()[mesh.vertex(face, corner)].as_dvec3().extend(1.0));
            // The determinant of the three (x, y, w) tells which side is seen, wherever they are.
            let [a, b, c] = corners.map(|corner| common::DVec3::new(corner.x, corner.y, corner.w));
            let front = a.dot(b.cross(c)) * entity.scale.as_dvec3().to_array().iter().product::<f64>() > 0.0;
            if scene.style.cull == Cull::None || front == (scene.style.cull == Cull::Back) {
                let sides = [0, 1, 2].map(|n| seen([corners[n], corners[(n + 1) % 3]], size));
                lines.extend(sides.into_iter().flatten());
            }
        }
    }
    lines
}

fn drawn(scene: &Scene, inverse_camera: &Mat4, antialiased: bool) -> (common::Image, Counts, Mat4) {
    let mut target = Target::new(SIZE[0], SIZE[1]);
    (target.antialiased, target.wireframe) = (antialiased, true);
    let projection = ahead(target.picture().size());
    let counts = render_scene(scene, &mut target, &projection, inverse_camera);
    (target.into_picture(), counts, projection * *inverse_camera)
}

/// How far a place is from a line.
fn distance(at: DVec2, [from, to]: [DVec2; 2]) -> f64 {
    let way = to - from;
    let along = ((at - from).dot(way) / way.length_squared().max(1e-12)).clamp(0.0, 1.0);
    (at - from - along * way).length()
}

/// Every pixel drawn is on a line, and along every line there are pixels: ends are whole pixels, half a diagonal away at most,
/// and a line's pixels half a pixel from it.
#[track_caller]
fn check(scene: &Scene, inverse_camera: &Mat4) -> usize {
    let (picture, counts, to_clip) = drawn(scene, inverse_camera, false);
    assert_eq!(counts.triangles.left_out, 0);
    let lines = lines(scene, &to_clip);
    let center = |x: i32, y: i32| DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
    let there: Vec<DVec2> =
        picture.pixels().filter(|pixel| pixel.2 != SKY).map(|(x, y, _)| center(x, y)).collect();
    const FAR: f64 = 1.25;
    for &at in &there {
        assert!(lines.iter().any(|&line| distance(at, line) < FAR), "{at} is on no line");
    }
    for &[from, to] in &lines {
        let steps = (to - from).length().ceil().max(1.0) as i32;
        for n in 0..=steps {
            let at = from + (to - from) * f64::from(n) / f64::from(steps);
            assert!(
                there.iter().any(|pixel| (*pixel - at).length() < FAR),
                "nothing at {at} from {from} to {to}"
            );
        }
    }
    there.len()
}

/// Of all that is in front, and of what reaches behind the eye or beyond the picture's borders, which is cut as triangles are.
#[test]
fn every_side_is_drawn_where_it_is_seen() {
    let turned = |levels| Entity { degrees: Vec3::new(25.0, 40.0, 15.0), ..Entity::new(levels) };
    for levels in [cube_of(Color::RED), sphere_of(Color::GREEN), patched_cube()] {
        for cull in [Cull::Back, Cull::Front, Cull::None] {
            for scale in [Vec3::ONE, Vec3::new(-1.5, 1.0, 0.7)] {
                let mut scene = lit(vec![Entity { scale, ..turned(levels.clone()) }]);
                scene.style.cull = cull;
                let from_afar = transforms::inverse::rigid(&ORBIT.camera());
                assert!(check(&scene, &from_afar) > 100);
                // From beside it, and from within.
                for at in [Vec3::new(0.3, 0.2, 0.9), Vec3::new(0.1, -0.05, 0.2)] {
                    check(&scene, &transforms::affine::translate(-at));
                }
            }
        }
    }
}

/// "The lines that link the points" of twelve triangles are eighteen, of which a cube has twelve: six are diagonals.
#[test]
fn diagonals_are_lines_too() {
    let mut scene = lit(vec![Entity { scale: Vec3::splat(2.0), ..Entity::new(cube_of(Color::WHITE)) }]);
    scene.style.cull = Cull::None;
    let (picture, ..) = drawn(&scene, &transforms::affine::translate(Vec3::new(0.0, 0.0, -4.0)), false);
    // The front face's middle is on its diagonal, and nothing else is between that and the back's.
    let [x, y] = SIZE.map(|side| i32::from(side) / 2);
    let around = (-2..2).flat_map(|i| (-2..2).map(move |j| (x + i, y + j)));
    assert!(around.filter(|&(x, y)| picture.get(x, y) != Some(SKY)).count() >= 4);
    let mesh = scene.entities[0].levels.finest();
    let mut sides: Vec<[[i32; 3]; 2]> = (0..12)
        .flat_map(|face| {
            let corners = [0, 1, 2].map(|corner| {
                mesh.positions()[mesh.vertex(face, corner)].to_array().map(|c| (2.0 * c) as i32)
            });
            [0, 1, 2].map(|n| {
                let mut side = [corners[n], corners[(n + 1) % 3]];
                side.sort_unstable();
                side
            })
        })
        .collect();
    sides.sort_unstable();
    sides.dedup();
    assert_eq!(sides.len(), 18);
}

/// A line is drawn once, however many triangles have it as a side: of a mesh with all its triangles twice, a translucent or a
/// smooth line is as bright as of the mesh with each once.
#[test]
fn shared_sides_are_drawn_once() {
    let Shape { vertices, mut triangles } = cube();
    triangles.extend(triangles.clone());
    let twice = Levels::one(Mesh::new(&Shape { vertices, triangles }, Paint::Color(Color::WHITE)));
    let camera = transforms::inverse::rigid(&ORBIT.camera());
    for antialiased in [false, true] {
        let [once, twice] = [cube_of(Color::WHITE), twice.clone()].map(|levels| {
            let cube = Entity { alpha: 0.5, degrees: Vec3::new(25.0, 40.0, 15.0), ..Entity::new(levels) };
            drawn(&lit(vec![cube]), &camera, antialiased).0
        });
        assert_eq!(different(&once, &twice), 0);
        // Along a side between two faces that are both seen, where no other line is, it is half of the way to white.
        let half = Color::rgb(132, 137, 147);
        assert!(antialiased || once.pixels().filter(|pixel| pixel.2 == half).count() > 60);
    }
}

/// Smooth lines are where the others are, each pixel with a share of the colour.
#[test]
fn smooth_lines_are_where_the_others_are() {
    let scene =
        lit(vec![Entity { degrees: Vec3::new(25.0, 40.0, 15.0), ..Entity::new(cube_of(Color::WHITE)) }]);
    let camera = transforms::inverse::rigid(&ORBIT.camera());
    let [sharp, smooth] = [false, true].map(|antialiased| drawn(&scene, &camera, antialiased).0);
    let (lines, full) = (lines(&scene, &drawn(&scene, &camera, true).2), Color::WHITE);
    let (mut partial, mut all) = (0, 0);
    for (x, y, color) in smooth.pixels().filter(|pixel| pixel.2 != SKY) {
        let at = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        assert!(lines.iter().any(|&line| distance(at, line) < 1.8), "{at}");
        partial += usize::from(color != full);
        all += 1;
    }
    let sharp = sharp.pixels().filter(|pixel| pixel.2 != SKY).count();
    assert!(all > sharp && 2 * partial > all, "{partial} of {all}, {sharp}");
}
