//! What blending costs: `cargo bench -p blending-tests`, single-threaded.
//!
//! | group | what is compared | at |
//! |---|---|---|
//! | `division` | each way to divide by 255 | 65,536 products |

use std::hint::black_box;

use blending::METHODS;
use criterion::{Criterion, criterion_group, criterion_main};

fn division(c: &mut Criterion) {
    let mut group = c.benchmark_group("division");
    for row in METHODS {
        group.bench_function(row.name, |b| b.iter(|| (row.run.mix)(black_box(200), 100, 50)));
    }
}

criterion_group!(benches, division);
criterion_main!(benches);
