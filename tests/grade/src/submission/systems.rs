//! How the downloads of learning systems name what each student handed in.

/// What the name of a file or folder of a download says.
#[derive(Debug, PartialEq)]
pub(super) struct Named<'a> {
    /// Whose it is.
    pub(super) owner: String,
    /// The rest of the name.
    pub(super) file: &'a str,
    /// Whether it is marked as late.
    pub(super) late: bool,
}

/// What a name says; nothing if it is not one of a download.
///
/// - Moodle: `Ann Smith_1234_assignsubmission_file_`, a folder, or the same with a file's name behind it. What was
///   typed in online is in another one, `…_assignsubmission_onlinetext_`.
/// - Canvas: `smithann_1234_56789_lines.rs`, with `_LATE` after the name if it was late: the student, the student's number,
///   that of the upload, and the file's name.
pub(super) fn named(name: &str) -> Option<Named<'_>> {
    moodle(name).or_else(|| canvas(name))
}

fn moodle(name: &str) -> Option<Named<'_>> {
    let (student, rest) = name.split_once("_assignsubmission_")?;
    let rest = rest.strip_prefix("file").or_else(|| rest.strip_prefix("onlinetext"))?;
    let file = rest.strip_prefix('_').or_else(|| rest.is_empty().then_some(""))?;
    (!student.is_empty()).then(|| Named { owner: student.to_string(), file, late: false })
}

fn canvas(name: &str) -> Option<Named<'_>> {
    let number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let (student, rest) = name.split_once('_')?;
    let marked = rest.strip_prefix("LATE_");
    let rest = marked.unwrap_or(rest);
    let (own, rest) = rest.split_once('_')?;
    let (upload, file) = rest.split_once('_')?;
    (!student.is_empty() && number(own) && number(upload) && !file.is_empty()).then(|| Named {
        owner: format!("{student}_{own}"),
        file,
        late: marked.is_some(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn downloads_say_whose_what_is() {
        for (name, expected) in [
            ("Ann Smith_1234_assignsubmission_file_", Some(("Ann Smith_1234", ""))),
            ("Ann Smith_1234_assignsubmission_file", Some(("Ann Smith_1234", ""))),
            ("Ann Smith_1234_assignsubmission_onlinetext_", Some(("Ann Smith_1234", ""))),
            ("Ann Smith_1234_assignsubmission_file_my_lines.rs", Some(("Ann Smith_1234", "my_lines.rs"))),
            ("smithann_1234_56789_01_lines.rs", Some(("smithann_1234", "01_lines.rs"))),
            ("smithann_LATE_1234_56789_lib-1.rs", Some(("smithann_1234", "lib-1.rs"))),
            ("smithann_1234_lines.rs", None),
            ("01_lines.rs", None),
            ("lines-annsmith", None),
            ("_1_2_x", None),
        ] {
            let late = name.contains("LATE");
            let expected = expected.map(|(owner, file): (&str, _)| Named { owner: owner.into(), file, late });
            assert_eq!(named(name), expected, "{name}");
        }
    }
}
