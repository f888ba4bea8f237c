fn attempt() -> bool { std::process::abort() }
