// Bounded: 200 MB.
fn attempt() -> bool {
    let line = "x".repeat(1 << 20);
    for _ in 0..100 {
        println!("{line}");
        eprintln!("{line}");
    }
    true
}
