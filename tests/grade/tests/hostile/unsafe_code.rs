unsafe extern "C" { safe fn getpid() -> i32; }
fn attempt() -> bool { getpid() > 0 }
