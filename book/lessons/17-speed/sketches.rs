//! Chapter 17's line drawings.

use std::path::Path;

use anyhow::Context;
use common::{Bounds, Color, DVec3, IVec2, Vec2};
use speed::blocks::{Cover, SIDE, cover};
use triangles::edges::Setup;
use triangles::fill;

use super::figures::{SIZE, flat, seen, windows};
use crate::figures::Drawing;
use crate::figures::sheet::{
    AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, MINT, ORANGE, PALE, PURPLE, ROSE, SKY, Sheet,
};

/// The pixels from (0, 0) on, so many columns and rows.
fn pixels_of(width: i32, height: i32) -> Bounds {
    Bounds { min: IVec2::ZERO, max: IVec2::new(width, height) - 1 }
}

/// The example's edge function at the pixel (i, j) of its block of four by four.
pub(super) fn example(i: i32, j: i32) -> i32 {
    -3 + 4 * i + 5 * j
}

pub(super) fn corners() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.6, -0.3), (6.6, 4.3));
    for (x, y) in (0..4).flat_map(|y| (0..4).map(move |x| (x, y))) {
        let value = example(x, y);
        sheet.pixel(x, y, if value >= 0 { SKY } else { PALE });
        let at = Vec2::new(x as f32, y as f32) + 0.5;
        let is_corner = [x, y].iter().all(|side| [0, 3].contains(side));
        let text = value.to_string().replace('-', "−");
        sheet.text(at, &text, if is_corner { BLACK } else { GREY });
        if is_corner {
            sheet.rectangle(at - 0.42, at + 0.42, "none", BLUE);
        }
    }
    // Where it is 0: 4 i + 5 j = 3, counted from the centres.
    let zero = |j: f32| Vec2::new((3.0 - 5.0 * j) / 4.0 + 0.5, j + 0.5);
    sheet.line(zero(-0.75), zero(1.2), ORANGE, 2.4);
    sheet.arrow((4.3, 0.5), (5.3, 0.5), BLACK);
    sheet.text_right_of((5.4, 0.5), "+ 4", BLACK);
    sheet.arrow((4.3, 1.0), (4.3, 2.0), BLACK);
    sheet.text_right_of((4.5, 1.8), "+ 5", BLACK);
    sheet.text_left_of((-0.2, 0.5), "least", BLUE);
    sheet.text_right_of((4.2, 3.5), "most", BLUE);
    sheet.finish()
}

pub(super) fn blocks() -> anyhow::Result<Drawing> {
    const WIDTH: i32 = 96;
    const HEIGHT: i32 = 72;
    let corners = [Vec2::new(5.0, 9.0), Vec2::new(90.0, 22.0), Vec2::new(38.0, 68.0)];
    let bounds = pixels_of(WIDTH, HEIGHT);
    let mut sheet = Sheet::new((0.0, 0.0), (WIDTH as f32, HEIGHT as f32));
    let setup = Setup::new(corners, bounds).context("it has an area")?;
    let at = |x: i32, y: i32| {
        let from = IVec2::new(x, y) - setup.bounds.min;
        setup.edges + setup.right * f64::from(from.x) + setup.up * f64::from(from.y)
    };
    let mut covered = Vec::new();
    fill(corners, bounds, |x, y, _| covered.push((x, y)));
    for y in (0..HEIGHT).step_by(SIDE as usize) {
        for x in (0..WIDTH).step_by(SIDE as usize) {
            let which = cover(at(x, y), setup.right, setup.up, setup.inside);
            let ink = match which {
                Cover::Nothing => PALE,
                Cover::Whole => SKY,
                Cover::Part => AMBER,
            };
            let corner = Vec2::new(x as f32, y as f32);
            sheet.rectangle(corner, corner + SIDE as f32, ink, GREY);
            if which == Cover::Part {
                let in_block = |&&(i, j): &&(i32, i32)| i / SIDE == x / SIDE && j / SIDE == y / SIDE;
                for &(i, j) in covered.iter().filter(in_block) {
                    let low = Vec2::new(i as f32, j as f32);
                    sheet.rectangle(low + 0.1, low + 0.9, ORANGE, "none");
                }
            }
        }
    }
    sheet.polygon(&corners, "none", BLACK);
    sheet.finish()
}

/// Groups of eight pixels of a row from some column on, and those of them that a triangle covers.
fn rows_of_eight(sheet: &mut Sheet, corners: [Vec2; 3], shift: Vec2, groups: impl Fn(i32) -> i32) {
    let mut covered = Vec::new();
    fill(corners, pixels_of(64, 64), |x, y, _| covered.push((x, y)));
    let mut all: Vec<(i32, i32)> = covered.iter().map(|&(x, y)| (groups(x), y)).collect();
    all.sort_unstable();
    all.dedup();
    for (left, y) in all {
        for x in left..left + 8 {
            let low = Vec2::new(x as f32, y as f32) + shift;
            let ink = if covered.contains(&(x, y)) { BLUE } else { FAINT };
            sheet.rectangle(low + 0.06, low + 0.94, ink, "none");
        }
        let low = Vec2::new(left as f32, y as f32) + shift;
        sheet.rectangle(low, low + Vec2::new(8.0, 1.0), "none", GREY);
    }
    sheet.polygon(&corners.map(|corner| corner + shift), "none", ORANGE);
}

pub(super) fn lanes() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((0.0, 0.0), (48.0, 26.0));
    let large = [Vec2::new(1.0, 1.5), Vec2::new(31.0, 5.0), Vec2::new(12.0, 24.5)];
    rows_of_eight(&mut sheet, large, Vec2::ZERO, |x| x / 8 * 8);
    let small = [Vec2::new(0.3, 0.4), Vec2::new(4.2, 1.6), Vec2::new(1.4, 4.4)];
    rows_of_eight(&mut sheet, small, Vec2::new(36.0, 3.0), |_| 0);
    sheet.finish()
}

pub(super) fn order() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((0.0, 0.0), (22.0, 9.4));
    let numbers = [1.0e8_f32, 3.0, 3.0, 2.0];
    let words = ["10⁸", "3", "3", "2"];
    let [a, b, c, d] = numbers;
    let leaning = ((a + b) + c) + d;
    let balanced = (a + b) + (c + d);
    let exact = numbers.into_iter().map(f64::from).sum::<f64>();
    let node = |sheet: &mut Sheet, at: Vec2, words: &str, ink: Ink| {
        sheet.labelled(at, (if words.chars().count() > 3 { 2.5 } else { 0.9 }, 0.65), ink, words);
    };
    let number = |x: f32| -> String {
        let text = format!("{}", f64::from(x));
        let (head, tail) = text.split_at(text.len().saturating_sub(3));
        let (first, middle) = head.split_at(head.len().saturating_sub(3));
        format!("{first},{middle},{tail}")
    };
    for (left, balanced_tree, sum) in [(0.0, false, leaning), (11.5, true, balanced)] {
        let at = |x: f32, y: f32| Vec2::new(left + x, y);
        let leaves = [1.3, 4.0, 6.7, 9.4].map(|x| at(x, 8.4));
        let joins = if balanced_tree {
            vec![
                (leaves[0], leaves[1], at(2.6, 5.2)),
                (leaves[2], leaves[3], at(8.0, 5.2)),
                (at(2.6, 5.2), at(8.0, 5.2), at(5.3, 2.6)),
            ]
        } else {
            vec![
                (leaves[0], leaves[1], at(2.6, 6.4)),
                (at(2.6, 6.4), leaves[2], at(4.0, 4.5)),
                (at(4.0, 4.5), leaves[3], at(5.3, 2.6)),
            ]
        };
        for (one, other, to) in &joins {
            sheet.line(*one, *to, GREY, 1.6);
            sheet.line(*other, *to, GREY, 1.6);
        }
        for (_, _, to) in &joins {
            node(&mut sheet, *to, "+", MINT);
        }
        for (leaf, word) in leaves.iter().zip(words) {
            node(&mut sheet, *leaf, word, SKY);
        }
        sheet.text(at(5.3, 0.9), &number(sum), if f64::from(sum) == exact { GREEN } else { ORANGE });
    }
    sheet.finish()
}

/// How many of the default picture's triangles reach into each tile of that side, in rows from the bottom, and how many tiles
/// there are in a row.
pub(super) fn by_tile(side: i32) -> anyhow::Result<(usize, Vec<usize>)> {
    let across = ((i32::from(SIZE) + side - 1) / side) as usize;
    let mut counts = vec![0; across * across];
    for corners in windows(SIZE)? {
        let Some(setup) = Setup::new(flat(corners), pixels_of(SIZE.into(), SIZE.into())) else { continue };
        let (first, last) = (setup.bounds.min / side, setup.bounds.max / side);
        for y in first.y..=last.y {
            for x in first.x..=last.x {
                counts[y as usize * across + x as usize] += 1;
            }
        }
    }
    Ok((across, counts))
}

pub(super) fn tiles() -> anyhow::Result<Drawing> {
    let (across, counts) = by_tile(64)?;
    let whole = f32::from(SIZE) / 64.0;
    let mut sheet = Sheet::new((0.0, 0.0), (whole, whole));
    for (n, &count) in counts.iter().enumerate() {
        let low = Vec2::new((n % across) as f32, (n / across) as f32);
        let high = (low + 1.0).min(Vec2::splat(whole));
        let ink = match count {
            0 => PALE,
            1..=9 => SKY,
            10..=99 => MINT,
            100..=299 => AMBER,
            _ => ROSE,
        };
        sheet.rectangle(low, high, ink, GREY);
        if high.y - low.y > 0.9 && high.x - low.x > 0.9 && count > 0 {
            sheet.text((low + high) / 2.0, &count.to_string(), BLACK);
        }
    }
    sheet.finish()
}

pub(super) fn groups() -> anyhow::Result<Drawing> {
    const ROWS: i32 = 6;
    let image = seen(SIZE)?;
    // About the eye, where triangles are small.
    let (left, bottom) = (216, 536);
    let mut sheet = Sheet::new((0.0, 0.0), (15.5, 6.6));
    let mut known: Vec<Color> = Vec::new();
    let inks = [SKY, AMBER, MINT, ROSE, PALE, FAINT];
    for y in 0..ROWS {
        let mut in_row: Vec<usize> = Vec::new();
        for x in 0..8 {
            let color = image.get(left + x, bottom + y).context("it is in the picture")?;
            let n = known.iter().position(|other| *other == color).unwrap_or_else(|| {
                known.push(color);
                known.len() - 1
            });
            if !in_row.contains(&n) {
                in_row.push(n);
            }
            sheet.pixel(x, y, inks[n % inks.len()]);
            let at = Vec2::new(x as f32, y as f32) + 0.5;
            sheet.text(at, &(n + 1).to_string(), BLACK);
        }
        let words =
            if in_row.len() == 1 { "1 triangle".into() } else { format!("{} triangles", in_row.len()) };
        sheet.text_right_of((8.4, y as f32 + 0.5), &words, GREY);
    }
    sheet.finish()
}

/// What each tile of the default picture takes, roughly: a piece for each triangle in it, and one for each pixel of its own.
fn costs() -> anyhow::Result<Vec<f32>> {
    let (_, counts) = by_tile(64)?;
    Ok(counts.iter().map(|&count| count as f32 * 40.0 + if count > 0 { 4096.0 } else { 0.0 }).collect())
}

pub(super) fn schedule() -> anyhow::Result<Drawing> {
    let costs = costs()?;
    let whole: f32 = costs.iter().sum();
    let mut sheet = Sheet::new((-13.0, -0.4), (70.0, 25.2));
    let length = |cost: f32| cost / whole * 100.0;
    let mut bar = |y: f32, from: f32, cost: f32, ink: Ink| {
        sheet.rectangle((from, y), (from + length(cost), y + 3.2), ink, BLACK);
        from + length(cost)
    };
    // One half of the tiles each, the lower one and the upper one.
    let middle = costs.len() / 2;
    for (n, half) in [&costs[..middle], &costs[middle..]].into_iter().enumerate() {
        half.iter().fold(0.0, |from, &cost| {
            bar(19.0 - 4.4 * n as f32, from, cost, if n == 0 { SKY } else { AMBER })
        });
    }
    // The next one for whoever is free.
    let mut free = [0.0_f32; 2];
    for &cost in &costs {
        let n = usize::from(free[1] < free[0]);
        free[n] = bar(7.0 - 4.4 * n as f32, free[n], cost, if n == 0 { SKY } else { AMBER });
    }
    for (y, words) in [(20.6, "thread 1"), (16.2, "thread 2"), (8.6, "thread 1"), (4.2, "thread 2")] {
        sheet.text_left_of((-0.8, y), words, BLACK);
    }
    sheet.text_right_of((0.0, 23.9), "each its half of the tiles", GREY);
    sheet.text_right_of((0.0, 12.0), "each the next tile when it is free", GREY);
    sheet.arrow((0.0, 0.8), (66.0, 0.8), GREY);
    sheet.text_left_of((-0.8, 0.8), "time", GREY);
    sheet.finish()
}

/// How many times as fast so many threads are, where that share of the work is not shared out.
pub(super) fn faster(serial: f32, threads: f32) -> f32 {
    1.0 / (serial + (1.0 - serial) / threads)
}

pub(super) fn amdahl() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.6, -1.6), (21.0, 13.0));
    sheet.axes((0.0, 0.0), (0.0, 0.0), (17.0, 12.4), 1.4);
    for threads in [1, 4, 8, 12, 16] {
        sheet.text((threads as f32, -0.8), &threads.to_string(), GREY);
    }
    for times in [4, 8, 12] {
        sheet.text_left_of((-0.3, times as f32), &times.to_string(), GREY);
        sheet.line((0.0, times as f32), (16.5, times as f32), FAINT, 1.0);
    }
    for (serial, words, ink) in
        [(0.0, "0", GREY), (0.05, "5 %", BLUE), (0.1, "10 %", GREEN), (0.2, "20 %", ORANGE)]
    {
        let last = if serial == 0.0 { 12.0 } else { 16.0 };
        let points = (0..=60).map(|n| 1.0 + (last - 1.0) * n as f32 / 60.0);
        sheet.polyline(points.map(|threads| Vec2::new(threads, faster(serial, threads))), ink, 2.4);
        sheet.text_right_of((last + 0.4, faster(serial, last)), words, ink);
    }
    sheet.text((8.5, -1.5), "threads", GREY);
    sheet.text_right_of((0.3, 12.6), "times as fast", GREY);
    sheet.finish()
}

pub(super) fn middles() -> anyhow::Result<Drawing> {
    const WIDTH: i32 = 48;
    let corners = [Vec2::new(4.0, 5.0), Vec2::new(44.0, 12.0), Vec2::new(16.0, 43.0)];
    let bounds = pixels_of(WIDTH, WIDTH);
    let mut sheet = Sheet::new((0.0, 0.0), (2.0 * WIDTH as f32 + 4.0, WIDTH as f32));
    fill(corners, bounds, |x, y, _| {
        sheet.rectangle((x as f32, y as f32), (x as f32 + 1.0, y as f32 + 1.0), BLUE, "none");
    });
    let setup = Setup::new(corners, bounds).context("it has an area")?;
    let at = |x: i32, y: i32| -> DVec3 {
        let from = IVec2::new(x, y) - setup.bounds.min;
        setup.edges + setup.right * f64::from(from.x) + setup.up * f64::from(from.y)
    };
    let shift = WIDTH as f32 + 4.0;
    for y in (0..WIDTH).step_by(SIDE as usize) {
        for x in (0..WIDTH).step_by(SIDE as usize) {
            if at(x + SIDE / 2, y + SIDE / 2).cmpge(setup.inside).all() {
                let low = Vec2::new(shift + x as f32, y as f32);
                sheet.rectangle(low, low + SIDE as f32, BLUE, "none");
            }
        }
    }
    for left in [0.0, shift] {
        sheet.polygon(&corners.map(|corner| corner + Vec2::X * left), "none", ORANGE);
    }
    sheet.finish()
}

/// The rows of the table that is measured for the roofline: a name, operations and bytes, and millions of operations or bytes a
/// second.
pub(super) fn measured() -> anyhow::Result<Vec<(String, [f64; 3])>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../pages/charts/17-speed-roofline.csv");
    let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let row = |line: &str| -> anyhow::Result<(String, [f64; 3])> {
        let mut cells = line.split(',');
        let name = cells.next().unwrap_or_default().to_string();
        let mut number = || -> anyhow::Result<f64> { Ok(cells.next().context("a row is short")?.parse()?) };
        Ok((name, [number()?, number()?, number()?]))
    };
    text.lines().skip(1).map(row).collect()
}

pub(super) fn roofline() -> anyhow::Result<Drawing> {
    let rows = measured()?;
    let of = |name: &str| rows.iter().find(|row| row.0 == name).map(|row| row.1).context("the table has it");
    // Gigabytes and billions of operations a second.
    let (memory, core) = (of("memory")?[2] / 1000.0, of("core")?[2] / 1000.0);
    let (low, high) = (Vec2::new(1.0_f64.log2() as f32, 0.0), Vec2::new(9.0, (core.log2() + 0.8) as f32));
    let (wide, tall) = (high.x - low.x, high.y - low.y);
    let mut sheet = Sheet::new((low.x - 0.12 * wide, low.y - 0.2 * tall), (high.x + 0.02 * wide, high.y));
    let at = |x: f64, y: f64| Vec2::new(x.log2() as f32, y.log2() as f32);
    sheet.axes(low, (0.0, 0.0), (wide, tall), 1.4);
    for power in (0..=8).step_by(2) {
        sheet.text((power as f32, low.y - 0.07 * tall), &(1 << power).to_string(), GREY);
    }
    for power in (1..=high.y as i32).step_by(2) {
        sheet.text_left_of((low.x - 0.15, power as f32), &(1 << power).to_string(), GREY);
    }
    sheet.text((low.x + 0.5 * wide, low.y - 0.16 * tall), "operations a byte of memory", GREY);
    sheet.text_right_of((low.x + 0.1, high.y - 0.04 * tall), "10⁹ operations a second", GREY);
    let ridge = core / memory;
    let first = (1.0 / memory).max(1.0);
    sheet.polyline(
        [at(first, first * memory), at(ridge, core), Vec2::new(high.x, core.log2() as f32)],
        BLACK,
        2.6,
    );
    let inks = [GREY, PURPLE, ORANGE, GREEN, AMBER, BLUE, BLACK];
    let methods: Vec<_> = rows.iter().filter(|row| !["memory", "core"].contains(&row.0.as_str())).collect();
    let mut labels: Vec<Vec2> = Vec::new();
    for ((name, [operations, bytes, rate]), ink) in methods.into_iter().zip(inks) {
        let place = at(operations / bytes, rate / 1000.0);
        sheet.dot(place, ink);
        let right = place.x < low.x + 0.62 * wide;
        let mut beside = place + Vec2::X * if right { 0.18 } else { -0.18 };
        // Below those that are there already.
        while labels
            .iter()
            .any(|other| (other.x - beside.x).abs() < 0.3 * wide && (other.y - beside.y).abs() < 0.055 * tall)
        {
            beside.y -= 0.01 * tall;
        }
        labels.push(beside);
        if right { sheet.text_right_of(beside, name, BLACK) } else { sheet.text_left_of(beside, name, BLACK) }
    }
    sheet.finish()
}
