use common::Image;
use speed::LESSON;
use tempfile::tempdir;
use verify::{CRATE, SPHERE, draw, names, run, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_texture(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[
            (
                &["--filter", "linear"],
                "--filter linear: there are nearest, bilinear, bilinear-8, trilinear, anisotropic",
            ),
            (&["--wrap", "mirrored"], "--wrap mirrored: there are clamp, repeat, mirror"),
            (&["--threads", "0"], "--threads <N>"),
            (&["--threads", "1000000"], "--threads <N>"),
            (&["--threads=-1"], "--threads <N>"),
            (&["--threads", "two"], "--threads <N>"),
            (&["--repeat", "0"], "--repeat <N>"),
            (&["--repeat", "4294967296"], "--repeat <N>"),
            (&["--repeat", "often"], "--repeat <N>"),
            (&["--cull", "sides"], "--cull <back|front|none>"),
            (&["--fov", "180"], "less than 180"),
            (&["--near", "0"], "must lie before the eye, at more than 0"),
            (&["--far", "0.1"], "it must lie behind the near one"),
            (&["--eye", "1,2,3", "--center", "1,2,3"], "--eye and --center are one point: move one of them"),
            (&["--turntable", "3"], "--turntable"),
            (&["--scene", "--filter", "nearest"], "'--scene [<N>]' cannot be used with '--filter <NAME>'"),
            (&["--scene", "3", "--model"], "'--scene [<N>]' cannot be used with '--model [<FILE>]'"),
            (&["--scene", "12"], "--scene [<N>]"),
        ],
    );
}

/// A line with three times, which are in order; and the picture is the same as without.
#[test]
fn a_picture_drawn_again_and_again_is_timed() {
    let folder = tempdir().unwrap();
    let scene = ["--model", SPHERE, "--texture", CRATE, "--size", "60x50"];
    let [plain, timed] = [("1", &[][..]), ("2", &["--repeat", "5"])].map(|(name, repeat)| {
        let file = format!("{name}.png");
        let output = run(LESSON.name, folder.path(), &[&scene, repeat, &["--out", &file]].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        (said, Image::read(&folder.path().join(file)).unwrap())
    });
    assert!(plain.1 == timed.1);
    assert!(!plain.0.contains("median"), "{}", plain.0);
    let lines: Vec<&str> = timed.0.lines().filter(|line| line.starts_with("median")).collect();
    let &[line] = &lines[..] else { panic!("{}", timed.0) };
    let rest = line.strip_prefix("median ").and_then(|rest| rest.strip_suffix(')'));
    let parts = rest.and_then(|rest| rest.split_once(" ms (p25 "));
    let parts = parts.and_then(|(median, rest)| Some((median, rest.split_once(", p75 ")?)));
    let Some((median, (low, high))) = parts else { panic!("{line}") };
    let times = [low, median, high].map(|time| {
        assert!(time.split_once('.').is_some_and(|(_, decimals)| decimals.len() == 2), "{line}");
        time.parse::<f64>().unwrap_or_else(|_| panic!("{line}"))
    });
    assert!(times.is_sorted() && times[0] >= 0.0, "{line}");
}

/// No pixel differs between any method and lesson 13's, and the program says so.
#[test]
fn methods_are_compared_without_a_difference() {
    let folder = tempdir().unwrap();
    for method in speed::METHODS {
        let pair = format!("simple,{}", method.name);
        let arguments = ["--compare", &pair, "--size", "90x70", "--threads", "3", "--out", "a.png"];
        let output = run(LESSON.name, folder.path(), &arguments);
        let said = String::from_utf8_lossy(&output.stdout);
        let told = "0 pixels missing (orange), 0 extra (blue), 0 of another colour";
        assert!(output.status.success() && said.contains(told), "{}: {said}", method.name);
    }
    assert_eq!(names(folder.path()), ["a.png"]);
}

/// However many threads, it is lesson 13's picture.
#[test]
fn any_number_of_threads_draws_lesson_13s_picture() {
    for filter in filtering::METHODS {
        let scene = ["--size", "70x60", "--wrap", "mirror", "--cull", "none"];
        let expected = draw("filtering", &[&scene[..], &["--method", filter.name]].concat());
        for threads in ["1", "2", "7", "64"] {
            let flags = ["--filter", filter.name, "--threads", threads];
            assert!(expected == draw("speed", &[&scene[..], &flags].concat()), "{}, {threads}", filter.name);
        }
    }
}

/// Errors of input are one line, and nothing is written.
#[test]
fn bad_input() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("a.obj"), "f 1 2 3\n").unwrap();
    let output = run(LESSON.name, folder.path(), &["--model", "a.obj", "--out", "a.png"]);
    usage::assert_fails(&output, 1, &["a.obj"]);
    let output = run(LESSON.name, folder.path(), &["--repeat", "3", "--out", "none/a.png"]);
    usage::assert_fails(&output, 1, &["none"]);
    assert_eq!(names(folder.path()), ["a.obj"]);
}
