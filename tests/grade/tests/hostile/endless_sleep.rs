fn attempt() -> bool {
    std::thread::sleep(std::time::Duration::from_secs(30));
    true
}
