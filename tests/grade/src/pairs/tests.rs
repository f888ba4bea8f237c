//! Copies are found, honest texts are not, and no text breaks it.

use std::collections::{BTreeMap, HashSet};
use std::path::Path;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

use super::compare::{passages, shares};
use super::fingerprints::{FOUND, GRAM, Work, grams};
use super::tokens::tokens;
use super::{Found, Options, Shares, page, prepare};
use crate::report::tests::page as html;

const COURSE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn work(text: &str) -> Work {
    Work::new(&tokens(text), &HashSet::new())
}

fn share(first: &str, second: &str) -> f64 {
    shares(&work(first), &work(second)).larger()
}

fn course(path: &str) -> String {
    std::fs::read_to_string(Path::new(COURSE).join(path)).unwrap()
}

/// A text with other names, numbers and strings, one token a line, and comments between them.
fn disguised(text: &str) -> String {
    let tokens = tokens(text);
    let token = |(kind, place): (&u8, &std::ops::Range<usize>)| match kind {
        b'i' => format!("x_{}", text[place.clone()].trim_start_matches("r#")),
        b'0' => "4_711".into(),
        b'"' => "\"other words\"".into(),
        _ => text[place.clone()].into(),
    };
    let all: Vec<String> = tokens.kinds.iter().zip(&tokens.places).map(token).collect();
    all.join("\n\t/* so /* it */ is */ // as if\n")
}

/// A lesson's solution, and what is given for it.
fn solutions() -> Vec<(String, String, HashSet<u64>)> {
    let read = |lesson: String| {
        let starter = course(&format!("lessons/{lesson}/mission/src/lib.rs"));
        let given = grams(&tokens(&starter).kinds).map(|(hash, _)| hash).collect();
        (lesson.clone(), course(&format!("tests/lessons/{lesson}/solution.rs")), given)
    };
    tasks::lessons(Path::new(COURSE)).unwrap().into_iter().map(read).collect()
}

#[test]
fn a_disguised_copy_is_the_same() {
    for (lesson, solution, given) in solutions() {
        let copy = disguised(&solution);
        assert_ne!(copy, solution);
        let [first, second] = [&solution, &copy].map(|text| Work::new(&tokens(text), &given));
        let shares = shares(&first, &second);
        assert!(first.own > super::LEAST, "{lesson}: {} tokens", first.own);
        assert_eq!((shares.of_first, shares.of_second), (1.0, 1.0), "{lesson}");
        // Not by the short cut for equal texts, either.
        let shared: usize = passages(&first, &second).iter().map(|passage| passage.here.len()).sum();
        assert_eq!(shared, first.own, "{lesson}");
    }
}

#[test]
fn functions_in_another_order_are_found_and_so_is_a_copy_in_much_else() {
    let [one, two, three] = ["01-lines", "03-triangles", "12-lighting"]
        .map(|lesson| course(&format!("tests/lessons/{lesson}/solution.rs")));
    let moved = disguised(&format!("{three}\n{one}\n{two}"));
    assert!(share(&format!("{one}\n{two}\n{three}"), &moved) > 0.95);
    let shares = shares(&work(&one), &work(&moved));
    assert!(shares.of_first > 0.95 && shares.of_second < 0.6, "{shares:?}");
    // A statement changed in the middle costs that passage's surroundings, and no more.
    let changed = one.replace("error += 2 * rise;", "error = error + rise + rise; let _unused = [1, 2, 3];");
    assert_ne!(changed, one);
    assert!(share(&one, &changed) > 0.75);
}

#[test]
fn honest_texts_have_little_in_common() {
    // The course's own methods for the same function were each written for itself.
    for (lesson, files) in [
        ("01-lines", &["bresenham", "distance", "major", "slides", "wu"][..]),
        ("03-triangles", &["barycentric", "edges", "slides"]),
    ] {
        let texts: Vec<String> =
            files.iter().map(|file| course(&format!("lessons/{lesson}/src/{file}.rs"))).collect();
        for (n, first) in texts.iter().enumerate() {
            for (m, second) in texts.iter().enumerate().skip(n + 1) {
                let share = share(first, second);
                println!("{lesson} {} {}: {share:.2}", files[n], files[m]);
                assert!(share < 0.5, "{lesson}: {} and {} share {share}", files[n], files[m]);
            }
        }
    }
    // Nor have solutions of different missions.
    let all = solutions();
    for (n, (first, text, _)) in all.iter().enumerate() {
        for (second, other, _) in &all[n + 1..] {
            let share = share(text, other);
            assert!(share < 0.5, "{first} and {second} share {share}");
        }
    }
}

#[test]
fn a_starter_has_nothing_of_its_own() {
    for lesson in tasks::lessons(Path::new(COURSE)).unwrap() {
        let starter = course(&format!("lessons/{lesson}/mission/src/lib.rs"));
        let names = |name: &str| vec![name.to_string()];
        let copy = disguised(&starter).into_bytes();
        let texts = BTreeMap::from([(starter.into_bytes(), names("ann")), (copy, names("ben"))]);
        let lesson = prepare(Path::new(COURSE), &lesson, texts, &mut Vec::new()).unwrap();
        assert_eq!(lesson.short, 2, "{}", lesson.name);
    }
}

#[test]
fn what_most_have_is_left_out_and_the_two_who_share_more_are_seen() {
    let everybody = course("tests/lessons/01-lines/solution.rs");
    let own = course("tests/lessons/03-triangles/solution.rs");
    // Different in each text.
    let filler = |n: u64| {
        let mut state = n;
        let mut sign = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ["+", "-", "*", "/", "%", "&", "|", "^"][(state >> 61) as usize]
        };
        let sum: String = (0..100).map(|_| format!("1 {} ", sign())).collect();
        format!("const A: i32 = {sum} 1;")
    };
    let mut texts = BTreeMap::new();
    for n in 0..12 {
        let own = if n < 2 { own.clone() } else { String::new() };
        texts.insert(format!("{everybody}{own}{}", filler(n)).into_bytes(), vec![format!("{n:02}")]);
    }
    let lesson = prepare(Path::new(COURSE), "01-lines", texts, &mut Vec::new()).unwrap();
    assert!(lesson.common > 100, "{}", lesson.common);
    let share = |a: usize, b: usize| shares(&lesson.texts[a].work, &lesson.texts[b].work).larger();
    // That all of them have it from the course is seen.
    let solution = lesson.texts.iter().rfind(|text| text.given).unwrap();
    for text in &lesson.texts[..12] {
        let (own, other) = text.with(solution).unwrap();
        assert_eq!(shares(own, other).of_second, 1.0);
    }
    assert!(share(0, 1) > 0.3 && share(0, 1) > 2.0 * share(2, 3), "{} {}", share(0, 1), share(2, 3));
}

#[test]
fn what_is_no_rust_is_told_with_its_line() {
    for (text, fault) in [
        ("fn f() {}\n/* /* */", Some((2, "a comment without an end"))),
        ("\n\nlet a = \"b;", Some((3, "a string without an end"))),
        ("r#\"a\"", Some((1, "a raw string without an end"))),
        ("a\n№", Some((2, "something that is no token of Rust"))),
        ("#!/usr/bin/env x\n#![a] fn f<'a>(b: &'a str) -> char { 'c' } // №", None),
        ("", None),
    ] {
        assert_eq!(tokens(text).fault, fault, "{text}");
    }
}

/// A text made of pieces of Rust and of anything.
fn text() -> impl Strategy<Value = String> {
    let rust = select(vec![
        "fn ", "let ", "x", "y ", "(", ")", "{", "}", "1", "2.5", "\"", "'a ", "'b'", "/*", "*/", "//", "\n",
        "r#\"", "\"#", "+", "=", ";", ", ", "№", "\0", "\u{ffff}", "#!", "---\n", "é", "<", "&", "</pre>",
        "k#", "b'",
    ]);
    let piece = prop_oneof![8 => rust.prop_map(String::from), 1 => any::<char>().prop_map(String::from)];
    vec(piece, 0..400).prop_map(|pieces| pieces.concat())
}

/// Tokens, by their number, in which much is repeated.
fn words(count: impl Into<proptest::collection::SizeRange>) -> impl Strategy<Value = Vec<usize>> {
    vec(0..8_usize, count)
}

fn spelt(words: &[usize], other: bool) -> String {
    let one = ["fn", "(", "name", "7", "+", "{", "\"a\"", "'a"];
    let another = ["fn", "(", "r#loop", "0x2f", "+", "{", "r\"b c\"", "'static"];
    let (spelling, between) = if other { (another, " // else\n") } else { (one, " ") };
    words.iter().map(|word| spelling[*word]).collect::<Vec<_>>().join(between)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_texts_can_be_compared_and_the_page_holds_them(first in text(), second in text()) {
        let names = |name: &str| vec![name.to_string(), "<b>\"'&".into()];
        let texts = BTreeMap::from([(first.clone().into_bytes(), names("ann")), (second.clone().into_bytes(), names("=ben"))]);
        let mut notes = Vec::new();
        let lesson = prepare(Path::new(COURSE), "01-lines", texts, &mut notes).unwrap();
        let mut found = Found { lessons: vec![lesson], pairs: vec![], above: 0, notes };
        let [class, report, folder] = [""; 3].map(Into::into);
        let options = Options { class, report, course: folder, lessons: vec![], least: 0.0, most: 9 };
        found.compare(&options);
        let page = html(&page::page(&found, &options).unwrap());
        prop_assert_eq!(&*page.errors.borrow(), &Vec::<String>::new());
        page::table(&found).unwrap();
        for pair in &found.pairs {
            let Shares { of_first, of_second } = pair.shares;
            prop_assert!([of_first, of_second].iter().all(|share| (0.0..=1.0).contains(share)));
        }
    }

    #[test]
    fn neither_text_is_the_first(first in words(0..300), second in words(0..300), both in words(0..80)) {
        let [first, second] = [first, second].map(|words| work(&spelt(&[words, both.clone()].concat(), false)));
        let (there, back) = (shares(&first, &second), shares(&second, &first));
        prop_assert_eq!((there.of_first, there.of_second), (back.of_second, back.of_first));
    }

    #[test]
    fn a_text_is_all_of_itself(own in words(GRAM..300)) {
        let own = work(&spelt(&own, false));
        let shares = shares(&own, &own.clone());
        prop_assert_eq!((shares.of_first, shares.of_second), (1.0, 1.0));
    }

    #[test]
    fn names_numbers_strings_and_layout_make_no_difference(own in words(0..300), other in words(0..300)) {
        let [plain, renamed] = [false, true].map(|other| work(&spelt(&own, other)));
        prop_assert_eq!(&plain.kinds, &renamed.kinds);
        let other = work(&spelt(&other, false));
        prop_assert_eq!(shares(&plain, &other), shares(&renamed, &other));
    }

    /// What winnowing promises.
    #[test]
    fn a_long_passage_is_always_found(before in words(0..90), shared in words(FOUND), after in words(0..90)) {
        let text = |begin: &[usize], end: &[usize]| work(&spelt(&[begin, &shared, end].concat(), false));
        let (first, second) = (text(&before, &after), text(&after, &before));
        let shared = before.len()..before.len() + FOUND;
        let found = passages(&first, &second);
        prop_assert!(found.iter().any(|passage| passage.here.start < shared.end && passage.here.end > shared.start));
        for passage in &found {
            prop_assert_eq!(&first.kinds[passage.here.clone()], &second.kinds[passage.there.clone()]);
        }
        prop_assert!(found.windows(2).all(|two| two[0].here.end <= two[1].here.start));
    }
}
