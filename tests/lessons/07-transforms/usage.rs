use transforms::LESSON;
use verify::usage;

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

#[test]
fn what_reaches_behind_the_eye_is_left_out() {
    usage::check_behind_the_eye(&LESSON, &[]);
}

#[test]
fn outside_a_texture_is_its_border_or_the_texture_again() {
    usage::check_wrap(&LESSON, 80, &[]);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[
            (&["--distance", "0"], "write a number above 0, or inf"),
            (&["--distance", "-2"], "write a number above 0, or inf"),
            (&["--distance", "nan"], "write a number above 0, or inf"),
            (&["--turntable", "3"], "unexpected argument '--turntable'"),
        ],
    );
}
