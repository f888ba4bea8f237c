//! Each fault stands in the code here and is recognised by its result alone.

use common::{Color, IVec2, Image};
use lines_tasks::Lines;

use judge::Verdict;
use tasks::SEED;

use crate::JUDGE;

#[test]
fn the_reference_earns_ten_points_for_any_seed() {
    JUDGE.check();
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
    let shifted: fn(IVec2, IVec2, &mut Image, Color) = |a, b, image, color| {
        lines::line(a + IVec2::X, b + IVec2::X, image, color);
    };
    check(shifted, "picture", "a pixel too far right");
    check(
        |a, b, image, color| lines::bresenham(a, b, image.bounds(), |x, y, _| image.set(y, x, color)),
        "steep",
        "x and y are swapped",
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
        "gaps",
    );
    // Ends not put in order: half-way, another pixel from either end.
    check(
        |a, b, image, color| {
            let middle = a + b;
            lines::bresenham(a, b, image.bounds(), |x, y, _| image.set(middle.x - x, middle.y - y, color));
        },
        "backward",
        "half-way",
    );
    check(|_, _, _, _| (), "picture", "nothing is drawn");
}
