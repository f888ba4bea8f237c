use triangles::LESSON;
use verify::usage;

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[(&["--depth", "a.png"], "unexpected argument '--depth'"), (&["--light", "0,0,0"], "not all 0")],
    );
}
