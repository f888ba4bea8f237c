// An answer in small pieces, each of which looks like progress.
fn attempt() -> bool {
    use std::io::Write;
    use std::time::{Duration, Instant};
    let Some(path) = std::env::args().nth(2) else { return false };
    let Ok(mut file) = std::fs::OpenOptions::new().append(true).open(path) else { return false };
    for _ in 0..300 {
        let _ = file.write_all(b"p");
        let since = Instant::now();
        while since.elapsed() < Duration::from_millis(200) {}
    }
    true
}
