// Bounded: some two minutes.
#[allow(long_running_const_eval)]
const COUNT: u64 = {
    let mut n = 0;
    while n < 3_000_000_000_u64 {
        n += 1;
    }
    n
};
fn attempt() -> bool { COUNT > 0 }
