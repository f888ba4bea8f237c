//! Each fault stands in the code here and is recognised by its result alone.

use common::Vec2;
use textures_tasks::Textures;

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
}

#[test]
fn each_fault_is_recognised() {
    let reference = JUDGE.reference;
    let check = |texel, check, words| {
        JUDGE.recognises(&Textures { texel, ..reference }, check, words);
    };
    check(textures::round, "within", "half a texel off");
    check(textures::truncate, "border", "black from u = 1 on");
    check(textures::repeat, "border", "repeated");
    check(|texture, uv| textures::texel(texture, Vec2::new(uv.x, 1.0 - uv.y)), "texels", "upside down");
    check(|texture, uv| textures::texel(texture, Vec2::new(uv.y, uv.x)), "texels", "x and y are swapped");
}
