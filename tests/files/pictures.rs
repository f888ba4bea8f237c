use std::fs;
use std::path::Path;

use common::file::Encoding;
use common::{Color, Error, Format, Image, PictureError};
use proptest::prelude::*;
use tempfile::tempdir;
use verify::{CRATE, SPHERE, run};

use crate::{assert_fails, names};

fn sample() -> Image {
    let mut image = Image::new(9, 7, Format::Rgb);
    for n in 0..40 {
        image.set(n % 9, n / 9, Color::random(n as u64 / 3));
    }
    image
}

#[test]
fn a_name_says_what_a_picture_is() {
    let folder = tempdir().unwrap();
    for (name, begins) in
        [("a.png", &b"\x89PNG"[..]), ("b.PNG", b"\x89PNG"), ("c.tga", b"\0\0\x0a"), ("d.Tga", b"\0\0\x0a")]
    {
        assert!(run("lines", folder.path(), &["--out", name]).status.success());
        assert!(fs::read(folder.path().join(name)).unwrap().starts_with(begins), "{name}");
    }
    for name in ["picture", "picture.bmp", "folder/", ".."] {
        let said = format!("{name}: the name of a picture must end in .tga or .png\n");
        assert_fails(&run("lines", folder.path(), &["--out", name]), 1, &[&said]);
    }
}

#[test]
fn an_ending_is_no_name() {
    let folder = tempdir().unwrap();
    for name in [".png", ".TGA"] {
        let said = format!(
            "{name}: the name of a picture must end in .tga or .png and begin with something else, as in a{name}"
        );
        assert_fails(&run("lines", folder.path(), &["--out", name]), 1, &[&said]);
    }
    assert_eq!(names(folder.path()), [""; 0]);
}

/// Names may hold what would break a line or move the cursor: it is escaped, whoever says it.
#[cfg(unix)]
#[test]
fn control_characters_in_names_are_escaped() {
    let folder = tempdir().unwrap();
    let (name, shown) = ("a\n\x1b[31m\u{202e}.png", r"a\n\u{1b}[31m\u{202e}.png");
    let output = run("lines", folder.path(), &["--out", name]);
    assert_eq!(String::from_utf8_lossy(&output.stdout), format!("{shown} (100x100)\n"));
    let model = "none\n.obj";
    for (lesson, arguments, code, said) in [
        ("lines", &["--out", "none/\n.png"][..], 1, r"cannot write none/\n.png"),
        ("wireframe", &["--model", model], 1, r"cannot read none\n.obj"),
        (
            "textures",
            &["--model", "--texture", name, "--out", "b.png", "--depth", "c\u{7}.bmp"],
            1,
            r"c\u{7}.bmp",
        ),
        ("textures", &["--texture", "no\x08ne.png"], 1, r"cannot read no\u{8}ne.png"),
        ("lines", &["--method", "a\nb\x1b"], 2, "--method"),
    ] {
        let output = run(lesson, folder.path(), arguments);
        assert_fails(&output, code, &[said]);
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(!error.trim_end().contains(char::is_control), "{error:?}");
    }
}

/// Two programs whose numbers are the same, as in two containers, write into one folder.
#[cfg(unix)]
#[test]
fn programs_that_write_into_one_folder_keep_their_own_pictures() {
    let folder = tempdir().unwrap();
    let lines = ["0,0,99,99,ff0000", "0,99,99,0,00ff00", "0,50,99,50,ffffff", "50,0,50,99,00ffff"];
    for _ in 0..10 {
        let children: Vec<_> = lines
            .iter()
            .enumerate()
            .map(|(n, line)| {
                let mut command = verify::program("lines", folder.path());
                command.args(["--line", line, "--out", &format!("{n}.png"), "--quiet"]);
                command.stdout(std::process::Stdio::null()).spawn().unwrap()
            })
            .collect();
        children.into_iter().for_each(|mut child| assert!(child.wait().unwrap().success()));
        for (n, line) in lines.iter().enumerate() {
            let picture = Image::read(&folder.path().join(format!("{n}.png"))).unwrap();
            let color: Color = line.rsplit(',').next().unwrap().parse().unwrap();
            assert!(picture.pixels().all(|pixel| [Color::BLACK, color].contains(&pixel.2)), "{n}.png");
        }
    }
    assert_eq!(names(folder.path()), ["0.png", "1.png", "2.png", "3.png"]);
}

/// Ended from outside at any moment, or by a limit on the size of a file, a program leaves nothing behind: there is
/// no name before there is a file.
#[cfg(target_os = "linux")]
#[test]
fn a_program_that_is_ended_leaves_nothing_behind() {
    let folder = tempdir().unwrap();
    let start = || {
        let mut command = verify::program("triangles", folder.path());
        command.args(["--size", "2000x2000", "--fill", "random", "--model", "--out", "a.tga", "--quiet"]);
        command.stdout(std::process::Stdio::null()).stderr(std::process::Stdio::null());
        command
    };
    let begun = std::time::Instant::now();
    assert!(start().status().unwrap().success());
    let whole = begun.elapsed();
    let bytes = fs::read(folder.path().join("a.tga")).unwrap();
    for n in 0..20 {
        fs::remove_file(folder.path().join("a.tga")).unwrap_or_default();
        let mut child = start().spawn().unwrap();
        std::thread::sleep(whole * n / 20);
        let signal = ["-INT", "-TERM", "-KILL"][n as usize % 3];
        std::process::Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
        child.wait().unwrap();
        let left = names(folder.path());
        assert!(left.is_empty() || left == ["a.tga"], "{signal}: {left:?}");
        assert!(left.is_empty() || fs::read(folder.path().join("a.tga")).unwrap() == bytes, "{signal}");
    }
    // The signal for too large a file, which ends the program.
    fs::write(folder.path().join("a.tga"), "old").unwrap();
    let script = "ulimit -f 1; exec \"$0\" \"$@\"";
    let mut limited = std::process::Command::new("sh");
    limited
        .args(["-c", script])
        .arg(start().get_program())
        .args(start().get_args())
        .current_dir(folder.path());
    assert!(!limited.stderr(std::process::Stdio::null()).status().unwrap().success());
    assert_eq!(names(folder.path()), ["a.tga"]);
    assert_eq!(fs::read(folder.path().join("a.tga")).unwrap(), b"old");
}

/// As any file of the user's, a picture is for whom the user's mask allows it.
#[cfg(unix)]
#[test]
fn a_picture_has_the_usual_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("usual"), "").unwrap();
    sample().write(&folder.path().join("a.png")).unwrap();
    let mode = |name| fs::metadata(folder.path().join(name)).unwrap().permissions().mode();
    assert_eq!(mode("a.png"), mode("usual"));
}

#[test]
fn without_a_name_there_are_two_files_in_out() {
    let folder = tempdir().unwrap();
    for _ in 0..2 {
        let output = run("lines", folder.path(), &[]);
        let said = format!("out{0}01-lines.tga, out{0}01-lines.png (100x100)\n", std::path::MAIN_SEPARATOR);
        assert_eq!(String::from_utf8_lossy(&output.stdout), said);
    }
    assert_eq!(names(&folder.path().join("out")), ["01-lines.png", "01-lines.tga"]);
    let [tga, png] =
        ["tga", "png"].map(|e| Image::read(&folder.path().join("out/01-lines").with_extension(e)).unwrap());
    assert_eq!(tga, png);
}

#[test]
fn a_named_folder_must_exist() {
    let folder = tempdir().unwrap();
    assert_fails(
        &run("lines", folder.path(), &["--out", "none/a.png"]),
        1,
        &["none", "a.png", "folder does not exist, create it first"],
    );
    fs::write(folder.path().join("out"), "a file").unwrap();
    assert_fails(
        &run("lines", folder.path(), &[]),
        1,
        &["cannot create the folder out/: there is a file of that name"],
    );
    let said = ["cannot write out/a.png: out is a file and no folder"];
    assert_fails(&run("lines", folder.path(), &["--out", "out/a.png"]), 1, &said);
    assert_eq!(names(folder.path()), ["out"]);
}

#[test]
fn what_cannot_be_replaced_stays() {
    let folder = tempdir().unwrap();
    fs::create_dir_all(folder.path().join("a.png/inside")).unwrap();
    assert_fails(&run("lines", folder.path(), &["--out", "a.png"]), 1, &["cannot write a.png"]);
    assert_eq!(names(folder.path()), ["a.png"]);
    assert_eq!(names(&folder.path().join("a.png")), ["inside"]);
}

/// A device with no room left, played by a limit on the size of a file: the old picture stays whole.
#[cfg(unix)]
#[test]
fn a_full_device_loses_nothing() {
    let folder = tempdir().unwrap();
    assert!(run("triangles", folder.path(), &["--out", "a.png"]).status.success());
    let before = fs::read(folder.path().join("a.png")).unwrap();
    let limited = "trap '' XFSZ; ulimit -f 1; exec \"$0\" --size 500x500 --fill random --model --out a.png";
    let program = verify::program("triangles", folder.path());
    let output = std::process::Command::new("sh")
        .args(["-c", limited])
        .arg(program.get_program())
        .current_dir(folder.path())
        .output();
    assert_fails(&output.unwrap(), 1, &["cannot write a.png", "File too large"]);
    assert_eq!(names(folder.path()), ["a.png"]);
    assert!(fs::read(folder.path().join("a.png")).unwrap() == before);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_output_is_told() {
    let folder = tempdir().unwrap();
    let full = || fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    for arguments in [&["--list"][..], &["--help"], &["--out", "a.png"]] {
        let output = verify::program("lines", folder.path()).args(arguments).stdout(full()).output().unwrap();
        assert_fails(&output, 1, &["cannot write to standard output", "No space left on device"]);
    }
}

/// Where nothing can be said there is nobody to tell; the exit code is what it would be.
#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_error_changes_nothing() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("some.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\nf 1 2\n").unwrap();
    let full = || fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    for (arguments, code) in [
        (&["--model", "some.obj", "--out", "a.png"][..], 0),
        (&["--model", "none.obj"], 1),
        (&["--nonsense"], 2),
    ] {
        let status = verify::program("wireframe", folder.path()).args(arguments).stderr(full()).output();
        assert_eq!(status.unwrap().status.code(), Some(code), "{arguments:?}");
    }
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_error() {
    let folder = tempdir().unwrap();
    for arguments in [&["--list"][..], &["--help"], &["--out", "a.png"]] {
        let mut command = verify::program("lines", folder.path());
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = command.args(arguments).stdout(writer).output().unwrap();
        assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]), "{arguments:?}");
    }
}

#[test]
fn the_first_program_draws_one_red_pixel() {
    let folder = tempdir().unwrap();
    assert!(run("pixel", folder.path(), &[]).status.success());
    let image = Image::read(&folder.path().join("out/pixel.png")).unwrap();
    assert_eq!((image.width(), image.height()), (100, 100));
    for (x, y, color) in image.pixels() {
        assert_eq!(color, if (x, y) == (52, 41) { Color::RED } else { Color::BLACK }, "({x}, {y})");
    }
}

#[test]
fn a_comparison_of_pictures_too_wide_for_one_is_an_error() {
    let folder = tempdir().unwrap();
    let compare =
        |size| run("lines", folder.path(), &["--compare", "wu,slope", "--out", "a.png", "--size", size]);
    assert_fails(
        &compare("16384x1"),
        1,
        &["side by side the pictures are 49164x1 pixels", "draw smaller ones"],
    );
    assert_eq!(names(folder.path()), [""; 0]);
    assert!(compare("2000x10").status.success());
    let sheet = Image::read(&folder.path().join("a.png")).unwrap();
    assert_eq!((sheet.width(), sheet.height()), (12_012, 20));
}

#[test]
fn a_truncated_or_altered_picture_is_an_error_that_names_it() {
    let folder = tempdir().unwrap();
    let huge = [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 32, 8];
    let tga = sample().encode(Encoding::TgaRle).unwrap();
    let png = sample().encode(Encoding::Png).unwrap();
    for (name, bytes) in [
        ("empty.tga", &[][..]),
        ("empty.png", &[]),
        ("half.tga", &tga[..tga.len() / 2]),
        ("half.png", &png[..png.len() / 2]),
        ("huge.tga", &huge),
        ("png.tga", &png),
        ("tga.png", &tga),
        ("text.png", b"v 0 0 0"),
    ] {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        let error = Image::read(&path).unwrap_err();
        let limits = matches!(error, Error::Picture { source: PictureError::TooLarge, .. });
        assert_eq!(limits, name == "huge.tga", "{error:?}");
        let error = error.to_string();
        assert!(error.contains(name) && error.contains("not a picture that can be read"), "{error}");
    }
    for (name, bytes, said) in [
        ("png.tga", &png[..], "it is a PNG picture, whose name ends in .png"),
        ("jpeg.png", b"\xff\xd8\xff\xe0\0\x10JFIF", "it is a JPEG picture: convert it to PNG"),
        ("jpeg.tga", b"\xff\xd8\xff\xe0\0\x10JFIF", "it is a JPEG picture: convert it to PNG"),
        ("gzip.png", b"\x1f\x8b\x08\0\0", "it is compressed by gzip: unpack it first"),
        ("page.png", b"<!doctype html>\n", "it is a page in HTML: download the file itself"),
        ("lfs.tga", b"version https://git-lfs.github.com/spec/v1\n", "it is a pointer of Git LFS"),
    ] {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        let error = Image::read(&path).unwrap_err().to_string();
        assert!(error.contains(name) && error.contains(said), "{error}");
    }
    let missing = Image::read(Path::new("none/none.png")).unwrap_err().to_string();
    assert_eq!(missing, "cannot read none/none.png");
    fs::create_dir(folder.path().join("folder.png")).unwrap();
    assert!(Image::read(&folder.path().join("folder.png")).is_err());
}

#[test]
fn flags_that_do_not_go_together_are_refused() {
    let folder = tempdir().unwrap();
    let same = ["--model", SPHERE, "--depth", "a.png", "--out"];
    for (lesson, arguments, said) in [
        ("triangles", &["--triangle", "0,0,1,0,0,1", "--model"][..], "cannot be used with '--model"),
        ("wireframe", &["--fit", "x"], "--fit"),
        ("zbuffer", &[&same[..], &["a.png"]].concat(), "'--out a.png': --depth names that file"),
        ("zbuffer", &[&same[..], &["./a.png"]].concat(), "name another one"),
        ("gouraud", &["--texture", "a.png", "--out", "./a.png"], "--texture names that file"),
    ] {
        assert_fails(&run(lesson, folder.path(), arguments), 2, &[said]);
    }
    assert_eq!(names(folder.path()), [""; 0]);
    let unnamed = ["--model", SPHERE, "--depth", "out/04-zbuffer.png"];
    assert_fails(&run("zbuffer", folder.path(), &unnamed), 2, &["the picture itself goes there"]);
    assert_eq!(names(&folder.path().join("out")), [""; 0]);
}

/// A name need not be text: the pictures' numbers are put into it as it is.
#[cfg(target_os = "linux")]
#[test]
fn a_turntables_names_keep_their_bytes() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let folder = tempdir().unwrap();
    let name = OsStr::from_bytes(b"a\xff.png");
    let mut command = verify::program("camera", folder.path());
    let output = command
        .args(["--turntable", "2", "--size", "9x9", "--model", SPHERE, "--texture", CRATE, "--out"])
        .arg(name)
        .output();
    assert!(output.unwrap().status.success());
    let mut written: Vec<_> =
        fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    written.sort();
    assert_eq!(written, [OsStr::from_bytes(b"a\xff-000.png"), OsStr::from_bytes(b"a\xff-001.png")]);
}

/// Far away or long, what has a direction has one.
#[test]
fn directions_may_have_any_length() {
    let folder = tempdir().unwrap();
    let draw = |flags: &[&str]| {
        let scene = ["--model", SPHERE, "--texture", CRATE, "--size", "60x60", "--out", "a.png"];
        let output = run("camera", folder.path(), &[&scene[..], flags].concat());
        assert!(output.status.success(), "{flags:?}: {}", String::from_utf8_lossy(&output.stderr));
        Image::read(&folder.path().join("a.png")).unwrap()
    };
    let same = |a: &[&str], b: &[&str]| {
        let (a, b) = (draw(a), draw(b));
        assert!(a.pixels().any(|pixel| pixel.2 != Color::BLACK));
        assert!(a.pixels().zip(b.pixels()).filter(|(a, b)| a.2 != b.2).count() <= 4);
    };
    same(&["--up", "1e20,1e20,0"], &["--up", "1,1,0"]);
    same(&["--up", "1e-30,0,0"], &["--up", "1,0,0"]);
    same(&["--eye", "0,0,1e20"], &["--eye", "0,0,1e9"]);
    same(&["--light", "1e-40,1e-40,0"], &["--light", "1,1,0"]);
}

#[test]
fn a_picture_without_pixels_is_not_written() {
    let folder = tempdir().unwrap();
    let error = Image::new(0, 5, Format::Rgb).write(&folder.path().join("a.tga")).unwrap_err();
    assert!(error.to_string().contains("cannot be encoded"));
    assert_eq!(names(folder.path()), [""; 0]);
}

#[cfg(target_os = "linux")]
#[test]
fn an_endless_file_is_refused() {
    let folder = tempdir().unwrap();
    std::os::unix::fs::symlink("/dev/zero", folder.path().join("zero.png")).unwrap();
    let error = Image::read(&folder.path().join("zero.png")).unwrap_err().to_string();
    assert!(error.contains("larger than the 256 MiB that are read"), "{error}");
}

proptest! {
    /// However the bytes of a picture are altered, reading them gives a picture or an error.
    #[test]
    fn no_bytes_panic(
        format in 0..3usize,
        encoding in 0..3usize,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..9),
        cut in any::<prop::sample::Index>(),
    ) {
        let encoding = [Encoding::TgaRle, Encoding::TgaRaw, Encoding::Png][encoding];
        let mut bytes = Image::new(7, 5, [Format::Gray, Format::Rgb, Format::Rgba][format]).encode(encoding).unwrap();
        for (at, byte) in changes {
            // The first bytes, the header, are altered more often than the rest.
            let at = at.index(bytes.len()).min(at.index(40));
            bytes[at] = byte;
        }
        bytes.truncate(bytes.len() - cut.index(bytes.len() + 1) / 4);
        let _ = Image::decode(&bytes, encoding);
    }
}
