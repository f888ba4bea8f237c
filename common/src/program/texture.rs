//! The texture of a model that brings its own, and of one that does not.

use std::path::{Component, Path, PathBuf};

use crate::model::Materials;
use crate::obj::Words;
use crate::printable::{printable, shown};
use crate::{Color, Format, Image, file};

/// The longest file of materials that is read, in bytes.
const FILE_LIMIT: u64 = 16 << 20;

/// The texture that a model's materials name, and the line that says which: the first `map_Kd` among the
/// materials that faces use, in the order of their use. It must lie in the model's folder or below, as TGA or
/// PNG. Where there is none, a checker, and the line says why.
pub(super) fn own(model: &Path, materials: &Materials) -> (Image, String) {
    let folder = model.parent().unwrap_or(Path::new(""));
    let found = name(folder, materials).and_then(|(name, count)| {
        let path = within(folder, &name)?;
        let texture = Image::read(&path).map_err(|error| error.to_string())?;
        let more = if count > 1 { format!(", the first of {count}: one is drawn") } else { String::new() };
        Ok((texture, format!("its texture is {}{more}", shown(&path))))
    });
    found.unwrap_or_else(|why| {
        (checker(), format!("drawn with a checker, as {why}; --texture FILE gives it another"))
    })
}

/// Eight by eight fields, light and dark.
fn checker() -> Image {
    let mut image = Image::new(8, 8, Format::Rgb);
    for (x, y) in (0..8).flat_map(|y| (0..8).map(move |x| (x, y))) {
        let light = if (x + y) % 2 == 0 { 230 } else { 150 };
        image.set(x, y, Color::rgb(light, light, light));
    }
    image
}

/// The name of the texture, as a file of materials has it, and of how many it is the first; or why there is none.
fn name(folder: &Path, materials: &Materials) -> Result<(String, usize), String> {
    let mut maps = Vec::new();
    let mut unread = None;
    for library in &materials.libraries {
        // One name with blanks in it, or several.
        let one = within(folder, library).and_then(|path| read(&path));
        let all = match one {
            Ok(bytes) => vec![Ok(bytes)],
            Err(_) => library
                .split_whitespace()
                .map(|name| within(folder, name).and_then(|path| read(&path)))
                .collect(),
        };
        for bytes in all {
            match bytes {
                Ok(bytes) => maps.extend(maps_of(&bytes)),
                Err(error) => unread = unread.or(Some(error)),
            }
        }
    }
    let map_of = |used: &String| maps.iter().find(|(material, _)| material == used);
    let mut names: Vec<&str> = if materials.used.is_empty() {
        maps.iter().take(1).map(|(_, name)| name.as_str()).collect()
    } else {
        materials.used.iter().filter_map(map_of).map(|(_, name)| name.as_str()).collect()
    };
    let Some(first) = names.first().map(|&first| first.to_string()) else {
        return Err(unread.unwrap_or_else(|| "it names none".into()));
    };
    names.sort_unstable();
    names.dedup();
    Ok((first, names.len()))
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    file::read_bytes(path, FILE_LIMIT).map_err(|error| error.to_string())
}

/// The materials that have a map for their diffuse colour, and its name, as an MTL file has them.
fn maps_of(bytes: &[u8]) -> Vec<(String, String)> {
    let mut words = Words::new(bytes);
    let mut material = String::new();
    let mut maps = Vec::new();
    let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
    loop {
        match words.word() {
            Some(b"newmtl") => material = text(words.rest()),
            Some(b"map_Kd") => {
                let name = map(&text(words.rest())).to_string();
                if !name.is_empty() {
                    maps.push((material.clone(), name));
                }
            }
            _ => {}
        }
        if !words.next_line() {
            return maps;
        }
    }
}

/// The name of a map without the options before it, such as `-s 2 2 1`, `-clamp on`.
fn map(mut text: &str) -> &str {
    let is_number_or_switch = |word: &str| matches!(word, "on" | "off") || word.parse::<f64>().is_ok();
    let mut option = None;
    loop {
        let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let is_value = is_number_or_switch(word)
            || option == Some("-imfchan") && matches!(word, "r" | "g" | "b" | "m" | "l" | "z");
        if word.starts_with('-') && !is_value {
            option = Some(word);
        } else if !(option.is_some() && is_value) {
            return text;
        }
        text = rest.trim_start();
    }
}

/// The path of a file that is named from a folder, if it is there and does not lead out of the folder.
fn within(folder: &Path, name: &str) -> Result<PathBuf, String> {
    // Names from Windows have backslashes.
    let relative = PathBuf::from(name.replace('\\', "/"));
    let inside = relative.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    let path = folder.join(&relative);
    let real = |path: &Path| path.canonicalize().ok();
    let root = real(if folder.as_os_str().is_empty() { Path::new(".") } else { folder });
    match (real(&path), root) {
        _ if !inside || name.contains(':') => {
            Err(format!("{} is not in the model's folder", printable(name)))
        }
        (Some(real), Some(root)) if !real.starts_with(&root) => {
            Err(format!("{} is not in the model's folder", printable(name)))
        }
        (None, _) => Err(format!("{} is not there", shown(&path))),
        _ => Ok(path),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_map_is_named_behind_its_options() {
        for (text, name) in [
            ("a.png", "a.png"),
            ("two words.png", "two words.png"),
            ("-s 2 2 1 -o .5 0 -clamp on a.png", "a.png"),
            ("-mm 0 1 dir\\a b.png", "dir\\a b.png"),
            ("-bm 1.5 7 up.png", "up.png"),
            ("-imfchan r -texres 512 b.png", "b.png"),
            ("-blendu off -mm -0.5 1 on.png", "on.png"),
            ("7", "7"),
            ("-s 1 1 1", ""),
            ("", ""),
        ] {
            assert_eq!(map(text), name, "{text}");
        }
    }

    #[test]
    fn fields_of_a_checker_that_share_a_side_differ() {
        let checker = checker();
        for (x, y, color) in checker.pixels() {
            assert!(
                [(x + 1, y), (x, y + 1)].iter().all(|&(x, y)| checker.get(x, y) != Some(color)),
                "({x}, {y})"
            );
        }
    }

    /// Of a folder with a texture in it, beside it and below, and files that are no texture.
    #[test]
    fn a_models_texture_is_the_one_that_its_material_names() {
        let above = tempfile::tempdir().unwrap();
        let folder = above.path().join("models");
        fs::create_dir_all(folder.join("maps")).unwrap();
        let red = |path: PathBuf| {
            let mut image = Image::new(1, 1, Format::Rgb);
            image.set(0, 0, Color::RED);
            image.write(&path).unwrap();
        };
        red(above.path().join("out.png"));
        red(folder.join("maps/in side.png"));
        fs::write(folder.join("half.png"), b"\x89PNG").unwrap();
        fs::write(folder.join("a.jpg"), b"\xff\xd8\xff").unwrap();
        let materials = "newmtl plain\nKd 1 1\nnewmtl in\n map_Kd -s 1 1 1 maps\\in side.png # c\nnewmtl out\nmap_Kd ../out.png\n\
                         newmtl far\nmap_Kd /etc/a.png\nnewmtl gone\nmap_Kd gone.png\nnewmtl jpg\nmap_Kd a.jpg\nnewmtl half\nmap_Kd half.png\n\
                         newmtl drive\nmap_Kd C:\\a.png\nnewmtl bare\nmap_Kd\nmap_Kd -s 1 1 1";
        fs::write(folder.join("a b.mtl"), materials).unwrap();
        fs::write(folder.join("c.mtl"), "newmtl c\n").unwrap();
        fs::write(folder.join("d.mtl"), "newmtl in\nmap_Kd maps/in side.png").unwrap();
        for (library, used, said) in [
            ("a b.mtl", &["plain", "in", "out"][..], "its texture is "),
            ("c.mtl", &["in"], "drawn with a checker, as it names none; --texture FILE gives it another"),
            ("a b.mtl", &["plain"], "as it names none;"),
            ("a b.mtl", &[], "its texture is "),
            ("a b.mtl", &["plain", "in", "gone", "in"], "in side.png, the first of 2: one is drawn"),
            ("a b.mtl", &["bare"], "as it names none;"),
            ("a b.mtl", &["out"], "as ../out.png is not in the model's folder;"),
            ("a b.mtl", &["far"], "as /etc/a.png is not in the model's folder;"),
            ("a b.mtl", &["drive"], r"as C:\a.png is not in the model's folder;"),
            ("a b.mtl", &["gone"], "gone.png is not there;"),
            ("a b.mtl", &["jpg"], "must end in .tga or .png"),
            ("a b.mtl", &["half"], "half.png: not a picture that can be read"),
            ("none.mtl", &["in"], "none.mtl is not there;"),
            ("none.mtl d.mtl", &["in"], "its texture is "),
            ("../a.mtl", &["in"], "as ../a.mtl is not in the model's folder;"),
        ] {
            let materials = Materials {
                libraries: vec![library.into()],
                used: used.iter().map(|&name| name.into()).collect(),
            };
            let (texture, line) = own(&folder.join("a.obj"), &materials);
            assert!(line.contains(said) && line.lines().count() == 1, "{library} {used:?}: {line}");
            let expected = if line.starts_with("its") { Color::RED } else { Color::rgb(230, 230, 230) };
            assert_eq!(texture.get(0, 0), Some(expected), "{library} {used:?}");
        }
    }

    /// A link that leads out of the folder leads nowhere.
    #[cfg(unix)]
    #[test]
    fn a_link_out_of_the_folder_is_not_followed() {
        let folder = tempfile::tempdir().unwrap();
        let outside = tempfile::tempdir().unwrap();
        Image::new(1, 1, Format::Rgb).write(&outside.path().join("a.png")).unwrap();
        std::os::unix::fs::symlink(outside.path().join("a.png"), folder.path().join("a.png")).unwrap();
        assert!(within(folder.path(), "a.png").unwrap_err().contains("not in the model's folder"));
    }
}
