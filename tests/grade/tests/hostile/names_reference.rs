extern crate lines;
fn attempt() -> bool { true }
