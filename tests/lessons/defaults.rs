use verify::{LESSONS, assert_picture, assert_similar, draw};

/// What a lesson draws without a flag, but smaller: the head from lesson 2 on, but for lesson 3's triangles.
#[test]
fn every_lesson_draws_its_default_picture() {
    for lesson in LESSONS {
        let picture = draw(lesson.name, &["--size", "200x200"]);
        if lesson.number < 7 {
            assert_picture(&lesson, "default", &picture, 0);
        } else {
            assert_similar(&lesson, "default", &picture);
        }
    }
}
