//! Files written whole or not at all.

use std::fs::File;
use std::io::{Result, Write};
use std::path::Path;

use tempfile::Builder;

use crate::Error;

/// Writes a file in its folder and only then gives it its name, so that a reader finds the old one or the new one
/// and never a part. A symbolic link of that name is replaced; the file to which it led stays as it was.
///
/// On Linux the file has no name until it is whole, so that nothing is left of it where the program is ended
/// (but for the moment between two system calls, where it takes the place of another). On other systems and
/// on the few file systems that have no such files it has a hidden one, `.XXXXXX.part`, that no other file has;
/// it is removed where anything fails, but stays where the program is ended from outside.
///
/// # Errors
/// One that names the file where its folder does not exist or the system refuses.
pub fn write_whole(path: &Path, bytes: &[u8]) -> std::result::Result<(), Error> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !folder.is_dir() {
        let (path, folder) = (path.into(), folder.to_path_buf());
        return Err(if folder.exists() {
            Error::NotAFolder { path, folder }
        } else {
            Error::NoFolder { path }
        });
    }
    let written = match unnamed::create(folder) {
        Ok(file) => write(file, bytes).and_then(|file| {
            unnamed::name(&file, folder, path).or_else(|_| write_hidden(folder, path, bytes))
        }),
        Err(_) => write_hidden(folder, path, bytes),
    };
    written.map_err(|source| Error::Write { path: path.into(), source })
}

fn write(mut file: File, bytes: &[u8]) -> Result<File> {
    file.write_all(bytes)?;
    file.sync_all()?;
    Ok(file)
}

/// Names that no other file has, short whatever the file's own name.
fn hidden() -> Builder<'static, 'static> {
    let mut builder = Builder::new();
    builder.prefix(".").suffix(".part");
    builder
}

/// Writes a file under a hidden name and renames it.
fn write_hidden(folder: &Path, path: &Path, bytes: &[u8]) -> Result<()> {
    // Not as the crate makes them, for its owner alone: it will be a file like others.
    let (file, hidden) = hidden().make_in(folder, |hidden| File::create_new(hidden))?.into_parts();
    write(file, bytes)?;
    Ok(hidden.persist(path)?)
}

/// Files without a name, as Linux has them.
#[cfg(target_os = "linux")]
mod unnamed {
    use std::fs::{File, OpenOptions};
    use std::io::Result;
    use std::os::fd::AsRawFd;
    use std::os::unix::fs::OpenOptionsExt;
    use std::path::Path;

    use rustix::fs::{AtFlags, CWD, OFlags, linkat};

    pub(super) fn create(folder: &Path) -> Result<File> {
        OpenOptions::new().write(true).custom_flags(OFlags::TMPFILE.bits() as i32).open(folder)
    }

    /// Gives a file its name, whether or not another one has it.
    pub(super) fn name(file: &File, folder: &Path, path: &Path) -> Result<()> {
        let number = format!("/proc/self/fd/{}", file.as_raw_fd());
        let link = |path: &Path| Ok(linkat(CWD, &number, CWD, path, AtFlags::SYMLINK_FOLLOW)?);
        if link(path).is_err() {
            // A link replaces nothing, but a new name does.
            super::hidden().make_in(folder, link)?.into_temp_path().persist(path)?;
        }
        Ok(())
    }
}

#[cfg(not(target_os = "linux"))]
mod unnamed {
    use std::fs::File;
    use std::io::{ErrorKind, Result};
    use std::path::Path;

    pub(super) fn create(_: &Path) -> Result<File> {
        Err(ErrorKind::Unsupported.into())
    }

    pub(super) fn name(_: &File, _: &Path, _: &Path) -> Result<()> {
        Err(ErrorKind::Unsupported.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As on a system or in a folder that has no files without a name.
    #[test]
    fn a_file_under_a_hidden_name_takes_the_place_of_another() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        for bytes in [&b"old"[..], b"new"] {
            write_hidden(folder.path(), &path, bytes).unwrap();
            assert_eq!(std::fs::read(&path).unwrap(), bytes);
            assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        }
        let hidden = hidden().tempfile_in(folder.path()).unwrap();
        let name = hidden.path().file_name().unwrap().to_str().unwrap();
        assert!(name.starts_with('.') && name.ends_with(".part"), "{name}");
    }
}
