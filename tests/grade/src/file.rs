//! Files that are whole or not there.

use std::io::{Read, Write};
use std::path::Path;

use anyhow::Context;
use judge::message;
use sha2::{Digest, Sha256};

/// Writes a file beside its place and renames it, so that it is never half-written.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    let whole = || -> anyhow::Result<()> {
        let folder = path.parent().context("it has no folder")?;
        std::fs::create_dir_all(folder)?;
        let mut file = tempfile::NamedTempFile::new_in(folder)?;
        file.write_all(bytes)?;
        file.as_file().sync_all()?;
        // Others may read a report: a temporary file is its maker's alone.
        let mode = std::os::unix::fs::PermissionsExt::from_mode(0o644);
        file.as_file().set_permissions(mode)?;
        file.persist(path)?;
        Ok(())
    };
    whole().with_context(|| format!("cannot write {}", path.display()))
}

/// The beginning of what a program said into a file, as far as it is text, with a note if there is more; nothing if
/// the file is not there.
pub(crate) fn said(path: &Path) -> String {
    let mut text = Vec::new();
    if let Ok(file) = std::fs::File::open(path) {
        // What cannot be read is not shown.
        let _ = file.take(2 * message::LONGEST as u64).read_to_end(&mut text);
    }
    message::cut(String::from_utf8_lossy(&text).trim())
}

/// SHA-256 of several pieces, each with its length, in hexadecimal.
pub(crate) fn digest<'a>(pieces: impl IntoIterator<Item = &'a [u8]>) -> String {
    let mut hash = Sha256::new();
    for piece in pieces {
        hash.update((piece.len() as u64).to_le_bytes());
        hash.update(piece);
    }
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
