//! Weights, late days and pseudonyms, by the command line, of a class that is graded once.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use tempfile::TempDir;

use crate::{FULL, grade, grader, hand_in, ran, said};

const RULES: &str = "[late]\nfree_days = 1\npenalty = 20\nlast_day = 5\n\n[lessons.01-lines]\nweight = 3\n\
                     due = 2026-10-05T23:59:00+02:00\n";

const SUBMITTED: &str = "submission,lesson,submitted\nann,01-lines,2026-10-05T21:00:00Z\n\
                         ben,01-lines,2026-10-08T10:00:00+02:00\ncem,01-lines,2026-11-01T10:00:00+02:00\n";

/// Writes the files, and the reports of a graded class anew.
fn merge(folder: &Path, files: [&str; 2], more: &[&str]) -> (Output, PathBuf) {
    let out = folder.join("out");
    let _ = fs::remove_dir_all(&out);
    let paths = ["rules.toml", "submitted.csv"].map(|name| folder.join(name));
    paths.iter().zip(files).for_each(|(path, text)| fs::write(path, text).unwrap());
    let graded = folder.join("graded");
    let mut parts = vec![("", &*graded), ("--out", &out), ("--rules", &paths[0])];
    if !files[1].is_empty() {
        parts.push(("--submitted", &paths[1]));
    }
    (grader(&[&["merge"], more].concat(), &parts).output().unwrap(), out)
}

/// A class whose members are right, but one who handed in nothing; nothing where no walls can be built.
fn graded() -> Option<TempDir> {
    let folder = tempfile::tempdir().unwrap();
    let class = folder.path().join("class");
    ["ann", "ben", "cem"].iter().for_each(|name| hand_in(&class, name, FULL));
    fs::create_dir(class.join("di")).unwrap();
    let report = folder.path().join("graded");
    ran(&grade(&class, &report, &[]), &report).then_some(folder)
}

#[test]
fn what_counts_is_in_all_reports() {
    let Some(folder) = graded() else { return };
    let (output, out) = merge(folder.path(), [RULES, SUBMITTED], &["--anonymous"]);
    assert!(output.status.success(), "{}", said(&output));
    let read = |name: &str| fs::read_to_string(out.join(name)).unwrap();

    // Three days late, of which one is free and two cost a fifth each: 3 · 10 · 60 %.
    let mut grades = csv::Reader::from_path(out.join("grades.csv")).unwrap();
    let rows: Vec<csv::StringRecord> = grades.records().map(Result::unwrap).collect();
    let last = |row: &csv::StringRecord| row.iter().skip(row.len() - 5).map(String::from).collect::<Vec<_>>();
    let counted: Vec<Vec<String>> = rows.iter().map(last).collect();
    let expected = [
        ["0", "0", "30", "30", "30"],
        ["3", "1", "18", "18", "30"],
        ["27", "0", "0", "0", "30"],
        ["0", "0", "0", "0", "30"],
    ];
    assert_eq!(counted, expected);
    let page = read("index.html");
    assert!(page.contains(">Counts<") && page.contains("18 / 30</td>"), "{page}");
    for (name, words) in [
        ("ann", "It counts 30 of 30."),
        ("ben", "It counts 18 of 30, 3 days late, of which 1 free."),
        ("cem", "It counts 0 of 30, 27 days late, which is too late."),
    ] {
        assert!(read(&format!("students/{name}.html")).contains(words), "{name}");
    }
    assert!(read("students/ben.html").contains("<p>With weights and days late: 18 of 30.</p>"));
    let anonymous = read("anonymous/grades.csv");
    assert!(anonymous.contains(",3,1,18,18,30") && !anonymous.contains("ben"), "{anonymous}");
    assert!(read("anonymous-key-keep-it-to-yourself.csv").contains(",ben\n"));
}

/// Merges a graded class, its names changed, with rules and what a system says of times. It comes as two equal parts, of which
/// the second knows who was marked as late.
fn told(
    folder: &Path,
    names: [&str; 3],
    late: &str,
    file: &str,
    text: &str,
    more: &[&str],
) -> (Output, PathBuf) {
    let [graded, parts, out] = ["graded", "parts", "out"].map(|name| folder.join(name));
    let class = fs::read_to_string(graded.join("class.json")).unwrap();
    let rename = |class: String, (from, to)| class.replace(&format!("\"{from}\":"), &format!("\"{to}\":"));
    let class = ["ann", "ben", "cem"].into_iter().zip(names).fold(class, rename);
    let parts = [("1", ""), ("2", late)].map(|(part, late)| {
        let part = parts.join(part);
        fs::create_dir_all(&part).unwrap();
        fs::write(part.join("class.json"), format!("{{\"late\":[{late}],{}", &class[1..])).unwrap();
        fs::copy(graded.join("times.csv"), part.join("times.csv")).unwrap();
        part
    });
    let [rules, submitted] = ["rules.toml", file].map(|name| folder.join(name));
    fs::write(&rules, RULES).unwrap();
    fs::write(&submitted, text).unwrap();
    let _ = fs::remove_dir_all(&out);
    let [one, two] = &parts;
    let paths = [("", &**one), ("", two), ("--out", &out), ("--rules", &rules), ("--submitted", &submitted)];
    (grader(&[&["merge"], more].concat(), &paths).output().unwrap(), out)
}

#[test]
fn moodle_and_gradescope_say_when() {
    let Some(folder) = graded() else { return };
    let last = |out: &Path, name: &str| {
        let mut grades = csv::Reader::from_path(out.join("grades.csv")).unwrap();
        let rows: Vec<csv::StringRecord> = grades.records().map(Result::unwrap).collect();
        let row = rows.iter().find(|row| &row[0] == name).unwrap();
        row.iter().skip(row.len() - 5).map(String::from).collect::<Vec<_>>()
    };

    let moodle = "\u{feff}Identifier,\"Full name\",Grade,\"Last modified (submission)\"\r\n\
                  \"Participant 101\",Ann,,\"Monday, 5 October 2026, 11:59 PM\"\r\n\
                  \"Participant 102\",Ben,,\"Thursday, 8 October 2026, 10:00 AM\"\r\n\
                  \"Participant 103\",Cem,,\"Thursday, 8 October 2026, 10:00 AM\"\r\n";
    let names = ["Ann_101", "Ben Okoro_102", "cohen_103"];
    let (output, out) = told(folder.path(), names, "", "moodle.csv", moodle, &["--zone", "Europe/Berlin"]);
    assert!(output.status.success(), "{}", said(&output));
    assert_eq!(last(&out, names[0]), ["0", "0", "30", "30", "30"]);
    assert_eq!(last(&out, names[1]), ["3", "1", "18", "18", "30"]);
    // Who has no number cannot be found.
    let names = ["Ann_101", "Ben Okoro_102", "cem"];
    let (output, _) = told(folder.path(), names, "", "moodle.csv", moodle, &["--zone", "Europe/Berlin"]);
    let expected = "--submitted does not say when cem handed in 01-lines";
    assert!(output.status.code() == Some(1) && said(&output).contains(expected), "{}", said(&output));

    let gradescope = "ann:\n  :created_at: 2026-10-05 21:00:00.000000000 Z\n\
                      submission_7001:\n  :created_at: 2026-10-08 08:00:00.000000000 Z\n\
                      cem:\n  :created_at: 2026-11-01 09:00:00.000000000 Z\n";
    let late = "\"ann\", \"submission_7001\"";
    let names = ["ann", "submission_7001", "cem"];
    let (output, out) =
        told(folder.path(), names, late, "submission_metadata.yml", gradescope, &["--anonymous"]);
    assert!(output.status.success(), "{}", said(&output));
    assert_eq!(last(&out, "ann"), ["0", "0", "30", "30", "30"]);
    assert_eq!(last(&out, "submission_7001"), ["3", "1", "18", "18", "30"]);
    // Canvas says otherwise of one of them.
    let page = fs::read_to_string(out.join("index.html")).unwrap();
    assert!(page.contains("1 marked as late") && page.contains("<li><strong>ann</strong></li>"), "{page}");
    assert!(!page.contains("<li><strong>submission_7001</strong></li>"), "{page}");
    assert!(!fs::read_to_string(out.join("anonymous/index.html")).unwrap().contains("<strong>ann"));

    for (file, text, more, words) in [
        (
            "moodle.csv",
            moodle,
            &[][..],
            "moodle.csv:1: Moodle’s worksheet does not say its time zone: add --zone",
        ),
        ("t.yml", "- 1\n", &[], "t.yml:1: it is not Gradescope’s submission_metadata.yml"),
    ] {
        let (output, out) = told(folder.path(), names, "", file, text, more);
        let said = said(&output);
        assert!(output.status.code() == Some(1) && said.contains(words), "{said}");
        assert!(said.trim().lines().count() == 1 && !out.exists(), "{said}");
    }
    let (output, _) = told(folder.path(), names, "", "moodle.csv", moodle, &["--zone", "CEST2"]);
    assert!(
        output.status.code() == Some(2) && said(&output).contains("no time zone is called so"),
        "{}",
        said(&output)
    );
}

#[test]
fn bad_rules_are_one_line_and_nothing_is_written() {
    let Some(folder) = graded() else { return };
    let twice = format!("{SUBMITTED}ben,01-lines,2026-10-08T10:00:00+02:00\n");
    let misspelt = SUBMITTED.replace("ben", "bon");
    for (rules, submitted, words) in [
        ("[late]\npenalty = 10\nfree = 1\n", SUBMITTED, "rules.toml:3: unknown field `free`"),
        ("[lessons.99-none]\nweight = 1\n", SUBMITTED, "rules.toml:1: `99-none` is no lesson"),
        (RULES, "", "rules.toml: 01-lines has a deadline: give --submitted FILE"),
        (RULES, "submission,submitted\nann,Monday\n", "submitted.csv:2: `Monday`: a time is to be written"),
        (RULES, &twice, "submitted.csv:5: there are two times for ben"),
        (RULES, &misspelt, "--submitted does not say when ben handed in 01-lines"),
    ] {
        let (output, out) = merge(folder.path(), [rules, submitted], &[]);
        let said = said(&output);
        assert!(output.status.code() == Some(1) && said.contains(words), "{said}");
        assert!(said.trim().lines().count() == 1 && !out.exists(), "{said}");
    }
}
