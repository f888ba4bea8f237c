use verify::{LESSONS, assert_picture, assert_similar, draw};

/// What a lesson draws without a flag, but smaller: the head from lesson 2 on, but for lesson 3's triangles.
#[test]
fn every_lesson_draws_its_default_picture() {
    for (n, lesson) in LESSONS.into_iter().enumerate() {
        let name = format!("0{}-{lesson}-default", n + 1);
        let picture = draw(lesson, &["--size", "200x200"]);
        if n < 6 {
            assert_picture(&name, &picture, 0);
        } else {
            assert_similar(&name, &picture);
        }
    }
}
