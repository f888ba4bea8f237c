fn attempt() -> bool { panic!("{}", "too long ".repeat(5 << 20)) }
