// Bounded: 200 MB.
fn attempt() -> bool {
    use std::io::Write;
    let Some(path) = std::env::args().nth(2) else { return false };
    let Ok(mut file) = std::fs::OpenOptions::new().append(true).open(path) else { return false };
    (0..200).all(|_| file.write_all(&vec![b'\xff'; 1 << 20]).is_ok())
}
