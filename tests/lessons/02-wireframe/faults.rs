//! Each fault stands in the code here and is recognised by its result alone.

use common::{IVec2, Image, Vec3};
use wireframe_tasks::Wireframe;

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
}

#[test]
fn each_fault_is_recognised() {
    let check = |to_pixel, check, words| {
        let functions = Wireframe { wireframe: wireframe::wireframe, to_pixel };
        JUDGE.recognises(&functions, check, words);
    };
    let as_printed: fn(Vec3, &Image) -> IVec2 =
        |p, image| ((p.truncate() + 1.0) * image.size() / 2.0).as_ivec2();
    check(as_printed, "border", "off by one at the border");
    check(as_printed, "outside", "cut off towards 0");
    check(|p, image| ((p.truncate() + 1.0) * image.size() / 2.0).round().as_ivec2(), "pixel", "rounded");
    check(|p, image| wireframe::to_pixel(p * Vec3::new(1.0, -1.0, 1.0), image), "pixel", "upside down");
    let mirrored = Wireframe {
        wireframe: |model, image, color| {
            wireframe::wireframe(model, image, color);
            image.flip_horizontally();
        },
        to_pixel: wireframe::to_pixel,
    };
    JUDGE.recognises(&mirrored, "picture", "mirrored");
}
