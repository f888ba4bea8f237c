fn attempt() -> bool {
    let written = ["CANARY.new", "/tmp/grade-was-here", "here"].iter().any(|path| std::fs::write(path, "x").is_ok());
    written || std::fs::write("CANARY", "x").is_ok() || std::fs::create_dir("CANARY.folder").is_ok()
}
