use scene::keys::Key;
use scene::{LESSON, METHODS, VERSIONS};
use verify::{draw, names, run, usage};

/// Small.
const SIZE: [&str; 2] = ["--size", "60x40"];

/// A version's picture after these further arguments.
fn shown(version: &str, arguments: &[&str]) -> common::Image {
    draw(LESSON.name, &[&SIZE[..], &["--version", version], arguments].concat())
}

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
}

#[test]
fn help_has_every_key() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let output = run(LESSON.name, folder.path(), &["--help"]);
    let help = String::from_utf8_lossy(&output.stdout);
    let (_, keys) = help.split_once("\nKeys:\n").expect("a part about keys");
    let told: Vec<_> = keys.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let names = Key::NAMES.iter().map(|(name, _)| *name);
    assert!(names.chain(["Space"]).all(|name| told.contains(&name)), "{help}");
}

/// Each in one line, with exit code 2, and no window and no file.
#[test]
fn wrong_command_lines() {
    let rows: &[(&[&str], &str)] = &[
        (&["--version", "12"], "12 is not in 0..=11"),
        (&["--version", "-1"], "-1"),
        (&["--version", "four"], "--version <N>"),
        (&["--version"], "--version <N>"),
        (&["--time", "-1"], "-1"),
        (&["--time=-1"], "write a number of seconds from 0 to 1000000"),
        (&["--time", "nan"], "write a number of seconds"),
        (&["--time", "inf"], "write a number of seconds"),
        (&["--time", "1e7"], "write a number of seconds"),
        (&["--time", "noon"], "write a number of seconds"),
        (&["--keys", "F3"], "there is no key `F3`, only Escape, F1, F2, Left, Right, Up, Down, W, S"),
        (&["--keys", "Left*0"], "`Left*0`: write a number of presses behind the *, up to 10000 in all"),
        (&["--keys", "Left*9999 Up*2"], "up to 10000 in all"),
        (&["--keys", "Left*ten"], "`Left*ten`"),
        (&["--keys"], "--keys <KEYS>"),
        (&["--version", "3", "--keys", "F1"], "--keys F1: version 3 has no such key, version 7 has"),
        (&["--version", "9", "--keys", "F2"], "--keys F2: version 9 has no such key, version 10 has"),
        (
            &["--version", "8", "--keys", "Escape Left"],
            "--keys Left: version 8 has no such key, version 9 has",
        ),
        (&["--version", "0", "--keys", "W*3"], "--keys W: version 0 has no such key, version 9 has"),
        (&["--version", "5", "--turntable", "3"], "--turntable: version 5 has no camera that could turn"),
        (&["--turntable", "0"], "--turntable <N>"),
        (&["--turntable", "1000"], "1..=999"),
        (&["--turntable", "3", "--compare", "8x16,by-size"], "cannot be used with"),
        (
            &["--version", "10", "--size", "5000x5000"],
            "16 samples a pixel are too many for it; up to 4096x4096 will do",
        ),
        (&["--method", "9x9"], "possible values"),
        (&["--depth", "a.png"], "--depth"),
        (&["--eye", "1,2,3"], "--eye"),
        (&["--model", "a.obj"], "--model"),
    ];
    // A file is always named: what is accepted by mistake must not open a window.
    let named: Vec<(Vec<&str>, &str)> = rows
        .iter()
        .map(|&(arguments, said)| {
            // What lacks its value must stay last.
            ([&["--out", "a.png"], arguments].concat(), said)
        })
        .collect();
    let rows: Vec<(&[&str], &str)> = named.iter().map(|(arguments, said)| (&arguments[..], *said)).collect();
    usage::refuses(&LESSON, &rows);
}

/// A folder that is not there, and a file that is one: exit code 1, one line, nothing half-written.
#[test]
fn pictures_that_cannot_be_written() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    std::fs::create_dir(folder.path().join("b.png")).expect("a folder can be made");
    for out in ["no/a.png", "b.png", "a.jpg"] {
        let output = run(LESSON.name, folder.path(), &["--version", "1", "--size", "8x8", "--out", out]);
        usage::assert_fails(&output, 1, &[out]);
    }
    assert_eq!(names(folder.path()), ["b.png"]);
}

/// The window's size unless told otherwise.
#[test]
fn a_picture_is_as_large_as_the_assignments_window() {
    let picture = draw(LESSON.name, &["--version", "1"]);
    assert_eq!([picture.width(), picture.height()], [1024, 768]);
}

/// Keys are switches or moves: twice is back again, there and back is none, and each name may be written small.
#[test]
fn keys_and_their_opposites() {
    let still = shown("11", &[]);
    for none in ["F1 F1", "F2*2", "Left*3 Right*3", "Up*2 Down*2", "W*4 S*4", "Escape", "Escape F1 W*9", " "]
    {
        assert!(shown("11", &["--keys", none]) == still, "{none}");
    }
    // Down comes after Up: at first this eye is as low as it goes.
    for some in ["F1", "F2", "Left", "Right", "Up", "Up*2 Down", "W", "S", "f1", "left", "F1*3"] {
        assert!(shown("11", &["--keys", some]) != still, "{some}");
    }
    assert!(shown("11", &["--keys", "w*2 Left"]) == shown("11", &["--keys", "Left W W"]));
    // All 48 presses around: a full turn takes four seconds.
    assert!(shown("9", &["--keys", "Right*48"]) == shown("9", &[]));
}

/// Escape is there from the first version on.
#[test]
fn every_version_ends_by_escape() {
    for version in VERSIONS {
        let number = version.number.to_string();
        assert!(shown(&number, &["--keys", "Escape"]) == shown(&number, &[]));
    }
}

/// What turns is elsewhere at another time, and what does not is not; a scene at a time is the same each time.
#[test]
fn times_are_told_apart() {
    for version in VERSIONS {
        let number = version.number.to_string();
        let [first, again, later] = ["0.5", "0.5", "2"].map(|time| shown(&number, &["--time", time]));
        assert!(first == again, "version {number}");
        assert_eq!(first != later, version.animate.is_some(), "version {number}");
    }
    assert!(VERSIONS[4].animate.is_some(), "from version 4 on cube and sphere turn");
    assert!(shown("4", &[]) == shown("4", &["--time", "0"]));
}

/// Each row of the table is another sphere.
#[test]
fn methods_draw_other_spheres() {
    let sphere = |name| draw(LESSON.name, &["--version", "0", "--size", "400x300", "--method", name]);
    assert!(sphere("by-size") == draw(LESSON.name, &["--version", "0", "--size", "400x300"]));
    let coarsest = sphere(METHODS[0].name);
    assert!(METHODS[1..].iter().all(|row| sphere(row.name) != coarsest));
}

/// A turn begins where the camera is at first, and comes back.
#[test]
fn a_turn_in_pictures() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let arguments = ["--version", "9", "--turntable", "4", "--out", "a.png", "--time", "1"];
    let output = run(LESSON.name, folder.path(), &[&SIZE[..], &arguments].concat());
    assert_eq!(String::from_utf8_lossy(&output.stdout), "4 pictures\n");
    assert_eq!(names(folder.path()), ["a-000.png", "a-001.png", "a-002.png", "a-003.png"]);
    let picture = |n: usize| {
        common::Image::read(&folder.path().join(format!("a-{n:03}.png")))
            .expect("the program wrote a picture")
    };
    for n in 0..4 {
        let presses = format!("Right*{}", 12 * n);
        let keys: &[&str] = if n == 0 { &[] } else { &["--keys", &presses] };
        assert!(picture(n) == shown("9", &[&["--time", "1"], keys].concat()), "{n}");
    }
}
