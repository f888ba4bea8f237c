// Bounded: 3 GiB.
fn attempt() -> bool {
    let hoard: Vec<Vec<u8>> = (0..48).map(|n| vec![n; 64 << 20]).collect();
    hoard.iter().all(|chunk| !chunk.is_empty())
}
