//! Who has handed in much the same: read in all shapes, and told in a page and a table.

use std::fs;
use std::path::Path;
use std::process::Output;

use crate::shapes::{write, zip};
use crate::{COURSE, FULL, LOOK, grader, hand_in, said};

/// Another way to the same pixels: each point by itself, without an error that is carried along.
const HONEST: &str = "use common::{Color, IVec2, Image};
    pub fn line(a: IVec2, b: IVec2, image: &mut Image, color: Color) {
        let (dx, dy) = (b.x as i64 - a.x as i64, b.y as i64 - a.y as i64);
        let n = dx.abs().max(dy.abs());
        if n == 0 {
            return image.set(a.x, a.y, color);
        }
        let forwards = if dx.abs() >= dy.abs() { dx > 0 } else { dy > 0 };
        let at = |k: i64, d: i64| -> i64 {
            let (twice, n2) = (2 * k * d.abs() - n, 2 * n);
            d.signum() * (twice.div_euclid(n2) + i64::from(twice.rem_euclid(n2) != 0))
        };
        let mut k = 0;
        while k <= n {
            let (start, along, across) = match forwards { true => (a, dx, dy), false => (b, -dx, -dy) };
            image.set((start.x as i64 + at(k, along)) as i32, (start.y as i64 + at(k, across)) as i32, color);
            k += 1;
        }
    }";

fn compare(class: &Path, report: &Path, more: &[&str]) -> Output {
    let arguments = [&["pairs", "--lessons", "1"], more].concat();
    grader(&arguments, &[("", class), ("--out", report)]).output().unwrap()
}

#[test]
fn who_has_handed_in_much_the_same_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let [class, report, again] = ["class", "report", "again"].map(|name| folder.path().join(name));
    let mut copy = FULL
        .replace('\n', " ")
        .replace("//! All of mission 1.", "")
        .replace("/// Bresenham's way, in 64 bits.", "");
    for (name, other) in [
        ("steep", "tall"),
        ("flip", "turned"),
        ("wide", "big"),
        ("error", "e"),
        ("length", "n"),
        ("rise", "up"),
        ("i64", "i128"),
    ] {
        copy = copy.replace(name, other);
    }
    hand_in(&class, "ann <b>", FULL);
    zip(&class.join("ben.zip"), &[("lines.rs", &copy)]);
    write(&class.join("cem_103_5001_lines.rs"), FULL);
    hand_in(&class, "dora", HONEST);
    hand_in(&class, "eve", fs::read(Path::new(COURSE).join("lessons/01-lines/mission/src/lib.rs")).unwrap());
    let output = compare(&class, &report, &[]);
    assert!(output.status.success(), "{}", said(&output));
    let read = |file: &str| fs::read_to_string(report.join(file)).unwrap();
    let mut table = csv::Reader::from_path(report.join("pairs.csv")).unwrap();
    let rows: Vec<Vec<String>> =
        table.records().map(|row| row.unwrap().iter().skip(1).map(String::from).collect()).collect();
    let expected = [
        ["ann <b>", "cem_103", "100", "100"],
        ["ann <b>", "the course’s solution", "100", "100"],
        ["ann <b>", "ben", "100", "100"],
        ["ben", "the course’s solution", "100", "100"],
    ];
    for row in expected {
        assert!(rows.iter().any(|other| other[..] == row), "{row:?} is not in {rows:?}");
    }
    assert!(rows.iter().flatten().all(|name| name != "dora" && name != "eve"), "{rows:?}");
    let page = read("pairs.html");
    assert!(page.contains("ann &#60;b&#62; and ben") && page.contains("let tall = "), "{page}");
    assert!(!page.contains("http") && !page.contains("<script"), "it needs nothing else");

    // Once more it is the same, and what cannot be compared is told.
    compare(&class, &again, &[]);
    assert_eq!(fs::read_to_string(again.join("pairs.html")).unwrap(), page);
    hand_in(&class, "fay", FULL.to_string() + "/* ");
    hand_in(&class, "gil", "x ".repeat(30_000));
    hand_in(&class, "hal", "");
    fs::rename(class.join("hal/lessons/01-lines/mission/src/lib.rs"), class.join("hal/a.rs")).unwrap();
    let output = compare(&class, &again, &["--least", "0", "--most", "3"]);
    assert_eq!(output.status.code(), Some(LOOK), "{}", said(&output));
    let page = fs::read_to_string(again.join("pairs.html")).unwrap();
    for (name, why) in [
        ("fay", "found a comment without an end in line 26"),
        ("gil", "found 30000 tokens, not compared"),
        ("hal", "neither its name nor its folder"),
    ] {
        assert!(said(&output).contains(&format!("look here: {name}, 01-lines: ")), "{}", said(&output));
        assert!(said(&output).contains(why) && page.contains(why), "{why}: {}", said(&output));
    }
    assert!(page.contains("of which the first 3 are shown"), "{page}");
    assert_eq!(page.matches("<section aria-labelledby=\"pair-").count(), 3);
}
