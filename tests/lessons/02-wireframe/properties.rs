use std::collections::BTreeSet;

use common::{Color, Format, Image, Model, Vec3};
use proptest::prelude::*;
use verify::window;
use wireframe::{METHODS, edges, to_pixel, wireframe};

fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![-1.0f32..=1.0, Just(-1.0), Just(1.0), Just(0.0), -0.001f32..0.001]
}

/// Up to twelve points, and triangles of any three of them.
fn model() -> impl Strategy<Value = Model> {
    let points = prop::collection::vec((coordinate(), coordinate(), coordinate()), 3..12);
    (points, prop::collection::vec(any::<[prop::sample::Index; 3]>(), 1..12)).prop_map(
        |(points, triangles)| {
            let triangles =
                triangles.iter().map(|t| t.map(|index| index.index(points.len()) as u32)).collect();
            Model::from_triangles(points.into_iter().map(Vec3::from).collect(), triangles).unwrap()
        },
    )
}

proptest! {
    #[test]
    fn every_method_draws_the_same(model in model()) {
        let pictures: Vec<Image> = METHODS.iter().map(|method| {
            let mut image = Image::new(64, 48, Format::Gray);
            (method.run.draw)(&model, &mut image, Color::WHITE);
            image
        }).collect();
        prop_assert!(pictures.iter().all(|picture| *picture == pictures[0]));
        let mut image = Image::new(64, 48, Format::Gray);
        wireframe(&model, &mut image, Color::WHITE);
        prop_assert!(image == pictures[0]);
    }

    #[test]
    fn every_edge_comes_once(model in model()) {
        let expected: BTreeSet<BTreeSet<u32>> = model.triangles().iter()
            .flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]].map(BTreeSet::from)).collect();
        let got = edges(&model);
        prop_assert_eq!(got.len(), expected.len());
        prop_assert_eq!(got.into_iter().map(BTreeSet::from).collect::<BTreeSet<_>>(), expected);
    }

    #[test]
    fn what_is_in_the_cube_is_in_the_picture(
        x in coordinate(), y in coordinate(), width in 1u16..2000, height in 1u16..2000,
    ) {
        let image = Image::new(width, height, Format::Gray);
        let pixel = to_pixel(Vec3::new(x, y, 0.0), &image);
        prop_assert!(window(image.width(), image.height()).contains(pixel.x, pixel.y));
        // In f64, and multiplied out: another rounding, in which a border cannot hide.
        let expected = |c: f32, size: u16| {
            let half = f64::from(size) / 2.0;
            ((f64::from(c) * half + half).floor() as i32).min(i32::from(size) - 1)
        };
        prop_assert_eq!((pixel.x, pixel.y), (expected(x, width), expected(y, height)));
    }

    #[test]
    fn any_point_has_a_pixel(x in any::<f32>(), y in any::<f32>()) {
        let _ = to_pixel(Vec3::new(x, y, 0.0), &Image::new(800, 800, Format::Gray));
    }
}
