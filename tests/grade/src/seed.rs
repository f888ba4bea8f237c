//! The seed of a class. Who knew it could know the inputs, so a new one comes from the system's randomness. It is kept
//! beside the reports, so that a regrade asks for the same; no report shows it.

use std::io::ErrorKind;
use std::path::Path;

use anyhow::Context;
use rustix::rand::{GetRandomFlags, getrandom};

use crate::file;

/// Where it is kept.
const SEED: &str = "seed";

/// The seed that is asked for, or else that of an earlier run, or else a new one.
pub(crate) fn of(report: &Path, asked: Option<u64>) -> anyhow::Result<u64> {
    let path = report.join(SEED);
    let seed = match asked {
        Some(seed) => seed,
        None => match std::fs::read_to_string(&path) {
            Ok(text) => {
                let seed = text.trim().parse().ok();
                return seed.with_context(|| format!("{} holds no seed: give --seed", path.display()));
            }
            Err(error) if error.kind() == ErrorKind::NotFound => random()?,
            Err(error) => return Err(error).with_context(|| format!("cannot read {}", path.display())),
        },
    };
    file::write(&path, format!("{seed}\n").as_bytes())?;
    Ok(seed)
}

/// A new one.
pub(crate) fn random() -> anyhow::Result<u64> {
    let mut bytes = [0; 8];
    getrandom(&mut bytes, GetRandomFlags::empty()).context("the system gives no random number")?;
    Ok(u64::from_le_bytes(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_is_made_once_and_kept() {
        let reports = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
        let [first, other] = reports.each_ref().map(|report| of(report.path(), None).unwrap());
        assert_ne!(first, other);
        let report = reports[0].path();
        assert_eq!(of(report, None).unwrap(), first);
        assert_eq!(of(report, Some(7)).unwrap(), 7);
        assert_eq!(of(report, None).unwrap(), 7);
        std::fs::write(report.join(SEED), "seven").unwrap();
        assert!(of(report, None).unwrap_err().to_string().contains("holds no seed"));
        assert_eq!(of(report, Some(8)).unwrap(), 8);
    }
}
