//! What can go wrong with a file, in one line each: the file, the cause, the cure.

use std::path::PathBuf;

use crate::printable::shown;

/// A file that could not be read or written.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The file could not be opened or read.
    #[error("cannot read {}", shown(path))]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The file could not be written; what was there before is there still.
    #[error("cannot write {}", shown(path))]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The folder in which a file is to be written does not exist.
    #[error("cannot write {}: its folder does not exist, create it first", shown(path))]
    NoFolder {
        /// The file.
        path: PathBuf,
    },
    /// What should be the folder of a file to be written is one itself.
    #[error("cannot write {}: {} is a file and no folder", shown(path), shown(folder))]
    NotAFolder {
        /// The file.
        path: PathBuf,
        /// What is no folder.
        folder: PathBuf,
    },
    /// The file's name does not say what it holds.
    #[error("{}: the name of a picture must end in .tga or .png", shown(path))]
    Ending {
        /// The file.
        path: PathBuf,
    },
    /// The file's name is nothing but an ending.
    #[error(
        "{}: the name of a picture must end in .tga or .png and begin with something else, as in a{0}",
        shown(path)
    )]
    NoName {
        /// The file.
        path: PathBuf,
    },
    /// The file is something else than its name says.
    #[error("{}: not a picture that can be read: {kind}", shown(path))]
    Kind {
        /// The file.
        path: PathBuf,
        /// What it is, and what can be done.
        kind: String,
    },
    /// The picture, or the description of materials, is larger than any that is read.
    #[error("{}: larger than the {} MiB that are read", shown(path), limit >> 20)]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// Bytes allowed.
        limit: u64,
    },
    /// The file does not hold the picture that its name promises, or one beyond the limits.
    #[error("{}: not a picture that can be read; is it whole, and named after what it is?", shown(path))]
    Picture {
        /// The file.
        path: PathBuf,
        /// What the decoder said.
        source: PictureError,
    },
    /// The picture cannot be stored, as it has no pixels.
    #[error("cannot write {}: the picture cannot be encoded", shown(path))]
    Encode {
        /// The file.
        path: PathBuf,
        /// What the encoder said.
        source: PictureError,
    },
    /// The file holds no model.
    #[error("{}: {reason}", shown(path))]
    Model {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
}

/// What is wrong with the bytes of a picture's file, or with the picture that is to become some.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// A side or the memory is beyond the limits of [`file`](crate::file).
    #[error("it is larger than can be read")]
    TooLarge,
    /// The bytes end before the picture does.
    #[error("unexpected end of file")]
    Truncated,
    /// The bytes do not make sense.
    #[error("{0}")]
    Malformed(&'static str),
    /// The picture has no pixels.
    #[error("it has no pixels")]
    Empty,
    /// No PNG file.
    #[error(transparent)]
    Decoding(#[from] png::DecodingError),
    /// Not to be stored as a PNG file.
    #[error(transparent)]
    Encoding(#[from] png::EncodingError),
}
