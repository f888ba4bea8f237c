fn attempt() -> bool {
    fn deeper(n: u64) -> u64 { if n == 0 { 0 } else { 1 + std::hint::black_box(deeper(std::hint::black_box(n - 1))) } }
    deeper(1 << 40) > 0
}
