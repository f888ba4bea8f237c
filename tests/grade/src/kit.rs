//! What a submission to a lesson is built with: a pristine course, compiled, without the lesson itself.
//!
//! Cargo builds the mission as it stands in the course, once. From what it built, two folders are put
//! together. The compiler that reads a student's text is shown `reads`: `common`, the crates of earlier
//! lessons, and what the mission gives; not the tasks, and no source at all. The linker is shown `links`, with the
//! tasks. What is expected is known to the lesson's judge alone, a program that Cargo builds as well: the lesson's own
//! crate is in neither folder, so that a program has no way to it, whatever its text does.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, ensure};
use cargo_metadata::{Artifact, CrateType, Message, Metadata, MetadataCommand, PackageId, TargetKind};

use crate::file;

/// Everything but the student's text.
pub(crate) struct Kit {
    /// As in `01-lines`.
    pub(crate) lesson: String,
    /// The name of the student's crate, as in `my_lines`.
    pub(crate) krate: String,
    /// The mission's `main.rs`.
    pub(crate) main: PathBuf,
    /// What the compiler may read.
    pub(crate) reads: PathBuf,
    /// What the linker may read.
    pub(crate) links: PathBuf,
    /// `--extern`s of the student's crate.
    pub(crate) lib: Vec<String>,
    /// `--extern`s of the program.
    pub(crate) bin: Vec<String>,
    /// How Cargo would have it compiled.
    pub(crate) flags: Vec<String>,
    /// The compiler.
    pub(crate) rustc: PathBuf,
    /// Its folder.
    pub(crate) sysroot: PathBuf,
    /// The program that knows what is expected.
    pub(crate) judge: PathBuf,
    /// Models and textures.
    pub(crate) assets: PathBuf,
    /// Tells this kit, and this program, from others.
    pub(crate) digest: String,
}

/// Builds what the lessons need, below a folder.
pub(crate) fn build(course: &Path, lessons: &[String], folder: &Path) -> anyhow::Result<Vec<Kit>> {
    let metadata = MetadataCommand::new().current_dir(course).other_options(["--locked".into()]).exec();
    let metadata = metadata.with_context(|| format!("{} is not the course", course.display()))?;
    let artifacts = compile(course, lessons)?;
    let said = run(Command::new("rustc").current_dir(course).args(["--print", "sysroot"]))?;
    let toolchain = Toolchain { metadata, artifacts, sysroot: PathBuf::from(said.trim()) };
    lessons.iter().map(|lesson| toolchain.kit(course, lesson, &folder.join(lesson))).collect()
}

/// Has Cargo build the missions and their judges, and returns what it built of each package: its library, or else
/// its program.
fn compile(course: &Path, lessons: &[String]) -> anyhow::Result<BTreeMap<PackageId, Artifact>> {
    let mut cargo = Command::new("cargo");
    cargo.current_dir(course).args([
        "build",
        "--locked",
        "--quiet",
        "--message-format=json-render-diagnostics",
    ]);
    lessons.iter().for_each(|lesson| {
        cargo.args(["--package", &package(lesson), "--package", &tests(lesson)]);
    });
    let mut cargo =
        cargo.stdin(Stdio::null()).stdout(Stdio::piped()).spawn().context("cannot start cargo")?;
    let output = std::io::BufReader::new(cargo.stdout.take().context("cargo has no output")?);
    let mut artifacts = BTreeMap::new();
    for message in Message::parse_stream(output) {
        if let Message::CompilerArtifact(artifact) = message?
            && let Some(kind) = artifact.target.kind.first()
        {
            match kind {
                TargetKind::Lib | TargetKind::ProcMacro => {
                    artifacts.insert(artifact.package_id.clone(), artifact);
                }
                TargetKind::Bin => {
                    artifacts.entry(artifact.package_id.clone()).or_insert(artifact);
                }
                _ => (),
            }
        }
    }
    ensure!(cargo.wait()?.success(), "the course's missions cannot be built");
    Ok(artifacts)
}

struct Toolchain {
    metadata: Metadata,
    artifacts: BTreeMap<PackageId, Artifact>,
    sysroot: PathBuf,
}

impl Toolchain {
    fn kit(&self, course: &Path, lesson: &str, folder: &Path) -> anyhow::Result<Kit> {
        let mission = course.join("lessons").join(lesson).join("mission/src");
        let [reads, links] = ["reads", "links"].map(|name| folder.join(name));
        let of_mission = self.package(&package(lesson))?;
        let direct = self.dependencies(&of_mission);
        let own_tasks = format!("{}_tasks", tasks::name(lesson));
        let given: Vec<_> = direct.iter().filter(|(name, _)| *name != own_tasks).collect();
        let own = self.package(tasks::name(lesson))?;
        for (packages, folder) in [(given.clone(), &reads), (direct.iter().collect(), &links)] {
            let all = self.gather(packages.into_iter().map(|(_, id)| id), folder)?;
            ensure!(!all.contains(&own), "the mission of {lesson} is built with the lesson that it asks for");
        }

        let judge = self.artifacts.get(&self.package(&tests(lesson))?);
        let judge =
            judge.and_then(|artifact| artifact.executable.as_ref()).context("the judge was not built")?;
        let mut kit = Kit {
            lesson: lesson.into(),
            krate: package(lesson).replace('-', "_"),
            main: mission.join("main.rs"),
            lib: self.externs(given, &reads)?,
            bin: self.externs(direct.iter().collect(), &links)?,
            flags: self.flags(&of_mission)?,
            rustc: self.sysroot.join("bin/rustc"),
            sysroot: self.sysroot.clone(),
            judge: judge.into(),
            assets: course.join("assets"),
            digest: String::new(),
            reads,
            links,
        };
        kit.digest = kit.stamp()?;
        Ok(kit)
    }

    fn package(&self, name: &str) -> anyhow::Result<PackageId> {
        let package = self.metadata.workspace_packages().into_iter().find(|package| package.name == name);
        Ok(package.with_context(|| format!("the course has no package {name}"))?.id.clone())
    }

    /// The packages that a package uses when it runs, under the names by which it calls them.
    fn dependencies(&self, package: &PackageId) -> Vec<(String, PackageId)> {
        let nodes = self.metadata.resolve.iter().flat_map(|resolve| &resolve.nodes);
        let dependencies = nodes.filter(|node| node.id == *package).flat_map(|node| &node.deps);
        let normal = |dependency: &&cargo_metadata::NodeDep| {
            dependency.dep_kinds.iter().any(|kind| kind.kind == cargo_metadata::DependencyKind::Normal)
        };
        dependencies
            .filter(normal)
            .map(|dependency| (dependency.name.clone(), dependency.pkg.clone()))
            .collect()
    }

    /// Puts these packages, and all that they use, into a folder. Returns all of them.
    fn gather<'a>(
        &self,
        packages: impl Iterator<Item = &'a PackageId>,
        folder: &Path,
    ) -> anyhow::Result<BTreeSet<PackageId>> {
        std::fs::create_dir_all(folder)?;
        let mut open: Vec<PackageId> = packages.cloned().collect();
        let mut seen = BTreeSet::new();
        while let Some(package) = open.pop() {
            if seen.insert(package.clone()) {
                open.extend(self.dependencies(&package).into_iter().map(|(_, id)| id));
                // What is for another system was not built.
                if let Some(artifact) = self.artifacts.get(&package) {
                    libraries(artifact).try_for_each(|library| link(library, folder))?;
                }
            }
        }
        Ok(seen)
    }

    fn externs(&self, packages: Vec<&(String, PackageId)>, folder: &Path) -> anyhow::Result<Vec<String>> {
        let named = |(name, id): &(String, PackageId)| {
            let artifact = self.artifacts.get(id).with_context(|| format!("{name} was not built"))?;
            let library = libraries(artifact).next().with_context(|| format!("{name} is not a library"))?;
            let file = library.file_name().context("a library has a name")?;
            Ok(format!("{name}={}", folder.join(file).display()))
        };
        packages.into_iter().map(named).collect()
    }

    fn flags(&self, mission: &PackageId) -> anyhow::Result<Vec<String>> {
        let artifact = self.artifacts.get(mission).context("the mission was not built")?;
        let profile = &artifact.profile;
        Ok(vec![
            format!("--edition={}", artifact.target.edition.as_str()),
            format!("-Copt-level={}", profile.opt_level),
            format!("-Cdebug-assertions={}", profile.debug_assertions),
            format!("-Coverflow-checks={}", profile.overflow_checks),
        ])
    }
}

impl Kit {
    /// A digest of names, sizes and times of change: all that is in the kit was built, and Cargo builds again
    /// what has changed.
    fn stamp(&self) -> anyhow::Result<String> {
        let grader = std::env::current_exe().context("cannot find the grader itself")?;
        let mut files = vec![grader, self.main.clone(), self.judge.clone(), self.rustc.clone()];
        for entry in std::fs::read_dir(&self.links)? {
            files.push(entry?.path());
        }
        files.sort();
        let mut digest = self.flags.join(" ");
        for path in &files {
            let found = std::fs::metadata(path).with_context(|| format!("cannot read {}", path.display()))?;
            let (name, size, changed) = (path.file_name(), found.len(), found.modified()?);
            digest += &format!("\n{name:?} {size} {changed:?}");
        }
        Ok(file::digest([digest.as_bytes()]))
    }
}

/// `-L`'s argument for a folder of crates that other crates use: none of them can be named from there.
pub(crate) fn dependencies(folder: &Path) -> String {
    format!("dependency={}", folder.display())
}

/// The package of a lesson's mission.
pub(crate) fn package(lesson: &str) -> String {
    format!("my-{}", tasks::name(lesson))
}

/// The package of its tests, which has its judge.
pub(crate) fn tests(lesson: &str) -> String {
    format!("{}-tests", tasks::name(lesson))
}

/// What of a package others are compiled against.
fn libraries(artifact: &Artifact) -> impl Iterator<Item = &Path> {
    let macros = artifact.target.crate_types.contains(&CrateType::ProcMacro);
    let ending = if macros { "so" } else { "rlib" };
    artifact
        .filenames
        .iter()
        .map(|path| path.as_std_path())
        .filter(move |path| path.extension().is_some_and(|e| e == ending))
}

/// Puts a file into a folder, as a second name of the same one where that can be.
fn link(file: &Path, folder: &Path) -> anyhow::Result<()> {
    let copy = folder.join(file.file_name().context("a file has a name")?);
    if std::fs::hard_link(file, &copy).is_err() {
        std::fs::copy(file, &copy).with_context(|| format!("cannot copy {}", file.display()))?;
    }
    Ok(())
}

/// Runs a program of ours to its end, and returns what it printed.
pub(crate) fn run(command: &mut Command) -> anyhow::Result<String> {
    let output =
        command.output().with_context(|| format!("cannot start {}", command.get_program().display()))?;
    ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr).trim());
    String::from_utf8(output.stdout).context("what it printed is not UTF-8")
}

/// Those of all lessons that a list such as `1-3,7` names by number.
pub(crate) fn lessons(list: &str, all: &[String]) -> Result<Vec<String>, String> {
    let numbered = |lesson: &String| lesson.split_once('-').and_then(|(number, _)| number.parse().ok());
    let numbers: BTreeMap<usize, &String> =
        all.iter().filter_map(|lesson| Some((numbered(lesson)?, lesson))).collect();
    let last = numbers.last_key_value().map_or(0, |(number, _)| *number);
    let number = |text: &str| match text.trim().parse::<usize>() {
        Ok(number) if numbers.contains_key(&number) => Ok(number),
        _ => Err(format!("`{text}` is not a lesson's number, 1 to {last}")),
    };
    let mut chosen = BTreeSet::new();
    for part in list.split(',') {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        chosen.extend(number(first)?..=number(last)?);
    }
    if chosen.is_empty() {
        return Err("it names no lesson".into());
    }
    Ok(chosen.iter().filter_map(|number| numbers.get(number).copied().cloned()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_lessons() {
        let all = ["01-a", "02-b-c", "03-d", "10-e"].map(String::from);
        assert_eq!(lessons("3,1-2,2", &all).unwrap(), ["01-a", "02-b-c", "03-d"]);
        assert_eq!(lessons("10", &all).unwrap(), ["10-e"]);
        for wrong in ["", "0", "11", "1-", "a", "3-2", "1,,2"] {
            assert!(lessons(wrong, &all).is_err(), "{wrong}");
        }
    }
}
