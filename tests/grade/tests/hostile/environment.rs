fn attempt() -> bool { std::env::vars_os().count() > 0 }
