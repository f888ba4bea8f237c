use camera::LESSON;
use verify::usage;

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

#[test]
fn what_holds_for_a_view() {
    usage::check_view(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(&LESSON, &[(&["--distance", "2"], "unexpected argument '--distance'")]);
}
