// More answers than questions.
fn attempt() -> bool {
    use std::io::Write;
    let Some(path) = std::env::args().nth(2) else { return false };
    let Ok(mut file) = std::fs::OpenOptions::new().append(true).open(path) else { return false };
    file.write_all("late\n".repeat(1 << 20).as_bytes()).is_err()
}
