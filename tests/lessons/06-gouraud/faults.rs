//! Each fault stands in the code here and is recognised by its result alone.

use common::Vec3;
use gouraud_tasks::Gouraud;

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
}

#[test]
fn each_fault_is_recognised() {
    let reference = JUDGE.reference;
    let check = |intensities, check, words| {
        let functions = Gouraud { intensities, gouraud: reference.gouraud };
        JUDGE.recognises(&functions, check, words);
    };
    check(|normals, light| gouraud::intensities(normals, -light), "corners", "behind");
    check(
        |normals, light| gouraud::intensities(normals, light).max(Vec3::ZERO),
        "corners",
        "clamped at the corners",
    );
    check(|[a, b, c], light| gouraud::intensities([b, c, a], light), "corners", "the corners are swapped");
    let behind = Gouraud {
        gouraud: |scene, image, place| {
            gouraud::gouraud(&gouraud::Scene { light: -scene.light, ..*scene }, image, place)
        },
        ..reference
    };
    JUDGE.recognises(&behind, "two sides", "the light comes from behind");
}
