//! Mission 8: looking at a point.

use common::{Mat3, Mat4, Vec3};
use fastrand::Rng;
use gouraud::{Scene, Wrap, corner_normals};
use tasks::scenery::{MODEL, MODEL_CODE, SIDE, TEXTURE, TEXTURE_CODE, canvas, direction, light, point};
use tasks::{Check, Code, Mission, Precision, Raw, Task};
use transforms::{place, projection, viewport};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Camera {
    /// The lesson's `basis`.
    pub basis: fn(Vec3, Vec3, Vec3) -> Option<Mat3>,
    /// The lesson's `lookat`.
    pub lookat: fn(Vec3, Vec3, Vec3) -> Option<Mat4>,
}

/// The mission.
pub const MISSION: Mission<Camera> = Mission {
    lesson: "08-camera",
    checks: &[
        Check {
            name: "basis",
            asks: "the rows x', y', z' of the eye's basis",
            points: 3,
            tasks: |rng| views(rng, true).map(|view| basis_of(&view)).collect(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "origin",
            asks: "the view of an eye that looks at the origin",
            points: 2,
            tasks: |rng| views(rng, true).map(|view| view_of(&view)).collect(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "centre",
            asks: "the view of an eye that looks at any other point, which becomes the origin",
            points: 3,
            tasks: |rng| views(rng, false).map(|view| view_of(&view)).collect(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "one point",
            asks: "an eye at the centre looks nowhere, one beside it somewhere",
            points: 1,
            tasks: |rng| {
                let p = point(rng);
                let mut tasks = vec![basis_of(&[p, p, Vec3::Y]), view_of(&[p, p, Vec3::Y])];
                tasks.extend(views(rng, false).take(1).map(|view| view_of(&view)));
                tasks
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "picture",
            asks: "the model from the right and from above",
            points: 1,
            tasks: |rng| vec![picture(rng)],
            precision: Precision::MODEL,
        },
    ],
};

/// Eye, centre, up.
type View = [Vec3; 3];

/// Four views with eyes at distances from 2 to 4, and ups of any length at least 20° from the view.
fn views(rng: &mut Rng, to_origin: bool) -> impl Iterator<Item = View> {
    let mut view = || loop {
        let (towards, up) = (direction(rng), direction(rng));
        let center = if to_origin { Vec3::ZERO } else { point(rng) };
        if towards.cross(up).length() > 0.35 {
            return [center + towards * (2.0 + 2.0 * rng.f32()), center, up * (0.5 + 2.0 * rng.f32())];
        }
    };
    [view(), view(), view(), view()].into_iter()
}

fn call(function: &str, view: &View) -> String {
    format!("{function}({})", view.map(|v| v.code()).join(", "))
}

fn basis_of(view: &View) -> Task<Camera> {
    let [eye, center, up] = *view;
    Task::call("", call("basis", view), move |student: &Camera| {
        let basis = (student.basis)(eye, center, up);
        Raw::rows(basis.into_iter().flat_map(|m| [0, 1, 2].map(|row| m.row(row).to_array())))
    })
}

fn view_of(view: &View) -> Task<Camera> {
    let [eye, center, up] = *view;
    Task::call("", call("lookat", view), move |student: &Camera| {
        (student.lookat)(eye, center, up).map_or_else(|| Raw::rows::<4>([]), Raw::matrix)
    })
}

fn picture(rng: &mut Rng) -> Task<Camera> {
    let light = light(rng);
    let view =
        [Vec3::new(1.0, 1.0, 2.0) + 0.2 * point(rng), Vec3::new(0.2, 0.0, 0.0) + 0.1 * point(rng), Vec3::Y];
    let [eye, center, up] = view;
    let code = format!(
        "{MODEL_CODE}{TEXTURE_CODE}let mut got = Image::new({SIDE}, {SIDE}, Format::Rgb);\n\
         let (size, (eye, center)) = (got.size(), ({}, {}));\n\
         let view = {}.expect(\"eye and centre differ\");\n\
         let all = transforms::viewport(size.x, size.y, 0.3)\n    \
         * transforms::projection(eye.distance(center))\n    * view;\n\
         let normals = gouraud::corner_normals(&model);\n\
         let scene = gouraud::Scene {{ model: &model, normals: &normals, texture: &texture, wrap: gouraud::Wrap::Clamp, light: {} }};\n\
         gouraud::gouraud(&scene, &mut got, |p| transforms::place(&all, p));",
        eye.code(),
        center.code(),
        call("lookat", &view),
        light.code()
    );
    let all = move |functions: &Camera| {
        let size = f32::from(SIDE);
        let view = (functions.lookat)(eye, center, up).unwrap_or(Mat4::NAN);
        viewport(size, size, 0.3) * projection(eye.distance(center)) * view
    };
    Task::new(format!("the model from {eye} towards {center}"), code, move |student: &Camera| {
        let all = all(student);
        let mut image = canvas(SIDE, SIDE);
        let scene = Scene {
            model: &MODEL,
            normals: &corner_normals(&MODEL),
            texture: &TEXTURE,
            wrap: Wrap::Clamp,
            light,
        };
        gouraud::gouraud(&scene, &mut image, |p| place(&all, p));
        Raw::Picture(image)
    })
    .of(move |functions| {
        let all = all(functions);
        MODEL.faces().filter_map(|corners| corners.map(|p| place(&all, p)).into_iter().collect()).collect()
    })
}
