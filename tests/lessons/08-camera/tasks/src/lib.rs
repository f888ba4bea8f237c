//! Mission 8: looking at a point.

use common::{Mat3, Mat4, Vec3};
use fastrand::Rng;
use gouraud::{Scene, Wrap, corner_normals};
use tasks::scenery::{LIGHT, MODEL, SIDE, TEXTURE, canvas, direction, point};
use tasks::{Check, Mission, Precision, Raw, Task};
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
            asks: "an eye at the centre looks nowhere",
            points: 1,
            tasks: |rng| {
                let p = point(rng);
                vec![Task::new("eye = centre", move |student: &Camera| {
                    let some = (student.lookat)(p, p, Vec3::Y).is_some();
                    Raw::rows([[f32::from(u8::from(some))]])
                })]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "picture",
            asks: "the model from the right and from above",
            points: 1,
            tasks: |_| vec![Task::new("eye (1, 1, 2), centre (0.2, 0, 0)", picture)],
            precision: Precision::MODEL,
        },
    ],
};

/// Eye, centre, up.
type View = [Vec3; 3];

/// Four views with eyes at distances from 2 to 4, and ups at least 20° from the view.
fn views(rng: &mut Rng, to_origin: bool) -> impl Iterator<Item = View> {
    let mut view = || loop {
        let (towards, up) = (direction(rng), direction(rng));
        let center = if to_origin { Vec3::ZERO } else { point(rng) };
        if towards.cross(up).length() > 0.35 {
            return [center + towards * (2.0 + 2.0 * rng.f32()), center, up];
        }
    };
    [view(), view(), view(), view()].into_iter()
}

fn name([eye, center, up]: &View) -> String {
    let p = |p: &Vec3| format!("({:.2}, {:.2}, {:.2})", p.x, p.y, p.z);
    format!("eye {}, centre {}, up {}", p(eye), p(center), p(up))
}

fn basis_of(view: &View) -> Task<Camera> {
    let [eye, center, up] = *view;
    Task::new(name(view), move |student: &Camera| {
        let basis = (student.basis)(eye, center, up).unwrap_or(Mat3::NAN);
        Raw::rows([0, 1, 2].map(|row| basis.row(row).to_array()))
    })
}

fn view_of(view: &View) -> Task<Camera> {
    let [eye, center, up] = *view;
    Task::new(name(view), move |student: &Camera| {
        Raw::matrix((student.lookat)(eye, center, up).unwrap_or(Mat4::NAN))
    })
}

fn picture(student: &Camera) -> Raw {
    let (eye, center) = (Vec3::new(1.0, 1.0, 2.0), Vec3::new(0.2, 0.0, 0.0));
    let mut image = canvas(SIDE, SIDE);
    let size = image.size();
    let view = (student.lookat)(eye, center, Vec3::Y).unwrap_or(Mat4::NAN);
    let all = viewport(size.x, size.y, 0.3) * projection(eye.distance(center)) * view;
    let scene = Scene {
        model: &MODEL,
        normals: &corner_normals(&MODEL),
        texture: &TEXTURE,
        wrap: Wrap::Clamp,
        light: LIGHT,
    };
    gouraud::gouraud(&scene, &mut image, |p| place(&all, p));
    Raw::Picture(image)
}
