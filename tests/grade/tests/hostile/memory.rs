// Bounded: 2 GiB.
fn attempt() -> bool {
    let hoard = vec![1_u8; 2 << 30];
    std::hint::black_box(hoard).iter().step_by(4096).all(|byte| *byte == 1)
}
