//! Wrong versions of mission 14, by which the judge knows what was done.

use blending_tasks::Blending;
use blending_tasks::given::{DepthTest, Kept, StencilOp, StencilTest};
use common::Color;
use judge::Fault;

use crate::RIGHT;

/// Both colours' channels, each by a function of source and destination; alpha by another one.
fn by(
    [source, destination]: [Color; 2],
    channel: impl Fn(u32, u32) -> u32,
    alpha: impl Fn(u32, u32) -> u32,
) -> Color {
    let of = |channel: &dyn Fn(u32, u32) -> u32, a: u8, b: u8| channel(a.into(), b.into()).min(255) as u8;
    Color {
        r: of(&channel, source.r, destination.r),
        g: of(&channel, source.g, destination.g),
        b: of(&channel, source.b, destination.b),
        a: of(&alpha, source.a, destination.a),
    }
}

fn nearest(sum: u32) -> u32 {
    (sum + 127) / 255
}

/// Red, green and blue by an expression of the channels s and d and the source's alpha a; alpha as it should be.
macro_rules! colors {
    (|$s:ident, $d:ident, $a:ident| $result:expr) => {
        Blending {
            over: |source, destination| {
                let $a = u32::from(source.a);
                let color = |$s: u32, $d: u32| -> u32 { $result };
                by([source, destination], color, |s, d| nearest(s * 255 + d * (255 - s)))
            },
            ..RIGHT
        }
    };
}

/// Alpha by an expression of both alphas; the colours as they should be.
macro_rules! alpha {
    (|$s:ident, $d:ident| $result:expr) => {
        Blending {
            over: |source, destination| {
                let a = u32::from(source.a);
                by(
                    [source, destination],
                    |s, d| nearest(s * a + d * (255 - a)),
                    |$s, $d| {
                        let _ = ($s, $d);
                        $result
                    },
                )
            },
            ..RIGHT
        }
    };
}

/// All four by an expression of s, d and a.
macro_rules! all {
    (|$s:ident, $d:ident, $a:ident| $result:expr) => {
        Blending {
            over: |source, destination| {
                let $a = u32::from(source.a);
                let all = |$s: u32, $d: u32| -> u32 { $result };
                by([source, destination], all, all)
            },
            ..RIGHT
        }
    };
}

/// A fragment before its tests, and what is wrong with these.
struct Tests {
    /// The bits compared of the reference, and of the kept value.
    read: [u8; 2],
    /// Whether the reference is on the right.
    stencil_turned: bool,
    /// Whether the fragment's depth is.
    depth_turned: bool,
    /// Which operation is done, after the stencil test and the depth test by itself.
    operation: fn(&StencilTest, bool, bool) -> StencilOp,
    /// On which value, and with which reference.
    operands: fn(&StencilTest, Kept) -> [u8; 2],
    /// What is kept of the old value and the new one.
    write: fn(&StencilTest, u8, u8) -> u8,
    /// Whether the depth is kept.
    keeps: fn(&DepthTest, bool, bool) -> bool,
    /// Whether the fragment passes.
    passes: fn(bool, bool) -> bool,
}

impl Tests {
    /// All as it should be.
    fn right(stencil: &StencilTest) -> Self {
        Self {
            read: [stencil.read_mask; 2],
            stencil_turned: false,
            depth_turned: false,
            operation: |stencil, marked, nearer| match (marked, nearer) {
                (false, _) => stencil.fail,
                (true, false) => stencil.depth_fail,
                (true, true) => stencil.pass,
            },
            operands: |stencil, kept| [kept.stencil, stencil.reference],
            write: |stencil, old, new| old & !stencil.write_mask | new & stencil.write_mask,
            keeps: |depth, marked, nearer| marked && nearer && depth.write,
            passes: |marked, nearer| marked && nearer,
        }
    }

    fn run(self, stencil: &StencilTest, depth: &DepthTest, fragment: f32, kept: Kept) -> (bool, Kept) {
        let (left, right) = (stencil.reference & self.read[0], kept.stencil & self.read[1]);
        let [left, right] = if self.stencil_turned { [right, left] } else { [left, right] };
        let marked = stencil.function.holds(left, right);
        let [front, back] = if self.depth_turned { [kept.depth, fragment] } else { [fragment, kept.depth] };
        let nearer = depth.function.holds(front, back);
        let [stored, reference] = (self.operands)(stencil, kept);
        let new = (self.operation)(stencil, marked, nearer).apply(stored, reference);
        let value = (self.write)(stencil, kept.stencil, new);
        let depth = if (self.keeps)(depth, marked, nearer) { fragment } else { kept.depth };
        ((self.passes)(marked, nearer), Kept { stencil: value, depth })
    }
}

macro_rules! tests {
    ($($field:ident: $value:expr),+) => {
        Blending {
            test: |stencil, depth, fragment, kept| {
                let tests = Tests { $($field: $value,)+ ..Tests::right(stencil) };
                tests.run(stencil, depth, fragment, kept)
            },
            ..RIGHT
        }
    };
    (|$stencil:ident| $field:ident: $value:expr) => {
        Blending {
            test: |$stencil, depth, fragment, kept| {
                Tests { $field: $value, ..Tests::right($stencil) }.run($stencil, depth, fragment, kept)
            },
            ..RIGHT
        }
    };
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Blending>] = &[
    Fault {
        cause: "always rounded down: add half of 255 before you divide",
        hint: Some(1),
        versions: &[
            Blending {
                over: |source, destination| {
                    let a = u32::from(source.a);
                    let channel = |s: u32, d: u32| (s * a + d * (255 - a)) / 255;
                    by([source, destination], channel, |s, d| (s * 255 + d * (255 - s)) / 255)
                },
                ..RIGHT
            },
            colors!(|s, d, a| (s * a + d * (255 - a)) / 255),
        ],
    },
    Fault {
        cause: "divided by 256: white over white is no longer white",
        hint: Some(1),
        versions: &[
            colors!(|s, d, a| (s * a + d * (255 - a)) / 256),
            colors!(|s, d, a| (s * a + d * (255 - a) + 128) / 256),
        ],
    },
    Fault {
        cause: "rounded twice: add the two products first, and round their sum",
        hint: Some(1),
        versions: &[
            colors!(|s, d, a| nearest(s * a) + nearest(d * (255 - a))),
            colors!(|s, d, a| s * a / 255 + d * (255 - a) / 255),
        ],
    },
    Fault {
        cause: "source and destination are exchanged: alpha is the source's share, the rest the destination's",
        hint: Some(2),
        versions: &[
            colors!(|s, d, a| nearest(d * a + s * (255 - a))),
            Blending { over: |source, destination| (RIGHT.over)(destination, source), ..RIGHT },
        ],
    },
    Fault {
        cause: "the source is added whole: it counts with its alpha",
        hint: Some(2),
        versions: &[
            colors!(|s, d, a| s + nearest(d * (255 - a))),
            colors!(|s, d, a| s + d * (255 - a) / 255),
        ],
    },
    Fault {
        cause: "the destination stays whole: the source leaves it 255 − alpha",
        hint: Some(2),
        versions: &[colors!(|s, d, a| nearest(s * a + d * 255))],
    },
    Fault {
        cause: "alpha is blended as a colour is: the source's counts whole here, not times itself",
        hint: Some(2),
        versions: &[all!(|s, d, a| nearest(s * a + d * (255 - a)))],
    },
    Fault {
        cause: "alpha is that of one of the two, or 255: together they cover more than each, and not all",
        hint: Some(2),
        versions: &[
            alpha!(|s, d| s),
            alpha!(|s, d| d),
            alpha!(|s, d| 255),
            alpha!(|s, d| s.max(d)),
            alpha!(|s, d| s + d),
        ],
    },
    Fault {
        cause: "the reference is on the left: `reference less kept`, not the other way round",
        hint: Some(3),
        versions: &[tests!(stencil_turned: true)],
    },
    Fault {
        cause: "the fragment's depth is on the left: `fragment less kept`, not the other way round",
        hint: Some(3),
        versions: &[tests!(depth_turned: true)],
    },
    Fault {
        cause: "all bits are compared: of both numbers only those in the read mask count",
        hint: Some(3),
        versions: &[
            tests!(read: [255, 255]),
            tests!(|stencil| read: [stencil.read_mask, 255]),
            tests!(|stencil| read: [255, stencil.read_mask]),
        ],
    },
    Fault {
        cause: "the write mask is for writing: what is compared is masked with the read mask",
        hint: Some(3),
        versions: &[tests!(|stencil| read: [stencil.write_mask; 2])],
    },
    Fault {
        cause: "all bits are written: those outside of the write mask stay what they were",
        hint: Some(3),
        versions: &[
            tests!(write: |_, _, new| new),
            tests!(write: |stencil, _, new| new & stencil.write_mask),
            tests!(write: |stencil, old, new| old | new & stencil.write_mask),
            tests!(write: |stencil, old, new| old & !stencil.read_mask | new & stencil.read_mask),
        ],
    },
    Fault {
        cause: "the read mask is for reading: the operation is done on the whole value, with the whole reference",
        hint: Some(3),
        versions: &[
            tests!(operands: |stencil, kept| [kept.stencil & stencil.read_mask, stencil.reference]),
            tests!(operands: |stencil, kept| [kept.stencil, stencil.reference & stencil.read_mask]),
            tests!(operands: |stencil, kept| [kept.stencil, stencil.reference].map(|value| value & stencil.read_mask)),
        ],
    },
    Fault {
        cause: "a failed stencil test ends it: `depth_fail` is for what passed that and failed the depth test",
        hint: Some(3),
        versions: &[
            tests!(operation: |stencil, marked, nearer| match (marked, nearer) {
                (_, false) => stencil.depth_fail,
                (false, true) => stencil.fail,
                (true, true) => stencil.pass,
            }),
            tests!(operation: |stencil, marked, nearer| match (marked, nearer) {
                (false, _) => stencil.depth_fail,
                (true, false) => stencil.fail,
                (true, true) => stencil.pass,
            }),
            tests!(operation: |stencil, marked, nearer| if marked && nearer { stencil.pass } else { stencil.fail }),
        ],
    },
    Fault {
        cause: "one of the operations is missing: a fragment that fails a test changes the stencil value, too",
        hint: Some(3),
        versions: &[
            tests!(operation: |stencil, marked, nearer| {
                if marked && nearer { stencil.pass } else { StencilOp::Keep }
            }),
            tests!(operation: |stencil, marked, nearer| match (marked, nearer) {
                (false, _) => stencil.fail,
                (true, false) => StencilOp::Keep,
                (true, true) => stencil.pass,
            }),
            tests!(operation: |stencil, marked, nearer| match (marked, nearer) {
                (false, _) => StencilOp::Keep,
                (true, false) => stencil.depth_fail,
                (true, true) => stencil.pass,
            }),
            tests!(operation: |stencil, marked, nearer| match (marked, nearer) {
                (false, _) => stencil.fail,
                (true, false) => stencil.depth_fail,
                (true, true) => StencilOp::Keep,
            }),
            tests!(operation: |stencil, marked, _| if marked { stencil.pass } else { stencil.fail }),
        ],
    },
    Fault {
        cause: "a depth is kept that should not be: only where both tests pass, and `write` says so",
        hint: Some(3),
        versions: &[
            tests!(keeps: |_, marked, nearer| marked && nearer),
            tests!(keeps: |depth, _, nearer| nearer && depth.write),
            tests!(keeps: |depth, marked, _| marked && depth.write),
            tests!(keeps: |depth, _, _| depth.write),
            tests!(keeps: |_, _, nearer| nearer),
            tests!(keeps: |_, _, _| true),
        ],
    },
    Fault {
        cause: "the fragment's depth is never kept: what is drawn later would not be hidden behind it",
        hint: Some(3),
        versions: &[tests!(keeps: |_, _, _| false)],
    },
    Fault {
        cause: "a fragment is seen only if it passes both tests",
        hint: Some(3),
        versions: &[
            tests!(passes: |_, nearer| nearer),
            tests!(passes: |marked, _| marked),
            tests!(passes: |marked, nearer| marked || nearer),
            tests!(passes: |_, _| true),
        ],
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JUDGE;

    #[test]
    fn the_reference_earns_ten_points_for_any_seed() {
        JUDGE.check();
    }

    #[test]
    fn to_do_nothing_earns_nothing() {
        JUDGE.earns_nothing(&Blending { over: |_, below| below, test: |_, _, _, kept| (false, kept) });
    }

    /// Versions that are not those of the table, for what they share with one of them.
    #[test]
    fn each_fault_is_recognised() {
        let over = |over, check, words| JUDGE.recognises(&Blending { over, ..RIGHT }, check, words);
        // In floats, cut off.
        over(
            |s, d| {
                let a = f64::from(s.a) / 255.0;
                let mix = |s: u8, d: u8| (f64::from(s) * a + f64::from(d) * (1.0 - a) + 1e-9) as u8;
                let alpha = f64::from(s.a) + f64::from(d.a) * (1.0 - a) + 1e-9;
                Color { r: mix(s.r, d.r), g: mix(s.g, d.g), b: mix(s.b, d.b), a: alpha as u8 }
            },
            "products",
            "always rounded down",
        );
        over(
            |s, d| {
                let Color { a, .. } = (RIGHT.over)(s, d);
                let blend = |one: u8, two: u8| {
                    ((u32::from(one) * u32::from(s.a) + u32::from(two) * (255 - u32::from(s.a))) >> 8) as u8
                };
                Color { r: blend(s.r, d.r), g: blend(s.g, d.g), b: blend(s.b, d.b), a }
            },
            "products",
            "divided by 256",
        );
        let test = |test, check, words| JUDGE.recognises(&Blending { test, ..RIGHT }, check, words);
        test(
            |stencil, depth, fragment, kept| {
                let masked = kept.stencil & stencil.read_mask;
                let write = |operation: StencilOp| {
                    let new = operation.apply(kept.stencil, stencil.reference) & stencil.write_mask;
                    Kept { stencil: kept.stencil & !stencil.write_mask | new, ..kept }
                };
                if !stencil.function.holds(masked, stencil.reference & stencil.read_mask) {
                    (false, write(stencil.fail))
                } else if !depth.function.holds(fragment, kept.depth) {
                    (false, write(stencil.depth_fail))
                } else {
                    let depth = if depth.write { fragment } else { kept.depth };
                    (true, Kept { depth, ..write(stencil.pass) })
                }
            },
            "stencil",
            "the reference is on the left",
        );
        test(
            |stencil, depth, fragment, kept| {
                let (passes, after) = (RIGHT.test)(stencil, depth, fragment, kept);
                (passes, if passes { after } else { kept })
            },
            "stencil",
            "one of the operations is missing",
        );
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
