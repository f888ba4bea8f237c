use std::collections::{BTreeMap, BTreeSet};

use common::{Attributes, Color, Format, IVec2, Image, Method, Model, Vec3};
use verify::SPHERE;
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, Row, counted, every_method};
use wireframe::{LESSON, METHODS, Wireframe, to_pixel};

/// An OBJ text, and what it has: triangles, faces that are left out, pixels that are drawn of a picture of 9×9.
type Given = (&'static str, [usize; 3]);

const BOTH_EXACT: &[Row] = &[("three-per-triangle, unique-edges", Exact)];
const ONE_AGAIN: &[Row] = &[("three-per-triangle", Fails("drawn again 1")), ("unique-edges", Exact)];

/// The models, and what each method must make of them: exact is each edge once.
const TABLE: &[Case<Given>] = &[
    ("whole", ("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3", [1, 0, 24]), BOTH_EXACT),
    ("a square", ("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4", [2, 0, 39]), ONE_AGAIN),
    (
        "six corners",
        ("v -1 0 0\nv -.5 -1 0\nv .5 -1 0\nv 1 0 0\nv .5 1 0\nv -.5 1 0\nf 1 2 3 4 5 6", [4, 0, 40]),
        &[("three-per-triangle", Fails("drawn again 3")), ("unique-edges", Exact)],
    ),
    ("beyond the picture", ("v -9 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3", [1, 0, 9]), BOTH_EXACT),
    ("a NaN vertex", ("v -1 -1 0\nv 1 -1 0\nv 1 1 nan\nf 1 2 3\nf 1 2 2", [1, 1, 9]), ONE_AGAIN),
    ("an infinite vertex", ("v -1 -1 0\nv 1 -1 0\nv inf 1 0\nf 1 2 3\nf 1 2 2", [1, 1, 9]), ONE_AGAIN),
    ("a missing vertex", ("v -1 -1 0\nv 1 -1 0\nf 1 2 3\nf 1 2 2", [1, 1, 9]), ONE_AGAIN),
    ("an index below the first", ("v -1 -1 0\nv 1 -1 0\nf 1 2 -3\nf 1 2 2", [1, 1, 9]), ONE_AGAIN),
    ("two corners", ("v -1 -1 0\nv 1 -1 0\nf 1 2\nf 1 2 2", [1, 1, 9]), ONE_AGAIN),
    (
        "no area",
        ("v 0 0 0\nf 1 1 1", [1, 0, 1]),
        &[("three-per-triangle", Fails("drawn again 2")), ("unique-edges", Exact)],
    ),
];

#[test]
fn every_method_does_what_it_must() {
    every_method(LESSON.name, METHODS, TABLE, |method, &(text, expected)| {
        let model = Model::parse(text.as_bytes(), Attributes::default()).unwrap();
        let mut image = Image::new(9, 9, Format::Gray);
        (method.run.draw)(&model, &mut image, Color::WHITE);
        let drawn = image.pixels().filter(|pixel| pixel.2 == Color::WHITE).count();
        let left_out = model.skipped().map_or(0, |skipped| skipped.count);
        assert_eq!([model.faces().len(), left_out, drawn], expected);
        let times = times(method, &model);
        counted([("drawn again", times.values().sum::<usize>() - times.len())])
    });
}

/// How often a method draws each edge.
fn times(method: &Method<Wireframe>, model: &Model) -> BTreeMap<BTreeSet<u32>, usize> {
    let mut times = BTreeMap::new();
    (method.run.visit)(model, &mut |edge| *times.entry(BTreeSet::from(edge)).or_default() += 1);
    times
}

#[test]
fn a_text_without_a_good_face_is_an_error() {
    for (text, expected) in [
        (
            "v nan 0 0\nf 1 1 1",
            "none of its 1 faces can be used; the first, line 2: corner `1`: vertex 1, in line 1: `nan` is not finite",
        ),
        ("", "there is no face in it; is it an OBJ file?"),
    ] {
        assert_eq!(Model::parse(text.as_bytes(), Attributes::default()).err().as_deref(), Some(expected));
    }
}

/// By the slides' formula a vertex at exactly 1 would land on column `width`, which does not exist.
#[test]
fn the_border_belongs_to_the_last_column() {
    let image = Image::new(800, 600, Format::Gray);
    let below_one = 1.0f32.next_down();
    for (coordinate, pixel) in [
        (1.0, IVec2::new(799, 599)),
        (below_one, IVec2::new(799, 599)),
        (-1.0, IVec2::ZERO),
        (0.0, IVec2::new(400, 300)),
        (-1e-9, IVec2::new(399, 299)),
        (-2.0f32.powi(-53), IVec2::new(399, 299)),
        (-2.0f32.powi(-54), IVec2::new(400, 300)),
        (1.0f32.next_up(), IVec2::new(800, 600)),
        ((-1.0f32).next_down(), IVec2::new(-1, -1)),
        (f32::MAX, IVec2::MAX),
        (f32::MIN, IVec2::MIN),
    ] {
        assert_eq!(to_pixel(Vec3::splat(coordinate), &image), pixel, "{coordinate}");
    }
}

/// A closed surface has 3/2 edges a triangle; whoever draws each once has to remember them.
const ON_THE_SPHERE: &[Case<&str>] = &[(
    "the sphere",
    SPHERE,
    &[("three-per-triangle", Fails("each edge 2 times")), ("unique-edges", Fails("24 bytes a triangle"))],
)];

#[test]
fn on_the_sphere_only_unique_edges_draws_each_edge_once() {
    every_method(LESSON.name, METHODS, ON_THE_SPHERE, |method, path| {
        let model = Model::read(path.as_ref(), Attributes::default()).unwrap();
        assert_eq!(model.faces().len(), 5000);
        let times = times(method, &model);
        let mut faults = counted([("edges missing", 7500 - times.len())]);
        let each: BTreeSet<usize> = times.into_values().collect();
        faults.extend(each.into_iter().filter(|&n| n > 1).map(|n| format!("each edge {n} times")));
        let memory = allocation_counter::measure(|| (method.run.visit)(&model, &mut |_| ())).bytes_max;
        faults.extend((memory > 0).then(|| format!("{} bytes a triangle", memory as f64 / 5000.0)));
        faults
    });
}
