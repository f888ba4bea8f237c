use verify::{LESSONS, assert_drawn};

/// What a lesson draws without a flag, but smaller: the head from lesson 2 on, but for lesson 3's triangles.
#[test]
fn every_lesson_draws_its_default_picture() {
    for lesson in LESSONS {
        assert_drawn(&lesson, "default", &["--size", "200x200"]);
    }
}
