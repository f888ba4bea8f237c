// What the system tells of itself and of its processes, and what it lends for random numbers and for messages.
fn attempt() -> bool {
    let files = ["/proc/self/maps", "/proc/self/cmdline", "/proc/1/cmdline", "/sys/kernel/mm/transparent_hugepage/enabled",
        "/dev/urandom", "/dev/zero", "/dev/tty"];
    files.iter().any(|path| std::fs::File::open(path).is_ok())
        || ["/dev", "/dev/shm", "/sys", "/proc/self/fd", "/var", "/home", "/root"].iter().any(|path| std::fs::read_dir(path).is_ok())
        || std::fs::write("/dev/shm/grade-was-here", "x").is_ok()
}
