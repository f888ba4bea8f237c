//! Mission 16: a sphere of triangles, and a camera on an orbit.

pub use scene_given as given;

use common::{Mat4, Vec3};
use fastrand::Rng;
use tasks::scenery::canvas;
use tasks::{Check, Code, Mission, Precision, Raw, Task};

use given::{Orbit, Shape, Sphere, after, cube, draw};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Scene {
    /// The lesson's `sphere`.
    pub sphere: Sphere,
    /// The lesson's `orbit`.
    pub orbit: Orbit,
}

/// The mission.
pub const MISSION: Mission<Scene> = Mission {
    lesson: "16-scene",
    checks: &[
        Check {
            name: "positions",
            asks: "where the vertices are, row by row from the north",
            points: 2,
            tasks: |rng| sizes(rng).map(positions).into(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "winding",
            asks: "the three vertices of each triangle, counterclockwise as seen from outside",
            points: 2,
            tasks: |rng| sizes(rng).map(winding).into(),
            precision: Precision::EXACT,
        },
        Check {
            name: "normals",
            asks: "normals, and where the vertices lie in a texture",
            points: 2,
            tasks: |rng| sizes(rng).map(normals).into(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "orbit",
            asks: "the camera's matrix, turned round, up, and both",
            points: 3,
            tasks: |rng| {
                let distance = 2.0 + 3.0 * rng.f32();
                let [azimuth, elevation] = [(), ()].map(|()| 15.0 + 50.0 * rng.f32());
                vec![
                    camera(0.0, 0.0, distance),
                    camera(azimuth, 0.0, distance),
                    camera(0.0, elevation, distance),
                    camera(azimuth, elevation, distance),
                    camera(-100.0 - azimuth, -elevation, 2.0 * distance),
                    camera(720.0 + 2.0 * azimuth, elevation - 89.0, 1.0 / distance),
                ]
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "picture",
            asks: "the sphere beside a cube, as the camera sees them after some keys",
            points: 1,
            tasks: |rng| vec![picture(rng, &["Right", "Up"]), picture(rng, &["Left", "Down"])],
            precision: PICTURE,
        },
    ],
};

/// Width and height of the pictures.
const SIZE: [u16; 2] = [320, 240];

/// The pixels at the borders of fields and triangles, where the last bit of a sine decides, may be others: 1 in 1000.
const PICTURE: Precision = Precision { tolerance: 2.0, strays: 76 };

/// Rows and columns of some spheres: the smallest one, more rows than columns, and more columns than rows.
fn sizes(rng: &mut Rng) -> [[usize; 2]; 4] {
    let few = [rng.usize(3..5), rng.usize(6..9)];
    let slices = [rng.usize(7..10), rng.usize(3..6)];
    let many = [rng.usize(6..10), rng.usize(11..16)];
    [[2, 3], few, slices, many]
}

/// A sphere's numbers, made of it by these functions of the shape.
fn of_a_sphere(
    [latitudes, longitudes]: [usize; 2],
    got: &str,
    work: impl Fn(&Shape) -> Raw + 'static,
) -> Task<Scene> {
    let call = format!("sphere({latitudes}, {longitudes})");
    let code = format!("let shape = {call};\n{got}");
    Task::new(call, code, move |student: &Scene| work(&(student.sphere)(latitudes, longitudes)))
}

fn positions(size: [usize; 2]) -> Task<Scene> {
    let got = "let got: Vec<_> = shape.vertices.iter().map(|vertex| vertex.position).collect();";
    of_a_sphere(size, got, |shape| Raw::rows(shape.vertices.iter().map(|vertex| vertex.position.to_array())))
}

fn winding(size: [usize; 2]) -> Task<Scene> {
    of_a_sphere(size, "let got = scene_tasks::wound(&shape);", |shape| Raw::rows(wound(shape)))
}

/// The triangles of a shape, each from its first vertex on, in order: with which of its corners a triangle begins, and which
/// triangle comes first, is nobody's business.
#[must_use]
pub fn wound(shape: &Shape) -> Vec<[f32; 3]> {
    let mut triangles = shape.triangles.clone();
    for triangle in &mut triangles {
        let first = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or_default();
        triangle.rotate_left(first);
    }
    triangles.sort_unstable();
    triangles.iter().map(|triangle| triangle.map(|vertex| vertex as f32)).collect()
}

fn normals(size: [usize; 2]) -> Task<Scene> {
    let got = "let got: Vec<_> = shape.vertices.iter().map(|vertex| (vertex.normal, vertex.uv)).collect();";
    of_a_sphere(size, got, |shape| {
        Raw::rows(shape.vertices.iter().map(|vertex| {
            let [x, y, z] = vertex.normal.to_array();
            [x, y, z, vertex.uv.x, vertex.uv.y]
        }))
    })
}

fn camera(azimuth: f32, elevation: f32, distance: f32) -> Task<Scene> {
    let call = format!("orbit({}, {}, {})", azimuth.code(), elevation.code(), distance.code());
    Task::call("", call, move |student: &Scene| Raw::matrix((student.orbit)(azimuth, elevation, distance)))
}

/// A sphere on the left and a cube on the right, after some of each of these keys, and of W.
fn picture(rng: &mut Rng, keys: &[&'static str]) -> Task<Scene> {
    let mut pressed = Vec::new();
    for &key in keys.iter().chain(&["W"]) {
        pressed.extend(std::iter::repeat_n(key, rng.usize(1..4)));
    }
    let (azimuth, elevation, distance) = after(&pressed);
    let [width, height] = SIZE;
    let input = format!("sphere(12, 24) and a cube after {}", pressed.join(" "));
    let code = format!(
        "let (azimuth, elevation, distance) = after(&{pressed:?});\n\
         let camera = orbit(azimuth, elevation, distance);\n\
         let mut got = common::Image::new({width}, {height}, common::Format::Rgb);\n\
         scene_tasks::sphere_and_cube(sphere, camera, &mut got);"
    );
    Task::new(input, code, move |student: &Scene| {
        let mut image = canvas(width, height);
        sphere_and_cube(student.sphere, (student.orbit)(azimuth, elevation, distance), &mut image);
        Raw::Picture(image)
    })
}

/// Draws a sphere of 12 rows and 24 columns, and a cube beside it.
pub fn sphere_and_cube(sphere: Sphere, camera: Mat4, image: &mut common::Image) {
    let [left, right] = [-0.8, 1.1].map(|x| Vec3::new(x, 0.0, 0.0));
    draw(&[(&sphere(12, 24), left), (&cube(), right)], camera, image);
}
