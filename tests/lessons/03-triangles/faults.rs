//! Each fault stands in the code here and is recognised by its result alone.

use common::Vec3;
use triangles_tasks::Triangles;

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
}

#[test]
fn each_fault_is_recognised() {
    let reference = JUDGE.reference;
    let check = |fill, check, words| {
        let functions = Triangles { fill, flat_intensity: reference.flat_intensity };
        JUDGE.recognises(&functions, check, words);
    };
    check(|corners, bounds, visit| triangles::barycentric(corners, bounds, visit), "sides", "visited twice");
    check(
        |corners, bounds, visit| {
            triangles::fill(corners, bounds, |x, y, w| visit(x, y, Vec3::new(w.y, w.z, w.x)));
        },
        "weights",
        "the weights are swapped",
    );
    let down: triangles::Visit = |corners, bounds, visit| {
        let top = bounds.max.y + bounds.min.y;
        triangles::fill(corners, bounds, |x, y, weights| visit(x, top - y, weights));
    };
    check(down, "coverage", "upside down");
    let behind = Triangles {
        flat_intensity: |[a, b, c], light| triangles::flat_intensity([a, c, b], light),
        ..reference
    };
    JUDGE.recognises(&behind, "intensity", "behind");
}
