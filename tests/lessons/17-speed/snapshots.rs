use speed::{LESSON, METHODS};
use verify::{CRATE, SPHERE, assert_drawn, assert_each_drawn};

const SIZE: [&str; 2] = ["--size", "200x200"];

/// Each draws the same; a picture of each, so that one that changes is seen alone.
#[test]
fn every_method_draws_the_head_on_its_floor() {
    assert_each_drawn(&LESSON, METHODS, &SIZE);
}

#[test]
fn every_filter_draws_a_sphere() {
    for row in filtering::METHODS {
        let flags = ["--size", "120x90", "--model", SPHERE, "--texture", CRATE, "--filter", row.name];
        assert_drawn(&LESSON, &format!("filter-{}", row.name), &flags);
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &SIZE);
}
