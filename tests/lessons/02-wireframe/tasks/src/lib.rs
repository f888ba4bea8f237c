//! Mission 2: a model's edges.

use common::{Color, IVec2, Image, Model, Vec3};
use fastrand::Rng;
use tasks::scenery::{MODEL, MODEL_CODE, canvas, signed, wide};
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Wireframe {
    /// The lesson's `wireframe`.
    pub wireframe: fn(&Model, &mut Image, Color),
    /// The lesson's `to_pixel`.
    pub to_pixel: fn(Vec3, &Image) -> IVec2,
}

/// Width and height of the small pictures.
pub const SIZE: IVec2 = IVec2::new(60, 40);

/// The same of a very small one, both odd.
const ODD: IVec2 = IVec2::new(7, 5);

/// The mission.
pub const MISSION: Mission<Wireframe> = Mission {
    lesson: "02-wireframe",
    checks: &[
        Check {
            name: "pixel",
            asks: "the pixel in which a point lies",
            points: 2,
            tasks: |rng| {
                let mut inside = || Vec3::new(within(rng, SIZE.x), within(rng, SIZE.y), signed(rng));
                let mut tasks: Vec<_> = (0..12).map(|_| pixel(inside())).collect();
                // Half of an odd side is not a whole number, which shows at the far end.
                let [x, y] = [ODD.x, ODD.y].map(|side| (side as f32 - 1.4) * 2.0 / side as f32 - 1.0);
                tasks.push(pixel_of(Vec3::new(x, y, 0.0), ODD));
                tasks
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "border",
            asks: "a point at exactly 1 lies in the last column or row",
            points: 2,
            tasks: |rng| {
                let (x, y) = (within(rng, SIZE.x), within(rng, SIZE.y));
                let points = [(1.0, y), (x, 1.0), (1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (-1.0, y)];
                points.map(|(x, y)| pixel(Vec3::new(x, y, 0.0))).into()
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "outside",
            asks: "a point beyond the border lies beyond the picture",
            points: 1,
            tasks: |rng| {
                let (x, y) = (within(rng, SIZE.x), within(rng, SIZE.y));
                let beside = [(1.01, y), (x, 1.01)];
                let points = [(-1.01, y), (x, -1.01), (1.2, y), (x, 1.2), (-3.01, -2.02)];
                let points = points.into_iter().chain(beside);
                points.map(|(x, y)| pixel(Vec3::new(x, y, 0.0))).collect()
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "rounding",
            asks: "a point next to a pixel's border lies on its own side of it, to the last bit",
            points: 1,
            tasks: |rng| {
                let (x, y) = (within(rng, SIZE.x), within(rng, SIZE.y));
                let points = [(BELOW_1, y), (x, BELOW_1), (-1e-8, y), (x, -1e-8)];
                points.map(|(x, y)| pixel(Vec3::new(x, y, 0.0))).into()
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "edges",
            asks: "all three sides of a few triangles",
            points: 2,
            tasks: |rng| (0..4).map(|n| few(rng, n % 2 == 1)).collect(),
            precision: Precision::EXACT,
        },
        Check {
            name: "picture",
            asks: "the model",
            points: 2,
            tasks: |rng| {
                let [width, height] = wide(rng);
                let code = format!(
                    "{MODEL_CODE}let mut got = Image::new({width}, {height}, Format::Rgb);\n\
                     wireframe(&model, &mut got, Color::WHITE);"
                );
                let input = format!("the model, {width}x{height}");
                let task = Task::new(input, code, move |student: &Wireframe| {
                    let mut image = canvas(width, height);
                    (student.wireframe)(&MODEL, &mut image, Color::WHITE);
                    Raw::Picture(image)
                });
                vec![task.of(move |functions| sides(functions, &MODEL, &canvas(width, height)))]
            },
            // Points of the model may lie on a pixel's border, where the last bit decides.
            precision: Precision { tolerance: 0.0, ..Precision::MODEL },
        },
    ],
};

/// The largest number below 1.
const BELOW_1: f32 = 1.0f32.next_down();

/// A coordinate well inside a pixel's upper or right quarter, where rounding goes wrong and cutting off does not.
fn within(rng: &mut Rng, size: i32) -> f32 {
    let pixel = rng.i32(0..size - 1) as f32 + 0.6 + 0.3 * rng.f32();
    pixel * 2.0 / size as f32 - 1.0
}

/// The pixel of a point.
fn pixel(point: Vec3) -> Task<Wireframe> {
    pixel_of(point, SIZE)
}

/// The pixel of a point in a picture of another size.
fn pixel_of(point: Vec3, size: IVec2) -> Task<Wireframe> {
    let before = format!("let image = Image::new({}, {}, Format::Rgb);\n", size.x, size.y);
    let call = format!("to_pixel({}, &image)", point.code());
    let task = Task::call(&before, call, move |student: &Wireframe| {
        let image = canvas(size.x as u16, size.y as u16);
        Raw::value((student.to_pixel)(point, &image).as_vec2().to_array())
    });
    Task { input: format!("to_pixel({}, an image of {}x{})", point.code(), size.x, size.y), ..task }
}

/// Three triangles with corners in the middle of pixels; the last two share a side. One corner may lie outside.
fn few(rng: &mut Rng, outside: bool) -> Task<Wireframe> {
    const TRIANGLES: [[u32; 3]; 3] = [[0, 1, 2], [3, 4, 5], [5, 4, 6]];
    let mut corner = || {
        let pixel = [SIZE.x, SIZE.y].map(|size| (rng.i32(0..size) as f32 + 0.5) * 2.0 / size as f32 - 1.0);
        Vec3::new(pixel[0], pixel[1], 0.0)
    };
    let mut positions = [(); 7].map(|()| corner());
    if outside {
        positions[6].x += 2.0;
    }
    let code = format!(
        "let model = Model::from_triangles(vec!{}, vec!{TRIANGLES:?}).expect(\"it is one\");\n\
         let mut got = Image::new({}, {}, Format::Rgb);\nwireframe(&model, &mut got, Color::GREEN);",
        positions.code(),
        SIZE.x,
        SIZE.y
    );
    let model =
        Model::from_triangles(positions.to_vec(), TRIANGLES.to_vec()).expect("its corners are finite");
    let small = || canvas(SIZE.x as u16, SIZE.y as u16);
    let drawn = model.clone();
    Task::new("three green triangles", code, move |student: &Wireframe| {
        let mut image = small();
        (student.wireframe)(&drawn, &mut image, Color::GREEN);
        Raw::Picture(image)
    })
    .of(move |functions| sides(functions, &model, &small()))
}

/// The sides of a model's triangles, from the middle of a pixel to that of another.
fn sides(functions: &Wireframe, model: &Model, image: &Image) -> Vec<Shape> {
    let center = |corner| ((functions.to_pixel)(corner, image).as_vec2() + 0.5).extend(0.0);
    let triangles = model.faces().map(|corners| corners.map(center));
    triangles.flat_map(|[a, b, c]| [vec![a, b], vec![b, c], vec![c, a]]).collect()
}
