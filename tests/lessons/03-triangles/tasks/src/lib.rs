//! Mission 3: the pixels of a triangle, and how bright it is.

use common::{Bounds, Color, IVec2, Image, Vec2, Vec3};
use fastrand::Rng;
use tasks::scenery::{MODEL, MODEL_CODE, SIDE, canvas, direction, light, point};
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Triangles {
    /// The lesson's `fill`.
    pub fill: Visit,
    /// The lesson's `flat_intensity`.
    pub flat_intensity: fn([Vec3; 3], Vec3) -> f32,
}

/// Corners, bounds, and `visit(x, y, weights)`.
pub type Visit = fn([Vec2; 3], Bounds, &mut dyn FnMut(i32, i32, Vec3));

/// What may be drawn; around it the picture has a frame in which nothing may be.
const BOUNDS: Bounds = Bounds { min: IVec2::splat(8), max: IVec2::splat(71) };

/// Width and height of the picture.
const SMALL: u16 = 80;

/// That picture and the bounds in it, as Rust.
const SMALL_CODE: &str = "let mut got = Image::new(80, 80, Format::Rgb);\nlet bounds = Bounds { min: \
                          IVec2::splat(8), max: IVec2::splat(71) };\n";

/// What one visit adds to a pixel's brightness.
pub const VISIT: u8 = 100;

/// The mission.
pub const MISSION: Mission<Triangles> = Mission {
    lesson: "03-triangles",
    checks: &[
        Check {
            name: "coverage",
            asks: "every pixel whose centre is inside, no other, each visited once (twice is brighter)",
            points: 2,
            tasks: |rng| {
                let large: Vec<_> = (0..6).map(|_| coverage(vec![corners(rng)])).collect();
                large.into_iter().chain([coverage(vec![tiny(rng)])]).collect()
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "order",
            asks: "the same pixels for any order of the corners",
            points: 1,
            tasks: |rng| {
                let [a, b, c] = corners(rng);
                [[a, b, c], [b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]]
                    .map(|corners| coverage(vec![corners]))
                    .into()
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "weights",
            asks: "red, green and blue are the weights of the first, second and third corner",
            points: 1,
            tasks: |rng| {
                let [a, b, c] = corners(rng);
                [corners(rng), [a, b, c], [a, c, b]].map(weights).into()
            },
            precision: Precision::SHADED,
        },
        Check {
            name: "bounds",
            asks: "nothing is visited outside the bounds",
            points: 1,
            tasks: |rng| {
                let shift = Vec2::new(rng.i32(-4..5) as f32, rng.i32(-4..5) as f32);
                let large = [(-30.25, -20.75), (140.25, 10.75), (20.25, 170.75)];
                vec![coverage(vec![large.map(|corner| Vec2::from(corner) + shift)])]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "no area",
            asks: "three corners on a line, or two at one place, cover nothing; a triangle beside them is seen",
            points: 1,
            tasks: |rng| {
                let a = center(rng);
                let flat = [a, a + Vec2::new(10.0, 5.0), a + Vec2::new(20.0, 10.0)];
                let beside = corners(rng);
                let flat = [flat, [a, a, a + Vec2::new(9.0, 9.0)], [a; 3]];
                flat.map(|flat| coverage(vec![beside, flat])).into()
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "sides",
            asks: "centres on a side: those on a left or a level top one are covered, so that neighbours share none",
            points: 1,
            tasks: |rng| [square(rng), square(rng), fan(rng), fan(rng), fan(rng)].into(),
            precision: Precision::EXACT,
        },
        Check {
            name: "intensity",
            asks: "the cosine between normal and light, below 0 for what faces away",
            points: 2,
            tasks: |rng| {
                let mut input: Vec<[Vec3; 3]> =
                    (0..10).map(|_| [point(rng), point(rng), point(rng)]).collect();
                // Without area.
                let p = point(rng);
                input.extend([[Vec3::ZERO, Vec3::ONE, Vec3::splat(2.0)], [p, p, Vec3::X]]);
                input.into_iter().map(|corners| intensity(corners, direction(rng))).collect()
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "picture",
            asks: "the model, flat-shaded",
            points: 1,
            tasks: |rng| {
                let light = light(rng);
                let code = format!(
                    "{MODEL_CODE}let mut got = Image::new({SIDE}, {SIDE}, Format::Rgb);\n\
                     let (half, bounds) = (got.size() / 2.0, got.bounds());\n\
                     for corners in model.faces() {{\n    \
                     let intensity = flat_intensity(corners, {});\n    \
                     let screen = corners.map(|corner| corner.truncate() * half + half);\n    \
                     if intensity >= 0.0 {{\n        \
                     fill(screen, bounds, |x, y, _| got.set(x, y, Color::gray(intensity)));\n    }}\n}}",
                    light.code()
                );
                let task = Task::new("the model", code, move |student: &Triangles| {
                    let mut image = canvas(SIDE, SIDE);
                    for corners in MODEL.faces() {
                        let intensity = (student.flat_intensity)(corners, light);
                        if intensity >= 0.0 {
                            let half = image.size() / 2.0;
                            let screen = corners.map(|corner| corner.truncate() * half + half);
                            paint(student, screen, &mut image, |_, _| Color::gray(intensity));
                        }
                    }
                    Raw::Picture(image)
                });
                let half = Vec2::splat(f32::from(SIDE) / 2.0);
                vec![task.of(move |functions| {
                    let lit = MODEL.faces().filter(|&c| (functions.flat_intensity)(c, light) >= 0.0);
                    lit.map(|c| c.map(|p| (p.truncate() * half + half).extend(p.z)).into()).collect()
                })]
            },
            precision: Precision::MODEL,
        },
    ],
};

/// Colours what the student visits, wherever that is.
fn paint(student: &Triangles, corners: [Vec2; 3], image: &mut Image, color: impl Fn(Color, Vec3) -> Color) {
    let bounds = if image.width() == i32::from(SMALL) { BOUNDS } else { image.bounds() };
    (student.fill)(corners, bounds, &mut |x, y, weights| {
        let before = image.get(x, y).unwrap_or(Color::BLACK);
        image.set(x, y, color(before, weights));
    });
}

/// Draws triangles; a pixel is brighter the more often it is visited.
fn coverage(triangles: Vec<[Vec2; 3]>) -> Task<Triangles> {
    let list: Vec<String> = triangles.iter().map(Code::code).collect();
    let code = format!(
        "{SMALL_CODE}for corners in [{}] {{\n    fill(corners, bounds, |x, y, _| {{\n        \
         let level = got.get(x, y).map_or(0, |before| before.r).saturating_add({VISIT});\n        \
         got.set(x, y, Color::rgb(level, level, level));\n    }});\n}}",
        list.join(", ")
    );
    let shapes = shapes(&triangles);
    Task::new(name(&triangles), code, move |student: &Triangles| {
        let mut image = canvas(SMALL, SMALL);
        for &corners in &triangles {
            paint(student, corners, &mut image, |before, _| {
                let level = before.r.saturating_add(VISIT);
                Color::rgb(level, level, level)
            });
        }
        Raw::Picture(image)
    })
    .of(move |_| shapes.clone())
}

fn shapes(triangles: &[[Vec2; 3]]) -> Vec<Shape> {
    triangles.iter().map(|corners| corners.map(|corner| corner.extend(0.0)).into()).collect()
}

/// Draws one triangle in the colours of its weights.
fn weights(corners: [Vec2; 3]) -> Task<Triangles> {
    let code = format!(
        "{SMALL_CODE}fill({}, bounds, |x, y, weights| {{\n    \
         let [r, g, b] = weights.to_array().map(|weight| (weight * 255.0).round() as u8);\n    \
         got.set(x, y, Color::rgb(r, g, b));\n}});",
        corners.code()
    );
    let shapes = shapes(&[corners]);
    Task::new(name(&[corners]), code, move |student: &Triangles| {
        let mut image = canvas(SMALL, SMALL);
        paint(student, corners, &mut image, |_, weights| {
            let [r, g, b] = weights.to_array().map(|weight| (weight * 255.0).round() as u8);
            Color::rgb(r, g, b)
        });
        Raw::Picture(image)
    })
    .of(move |_| shapes.clone())
}

/// How bright a triangle in space is.
fn intensity(corners: [Vec3; 3], light: Vec3) -> Task<Triangles> {
    let call = format!("flat_intensity({}, {})", corners.code(), light.code());
    Task::call("", call, move |student: &Triangles| Raw::value([(student.flat_intensity)(corners, light)]))
}

fn name(triangles: &[[Vec2; 3]]) -> String {
    match triangles {
        [[a, b, c]] => {
            format!("fill([({}, {}), ({}, {}), ({}, {})], …)", a.x, a.y, b.x, b.y, c.x, c.y)
        }
        [_, _] => "two triangles".into(),
        _ => format!("{} triangles around a point", triangles.len()),
    }
}

/// Corners in 1/16 px, in which no rounding is needed, such that no pixel's centre lies on a side.
fn corners(rng: &mut Rng) -> [Vec2; 3] {
    let mut corner = || IVec2::new(rng.i32(160..1120), rng.i32(160..1120));
    loop {
        let [a, b, c] = [corner(), corner(), corner()];
        let on_side = |p: IVec2| [(a, b), (b, c), (c, a)].iter().any(|&(a, b)| (b - a).perp_dot(p - a) == 0);
        let clear = (10..70).all(|y| (10..70).all(|x| !on_side(IVec2::new(x, y) * 16 + 8)));
        let doubled = (b - a).perp_dot(c - a).abs();
        // Of more than 100 pixels.
        if clear && doubled > 2 * 100 * 16 * 16 {
            return [a, b, c].map(|corner| corner.as_vec2() / 16.0);
        }
    }
}

/// Of less than half a pixel, around a centre.
fn tiny(rng: &mut Rng) -> [Vec2; 3] {
    let around = [(-0.25, -0.125), (0.375, -0.125), (0.0, 0.375)];
    let middle = center(rng);
    shuffled(rng, around.map(|way| middle + Vec2::from(way)))
}

/// A pixel's centre.
fn center(rng: &mut Rng) -> Vec2 {
    Vec2::new(rng.i32(34..46) as f32, rng.i32(34..46) as f32) + 0.5
}

/// Corners in any order, clockwise or not.
fn shuffled(rng: &mut Rng, mut corners: [Vec2; 3]) -> [Vec2; 3] {
    rng.shuffle(&mut corners);
    corners
}

/// Two triangles, one clockwise, one not, with all corners and sides through pixels' centres.
fn square(rng: &mut Rng) -> Task<Triangles> {
    // Sides in which some quotients have rounding errors.
    let (a, side) = (center(rng), rng.i32(9..16) as f32);
    let [b, c, d] = [(side, 0.0), (side, side), (0.0, side)].map(|way| a + Vec2::from(way));
    coverage(if rng.bool() { vec![[a, b, c], [a, d, c]] } else { vec![[a, c, b], [c, d, a]] })
}

/// Triangles around a pixel's centre that cover all there is. Their common sides run through many centres.
fn fan(rng: &mut Rng) -> Task<Triangles> {
    let middle = center(rng);
    let quarter = [(1, 0), (2, 1), (1, 1), (1, 2)].map(IVec2::from);
    let turned = |n: usize| (0..n / 4).fold(quarter[n % 4], |corner, _| corner.perp());
    let around = |n: usize| middle + 60.0 * turned(n % 16).as_vec2();
    coverage((0..16).map(|n| shuffled(rng, [middle, around(n), around(n + 1)])).collect())
}
