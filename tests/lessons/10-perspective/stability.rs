use std::path::Path;

use checks::camera::{self, distance_at, rounded_to};
use checks::ray::{Screen, hit};
use checks::view::on_level;
use common::{Attributes, Bounds, Color, DVec2, DVec3, Format, Image, Mat4, Model, Vec2, Vec3, Vec4};
use gouraud::corner_normals;
use perspective::depth::{Depth, Logarithmic, ReversedZF32, ZF32};
use perspective::division::{Division, Exact as ByDivision, MAGIC};
use perspective::interpolation::{Affine, PerPixel};
use perspective::{
    DEPTHS, DIVISIONS, Draw, Drawn, FLOOR, Framebuffer, FrustumError, LESSON, METHODS, Planes, Visit, draw,
    draw_triangle, frustum, perspective_weights, render, view,
};
use shaders::Uniforms;
use shaders::shader::{Fragment, Shader};
use shaders::target::Target;
use textures::Wrap;
use verify::stability::Must::{AtMost, Between, Exact, Fails, Nothing};
use verify::stability::{Case, counted, every_method};
use verify::{method, window};

const BOTH: Attributes = Attributes { normals: true, uvs: true };

/// The size of a picture, in pixels.
const SIZE: DVec2 = DVec2::new(320.0, 200.0);

/// A triangle in the window: at each corner x and y in pixels, z, and 1/w.
type Window = [[f32; 4]; 3];

/// One that goes from the left side of the picture to the middle of the right one, where it is so many times as far.
const fn wall(ratio: f32) -> Window {
    [[0.0, 0.0, 0.5, 1.0], [0.0, 200.0, 0.5, 1.0], [320.0, 100.0, 0.5, 1.0 / ratio]]
}

/// One that goes from the bottom to the top, where it is so many times as far: all along a row it is equally far.
const fn floor(ratio: f32) -> Window {
    [[0.0, 0.0, 0.5, 1.0], [320.0, 0.0, 0.5, 1.0], [160.0, 200.0, 0.5, 1.0 / ratio]]
}

/// The wall at so many times the distance.
const fn moved(ratio: f32, scale: f32) -> Window {
    let [[a, b, c, near], _, [.., far]] = wall(ratio);
    [[a, b, c, near / scale], [0.0, 200.0, 0.5, near / scale], [320.0, 100.0, 0.5, far / scale]]
}

/// How far (u, v) is off, in texels of a texture of 256×256 that the triangle shows a half of: against what the ray
/// through the pixel's centre meets. A part of a millionth of a texel is what the reference itself is off.
const WARP: &[Case<Window>] = &[
    ("equally far all over", wall(1.0), &[("affine, every-16, every-8, per-pixel", AtMost(2e-5))]),
    ("equally far, at 10^30", moved(1.0, 1e30), &[("affine, every-16, every-8, per-pixel", AtMost(2e-5))]),
    (
        "a floor, 2 times as far at its end",
        floor(2.0),
        &[("affine", Between(43.9, 44.0)), ("every-16, every-8, per-pixel", AtMost(1e-4))],
    ),
    (
        "a floor, 100 times as far at its end",
        floor(100.0),
        &[("affine", Between(209.0, 209.5)), ("every-16, every-8, per-pixel", AtMost(1e-4))],
    ),
    (
        "a floor to the horizon, 10^8 times as far at its end",
        floor(1e8),
        &[("affine", Between(253.9, 254.2)), ("every-16, every-8, per-pixel", AtMost(1e-4))],
    ),
    (
        "a wall, 2 times as far at its end",
        wall(2.0),
        &[
            ("affine", Between(43.9, 44.0)),
            ("every-16", Between(0.25, 0.27)),
            ("every-8", Between(0.070, 0.074)),
            ("per-pixel", AtMost(1e-4)),
        ],
    ),
    (
        "a wall, 10 times as far at its end",
        wall(10.0),
        &[
            ("affine", Between(132.9, 133.0)),
            ("every-16", Between(4.9, 5.0)),
            ("every-8", Between(1.5, 1.6)),
            ("per-pixel", AtMost(1e-4)),
        ],
    ),
    (
        "a wall, 100 times as far at its end",
        wall(100.0),
        &[
            ("affine", Between(209.4, 209.5)),
            ("every-16", Between(28.0, 30.0)),
            ("every-8", Between(10.0, 11.0)),
            ("per-pixel", AtMost(1e-4)),
        ],
    ),
    (
        "a wall to the horizon, 10^8 times as far at its end",
        wall(1e8),
        &[
            ("affine", Between(253.9, 254.1)),
            ("every-16", Between(29.0, 29.5)),
            ("every-8", Between(14.0, 15.0)),
            ("per-pixel", AtMost(1e-4)),
        ],
    ),
    (
        "a wall whose end is 10^30 away: its w is no number to be multiplied by",
        wall(1e30),
        &[
            ("affine", Between(253.9, 254.1)),
            ("every-16", Between(29.0, 29.5)),
            ("every-8", Between(14.0, 15.0)),
            ("per-pixel", AtMost(1e-4)),
        ],
    ),
    (
        "a wall 10^-30 before the eye, 10 times as far at its end",
        moved(10.0, 1e-30),
        &[
            ("affine", Between(132.9, 133.0)),
            ("every-16", Between(4.9, 5.0)),
            ("every-8", Between(1.5, 1.6)),
            ("per-pixel", AtMost(1e-4)),
        ],
    ),
    (
        "rows of 17 pixels, the last stretch one pixel long",
        [[0.0, 0.0, 0.5, 1.0], [0.0, 400.0, 0.5, 1.0], [17.0, 200.0, 0.5, 0.25]],
        &[
            ("affine", Between(85.0, 86.0)),
            ("every-16", Between(69.0, 71.0)),
            ("every-8", Between(30.0, 40.0)),
            ("per-pixel", AtMost(1e-4)),
        ],
    ),
    (
        "rows of one pixel",
        [[7.0, 0.0, 0.5, 1.0], [8.0, 0.0, 0.5, 1.0], [8.0, 200.0, 0.5, 0.1]],
        &[("affine", Between(104.0, 105.0)), ("every-16, every-8, per-pixel", AtMost(1e-4))],
    ),
    (
        "a corner at infinite depth",
        [[0.0, 0.0, 0.5, 1.0], [0.0, 200.0, f32::INFINITY, 1.0], [320.0, 100.0, 0.5, 1.0]],
        &[("affine, every-16, every-8, per-pixel", Nothing)],
    ),
    (
        "a corner at no depth",
        [[0.0, 0.0, 0.5, 1.0], [0.0, 200.0, f32::NAN, 1.0], [320.0, 100.0, 0.5, 1.0]],
        &[("affine, every-16, every-8, per-pixel", Nothing)],
    ),
    (
        "a corner with w = 0",
        [[0.0, 0.0, 0.5, 1.0], [0.0, 200.0, 0.5, f32::INFINITY], [320.0, 100.0, 0.5, 1.0]],
        &[("affine, every-16, every-8, per-pixel", Nothing)],
    ),
    (
        "a corner behind the eye",
        [[0.0, 0.0, 0.5, 1.0], [0.0, 200.0, 0.5, -1.0], [320.0, 100.0, 0.5, 1.0]],
        &[("affine, every-16, every-8, per-pixel", Nothing)],
    ),
    (
        "a corner whose w is no number",
        [[0.0, 0.0, 0.5, 1.0], [0.0, 200.0, 0.5, f32::NAN], [320.0, 100.0, 0.5, 1.0]],
        &[("affine, every-16, every-8, per-pixel", Nothing)],
    ),
    (
        "all corners infinitely far",
        [[0.0, 0.0, 0.5, 0.0], [0.0, 200.0, 0.5, 0.0], [320.0, 100.0, 0.5, 0.0]],
        &[("affine, every-16, every-8, per-pixel", Nothing)],
    ),
];

/// The exact (u, v) at a pixel of a triangle with (0, 0), (1, 0) and (0, 1) at its corners.
fn exact(corners: [Vec4; 3], x: i32, y: i32) -> DVec2 {
    let screen = Screen::ahead(60.0, SIZE);
    let seen = hit(corners.map(|corner| screen.point(corner)), screen.through(x, y));
    DVec2::new(seen.weights.y, seen.weights.z)
}

/// Calls `each(x, y, how far off)` for the pixels of a triangle; in texels of 256.
fn offs(visit: Visit, triangle: &Window, mut each: impl FnMut(i32, i32, f64)) {
    let corners = triangle.map(Vec4::from_array);
    let bounds = window(SIZE.x as i32, SIZE.y as i32);
    visit(corners, [Vec2::ZERO, Vec2::X, Vec2::Y], bounds, &mut |x, y, depth, uv| {
        assert_eq!(depth, 0.5, "a depth that all corners have is that of each pixel");
        each(x, y, (uv.as_dvec2() - exact(corners, x, y)).abs().max_element() * 256.0);
    });
}

#[test]
fn every_interpolation_warps_as_it_must() {
    every_method(LESSON.name, METHODS, WARP, |method, triangle| {
        let mut worst = None;
        offs(method.run.visit, triangle, |_, _, off| {
            let so_far = worst.unwrap_or(0.0);
            // Unlike `f64::max` this keeps a NaN.
            worst = Some(if off <= so_far { so_far } else { off });
        });
        worst
    });
}

/// A corner infinitely far is the limit of those that are farther and farther.
#[test]
fn a_corner_at_infinity_is_a_limit() {
    for row in METHODS {
        let mut seen = [1e-30, 0.0].map(|far| {
            let mut triangle = wall(1.0);
            triangle[2][3] = far;
            let mut uvs = Vec::new();
            let bounds = window(SIZE.x as i32, SIZE.y as i32);
            let corners = triangle.map(Vec4::from_array);
            (row.run.visit)(corners, [Vec2::ZERO, Vec2::X, Vec2::Y], bounds, &mut |_, _, _, uv| uvs.push(uv));
            uvs
        });
        let [far, infinite] = &mut seen;
        assert!(!far.is_empty() && far.len() == infinite.len());
        let off = far.iter().zip(infinite).map(|(a, b)| a.distance(*b)).fold(0.0, f32::max);
        assert!(off <= 1e-6, "{}: {off}", row.name);
    }
}

/// A pixel whose centre is the corner that is infinitely far: it has that corner's (u, v), although 1/w is 0 there.
#[test]
fn at_a_corner_at_infinity_is_that_corner() {
    // Its sides are a left and a top one, and so its centre is covered.
    let corners = [(10.5, 100.5, 0.0), (100.5, 100.5, 1.0), (10.5, 10.5, 1.0)];
    let corners = corners.map(|(x, y, w)| Vec4::new(x, y, 0.5, w));
    for row in METHODS {
        let mut seen = None;
        (row.run.visit)(corners, [Vec2::ONE, Vec2::X, Vec2::Y], window(320, 200), &mut |x, y, _, uv| {
            if (x, y) == (10, 100) {
                seen = Some(uv);
            }
        });
        assert_eq!(seen, Some(Vec2::ONE), "{}", row.name);
    }
}

/// At every 8th or 16th pixel of a row and at its last one nothing is off, between it is; and so it is where the last
/// stretch has one pixel, as many as all others, or any number between.
#[test]
fn every_nth_pixel_and_the_last_are_exact() {
    // A row is 1.585 px shorter than the one below it.
    let leaning = [[0.0, 0.0, 0.5, 1.0], [317.0, 0.0, 0.5, 0.25], [0.0, 200.0, 0.5, 1.0]];
    for (name, n) in [("every-8", 8), ("every-16", 16)] {
        let mut lengths = [false; 16];
        let mut between: f64 = 0.0;
        let mut rows: Vec<Vec<(i32, f64)>> = vec![Vec::new(); 200];
        offs(method(METHODS, name).visit, &leaning, |x, y, off| rows[y as usize].push((x, off)));
        for row in &rows {
            let Some((&(first, _), &(last, _))) = row.first().zip(row.last()) else { continue };
            lengths[((last - first) % n) as usize] = true;
            for &(x, off) in row {
                if (x - first) % n == 0 || x == last {
                    assert!(off <= 1e-4, "{name}: off by {off} at {x} from {first} to {last}");
                } else {
                    between = between.max(off);
                }
            }
        }
        assert!(lengths[..n as usize].iter().all(|&seen| seen), "{name}: {lengths:?}");
        assert!(between > 0.1, "{name}: {between}");
    }
}

/// A way to keep depths, drawn per pixel.
fn by_depth(name: &str) -> Draw {
    (method(METHODS, "per-pixel").draw)(method(DEPTHS, name))
}

/// A model in eye space, with (0, 0) as (u, v), and a texture of one colour.
fn plain(text: &str, color: Color) -> (Model, Image) {
    let text = format!("{text}vt 0 0\nvn 0 0 1\n");
    let mut texture = Image::new(1, 1, Format::Rgb);
    texture.set(0, 0, color);
    (Model::parse(text.as_bytes(), BOTH).unwrap(), texture)
}

/// Draws models of one colour each, one after the other, as an eye at the origin sees them.
fn drawn(models: &[(Model, Image)], planes: Planes, way: Draw, image: &mut Image) -> Drawn {
    let to_clip = perspective::perspective(60.0, 1.0, planes.near, planes.far).unwrap();
    let normals: Vec<_> = models.iter().map(|(model, _)| corner_normals(model)).collect();
    let uniforms = models.iter().zip(&normals).map(|((model, texture), normals)| Uniforms {
        normals,
        texture: Some(texture),
        to_clip,
        ..Uniforms::new(model)
    });
    way(&uniforms.collect::<Vec<_>>(), planes, image)
}

/// A triangle that fills the lower half of the picture, and the third corner of another one beside it.
const BEHIND: &[Case<&str>] = &[
    ("before the eye", "v 0 9 -2\nf 1/1/1 2/1/1 4/1/1\n", &[("affine, every-16, every-8, per-pixel", Exact)]),
    (
        "at the eye's depth, w = 0",
        "v 0 9 0\nf 1/1/1 2/1/1 4/1/1\n",
        &[("affine, every-16, every-8, per-pixel", Fails("left out 1"))],
    ),
    (
        "behind the eye, w = -1",
        "v 0 9 1\nf 1/1/1 2/1/1 4/1/1\n",
        &[("affine, every-16, every-8, per-pixel", Fails("left out 1"))],
    ),
    (
        "all corners behind the eye, and one at it",
        "v 0 9 1\nv 3 0 2\nv 0 0 0\nf 4/1/1 5/1/1 4/1/1\nf 1/1/1 4/1/1 6/1/1\nf 6/1/1 6/1/1 6/1/1\n",
        &[("affine, every-16, every-8, per-pixel", Fails("left out 3"))],
    ),
    (
        "a corner at w = 2^-19, 1.9e-6",
        "v 0 9 -0.0000019073486328125\nf 1/1/1 2/1/1 4/1/1\n",
        &[("affine, every-16, every-8, per-pixel", Exact)],
    ),
    (
        "a corner at w = 1e-6",
        "v 0 9 -0.000001\nf 1/1/1 2/1/1 4/1/1\n",
        &[("affine, every-16, every-8, per-pixel", Fails("left out 1"))],
    ),
    (
        "a corner at w = 2^-20, 9.5e-7",
        "v 0 9 -0.00000095367431640625\nf 1/1/1 2/1/1 4/1/1\n",
        &[("affine, every-16, every-8, per-pixel", Fails("left out 1"))],
    ),
];

/// A triangle with a corner at w ≤ 1e-6 is left out whole and counted; all else is drawn as if it were not there.
#[test]
fn what_reaches_behind_the_eye_is_left_out_whole_and_counted() {
    let planes = Planes { near: 0.1, far: 100.0 };
    let seen = "v -9 0 -2\nv 9 0 -2\nv 0 -9 -2\nf 1/1/1 2/1/1 3/1/1\n";
    every_method(LESSON.name, METHODS, BEHIND, |method, more| {
        let way = (method.run.draw)(self::method(DEPTHS, "z-f32"));
        let mut alone = Image::new(40, 40, Format::Rgb);
        drawn(&[plain(seen, Color::RED)], planes, way, &mut alone);
        let mut image = Image::new(40, 40, Format::Rgb);
        let drawn = drawn(&[plain(&format!("{seen}{more}"), Color::RED)], planes, way, &mut image);
        assert_eq!(image == alone, drawn.left_out > 0, "what is not left out covers the upper half");
        counted([("left out", drawn.left_out)])
    });
    let twice = [1, 2].map(|_| plain("v 0 0 -1\nv 1 0 -1\nv 0 0 1\nf 1/1/1 2/1/1 3/1/1\n", Color::RED));
    assert_eq!(drawn(&twice, planes, by_depth("w"), &mut Image::new(9, 9, Format::Rgb)).left_out, 2);
}

/// What faces away from the light is black and hides what is behind it: brightness drops nothing.
#[test]
fn the_dark_side_is_black_and_not_missing() {
    let wall = |z: f32, normal: f32| {
        let text =
            format!("v -9 -9 {z}\nv 9 -9 {z}\nv 0 9 {z}\nvt 0 0\nvn 0 0 {normal}\nf 1/1/1 2/1/1 3/1/1\n");
        let (_, texture) = plain("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1/1/1 2/1/1 3/1/1\n", Color::RED);
        (Model::parse(text.as_bytes(), BOTH).unwrap(), texture)
    };
    let planes = Planes { near: 0.1, far: 100.0 };
    for row in METHODS {
        for dark_first in [false, true] {
            let mut walls = [wall(-3.0, 1.0), wall(-2.0, -1.0)];
            if dark_first {
                walls.reverse();
            }
            let mut image = Image::new(9, 9, Format::Rgb);
            let drawn = drawn(&walls, planes, (row.run.draw)(method(DEPTHS, "w")), &mut image);
            assert_eq!((image.get(4, 4), drawn.depths.get(4, 4)), (Some(Color::BLACK), 2.0), "{}", row.name);
        }
    }
}

/// After it is cleared a framebuffer is as good as new.
#[test]
fn a_framebuffer_is_cleared() {
    let [mut image, mut other] = [0, 1].map(|_| Image::new(3, 2, Format::Rgb));
    let mut target = Framebuffer::new(&mut image, ZF32);
    assert!(target.test(1, 1, 0.5) && !target.test(1, 1, 1.0));
    target.write(1, 1, 0.5, Color::RED);
    assert!(!target.test(1, 1, 0.5) && target.test(1, 1, 0.25));
    target.clear();
    let new = Framebuffer::new(&mut other, ZF32);
    assert!(target.depths == new.depths && target.image == new.image);
}

/// How many times as far as the near plane the far one is, and how far apart two surfaces at nine tenths of the far
/// plane's distance must be to be told apart always, as a share of it. Nothing: that far it is as if nothing was drawn.
const GAPS: &[Case<f32>] = &[
    (
        "f/n = 10",
        1e1,
        &[
            ("z24, z-f32", Between(4.8e-7, 4.9e-7)),
            ("reversed-z-f32, w", AtMost(2.4e-7)),
            ("logarithmic", AtMost(2.4e-7)),
        ],
    ),
    (
        "f/n = 10^2",
        1e2,
        &[
            ("z24, z-f32", Between(5.3e-6, 5.4e-6)),
            ("reversed-z-f32, w", AtMost(2.4e-7)),
            ("logarithmic", Between(2.4e-7, 4.8e-7)),
        ],
    ),
    (
        "f/n = 10^4, a hand's breadth of a kilometre",
        1e4,
        &[
            ("z24, z-f32", Between(5.3e-4, 5.4e-4)),
            ("reversed-z-f32, w", AtMost(2.4e-7)),
            ("logarithmic", Between(4.8e-7, 8e-7)),
        ],
    ),
    (
        "f/n = 10^6",
        1e6,
        &[
            ("z24, z-f32", Between(0.05, 0.06)),
            ("reversed-z-f32, w", AtMost(2.4e-7)),
            ("logarithmic", Between(8e-7, 1.5e-6)),
        ],
    ),
    (
        "f/n = 10^8",
        1e8,
        &[
            ("z24, z-f32", Nothing),
            ("reversed-z-f32, w", AtMost(2.4e-7)),
            ("logarithmic", Between(1e-6, 2e-6)),
        ],
    ),
];

/// The gap below which some pairs of surfaces at a distance are not told apart, as a share of it; none where it is more
/// than a million.
fn gap(name: &str, planes: Planes, distance: f64) -> Option<f64> {
    let alike = (method(DEPTHS, name).alike)(planes, distance);
    Some((alike.end() - alike.start()) / distance).filter(|&gap| gap < 1e6)
}

#[test]
fn every_depth_tells_apart_what_it_must() {
    every_method(LESSON.name, DEPTHS, GAPS, |row, &ratio| {
        let near = 0.125;
        gap(row.name, Planes { near, far: near * ratio }, f64::from(near * ratio) * 0.9)
    });
}

/// The same a little behind the near plane: there all are fine, and z-f32, near its 0, for nothing.
const NEAR_GAPS: &[Case<f32>] = &[
    (
        "f/n = 10",
        1e1,
        &[
            ("z24", Between(5.4e-8, 6.6e-8)),
            ("z-f32", AtMost(1e-9)),
            ("reversed-z-f32, logarithmic, w", AtMost(2.4e-7)),
        ],
    ),
    (
        "f/n = 10^4",
        1e4,
        &[
            ("z24", Between(5.9e-8, 6.1e-8)),
            ("z-f32", AtMost(1e-9)),
            ("reversed-z-f32, logarithmic, w", AtMost(2.4e-7)),
        ],
    ),
    (
        "f/n = 10^8",
        1e8,
        &[
            ("z24", Between(5.9e-8, 6.1e-8)),
            ("z-f32", AtMost(1e-9)),
            ("reversed-z-f32, logarithmic, w", AtMost(2.4e-7)),
        ],
    ),
];

#[test]
fn near_the_eye_every_depth_is_fine() {
    every_method(LESSON.name, DEPTHS, NEAR_GAPS, |row, &ratio| {
        gap(row.name, Planes { near: 0.125, far: 0.125 * ratio }, 0.1255)
    });
}

/// The limits: an infinite far plane, and near planes as near as f32 can say; at a distance of 1,000.
const LIMITS: &[Case<Planes>] = &[
    (
        "f infinite, n = 0.125",
        Planes { near: 0.125, far: f32::INFINITY },
        &[
            ("z24, z-f32", Between(4.7e-4, 4.8e-4)),
            ("reversed-z-f32, w", AtMost(2.4e-7)),
            ("logarithmic", Nothing),
        ],
    ),
    (
        "f infinite, n = 10^-4: beyond 3,355 nothing is drawn",
        Planes { near: 1e-4, far: f32::INFINITY },
        &[
            ("z24, z-f32", Between(0.44, 0.46)),
            ("reversed-z-f32, w", AtMost(2.4e-7)),
            ("logarithmic", Nothing),
        ],
    ),
    (
        "n = 10^-5: 1,000 is beyond what z keeps apart from infinity",
        Planes { near: 1e-5, far: 1e6 },
        &[("z24, z-f32", Nothing), ("reversed-z-f32, w", AtMost(2.4e-7)), ("logarithmic", AtMost(2e-6))],
    ),
    (
        "n = 10^-30",
        Planes { near: 1e-30, far: 1e6 },
        &[
            ("z24, z-f32", Nothing),
            ("reversed-z-f32, w", AtMost(2.4e-7)),
            ("logarithmic", Between(2e-6, 6e-6)),
        ],
    ),
    (
        "n = 10^-43: n/w is no f32",
        Planes { near: 1e-43, far: 1e6 },
        &[("z24, z-f32, reversed-z-f32, logarithmic", Nothing), ("w", AtMost(2.4e-7))],
    ),
];

#[test]
fn the_limits_of_the_planes_are_kept_by_some() {
    every_method(LESSON.name, DEPTHS, LIMITS, |row, &planes| gap(row.name, planes, 1000.0));
}

/// What z24 and z-f32 keep of a distance is kept of just the distances that the numbers' own spacing says.
#[test]
fn gaps_are_those_of_the_numbers() {
    for far in [1.25_f32, 12.5, 1250.0, 1.25e5, f32::INFINITY] {
        let planes = Planes { near: 0.125, far };
        let [n, f] = [0.125, f64::from(far)];
        for step in 1..40 {
            let distance = distance_at(f64::from(step) / 40.0, n, f);
            let check = |name: &str, [low, high]: [f64; 2]| {
                let alike = (method(DEPTHS, name).alike)(planes, distance);
                let [first, last] = [low, high].map(|z| distance_at(z, n, f));
                let off = (alike.start() - first).abs().max((alike.end() - last).abs());
                assert!(
                    off <= 1e-6 * (last - first),
                    "{name} at {distance} of {far}: {alike:?}, not {first} to {last}"
                );
                assert!(alike.contains(&distance));
            };
            let z = (method(DEPTHS, "z-f32").kept)(planes, distance);
            check("z-f32", rounded_to(z));
            if z <= 0.5 {
                continue;
            }
            // From one half on z is a whole number of 2⁻²⁴ already, and its level is the number below.
            let level = (method(DEPTHS, "z24").kept)(planes, distance);
            assert_eq!(f64::from(level) + 1.0, f64::from(z) * f64::from(1 << 24));
            check("z24", rounded_to(z));
        }
        // For w the distance is rounded once as 1/w and once as itself.
        for step in 0..200 {
            let distance = 0.125 * 1.07_f64.powi(step);
            let gap = gap("w", planes, distance).unwrap();
            assert!((0.9 * 2f64.powi(-24)..2f64.powi(-22)).contains(&gap), "{distance}: {gap}");
        }
    }
}

/// Two tilted walls, one this share of the distance behind the other, at about half of the far plane's: in how much of
/// the picture the one behind is seen, drawn first or last, whichever is worse.
const FIGHTS: &[Case<(f32, f32)>] = &[
    ("1/1,000 apart, f/n = 10^2", (1e2, 1e-3), &[("z24, z-f32, reversed-z-f32, logarithmic, w", Exact)]),
    ("1/1,000 apart, f/n = 10^4", (1e4, 1e-3), &[("z24, z-f32, reversed-z-f32, logarithmic, w", Exact)]),
    (
        "1/10,000 apart, f/n = 10^4",
        (1e4, 1e-4),
        &[("z24, z-f32", Between(0.3, 0.9)), ("reversed-z-f32, logarithmic, w", Exact)],
    ),
    (
        "1/1,000 apart, f/n = 10^6",
        (1e6, 1e-3),
        &[("z24, z-f32", Between(0.3, 1.0)), ("reversed-z-f32, logarithmic, w", Exact)],
    ),
    (
        "1/10 apart, f/n = 10^8",
        (1e8, 0.1),
        &[("z24, z-f32", Between(1.0, 1.0)), ("reversed-z-f32, logarithmic, w", Exact)],
    ),
    (
        "1/100,000 apart, f/n = 10^8",
        (1e8, 1e-5),
        &[("z24, z-f32", Between(1.0, 1.0)), ("reversed-z-f32, logarithmic, w", Exact)],
    ),
    (
        "1/40,000,000 apart, f/n = 10: the corners themselves are the same",
        (1e1, 2.5e-8),
        &[("z24, z-f32, reversed-z-f32, logarithmic, w", Between(1.0, 1.0))],
    ),
];

/// A wall that fills the picture, half as far again on the right as on the left.
fn tilted(distance: f32) -> String {
    let [near, far] = [distance, 1.5 * distance];
    format!(
        "v -{far} -{far} -{near}\nv {far} -{far} -{far}\nv {far} {far} -{far}\nv -{far} {far} -{near}\n\
         f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\n"
    )
}

/// The share of a picture in which the wall behind, or none, is seen.
fn lost(planes: Planes, apart: f32, way: Draw) -> f64 {
    let distance = planes.far / 2.0;
    let walls = [(distance, Color::GREEN), (distance * (1.0 + apart), Color::RED)];
    let [near, far] = walls.map(|(distance, color)| plain(&tilted(distance), color));
    let share = |models: &[(Model, Image)]| {
        let mut image = Image::new(60, 60, Format::Rgb);
        drawn(models, planes, way, &mut image);
        image.pixels().filter(|pixel| pixel.2.r > 0 || pixel.2.g == 0).count() as f64 / 3600.0
    };
    share(&[near.clone(), far.clone()]).max(share(&[far, near]))
}

#[test]
fn surfaces_fight_where_their_depths_are_one() {
    every_method(LESSON.name, DEPTHS, FIGHTS, |row, &(ratio, apart)| {
        lost(Planes { near: 0.1, far: 0.1 * ratio }, apart, by_depth(row.name))
    });
}

/// Reversed after z was rounded to what is near 1: what rounding did to z is kept.
#[derive(Clone, Copy)]
struct ReversedTooLate;

impl Depth for ReversedTooLate {
    const LARGER_IS_NEARER: bool = true;

    fn new(_: Planes) -> Self {
        Self
    }

    fn nothing(self) -> f32 {
        0.0
    }

    fn corner(self, window: Vec4) -> f32 {
        1.0 - window.z
    }

    fn stored(self, interpolated: f32) -> f32 {
        interpolated
    }
}

#[test]
fn reversing_after_rounding_mends_nothing() {
    let planes = Planes { near: 0.1, far: 1e5 };
    let [early, late] = [draw::<PerPixel, ReversedZF32> as Draw, draw::<PerPixel, ReversedTooLate>]
        .map(|way| lost(planes, 1e-3, way));
    assert!(early == 0.0 && late > 0.3, "{early}, {late}");
}

/// The logarithm taken at the corners, and interpolated as if it were linear in the picture.
#[derive(Clone, Copy)]
struct LogarithmicPerVertex(Logarithmic);

impl Depth for LogarithmicPerVertex {
    fn new(planes: Planes) -> Self {
        Self(Logarithmic::new(planes))
    }

    fn nothing(self) -> f32 {
        1.0
    }

    fn corner(self, window: Vec4) -> f32 {
        self.0.stored(window.w)
    }

    fn stored(self, interpolated: f32) -> f32 {
        interpolated
    }
}

/// A wall reaches below a floor of two large triangles. Between the corners a logarithm lies above the one at the pixel:
/// the floor is kept as farther away than it is, and shows what lies below it; per pixel it does not.
#[test]
fn a_logarithm_belongs_to_the_pixel() {
    let floor =
        "v -50 -1 -1.5\nv 50 -1 -1.5\nv 50 -1 -90\nv -50 -1 -90\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\n";
    let wall = "v -9 -9 -9\nv 9 -9 -9\nv 9 -1 -9\nv -9 -1 -9\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\n";
    let planes = Planes { near: 0.1, far: 100.0 };
    let below = |way: Draw| {
        let mut image = Image::new(100, 100, Format::Rgb);
        drawn(&[plain(floor, Color::GREEN), plain(wall, Color::RED)], planes, way, &mut image);
        image.pixels().filter(|pixel| pixel.2.r > 0).count()
    };
    // What the floor's near end leaves free at the bottom of the picture.
    let free = below(draw::<PerPixel, ZF32>);
    assert_eq!(below(draw::<PerPixel, Logarithmic>), free);
    let seen = below(draw::<PerPixel, LogarithmicPerVertex>) - free;
    assert!((2000..2600).contains(&seen), "{seen} pixels of the wall are seen through the floor");
}

/// Beyond the far plane nothing is drawn, whatever is kept; before the near plane it is, until lesson 11.
#[test]
fn the_far_plane_cuts_pixel_by_pixel_and_the_near_one_not_yet() {
    let planes = Planes { near: 1.0, far: 8.0 };
    for row in DEPTHS {
        for (distance, seen) in
            [(0.5, true), (0.999, true), (1.001, true), (7.99, true), (8.01, false), (100.0, false)]
        {
            let size = 2.0 * distance;
            let text = format!(
                "v -{size} -{size} -{distance}\nv {size} -{size} -{distance}\nv 0 {size} -{distance}\nf 1/1/1 2/1/1 3/1/1\n"
            );
            let mut image = Image::new(9, 9, Format::Rgb);
            drawn(&[plain(&text, Color::RED)], planes, by_depth(row.name), &mut image);
            assert_eq!(image.get(4, 3) == Some(Color::RED), seen, "{} at {distance}", row.name);
        }
    }
}

/// Of equal depths the first drawn stays, whichever way they are kept.
#[test]
fn of_equal_depths_the_first_stays() {
    let wall = tilted(3.0);
    for row in DEPTHS {
        for colors in [[Color::RED, Color::GREEN], [Color::GREEN, Color::RED]] {
            let models = colors.map(|color| plain(&wall, color));
            let mut image = Image::new(30, 30, Format::Rgb);
            drawn(&models, Planes { near: 0.1, far: 10.0 }, by_depth(row.name), &mut image);
            assert!(image.pixels().all(|pixel| pixel.2 == colors[0]), "{}", row.name);
        }
    }
}

/// The course's floor, seen from the height of the head: how many pixels of 240×240 show another field than the ray
/// through them meets; but for those that a field's border passes within 1/128 px of.
const HORIZON: &[Case<(Vec3, Vec3)>] = &[
    (
        "along an axis",
        (Vec3::new(0.3, 0.1, 3.9), Vec3::new(0.3, 0.0, 0.0)),
        &[("affine", Between(12_500.0, 12_700.0)), ("every-16, every-8, per-pixel", Exact)],
    ),
    (
        "askew",
        (Vec3::new(1.1, 0.1, 3.4), Vec3::new(0.0, 0.1, 0.0)),
        &[("affine", Between(10_300.0, 10_500.0)), ("every-16, every-8, per-pixel", Exact)],
    ),
    (
        "the head on one side: along a row the floor runs away from the eye",
        (Vec3::new(0.3, 0.1, 3.9), Vec3::new(0.3, 0.0, 0.001)),
        &[
            ("affine", Between(12_500.0, 12_700.0)),
            ("every-16", Between(4_700.0, 4_900.0)),
            ("every-8", Between(2_750.0, 2_850.0)),
            ("per-pixel", Exact),
        ],
    ),
];

#[test]
fn a_floor_reaches_to_the_horizon() {
    let model = Model::read(Path::new(FLOOR[0]), BOTH).unwrap();
    let texture = Image::read(Path::new(FLOOR[1])).unwrap();
    let normals = corner_normals(&model);
    let planes = Planes { near: 0.1, far: 100.0 };
    every_method(LESSON.name, METHODS, HORIZON, |row, &(eye, center)| {
        let up = if center.z == 0.0 { Vec3::Y } else { Vec3::X };
        let to_clip =
            perspective::perspective(45.0, 1.0, 0.1, 100.0).unwrap() * view(eye, center, up).unwrap();
        let uniforms = Uniforms {
            normals: &normals,
            texture: Some(&texture),
            wrap: Wrap::Repeat,
            light: Vec3::Y,
            to_clip,
            ..Uniforms::new(&model)
        };
        let mut image = Image::new(240, 240, Format::Rgb);
        (row.run.draw)(method(DEPTHS, "z-f32"))(&[uniforms], planes, &mut image);
        let screen = Screen::ahead(45.0, DVec2::splat(240.0));
        let [right, upward, back] = checks::view::basis(eye, center, up);
        let field = |at: DVec2| {
            let d = screen.direction(at);
            let through = eye.as_dvec3() + right * d.x + upward * d.y - back;
            let met = on_level(-0.996, eye.as_dvec3(), through);
            let depth = (eye.as_dvec3() - met).dot(back);
            let seen = (0.0..100.0).contains(&depth) && met.abs().max_element() < 128.0;
            // Fields are half a unit wide; (0, 0) is the lower left corner of a dark one.
            seen.then(|| ((2.0 * met.x).floor() + (-2.0 * met.z).floor()).rem_euclid(2.0) == 0.0)
        };
        let (mut other, mut missing) = (0_u32, 0);
        for (x, y, color) in image.pixels() {
            let middle = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let expected = field(middle);
            let around =
                (0..25).map(|n| middle + DVec2::new(f64::from(n % 5 - 2), f64::from(n / 5 - 2)) / 256.0);
            if { around }.any(|at| field(at) != expected) {
                continue;
            }
            let got = (color != Color::BLACK).then_some(color.r < 0x80);
            missing += u32::from(got.is_none() && expected.is_some());
            other += u32::from(got != expected && got.is_some());
        }
        assert_eq!(missing, 0, "{}", row.name);
        f64::from(other)
    });
}

/// Frustums: left, right, bottom, top, near, far.
const FRUSTUMS: &[[f32; 6]] = &[
    [-1.0, 1.0, -1.0, 1.0, 1.0, 10.0],
    [-1.0, 3.0, -2.0, 1.0, 0.5, 8.0],
    [0.25, 1.0, -7.0, -1.0, 0.125, 1e8],
    [1.0, -1.0, -1.0, 1.0, 0.1, 100.0],
    [-1.0, 1.0, -1.0, 1.0, 0.1, f32::INFINITY],
    [-1.0, 1.0, -1.0, 1.0, 0.1, f32::MAX],
    [-1.0, 1.0, -1.0, 1.0, 99.99999, 100.0],
    [-1.0, 1.0, -1.0, 1.0, 1.0, 1.000_000_1],
    [-1e-20, 1e-20, -1e-20, 1e-20, 1e-30, 1e30],
    [-1e30, 1e30, -1e30, 1e30, 1e10, 3e38],
    [1.0, 1.000_000_1, -1.0, 1.0, 1.0, 10.0],
    [-1.0, 1.0, -1.0, 1.0, f32::from_bits(1), 1.0],
];

/// Every entry is the exact one, rounded once; also where f is next to n, or as far as can be, or infinitely far.
#[test]
fn the_matrix_is_exact_to_the_last_bit() {
    for &sides in FRUSTUMS {
        let [l, r, b, t, n, f] = sides;
        let off = camera::error(&frustum(l, r, b, t, n, f).unwrap(), sides.map(f64::from));
        assert!(off <= 2f64.powi(-24), "{sides:?}: {off:e}");
    }
    for (fov, aspect) in [(45.0_f32, 1.0_f32), (90.0, 1.5), (0.001, 0.1), (179.9, 3.0), (1e-30, 1.0)] {
        let tangent = (f64::from(fov) / 2.0).to_radians().tan();
        for (n, f) in [(0.1_f32, 100.0_f32), (1e-6, f32::INFINITY), (f32::from_bits(1), 1.0)] {
            let top = f64::from(n) * tangent;
            let right = top * f64::from(aspect);
            let sides = [-right, right, -top, top, n.into(), f.into()];
            let off = camera::error(&perspective::perspective(fov, aspect, n, f).unwrap(), sides);
            // The reference rounds the tangent and five products and quotients.
            assert!(off <= 1.001 * 2f64.powi(-24), "{fov} {aspect} {n} {f}: {off:e}");
        }
    }
}

/// n → 0: the picture stays, every depth becomes 1. A frustum of given sides has no such limit.
#[test]
fn the_near_plane_at_the_eye_leaves_the_picture_and_takes_the_depth() {
    for far in [100.0, f32::INFINITY] {
        let limit = perspective::perspective(45.0, 1.5, 0.0, far).unwrap();
        let near = perspective::perspective(45.0, 1.5, 1e-12, far).unwrap();
        assert_eq!([limit.row(0), limit.row(1), limit.row(3)], [near.row(0), near.row(1), near.row(3)]);
        assert!((limit - near).abs_diff_eq(Mat4::ZERO, 3e-12));
        for depth in [0.1, 1.0, 99.0] {
            let clip = limit * Vec4::new(0.3, 0.2, -depth, 1.0);
            assert_eq!(clip.z, clip.w);
            assert_eq!(perspective::window(clip, Vec2::new(10.0, 10.0)).map(|window| window.z), Some(1.0));
        }
    }
    assert_eq!(frustum(-1.0, 1.0, -1.0, 1.0, 0.0, 1.0), Err(FrustumError::Near(0.0)));
    // A depth that keeps w needs neither plane: so near the eye z tells nothing, and w all.
    let planes = Planes { near: 1e-12, far: 100.0 };
    assert_eq!([lost(planes, 0.01, by_depth("z-f32")), lost(planes, 0.01, by_depth("w"))], [1.0, 0.0]);
}

/// What is no camera is refused, and said why in a line.
#[test]
fn what_is_no_camera_is_refused() {
    let nan = f32::NAN;
    let good = [-1.0, 1.0, -1.0, 1.0, 1.0, 10.0];
    let rows: &[(usize, &[f32], &str)] = &[
        (0, &[1.0, nan, f32::INFINITY], "it needs two different finite ends"),
        (2, &[1.0, nan, f32::NEG_INFINITY], "it needs two different finite ends"),
        (4, &[0.0, -0.0, -1.0, nan, f32::INFINITY], "it must lie before the eye, at more than 0"),
        (5, &[1.0, 0.5, -3.0, nan, f32::NEG_INFINITY], "it must lie behind the near one, which is at 1"),
    ];
    for &(place, values, said) in rows {
        for &value in values {
            let mut sides = good;
            sides[place] = value;
            let [l, r, b, t, n, f] = sides;
            let error = frustum(l, r, b, t, n, f).unwrap_err().to_string();
            assert!(error.contains(said) && !error.contains('\n'), "{sides:?}: {error}");
        }
    }
    for (fov, aspect, n, f, said) in [
        (0.0, 1.0, 0.1, 1.0, "more than 0 and less than 180"),
        (180.0, 1.0, 0.1, 1.0, "more than 0 and less than 180"),
        (-45.0, 1.0, 0.1, 1.0, "more than 0 and less than 180"),
        (nan, 1.0, 0.1, 1.0, "more than 0 and less than 180"),
        (45.0, 0.0, 0.1, 1.0, "a finite number above 0"),
        (45.0, nan, 0.1, 1.0, "a finite number above 0"),
        (45.0, f32::INFINITY, 0.1, 1.0, "a finite number above 0"),
        (45.0, 1.0, -0.1, 1.0, "at more than 0"),
        (45.0, 1.0, nan, 1.0, "at more than 0"),
        (45.0, 1.0, f32::INFINITY, f32::INFINITY, "at more than 0"),
        (45.0, 1.0, 1.0, 1.0, "behind the near one"),
        (45.0, 1.0, 0.0, 0.0, "behind the near one"),
        (45.0, 1.0, 1.0, nan, "behind the near one"),
        (1e-40, 1.0, 1.0, 2.0, "too large for 32 bits"),
        (45.0, 1.0, 3e38, 3.1e38, "too large for 32 bits"),
    ] {
        let error = perspective::perspective(fov, aspect, n, f).unwrap_err().to_string();
        assert!(error.contains(said) && !error.contains('\n'), "{fov} {aspect} {n} {f}: {error}");
    }
}

/// The largest relative error of 1/x over all x from 1 to 2, every f32 of them: the error is the same in each octave.
const OCTAVE: &[Case<()>] = &[(
    "from 1 to 2",
    (),
    &[
        ("fast-0", Between(0.050_510, 0.050_511)),
        ("fast-1", Between(0.002_551, 0.002_552)),
        ("fast-2", Between(6.5e-6, 6.8e-6)),
        ("exact", AtMost(6e-8)),
    ],
)];

/// The same at the ends of what can be divided, each 1.5 times a power of 2.
const RECIPROCALS: &[Case<f32>] = &[
    (
        "1.5, near to the worst of the guess without a step",
        1.5,
        &[
            ("fast-0", Between(0.03, 0.051)),
            ("fast-1", Between(1e-4, 0.002_552)),
            ("fast-2", AtMost(7e-6)),
            ("exact", AtMost(6e-8)),
        ],
    ),
    (
        "1.5·2^-126, the smallest exponent",
        1.5 * f32::MIN_POSITIVE,
        &[
            ("fast-0", Between(0.03, 0.051)),
            ("fast-1", Between(1e-4, 0.002_552)),
            ("fast-2", AtMost(7e-6)),
            ("exact", AtMost(6e-8)),
        ],
    ),
    (
        "1.5·2^124",
        1.5 * 2.126_764_8e37,
        &[
            ("fast-0", Between(0.03, 0.051)),
            ("fast-1", Between(1e-4, 0.002_552)),
            ("fast-2", AtMost(7e-6)),
            ("exact", AtMost(6e-8)),
        ],
    ),
];

#[test]
fn every_division_does_what_it_must() {
    let off = |one: fn(f32) -> f32, x: f32| (f64::from(one(x)) * f64::from(x) - 1.0).abs();
    every_method(LESSON.name, DIVISIONS, OCTAVE, |row, ()| {
        let octave = (1.0_f32.to_bits()..2.0_f32.to_bits()).map(f32::from_bits);
        octave.map(|x| off(row.run.one, x)).fold(0.0, f64::max)
    });
    every_method(LESSON.name, DIVISIONS, RECIPROCALS, |row, &x| off(row.run.one, x));
    for row in DIVISIONS {
        let mut many = [0.1, 0.25, 1.0, 3.0, 1e6];
        let each = many.map(row.run.one);
        (row.run.all)(&mut many);
        assert_eq!(many, each, "{}", row.name);
    }
}

/// No other number to subtract from has a smaller error on both sides.
#[test]
fn the_magic_number_is_the_best_one() {
    let worst = |magic: u32| {
        let octave = (1.0_f32.to_bits()..2.0_f32.to_bits()).step_by(64).map(f32::from_bits);
        octave.map(|x| (f32::from_bits(magic - x.to_bits()) * x - 1.0).abs()).fold(0.0, f32::max)
    };
    let best = worst(MAGIC);
    for other in [1, 64, 4096, 1 << 18] {
        assert!(worst(MAGIC - other) >= best && worst(MAGIC + other) >= best, "{other}");
    }
}

/// A wall's (u, v) by each reciprocal, off as in [`WARP`]: by the reciprocal's share of 256 texels.
const BENT: &[Case<Window>] = &[
    (
        "a wall, 10 times as far at its end",
        wall(10.0),
        &[
            ("fast-0", Between(10.0, 12.94)),
            ("fast-1", Between(0.3, 0.66)),
            ("fast-2", Between(2e-4, 2e-3)),
            ("exact", AtMost(1e-4)),
        ],
    ),
    (
        "equally far all over: 1/w is 1, and off as the reciprocal of 1",
        wall(1.0),
        &[
            ("fast-0", Between(8.0, 12.94)),
            ("fast-1", Between(0.3, 0.66)),
            ("fast-2", Between(2e-4, 2e-3)),
            ("exact", AtMost(2e-5)),
        ],
    ),
];

#[test]
fn a_coarse_division_bends_a_texture() {
    every_method(LESSON.name, DIVISIONS, BENT, |row, triangle| {
        let mut worst = 0.0;
        offs(row.run.visit, triangle, |_, _, off| worst = f64::max(worst, off));
        worst
    });
}

/// The weights that follow from those in the picture are the ray's, and where all corners are equally far, the same.
#[test]
fn weights_in_perspective() {
    let weights = Vec3::new(0.5, 0.25, 0.25);
    assert_eq!(perspective_weights(weights, Vec3::ONE), weights);
    assert_eq!(perspective_weights(weights, Vec3::splat(0.125)), weights);
    // Half-way in the picture to a corner 3 times as far is a quarter of the way in space.
    assert_eq!(
        perspective_weights(Vec3::new(0.5, 0.5, 0.0), Vec3::new(3.0, 1.0, 2.0)),
        Vec3::new(0.75, 0.25, 0.0)
    );
    assert_eq!(perspective_weights(Vec3::Y, Vec3::new(3.0, 1.0, 2.0)), Vec3::Y);
    assert_eq!(ByDivision::reciprocal(4.0), 0.25);
}

/// A shader that gives on what it is told.
struct Tell;

impl Shader for Tell {
    type Constant = usize;
    type Varying = f32;
    type Output = (usize, Fragment<f32>);

    /// A square in the middle, from w = 2 on the left to w = 4 on the right; and a corner behind the eye.
    fn position(&self, vertex: usize) -> Vec4 {
        let (x, y, w) =
            [(-0.5, -0.5, 2.0), (0.5, -0.5, 4.0), (0.5, 0.5, 4.0), (-0.5, 0.5, 2.0), (0.0, 0.0, -1.0)]
                [vertex];
        Vec4::new(x * w, y * w, 0.5 * w, w)
    }

    fn triangle(&self, face: usize) -> Option<usize> {
        (face < 3).then_some(face)
    }

    fn corner(&self, face: usize, corner: usize) -> f32 {
        [[0.0, 1.0, 1.0], [0.0, 1.0, 0.0], [9.0; 3]][face][corner]
    }

    fn fragment(&self, face: usize, fragment: Fragment<f32>) -> Option<(usize, Fragment<f32>)> {
        (fragment.y != 3).then_some((face, fragment))
    }
}

/// A target of another kind: what came to each of its 8×8 pixels.
struct Log(Vec<Option<(usize, Fragment<f32>)>>);

impl Target<(usize, Fragment<f32>)> for Log {
    fn bounds(&self) -> Bounds {
        window(8, 8)
    }

    fn test(&mut self, x: i32, y: i32, _: f32) -> bool {
        self.0[(8 * y + x) as usize].is_none()
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, output: (usize, Fragment<f32>)) {
        assert_eq!(depth, output.1.depth);
        self.0[(8 * y + x) as usize] = Some(output);
    }

    fn clear(&mut self) {
        self.0.fill(None);
    }
}

/// Any shader and any target: a rejected triangle is not counted as left out, a dropped fragment not written, and
/// varyings are the ray's.
#[test]
fn the_loop_draws_any_shader_to_any_target() {
    let mut log = Log(vec![None; 64]);
    // The last triangle is rejected by the shader, before anyone knows that it reaches behind the eye.
    let triangles = [[0, 1, 2], [0, 2, 3], [0, 1, 4], [4, 4, 4]];
    assert_eq!(render(&Tell, 5, &triangles, PerPixel(ByDivision), ZF32, &mut log), 1);
    for (n, seen) in log.0.iter().enumerate() {
        let (x, y) = (n as i32 % 8, n as i32 / 8);
        let inside = (2..6).contains(&x) && (2..6).contains(&y) && y != 3;
        assert_eq!(seen.is_some(), inside, "({x}, {y})");
        let Some((face, fragment)) = seen else { continue };
        // z/w is ½ everywhere, from −1 to 1: ¾ in the window.
        assert_eq!((fragment.x, fragment.y, fragment.depth), (x, y, 0.75));
        assert_eq!(*face, usize::from(x < y), "the diagonal is a left side of the lower triangle");
        // A share s of the way across the picture is μ of the way in space: s = 2μ / (1 + μ)·… with depths 2 and 4.
        let s = (f64::from(x) - 1.5) / 4.0;
        let exact = s / 4.0 / (s / 4.0 + (1.0 - s) / 2.0);
        assert!((f64::from(fragment.varying) - exact).abs() < 1e-6, "({x}, {y})");
    }
    // One triangle by itself, affinely.
    let mut alone = Log(vec![None; 64]);
    let corners =
        [Vec4::new(0.0, 0.0, 0.25, 1.0), Vec4::new(8.0, 0.0, 0.25, 0.5), Vec4::new(0.0, 8.0, 0.25, 1.0)];
    draw_triangle(&Tell, 7, corners, [0.0, 8.0, 0.0], Affine, &mut alone);
    for x in 0..7 {
        assert_eq!(alone.0[x].map(|(face, fragment)| (face, fragment.varying)), Some((7, x as f32 + 0.5)));
    }
}

/// A floor and more of it: the same number of allocations, one for the depths and one for each model's vertices.
#[test]
fn drawing_allocates_nothing_per_triangle_or_fragment() {
    let model = Model::read(Path::new(FLOOR[0]), BOTH).unwrap();
    let texture = Image::read(Path::new(FLOOR[1])).unwrap();
    let normals = corner_normals(&model);
    let to_clip = perspective::perspective(60.0, 1.0, 0.1, 100.0).unwrap();
    let uniforms = Uniforms { normals: &normals, texture: Some(&texture), to_clip, ..Uniforms::new(&model) };
    for keep in DEPTHS {
        for row in METHODS {
            let way = (row.run.draw)(&keep.run);
            let count = |models: usize, side: u16| {
                let mut image = Image::new(side, side, Format::Rgb);
                let models = vec![uniforms; models];
                allocation_counter::measure(|| {
                    way(&models, Planes { near: 0.1, far: 100.0 }, &mut image);
                })
                .count_total
            };
            assert_eq!([count(1, 50), count(1, 100), count(2, 50)], [2, 2, 3], "{}, {}", keep.name, row.name);
        }
    }
}

/// A vertical field of view keeps what is in it when the picture grows wider, and −z of eye space is ahead.
#[test]
fn the_view_has_its_origin_at_the_eye_and_looks_along_minus_z() {
    let (eye, center) = (Vec3::new(3.0, -2.0, 5.0), Vec3::new(1.0, 1.0, -1.0));
    let to_eye = view(eye, center, Vec3::Y).unwrap();
    assert!(to_eye.transform_point3(eye).length() < 1e-6);
    let distance = eye.distance(center);
    assert!(to_eye.transform_point3(center).distance(Vec3::new(0.0, 0.0, -distance)) < 2e-6);
    for point in [Vec3::ZERO, Vec3::new(-4.0, 2.0, 9.0), Vec3::new(0.5, 7.0, -3.0)] {
        let exact =
            checks::view::seen(point.as_dvec3(), eye, center, Vec3::Y) - DVec3::Z * f64::from(distance);
        assert!(to_eye.transform_point3(point).as_dvec3().distance(exact) < 5e-6);
    }
    assert_eq!(view(eye, eye, Vec3::Y), None);
    for aspect in [1.0, 2.0] {
        let clip =
            perspective::perspective(90.0, aspect, 0.1, 10.0).unwrap() * Vec4::new(aspect, 1.0, -1.0, 1.0);
        assert!((clip.truncate() / clip.w).truncate().distance(Vec2::ONE) < 1e-6);
    }
}
