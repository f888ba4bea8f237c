fn attempt() -> bool {
    ["/etc/passwd", "CANARY", "COURSE", "/tmp", "/"].iter().map(std::path::Path::new).any(|path| {
        path.exists() || path.is_dir() || path.metadata().is_ok() || path.symlink_metadata().is_ok()
    }) || std::env::current_dir().is_ok()
}
