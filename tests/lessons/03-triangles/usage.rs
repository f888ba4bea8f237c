use common::Color;
use triangles::LESSON;
use verify::{draw, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[
            (&["--depth", "a.png"], "unexpected argument '--depth'"),
            (&["--light", "0,0,0"], "not all 0"),
            (&["--triangle", "0,0,9,0,0,inf"], "a corner must be finite"),
        ],
    );
}

#[test]
fn a_triangle_has_the_corners_and_the_colour_that_it_is_given() {
    let picture = draw("triangles", &["--triangle", "10,20,110,30,40,120,00ff00"]);
    let inside = [(12, 21), (107, 31), (40, 117), (53, 56)];
    let outside = [(10, 30), (107, 26), (45, 118), (30, 20), (90, 60), (20, 80)];
    assert!(inside.iter().all(|&(x, y)| picture.get(x, y) == Some(Color::GREEN)));
    assert!(outside.iter().all(|&(x, y)| picture.get(x, y) == Some(Color::BLACK)));
}
