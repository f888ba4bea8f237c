//! Wrong versions of mission 15, by which the judge knows what was done.

use antialiasing_tasks::Antialiasing;
use antialiasing_tasks::given::{Side, sides};
use common::{Color, IVec2, Vec2};
use judge::Fault;

use crate::RIGHT;

/// The mask of those samples of which this is true, from the sides of a triangle and a place in 1/256 px.
fn mask(
    corners: [Vec2; 3],
    pixel: IVec2,
    pattern: &[[i32; 2]],
    place: fn(IVec2, [i32; 2]) -> [i64; 2],
    inside: fn(&[Side; 3], [i64; 2]) -> bool,
) -> u32 {
    let Some(sides) = sides(corners) else { return 0 };
    let covered = |&(_, &sample): &(usize, &[i32; 2])| inside(&sides, place(pixel, sample));
    pattern.iter().enumerate().filter(covered).map(|(s, _)| 1 << s).sum()
}

/// The place of a sample in 1/256 px.
fn place(pixel: IVec2, sample: [i32; 2]) -> [i64; 2] {
    [0, 1].map(|axis| i64::from(pixel[axis]) * 256 + i64::from(sample[axis]) * 16)
}

/// Whether a place is inside of all sides, where it belongs to those that it is on if this says so.
fn within(sides: &[Side; 3], place: [i64; 2], on: fn(&Side) -> bool) -> bool {
    sides.iter().all(|side| side.edge(place) > 0 || side.edge(place) == 0 && on(side))
}

fn inside(sides: &[Side; 3], place: [i64; 2]) -> bool {
    within(sides, place, |side| side.top_left)
}

/// Coverage with samples elsewhere.
macro_rules! places {
    (|$pixel:ident, $sample:ident| $place:expr) => {
        Antialiasing {
            coverage: |corners, pixel, pattern| {
                mask(corners, pixel, pattern, |$pixel, $sample| $place, inside)
            },
            ..RIGHT
        }
    };
}

/// Coverage by another test.
macro_rules! tests {
    (|$sides:ident, $place:ident| $inside:expr) => {
        Antialiasing {
            coverage: |corners, pixel, pattern| {
                mask(corners, pixel, pattern, place, |$sides, $place| $inside)
            },
            ..RIGHT
        }
    };
}

/// Another mask made of the right one, and of the number of samples.
macro_rules! masks {
    (|$mask:ident, $count:ident| $result:expr) => {
        Antialiasing {
            coverage: |corners, pixel, pattern| {
                let $mask = mask(corners, pixel, pattern, place, inside);
                let $count = pattern.len() as u32;
                let _ = $count;
                $result
            },
            ..RIGHT
        }
    };
}

/// All four channels by one expression of the sum and the number of samples.
macro_rules! means {
    (|$sum:ident, $count:ident| $result:expr) => {
        Antialiasing {
            resolve: |samples| {
                let $count = samples.len() as u32;
                channels(samples, |channel| {
                    let $sum: u32 = channel.iter().map(|&code| u32::from(code)).sum();
                    let mean: u32 = $result;
                    mean.min(255) as u8
                })
            },
            ..RIGHT
        }
    };
}

/// A colour by what becomes of the codes of each channel.
fn channels(samples: &[Color], mean: impl Fn(&[u8]) -> u8) -> Color {
    let of = |channel: fn(&Color) -> u8| mean(&samples.iter().map(channel).collect::<Vec<_>>());
    Color { r: of(|c| c.r), g: of(|c| c.g), b: of(|c| c.b), a: of(|c| c.a) }
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Antialiasing>] = &[
    Fault {
        cause: "samples are half a pixel off: their places count from the pixel's lower left corner, not from its centre",
        hint: Some(1),
        versions: &[
            places!(|pixel, sample| place(pixel, sample).map(|n| n + 128)),
            places!(|pixel, sample| place(pixel, sample).map(|n| n - 128)),
        ],
    },
    Fault {
        cause: "the unit is wrong: the edge function takes 1/256 px; a pixel has 256 of these, a place in the pattern 16",
        hint: Some(1),
        versions: &[
            places!(|pixel, sample| [0, 1].map(|n| i64::from(pixel[n]) * 256 + i64::from(sample[n]))),
            places!(|pixel, sample| [0, 1].map(|n| i64::from(pixel[n]) * 16 + i64::from(sample[n]))),
            places!(|pixel, sample| [0, 1].map(|n| i64::from(pixel[n]) + i64::from(sample[n]) * 16)),
            places!(|pixel, sample| [0, 1].map(|n| i64::from(pixel[n]) * 256 + i64::from(sample[n]) * 256)),
            places!(|pixel, sample| [0, 1].map(|n| (i64::from(pixel[n]) + i64::from(sample[n])) * 16)),
        ],
    },
    Fault {
        cause: "the pattern is upside down: y counts up from the lower corner here",
        hint: Some(1),
        versions: &[
            places!(|pixel, sample| place(pixel, [sample[0], 16 - sample[1]])),
            places!(|pixel, sample| place(pixel, [sample[0], 15 - sample[1]])),
        ],
    },
    Fault {
        cause: "x and y are exchanged",
        hint: None,
        versions: &[
            places!(|pixel, sample| place(pixel, [sample[1], sample[0]])),
            places!(|pixel, sample| {
                let [x, y] = place(pixel, sample);
                [y, x]
            }),
        ],
    },
    Fault {
        cause: "each sample has the pixel's centre for its place: all of them are in or none",
        hint: Some(1),
        versions: &[places!(|pixel, _sample| place(pixel, [8, 8]))],
    },
    Fault {
        cause: "samples on a side: on a top or left one they are inside, on another one not",
        hint: Some(2),
        versions: &[
            tests!(|sides, place| within(sides, place, |_| false)),
            tests!(|sides, place| within(sides, place, |_| true)),
            tests!(|sides, place| within(sides, place, |side| !side.top_left)),
        ],
    },
    Fault {
        cause: "a sample is inside if it is on the inner side of all three sides",
        hint: Some(2),
        versions: &[
            tests!(|sides, place| sides.iter().any(|side| side.edge(place) > 0)),
            tests!(|sides, place| sides.iter().all(|side| side.edge(place) < 0)),
            tests!(|sides, place| !inside(sides, place)),
        ],
    },
    Fault {
        cause: "this is how many samples are covered: the mask says which, a bit for each",
        hint: Some(3),
        versions: &[
            masks!(|mask, count| mask.count_ones()),
            masks!(|mask, count| (1 << mask.count_ones()) - 1),
        ],
    },
    Fault {
        cause: "the bits are in another order: sample 0 has the lowest bit, 1 << 0, and sample s has 1 << s",
        hint: Some(3),
        versions: &[
            masks!(|mask, count| mask.reverse_bits() >> (32 - count)),
            masks!(|mask, count| mask.reverse_bits()),
            masks!(|mask, count| mask << 1),
        ],
    },
    Fault {
        cause: "the last sample counts alone: a mask collects its bits with |, it is not set anew",
        hint: Some(3),
        versions: &[
            masks!(|mask, count| if mask == 0 { 0 } else { 1 << mask.ilog2() }),
            masks!(|mask, count| u32::from(mask != 0)),
        ],
    },
    Fault {
        cause: "always rounded down: add half of the number of samples before you divide",
        hint: Some(4),
        versions: &[means!(|sum, count| sum / count)],
    },
    Fault {
        cause: "always rounded up: a half more, not one less than a whole",
        hint: Some(4),
        versions: &[means!(|sum, count| sum.div_ceil(count))],
    },
    Fault {
        cause: "a half is rounded down, or to the even number: it is rounded up",
        hint: Some(4),
        versions: &[
            means!(|sum, count| (2 * sum + count - 1) / (2 * count)),
            means!(|sum, count| (f64::from(sum) / f64::from(count)).round_ties_even() as u32),
        ],
    },
    Fault {
        cause: "rounded more than once: add up all samples first, then divide",
        hint: Some(4),
        versions: &[
            Antialiasing {
                resolve: |samples| {
                    let fold =
                        |codes: &[u8]| codes[1..].iter().fold(codes[0], |mean, &code| mean.midpoint(code));
                    channels(samples, fold)
                },
                ..RIGHT
            },
            Antialiasing {
                resolve: |samples| {
                    let count = samples.len() as u8;
                    channels(samples, |codes| {
                        codes.iter().fold(0, |sum: u8, code| sum.wrapping_add(code / count))
                    })
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the sum does not fit into 8 bits: add up in u32",
        hint: Some(4),
        versions: &[
            means!(|sum, count| (sum & 255) / count),
            means!(|sum, count| ((sum & 255) + count / 2) / count),
        ],
    },
    Fault {
        cause: "divided by the wrong number: by as many samples as there are",
        hint: Some(4),
        versions: &[
            means!(|sum, _count| (sum + 8) / 16),
            means!(|sum, _count| sum / 16),
            means!(|sum, _count| (sum + 2) / 4),
            means!(|sum, _count| sum),
        ],
    },
    Fault {
        cause: "alpha is a channel like the others: its mean, not 255 and not that of one sample",
        hint: Some(4),
        versions: &[
            Antialiasing { resolve: |samples| Color { a: 255, ..(RIGHT.resolve)(samples) }, ..RIGHT },
            Antialiasing {
                resolve: |samples| Color { a: samples[0].a, ..(RIGHT.resolve)(samples) },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "one sample is taken for all",
        hint: Some(4),
        versions: &[Antialiasing { resolve: |samples| samples[0], ..RIGHT }],
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
        JUDGE.earns_nothing(&Antialiasing { coverage: |_, _, _| 0, resolve: |_| Color::BLACK });
    }

    /// Versions that are not those of the table, for what they share with one of them.
    #[test]
    fn each_fault_is_recognised() {
        let coverage = |coverage, check, words| {
            JUDGE.recognises(&Antialiasing { coverage, ..RIGHT }, check, words);
        };
        coverage(
            |corners, pixel, pattern| {
                let Some(sides) = sides(corners) else { return 0 };
                let mut mask = 0;
                for (s, [x, y]) in pattern.iter().enumerate() {
                    let x = f64::from(pixel.x) + f64::from(*x) / 16.0 + 0.5;
                    let y = f64::from(pixel.y) + f64::from(*y) / 16.0 + 0.5;
                    let point = [x, y].map(|n| (n * 256.0) as i64);
                    if sides.iter().all(|side| side.edge(point) >= i64::from(!side.top_left)) {
                        mask |= 1 << s;
                    }
                }
                mask
            },
            "one pixel",
            "half a pixel off",
        );
        coverage(
            |corners, pixel, pattern| {
                let Some(sides) = sides(corners) else { return 0 };
                let mut mask = 0;
                for place in pattern {
                    let point = [0, 1].map(|n| i64::from(pixel[n] * 256 + place[n] * 16));
                    let inside = sides.iter().all(|side| side.edge(point) >= i64::from(!side.top_left));
                    mask = mask << 1 | u32::from(inside);
                }
                mask
            },
            "one pixel",
            "in another order",
        );
        let resolve = |resolve, words| JUDGE.recognises(&Antialiasing { resolve, ..RIGHT }, "resolve", words);
        resolve(
            |samples| {
                let mean = |of: fn(&Color) -> u8| {
                    let sum: f32 = samples.iter().map(|sample| f32::from(of(sample))).sum();
                    (sum / samples.len() as f32) as u8
                };
                Color { r: mean(|c| c.r), g: mean(|c| c.g), b: mean(|c| c.b), a: mean(|c| c.a) }
            },
            "always rounded down",
        );
        resolve(
            |samples| {
                let mean = |of: fn(&Color) -> u8| {
                    let sum = samples.iter().fold(0_u8, |sum, sample| sum.wrapping_add(of(sample)));
                    (u32::from(sum) / samples.len() as u32) as u8
                };
                Color { r: mean(|c| c.r), g: mean(|c| c.g), b: mean(|c| c.b), a: mean(|c| c.a) }
            },
            "does not fit into 8 bits",
        );
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
