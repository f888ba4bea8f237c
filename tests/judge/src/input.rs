//! An input as Rust.

use std::process::ExitCode;

use anyhow::Context;
use common::terminal::print;
use tasks::{Raw, SEED, name};

use super::Judge;
use super::compare::value;

impl<F> Judge<F> {
    /// Prints an input as a test that a student may paste.
    pub(crate) fn print_input(&self, number: &str) -> anyhow::Result<ExitCode> {
        let lesson = self.mission.lesson;
        let keys = self.key(SEED);
        let count: usize = keys.iter().map(|key| key.questions.len()).sum();
        let n = number.parse().ok().filter(|n| (1..=count).contains(n));
        let n: usize =
            n.with_context(|| format!("there is no input {number}: they are numbered 1 to {count}"))?;
        let tasks = self.mission.tasks(SEED).into_iter().flatten();
        let questions = keys.iter().flat_map(|key| &key.questions);
        let (task, question) = tasks.zip(questions).nth(n - 1).context("an input")?;
        let names = ["Bounds", "Color", "Format", "IVec2", "Image", "Mat4", "Model", "Vec2", "Vec3", "Vec4"];
        // By itself, not as the end of another name.
        let is_used = |word: &str| {
            let before = |(at, _): (usize, &str)| task.code[..at].chars().next_back();
            task.code.match_indices(word).any(|found| !before(found).is_some_and(char::is_alphanumeric))
        };
        let used =
            names.iter().filter(|name| is_used(&format!("{name}::")) || is_used(&format!("{name} {{")));
        let used = used.copied().collect::<Vec<_>>().join(", ");
        let uses = if used.is_empty() { String::new() } else { format!("    use common::{{{used}}};\n") };
        let code: String = task.code.lines().map(|line| format!("    {line}\n")).collect();
        let shows = match &question.expected {
            Raw::Numbers { values, .. } => {
                let expected = if values.is_empty() { "None".into() } else { value(values) };
                format!("println!(\"got {{got:?}}, expected {expected}\");")
            }
            Raw::List { columns, values } => {
                let expected = values.chunks_exact(*columns).map(value).collect::<Vec<_>>().join(", ");
                format!("println!(\"got {{got:?}}, expected {expected}\");")
            }
            Raw::Picture(_) => {
                // Tests run in the package's folder.
                let lines = [
                    "std::fs::create_dir_all(\"../../../out\").expect(\"a folder can be made\");".to_string(),
                    format!(
                        "got.write(\"../../../out/input-{n}.png\".as_ref()).expect(\"it can be written\");"
                    ),
                    format!("println!(\"see out/input-{n}.png\");"),
                ];
                lines.join("\n    ")
            }
            Raw::Depths { .. } => "let _ = got;".into(),
        };
        print(&format!(
            "// Paste it at the end of lessons/{lesson}/mission/src/lib.rs, and run\n\
             // cargo test -p my-{} --lib -- --nocapture\n\
             #[test]\nfn input_{n}() {{\n{uses}{code}    {shows}\n}}\n",
            name(lesson)
        ))?;
        Ok(ExitCode::SUCCESS)
    }
}
