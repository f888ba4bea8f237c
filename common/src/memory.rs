//! How much memory a model may take.

use std::fs::read_to_string;

/// What is taken to be free where no file below is there, as on other systems than Linux, in bytes.
const UNKNOWN: u64 = 4 << 30;

/// Files in which Linux says how much memory there is, the word in front of the number, and its unit in bytes.
/// See proc(5): what the machine has free for new programs, and the process's own limit. In a container, its limit
/// (the kernel's *Control Group v2*, and the memory controller of version 1). Where there is none, no number follows.
const TOLD: [(&str, &str, u64); 4] = [
    ("/proc/meminfo", "MemAvailable:", 1024),
    ("/proc/self/limits", "Max address space", 1),
    ("/sys/fs/cgroup/memory.max", "", 1),
    ("/sys/fs/cgroup/memory/memory.limit_in_bytes", "", 1),
];

/// Half of the memory that is free, in bytes. The other half is left to what a program makes of a model, and to other
/// programs.
pub(crate) fn half() -> u64 {
    let told = TOLD.iter().filter_map(|&(path, word, unit)| {
        Some(number(&read_to_string(path).ok()?, word)?.saturating_mul(unit))
    });
    told.min().unwrap_or(UNKNOWN) / 2
}

/// The number behind a word that begins a line.
fn number(text: &str, word: &str) -> Option<u64> {
    let behind = text.lines().find_map(|line| line.strip_prefix(word))?;
    behind.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_found_behind_its_word() {
        let meminfo = "MemTotal:       24689764 kB\nMemAvailable:   23012345 kB\n";
        assert_eq!(number(meminfo, "MemAvailable:"), Some(23_012_345));
        assert_eq!(
            number(
                "Max address space         409600000            unlimited            bytes",
                "Max address space"
            ),
            Some(409_600_000)
        );
        assert_eq!(
            number(
                "Max address space         unlimited            unlimited            bytes",
                "Max address space"
            ),
            None
        );
        assert_eq!(number("536870912\n", ""), Some(536_870_912));
        for text in ["max\n", "", "\n"] {
            assert_eq!(number(text, ""), None, "{text:?}");
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn linux_tells_how_much_there_is() {
        assert!((1 << 20..u64::MAX / 4).contains(&half()) && half() != UNKNOWN / 2, "{}", half());
    }
}
