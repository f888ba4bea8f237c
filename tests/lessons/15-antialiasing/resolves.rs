//! What becomes of a pixel's samples, and how they are kept.

use antialiasing::resolve::Resolve;
use antialiasing::{Draw, LESSON, RESOLVES, STORAGES};
use checks::footprint::{code, light};
use common::{Color, Method};
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, Row, every_method};

use crate::scenes::{Scene, codes, grid, on_white, pair, right_of, slivers, through};

const ALL_EXACT: &[Row] = &[("encoded, linear", Exact)];

/// Makes samples.
type Make = fn() -> Vec<Color>;

/// So many samples of one grey, so many of another.
fn greys(first: u8, count: usize, second: u8, more: usize) -> Vec<Color> {
    let grey = |code| Color::rgb(code, code, code);
    [vec![grey(first); count], vec![grey(second); more]].concat()
}

/// Samples, and what each way must make of them: exact is the code of the mean light, rounded; what is not is told by the
/// grey levels that it is darker by.
const SAMPLES: &[Case<Make>] = &[
    ("one", || greys(77, 1, 0, 0), ALL_EXACT),
    ("sixteen of one colour", || vec![Color::rgb(13, 200, 77); 16], ALL_EXACT),
    ("white", || greys(255, 16, 0, 0), ALL_EXACT),
    ("half white, half black", || greys(255, 8, 0, 8), &[("encoded", Fails("60")), ("linear", Exact)]),
    ("one of sixteen white", || greys(255, 1, 0, 15), &[("encoded", Fails("55")), ("linear", Exact)]),
    ("fifteen of sixteen white", || greys(255, 15, 0, 1), &[("encoded", Fails("9")), ("linear", Exact)]),
    ("one of four white", || greys(255, 1, 0, 3), &[("encoded", Fails("73")), ("linear", Exact)]),
    ("two greys, 1 apart", || greys(100, 8, 101, 8), ALL_EXACT),
    ("two greys, 20 apart", || greys(100, 8, 120, 8), &[("encoded", Fails("1")), ("linear", Exact)]),
    ("dark beside darker", || greys(3, 8, 10, 8), ALL_EXACT),
    (
        "red and green",
        || [vec![Color::RED; 2], vec![Color::GREEN; 2]].concat(),
        &[("encoded", Fails("60")), ("linear", Exact)],
    ),
];

#[test]
fn the_mean_of_codes_is_darker_than_the_mean_of_light() {
    every_method(LESSON.name, RESOLVES, SAMPLES, |method: &Method<Resolve>, make| {
        let samples = make();
        let got = codes((method.run)(&samples));
        let exact = |channel: usize| {
            code(
                samples.iter().map(|&sample| light(codes(sample)[channel])).sum::<f64>()
                    / samples.len() as f64,
            )
        };
        let darker = (0..3).map(|channel| exact(channel) - got[channel]).fold(0.0, f64::max);
        if darker > 0.501 { vec![format!("{darker:.0}")] } else { Vec::new() }
    });
}

/// Scenes of which each way to keep samples must keep every one right.
const KEPT: &[Case<fn() -> Scene>] = &[
    ("nothing", || Scene::white([9, 7], []), &[("samples, compressed", Exact)]),
    ("an edge", || Scene::white([9, 7], [right_of(4.3)]), &[("samples, compressed", Exact)]),
    (
        "an edge that is covered again",
        || Scene::white([9, 7], [right_of(4.3), right_of(-9.0)]),
        &[("samples, compressed", Exact)],
    ),
    ("slivers", || on_white(&slivers()), &[("samples, compressed", Exact)]),
    ("triangles smaller than pixels", || on_white(&grid()), &[("samples, compressed", Exact)]),
    ("one before the other", || pair(0.25, 0.75), &[("samples, compressed", Exact)]),
    ("one through the other", through, &[("samples, compressed", Exact)]),
];

#[test]
fn samples_are_kept_in_either_way() {
    every_method(LESSON.name, STORAGES, KEPT, |method: &Method<Draw>, make| {
        let scene = make();
        let image = scene.drawn(&method.run);
        let wrong = scene.pixels().zip(scene.sampled(method)).filter(|&((x, y), mean)| {
            let expected = mean.map(|mean| mean.map(|code| (code + 0.5).floor()));
            Some(codes(image.get(x, y).unwrap())) != expected
        });
        match wrong.count() {
            0 => Vec::new(),
            wrong => vec![format!("{wrong} wrong")],
        }
    });
}
