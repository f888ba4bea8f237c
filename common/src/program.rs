//! A lesson's program: what all of them have in common.
//!
//! A lesson's `main.rs` says in a [`Program`] what it loads and how it draws, and calls [`run`]. The flags that
//! all lessons have are here, in [`Shared`]; a lesson brings its own as a `clap::Args`. Those that several
//! lessons take are small ones, put together by `#[command(flatten)]`: see [`flags`] and [`model`].

pub mod flags;
pub mod model;
mod output;
mod texture;
pub mod values;

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::Context;
use clap::builder::PossibleValuesParser;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{ArgAction, ArgMatches, Args, Command, FromArgMatches};

use crate::printable::shown;
use crate::terminal::{eprintln, print};
use crate::{Image, Lesson, Method};

pub use output::Output;
use output::is_same;

/// What a lesson's program loads once, and draws as often as it is asked: by one method or by two, once or
/// many times, into a file or a window.
pub trait Program: Sized {
    /// Its own flags.
    type Flags: Args;
    /// What its table of methods holds.
    type Method: 'static;

    /// The lesson.
    const LESSON: Lesson;
    /// The table of methods.
    const METHODS: &'static [Method<Self::Method>];
    /// The method that draws when none is named.
    const DEFAULT: &'static str;

    /// Reads what is to be drawn, and computes what is the same in every picture.
    ///
    /// # Errors
    /// Where a file cannot be read, or the flags do not go together ([`UsageError`]).
    fn load(flags: Self::Flags) -> anyhow::Result<Self>;

    /// Width and height of a picture in pixels, where none are asked for.
    fn size(&self) -> (u16, u16) {
        (800, 800)
    }

    /// Draws into a black picture of any size. No file is touched.
    ///
    /// # Errors
    /// Where there is nothing to be seen that way ([`UsageError`]).
    fn draw(&mut self, method: &Self::Method, picture: &mut Image) -> anyhow::Result<Extras>;

    /// Draws what the flags ask for: one picture, unless a lesson has flags that ask for more.
    ///
    /// # Errors
    /// As [`Output::one`].
    fn show(&mut self, method: &Self::Method, output: &Output) -> anyhow::Result<()> {
        output.one(self, method)
    }
}

/// What there is of a drawing besides the picture.
#[derive(Default)]
pub struct Extras {
    /// The depths in grey, and the file that they go to, where a flag asks for them.
    pub depth: Option<(PathBuf, Image)>,
    /// How many triangles are not in the picture since they reach behind the eye.
    pub left_out: usize,
}

/// What is wrong with a command line, where only the lesson can tell.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct UsageError(pub String);

/// What a flag names in a further table of a lesson.
///
/// # Errors
/// Where the table has no row of that name.
pub fn named<'a, F>(table: &'a [Method<F>], flag: &str, name: &str) -> Result<&'a F, UsageError> {
    let names = || table.iter().map(|row| row.name).collect::<Vec<_>>().join(", ");
    let unknown = || UsageError(format!("--{flag} {name}: there are {}", names()));
    Method::find(table, name).map(|row| &row.run).ok_or_else(unknown)
}

/// The flags that every lesson's program has.
#[derive(Clone, Debug, Args)]
pub struct Shared {
    /// The picture to write, .tga or .png by its ending [default: both, in out/]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,

    /// Width and height of the picture in pixels, up to 16384 each and 8192x8192 in all
    #[arg(long, value_name = "WxH", value_parser = values::size)]
    pub size: Option<(u16, u16)>,

    /// The method that draws; --list says what each promises
    #[arg(long, value_name = "NAME")]
    pub method: String,

    /// Print the table of methods and draw nothing
    #[arg(long)]
    pub list: bool,

    /// Draw by A, by B, and where B differs: A | B | difference; the counts are printed
    #[arg(long, value_name = "A,B")]
    pub compare: Vec<String>,

    /// Do not show the picture in the terminal
    #[arg(long)]
    pub quiet: bool,
}

/// Runs a lesson's program with the arguments of this process. What goes wrong is told in one line on
/// standard error, with exit code 1, or 2 where the command line is at fault.
#[must_use]
pub fn run<P: Program>() -> ExitCode {
    match parse::<P>(std::env::args_os()) {
        Ok((shared, flags)) => finish(execute::<P>(shared, flags)),
        Err(error) if error.use_stderr() => {
            eprintln(one_line(&error));
            ExitCode::from(2)
        }
        Err(help) => finish(print(&help.render().to_string())),
    }
}

fn finish(result: anyhow::Result<()>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln(format_args!("error: {error:#}"));
            ExitCode::from(if error.is::<UsageError>() { 2 } else { 1 })
        }
    }
}

fn parse<P: Program>(
    arguments: impl IntoIterator<Item = OsString>,
) -> Result<(Shared, P::Flags), clap::Error> {
    let names = P::METHODS.iter().map(|method| method.name).collect();
    let command = P::Flags::augment_args(Shared::augment_args(Command::new(P::LESSON.name)));
    let (shared, matches) =
        parse_shared(command, &P::LESSON, names, P::DEFAULT, arguments.into_iter().collect())?;
    Ok((shared, P::Flags::from_arg_matches(&matches)?))
}

/// What all lessons share, and what clap found beside it. (Apart from [`parse`], so that it is compiled once.)
fn parse_shared(
    command: Command,
    lesson: &Lesson,
    methods: Vec<&'static str>,
    default: &'static str,
    arguments: Vec<OsString>,
) -> Result<(Shared, ArgMatches), clap::Error> {
    let names = PossibleValuesParser::new(methods);
    let mut command = command
        .about(format!("Lesson {}: {}.", lesson.number, lesson.job))
        .mut_arg("method", |arg| {
            arg.required(false).default_value(default).value_parser(names.clone()).hide_possible_values(true)
        })
        .mut_arg("compare", |arg| {
            arg.value_parser(names).value_delimiter(',').action(ArgAction::Append).hide_possible_values(true)
        });
    let matches = command.try_get_matches_from_mut(arguments)?;
    let shared = Shared::from_arg_matches(&matches)?;
    if !matches!(shared.compare.len(), 0 | 2) {
        let message = "'--compare <A,B>' takes two methods, as in --compare A,B\n";
        return Err(command.error(ErrorKind::WrongNumberOfValues, message));
    }
    if let Some(out) = &shared.out
        && let Some(flag) = other_flag_for(out, &matches)
    {
        let message = format!("'--out {}': --{flag} names that file: name another one\n", shown(out));
        return Err(command.error(ErrorKind::ArgumentConflict, message));
    }
    Ok((shared, matches))
}

/// Another flag than `--out` that names the file, which may be a texture that would be lost.
fn other_flag_for<'a>(out: &Path, matches: &'a ArgMatches) -> Option<&'a str> {
    let others = matches.ids().map(clap::Id::as_str).filter(|&id| id != "out");
    let names = |id: &&str| {
        matches.try_get_one::<PathBuf>(id).is_ok_and(|path| path.is_some_and(|path| is_same(path, out)))
    };
    others.into_iter().find(names)
}

/// clap's message without its usage block, on one line. A flag that clap does not know may be another
/// lesson's: there are such flags, only not here.
fn one_line(error: &clap::Error) -> String {
    let mut message = error.render().to_string();
    if error.kind() == ErrorKind::UnknownArgument
        && let Some(ContextValue::String(flag)) = error.get(ContextKind::InvalidArg)
        && flag.starts_with('-')
    {
        let [said, says] = ["' found", "': this lesson has no such flag"].map(|end| format!("'{flag}{end}"));
        message = message.replacen(&said, &says, 1);
    }
    let lines = message.lines().map(str::trim);
    lines.filter(|line| !line.is_empty() && !line.starts_with("Usage:")).collect::<Vec<_>>().join("; ")
}

fn execute<P: Program>(shared: Shared, flags: P::Flags) -> anyhow::Result<()> {
    if shared.list {
        return print(&Method::list(P::METHODS));
    }
    let mut program = P::load(flags)?;
    let method = |name: &str| {
        let method =
            Method::find(P::METHODS, name).with_context(|| format!("there is no method `{name}`"))?;
        anyhow::Ok(&method.run)
    };
    let drawing = method(&shared.method)?;
    let compared = shared.compare.iter().map(|name| method(name)).collect::<anyhow::Result<Vec<_>>>()?;
    let output = Output::new(shared, P::LESSON.folder());
    match compared.as_slice() {
        &[a, b] => output.two(&mut program, a, b),
        _ => program.show(drawing, &output),
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use glam::Vec3;

    use super::*;
    use crate::program::flags::LightFlag;
    use crate::{Color, Table};

    /// One pixel in a row of four, a step further in each picture of a series.
    struct Pixel {
        x: i32,
        count: Option<u16>,
    }

    #[derive(clap::Args)]
    struct Flags {
        #[command(flatten)]
        light: LightFlag,

        #[arg(long, value_parser = values::numbers::<i32, 2>, allow_hyphen_values = true)]
        pair: Vec<[i32; 2]>,

        #[arg(long)]
        count: Option<u16>,
    }

    thread_local! {
        static LOADED: Cell<usize> = const { Cell::new(0) };
    }

    impl Program for Pixel {
        type Flags = Flags;
        type Method = Color;

        const LESSON: Lesson = Lesson {
            number: 99,
            name: "pixel",
            title: "A pixel",
            job: "one pixel",
            tables: &[Table { name: "", job: "Set a pixel", rows: || Method::rows(Pixel::METHODS) }],
        };
        const METHODS: &[Method<Color>] = &[
            Method { name: "red", run: Color::RED, promise: "red", failure: "-" },
            Method { name: "green", run: Color::GREEN, promise: "green", failure: "-" },
        ];
        const DEFAULT: &str = "green";

        fn load(flags: Flags) -> anyhow::Result<Self> {
            LOADED.set(LOADED.get() + 1);
            Ok(Self { x: 0, count: flags.count })
        }

        fn size(&self) -> (u16, u16) {
            (4, 1)
        }

        fn draw(&mut self, &color: &Color, picture: &mut Image) -> anyhow::Result<Extras> {
            assert!(picture.buffer().iter().all(|&byte| byte == 0), "the picture is black at first");
            picture.set(self.x, 0, color);
            Ok(Extras::default())
        }

        fn show(&mut self, method: &Color, output: &Output) -> anyhow::Result<()> {
            let Some(count) = self.count else { return output.one(self, method) };
            output.series(self, method, count, |pixel, n| pixel.x = n.into())
        }
    }

    fn parsed(arguments: &[&str]) -> Result<(Shared, Flags), String> {
        let arguments = std::iter::once("test").chain(arguments.iter().copied()).map(Into::into);
        parse::<Pixel>(arguments).map_err(|error| one_line(&error))
    }

    #[test]
    fn defaults_are_the_lessons() {
        let (shared, own) = parsed(&[]).unwrap();
        assert_eq!((shared.method.as_str(), own.light.direction), ("green", Vec3::Z));
        let size = |shared| Output::new(shared, String::new()).canvas(&Pixel { x: 0, count: None }).size();
        assert_eq!(size(shared).to_array(), [4.0, 1.0]);
        assert_eq!(size(parsed(&["--size", "7x5"]).unwrap().0).to_array(), [7.0, 5.0]);
    }

    #[test]
    fn help_says_which_lesson_it_is_and_what_the_method_is() {
        let Err(help) = parsed(&["--help"]) else { panic!("this is no drawing") };
        assert!(help.starts_with("Lesson 99: one pixel.; "), "{help}");
        assert!(help.contains("--list says what each promises [default: green]"), "{help}");
        assert!(help.contains("Direction from the surface to the light"), "{help}");
    }

    #[test]
    fn values_may_begin_with_a_minus_and_flags_be_repeated() {
        let own = parsed(&["--pair", "-1,2", "--pair", "3,-4", "--light", "-1,0,0"]).unwrap().1;
        assert_eq!((own.pair, own.light.direction), (vec![[-1, 2], [3, -4]], Vec3::NEG_X));
    }

    #[test]
    fn what_is_wrong_is_said_in_one_line() {
        for (arguments, said) in [
            (&["--size", "0x5"][..], "'--size <WxH>': write two numbers from 1 to 16384"),
            (
                &["--method", "blue"],
                "invalid value 'blue' for '--method <NAME>'; [possible values: red, green]",
            ),
            (&["--compare", "red"], "takes two methods"),
            (&["--compare", "red,green,red"], "takes two methods"),
            (&["--compare", "red,blue"], "[possible values: red, green]"),
            (&["--pair", "1,2,3"], "'--pair <PAIR>': write 2 numbers"),
            (&["--light", "0,0,0"], "not all 0"),
            (&["--fill", "flat"], "error: unexpected argument '--fill': this lesson has no such flag"),
            (&["--fill=flat"], "error: unexpected argument '--fill': this lesson has no such flag"),
            (&["--nonsense"], "unexpected argument '--nonsense'"),
            (&["--sise", "1x1"], "tip: a similar argument exists: '--size'"),
            (&["word"], "error: unexpected argument 'word' found"),
        ] {
            let Err(error) = parsed(arguments) else { panic!("{arguments:?}") };
            assert!(error.contains(said) && !error.contains('\n'), "{arguments:?}: {error}");
            assert!(!error.contains("Usage:") && !error.contains("; ;"), "{arguments:?}: {error}");
        }
    }

    /// Runs the program in a folder of its own, and reads the pictures that are there then.
    fn pictures(arguments: &[&str]) -> Vec<(String, Image)> {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("a.png");
        LOADED.set(0);
        let (shared, flags) = parsed(&[arguments, &["--out", out.to_str().unwrap()]].concat()).unwrap();
        execute::<Pixel>(shared, flags).unwrap();
        let mut files: Vec<_> =
            std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.sort();
        let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
        files.iter().map(|path| (name(path), Image::read(path).unwrap())).collect()
    }

    #[test]
    fn a_program_loads_once_however_often_it_draws() {
        let series = pictures(&["--count", "3"]);
        let names: Vec<&str> = series.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!((names, LOADED.get()), (vec!["a-000.png", "a-001.png", "a-002.png"], 1));
        for (n, (_, picture)) in series.iter().enumerate() {
            let lit: Vec<i32> = (0..4).filter(|&x| picture.get(x, 0) == Some(Color::GREEN)).collect();
            assert_eq!(lit, [n as i32]);
        }

        assert_eq!((pictures(&["--compare", "red,green"]).len(), LOADED.get()), (1, 1));
        assert_eq!((pictures(&["--list"]).len(), LOADED.get()), (0, 0));
    }
}
