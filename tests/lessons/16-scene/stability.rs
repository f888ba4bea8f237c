use std::sync::Arc;

use clipping::Cull;
use common::{Color, DVec2, Image, Mat4, Vec3, Vec4};
use perspective::view;
use scene::levels::spheres;
use scene::{LESSON, Levels, METHODS};
use verify::stability::Must::{self, AtMost, Between, Exact};
use verify::stability::{Case, Row, every_method};

use crate::stage::{Stage, WHITE};

/// What is to be seen.
#[derive(Clone, Copy)]
enum Truth {
    /// The pixels whose centres are within the outline.
    Outline,
    /// None.
    Nothing,
    /// All.
    Everything,
}
use Truth::{Everything, Nothing, Outline};

/// Makes a stage.
type Make = (Truth, fn() -> Stage);

/// Where every method is right.
const ALL_EXACT: &[Row] = &[("8x16, 32x64, 128x256, by-size", Exact)];

/// Right within so many hundredths of a pixel, and not within one less.
const fn px(hundredths: u32) -> Must {
    match hundredths {
        0 => Exact,
        1 => Between(ROUNDING, 0.01),
        n => Between((n - 1) as f64 / 100.0, n as f64 / 100.0),
    }
}

/// How far off the methods are, in hundredths of a pixel; `by-size` by at most half a pixel, unless told.
macro_rules! off {
    [$coarse:literal, $middle:literal, $fine:literal] => {
        off![$coarse, $middle, $fine, AtMost(0.5)]
    };
    [$coarse:literal, $middle:literal, $fine:literal, $by_size:expr] => {
        &[("8x16", px($coarse)), ("32x64", px($middle)), ("128x256", px($fine)), ("by-size", $by_size)]
    };
}

/// Spheres, and what each method must do: exact is that just the pixels are white whose centres are within the true outline.
/// What is not is told by how far from the outline, in pixels, the centre is of the worst one.
const TABLE: &[Case<Make>] = &[
    // The size in the picture.
    ("half a pixel in radius", (Outline, || Stage::at(0.5, 0.5, -200.0)), off![0, 0, 0]),
    ("a few pixels", (Outline, || Stage::at(3.0, -2.0, -30.0)), off![3, 0, 0]),
    ("13 px in radius", (Outline, || Stage::at(2.0, 1.0, -8.0)), off![27, 2, 0]),
    ("53 px in radius", (Outline, || Stage::at(0.0, 0.0, -2.2)), off![173, 4, 0]),
    ("its outline across the picture", (Outline, || Stage::at(1.0, 0.5, -1.4)), off![155, 8, 0]),
    (
        "in a large picture",
        (Outline, || Stage::at(0.1, 0.0, -2.2).seen([1600, 1200], 60.0)),
        off![2119, 140, 6],
    ),
    (
        "3,000 px in radius",
        (Outline, || Stage::at(-0.98, 0.1, -20.0).seen([160, 120], 0.1)),
        off![5561, 251, 24],
    ),
    (
        "nearer than the finest step reaches",
        (Outline, near_the_finest_step),
        off![7920, 4817, 1120, px(1120)],
    ),
    // The place in the picture, and its shape.
    (
        "in the corner of a wide view",
        (Outline, || Stage::at(6.0, -3.6, -4.0).seen([200, 120], 110.0)),
        off![63, 0, 0],
    ),
    ("in a wide picture", (Outline, || Stage::at(-9.0, 1.0, -7.0).seen([300, 50], 40.0)), off![66, 0, 0]),
    ("in a tall picture", (Outline, || Stage::at(0.3, 9.0, -9.0).seen([50, 300], 100.0)), off![29, 1, 0]),
    (
        "off the middle of a frustum",
        (Outline, || Stage::at(3.0, 2.0, -5.0).framed([0.2, 1.0, 0.1, 0.7])),
        off![179, 8, 1],
    ),
    (
        "in parallel projection",
        (Outline, || Stage { projection: parallel(), ..Stage::at(-1.0, 0.5, -2.0) }),
        off![21, 0, 0],
    ),
    (
        "before a camera elsewhere",
        (Outline, || {
            let eye = view(Vec3::new(5.0, 4.0, 1.0), Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.3, 1.0, 0.1));
            Stage { inverse_camera: eye.unwrap(), ..Stage::at(1.5, 2.0, 2.5) }
        }),
        off![78, 1, 0],
    ),
    (
        "a million units large and away",
        (Outline, || Stage {
            scale: Vec3::splat(1e6),
            ..Stage::at(2e6, 1e6, -8e6).framed([-0.8, 0.8, -0.6, 0.6])
        }),
        off![22, 3, 0],
    ),
    // Poles.
    ("its pole towards the eye", (Outline, || turned([90.0, 0.0, 0.0])), off![177, 10, 0]),
    ("its south pole towards the eye", (Outline, || turned([-90.0, 30.0, 0.0])), off![167, 10, 0]),
    ("its poles on the outline", (Outline, || turned([0.0, 0.0, 90.0])), off![153, 6, 0]),
    ("turned anyhow", (Outline, || turned([33.0, 71.0, -125.0])), off![129, 7, 0]),
    // Scales.
    ("mirrored", (Outline, || scaled([-1.0, -1.0, -1.0])), off![187, 5, 0]),
    ("mirrored in one axis", (Outline, || scaled([1.0, -1.0, 1.0])), off![187, 5, 0]),
    ("stretched", (Outline, || scaled([1.6, 0.3, 1.0])), off![177, 3, 0]),
    ("stretched and mirrored twice", (Outline, || scaled([-1.2, 0.7, -0.4])), off![159, 6, 0]),
    ("a needle", (Outline, || scaled([1.8, 0.02, 0.02])), off![2, 0, 0]),
    ("scaled by 0", (Nothing, || scaled([0.0; 3])), ALL_EXACT),
    ("flattened along one axis", (Nothing, || scaled([1.0, 0.0, 1.0])), ALL_EXACT),
    ("flattened along the way to the eye", (Nothing, || scaled([1.0, 1.0, 0.0])), ALL_EXACT),
    ("too small to be seen", (Nothing, || scaled([1e-30; 3])), ALL_EXACT),
    // Out of the picture.
    ("behind the eye", (Nothing, || Stage::at(0.0, 0.0, 5.0)), ALL_EXACT),
    ("beside the eye, across its depth", (Nothing, || Stage::at(-2.5, 0.0, 0.3)), ALL_EXACT),
    ("beyond the far plane", (Nothing, || Stage::at(0.0, 0.0, -10_002.0)), ALL_EXACT),
    (
        "before the near plane",
        (Nothing, || Stage { scale: Vec3::splat(2e-3), ..Stage::at(0.0, 0.0, -0.007) }),
        ALL_EXACT,
    ),
    ("just beside the picture", (Nothing, || Stage::at(5.13, 0.0, -5.0)), ALL_EXACT),
    ("at the corner, within all planes' reach", (Nothing, || Stage::at(8.386, 6.467, -9.5)), ALL_EXACT),
    // Around the eye.
    ("around the eye, its inside not drawn", (Nothing, || Stage::at(0.2, 0.1, -0.3)), ALL_EXACT),
    (
        "around the eye, its inside drawn",
        (Everything, || Stage { cull: Cull::None, ..Stage::at(0.2, 0.1, -0.3) }),
        ALL_EXACT,
    ),
    (
        "around the eye and all there is",
        (Everything, || Stage { cull: Cull::Front, scale: Vec3::splat(-5e3), ..Stage::at(0.2, 0.1, -0.3) }),
        ALL_EXACT,
    ),
    (
        "cut open by the near plane",
        (Outline, || Stage { cull: Cull::None, ..Stage::at(0.0, 0.0, -1.9).framed([-0.8, 0.8, -0.6, 0.6]) }),
        off![247, 6, 0],
    ),
    // Windows.
    ("in a window of one pixel", (Everything, || Stage::at(0.0, 0.0, -1.2).seen([1, 1], 60.0)), ALL_EXACT),
    ("beside a window of one pixel", (Nothing, || Stage::at(0.0, 2.0, -5.0).seen([1, 1], 60.0)), ALL_EXACT),
    (
        "smaller than a window of one pixel",
        (Everything, || Stage::at(0.0, 0.0, -50.0).seen([1, 1], 60.0)),
        ALL_EXACT,
    ),
    ("in a column of pixels", (Outline, || Stage::at(0.0, 0.3, -4.0).seen([1, 90], 60.0)), off![0, 0, 0]),
    ("in a row of pixels", (Outline, || Stage::at(7.0, 0.2, -14.0).seen([200, 1], 30.0)), off![0, 0, 0]),
];

/// The assignment's projection: from −5 to 5.
fn parallel() -> Mat4 {
    Mat4::from_diagonal(Vec4::new(0.2, 0.2, -0.5, 1.0)) * Mat4::from_translation(Vec3::new(0.0, 0.0, 2.0))
}

fn turned(degrees: [f32; 3]) -> Stage {
    Stage { degrees: degrees.into(), ..Stage::at(-0.4, 0.3, -2.6) }
}

/// Before a telescope that looks at the middle of a facet of the finest step, on the outline: 76,394 px in radius.
fn near_the_finest_step() -> Stage {
    let half_a_cell = 180.0 / 256.0;
    let degrees = Vec3::new(0.0, half_a_cell, half_a_cell);
    Stage { degrees, ..Stage::at(-1.000_004, 0.0, -30.0).seen([160, 120], 0.003) }
}

fn scaled(scale: [f32; 3]) -> Stage {
    Stage { scale: scale.into(), ..turned([20.0, 50.0, -65.0]) }
}

/// Corners are rounded to 1/256 px, by a half of that each way at most, and places to `f32`: so near the outline a pixel may
/// be either.
const ROUNDING: f64 = 0.004;

/// How far from the outline the worst pixel's centre is. Infinite where what is to be seen has no outline and is not seen.
fn worst(truth: Truth, stage: &Stage, image: &Image) -> f64 {
    let white = |(.., color): &(i32, i32, Color)| *color == Color::WHITE;
    let outline = match truth {
        Outline => stage.outline().expect("it has an outline"),
        Nothing | Everything => {
            let wrong = image.pixels().filter(|pixel| white(pixel) == matches!(truth, Nothing)).count();
            return if wrong == 0 { 0.0 } else { f64::INFINITY };
        }
    };
    let center = |(x, y, _): &(i32, i32, Color)| DVec2::new((*x).into(), (*y).into()) + 0.5;
    let wrong = image.pixels().filter(|pixel| white(pixel) != outline.contains(center(pixel)));
    let off = wrong.map(|pixel| outline.distance(center(&pixel)).abs());
    off.filter(|&off| off > ROUNDING).fold(0.0, f64::max)
}

#[test]
fn a_sphere_covers_what_is_within_its_outline() {
    let levels: Vec<(&str, Arc<Levels>)> =
        METHODS.iter().map(|method| (method.name, spheres(method.run, &WHITE))).collect();
    every_method(LESSON.name, METHODS, TABLE, |method, (truth, make)| {
        let stage = make();
        let (_, levels) = levels.iter().find(|(name, _)| *name == method.name).unwrap();
        worst(*truth, &stage, &stage.drawn(levels).0)
    });
}
