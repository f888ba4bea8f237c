use gouraud::LESSON;
use verify::usage;

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(&LESSON, &[(&["--eye", "1,1,1"], "unexpected argument '--eye'")]);
}
