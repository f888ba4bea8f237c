// Bounded: a hundred threads for two seconds.
fn attempt() -> bool {
    let sleep = || std::thread::sleep(std::time::Duration::from_secs(2));
    (0..100).filter(|_| std::thread::Builder::new().spawn(sleep).is_ok()).count() > 0
}
