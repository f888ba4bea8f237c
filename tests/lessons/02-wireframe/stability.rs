use std::collections::{BTreeMap, BTreeSet};

use common::{Attributes, Color, Format, IVec2, Image, Model, Vec3};
use verify::SPHERE;
use wireframe::{METHODS, to_pixel};

type Case = (&'static str, &'static str, Result<(usize, usize, usize), &'static str>);

/// Input, its OBJ text, and what must happen: the triangles left, the faces left out, and the pixels drawn
/// in a picture of 9×9. Or the error.
const TABLE: &[Case] = &[
    ("whole", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3", Ok((1, 0, 24))),
    ("a square", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4", Ok((2, 0, 39))),
    (
        "six corners",
        "v -1 0 0\nv -.5 -1 0\nv .5 -1 0\nv 1 0 0\nv .5 1 0\nv -.5 1 0\nf 1 2 3 4 5 6",
        Ok((4, 0, 40)),
    ),
    ("beyond the picture", "v -9 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3", Ok((1, 0, 9))),
    ("a NaN vertex", "v -1 -1 0\nv 1 -1 0\nv 1 1 nan\nf 1 2 3\nf 1 2 2", Ok((1, 1, 9))),
    ("an infinite vertex", "v -1 -1 0\nv 1 -1 0\nv inf 1 0\nf 1 2 3\nf 1 2 2", Ok((1, 1, 9))),
    ("a missing vertex", "v -1 -1 0\nv 1 -1 0\nf 1 2 3\nf 1 2 2", Ok((1, 1, 9))),
    ("an index below the first", "v -1 -1 0\nv 1 -1 0\nf 1 2 -3\nf 1 2 2", Ok((1, 1, 9))),
    ("two corners", "v -1 -1 0\nv 1 -1 0\nf 1 2\nf 1 2 2", Ok((1, 1, 9))),
    ("no area", "v 0 0 0\nf 1 1 1", Ok((1, 0, 1))),
    (
        "nothing good",
        "v nan 0 0\nf 1 1 1",
        Err(
            "none of its 1 faces can be used; the first, line 2: corner `1`: vertex 1, in line 1: `nan` is not finite",
        ),
    ),
    ("nothing at all", "", Err("there is no face in it; is it an OBJ file?")),
];

#[test]
fn every_method_does_what_it_must() {
    for (input, text, must) in TABLE {
        let model = Model::parse(text.as_bytes(), Attributes::default());
        for method in METHODS {
            let got = model.as_ref().map_err(String::as_str).map(|model| {
                let mut image = Image::new(9, 9, Format::Gray);
                (method.run.draw)(model, &mut image, Color::WHITE);
                let drawn = image.pixels().filter(|pixel| pixel.2 == Color::WHITE).count();
                (model.faces().len(), model.skipped().map_or(0, |skipped| skipped.count), drawn)
            });
            assert_eq!(got, *must, "{input}, {}", method.name);
        }
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

/// A closed surface has 3/2 edges a triangle.
#[test]
fn on_the_sphere_only_unique_edges_draws_each_edge_once() {
    let model = Model::read(SPHERE.as_ref(), Attributes::default()).unwrap();
    assert_eq!(model.faces().len(), 5000);
    for (method, times) in METHODS.iter().zip([2, 1]) {
        let mut drawn: BTreeMap<BTreeSet<u32>, usize> = BTreeMap::new();
        (method.run.visit)(&model, &mut |edge| *drawn.entry(BTreeSet::from(edge)).or_default() += 1);
        assert_eq!(drawn.len(), 7500, "{}", method.name);
        assert!(drawn.values().all(|&count| count == times), "{}", method.name);
    }
}
