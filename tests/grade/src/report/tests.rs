//! Whatever students call themselves and say, the reports can be read again.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use html5ever::tokenizer::states::RawKind;
use html5ever::tokenizer::{BufferQueue, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts};
use judge::message;
use proptest::collection::{btree_map, vec};
use proptest::prelude::*;

use super::{Extras, PAGE, write};
use crate::results::{Check, Class, Judged, Lesson, Look, Outcome, Work, Wrong, total};
use crate::submission::name_of;

/// What a file's name can be, made of pieces of which some are no text.
fn name() -> impl Strategy<Value = String> {
    let odd =
        prop::sample::select(vec!["\u{1}", "\u{1b}", "\u{7f}", "\u{fffe}", "\u{ffff}", "\"'<>&%=+ .", "é"]);
    let byte = (1..=255_u8).prop_filter("no file has it", |byte| *byte != b'/').prop_map(|byte| vec![byte]);
    let piece = prop_oneof![byte, odd.prop_map(|text| text.as_bytes().to_vec())];
    let name = vec(piece, 1..250).prop_map(|pieces| name_of(&pieces.concat()));
    name.prop_filter("hidden", |name| !name.starts_with('.'))
}

fn message() -> impl Strategy<Value = String> {
    let odd =
        prop::sample::select(vec!['\0', '\r', '\n', '\u{1b}', '\u{fffe}', '\u{ffff}', '<', '&', ']', '>']);
    let text = vec(prop_oneof![any::<char>(), odd], 0..40).prop_map(String::from_iter);
    let markup = prop::sample::select(vec!["]]>", "</pre><script>x</script>", "<!--", "&amp;", "\u{feff}"]);
    (text, markup, 0..200_usize)
        .prop_map(|(text, markup, times)| message::cut(&format!("{text}{}", markup.repeat(times))))
}

fn outcome() -> impl Strategy<Value = Outcome> {
    let ran = |(said, cause, printed): (String, String, String)| {
        let wrong = Wrong { input: "an input".into(), findings: vec![said] };
        let wrong =
            Judged { earned: 0, cause: Some(cause), inputs: 2, wrong: 2, told: vec![wrong], pictures: None };
        let right = Judged { earned: 2, cause: None, inputs: 3, wrong: 0, told: vec![], pictures: None };
        Outcome::Ran { checks: vec![wrong, right], printed }
    };
    prop_oneof![
        Just(Outcome::Missing),
        message().prop_map(Outcome::NotCompiled),
        (message(), message()).prop_map(|(found, because)| Outcome::NotGraded(Look {
            found,
            because,
            cure: "look".into()
        })),
        (message(), message(), message()).prop_map(ran),
    ]
}

fn class() -> impl Strategy<Value = Class> {
    btree_map(name(), outcome(), 1..5).prop_map(|students| {
        let check = |name: &str, points| Check { name: name.into(), asks: "what".into(), points };
        let lesson = Lesson { name: "01-lines".into(), checks: vec![check("a", 8), check("b", 2)] };
        let work = |(name, outcome)| (name, vec![Work { text: String::new(), outcome }]);
        let submissions = students.into_iter().map(work).collect::<BTreeMap<_, _>>();
        Class { seed: 2, lessons: vec![lesson], walls: vec![], submissions, late: BTreeSet::new() }
    })
}

/// The texts of a page, the tags between which they stand, and what is wrong with it.
#[derive(Default)]
pub(crate) struct Page {
    texts: RefCell<Vec<String>>,
    tags: RefCell<Vec<String>>,
    pub(crate) errors: RefCell<Vec<String>>,
}

impl TokenSink for Page {
    type Handle = ();

    fn process_token(&self, token: Token, line: u64) -> TokenSinkResult<()> {
        match token {
            Token::CharacterTokens(text) => {
                if let Some(last) = self.texts.borrow_mut().last_mut() {
                    last.push_str(&text);
                }
            }
            Token::TagToken(tag) => {
                self.texts.borrow_mut().push(String::new());
                self.tags.borrow_mut().push(tag.name.to_string());
                if tag.kind == html5ever::tokenizer::StartTag && matches!(&*tag.name, "style" | "script") {
                    return TokenSinkResult::RawData(RawKind::Rawtext);
                }
            }
            Token::ParseError(what) => self.errors.borrow_mut().push(format!("{line}: {what}")),
            Token::NullCharacterToken => self.errors.borrow_mut().push(format!("{line}: NUL")),
            Token::DoctypeToken(_) | Token::CommentToken(_) | Token::EOFToken => (),
        }
        TokenSinkResult::Continue
    }
}

pub(crate) fn page(text: &str) -> Page {
    let input = BufferQueue::default();
    input.push_back(text.into());
    let tokenizer =
        Tokenizer::new(Page::default(), TokenizerOpts { exact_errors: true, ..TokenizerOpts::default() });
    let _ = tokenizer.feed(&input);
    tokenizer.end();
    tokenizer.sink
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn all_reports_are_read_again(class in class()) {
        let folder = tempfile::tempdir().unwrap();
        let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
        write(&class, vec![], &Extras::default(), folder.path()).unwrap();
        prop_assert_eq!(&Class::read(folder.path()).unwrap(), &class);

        let grades = read("grades.csv");
        let mut grades = csv::Reader::from_reader(grades.as_bytes());
        let rows: Vec<csv::StringRecord> = grades.records().map(Result::unwrap).collect();
        prop_assert_eq!(rows.len(), class.submissions.len());

        let junit = read("junit.xml");
        let junit = roxmltree::Document::parse(&junit).unwrap();
        let suites: Vec<_> = junit.descendants().filter(|node| node.has_tag_name("testsuite")).collect();
        prop_assert_eq!(suites.len(), class.submissions.len());

        let html = page(&read(PAGE));
        prop_assert_eq!(&*html.errors.borrow(), &Vec::<String>::new());
        let texts = html.texts.borrow();
        // Both of its ends.
        prop_assert_eq!(html.tags.borrow().iter().filter(|tag| *tag == "script").count(), 2);

        for (((name, works), row), suite) in class.submissions.iter().zip(&rows).zip(&suites) {
            prop_assert!(row[0] == **name || row[0] == format!("'{name}"), "{} {name}", &row[0]);
            prop_assert!(texts.contains(name), "{name}");
            prop_assert_eq!(suite.attribute("name").unwrap(), format!("{name}: 01-lines"));
            prop_assert!(name.len() <= 200);

            let said = match &works[0].outcome {
                Outcome::NotCompiled(said) => said.as_str(),
                Outcome::Ran { printed, .. } => printed.trim(),
                _ => "",
            };
            let own = page(&read(&super::student::file(name)));
            prop_assert_eq!(&*own.errors.borrow(), &Vec::<String>::new());
            let texts = own.texts.borrow();
            prop_assert!(texts.contains(name), "{name}");
            prop_assert!(said.is_empty() || texts.iter().any(|text| text == said), "{said:?}");
            let path = folder.path().join("gradescope").join(name).join("results.json");
            prop_assert_eq!(path.exists(), total(works).is_some());
            if let Some(score) = total(works) {
                let results: serde_json::Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
                prop_assert_eq!(results["score"].as_u64(), Some(score.into()));
                prop_assert_eq!(results["tests"].as_array().unwrap().len(), 2);
            }
        }
    }
}

#[test]
fn the_page_of_a_large_class_is_small() {
    let check = |n: usize| Check { name: format!("check {n}"), asks: "what".into(), points: 1 };
    let lesson =
        |n: usize| Lesson { name: format!("{n:02}-perspective"), checks: (0..10).map(check).collect() };
    let judged = |n: usize| {
        let findings = vec!["12 pixels are missing, the first at (3, 4)".repeat(20)];
        let told = vec![Wrong { input: "an input".into(), findings }];
        let earned = u32::from(n.is_multiple_of(3));
        Judged { earned, cause: None, inputs: 9, wrong: 1 - earned as usize, told, pictures: None }
    };
    let work = |n: usize| {
        let checks = (0..10).map(|check| judged(n + check)).collect();
        Work { text: format!("{n}"), outcome: Outcome::Ran { checks, printed: "debug".repeat(400) } }
    };
    let works = |n: usize| (1..=17).map(|lesson| work(100 * n + lesson)).collect();
    let submissions = (0..150).map(|n| (format!("a student with a long name {n}"), works(n))).collect();
    let class = Class {
        seed: 2,
        lessons: (1..=17).map(lesson).collect(),
        walls: vec![],
        submissions,
        late: BTreeSet::new(),
    };
    let size = super::html::page(&class, None).unwrap().len();
    assert!(size < 400_000, "{size} bytes");
}
