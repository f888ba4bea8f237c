//! Each fault stands in the code here and is recognised by its result alone.

use common::Vec3;
use zbuffer_tasks::Zbuffer;

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
}

#[test]
fn each_fault_is_recognised() {
    let reference = JUDGE.reference;
    let check = |fill_nearest, check, words| {
        let functions = Zbuffer { fill_nearest, z_f32: reference.z_f32 };
        JUDGE.recognises(&functions, check, words);
    };
    check(
        |corners, depths, store, visit| {
            zbuffer::fill_nearest(corners.map(|c| Vec3 { z: -c.z, ..c }), depths, store, visit);
        },
        "pairs",
        "wrong sign of depth",
    );
    check(
        |corners, depths, store, visit| {
            zbuffer::fill_nearest(corners.map(|c| Vec3 { z: -c.z, ..c }), depths, store, visit);
        },
        "depths",
        "wrong sign of depth",
    );
    check(
        |corners, depths, _, visit| {
            triangles::fill(corners.map(Vec3::truncate), depths.bounds(), visit);
        },
        "pairs",
        "the last one drawn is seen",
    );
    check(
        |corners, depths, store, visit| {
            let z = Vec3::from_array(corners.map(|corner| corner.z));
            triangles::fill(corners.map(Vec3::truncate), depths.bounds(), |x, y, weights| {
                if store(weights.dot(z)) < depths.get(x, y) {
                    depths.set(x, y, store(weights.dot(z)));
                    visit(x, y, weights);
                }
            });
        },
        "pairs",
        "nothing passes",
    );
    let equal = Zbuffer {
        z_f32: |surfaces, image| {
            let reversed: Vec<_> = surfaces.iter().rev().copied().collect();
            zbuffer::z_f32(&reversed, image)
        },
        ..reference
    };
    JUDGE.recognises(&equal, "equal", "nearer is >");
}
