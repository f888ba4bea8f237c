use common::{Color, Format, Image, Vec3};
use verify::{SPHERE, assert_drawn, assert_picture, assert_text, draw};
use zbuffer::{LESSON, METHODS, Surface};

const GREYS: [f32; 3] = [1.0, 0.6, 0.3];

fn surfaces(triangles: &[[[f32; 3]; 3]]) -> Vec<Surface> {
    let surface = |(corners, grey): (&[[f32; 3]; 3], f32)| Surface {
        corners: corners.map(Vec3::from_array),
        color: Color::gray(grey),
    };
    triangles.iter().zip(GREYS).map(surface).collect()
}

/// Two triangles that cut each other, and three that cover each other in a circle: `painter` finds no order.
#[test]
fn every_method_draws_what_has_no_order() {
    let crossing = [
        [[1.0, 2.0, 0.5], [31.0, 3.0, -0.5], [14.0, 15.0, 0.0]],
        [[1.0, 14.0, -0.6], [31.0, 13.0, 0.4], [18.0, 1.0, 0.0]],
    ];
    let circle = [
        [[2.0, 2.5, 0.5], [2.0, 15.5, 0.5], [35.0, 9.0, -1.0]],
        [[37.7, 8.9, 0.5], [26.4, 2.4, 0.5], [15.6, 34.2, -1.0]],
        [[14.3, 36.6, 0.5], [25.6, 30.1, 0.5], [3.4, 4.8, -1.0]],
    ];
    for method in METHODS {
        for (name, triangles, height) in [("crossing", &crossing[..], 16), ("circle", &circle, 37)] {
            let mut image = Image::new(40, height, Format::Gray);
            (method.run.draw)(&surfaces(triangles), &mut image);
            assert_text(&LESSON, &format!("{name}-{}", method.name), &image);
        }
    }
}

#[test]
fn every_method_draws_the_sphere() {
    for method in METHODS {
        let arguments =
            ["--size", "200x200", "--model", SPHERE, "--light", "-1,1,2", "--method", method.name];
        assert_picture(&LESSON, method.name, &draw("zbuffer", &arguments), 0);
    }
}

#[test]
fn every_depth_buffer_is_a_picture() {
    for method in METHODS.iter().filter(|method| method.run.depth.is_some()) {
        let folder = tempfile::tempdir().unwrap();
        let depth = folder.path().join("depth.png");
        let arguments = ["--size", "200x200", "--model", SPHERE, "--method", method.name, "--depth"];
        let _ = draw("zbuffer", &[&arguments[..], &[depth.to_str().unwrap()]].concat());
        assert_picture(&LESSON, &format!("depth-{}", method.name), &Image::read(&depth).unwrap(), 0);
    }
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &["--size", "200x200"]);
}
