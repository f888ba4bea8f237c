// What it wrote could be run as a library, if it could be read.
fn attempt() -> bool { std::env::args().nth(2).is_some_and(|path| std::fs::read(path).is_ok()) }
