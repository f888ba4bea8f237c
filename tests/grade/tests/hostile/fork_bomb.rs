// Bounded: ten children that end at once.
fn attempt() -> bool {
    let own = std::env::args().next().unwrap_or_default();
    let born = |_: &i32| ["/bin/true", own.as_str()].iter().any(|program| {
        std::process::Command::new(program).arg("--help").spawn().is_ok()
    });
    (0..5).filter(born).count() > 0
}
