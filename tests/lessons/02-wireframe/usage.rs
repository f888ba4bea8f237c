use verify::usage;
use wireframe::LESSON;

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(&LESSON, &[(&["--line", "1,2,3,4"], "unexpected argument '--line'")]);
}
