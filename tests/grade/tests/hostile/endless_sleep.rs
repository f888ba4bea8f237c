// Bounded: some twenty seconds, if each sleep is over at once.
fn attempt() -> bool {
    (0..1_u64 << 27).for_each(|_| std::thread::sleep(std::time::Duration::from_secs(1)));
    true
}
