// The seed would say which inputs come.
fn attempt() -> bool { std::env::args().skip(1).any(|word| word == "2") || std::env::args().count() > 4 }
