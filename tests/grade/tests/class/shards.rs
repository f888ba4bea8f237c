//! The templates for a large class: the shards run as they stand there, each a process of its own, and merged they are the
//! report of the whole class.

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::Command;

use saphyr::{LoadableYamlNode, Yaml};

use crate::{COURSE, LOOK, grade, ran, reports, said, small_class};

/// How many shards the tests make, whatever a template has.
const SHARDS: usize = 2;

fn template(name: &str) -> String {
    fs::read_to_string(Path::new(COURSE).join("tests/ci-templates").join(name)).unwrap()
}

/// What is at these keys of a YAML document.
fn at<'a, 'b>(yaml: &'a Yaml<'b>, keys: &[&str]) -> &'a Yaml<'b> {
    keys.iter().fold(yaml, |yaml, key| match key.parse::<usize>() {
        Ok(number) => &yaml[number],
        Err(_) => &yaml[*key],
    })
}

fn text(yaml: &Yaml, keys: &[&str]) -> String {
    at(yaml, keys).as_str().unwrap_or_else(|| panic!("no text at {keys:?}")).to_string()
}

/// The command of a job that has the grader among its steps.
fn step(yaml: &Yaml, job: &str) -> String {
    let steps = at(yaml, &["jobs", job, "steps"]).as_sequence().unwrap();
    let runs = steps.iter().filter_map(|step| step.as_mapping_get("run")?.as_str());
    runs.into_iter().find(|run| run.contains("-p grade")).unwrap().to_string()
}

fn lines(yaml: &Yaml, job: &str) -> String {
    let script = at(yaml, &[job, "script"]).as_sequence().unwrap();
    script.iter().map(|line| format!("{}\n", line.as_str().unwrap())).collect()
}

/// A place with the class, a folder for the course, and programs that run the grader under test.
struct Place {
    folder: PathBuf,
}

impl Place {
    fn new(folder: PathBuf, class: &Path) -> Self {
        fs::create_dir_all(folder.join("course")).unwrap();
        fs::create_dir_all(folder.join("bin")).unwrap();
        symlink(class, folder.join("class")).unwrap();
        // `cargo run --release -p grade -- …`
        let cargo = "#!/bin/sh\n[ \"$1 $2 $3 $4 $5\" = 'run --release -p grade --' ] || exit 9\nshift 5\n";
        let real = std::env::var("PATH").unwrap();
        let grade = format!("PATH='{real}' exec '{}' \"$@\"\n", env!("CARGO_BIN_EXE_grade"));
        for (name, script) in [("cargo", format!("{cargo}{grade}")), ("grade", format!("#!/bin/sh\n{grade}"))]
        {
            let path = folder.join("bin").join(name);
            fs::write(&path, script).unwrap();
            fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
        }
        Self { folder }
    }

    /// Runs a script that ends with one of these codes.
    fn run(&self, within: &str, script: &str, variables: &[(&str, String)], codes: &[i32]) {
        let path = format!("{}:{}", self.folder.join("bin").display(), std::env::var("PATH").unwrap());
        let mut bash = Command::new("bash");
        bash.args(["-e", "-o", "pipefail", "-c", script]).current_dir(self.folder.join(within));
        let output = bash.env("PATH", path).envs(variables.iter().cloned()).output().unwrap();
        assert!(
            output.status.code().is_some_and(|code| codes.contains(&code)),
            "{script}\n{}",
            said(&output)
        );
    }

    fn path(&self, name: &str) -> String {
        self.folder.join(name).to_str().unwrap().into()
    }
}

/// Variables that all templates take: a seed as the whole class has, and one lesson.
fn chosen() -> Vec<(&'static str, String)> {
    vec![("SEED", "2".into()), ("LESSONS", "1".into())]
}

fn with(more: &[(&'static str, String)]) -> Vec<(&'static str, String)> {
    [chosen(), more.to_vec()].concat()
}

#[test]
#[ignore = "a minute; for the course's own CI"]
fn each_template_makes_the_report_of_the_whole_class() {
    let folder = small_class();
    // Something to look at: that ends no shard.
    fs::create_dir_all(folder.path().join("class/zoe")).unwrap();
    fs::write(folder.path().join("class/zoe/notes.txt"), "I could not do it").unwrap();
    let whole = folder.path().join("whole");
    let output = grade(&folder.path().join("class"), &whole, &[]);
    if !ran(&output, &whole) {
        return;
    }
    assert_eq!(output.status.code(), Some(LOOK));
    let expected = reports(&whole);
    let place = |name: &str| Place::new(folder.path().join(name), &folder.path().join("class"));
    let same = |place: &Place, report: &str| {
        assert!(reports(&place.folder.join(report)) == expected, "{}", place.folder.display());
    };

    let slurm = place("slurm");
    let reports = [("CLASS", slurm.path("class")), ("REPORTS", slurm.path("reports"))];
    for task in 1..=SHARDS {
        let array =
            [("SLURM_ARRAY_TASK_ID", task.to_string()), ("SLURM_ARRAY_TASK_COUNT", SHARDS.to_string())];
        slurm.run("course", &template("slurm-class.sbatch"), &with(&[&reports[..], &array].concat()), &[0]);
    }
    slurm.run("course", &template("slurm-merge.sbatch"), &with(&reports), &[0]);
    same(&slurm, "reports/all");

    let kubernetes = place("kubernetes");
    let [class, merge] = ["class", "merge"].map(|job| template(&format!("kubernetes-{job}.yml")));
    let [class, merge] = [&class, &merge].map(|text| Yaml::load_from_str(text).unwrap().remove(0));
    let container = ["spec", "template", "spec", "containers", "0"];
    let variables = at(&class, &[&container[..], &["env"]].concat());
    let shards = variables.as_sequence().unwrap().iter().find(|own| own["name"].as_str() == Some("SHARDS"));
    let completions = at(&class, &["spec", "completions"]).as_integer().unwrap();
    assert_eq!(shards.unwrap()["value"].as_str(), Some(&*completions.to_string()));
    let command = |job| {
        text(job, &[&container[..], &["args", "0"]].concat()).replace("/grading/", &kubernetes.path(""))
    };
    for pod in 0..SHARDS {
        let index = [("JOB_COMPLETION_INDEX", pod.to_string()), ("SHARDS", SHARDS.to_string())];
        kubernetes.run("", &command(&class), &with(&index), &[0]);
    }
    kubernetes.run("", &command(&merge), &[], &[0]);
    same(&kubernetes, "reports/all");

    // Each job has a machine of its own; what it uploads is downloaded beside that of the others.
    let github = template("github-class.yml");
    let github = Yaml::load_from_str(&github).unwrap().remove(0);
    let last = place("github");
    fs::create_dir_all(last.folder.join("shards")).unwrap();
    for shard in 1..=SHARDS {
        let runner = place(&format!("github-{shard}"));
        let command = step(&github, "shard")
            .replace("${{ matrix.shard }}", &shard.to_string())
            .replace("${{ strategy.job-total }}", &SHARDS.to_string());
        runner.run("course", &command, &chosen(), &[0]);
        fs::remove_dir_all(runner.folder.join("report/work")).unwrap();
        fs::rename(runner.folder.join("report"), last.folder.join(format!("shards/shard-{shard}"))).unwrap();
    }
    // A forge shows by a red run that there is something to look at.
    last.run("course", &step(&github, "merge"), &[], &[LOOK]);
    same(&last, "report");

    let gitlab = template("gitlab-class.yml");
    let gitlab = Yaml::load_from_str(&gitlab).unwrap().remove(0);
    let project = place("gitlab");
    for node in 1..=SHARDS {
        let parallel = [("CI_NODE_INDEX", node.to_string()), ("CI_NODE_TOTAL", SHARDS.to_string())];
        project.run("", &lines(&gitlab, "shard"), &with(&parallel), &[0]);
    }
    project.run("", &lines(&gitlab, "merge"), &[], &[LOOK]);
    same(&project, "report");
}
