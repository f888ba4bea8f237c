//! The model that a program draws, and its texture.

use std::path::{Path, PathBuf};

use anyhow::ensure;

use crate::terminal::eprintln;
use crate::{Attributes, Image, Model};

/// The model that lessons draw unless told otherwise.
pub const DEFAULT_MODEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/head.obj");

/// The texture of the head.
pub const DEFAULT_TEXTURE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/head.tga");

/// `--model`.
#[derive(Clone, Debug, clap::Args)]
pub struct ModelFlag {
    /// The model to draw, an OBJ file; without FILE the course's own
    #[arg(id = "model", long = "model", value_name = "FILE", num_args = 0..=1, default_missing_value = DEFAULT_MODEL)]
    pub file: Option<PathBuf>,
}

impl ModelFlag {
    /// Reads the model asked for, or else the course's own, and tells on standard error what was left out,
    /// or that it has no normals where the lesson wants some.
    ///
    /// # Errors
    /// As [`Model::read`]; if the model has lines and no faces; and if the lesson wants texture coordinates and
    /// the model has none.
    pub fn read(&self, wanted: Attributes) -> anyhow::Result<Model> {
        let (path, model) = (self.path(), self.read_lines(wanted)?);
        ensure!(
            model.faces().len() > 0,
            "{}: there are lines in it and no faces; lesson 2 draws lines: cargo run -p wireframe -- --model {0}",
            path.display()
        );
        Ok(model)
    }

    /// As [`read`](Self::read), for a lesson that draws a model's lines as well: it need not have faces.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_lines(&self, wanted: Attributes) -> anyhow::Result<Model> {
        let path = self.path();
        let model = Model::read(path, wanted)?;
        ensure!(
            !wanted.uvs || model.face_uvs().len() == model.faces().len(),
            "{}: not every face has texture coordinates; export the model with them, or draw it without a texture",
            path.display()
        );
        for note in notes(&model, wanted) {
            eprintln(format_args!("{}: {note}", path.display()));
        }
        Ok(model)
    }

    fn path(&self) -> &Path {
        self.file.as_deref().unwrap_or(Path::new(DEFAULT_MODEL))
    }
}

/// What the reader of a model should know before looking at the picture.
fn notes(model: &Model, wanted: Attributes) -> Vec<String> {
    let skipped = model.skipped().map(|skipped| {
        format!("left out {} of {} faces; the first, {}", skipped.count, skipped.of, skipped.first)
    });
    let computed = (wanted.normals && model.face_normals().len() == 0)
        .then(|| "not every face has normals; they are computed".into());
    skipped.into_iter().chain(model.remarks().iter().cloned()).chain(computed).collect()
}

/// `--model` and `--texture`.
#[derive(Clone, Debug, clap::Args)]
pub struct TexturedModelFlags {
    #[command(flatten)]
    model: ModelFlag,

    /// The model's texture, .tga or .png [default: the head's]
    #[arg(long, value_name = "FILE")]
    texture: Option<PathBuf>,
}

impl TexturedModelFlags {
    /// Reads the model, with texture coordinates, and its texture.
    ///
    /// # Errors
    /// As [`ModelFlag::read`] and [`Image::read`].
    pub fn read(&self, wanted: Attributes) -> anyhow::Result<(Model, Image)> {
        let model = self.model.read(Attributes { uvs: true, ..wanted })?;
        let texture = Image::read(self.texture.as_deref().unwrap_or(Path::new(DEFAULT_TEXTURE)))?;
        Ok((model, texture))
    }

    /// Reads the model alone, for a picture that needs no texture: whether there is one is not looked at.
    ///
    /// # Errors
    /// As [`ModelFlag::read`].
    pub fn read_untextured(&self, wanted: Attributes) -> anyhow::Result<Model> {
        self.model.read(Attributes { uvs: false, ..wanted })
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
        let model = ModelFlag { file: Some(path) };
        let flags = TexturedModelFlags { model, texture: Some("none.png".into()) };
        let error = flags.read(Attributes::default()).unwrap_err();
        assert!(error.to_string().contains("not every face has texture coordinates"), "{error}");
        assert_eq!(flags.read_untextured(Attributes::default()).unwrap().triangles().len(), 1);

        let head = TexturedModelFlags { model: ModelFlag { file: None }, ..flags };
        assert!(head.read(Attributes::default()).unwrap_err().to_string().contains("cannot read none.png"));
    }
}
