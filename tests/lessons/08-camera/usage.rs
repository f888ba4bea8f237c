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
fn outside_a_texture_is_its_border_or_the_texture_again() {
    usage::check_wrap(&LESSON, 80, &["--eye", "0,0,2"]);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(&LESSON, &[(&["--distance", "2"], "unexpected argument '--distance'")]);
}
