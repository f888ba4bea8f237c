//! Each fault stands in the code here and is recognised by its result alone.

use common::Vec3;
use transforms_tasks::Transforms;

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
}

#[test]
fn each_fault_is_recognised() {
    let reference = JUDGE.reference;
    let viewport = |viewport, words| {
        let functions = Transforms { viewport, ..reference };
        JUDGE.recognises(&functions, "viewport", words);
    };
    viewport(|w, h, zoom| transforms::viewport(w, h, zoom).transpose(), "rows and columns");
    viewport(
        |w, h, zoom| transforms::viewport(w, h, zoom) * transforms::scale(Vec3::new(1.0, -1.0, 1.0)),
        "upside down",
    );
    viewport(|w, h, zoom| transforms::viewport(w, h, zoom / 2.0), "half as large");
    viewport(
        |w, h, zoom| {
            transforms::scale(Vec3::new(w * zoom, h * zoom, 1.0))
                * transforms::translate(Vec3::new(w / 2.0, h / 2.0, 0.0))
        },
        "order of the product",
    );
    let projection = |projection, words| {
        let functions = Transforms { projection, ..reference };
        JUDGE.recognises(&functions, "projection", words);
    };
    projection(|d| transforms::projection(-d), "the sign is wrong");
    projection(|d| transforms::projection(d).transpose(), "rows and columns");
    let behind = Transforms { place: |m, p| Some(m.project_point3(p)), ..reference };
    JUDGE.recognises(&behind, "behind", "behind the eye");
}
