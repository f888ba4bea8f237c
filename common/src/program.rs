//! A lesson's program: the command line that all lessons share, and what it does with the picture.
//!
//! A lesson's `main.rs` fills in a [`Lesson`] and calls [`run`]. Every flag of the course is defined once,
//! in [`Flags`]; a lesson names those that are its own, and the others are unknown to it.

use std::cell::OnceCell;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::rc::Rc;

use anyhow::{Context, ensure};
use clap::{ArgAction, CommandFactory, FromArgMatches, builder::PossibleValuesParser};
use glam::{DVec3, IVec2, Vec2, Vec3};

use crate::compare::{Difference, side_by_side};
use crate::{Attributes, Color, Error, Format, Image, Method, Model, file, preview};

/// The model that lessons draw unless told otherwise.
pub const DEFAULT_MODEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/head.obj");

/// The texture of the head.
pub const DEFAULT_TEXTURE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/head.tga");

/// The flags that every lesson has; the rest of [`Flags`] are those of some.
const SHARED: [&str; 6] = ["out", "size", "method", "list", "compare", "quiet"];

/// What makes a lesson's program.
pub struct Lesson<F: 'static> {
    /// Number and name, as in `01-lines`.
    pub name: &'static str,
    /// One line for `--help`.
    pub about: &'static str,
    /// The table of methods.
    pub methods: &'static [Method<F>],
    /// The method that draws when none is named.
    pub default: &'static str,
    /// The names of its own flags, as fields of [`Flags`].
    pub flags: &'static [&'static str],
    /// Draws the picture that the flags ask for, by one method.
    pub draw: fn(&Flags, &F) -> anyhow::Result<Drawing>,
    /// What `--turntable` does, in lessons that have it: draws as often as needed, with other flags each time.
    pub turntable: Option<Turntable>,
}

/// Draws several pictures of a lesson of that name.
pub type Turntable = fn(&Flags, &str, &dyn Fn(&Flags) -> anyhow::Result<Drawing>) -> anyhow::Result<()>;

/// What a lesson has drawn.
pub struct Drawing {
    /// The picture.
    pub picture: Image,
    /// The depth buffer in grey, where `--depth` asks for it.
    pub depth: Option<Image>,
}

impl From<Image> for Drawing {
    fn from(picture: Image) -> Self {
        Self { picture, depth: None }
    }
}

/// A straight line, as `--line` gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineFlag {
    /// The two ends, in whole pixels.
    pub ends: [IVec2; 2],
    /// Its colour.
    pub color: Color,
}

/// A triangle, as `--triangle` gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleFlag {
    /// The three corners, in pixels.
    pub corners: [Vec2; 3],
    /// Its colour.
    pub color: Color,
}

/// How a model's triangles are coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Fill {
    /// Each triangle in a colour of its own, the same ones in every run.
    Random,
    /// Each triangle as bright as it faces the light.
    Flat,
}

/// What is wrong with a command line, where only the lesson can tell.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct UsageError(pub String);

/// The flags of all lessons.
#[derive(Clone, Debug, clap::Parser)]
#[command(disable_version_flag = true)]
pub struct Flags {
    /// The picture to write, .tga or .png by its ending [default: both, in out/]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,

    /// Width and height of the picture in pixels, up to 16384 each and 8192x8192 in all
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
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

    /// A line instead of the lesson's two, in whole pixels; may be repeated
    #[arg(long, value_name = "x0,y0,x1,y1[,rrggbb]", value_parser = parse_line, allow_hyphen_values = true)]
    pub line: Vec<LineFlag>,

    /// The model to draw, an OBJ file; without FILE the course's own
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = DEFAULT_MODEL)]
    pub model: Option<PathBuf>,

    /// A triangle instead of the lesson's three, in pixels; may be repeated
    #[arg(long, value_name = "x0,y0,x1,y1,x2,y2[,rrggbb]", value_parser = parse_triangle, allow_hyphen_values = true)]
    pub triangle: Vec<TriangleFlag>,

    /// How the model's triangles are coloured
    #[arg(long, value_enum, default_value_t = Fill::Flat)]
    pub fill: Fill,

    /// Direction from the surface to the light, of any length but 0
    #[arg(long, value_name = "x,y,z", default_value = "0,0,1", value_parser = parse_direction, allow_hyphen_values = true)]
    pub light: Vec3,

    /// Also write the depth buffer as a grey picture: the nearest is white, where nothing is stays black
    #[arg(long, value_name = "FILE", conflicts_with_all = ["compare", "turntable"])]
    pub depth: Option<PathBuf>,

    /// The model's texture, .tga or .png [default: the head's]
    #[arg(long, value_name = "FILE")]
    pub texture: Option<PathBuf>,

    /// Distance of the eye from the origin, along z; inf is the parallel projection
    #[arg(long, value_name = "D", default_value = "2", value_parser = parse_distance, allow_hyphen_values = true)]
    pub distance: f32,

    /// Where the eye is
    #[arg(long, value_name = "x,y,z", default_value = "1,1,2", value_parser = parse_point, allow_hyphen_values = true)]
    pub eye: Vec3,

    /// The point it looks at, which becomes the middle of the picture
    #[arg(long, value_name = "x,y,z", default_value = "0,0,0", value_parser = parse_point, allow_hyphen_values = true)]
    pub center: Vec3,

    /// The direction that is up in the picture
    #[arg(long, value_name = "x,y,z", default_value = "0,1,0", value_parser = parse_point, allow_hyphen_values = true)]
    pub up: Vec3,

    /// One shader alone instead of the sheet of four
    #[arg(long, value_name = "NAME")]
    pub shader: Option<String>,

    /// Steps of brightness of the quantized shader
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u16).range(1..))]
    pub levels: u16,

    /// Draw this many pictures on a circle around the model, NAME-000 and so on
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=999), conflicts_with = "compare")]
    pub turntable: Option<u16>,

    /// The model once it was read: methods that are compared and the pictures of a turntable share it.
    #[arg(skip)]
    pub loaded: Rc<OnceCell<(Attributes, Rc<Model>)>>,
}

impl Flags {
    /// A black picture of the size asked for, or else of this one.
    #[must_use]
    pub fn canvas(&self, width: u16, height: u16) -> Image {
        let (width, height) = self.size.unwrap_or((width, height));
        Image::new(width, height, Format::Rgb)
    }

    /// Reads the model asked for, or else the course's own, and tells on standard error what was left out,
    /// or that it has no normals where the lesson wants some. Asked for again, it is neither read nor told
    /// again.
    ///
    /// # Errors
    /// As [`Model::read`]; and if the lesson wants texture coordinates and the model has none.
    pub fn read_model(&self, wanted: Attributes) -> anyhow::Result<Rc<Model>> {
        if let Some((had, model)) = self.loaded.get()
            && *had == wanted
        {
            return Ok(Rc::clone(model));
        }
        let path = self.model.as_deref().unwrap_or(Path::new(DEFAULT_MODEL));
        let model = Model::read(path, wanted)?;
        ensure!(
            !wanted.uvs || model.face_uvs().len() > 0,
            "{}: not every face has texture coordinates; export the model with them, or draw it without a texture",
            path.display()
        );
        ensure!(
            model.faces().len() > 0 || wanted == Attributes::default(),
            "{}: there are lines and no faces in it; lesson 2 draws lines: cargo run -p wireframe -- --model {0}",
            path.display()
        );
        if let Some(skipped) = model.skipped() {
            let (count, of, first) = (skipped.count, skipped.of, &skipped.first);
            tell(format_args!("{}: left out {count} of {of} faces; the first, {first}", path.display()));
        }
        for remark in model.remarks() {
            tell(format_args!("{}: {remark}", path.display()));
        }
        if wanted.normals && model.face_normals().len() == 0 {
            tell(format_args!("{}: not every face has normals; they are computed", path.display()));
        }
        let model = Rc::new(model);
        // A lesson that asks for other attributes the second time reads again; none does.
        let _ = self.loaded.set((wanted, Rc::clone(&model)));
        Ok(model)
    }

    /// Reads the texture asked for, or else the head's.
    ///
    /// # Errors
    /// As [`Image::read`].
    pub fn read_texture(&self) -> Result<Image, Error> {
        Image::read(self.texture.as_deref().unwrap_or(Path::new(DEFAULT_TEXTURE)))
    }
}

/// Runs a lesson's program with the arguments of this process. What goes wrong is told in one line on
/// standard error, with exit code 1, or 2 where the command line is at fault.
#[must_use]
pub fn run<F>(lesson: &Lesson<F>) -> ExitCode {
    let flags = match parse(lesson, std::env::args_os()) {
        Ok(flags) => flags,
        Err(error) if error.use_stderr() => {
            tell(one_line(&error));
            return ExitCode::from(2);
        }
        Err(help) => return finish(print(&help.render().to_string())),
    };
    finish(execute(lesson, &flags))
}

fn finish(result: anyhow::Result<()>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            tell(format_args!("error: {error:#}"));
            ExitCode::from(if error.is::<UsageError>() { 2 } else { 1 })
        }
    }
}

/// The flags of a lesson: clap's definition of [`Flags`] with this lesson's methods, less other lessons' flags.
fn parse<F>(
    lesson: &Lesson<F>,
    arguments: impl IntoIterator<Item = std::ffi::OsString>,
) -> Result<Flags, clap::Error> {
    let names = || PossibleValuesParser::new(lesson.methods.iter().map(|method| method.name));
    let mut command = Flags::command()
        .about(lesson.about)
        .mut_arg("method", |arg| {
            arg.required(false).default_value(lesson.default).value_parser(names()).hide_possible_values(true)
        })
        .mut_arg("compare", |arg| {
            arg.value_parser(names())
                .value_delimiter(',')
                .action(ArgAction::Append)
                .hide_possible_values(true)
        });
    let foreign: Vec<String> = command
        .get_arguments()
        .map(|arg| arg.get_id().to_string())
        .filter(|id| !SHARED.contains(&id.as_str()) && !lesson.flags.contains(&id.as_str()))
        .collect();
    for id in &foreign {
        command = command.mut_arg(id, |arg| arg.hide(true));
    }
    let matches = command.try_get_matches_from_mut(arguments)?;
    let given = |id: &&String| matches.value_source(id) == Some(clap::parser::ValueSource::CommandLine);
    if let Some(id) = foreign.iter().find(given) {
        let message = format!("unexpected argument '--{id}': this lesson has no such flag\n");
        return Err(command.error(clap::error::ErrorKind::UnknownArgument, message));
    }
    let flags = Flags::from_arg_matches(&matches)?;
    if !matches!(flags.compare.len(), 0 | 2) {
        let message = "'--compare <A,B>' takes two methods, as in --compare A,B\n";
        return Err(command.error(clap::error::ErrorKind::WrongNumberOfValues, message));
    }
    Ok(flags)
}

/// clap's message without its usage block, on one line.
fn one_line(error: &clap::Error) -> String {
    let message = error.render().to_string();
    let lines = message.lines().map(str::trim);
    lines.filter(|line| !line.is_empty() && !line.starts_with("Usage:")).collect::<Vec<_>>().join("; ")
}

fn execute<F>(lesson: &Lesson<F>, flags: &Flags) -> anyhow::Result<()> {
    if flags.list {
        return print(&Method::list(lesson.methods));
    }
    let draw_by = |flags: &Flags, name: &str| {
        let method =
            Method::find(lesson.methods, name).with_context(|| format!("there is no method `{name}`"))?;
        (lesson.draw)(flags, &method.run)
    };
    if let (Some(_), Some(turntable)) = (flags.turntable, lesson.turntable) {
        return turntable(flags, lesson.name, &|flags| draw_by(flags, &flags.method));
    }
    let draw = |name: &str| draw_by(flags, name);
    let [a, b] = flags.compare.as_slice() else {
        let drawing = draw(&flags.method)?;
        if let (Some(path), Some(depth)) = (&flags.depth, drawing.depth) {
            depth.write(path)?;
        }
        return deliver(&drawing.picture, flags, lesson.name);
    };
    let (expected, got) = (draw(a)?.picture, draw(b)?.picture);
    let difference = Difference::between(&expected, &got);
    let sheet =
        side_by_side(&[&expected, &got, &difference.picture(&expected)]).map_err(anyhow::Error::msg)?;
    deliver(&sheet, flags, &format!("{}-compare", lesson.name))?;
    print(&format!("{b} against {a}: {difference}\n"))
}

/// Writes the picture, shows it in the terminal, and says where it is.
fn deliver(image: &Image, flags: &Flags, name: &str) -> anyhow::Result<()> {
    let paths = write_pictures(image, flags.out.as_deref(), name, None)?;
    if let Some(text) = preview::for_terminal(image).filter(|_| !flags.quiet) {
        print(&text)?;
    }
    let names: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    print(&format!("{} ({}x{})\n", names.join(", "), image.width(), image.height()))
}

/// Writes the picture where `out` says, or else as TGA and PNG in the folder `out/`, under that name; the
/// pictures of a series have a number behind it. Returns where.
///
/// # Errors
/// Where a file cannot be written.
pub fn write_pictures(
    image: &Image,
    out: Option<&Path>,
    name: &str,
    number: Option<u16>,
) -> anyhow::Result<Vec<PathBuf>> {
    let mut paths = match out {
        Some(path) => vec![path.to_path_buf()],
        None => {
            std::fs::create_dir_all("out").context("cannot create the folder out/")?;
            ["tga", "png"].map(|ending| Path::new("out").join(name).with_extension(ending)).to_vec()
        }
    };
    for path in &mut paths {
        if let Some(number) = number {
            let ending = path.extension().unwrap_or_default().to_string_lossy().into_owned();
            let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            path.set_file_name(format!("{stem}-{number:03}.{ending}"));
        }
        image.write(path)?;
    }
    Ok(paths)
}

/// Says a line on standard error. Where that fails there is nobody left to tell, so it is no error.
pub fn tell(line: impl std::fmt::Display) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// Prints to standard output. A reader that has gone away wants no more: that is no error.
///
/// # Errors
/// Where standard output cannot be written.
pub fn print(text: &str) -> anyhow::Result<()> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(error).context("cannot write to standard output")
        }
        _ => Ok(()),
    }
}

fn parse_size(text: &str) -> Result<(u16, u16), String> {
    let size = text
        .split_once('x')
        .and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)))
        .filter(|&(width, height): &(u16, u16)| {
            width.min(height) > 0 && width.max(height) <= file::SIDE_LIMIT
        });
    match size {
        None => Err(format!("write two numbers from 1 to {}, as in 800x600", file::SIDE_LIMIT)),
        Some((width, height)) if !file::fits(width, height) => {
            Err(format!("a picture may have {} pixels in all, as 8192x8192 has", file::PIXEL_LIMIT))
        }
        Some(size) => Ok(size),
    }
}

/// `count` numbers with commas between them and, behind a further comma, perhaps a colour.
fn parse_numbers<T: std::str::FromStr>(text: &str, count: usize) -> Result<(Vec<T>, Option<Color>), String> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    if parts.len() < count || parts.len() > count + 1 {
        return Err(format!("write {count} numbers with commas between them, not {}", parts.len()));
    }
    let number =
        |part: &&str| part.parse().map_err(|_| format!("`{part}` is not a number that can be used here"));
    let numbers = parts[..count].iter().map(number).collect::<Result<_, _>>()?;
    Ok((numbers, parts.get(count).map(|color| color.parse()).transpose()?))
}

fn parse_line(text: &str) -> Result<LineFlag, String> {
    let (n, color) = parse_numbers::<i32>(text, 4)?;
    let ends = [IVec2::new(n[0], n[1]), IVec2::new(n[2], n[3])];
    Ok(LineFlag { ends, color: color.unwrap_or(Color::WHITE) })
}

fn parse_triangle(text: &str) -> Result<TriangleFlag, String> {
    let (n, color) = parse_numbers::<f32>(text, 6)?;
    if !n.iter().all(|number| number.is_finite()) {
        return Err("a corner must be finite".into());
    }
    let corners = [0, 2, 4].map(|i| Vec2::new(n[i], n[i + 1]));
    Ok(TriangleFlag { corners, color: color.unwrap_or(Color::WHITE) })
}

/// A direction, made 1 long in f64, where no f32 over- or underflows when squared.
fn parse_direction(text: &str) -> Result<Vec3, String> {
    match parse_numbers::<f32>(text, 3)? {
        (n, None) => DVec3::new(n[0].into(), n[1].into(), n[2].into())
            .try_normalize()
            .map(DVec3::as_vec3)
            .ok_or_else(|| "a direction needs three finite numbers, not all 0".into()),
        (_, Some(_)) => Err("write 3 numbers with commas between them, not 4".into()),
    }
}

fn parse_point(text: &str) -> Result<Vec3, String> {
    match parse_numbers::<f32>(text, 3)? {
        (n, None) if n.iter().all(|number| number.is_finite()) => Ok(Vec3::new(n[0], n[1], n[2])),
        _ => Err("write 3 finite numbers with commas between them".into()),
    }
}

fn parse_distance(text: &str) -> Result<f32, String> {
    text.parse().ok().filter(|&d| d > 0.0).ok_or_else(|| "write a number above 0, or inf".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    const LESSON: Lesson<Color> = Lesson {
        name: "00-test",
        about: "One pixel.",
        methods: &[
            Method { name: "red", run: Color::RED, promise: "red", failure: "-" },
            Method { name: "green", run: Color::GREEN, promise: "green", failure: "-" },
        ],
        default: "green",
        flags: &["line", "light", "triangle"],
        draw: |flags, &color| {
            let mut image = flags.canvas(1, 1);
            image.set(0, 0, color);
            Ok(image.into())
        },
        turntable: None,
    };

    fn parsed(arguments: &[&str]) -> Result<Flags, String> {
        let arguments = std::iter::once("test").chain(arguments.iter().copied()).map(Into::into);
        parse(&LESSON, arguments).map_err(|error| one_line(&error))
    }

    #[test]
    fn defaults_are_the_lessons() {
        let flags = parsed(&[]).unwrap();
        assert_eq!((flags.method.as_str(), flags.light, flags.fill), ("green", Vec3::Z, Fill::Flat));
        assert_eq!((flags.canvas(7, 5).width(), flags.canvas(7, 5).height()), (7, 5));
    }

    #[test]
    fn values_may_begin_with_a_minus() {
        let flags =
            parsed(&["--line", "-1,-2,3,-4", "--line", "0,0,1,1,ff0000", "--light", "-1,0,0"]).unwrap();
        let ends = [IVec2::new(-1, -2), IVec2::new(3, -4)];
        assert_eq!(flags.line[0], LineFlag { ends, color: Color::WHITE });
        assert_eq!((flags.line[1].color, flags.light), (Color::RED, Vec3::NEG_X));
    }

    #[test]
    fn a_direction_becomes_a_unit_vector_however_long_it_was() {
        for scale in ["1e-38", "1", "1e38"] {
            let flags = parsed(&["--light", &format!("{scale},0,{scale}")]).unwrap();
            assert!((flags.light - Vec3::new(0.5, 0.0, 0.5).normalize()).length() < 1e-6, "{scale}");
        }
    }

    #[test]
    fn what_is_wrong_is_said_in_one_line() {
        for (arguments, said) in [
            (&["--size", "0x5"][..], "write two numbers from 1 to 16384"),
            (&["--size", "20000x5"], "write two numbers from 1 to 16384"),
            (&["--size", "5"], "write two numbers from 1 to 16384"),
            (&["--size", "8192x8193"], "a picture may have 67108864 pixels in all"),
            (
                &["--method", "blue"],
                "invalid value 'blue' for '--method <NAME>'; [possible values: red, green]",
            ),
            (&["--compare", "red"], "takes two methods"),
            (&["--compare", "red,green,red"], "takes two methods"),
            (&["--compare", "red,blue"], "[possible values: red, green]"),
            (&["--line", "1,2,3"], "write 4 numbers"),
            (&["--line", "1,2,3,4.5"], "`4.5` is not a number"),
            (&["--line", "1,2,3,2147483648"], "`2147483648` is not a number"),
            (&["--line", "1,2,3,4,red"], "`red` is not a colour"),
            (&["--triangle", "1,2,3,4,5,nan"], "a corner must be finite"),
            (&["--light", "0,0,0"], "not all 0"),
            (&["--light", "0,inf,0"], "not all 0"),
            (&["--fill", "flat"], "unexpected argument '--fill': this lesson has no such flag"),
            (&["--nonsense"], "unexpected argument '--nonsense'"),
        ] {
            let error = parsed(arguments).unwrap_err();
            assert!(error.contains(said) && !error.contains('\n'), "{arguments:?}: {error}");
        }
    }
}
