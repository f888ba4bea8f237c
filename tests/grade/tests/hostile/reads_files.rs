fn attempt() -> bool {
    ["CANARY", "COURSE/lessons/01-lines/src/lib.rs", "COURSE/tests/lessons/01-lines/tasks/src/lib.rs", "/etc/passwd",
        "/proc/self/environ", "/proc/self/mem", "lib.rs", "COURSE/lessons/01-lines/mission/src/main.rs"]
        .iter().any(|path| std::fs::read(path).is_ok())
        || ["COURSE/tests/lessons/01-lines", "/tmp", "/", "/proc", "."].iter().any(|path| std::fs::read_dir(path).is_ok())
}
