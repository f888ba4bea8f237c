//! Lesson 16's window: what it shows is what `--out` draws, whatever is typed.
//!
//! Each test starts an X server without a screen and opens the real window on it; `.ci/run` installs what that takes. Keys
//! are typed by `xdotool` through the X server, as by a keyboard, and released within some thousandths of a second.
#![cfg(target_os = "linux")]

mod display;

use std::thread::sleep;

use common::Image;
use scene::VERSIONS;
use scene::keys::Key;
use verify::draw;

use display::{Display, WHILE};

/// What the program draws into a file.
fn drawn(version: &str, size: &str, keys: &str) -> Image {
    draw("scene", &["--version", version, "--time", "1.5", "--size", size, "--keys", keys])
}

/// The same in a window, before its keys are typed.
fn arguments<'a>(version: &'a str, size: &'a str) -> [&'a str; 6] {
    ["--version", version, "--time", "1.5", "--size", size]
}

/// The keys of a keyboard for keys of `--keys`: a capital letter would be one more, Shift.
fn typed(keys: &str) -> Vec<&str> {
    let letter = |key| match key {
        "W" => "w",
        "S" => "s",
        key => key,
    };
    keys.split(' ').map(letter).collect()
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn every_version_shows_what_it_draws_after_any_keys_that_it_has() {
    let display = Display::new();
    let lists = [
        "F1",
        "F1 F1",
        "F2",
        "Left Left W Up",
        "Right Down S S Down Right W",
        "Up Up Up Up Up Up Up Up Up Up Up Up Up Down Down Left Right Right",
        "F1 Left F2 Up",
    ];
    for version in VERSIONS {
        let number = version.number.to_string();
        let shown = display.show(1, &arguments(&number, "331x247"));
        shown.assert_shows(&drawn(&number, "331x247", ""), &format!("version {number}"));
        let has = |list: &&&str| {
            let mut names = list.split(' ');
            names.all(|name| Key::NAMES.iter().any(|&(known, key)| known == name && version.has(key)))
        };
        // One list after the other in the same window.
        let mut keys = String::new();
        for list in lists.iter().filter(has) {
            keys = [&keys, *list].join(" ");
            display.xdotool(&[&["key"], &typed(list)[..]].concat());
            shown.assert_shows(&drawn(&number, "331x247", &keys), &format!("version {number}, {keys}"));
        }
    }
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn keys_that_a_version_does_not_have_do_nothing() {
    let display = Display::new();
    let shown = display.show(1, &arguments("3", "331x247"));
    display.xdotool(&["key", "F1", "F2", "Left", "w", "q", "F3", "Return"]);
    shown.assert_shows(&drawn("3", "331x247", ""), "version 3");
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn the_window_is_as_large_as_said_and_may_become_any_size() {
    let display = Display::new();
    let shown = display.show(1, &["--version", "10", "--time", "1.5"]);
    shown.assert_shows(&drawn("10", "1024x768", ""), "as large as the assignment says");
    for (width, height) in [(317, 211), (1, 1), (700, 9), (3, 400), (640, 480)] {
        let size = format!("{width}x{height}");
        shown.resize(width, height);
        shown.assert_shows(&drawn("10", &size, ""), &size);
    }
    // Pixels of the screen are drawn, not those that programs count.
    let sharp = display.show(2, &arguments("10", "300x200"));
    sharp.assert_shows(&drawn("10", "600x400", ""), "twice as many, each way");
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn a_held_key_moves_the_eye_until_it_is_released_or_the_window_loses_the_keyboard() {
    let display = Display::new();
    let shown = display.show(1, &arguments("9", "331x247"));
    display.xdotool(&["keydown", "Left"]);
    assert!((0..3).all(|_| shown.is_moving()));
    display.xdotool(&["keyup", "Left"]);
    shown.wait_until_still();

    display.xdotool(&["keydown", "Right"]);
    assert!(shown.is_moving());
    display.unfocus();
    shown.wait_until_still();
    display.xdotool(&["keyup", "Right"]);
    shown.focus();
    sleep(WHILE);
    assert!(!shown.is_moving(), "it was released in between");
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn a_held_key_is_released_whatever_is_written_on_it_by_then() {
    /// The number that X has for the key of a keypad with 4 and an arrow on it.
    const KEYPAD_4: &str = "83";
    let display = Display::new();
    let shown = display.show(1, &arguments("9", "331x247"));
    display.xdotool(&["keydown", KEYPAD_4]);
    assert!(shown.is_moving(), "without Num Lock it is an arrow");
    display.xdotool(&["key", "Num_Lock"]);
    display.xdotool(&["keyup", KEYPAD_4]);
    shown.wait_until_still();
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn nothing_is_pulled_once_the_window_has_lost_the_keyboard() {
    let display = Display::new();
    let shown = display.show(1, &arguments("9", "331x247"));
    display.xdotool(&["mousemove", "100", "100", "mousedown", "1"]);
    display.unfocus();
    sleep(WHILE);
    display.xdotool(&["mousemove", "160", "140"]);
    shown.assert_shows(&drawn("9", "331x247", ""), "it may be released elsewhere");
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn the_mouse_pulls_and_scrolls_as_far_as_keys_move() {
    let display = Display::new();
    let shown = display.show(1, &arguments("9", "1024x768"));
    // 32 of 768 pixels are a 24th of half a turn in 2 s, and so a twelfth of a second.
    display.xdotool(&[
        "mousemove",
        "500",
        "300",
        "mousedown",
        "1",
        "mousemove",
        "468",
        "332",
        "mouseup",
        "1",
    ]);
    shown.assert_shows(&drawn("9", "1024x768", "Right Up"), "pulled to the left and down");
    display.xdotool(&["mousemove", "100", "200"]);
    shown.assert_shows(&drawn("9", "1024x768", "Right Up"), "not pulled");
    // This server's wheel is two buttons, 4 and 5, and winit 0.30 makes a line of the press and another of the release.
    display.xdotool(&["click", "4"]);
    shown.assert_shows(&drawn("9", "1024x768", "Right Up W*2"), "two lines nearer");
    display.xdotool(&["click", "--repeat", "3", "5"]);
    shown.assert_shows(&drawn("9", "1024x768", "Right Up W*2 S*6"), "six farther");
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn space_stops_the_scene_and_lets_it_go_on() {
    let display = Display::new();
    let shown = display.show(1, &["--version", "4", "--size", "331x247"]);
    assert!(shown.is_moving());
    display.xdotool(&["key", "space"]);
    shown.wait_until_still();
    display.xdotool(&["key", "space"]);
    sleep(WHILE);
    assert!(shown.is_moving());
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn it_sleeps_where_nothing_moves_and_where_it_cannot_be_seen() {
    let display = Display::new();
    let works = |shown: &display::Shown| {
        sleep(WHILE);
        let before = shown.work();
        sleep(3 * WHILE);
        shown.work() - before
    };
    let still = display.show(1, &arguments("4", "331x247"));
    assert!(works(&still) <= 2, "nothing moves");
    drop(still);
    let turning = display.show(1, &["--version", "4", "--size", "800x600"]);
    assert!(works(&turning) > 6, "it is seen");
    let cover = display.cover();
    assert!(works(&turning) <= 2, "it is not seen");
    display.uncover(cover);
    sleep(WHILE);
    assert!(turning.is_moving(), "it is seen again");
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn escape_and_the_close_button_end_it() {
    let display = Display::new();
    for version in ["0", "11"] {
        let shown = display.show(1, &arguments(version, "331x247"));
        display.xdotool(&["key", "Escape"]);
        assert_eq!(shown.end().code(), Some(0), "version {version}");
    }
    let shown = display.show(1, &arguments("0", "331x247"));
    shown.close();
    assert_eq!(shown.end().code(), Some(0));
}

#[test]
#[ignore = "takes Xvfb and xdotool, which .ci/run installs"]
fn lesson_17_opens_the_same_window() {
    let display = Display::new();
    let still = ["--window", "--scene", "0", "--size", "331x247"];
    let shown = display.show_by("speed", 1, &still);
    shown.assert_shows(&drawn("0", "331x247", ""), "version 0");
    drop(shown);
    // The default one has sixteen samples a pixel until F2 is pressed.
    let shown = display.show_by("speed", 1, &["--window", "--threads", "2"]);
    assert!(shown.is_moving());
    display.xdotool(&["key", "F2"]);
    assert!(shown.is_moving());
    display.xdotool(&["key", "space"]);
    shown.wait_until_still();
    display.xdotool(&["key", "Escape"]);
    assert_eq!(shown.end().code(), Some(0));
}
