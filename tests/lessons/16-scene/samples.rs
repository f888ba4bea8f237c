//! Version 10: sixteen samples a pixel, for which the assignment has no place.

use antialiasing::pattern;
use common::{DVec2, Image};
use scene::Entity;

use crate::pictures::{FIELD_OF_VIEW, ORBIT, cube_of, different, lit, seen_as, sphere_of};
use crate::truth::{Eye, Truth, codes, distance};
use crate::versions::{eye, picture_at, scene_at};

/// What sixteen rays meet, one through each sample: their mean, and whether all meet the same triangles.
fn by_samples(truth: &Truth, x: i32, y: i32, size: DVec2) -> [f64; 3] {
    let colors = pattern(16).iter().map(|&[right, up]| {
        let at = |pixel: i32, part: i32| f64::from(pixel) + f64::from(part) / 16.0;
        truth.at(DVec2::new(at(x, right), at(y, up)), size)
    });
    colors.fold([0.0; 3], |sum, color| std::array::from_fn(|n| sum[n] + color[n] / 16.0))
}

/// How far a picture is from the mean of sixteen rays, at most and on average, over all pixels where one ray and sixteen differ
/// by more than 16 levels: the edges.
fn off_at_edges(truth: &Truth, one: &Image, picture: &Image) -> [f64; 2] {
    let size = picture.size().as_dvec2();
    let mut off = Vec::new();
    for (x, y, color) in picture.pixels() {
        let mean = by_samples(truth, x, y, size);
        let rgb = |color| {
            let [r, g, b, _] = codes(color);
            [r, g, b]
        };
        if distance(rgb(one.get(x, y).expect("inside")), mean) > 16.0 {
            off.push(distance(rgb(color), mean));
        }
    }
    assert!(off.len() > 30, "{} pixels at edges", off.len());
    [off.iter().copied().fold(0.0, f64::max), off.iter().sum::<f64>() / off.len() as f64]
}

/// With F2's samples edges are what sixteen rays see, but that light and texture are computed once a pixel; without, they are
/// far from it.
#[test]
fn sixteen_samples_are_sixteen_rays() {
    let truth = Truth::new(&scene_at(10, 1.7), eye(10));
    let [one, many] = [false, true].map(|antialiased| picture_at(10, 1.7, antialiased));
    let [[_, rough], [_, smooth]] = [&one, &many].map(|picture| off_at_edges(&truth, &one, picture));
    assert!(rough > 25.0 && smooth < rough / 3.0, "{rough} {smooth}");
}

/// Of one colour, unlit, they are just the share of the samples: each mean to within what rounding makes of it.
#[test]
fn shares_are_exact() {
    let mut scene =
        lit(vec![Entity::new(cube_of(common::Color::WHITE)), Entity::new(sphere_of(common::Color::RED))]);
    scene.style.shading = scene::Shading::Unlit;
    scene.entities[1].position.x = 0.6;
    let truth = Truth::new(&scene, Eye::Around(ORBIT, FIELD_OF_VIEW));
    let [one, many] = [false, true].map(|antialiased| seen_as(&scene, antialiased, false));
    let [worst, mean] = off_at_edges(&truth, &one, &many);
    // A sample within 1/256 px of a side may change hands: 1/16 of 255 levels.
    assert!(worst < 17.0 && mean < 1.5, "{worst} {mean}");
}

/// Without F2's samples version 10 is version 9.
#[test]
fn without_samples_it_is_version_9() {
    for seconds in [0.0, 1.7] {
        assert_eq!(different(&picture_at(9, seconds, false), &picture_at(10, seconds, false)), 0);
        assert!(different(&picture_at(9, seconds, false), &picture_at(10, seconds, true)) > 300);
    }
}
