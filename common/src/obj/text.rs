//! The text of a model's file.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::stage::Stage;
use crate::Error;

/// The longest file whose places a `u32` counts, in bytes.
const LENGTH_LIMIT: u64 = u32::MAX as u64;

/// The most bytes that are read of what does not say how many it has.
const UNKNOWN_LIMIT: u64 = 256 << 20;

/// What is read at a time, in bytes.
const CHUNK: u64 = 1 << 20;

/// What helps where a model takes too much memory.
pub(super) const CURE: &str = "close other programs, or draw a model of fewer faces";

/// The text of a file, of at most `memory` bytes. One that is too long is refused before anything is allocated for it.
/// A pipe or a device has no length, nor have the files in which Linux tells of itself; of these, at most 256 MiB are
/// read.
pub(super) fn read(
    path: &Path,
    memory: u64,
    watch: &mut dyn FnMut(f64),
    share: [f64; 2],
) -> Result<Vec<u8>, Error> {
    let refused = |reason| Err(Error::Model { path: path.into(), reason });
    let failed = |source| Error::Read { path: path.into(), source };
    let file = File::open(path).map_err(failed)?;
    let metadata = file.metadata().map_err(failed)?;
    let length = Some(metadata.len()).filter(|&length| metadata.is_file() && length > 0);
    if let Some(length) = length.filter(|&length| length > LENGTH_LIMIT.min(memory)) {
        let mib = length.div_ceil(1 << 20);
        return refused(if length > LENGTH_LIMIT {
            format!("it has {mib} MiB, of which less than 4096 can be read: draw a model of fewer faces")
        } else {
            format!(
                "its {mib} MiB are more than the {} MiB that are half of the free memory: {CURE}",
                memory >> 20
            )
        });
    }
    let limit = length.unwrap_or(UNKNOWN_LIMIT.min(memory));
    let mut text = Vec::new();
    let room = length.map_or(0, |length| length as usize + 1);
    text.try_reserve_exact(room).map_err(|error| failed(io::Error::from(error)))?;
    let mut stage = Stage::new(watch, share, limit as usize);
    let mut file = file.take(limit + 1);
    while file.by_ref().take(CHUNK).read_to_end(&mut text).map_err(failed)? > 0 {
        stage.done(text.len());
    }
    if text.len() as u64 <= limit {
        return Ok(text);
    }
    refused(match length {
        Some(_) => "it became longer while it was read: draw it when it is complete".into(),
        None => format!(
            "it does not say how long it is, and has more than {} MiB: save it as a file first",
            limit >> 20
        ),
    })
}

#[cfg(test)]
mod tests {
    use std::fs::{self, OpenOptions};
    use std::io::Write;

    use super::*;

    fn read_quietly(path: &Path, memory: u64) -> Result<Vec<u8>, String> {
        read(path, memory, &mut |_| (), [0.0, 1.0]).map_err(|error| error.to_string())
    }

    #[test]
    fn a_file_may_have_as_many_bytes_as_there_is_memory() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.obj");
        fs::write(&path, vec![b'#'; 3 << 20]).unwrap();
        for memory in [3 << 20, (3 << 20) + 1, u64::MAX] {
            assert_eq!(read_quietly(&path, memory).unwrap().len(), 3 << 20, "{memory}");
        }
        let error = read_quietly(&path, (3 << 20) - 1).unwrap_err();
        let said = "a.obj: its 3 MiB are more than the 2 MiB that are half of the free memory: close other programs, or draw a model of fewer faces";
        assert!(error.ends_with(said), "{error}");
    }

    /// It has no more than its length on the disk.
    #[test]
    fn a_file_that_is_too_long_is_not_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.obj");
        File::create(&path).unwrap().set_len(4 << 30).unwrap();
        let error = read_quietly(&path, u64::MAX).unwrap_err();
        assert!(
            error.ends_with(
                "a.obj: it has 4096 MiB, of which less than 4096 can be read: draw a model of fewer faces"
            ),
            "{error}"
        );
    }

    #[test]
    fn a_file_that_grows_is_not_followed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.obj");
        fs::write(&path, vec![b'#'; CHUNK as usize + 1]).unwrap();
        let mut writer = OpenOptions::new().append(true).open(&path).unwrap();
        let mut grow = |_| writer.write_all(&[b'#'; 3 << 20]).unwrap();
        let error = read(&path, u64::MAX, &mut grow, [0.0, 1.0]).unwrap_err().to_string();
        assert!(
            error.ends_with("a.obj: it became longer while it was read: draw it when it is complete"),
            "{error}"
        );
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn what_has_no_length_is_cut_off() {
        let error = read_quietly(Path::new("/dev/zero"), 5 << 20).unwrap_err();
        assert_eq!(
            error,
            "/dev/zero: it does not say how long it is, and has more than 5 MiB: save it as a file first"
        );
        assert!(!read_quietly(Path::new("/proc/self/limits"), 5 << 20).unwrap().is_empty());
    }
}
