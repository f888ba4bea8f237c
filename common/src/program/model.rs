//! The model that a program draws, and its texture.

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{bail, ensure};

use super::texture;
use crate::placement::{Placement, Up};
use crate::printable::shown;
use crate::terminal::{Progress, eprintln};
use crate::{Attributes, DVec3, Image, Model};

/// The model that lessons draw unless told otherwise.
pub const DEFAULT_MODEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/head.obj");

/// The texture of the head.
pub const DEFAULT_TEXTURE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/head.tga");

/// How long reading a model may take before it is shown how far it has come.
const PATIENCE: Duration = Duration::from_secs(1);

/// `--model` and `--fit`.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct ModelFlag {
    /// The model to draw, an OBJ file, which may take half of the free memory; without FILE the course's own. What lies
    /// between -1 and 1 is in view
    #[arg(id = "model", long = "model", value_name = "FILE", num_args = 0..=1, default_missing_value = DEFAULT_MODEL)]
    pub file: Option<PathBuf>,

    /// Move and scale the model into view, whatever its units; with z, what points up in it is z
    #[arg(id = "fit", long = "fit", value_name = "y|z", value_enum, hide_possible_values = true, num_args = 0..=1, default_missing_value = "y")]
    pub fit: Option<Up>,
}

impl ModelFlag {
    /// Reads the model asked for, or else the course's own, and tells on standard error what was left out, that
    /// it is out of view or how it was brought there, or that it has no normals where the lesson wants some.
    ///
    /// # Errors
    /// As [`Model::read`]; if the model has lines and no faces; and if the lesson wants texture coordinates and
    /// the model has none.
    pub fn read(&self, wanted: Attributes) -> anyhow::Result<Model> {
        self.read_about(DVec3::ZERO, wanted)
    }

    /// As [`read`](Self::read), about another origin than the file's, which lies there no longer: see
    /// [`Placement`].
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_about(&self, origin: DVec3, wanted: Attributes) -> anyhow::Result<Model> {
        let (path, model) = (self.path(), self.load(origin, wanted)?);
        ensure!(
            model.faces().len() > 0,
            "{}: there are lines in it and no faces; lesson 2 draws lines: cargo run -p wireframe -- --model {0}",
            shown(path)
        );
        Ok(model)
    }

    /// As [`read`](Self::read), for a lesson that draws a model's lines as well: it need not have faces.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_lines(&self, wanted: Attributes) -> anyhow::Result<Model> {
        self.load(DVec3::ZERO, wanted)
    }

    fn load(&self, origin: DVec3, wanted: Attributes) -> anyhow::Result<Model> {
        let path = self.path();
        let mut progress = Progress::new(100, PATIENCE);
        let mut watch = |share: f64| progress.reach((100.0 * share) as u16);
        let model = Model::read_watched(path, wanted, &Placement { fit: self.fit, origin }, &mut watch)?;
        drop(progress);
        if let Some(line) = model.without_uvs() {
            bail!(
                "{}: not every face has texture coordinates; export the model with them, or draw it without a \
                 texture; the first face without them is in line {line}",
                shown(path)
            );
        }
        for note in notes(&model, wanted).into_iter().chain(view(&model, origin)) {
            eprintln(format_args!("{}: {note}", shown(path)));
        }
        Ok(model)
    }

    fn path(&self) -> &Path {
        self.file.as_deref().unwrap_or(Path::new(DEFAULT_MODEL))
    }

    /// Whether it is the course's own, however it is named.
    fn is_default(&self) -> bool {
        let real = |path: &Path| path.canonicalize().ok();
        self.file.as_deref().is_none_or(|file| real(file) == real(Path::new(DEFAULT_MODEL)))
    }
}

/// What the reader of a model should know before looking at the picture.
fn notes(model: &Model, wanted: Attributes) -> Vec<String> {
    let skipped = model.skipped().map(|skipped| {
        format!("left out {} of {} faces; the first, {}", skipped.count, skipped.of, skipped.first)
    });
    let computed = model
        .without_normals()
        .filter(|_| wanted.normals)
        .map(|_| "not every face has normals; they are computed".into());
    skipped.into_iter().chain(model.remarks().iter().cloned()).chain(computed).collect()
}

/// How the model was brought into view, or that it is not.
fn view(model: &Model, origin: DVec3) -> Option<String> {
    if let Some(fit) = model.fit() {
        let [x, y, z] = fit.size.to_array().map(rounded);
        let (scale, up) = (rounded(fit.scale), if fit.up == Up::Y { "y" } else { "z" });
        let middle = fit.middle.to_array().map(|at| placed(at, fit.size.max_element())).join(", ");
        return Some(format!("{x} x {y} x {z} units about ({middle}), {up} up, scaled by {scale}"));
    }
    let reach = model.reach();
    let told = rounded(reach.into());
    match origin {
        DVec3::ZERO if reach > 1.0 => Some(format!(
            "it reaches to {told}, and what lies beyond 1 may be out of view: --fit brings it in"
        )),
        DVec3::ZERO if reach < 0.01 => {
            Some(format!("it reaches to {told} only: --fit makes it as large as the view"))
        }
        _ => None,
    }
}

/// A coordinate, in as many digits as say where something of that size is: a point to look at, however far away.
fn placed(coordinate: f64, size: f64) -> String {
    let all = rounded(coordinate);
    let exact = |text: &String| text.parse() == Ok(coordinate);
    if exact(&all) || coordinate.abs() >= 1e15 || size == 0.0 {
        return all;
    }
    let decimals = (2.0 - size.log10().floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{coordinate:.decimals$}");
    if decimals == 0 { text } else { text.trim_end_matches('0').trim_end_matches('.').into() }
}

/// A number in three digits.
fn rounded(number: f64) -> String {
    if number == 0.0 || (1e-3..1e6).contains(&number.abs()) {
        let digits = (2.0 - number.abs().max(1e-3).log10().floor()).clamp(0.0, 6.0) as usize;
        let text = format!("{number:.digits$}");
        return if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').into()
        } else {
            text
        };
    }
    format!("{number:.2e}")
}

/// `--model` and `--texture`.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct TexturedModelFlags {
    #[command(flatten)]
    model: ModelFlag,

    /// The model's texture, .tga or .png [default: the one that its material names, else a checker]
    #[arg(long, value_name = "FILE")]
    texture: Option<PathBuf>,
}

impl TexturedModelFlags {
    /// Whether `--model` was given.
    #[must_use]
    pub fn is_given(&self) -> bool {
        self.model.file.is_some()
    }

    /// Reads the model, with texture coordinates, and its texture: the one asked for, the head's for the head, or
    /// the model's own; where that has none, a checker. Which one a model of the user's has is told.
    ///
    /// # Errors
    /// As [`ModelFlag::read`] and [`Image::read`].
    pub fn read(&self, wanted: Attributes) -> anyhow::Result<(Model, Image)> {
        self.read_about(DVec3::ZERO, wanted)
    }

    /// As [`read`](Self::read), about another origin: see [`ModelFlag::read_about`].
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_about(&self, origin: DVec3, wanted: Attributes) -> anyhow::Result<(Model, Image)> {
        let model = self.model.read_about(origin, Attributes { uvs: true, ..wanted })?;
        let texture = match &self.texture {
            Some(path) => Image::read(path)?,
            None if self.model.is_default() => Image::read(Path::new(DEFAULT_TEXTURE))?,
            None => {
                let (texture, line) = texture::own(self.model.path(), model.materials());
                eprintln(format_args!("{}: {line}", shown(self.model.path())));
                texture
            }
        };
        Ok((model, texture))
    }

    /// As [`read_about`](Self::read_about), where a lesson draws another model than the head unless told otherwise, with
    /// another texture.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_instead(
        &self,
        [model, texture]: [&str; 2],
        origin: DVec3,
        wanted: Attributes,
    ) -> anyhow::Result<(Model, Image)> {
        if self.is_given() {
            return self.read_about(origin, wanted);
        }
        let texture = self.texture.clone().or_else(|| Some(texture.into()));
        let model = ModelFlag { file: Some(model.into()), fit: self.model.fit };
        Self { model, texture }.read_about(origin, wanted)
    }

    /// Reads the model alone, for a picture that needs no texture: whether there is one is not looked at.
    ///
    /// # Errors
    /// As [`ModelFlag::read`].
    pub fn read_untextured(&self, origin: DVec3, wanted: Attributes) -> anyhow::Result<Model> {
        self.model.read_about(origin, Attributes { uvs: false, ..wanted })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BARE: &[u8] = b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n";

    #[test]
    fn what_is_missing_is_told_where_it_is_wanted() {
        for (normals, count) in [(false, 1), (true, 2)] {
            let wanted = Attributes { normals, uvs: false };
            let notes = notes(&Model::parse(BARE, wanted).unwrap(), wanted);
            assert_eq!(notes.len(), count, "{notes:?}");
            assert!(notes[0].starts_with("left out 1 of 2 faces; the first, line 5"), "{notes:?}");
        }
    }

    #[test]
    fn a_texture_is_read_only_for_a_model_with_coordinates_and_where_it_is_wanted() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("bare.obj");
        std::fs::write(&path, BARE).unwrap();
        let model = ModelFlag { file: Some(path), fit: None };
        let flags = TexturedModelFlags { model, texture: Some("none.png".into()) };
        let error = flags.read(Attributes::default()).unwrap_err();
        assert!(error.to_string().contains("not every face has texture coordinates"), "{error}");
        let wanted = Attributes { uvs: true, ..Attributes::default() };
        assert_eq!(flags.read_untextured(DVec3::ZERO, wanted).unwrap().triangles().len(), 1);

        assert!(flags.is_given());

        let head = TexturedModelFlags { model: ModelFlag { file: None, fit: None }, ..flags };
        assert!(!head.is_given());
        assert!(head.read(Attributes::default()).unwrap_err().to_string().contains("cannot read none.png"));
    }

    /// What is told of where a model was is enough to look at it there: off by less than a hundredth of its size.
    #[test]
    fn the_middle_is_told_in_as_many_digits_as_it_needs() {
        for (coordinate, size, told) in [
            (4_649_777.31, 1.0, "4649777.31"),
            (500_000.87, 1.0, "500000.87"),
            (212.9, 1.0, "212.9"),
            (0.0, 1.0, "0"),
            (1_234_567.0, 90_000.0, "1234567"),
            (0.000_123_4, 0.002, "0.00012"),
            (-12.345_678, 0.05, "-12.3457"),
            (1e30, 1e29, "1.00e30"),
            (1.2345e15, 1e15, "1.23e15"),
            (2e6, 1.0, "2.00e6"),
            (5.0, 0.0, "5"),
        ] {
            assert_eq!(placed(coordinate, size), told);
            let off = (told.parse::<f64>().unwrap() - coordinate).abs();
            assert!(off <= size / 100.0, "{told}");
        }
    }

    #[test]
    fn what_is_out_of_view_is_told_with_the_cure_and_what_was_fitted_with_its_size() {
        for (scale, fit, said) in [
            (1.0, None, None),
            (
                1.5,
                None,
                Some("it reaches to 1.5, and what lies beyond 1 may be out of view: --fit brings it in"),
            ),
            (1200.0, None, Some("it reaches to 1200, and what")),
            (5e7, None, Some("it reaches to 5.00e7, and what")),
            (0.01, None, None),
            (0.001, None, Some("it reaches to 0.001 only: --fit makes it as large as the view")),
            (0.001, Some(Up::Y), Some("0.002 x 0.002 x 0 units about (0, 0, 0), y up, scaled by 632")),
            (1200.0, Some(Up::Z), Some("2400 x 2400 x 0 units about (0, 0, 0), z up, scaled by 5.27e-4")),
        ] {
            let text = format!("v -{scale} -{scale} 0\nv {scale} -{scale} 0\nv {scale} {scale} 0\nf 1 2 3\n");
            let placement = Placement { fit, ..Placement::default() };
            let model = Model::parse_placed(text.as_bytes(), Attributes::default(), &placement).unwrap();
            let told = view(&model, DVec3::ZERO);
            assert!(told.as_deref().unwrap_or("").starts_with(said.unwrap_or("")), "{scale}: {told:?}");
            assert_eq!(told.is_some(), said.is_some(), "{scale}: {told:?}");
        }
    }
}
