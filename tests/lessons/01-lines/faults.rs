//! Wrong versions of mission 1, by which the judge knows what was done.

use common::{Color, IVec2, Image};
use judge::Fault;
use lines_tasks::Lines;

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Lines>] = &[
    Fault {
        cause: "the pixel at an end is missing: both ends belong to the segment, so the range is a..=b",
        hint: None,
        versions: &[
            Lines { line: |a, b, image, color| plot(image, color, but(b, right(a, b))) },
            Lines { line: |a, b, image, color| plot(image, color, but(ordered(a, b)[1], right(a, b))) },
            Lines { line: |a, b, image, color| plot(image, color, but(a, right(a, b))) },
        ],
    },
    Fault {
        cause: "it walks along x alone: a steep line needs a pixel in each row, so swap x and y there",
        hint: Some(1),
        versions: &[
            Lines {
                line: |a, b, image, color| {
                    let [a, b] = if a.x < b.x { [a, b] } else { [b, a] };
                    lines::slides::per_column(a, b, image.bounds(), |x, y, _| image.set(x, y, color));
                },
            },
            // One row a column, at most.
            Lines {
                line: |a, b, image, color| {
                    let [a, b] = if a.x <= b.x { [a, b] } else { [b, a] };
                    if is_steep(a, b) {
                        let step = IVec2::new(1, (b - a).y.signum());
                        plot(image, color, (0..=(b - a).x).map(|n| a + step * n));
                    } else {
                        plot(image, color, right(a, b));
                    }
                },
            },
        ],
    },
    Fault {
        cause: "a steep line is plotted with x and y swapped: swap them back when you colour the pixel",
        hint: Some(1),
        versions: &[Lines {
            line: |a, b, image, color| {
                let back = |p: IVec2| if is_steep(a, b) { IVec2::new(p.y, p.x) } else { p };
                plot(image, color, right(a, b).map(back));
            },
        }],
    },
    Fault {
        cause: "every pixel is coloured at (y, x): image.set takes x first",
        hint: None,
        versions: &[Lines {
            line: |a, b, image, color| plot(image, color, right(a, b).map(|p| IVec2::new(p.y, p.x))),
        }],
    },
    Fault {
        cause: "it only ever moves up: where the line falls, the step across is -1",
        hint: None,
        versions: &[Lines {
            line: |a, b, image, color| {
                let [a, b] = ordered(a, b);
                let up = |p: IVec2| {
                    if is_steep(a, b) {
                        IVec2::new(a.x + (p.x - a.x).abs(), p.y)
                    } else {
                        IVec2::new(p.x, a.y + (p.y - a.y).abs())
                    }
                };
                plot(image, color, steps(a, b, 0).map(up));
            },
        }],
    },
    Fault {
        cause: "the fraction is cut off: the pixel is the nearest one, so start with an error of -length, not 0 and \
                not -2 * length",
        hint: Some(2),
        versions: &[
            Lines { line: |a, b, image, color| plot(image, color, cut_off(a, b, false)) },
            Lines { line: |a, b, image, color| plot(image, color, cut_off(a, b, true)) },
            Lines {
                line: |a, b, image, color| {
                    let [a, b] = ordered(a, b);
                    plot(image, color, steps(a, b, length(a, b)));
                },
            },
            Lines {
                line: |a, b, image, color| {
                    let [a, b] = ordered(a, b);
                    plot(image, color, steps(a, b, -length(a, b)));
                },
            },
        ],
    },
    Fault {
        cause: "it steps before it plots: colour the pixel first, then add to the error",
        hint: Some(2),
        versions: &[Lines {
            line: |a, b, image, color| {
                let [a, b] = ordered(a, b);
                lines::slides::listing(a, b, image.bounds(), |x, y, _| image.set(x, y, color));
            },
        }],
    },
    Fault {
        cause: "a line to the left, or down, is not drawn: put the ends in order before the loop",
        hint: Some(3),
        versions: &[Lines {
            line: |a, b, image, color| {
                if ordered(a, b) == [a, b] {
                    lines::line(a, b, image, color);
                }
            },
        }],
    },
    Fault {
        cause: "the ends are not put in order: half-way between two pixels, b to a takes another one than a to b",
        hint: Some(3),
        versions: &[Lines { line: |a, b, image, color| plot(image, color, steps(a, b, 0)) }],
    },
    Fault {
        cause: "half-way between two pixels it moves across: stay, step only when the error is > 0, not >= 0",
        hint: Some(3),
        versions: &[
            Lines {
                line: |a, b, image, color| {
                    let [a, b] = ordered(a, b);
                    plot(image, color, steps(a, b, -1));
                },
            },
            Lines { line: |a, b, image, color| plot(image, color, steps(a, b, -1)) },
        ],
    },
    Fault {
        cause: "it is computed in f32, which is too coarse for far ends: use whole numbers, or f64",
        hint: None,
        versions: &[Lines {
            line: |a, b, image, color| {
                let [a, b] = ordered(a, b);
                let step = (b - a).as_vec2() / (b - a).abs().max_element().max(1) as f32;
                plot(image, color, near(a, b).map(|n| (a.as_vec2() + step * n as f32).round().as_ivec2()));
            },
        }],
    },
    Fault {
        cause: "it is upside down: y points up, row 0 is the lowest",
        hint: None,
        versions: &[Lines {
            line: |a, b, image, color| {
                let top = image.height() - 1;
                plot(image, color, right(a, b).map(|p| IVec2::new(p.x, top - p.y)));
            },
        }],
    },
    Fault {
        cause: "the colour is always white: use the one that is given",
        hint: None,
        versions: &[Lines { line: |a, b, image, _| lines::line(a, b, image, Color::WHITE) }],
    },
];

fn plot(image: &mut Image, color: Color, pixels: impl Iterator<Item = IVec2>) {
    pixels.for_each(|p| image.set(p.x, p.y, color));
}

fn is_steep(a: IVec2, b: IVec2) -> bool {
    (b - a).x.abs() < (b - a).y.abs()
}

/// Along the longer side.
fn length(a: IVec2, b: IVec2) -> i64 {
    i64::from((b - a).abs().max_element())
}

fn ordered(a: IVec2, b: IVec2) -> [IVec2; 2] {
    let forward = if is_steep(a, b) { a.y < b.y } else { a.x < b.x };
    if forward { [a, b] } else { [b, a] }
}

/// The right pixels.
fn right(a: IVec2, b: IVec2) -> impl Iterator<Item = IVec2> {
    let [a, b] = ordered(a, b);
    steps(a, b, 0)
}

fn but(left_out: IVec2, pixels: impl Iterator<Item = IVec2>) -> impl Iterator<Item = IVec2> {
    pixels.filter(move |&p| p != left_out)
}

/// The steps from `a` to `b` that may be in a picture: a far end is millions of them away.
fn near(a: IVec2, b: IVec2) -> impl Iterator<Item = i64> {
    const SIDE: i64 = 1000;
    let [a, b] = [a, b].map(|p| i64::from(if is_steep(a, b) { p.y } else { p.x }));
    let range = if a < b { (-SIDE - a, SIDE - a) } else { (a - SIDE, a + SIDE) };
    range.0.max(0)..=range.1.min((b - a).abs())
}

/// From `a` to `b`, moving across when the error is above a limit: 0 is right.
fn steps(a: IVec2, b: IVec2, limit: i64) -> impl Iterator<Item = IVec2> {
    let size = (b - a).abs();
    let (length, rise) = (i64::from(size.max_element()), i64::from(size.min_element()));
    let along = if is_steep(a, b) { IVec2::Y } else { IVec2::X } * (b - a).signum();
    let across = (b - a).signum() - along;
    near(a, b).map(move |n| {
        // The error -length + n * 2 * rise, less 2 * length for each move across, is not above the limit.
        let over = 2 * rise * n - length - limit;
        let moves = (over + 2 * length - 1).div_euclid((2 * length).max(1)).max(0);
        a + along * n as i32 + across * moves as i32
    })
}

/// The pixel in which the line is, not the nearest one: below it, or on the side of the first end.
fn cut_off(a: IVec2, b: IVec2, floor: bool) -> impl Iterator<Item = IVec2> {
    let [a, b] = ordered(a, b);
    let [x, y] = (b - a).to_array().map(i64::from);
    let length = x.abs().max(y.abs()).max(1);
    let part = move |n: i64, whole: i64| {
        (if floor { (n * whole).div_euclid(length) } else { n * whole / length }) as i32
    };
    near(a, b).map(move |n| a + IVec2::new(part(n, x), part(n, y)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JUDGE;
    use judge::Verdict;
    use tasks::SEED;

    #[test]
    fn the_reference_earns_ten_points_for_any_seed() {
        JUDGE.check();
    }

    #[test]
    fn to_do_nothing_earns_nothing() {
        JUDGE.earns_nothing(&Lines { line: |_, _, _, _| () });
    }

    /// Other seeds make other inputs, so that a picture learnt by heart earns the picture's points at most.
    #[test]
    fn inputs_come_from_the_seed() {
        let inputs = |seed| -> Vec<String> {
            JUDGE.key(seed).into_iter().flat_map(|sheet| sheet.questions).map(|asked| asked.input).collect()
        };
        assert_eq!(inputs(1), inputs(1));
        assert_ne!(inputs(1), inputs(2));
        let only_picture = Lines {
            line: |a, b, image, color| {
                if image.width() == 100 {
                    lines::line(a, b, image, color);
                }
            },
        };
        let earned: u32 = JUDGE.verdicts(&only_picture, SEED).iter().map(Verdict::earned).sum();
        assert_eq!(earned, 2);
    }

    #[test]
    fn each_fault_is_recognised() {
        let check = |line, check, words| JUDGE.recognises(&Lines { line }, check, words);
        let upside_down: fn(IVec2, IVec2, &mut Image, Color) = |a, b, image, color| {
            let top = image.height() - 1;
            lines::bresenham(a, b, image.bounds(), |x, y, _| image.set(x, top - y, color));
        };
        check(upside_down, "picture", "upside down");
        check(upside_down, "gentle", "upside down");
        check(
            |a, b, image, color| lines::bresenham(a, b, image.bounds(), |x, y, _| image.set(y, x, color)),
            "steep",
            "at (y, x)",
        );
        let one_short: fn(IVec2, IVec2, &mut Image, Color) = |a, b, image, color| {
            lines::bresenham(a, b, image.bounds(), |x, y, _| {
                if (x, y) != (b.x, b.y) {
                    image.set(x, y, color);
                }
            });
        };
        check(one_short, "gentle", "the pixel at an end is missing");
        check(one_short, "backward", "the pixel at an end is missing");
        check(
            |a, b, image, color| {
                let [a, b] = if a.x < b.x { [a, b] } else { [b, a] };
                lines::slides::per_column(a, b, image.bounds(), |x, y, _| image.set(x, y, color));
            },
            "steep",
            "along x alone",
        );
        // Ends not put in order: half-way, another pixel from either end.
        check(
            |a, b, image, color| {
                let middle = a + b;
                lines::bresenham(a, b, image.bounds(), |x, y, _| {
                    image.set(middle.x - x, middle.y - y, color);
                });
            },
            "halves",
            "half-way",
        );
    }

    #[test]
    fn each_is_named_by_what_it_draws() {
        JUDGE.check_faults();
    }

    /// What is wrong is told, but no cause, where no known fault draws the same: nothing at all, or something that
    /// half of the answers show.
    #[test]
    fn no_cause_is_made_up() {
        let shifted =
            Lines { line: |a, b, image, color| lines::line(a + IVec2::X, b + IVec2::X, image, color) };
        for line in [Lines { line: |_, _, _, _| () }, shifted] {
            for verdict in JUDGE.verdicts(&line, SEED) {
                assert!(!verdict.wrong.is_empty() && verdict.cause.is_none(), "{verdict:?}");
            }
        }
    }
}
