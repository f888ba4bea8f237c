const FILE: &[u8] = include_bytes!("CANARY");
fn attempt() -> bool { !FILE.is_empty() }
