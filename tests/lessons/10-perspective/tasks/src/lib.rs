//! Mission 10: the matrix of a frustum, and weights in perspective.

pub use perspective_given as given;
pub use tasks::scenery::pattern;

use common::{Mat4, Vec2, Vec3, Vec4Swizzles};
use fastrand::Rng;
use tasks::scenery::{canvas, signed};
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};

use given::{Triangle, draw, to_window, view};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Perspective {
    /// The lesson's `frustum`.
    pub frustum: fn(f32, f32, f32, f32, f32, f32) -> Option<Mat4>,
    /// The lesson's `perspective_weights`.
    pub perspective_weights: fn(Vec3, Vec3) -> Vec3,
}

/// The mission.
pub const MISSION: Mission<Perspective> = Mission {
    lesson: "10-perspective",
    checks: &[
        Check {
            name: "frustum",
            asks: "the matrix of l, r, b, t, n, f",
            points: 3,
            tasks: |rng| {
                let askew = [askew(rng), askew(rng)];
                let upright = symmetric(rng);
                let [l, r, b, t, n, f] = askew[0];
                [upright, askew[0], askew[1], [r, l, b, t, n, f]].map(frustum).into()
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "far",
            asks: "the far plane at infinity, and as far away as f32 can say",
            points: 1,
            tasks: |rng| {
                let [l, r, b, t, n, _] = askew(rng);
                [f32::INFINITY, f32::MAX, 2e38].map(|f| frustum([l, r, b, t, 2.0 + n, f])).into()
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "refused",
            asks: "None for what is no frustum, and for nothing else",
            points: 1,
            tasks: |rng| {
                let good = askew(rng);
                let [l, _, b, _, n, f] = good;
                let with = |at: usize, value: f32| {
                    let mut numbers = good;
                    numbers[at] = value;
                    numbers
                };
                let mut all = vec![
                    with(4, 0.0),
                    with(4, -n),
                    with(5, n),
                    with(5, n / 2.0),
                    with(5, -f),
                    with(1, l),
                    with(3, b),
                ];
                all.extend([0, 2, 4, 5].map(|at| with(at, f32::NAN)));
                all.extend([0, 1, 2, 3, 4].map(|at| with(at, f32::INFINITY)));
                // 2n/(r − l) is no f32.
                all.push([-1e-20, 1e-20, -1.0, 1.0, 1e20, 1e21]);
                all.extend([
                    with(5, f32::NEG_INFINITY),
                    [-1.0, 1.0, -1.0, 1.0, f32::INFINITY, f32::INFINITY],
                ]);
                all.push(good);
                all.into_iter().map(frustum).collect()
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "weights",
            asks: "weights on the triangle from those in the picture and 1/w",
            points: 2,
            tasks: |rng| {
                let even = Vec3::splat(0.1 + rng.f32());
                let mut tasks = vec![weights(in_picture(rng), even), weights(Vec3::Y, depths(rng).recip())];
                tasks.extend((0..4).map(|_| weights(in_picture(rng), depths(rng).recip())));
                // Near and far apart by a million.
                tasks.push(weights(in_picture(rng), Vec3::new(1e3, 1.0 + rng.f32(), 1e-3)));
                tasks
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "rays",
            asks: "the point of a triangle that the ray through a pixel meets",
            points: 1,
            tasks: |rng| (0..4).map(|_| ray(rng)).collect(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "picture",
            asks: "a floor and a wall, in a picture and in one that is askew",
            points: 2,
            tasks: |rng| [symmetric_room(), askew_room(rng)].map(picture).into(),
            // In some pixels the last bit decides between two squares of the pattern.
            precision: Precision { tolerance: 2.0, strays: 60 },
        },
    ],
};

/// l, r, b, t, n, f.
type Numbers = [f32; 6];

/// A frustum whose middle is not the picture's.
fn askew(rng: &mut Rng) -> Numbers {
    let mut between = |low: f32, high: f32| low + (high - low) * rng.f32();
    let (l, b) = (between(-2.0, -0.5), between(-1.5, -0.4));
    [l, between(0.6, 1.4), b, between(0.3, 1.2), between(0.5, 1.5), between(4.0, 12.0)]
}

/// One straight ahead.
fn symmetric(rng: &mut Rng) -> Numbers {
    let (r, t) = (0.5 + rng.f32(), 0.5 + rng.f32());
    [-r, r, -t, t, 0.5 + rng.f32(), 5.0 + 5.0 * rng.f32()]
}

fn frustum_code(numbers: Numbers) -> String {
    format!("frustum({})", numbers.map(|number| number.code()).join(", "))
}

fn frustum(numbers: Numbers) -> Task<Perspective> {
    let [l, r, b, t, n, f] = numbers;
    Task::call("", frustum_code(numbers), move |student: &Perspective| {
        (student.frustum)(l, r, b, t, n, f).map_or_else(|| Raw::rows::<4>([]), Raw::matrix)
    })
}

/// Weights inside of a triangle, each at least a tenth.
fn in_picture(rng: &mut Rng) -> Vec3 {
    let w = Vec3::new(rng.f32(), rng.f32(), rng.f32()) + 0.25;
    w / w.element_sum()
}

/// Three depths from 1 to 10, no two alike.
fn depths(rng: &mut Rng) -> Vec3 {
    Vec3::new(1.0 + rng.f32(), 3.0 + 2.0 * rng.f32(), 6.0 + 4.0 * rng.f32())
}

fn weights(in_picture: Vec3, inverse_w: Vec3) -> Task<Perspective> {
    let call = format!("perspective_weights({}, {})", in_picture.code(), inverse_w.code());
    Task::call("", call, move |student: &Perspective| {
        Raw::value((student.perspective_weights)(in_picture, inverse_w).to_array())
    })
}

/// The point of a triangle before the eye that is seen where its corners have random weights in the picture.
fn ray(rng: &mut Rng) -> Task<Perspective> {
    let depths = depths(rng);
    let corners = depths.to_array().map(|z| Vec3::new(signed(rng) * z, signed(rng) * z, -z));
    let in_picture = in_picture(rng);
    let input = format!(
        "where the ray meets the triangle {}, with the weights {in_picture} in the picture",
        listed(&corners)
    );
    let code = format!(
        "let corners = {};\n\
         let inverse_w = Vec3::from_array(corners.map(|corner| -1.0 / corner.z));\n\
         let on_triangle = perspective_weights({}, inverse_w);\n\
         let got = corners[0] * on_triangle.x + corners[1] * on_triangle.y + corners[2] * on_triangle.z;",
        corners.code(),
        in_picture.code()
    );
    Task::new(input, code, move |student: &Perspective| {
        let inverse_w = Vec3::from_array(corners.map(|corner| -1.0 / corner.z));
        let on_triangle = (student.perspective_weights)(in_picture, inverse_w);
        let point = corners[0] * on_triangle.x + corners[1] * on_triangle.y + corners[2] * on_triangle.z;
        Raw::value(point.to_array())
    })
}

fn listed(points: &[Vec3]) -> String {
    points.iter().map(Vec3::to_string).collect::<Vec<_>>().join(", ")
}

/// Width and height of the picture.
const SIZE: [u16; 2] = [320, 240];

/// From where, and to where, the room is seen.
const VIEW: [Vec3; 3] = [Vec3::new(-0.6, 0.8, 2.6), Vec3::new(0.3, 0.3, 0.0), Vec3::Y];

/// A camera whose view is through the middle of the picture.
fn symmetric_room() -> Numbers {
    [-0.3, 0.3, -0.225, 0.225, 0.4, f32::INFINITY]
}

/// One whose view is not.
fn askew_room(rng: &mut Rng) -> Numbers {
    let (l, b) = (-0.16 - 0.08 * rng.f32(), -0.28 + 0.06 * rng.f32());
    [l, l + 0.56, b, b + 0.42, 0.4, 9.0 + rng.f32()]
}

/// A floor and a wall behind it, of two triangles each, so large that perspective shows.
#[must_use]
pub fn room() -> [Triangle; 4] {
    let halves = |[a, b, c, d]: [Vec3; 4], side: f32| {
        let [p, q, r, s] = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y].map(|corner| corner * side);
        [Triangle { corners: [a, b, c], uvs: [p, q, r] }, Triangle { corners: [a, c, d], uvs: [p, r, s] }]
    };
    let at = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
    let [a, b] =
        halves([at(-2.0, 0.0, 1.6), at(2.0, 0.0, 1.6), at(2.0, 0.0, -4.4), at(-2.0, 0.0, -4.4)], 3.0);
    let [c, d] = halves([at(2.0, 0.0, 1.0), at(2.0, 0.0, -4.4), at(2.0, 2.0, -4.4), at(2.0, 2.0, 1.0)], 2.0);
    [a, b, c, d]
}

/// The room by a student's two functions; black where there is no matrix.
fn picture(numbers: Numbers) -> Task<Perspective> {
    let [width, height] = SIZE;
    let code = format!(
        "let mut got = Image::new({width}, {height}, Format::Rgb);\n\
         let view = view({}).expect(\"eye and centre differ\");\n\
         let to_clip = {}.expect(\"it is a frustum\") * view;\n\
         draw(&perspective_tasks::room(), &perspective_tasks::pattern(), to_clip, perspective_weights, &mut got);",
        VIEW.map(|v| v.code()).join(", "),
        frustum_code(numbers)
    );
    let to_clip = move |functions: &Perspective| {
        let [l, r, b, t, n, f] = numbers;
        let [eye, center, up] = VIEW;
        Some((functions.frustum)(l, r, b, t, n, f)? * view(eye, center, up)?)
    };
    let input = format!("a floor and a wall, {width}x{height}, {}", frustum_code(numbers));
    Task::new(input, code, move |student: &Perspective| {
        let mut image = canvas(width, height);
        if let Some(to_clip) = to_clip(student) {
            draw(&room(), &pattern(), to_clip, student.perspective_weights, &mut image);
        }
        Raw::Picture(image)
    })
    .of(move |functions| {
        let size = Vec2::new(width.into(), height.into());
        let Some(to_clip) = to_clip(functions) else { return Vec::new() };
        let corner = |corner: Vec3| to_window(to_clip * corner.extend(1.0), size).xyz();
        room().map(|triangle| Shape::from(triangle.corners.map(corner))).into()
    })
}
