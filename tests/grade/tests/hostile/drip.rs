// An answer in small pieces, each of which looks like progress.
fn attempt() -> bool {
    use std::io::Write;
    let Some(path) = std::env::args().nth(2) else { return false };
    let Ok(mut file) = std::fs::OpenOptions::new().append(true).open(path) else { return false };
    for _ in 0..300 {
        let _ = file.write_all(b"p");
        (0..1_u64 << 28).for_each(|n| {
            std::hint::black_box(n);
        });
    }
    true
}
