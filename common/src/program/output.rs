//! Where a program's pictures go: into files, and small ones into the terminal.

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::Context;

use super::{Extras, Program, Shared, UsageError};
use crate::compare::{Difference, side_by_side};
use crate::printable::shown;
use crate::terminal::{Progress, eprintln, print};
use crate::{Format, Image, preview};

/// The pictures' size, files and terminal, as the shared flags ask for them.
pub struct Output {
    shared: Shared,
    /// What files are called unless told otherwise.
    name: String,
}

impl Output {
    pub(super) fn new(shared: Shared, name: String) -> Self {
        Self { shared, name }
    }

    /// Whether `--out` names a file: where none is named, a program may show its picture in a window instead.
    #[must_use]
    pub fn has_file(&self) -> bool {
        self.shared.out.is_some()
    }

    /// Width and height in pixels, as asked for, or else the program's own.
    pub fn size<P: Program>(&self, program: &P) -> (u16, u16) {
        self.shared.size.unwrap_or_else(|| program.size())
    }

    /// A black picture of that size.
    pub(super) fn canvas<P: Program>(&self, program: &P) -> Image {
        let (width, height) = self.size(program);
        Image::new(width, height, Format::Rgb)
    }

    /// Draws one picture, writes it, shows it in the terminal, and says where it is.
    ///
    /// # Errors
    /// Where it cannot be drawn, or a file not be written.
    pub fn one<P: Program>(&self, program: &mut P, method: &P::Method) -> anyhow::Result<()> {
        let mut picture = self.canvas(program);
        let extras = draw(program, method, &mut picture)?;
        if let Some((path, depth)) = extras.depth {
            if self.paths(&self.name)?.iter().any(|other| is_same(&path, other)) {
                let path = shown(&path);
                return Err(UsageError(format!(
                    "--depth {path}: the picture itself goes there: name another file"
                ))
                .into());
            }
            depth.write(&path)?;
        }
        self.deliver(&picture, &self.name)
    }

    /// Draws `count` pictures and writes them under the name and their number: NAME-000, NAME-001 and so on.
    /// `prepare(program, n)` makes the program ready for picture `n`.
    ///
    /// # Errors
    /// As [`one`](Self::one).
    pub fn series<P: Program>(
        &self,
        program: &mut P,
        method: &P::Method,
        count: u16,
        prepare: impl Fn(&mut P, u16),
    ) -> anyhow::Result<()> {
        let mut picture = self.canvas(program);
        let mut progress = Progress::new(count, Duration::ZERO);
        for n in 0..count {
            prepare(program, n);
            picture.clear();
            draw(program, method, &mut picture)?;
            for path in self.paths(&self.name)? {
                picture.write(&numbered(&path, n))?;
            }
            progress.step();
        }
        drop(progress);
        print(&format!("{count} pictures\n"))
    }

    /// Draws by two methods, shows both pictures beside each other with their difference, and counts it.
    pub(super) fn two<P: Program>(
        &self,
        program: &mut P,
        a: &P::Method,
        b: &P::Method,
    ) -> anyhow::Result<()> {
        let [mut expected, mut got] = [self.canvas(program), self.canvas(program)];
        draw(program, a, &mut expected)?;
        draw(program, b, &mut got)?;
        self.difference(&expected, &got)
    }

    fn difference(&self, expected: &Image, got: &Image) -> anyhow::Result<()> {
        let difference = Difference::between(expected, got);
        let sheet =
            side_by_side(&[expected, got, &difference.picture(expected)]).map_err(anyhow::Error::msg)?;
        self.deliver(&sheet, &format!("{}-compare", self.name))?;
        let [a, b] = [0, 1].map(|n| self.shared.compare[n].as_str());
        print(&format!("{b} against {a}: {difference}\n"))
    }

    /// Writes a picture, shows it in the terminal, and says where it is.
    fn deliver(&self, picture: &Image, name: &str) -> anyhow::Result<()> {
        let paths = self.paths(name)?;
        for path in &paths {
            picture.write(path)?;
        }
        if let Some(text) = preview::for_terminal(picture).filter(|_| !self.shared.quiet) {
            print(&text)?;
        }
        let names: Vec<String> = paths.iter().map(|path| shown(path).to_string()).collect();
        print(&format!("{} ({}x{})\n", names.join(", "), picture.width(), picture.height()))
    }

    /// The file that `--out` names, or else a TGA and a PNG of that name in the folder `out/`, which is made.
    fn paths(&self, name: &str) -> anyhow::Result<Vec<PathBuf>> {
        if let Some(path) = &self.shared.out {
            return Ok(vec![path.clone()]);
        }
        let reason = if Path::new("out").is_file() { ": there is a file of that name" } else { "" };
        std::fs::create_dir_all("out").with_context(|| format!("cannot create the folder out/{reason}"))?;
        Ok(["tga", "png"].map(|ending| Path::new("out").join(name).with_extension(ending)).to_vec())
    }
}

/// Draws, and tells on standard error which triangles are not in the picture.
fn draw<P: Program>(program: &mut P, method: &P::Method, picture: &mut Image) -> anyhow::Result<Extras> {
    let extras = program.draw(method, picture)?;
    match extras.left_out {
        0 => {}
        1 => eprintln("left out 1 triangle that reaches behind the eye"),
        count => eprintln(format_args!("left out {count} triangles that reach behind the eye")),
    }
    Ok(extras)
}

/// The name of picture `number` of a series: `a.png` becomes `a-000.png`.
fn numbered(path: &Path, number: u16) -> PathBuf {
    let mut name = path.file_stem().unwrap_or_default().to_os_string();
    name.push(format!("-{number:03}."));
    name.push(path.extension().unwrap_or_default());
    path.with_file_name(name)
}

/// Whether two names are those of one file, there or not.
pub(super) fn is_same(a: &Path, b: &Path) -> bool {
    let place = |path: &Path| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Some((folder.canonicalize().ok()?, path.file_name()?.to_os_string()))
    };
    a == b || place(a).is_some_and(|a| place(b) == Some(a))
}
