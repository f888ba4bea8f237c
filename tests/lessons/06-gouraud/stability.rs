use assets::sphere::sphere;
use checks::sphere::intensity;
use common::{Format, Image, Model, Vec3};
use gouraud::{LESSON, METHODS, Scene, Wrap, corner_normals, gouraud, intensities};
use verify::stability::Must::{AtMost, Between};
use verify::stability::{Case, every_method};
use zbuffer::to_screen;

use crate::{BOTH, draw};

/// A sphere's bands and sectors, and the light.
type Given = ([usize; 2], Vec3);

/// The spheres, and how many grey levels each method is off the smooth one, at worst; half a level is what rounding
/// a colour costs. Measured within 0.9 of the radius, where the triangles' outline cannot be mistaken for the sphere's.
const TABLE: &[Case<Given>] = &[
    (
        "24 triangles: worse than flat",
        ([4, 4], Vec3::Z),
        &[("none", Between(143.5, 144.5)), ("flat", Between(86.4, 87.4)), ("gouraud", Between(120.8, 121.8))],
    ),
    (
        "440 triangles",
        ([12, 20], Vec3::Z),
        &[("none", Between(143.5, 144.5)), ("flat", Between(36.9, 37.9)), ("gouraud", AtMost(12.5))],
    ),
    (
        "1,840 triangles",
        ([24, 40], Vec3::Z),
        &[("none", Between(143.5, 144.5)), ("flat", Between(18.7, 19.7)), ("gouraud", AtMost(4.5))],
    ),
    (
        "7,520 triangles",
        ([48, 80], Vec3::Z),
        &[("none", Between(143.5, 144.5)), ("flat", Between(9.2, 10.2)), ("gouraud", AtMost(1.5))],
    ),
    (
        "7,520 triangles, light from the side",
        ([48, 80], Vec3::X),
        &[("none", Between(254.5, 255.5)), ("flat", Between(9.5, 10.5)), ("gouraud", AtMost(1.5))],
    ),
    (
        "7,520 triangles, light from behind",
        ([48, 80], Vec3::NEG_Z),
        &[("none", Between(254.5, 255.5)), ("flat", Between(-0.5, 0.5)), ("gouraud", AtMost(0.5))],
    ),
];

/// A square picture of a model, white, by one method.
fn drawn(model: &Model, light: Vec3, name: &str, side: u16) -> Image {
    let mut picture = Image::new(side, side, Format::Gray);
    draw(model, light, name, &mut picture);
    picture
}

/// The largest difference from the smooth sphere, and the mean, in grey levels.
fn error([bands, sectors]: [usize; 2], light: Vec3, name: &str) -> (f64, f64) {
    let model = Model::parse(sphere(bands, sectors).to_obj().as_bytes(), BOTH).unwrap();
    let picture = drawn(&model, light, name, 201);
    let at = |n: i32| (2.0 * f64::from(n) + 1.0) / 201.0 - 1.0;
    let inner = picture.pixels().filter(|&(x, y, _)| at(x) * at(x) + at(y) * at(y) < 0.81);
    let errors: Vec<f64> = inner
        .map(|(x, y, color)| {
            let exact = intensity(at(x), at(y), light.as_dvec3()).unwrap();
            (f64::from(color.r) - 255.0 * exact).abs()
        })
        .collect();
    (errors.iter().copied().fold(0.0, f64::max), errors.iter().sum::<f64>() / errors.len() as f64)
}

#[test]
fn every_method_does_what_it_must() {
    every_method(LESSON.name, METHODS, TABLE, |method, &(cuts, light)| error(cuts, light, method.name).0);
}

/// Half the triangles' size, a quarter of the error; flat shading only halves it.
#[test]
fn gourauds_error_falls_with_the_square_of_the_triangles_size() {
    let ratio = |name| error([12, 20], Vec3::Z, name).1 / error([24, 40], Vec3::Z, name).1;
    assert!((3.0..5.0).contains(&ratio("gouraud")));
    assert!((1.8..2.2).contains(&ratio("flat")));
}

/// The faces of a cube, each as four corners of eight.
const CUBE: [[usize; 4]; 6] =
    [[4, 5, 7, 6], [1, 0, 2, 3], [5, 1, 3, 7], [0, 4, 6, 2], [6, 7, 3, 2], [0, 1, 5, 4]];

/// A cube seen from the front, and how many grey levels each method is off its front face, which is as bright all over.
/// A mean normal looks along the diagonal, as if the corner were round.
const CUBES: &[Case<bool>] = &[
    (
        "eight corners, with a mean normal each",
        false,
        &[("none", Between(50.4, 51.4)), ("flat", AtMost(0.5)), ("gouraud", Between(203.5, 204.5))],
    ),
    (
        "a normal for each corner of each face",
        true,
        &[("none", Between(50.4, 51.4)), ("flat, gouraud", AtMost(0.5))],
    ),
];

#[test]
fn mean_normals_round_a_cube() {
    let light = Vec3::new(0.0, 0.6, 0.8);
    every_method(LESSON.name, METHODS, CUBES, |method, &own_normals| {
        let sign = |n: usize, bit: usize| if n >> bit & 1 == 1 { 1 } else { -1 };
        let mut text =
            String::from("vt 0 0\nvn 0 0 1\nvn 0 0 -1\nvn 1 0 0\nvn -1 0 0\nvn 0 1 0\nvn 0 -1 0\n");
        (0..8).for_each(|n| text += &format!("v {} {} {}\n", sign(n, 0), sign(n, 1), sign(n, 2)));
        for (face, corners) in CUBE.iter().enumerate() {
            let normal = if own_normals { format!("/{}", face + 1) } else { String::new() };
            text += "f";
            corners.iter().for_each(|corner| text += &format!(" {}/1{normal}", corner + 1));
            text += "\n";
        }
        let model = Model::parse(text.as_bytes(), BOTH).unwrap();
        let exact = 255.0 * f64::from(light.z);
        let picture = drawn(&model, light, method.name, 40);
        picture.pixels().map(|pixel| (f64::from(pixel.2.r) - exact).abs()).fold(0.0, f64::max)
    });
}

/// Light that falls on the middle of a large triangle leaves its corners, and so all of it, dimmer than it is.
#[test]
fn a_highlight_narrower_than_a_triangle_is_lost() {
    let octahedron = Model::parse(
        b"v 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\nf 1/1/1 2/1/2 3/1/3\n",
        BOTH,
    );
    let model = octahedron.unwrap();
    let light = Vec3::ONE.normalize();
    let brightest = |name: &str| {
        let picture = drawn(&model, light, name, 99);
        picture.pixels().map(|pixel| pixel.2.r).max()
    };
    // All three corners see the light at arccos(1/√3) = 54.7°.
    let at_the_corners = (255.0 / 3f64.sqrt()).round() as u8;
    assert_eq!((brightest("flat"), brightest("gouraud")), (Some(255), Some(at_the_corners)));
}

/// One corner in the light, two in the dark: the brightness is interpolated first and cut off at 0 then, so
/// that the border of the light is where the sum is 0 and not along the sides.
#[test]
fn brightness_is_clamped_after_interpolation() {
    let text = b"v -1 -1 0\nv 1 -1 0\nv -1 1 0\nvt 0 0\nvn 0 0 1\nvn 0 0 -1\nf 1/1/1 2/1/2 3/1/2\n";
    let model = Model::parse(text, BOTH).unwrap();
    let picture = drawn(&model, Vec3::Z, "gouraud", 16);
    for (x, y, color) in picture.pixels().filter(|(x, y, _)| x + y < 15) {
        // The weights of the second and third corner grow with x and y.
        let dark = (f64::from(x) + 0.5) / 16.0 + (f64::from(y) + 0.5) / 16.0;
        let exact = 255.0 * (1.0 - 2.0 * dark).max(0.0);
        assert!((f64::from(color.r) - exact).abs() <= 0.51, "({x}, {y}): {}, not {exact}", color.r);
    }
    assert_eq!(intensities([Vec3::Z, Vec3::NEG_Z, Vec3::X], Vec3::Z), Vec3::new(1.0, -1.0, 0.0));
}

/// A triangle with a corner that has no place in the picture is left out, and counted.
#[test]
fn what_has_no_place_is_left_out_and_counted() {
    let text = b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 1 9\nvt 0 0\nvn 0 0 1\n\
        f 1/1/1 2/1/1 4/1/1\nf 1/1/1 2/1/1 3/1/1\nf 4/1/1 1/1/1 2/1/1\n";
    let model = Model::parse(text, BOTH).unwrap();
    let scene = Scene {
        model: &model,
        normals: &corner_normals(&model),
        texture: &Image::new(1, 1, Format::Gray),
        wrap: Wrap::Clamp,
        light: Vec3::Z,
    };
    let mut picture = Image::new(9, 9, Format::Gray);
    let size = picture.size();
    let drawn = gouraud(&scene, &mut picture, |point| (point.z < 1.0).then(|| to_screen(point, size)));
    assert_eq!((drawn.left_out, drawn.depths.get(4, 4)), (2, 0.0));
}

/// Input, an OBJ text, and the normal at the first corner of the first triangle.
#[test]
fn normals_are_the_files_made_1_long_or_else_computed() {
    // A level triangle, and one twice as large that stands on it; both have corner 1.
    let shape = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nvt 0 0\n";
    let weighted = Vec3::new(2.0, 0.0, 1.0).normalize();
    for (input, faces, expected) in [
        ("of length 1", "vn 0 1 0\nf 1/1/1 2/1/1 3/1/1\n", Vec3::Y),
        ("of length 5", "vn 0 3 4\nf 1/1/1 2/1/1 3/1/1\n", Vec3::new(0.0, 0.6, 0.8)),
        ("of length 1e-3", "vn 0 0.001 0\nf 1/1/1 2/1/1 3/1/1\n", Vec3::Y),
        ("of length 0: the triangle's own", "vn 0 0 0\nf 1/1/1 2/1/1 3/1/1\n", Vec3::Z),
        ("so short that its square is 0", "vn 0 1e-30 0\nf 1/1/1 2/1/1 3/1/1\n", Vec3::Y),
        ("so long that its square is infinite", "vn 0 1.9e19 0\nf 1/1/1 2/1/1 3/1/1\n", Vec3::Y),
        (
            "the longest",
            "vn 0 3e38 3e38\nf 1/1/1 2/1/1 3/1/1\n",
            Vec3::new(0.0, 0.5f32.sqrt(), 0.5f32.sqrt()),
        ),
        ("missing: the mean, weighted by area", "f 1/1 2/1 3/1\nf 1/1 3/1 4/1\n", weighted),
        ("missing at one face: all are computed", "vn 0 1 0\nf 1/1/1 2/1/1 3/1/1\nf 1/1 3/1 4/1\n", weighted),
        ("missing, and two faces cancel: the triangle's own", "f 1/1 2/1 3/1\nf 1/1 3/1 2/1\n", Vec3::Z),
        (
            "missing, and the two sides of a sheet cancel but for rounding: the triangle's own",
            "v -.3 -.7 -.3\nv .4 -.4 .2\nv -.1 .8 -.1\nf 5/1 6/1 7/1\nf 7/1 6/1 5/1\n",
            Vec3::new(-0.69, -0.04, 0.99).normalize(),
        ),
        (
            "the same, where f64 rounds as well",
            "v .182 .803 -.955\nv .009 .004 .452\nv .005 .001 -.538\nf 5/1 6/1 7/1\nf 7/1 6/1 5/1\n",
            Vec3::new(0.976_135, -0.217_139_83, -0.003_286),
        ),
        (
            "missing, and the areas are no f32",
            "v 3e38 0 0\nv 0 3e38 0\nv 0 0 3e38\nf 5/1 6/1 7/1\n",
            Vec3::ONE.normalize(),
        ),
        (
            "missing, and the areas are smaller than any f32",
            "v 3e-38 0 0\nv 0 3e-38 0\nv 0 0 3e-38\nf 5/1 6/1 7/1\n",
            Vec3::ONE.normalize(),
        ),
        (
            "missing: the mean, of areas smaller than any f32",
            "v 1e-30 0 0\nv 0 1e-30 0\nv 0 0 2e-30\nf 1/1 5/1 6/1\nf 1/1 6/1 7/1\n",
            weighted,
        ),
        ("missing, and no area: none", "f 1/1 1/1 2/1\n", Vec3::ZERO),
    ] {
        let model = Model::parse(format!("{shape}{faces}").as_bytes(), BOTH).unwrap();
        let got = corner_normals(&model)[0][0];
        assert!((got - expected).length() < 1e-6, "{input}: {got}, not {expected}");
    }
}
