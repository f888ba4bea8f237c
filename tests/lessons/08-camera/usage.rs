use camera::LESSON;
use verify::{CRATE, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

#[test]
fn what_reaches_behind_the_eye_is_left_out() {
    usage::check_behind_the_eye(&LESSON, &["--eye", "0,0,2"]);
}

#[test]
fn a_turntable_writes_as_many_pictures_as_asked_for() {
    usage::check_turntable(&LESSON);
}

#[cfg(unix)]
#[test]
fn a_turntable_reads_its_texture_once() {
    usage::check_turntable_reads_once(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[
            (&["--eye", "1,2"], "--eye <x,y,z>"),
            (&["--up", "0,inf,0"], "write 3 finite numbers"),
            (
                &["--eye", "1,2,3", "--center", "1,2,3", "--texture", CRATE],
                "--eye and --center are one point: move one of them",
            ),
            (&["--turntable", "0"], "--turntable <N>"),
            (&["--turntable", "1000"], "1..=999"),
            (&["--turntable", "3", "--depth", "a.png"], "cannot be used with"),
            (&["--turntable", "3", "--compare", "lookat,listing"], "cannot be used with"),
        ],
    );
}
