//! No page shows, before a mission, what the mission asks for.

use std::fs;
use std::path::Path;

use tasks::COURSE;

/// What a learner has read before the first mission.
const BEFORE_ALL: [&str; 2] = ["book/pages/first-ten-minutes.md", "book/pages/rust.md"];

/// A shorter body is a formula of the chapter, which is there to be read.
const SHORT: usize = 40;

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(COURSE).join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Code without what does not matter: spaces, commas at the ends of lists, and comments.
fn bare(code: &str) -> String {
    let lines = code.lines().map(|line| line.split_once("//").map_or(line, |(before, _)| before));
    let dense: String = lines.flat_map(str::chars).filter(|c| !c.is_whitespace()).collect();
    dense.replace(",)", ")").replace(",}", "}")
}

/// A page with what it quotes in the place of the quotations, such as `{{#include file.rs:anchor}}`.
fn with_quotes(page: &str) -> String {
    let mut parts = page.split("{{#include ");
    let first = parts.next().unwrap_or_default().to_string();
    parts.fold(first, |text, part| {
        let (place, rest) = part.split_once("}}").expect("a quotation ends");
        let place = place.split(' ').next().unwrap_or_default();
        let (file, anchor) = place.split_once(':').expect("a quotation has an anchor");
        let code = read(file);
        let (_, code) = code.split_once(&format!("ANCHOR: {anchor}\n")).expect("the anchor is there");
        let (code, _) = code.split_once(&format!("ANCHOR_END: {anchor}\n")).expect("it has an end");
        text + code + rest
    })
}

/// The functions in a file, each as its name and what stands between its braces.
fn functions(code: &str) -> Vec<(String, String)> {
    let starts = code.match_indices("fn ").map(|(at, _)| &code[at + 3..]);
    let function = |text: &str| {
        let name: String = text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
        let open = text.find('{')?;
        let mut depth = 0;
        let end = text[open..].char_indices().find_map(|(at, c)| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            (depth == 0).then_some(open + at)
        })?;
        (!name.is_empty()).then(|| (name, text[open + 1..end].to_string()))
    };
    starts.filter_map(function).collect()
}

/// What would be an answer to a mission: the bodies of its solution's functions, of the lesson's of these names, and of
/// what these call in the lesson, unless it is given.
fn answers(lesson: &str) -> Vec<(String, String)> {
    let solution = read(&format!("tests/lessons/{lesson}/solution.rs"));
    let given = solution.split("fn ").next().unwrap_or_default().to_string();
    let solution = functions(&solution);
    let folder = Path::new(COURSE).join("lessons").join(lesson).join("src");
    let mut own = Vec::new();
    for entry in fs::read_dir(folder).expect("a lesson has code") {
        let path = entry.expect("the folder can be read").path();
        if path.extension().is_some_and(|extension| extension == "rs") {
            own.extend(functions(&fs::read_to_string(path).expect("it is text")));
        }
    }
    // Methods of traits have one name in many bodies.
    let is_method = |name: &str| ["corner", "triangle", "intensity", "color", "new"].contains(&name);
    own.retain(|(name, _)| !is_method(name) && !given.contains(name.as_str()));
    let asked = |name: &String| solution.iter().any(|(asked, _)| asked == name);
    let bodies: String = own.iter().filter(|(name, _)| asked(name)).map(|(_, body)| body.as_str()).collect();
    own.retain(|(name, _)| asked(name) || bodies.contains(&format!("{name}(")));
    solution.into_iter().chain(own).map(|(name, body)| (name, bare(&body))).collect()
}

/// What of a mission's answers stands in a text.
fn shown(text: &str, lesson: &str) -> Vec<String> {
    let text = bare(&with_quotes(text));
    let long = answers(lesson).into_iter().filter(|(_, body)| body.len() > SHORT);
    long.filter(|(_, body)| text.contains(body)).map(|(name, _)| name).collect()
}

#[test]
fn no_answer_stands_before_its_mission() {
    for lesson in tasks::lessons(Path::new(COURSE)).expect("the workspace can be read") {
        let chapter = read(&format!("book/lessons/{lesson}/chapter.md"));
        let (before, _) = chapter.split_once("\n## The mission\n").expect("a chapter has a mission");
        for (place, text) in
            BEFORE_ALL.map(|page| (page, read(page))).into_iter().chain([("its chapter", before.to_string())])
        {
            let shown = shown(&text, &lesson);
            assert!(shown.is_empty(), "{place} shows the answer to mission {lesson}: {shown:?}");
        }
    }
}

#[test]
fn an_answer_would_be_seen() {
    for lesson in ["01-lines", "03-triangles", "07-transforms"] {
        let chapter = read(&format!("book/lessons/{lesson}/chapter.md"));
        let (_, behind) = chapter.split_once("\n## Our solution\n").expect("a chapter has a solution");
        assert!(!shown(behind, lesson).is_empty(), "{lesson}");
    }
}
