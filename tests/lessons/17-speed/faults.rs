//! Wrong versions of mission 17, by which the judge knows what was done.

use common::DVec3;
use judge::Fault;
use speed_tasks::Speed;
use speed_tasks::given::Cover;

/// What follows from the least and the greatest values in a block.
fn judged(least: DVec3, most: DVec3, inside: DVec3) -> Cover {
    if most.cmplt(inside).any() {
        Cover::Nothing
    } else if least.cmpge(inside).all() {
        Cover::Whole
    } else {
        Cover::Part
    }
}

/// The least and the greatest values in a block whose last pixel is so many steps from the first.
fn ends(edges: DVec3, right: DVec3, up: DVec3, steps: f64) -> [DVec3; 2] {
    [
        edges + (right.min(DVec3::ZERO) + up.min(DVec3::ZERO)) * steps,
        edges + (right.max(DVec3::ZERO) + up.max(DVec3::ZERO)) * steps,
    ]
}

/// Of these pixels alone, which are so many steps to the right and up.
fn at<const N: usize>([edges, right, up, inside]: [DVec3; 4], steps: [[f64; 2]; N]) -> Cover {
    let values = steps.map(|[x, y]| edges + right * x + up * y);
    let fold = |pick: fn(DVec3, DVec3) -> DVec3| values.into_iter().reduce(pick).unwrap_or(edges);
    judged(fold(DVec3::min), fold(DVec3::max), inside)
}

/// Another way to find the least and the greatest values.
macro_rules! found {
    (|$edges:ident, $right:ident, $up:ident| $ends:expr) => {
        Speed {
            cover: |$edges, $right, $up, inside| {
                let [least, most]: [DVec3; 2] = $ends;
                judged(least, most, inside)
            },
        }
    };
}

/// Another judgement of these.
macro_rules! said {
    (|$least:ident, $most:ident, $inside:ident| $cover:expr) => {
        Speed {
            cover: |edges, right, up, $inside| {
                let [$least, $most] = ends(edges, right, up, 7.0);
                $cover
            },
        }
    };
}

/// Of some pixels alone.
macro_rules! pixels {
    ($steps:expr) => {
        Speed { cover: |edges, right, up, inside| at([edges, right, up, inside], $steps) }
    };
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Speed>] = &[
    Fault {
        cause: "only the lower left pixel is looked at: all four corners of the block count",
        hint: Some(1),
        versions: &[
            pixels!([[0.0, 0.0]]),
            // Outside, it is rejected; inside, it is asked for.
            Speed {
                cover: |edges, _, _, inside| {
                    if edges.cmplt(inside).any() { Cover::Nothing } else { Cover::Part }
                },
            },
        ],
    },
    Fault {
        cause: "only the middle of the block is looked at: an edge function is largest and smallest at its corners",
        hint: Some(1),
        versions: &[pixels!([[3.5, 3.5]]), pixels!([[4.0, 4.0]])],
    },
    Fault {
        cause: "only two opposite corners are looked at: where a side lies decides which of the four counts",
        hint: Some(1),
        versions: &[pixels!([[0.0, 0.0], [7.0, 7.0]]), pixels!([[7.0, 0.0], [0.0, 7.0]])],
    },
    Fault {
        cause: "only the block's first row or its first column is looked at: all four corners of the block count",
        hint: Some(1),
        versions: &[pixels!([[0.0, 0.0], [7.0, 0.0]]), pixels!([[0.0, 0.0], [0.0, 7.0]])],
    },
    Fault {
        cause: "three corners of the four are looked at",
        hint: Some(1),
        versions: &[
            pixels!([[0.0, 0.0], [7.0, 0.0], [0.0, 7.0]]),
            pixels!([[7.0, 7.0], [7.0, 0.0], [0.0, 7.0]]),
        ],
    },
    Fault {
        cause: "the lower left pixel is not always that of the least value: right and up are below 0 where the inside is to the left or below",
        hint: Some(1),
        versions: &[found!(|edges, right, up| [edges, edges + (right + up) * 7.0])],
    },
    Fault {
        cause: "from the first pixel of a block to its last there are seven steps, not eight",
        hint: Some(2),
        versions: &[found!(|edges, right, up| ends(edges, right, up, 8.0))],
    },
    Fault {
        cause: "right and up are what one pixel adds: the block's last pixel is seven steps away",
        hint: Some(2),
        versions: &[
            found!(|edges, right, up| ends(edges, right, up, 1.0)),
            found!(|edges, right, up| ends(edges, right, up, 7.0 * 256.0)),
        ],
    },
    Fault {
        cause: "edges are those of the lower left pixel, not of the middle: the block lies to the right of it and above",
        hint: Some(2),
        versions: &[
            found!(|edges, right, up| {
                let reach = (right.abs() + up.abs()) * 7.0;
                [edges - reach, edges + reach]
            }),
            found!(|edges, right, up| {
                let reach = (right.abs() + up.abs()) * 3.5;
                [edges - reach, edges + reach]
            }),
            found!(|edges, right, up| {
                let reach = (right.abs() + up.abs()) * 4.0;
                [edges - reach, edges + reach]
            }),
        ],
    },
    Fault {
        cause: "a block is said to be outside where one of its corners is: all four must be, of the same side",
        hint: Some(3),
        versions: &[said!(|least, _most, inside| {
            if least.cmplt(inside).any() { Cover::Nothing } else { Cover::Whole }
        })],
    },
    Fault {
        cause: "no corner covered does not mean that nothing is: a triangle may pass between them; all four must be outside of the same side",
        hint: Some(3),
        versions: &[Speed {
            cover: |edges, right, up, inside| {
                let corners = [[0.0, 0.0], [7.0, 0.0], [0.0, 7.0], [7.0, 7.0]];
                let covered = corners.map(|[x, y]| (edges + right * x + up * y).cmpge(inside).all());
                match covered {
                    [false, false, false, false] => Cover::Nothing,
                    [true, true, true, true] => Cover::Whole,
                    _ => Cover::Part,
                }
            },
        }],
    },
    Fault {
        cause: "nothing is rejected: one side that has the block outside is enough",
        hint: Some(3),
        versions: &[said!(|least, _most, inside| {
            if least.cmpge(inside).all() { Cover::Whole } else { Cover::Part }
        })],
    },
    Fault {
        cause: "a block is said to be covered where it is inside of one side: it must be inside of all three",
        hint: Some(4),
        versions: &[said!(|least, most, inside| {
            if most.cmplt(inside).any() {
                Cover::Nothing
            } else if least.cmpge(inside).any() {
                Cover::Whole
            } else {
                Cover::Part
            }
        })],
    },
    Fault {
        cause: "what is not wholly outside is said to be covered: between the two there is Part",
        hint: Some(4),
        versions: &[said!(|_least, most, inside| {
            if most.cmplt(inside).any() { Cover::Nothing } else { Cover::Whole }
        })],
    },
    Fault {
        cause: "nothing is accepted: where the least value of each side is inside the whole block is",
        hint: Some(4),
        versions: &[said!(|_least, most, inside| {
            if most.cmplt(inside).any() { Cover::Nothing } else { Cover::Part }
        })],
    },
    Fault {
        cause: "all blocks are asked pixel by pixel: this draws the right pixels, and saves nothing",
        hint: Some(3),
        versions: &[Speed { cover: |_, _, _, _| Cover::Part }],
    },
    Fault {
        cause: "Nothing and Whole are exchanged: a value is inside where it is large",
        hint: Some(3),
        versions: &[said!(|least, most, inside| match judged(least, most, inside) {
            Cover::Nothing => Cover::Whole,
            Cover::Part => Cover::Part,
            Cover::Whole => Cover::Nothing,
        })],
    },
    Fault {
        cause: "only one side is asked: the loop must go on to the others before it says Whole or Part",
        hint: Some(4),
        versions: &[
            said!(|least, most, inside| judged(
                DVec3::splat(least.x),
                DVec3::splat(most.x),
                DVec3::splat(inside.x)
            )),
            said!(|least, most, inside| judged(
                DVec3::splat(least.z),
                DVec3::splat(most.z),
                DVec3::splat(inside.z)
            )),
        ],
    },
    Fault {
        cause: "a value equal to that of inside is inside: a block is outside where the greatest is less, and covered where the least is no less",
        hint: Some(5),
        versions: &[
            said!(|least, most, inside| judged(least, most, inside + 1.0)),
            said!(|least, most, inside| judged(least, most - 1.0, inside)),
            said!(|least, most, inside| judged(least - 1.0, most, inside)),
            // More than 0 on each side.
            said!(|least, most, _inside| judged(least, most, DVec3::ONE)),
        ],
    },
    Fault {
        cause: "compared with 0: that is inside of top and left sides alone, and inside says of which",
        hint: Some(5),
        versions: &[
            said!(|least, most, _inside| judged(least, most, DVec3::ZERO)),
            said!(|least, most, _inside| judged(least - 1.0, most, DVec3::ZERO)),
            said!(|least, most, _inside| judged(least, most - 1.0, DVec3::ZERO)),
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

    /// Versions that are not those of the table, for what they share with one of them.
    #[test]
    fn each_fault_is_recognised() {
        let cover = |cover, check, words| JUDGE.recognises(&Speed { cover }, check, words);
        cover(
            |edges, right, up, inside| {
                let mut outside = 0;
                let mut within = 0;
                for (x, y) in [(0.0, 0.0), (8.0, 0.0), (0.0, 8.0), (8.0, 8.0)] {
                    let corner = edges + x * right + y * up;
                    outside |= 7 & !corner.cmplt(inside).bitmask();
                    within += u32::from(corner.cmpge(inside).all());
                }
                match (outside, within) {
                    (7, 4) => Cover::Whole,
                    (7, _) => Cover::Part,
                    _ => Cover::Nothing,
                }
            },
            "one side",
            "seven steps, not eight",
        );
        cover(
            |edges, right, up, inside| {
                let corners = [(0.0, 0.0), (7.0, 0.0), (0.0, 7.0), (7.0, 7.0)];
                let covered = |(x, y): &(f64, f64)| (edges + *x * right + *y * up).cmpge(inside).all();
                match corners.iter().filter(|corner| covered(corner)).count() {
                    0 => Cover::Nothing,
                    4 => Cover::Whole,
                    _ => Cover::Part,
                }
            },
            "one side",
            "may pass between them",
        );
        cover(
            |edges, right, up, inside| {
                let mut all = true;
                for side in 0..3 {
                    let corners = [0.0, right[side] * 7.0, up[side] * 7.0, (right[side] + up[side]) * 7.0]
                        .map(|more| edges[side] + more);
                    if corners.iter().all(|&value| value <= inside[side]) {
                        return Cover::Nothing;
                    }
                    all &= corners.iter().all(|&value| value > inside[side]);
                }
                if all { Cover::Whole } else { Cover::Part }
            },
            "on a side",
            "equal to that of inside is inside",
        );
        cover(|_, _, _, _| Cover::Part, "one side", "saves nothing");
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
