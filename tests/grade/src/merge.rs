//! Several reports made into one.

use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};

use crate::report::{self, Extras};
use crate::results::Class;

/// Puts the reports of several folders together in another one. Returns the class.
pub(crate) fn merge(parts: &[PathBuf], extras: &Extras, into: &Path) -> anyhow::Result<Class> {
    let (first, others) = parts.split_first().context("there is nothing to merge")?;
    let mut class = Class::read(first)?;
    let mut times = report::times(first)?;
    for part in others {
        let other = Class::read(part)?;
        let same = class.seed == other.seed && class.lessons == other.lessons;
        ensure!(
            same,
            "{} was graded with another seed, lessons or weights than {}",
            part.display(),
            first.display()
        );
        for theirs in other.walls {
            match class.walls.iter_mut().find(|wall| wall.against == theirs.against) {
                Some(ours) => ours.held &= theirs.held,
                None => class.walls.push(theirs),
            }
        }
        let mut renamed = std::collections::BTreeMap::new();
        for (name, works) in other.submissions {
            let free = free(&class, &name, |there| *there == works);
            renamed.insert(name, free.clone());
            class.submissions.insert(free, works);
        }
        class.late.extend(other.late.iter().map(|name| renamed.get(name).unwrap_or(name).clone()));
        times.extend(report::times(part)?.into_iter().map(|mut time| {
            time.submission = renamed.get(&time.submission).cloned().unwrap_or(time.submission);
            time
        }));
    }
    let looks = report::write(&class, times, extras, into)?;
    let page = into.join(report::PAGE);
    println!("{looks}{} submissions\n{}", class.submissions.len(), page.display());
    Ok(class)
}

/// A name, with a number if another submission has it already. The same submission twice is one.
fn free(class: &Class, name: &str, same: impl Fn(&Vec<crate::results::Work>) -> bool) -> String {
    let names = (1..).map(|n| if n == 1 { name.to_string() } else { format!("{name} ({n})") });
    let fits = |name: &String| class.submissions.get(name).is_none_or(&same);
    names.into_iter().find(fits).unwrap_or_else(|| name.into())
}
