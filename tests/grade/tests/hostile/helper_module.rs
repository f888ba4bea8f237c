mod helper;
fn attempt() -> bool { helper::attempt() }
