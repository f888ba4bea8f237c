const SOURCE: &str = include_str!("COURSE/lessons/01-lines/src/bresenham.rs");
fn attempt() -> bool { !SOURCE.is_empty() }
