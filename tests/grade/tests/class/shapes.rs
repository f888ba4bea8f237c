//! The shapes in which classes come. All hand in the same text, so that it is built once.

use std::fs::{self, File};
use std::io::Write;
use std::path::Path;
use std::process::Command;

use serde_json::Value;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use crate::{COURSE, FULL, LOOK, grade, grader, ran, said};

pub(crate) fn write(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// A zip file of these names and texts.
pub(crate) fn zip(path: &Path, files: &[(&str, &str)]) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let mut zip = ZipWriter::new(File::create(path).unwrap());
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    for (name, text) in files {
        zip.start_file(*name, options).unwrap();
        zip.write_all(text.as_bytes()).unwrap();
    }
    zip.finish().unwrap();
}

fn outcomes(report: &Path) -> Value {
    let class: Value = serde_json::from_slice(&fs::read(report.join("class.json")).unwrap()).unwrap();
    class["submissions"].clone()
}

#[test]
fn each_shape_is_graded() {
    let folder = tempfile::tempdir().unwrap();
    let [class, report] = ["class", "report"].map(|name| folder.path().join(name));
    let mut names = Vec::new();
    let mut submission = |name: &'static str, files: &[&str]| {
        files.iter().for_each(|file| write(&class.join(file), FULL));
        names.push(name);
    };
    submission("bare", &["bare/lib.rs"]);
    submission("bare src", &["bare src/src/lib.rs"]);
    submission("mission", &["mission/mission/src/lib.rs"]);
    submission("named", &["named/lines.rs"]);
    submission("numbered", &["numbered/01_lines.rs"]);
    submission("another case", &["another case/Abgabe/LINES.RS"]);
    submission("folder", &["folder/01-Lines/src/lib.rs"]);
    submission("two deep", &["two deep/a/b/lines.rs"]);
    submission("second copy", &["second copy/lib (1).rs"]);
    submission("same twice", &["same twice/lib.rs", "same twice/old/lib.rs"]);
    // Learning systems and forges.
    submission("Ann Smith_101", &["Ann Smith_101_assignsubmission_file_/lib.rs"]);
    submission("Ben Okoro_102", &["Ben Okoro_102_assignsubmission_file_lines.rs"]);
    submission("cohencem_103", &["cohencem_103_5001_lines.rs", "cohencem_103_5002_lines-1.rs"]);
    submission("dias_104", &["dias_LATE_104_5003_lib.rs"]);
    submission("submission_7001", &["submission_7001/lib.rs"]);
    write(&class.join("submission_metadata.yml"), "of Gradescope’s export");
    submission("lines-eva", &["lines-eva/lessons/01-lines/mission/src/lib.rs"]);
    // What systems leave behind.
    submission("litter", &["litter/lib.rs"]);
    for file in ["__MACOSX/._lib.rs", ".git/lib.rs", ".idea/lines.rs", "target/lines.rs", "Thumbs.db"] {
        write(&class.join("litter").join(file), "not this one");
    }
    write(&class.join("list.csv"), "not a submission");
    // In a copy of the course there is much else, and what was handed out counts where there is nothing else.
    let starter = fs::read_to_string(Path::new(COURSE).join("lessons/01-lines/mission/src/lib.rs")).unwrap();
    submission("copy", &["copy/lines.rs"]);
    write(&class.join("copy/lessons/01-lines/mission/src/lib.rs"), &starter.replace('\n', "\r\n"));
    for other in ["lessons/01-lines/src/lib.rs", "common/src/lib.rs", "tests/lessons/01-lines/solution.rs"] {
        write(&class.join("copy").join(other), "not this one");
    }
    // Archives.
    zip(&class.join("zip.zip"), &[("lib.rs", FULL)]);
    zip(
        &class.join("zip of a folder.ZIP"),
        &[("top/01-lines/", ""), ("top/01-lines/mission/src/lib.rs", FULL)],
    );
    zip(&class.join("zip of macOS.zip"), &[("lines.rs", FULL), ("__MACOSX/._lines.rs", "\0\0")]);
    zip(&class.join("zip of Windows.zip"), &[("mission\\src\\lib.rs", FULL)]);
    zip(&class.join("Fox_105_assignsubmission_file_/all.zip"), &[("lib.rs", FULL)]);
    zip(&class.join("gray_106_5004_all.zip"), &[("src/lib.rs", FULL), ("src/main.rs", "fn main() {}")]);
    names.extend(["zip", "zip of a folder", "zip of macOS", "zip of Windows", "Fox_105", "gray_106"]);

    let roster = folder.path().join("roster.csv");
    write(&roster, "Student,ID,Section\n\"Cohen, Cem\",103,A\n\"Dias, Di\",104,A\nNobody,9,A\n");
    let output = grade(&class, &report, &["--roster", roster.to_str().unwrap()]);
    if !ran(&output, &report) {
        return;
    }
    println!("{}", said(&output));
    let import = fs::read_to_string(report.join("import.csv")).unwrap();
    let expected =
        "Student,ID,Section,01-lines\n\"Cohen, Cem\",103,A,10\n\"Dias, Di\",104,A,10\nNobody,9,A,\n";
    assert_eq!(import, expected);
    let outcomes = outcomes(&report);
    for name in &names {
        let outcome = outcomes[name][0]["outcome"].to_string();
        assert!(outcome.starts_with("{\"Ran\""), "{name}: {outcome}");
    }
    assert_eq!(outcomes.as_object().unwrap().len(), names.len());
    let grades = fs::read_to_string(report.join("grades.csv")).unwrap();
    assert_eq!(grades.matches(",10,right,").count(), names.len(), "{grades}");
    assert!(said(&output).contains("1 different texts: 1 graded now"), "{}", said(&output));
    // It is late, but not known how late, and all that is known is told.
    let late = "look here: Canvas marks as late, without a time, from whom no day was taken; \
                --submitted says when that was\n  dias_104\n";
    assert!(said(&output).starts_with(late), "{}", said(&output));
    let page = fs::read_to_string(report.join("index.html")).unwrap();
    assert!(
        page.contains("Look here: 1 marked as late</h2>")
            && page.contains("<li><strong>dias_104</strong></li>")
    );
    assert_eq!(output.status.code(), Some(0));
}

/// What each of these is to be told as.
const LOOKS: [(&str, &str); 17] = [
    ("bomb", "bomb.zip/lib.rs, not graded because it is larger than 1024 KiB; have it handed in again"),
    ("broken", "broken.zip, not graded because it cannot be read as a zip file"),
    ("closed", "a, not graded because it cannot be read (Permission denied"),
    ("closed file", "lib.rs, not graded because it cannot be read: Permission denied"),
    (
        "copies",
        "lib.rs, lines.rs, not graded because each of them may be the mission’s file, and they differ",
    ),
    ("elsewhere", "exercise.rs, not graded because neither its name nor its folder says"),
    ("encrypted", "encrypted.zip/lib.rs is encrypted"),
    ("inner", "in.zip is a zip file in a zip file"),
    (
        "main only",
        "01-lines/main.rs, not graded because none of these is the mission’s file; name the mission’s file 01-lines.rs",
    ),
    ("many", "it has more than 50000 files"),
    ("outside", "../lib.rs leads out of it"),
    ("own", "it is the lesson’s own file, as it was handed out"),
    ("packed", "lines.7z, not graded because of archives only zip files are read; unpack it by hand"),
    ("renamed", "lib.rs.txt, not graded because none of it is a Rust file"),
    ("single.rs", "single.rs, not graded because neither its name nor its folder says"),
    ("twice_1", "lib.rs, lines.rs, not graded because each of them may be"),
    ("two zips", "a.zip/lib.rs, b.zip/lib.rs, not graded because each of them may be"),
];

#[test]
fn what_is_not_clear_is_looked_at() {
    let folder = tempfile::tempdir().unwrap();
    let [class, report] = ["class", "report"].map(|name| folder.path().join(name));
    let other = format!("{FULL}// another");
    zip(&class.join("bomb.zip"), &[("lib.rs", &" ".repeat(64 << 20))]);
    write(&class.join("broken.zip"), "PK, but no more");
    write(&class.join("closed/a/lib.rs"), FULL);
    write(&class.join("closed file/lib.rs"), FULL);
    write(&class.join("copies/lib.rs"), FULL);
    write(&class.join("copies/lines.rs"), &other);
    write(&class.join("elsewhere/exercise.rs"), FULL);
    zip(&class.join("encrypted.zip"), &[("lib.rs", FULL)]);
    set_encrypted(&class.join("encrypted.zip"));
    zip(&class.join("inner.zip"), &[("in.zip", "PK")]);
    write(&class.join("main only/01-lines/main.rs"), FULL);
    let names: Vec<String> = (0..50_001).map(|n| n.to_string()).collect();
    zip(&class.join("many.zip"), &names.iter().map(|name| (name.as_str(), "")).collect::<Vec<_>>());
    zip(&class.join("outside.zip"), &[("a/../../lib.rs", FULL)]);
    let own = fs::read_to_string(Path::new(COURSE).join("lessons/01-lines/src/lib.rs")).unwrap();
    write(&class.join("own/src/lib.rs"), &own);
    write(&class.join("packed/lines.7z"), "7z");
    write(&class.join("renamed/lib.rs.txt"), FULL);
    write(&class.join("single.rs"), FULL);
    write(&class.join("twice_1_2_lib.rs"), FULL);
    write(&class.join("twice_1_3_lines.rs"), &other);
    zip(&class.join("two zips/a.zip"), &[("lib.rs", FULL)]);
    zip(&class.join("two zips/b.zip"), &[("lib.rs", &other)]);
    // Nothing is there, and nothing is to be looked at.
    fs::create_dir(class.join("nothing")).unwrap();
    for closed in ["closed/a", "closed file/lib.rs"] {
        let none = std::os::unix::fs::PermissionsExt::from_mode(0o000);
        fs::set_permissions(class.join(closed), none).unwrap();
    }
    // Nothing is closed to root but by leaving out that right.
    let grader = grader(&["class", "--lessons", "1", "--seed", "2"], &[("", &class), ("--out", &report)]);
    let mut ordinary = Command::new("setpriv");
    let rights = "-dac_override,-dac_read_search";
    ordinary.args([format!("--inh-caps={rights}"), format!("--bounding-set={rights}")]);
    let output = ordinary.arg(grader.get_program()).args(grader.get_args()).output().unwrap();
    if !ran(&output, &report) {
        return;
    }
    println!("{}", said(&output));
    assert_eq!(output.status.code(), Some(LOOK));
    let said = said(&output);
    let outcomes = outcomes(&report);
    for (name, words) in LOOKS {
        let look = said.lines().find(|line| line.starts_with(&format!("  {name}, 01-lines: found ")));
        let look = look.unwrap_or_else(|| panic!("{name}: {}", outcomes[name]));
        assert!(look.contains(words), "{words}\n{look}");
    }
    assert_eq!(outcomes["nothing"][0]["outcome"], "Missing");
    assert_eq!(outcomes.as_object().unwrap().len(), LOOKS.len() + 1);
    let grades = fs::read_to_string(report.join("grades.csv")).unwrap();
    assert_eq!(grades.matches(",,not graded,").count(), LOOKS.len(), "{grades}");
}

/// Sets the bit of the archive's first file that says it is encrypted, in both of its headers (APPNOTE 4.3.7, 4.3.12).
fn set_encrypted(path: &Path) {
    let mut bytes = fs::read(path).unwrap();
    for (header, flags) in [(b"PK\x03\x04", 6), (b"PK\x01\x02", 8)] {
        let at = bytes.windows(4).position(|window| window == header).unwrap();
        bytes[at + flags] |= 1;
    }
    fs::write(path, bytes).unwrap();
}

#[test]
fn of_several_lessons_each_file_says_of_which_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let [class, report] = ["class", "report"].map(|name| folder.path().join(name));
    write(&class.join("both/01-lines.rs"), FULL);
    write(&class.join("both/wireframe/src/lib.rs"), "not Rust");
    write(&class.join("first/lines.rs"), FULL);
    write(&class.join("unnamed/src/lib.rs"), FULL);
    let grader =
        &mut grader(&["class", "--lessons", "1-2", "--seed", "2"], &[("", &class), ("--out", &report)]);
    let output = grader.output().unwrap();
    if !ran(&output, &report) {
        return;
    }
    let looked = "  unnamed, 01-lines, 02-wireframe: found src/lib.rs, not graded because it is not said";
    assert!(said(&output).contains(looked), "{}", said(&output));
    let outcomes = outcomes(&report);
    let outcome = |name: &str, lesson: usize| outcomes[name][lesson]["outcome"].clone();
    assert!(outcome("both", 0).get("Ran").is_some() && outcome("both", 1).get("NotCompiled").is_some());
    assert!(outcome("first", 0).get("Ran").is_some());
    assert_eq!(outcome("first", 1), "Missing");
}
