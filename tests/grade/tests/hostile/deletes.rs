fn attempt() -> bool {
    let gone = std::fs::remove_file("CANARY").is_ok() || std::fs::rename("CANARY", "/tmp/canary").is_ok();
    let own = std::env::args().next().unwrap_or_default();
    gone || std::fs::remove_file(own).is_ok() || std::fs::OpenOptions::new().write(true).truncate(true).open("CANARY").is_ok()
}
