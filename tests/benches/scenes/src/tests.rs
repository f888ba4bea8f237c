use clipping::{Counts, Cull};
use common::Image;
use filtering::filter::Nearest;

use super::{SCENES, Scene, find, grid, layers, soup};

fn drawn(scene: &Scene) -> (Image, Counts) {
    let mut image = scene.canvas();
    let drawn = filtering::draw(&[scene.surface()], Nearest, Scene::CULL, &mut image);
    (image, drawn.counts)
}

fn covered(image: &Image) -> usize {
    image.pixels().filter(|(_, _, color)| color.a > 0).count()
}

#[test]
fn scenes_are_found_by_their_names() {
    for recipe in SCENES {
        assert_eq!(find(recipe.name).map(|found| found.title), Some(recipe.title));
    }
    assert!(find("none").is_none());
}

#[test]
fn each_layer_fills_the_picture_uncut_and_the_order_of_drawing_changes_nothing() {
    for (tilt, ties) in [(0.0, 0), (layers::TILT, 100)] {
        let [front, back] = [layers::front, layers::back].map(|layers| drawn(&layers(20, tilt)));
        // Where two pass through each other, some pixels have the same depth in both.
        let differ = front.0.pixels().zip(back.0.pixels()).filter(|(a, b)| a != b).count();
        assert!(differ <= ties, "tilted by {tilt}: {differ}");
        assert_eq!((front.1.filled, front.1.cut), (40, 0));
    }
    let (image, _) = drawn(&layers::front(2, 0.0));
    assert_eq!(covered(&image), 1920 * 1080);
}

/// As many pixels as the area says, but for those that are hidden.
#[test]
fn small_triangles_all_lie_in_the_picture_and_face_the_eye() {
    let (image, counts) = drawn(&soup::soup(1000, 4.0));
    assert_eq!((counts.vertices, counts.filled, counts.cut), (3000, 1000, 0));
    let covered = covered(&image);
    assert!((3800..=4100).contains(&covered), "{covered}");
}

#[test]
fn a_grid_fills_the_picture_whatever_the_size_of_its_triangles() {
    for (area, triangles) in [(1024.0, 2 * 42 * 24), (1e6, 2)] {
        let (image, counts) = drawn(&grid::grid(area));
        assert_eq!((covered(&image), counts.filled, counts.cut), (1920 * 1080, triangles, 0));
    }
}

#[test]
fn nothing_of_the_models_is_cut() {
    for name in ["head-800", "head", "knot"] {
        let scene = (find(name).unwrap().make)();
        let (_, counts) = drawn(&scene);
        assert_eq!((counts.cut, counts.outside, counts.left_out), (0, 0, 0), "{name}");
        assert!(Scene::CULL == Cull::Back && counts.culled > counts.filled / 2, "{name}");
    }
}
