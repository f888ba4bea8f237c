//! What a path says of the mission that a file is meant for.

/// Folders of the course in which nothing is handed in.
const COURSE: [&str; 5] = ["assets", "book", "common", "tests", "target"];

/// What a path says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// It is the mission's file of this lesson, the `n`-th of all.
    Mission(usize),
    /// It is in a folder of this lesson, but not where the mission's file is.
    Beside(usize),
    /// It is a mission's file, but of which lesson is not said.
    Unnamed,
    /// It is no mission's file.
    Elsewhere,
}

/// Finds a file's place among lessons such as `01-lines`. Upper and lower case are the same, and so are `_` and `-`.
pub(super) fn place(path: &str, lessons: &[String]) -> Place {
    let path = path.to_lowercase();
    let mut folders: Vec<&str> = path.split('/').collect();
    let file = folders.pop().and_then(|file| file.strip_suffix(".rs")).unwrap_or_default();
    if folders.iter().any(|folder| COURSE.contains(folder)) {
        return Place::Elsewhere;
    }
    let of_file = lesson(file, lessons).or_else(|| lesson(without_number(file), lessons));
    let of_folder =
        folders.iter().enumerate().rev().find_map(|(n, folder)| Some((n, lesson(folder, lessons)?)));
    let library = file == "lib" || without_number(file) == "lib";
    match (of_folder, of_file) {
        (Some((n, lesson)), of_file) => {
            let inside = matches!(folders[n + 1..], [] | ["src" | "mission"] | ["mission", "src"]);
            let meant = library || of_file == Some(lesson);
            if inside && meant { Place::Mission(lesson) } else { Place::Beside(lesson) }
        }
        (None, Some(lesson)) => Place::Mission(lesson),
        (None, None) if library => Place::Unnamed,
        (None, None) => Place::Elsewhere,
    }
}

/// Which lesson a word names: `01-lines`, `1_lines`, `lines`, `my-lines`, `lesson1`, `mission 01`.
fn lesson(word: &str, lessons: &[String]) -> Option<usize> {
    let word = word.replace(['_', ' '], "-");
    let word = word.strip_prefix("my-").unwrap_or(&word);
    let bare = word.strip_prefix("lesson").or_else(|| word.strip_prefix("mission"));
    let number = |text: &str| text.parse::<usize>().ok();
    lessons.iter().position(|lesson| {
        let (own, name) = (number(tasks::number(lesson)), tasks::name(lesson));
        let numbered = bare.is_some_and(|bare| number(bare.trim_start_matches('-')) == own && own.is_some());
        let both = word.split_once('-').is_some_and(|(first, rest)| number(first) == own && rest == name);
        numbered || both || word == name
    })
}

/// A file's name without the number that a browser or Canvas appends to a second copy: `lib-1`, `lib (2)`.
fn without_number(name: &str) -> &str {
    let digits = |text: &str| text.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    let inner = name.strip_suffix(')').unwrap_or(name);
    let rest = &inner[..digits(inner)];
    let opened = if inner.len() < name.len() { rest.strip_suffix('(') } else { rest.strip_suffix('-') };
    opened.filter(|_| rest.len() < inner.len()).map_or(name, str::trim_end)
}

/// Where the course, or a copy of it, has its top folder: what is before `lessons/01-lines/`; nothing elsewhere.
pub(super) fn top<'a>(path: &'a str, lessons: &[String]) -> Option<&'a str> {
    let mut begin = 0;
    let mut folders = path.split_inclusive('/').peekable();
    while let Some(folder) = folders.next() {
        let next = folders.peek().map(|next| next.trim_end_matches('/').to_lowercase());
        if COURSE.iter().any(|own| folder.trim_end_matches('/').eq_ignore_ascii_case(own)) {
            return None;
        }
        if folder.eq_ignore_ascii_case("lessons/") && next.is_some_and(|next| lessons.contains(&next)) {
            return Some(&path[..begin]);
        }
        begin += folder.len();
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_shape_says_what_it_is() {
        use Place::{Beside, Elsewhere, Mission, Unnamed};
        let lessons = ["01-lines", "02-wireframe", "10-perspective"].map(String::from);
        for (path, expected) in [
            ("lib.rs", Unnamed),
            ("src/lib.rs", Unnamed),
            ("mission/src/LIB.RS", Unnamed),
            ("lib-1.rs", Unnamed),
            ("a/b/lib (2).rs", Unnamed),
            ("lines.rs", Mission(0)),
            ("Lines.rs", Mission(0)),
            ("01_lines.rs", Mission(0)),
            ("1-lines-2.rs", Mission(0)),
            ("10-Perspective.rs", Mission(2)),
            ("lesson 1.rs", Mission(0)),
            ("Mission02/lib.rs", Mission(1)),
            ("my-lines/src/lib.rs", Mission(0)),
            ("a/b/01-lines/mission/src/lib.rs", Mission(0)),
            ("lessons/01-lines/src/lib.rs", Mission(0)),
            ("lessons/01-lines/mission/src/main.rs", Beside(0)),
            ("lessons/01-lines/mission/tests/lib.rs", Elsewhere),
            ("02-wireframe/lines.rs", Beside(1)),
            ("02-lines.rs", Elsewhere),
            ("common/src/lib.rs", Elsewhere),
            ("tests/lessons/01-lines/solution.rs", Elsewhere),
            ("main.rs", Elsewhere),
            ("lines.txt", Elsewhere),
            ("1.rs", Elsewhere),
            ("lesson.rs", Elsewhere),
            ("(1).rs", Elsewhere),
            ("", Elsewhere),
        ] {
            assert_eq!(place(path, &lessons), expected, "{path}");
        }
    }

    #[test]
    fn a_copy_of_the_course_is_seen() {
        let lessons = ["01-lines".to_string()];
        assert_eq!(top("lessons/01-lines/src/lib.rs", &lessons), Some(""));
        assert_eq!(top("a/b/Lessons/01-lines/x.rs", &lessons), Some("a/b/"));
        assert_eq!(top("tests/lessons/01-lines/x.rs", &lessons), None);
        assert_eq!(top("lessons/lines.rs", &lessons), None);
    }
}
