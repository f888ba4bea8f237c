use checks::lamp::Highlight;
use clipping::Cull;
use common::{Format, Image, Mat3, Mat4, Method, Vec3};
use lighting::normalisation::Normalise;
use lighting::power::Raise;
use lighting::{Draw, Falloff, LESSON, METHODS, NORMALISATIONS, POWERS, PointLight};
use transforms::{affine, scale, translate};
use verify::stability::Must::{AtMost, Between, Exact};
use verify::stability::{Case, Row, every_method};

use crate::stage::Stage;

/// The program's light, at another place.
fn at(x: f32, y: f32, z: f32) -> PointLight {
    PointLight { position: Vec3::new(x, y, z), ..PointLight::default() }
}

/// One that makes highlights of that exponent.
fn shining(shininess: f32) -> PointLight {
    PointLight { shininess, ..at(1.2, -0.9, 1.5) }
}

/// A wall whose normals are its own.
fn wall(light: PointLight) -> Stage {
    Stage::wall([Vec3::Z; 4], light)
}

/// A ball of many triangles.
fn ball(light: PointLight) -> Stage {
    Stage::sphere([48, 80], Vec3::ONE, light)
}

/// A ball, stretched.
fn egg(light: PointLight) -> Stage {
    Stage::sphere([48, 80], Vec3::new(1.0, 0.4, 0.7), light)
}

/// The wall under a map that stretches, slants and turns, as far from the axes as any.
fn slanting() -> Stage {
    let turn = Mat4::from_mat3(affine::euler(Vec3::new(25.0, -35.0, 50.0)));
    let normals =
        [Vec3::new(-0.4, -0.4, 1.0), Vec3::new(0.4, -0.4, 1.0), Vec3::ONE, Vec3::new(-0.4, 0.4, 1.0)];
    let to_world = translate(Vec3::new(0.1, 0.2, -0.3))
        * turn
        * affine::shear_x(0.5, -0.3)
        * scale(Vec3::new(0.5, 0.9, 0.6));
    Stage { to_world, cull: Cull::None, ..Stage::wall(normals, at(1.0, 1.0, 2.0)) }
}

const ALL: &str = "flat, phong-vertex, phong, blinn-phong";

/// Half a level is what rounding a colour costs, and a little more what `f32` does before.
const ROUNDED: &[Row] = &[(ALL, AtMost(0.52))];

type Make = fn() -> Stage;

/// Scenes, and by how many grey levels a white surface in them is off, at worst: a wall against its rays, a ball against the
/// smooth one.
const TABLE: &[Case<Make>] = &[
    (
        "a wall",
        || wall(at(0.3, 0.2, 2.0)),
        &[
            ("flat", Between(95.0, 97.0)),
            ("phong-vertex", Between(118.0, 120.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    ("the lamp behind the wall", || wall(at(0.3, 0.2, -1.0)), ROUNDED),
    ("the lamp in the wall's plane", || wall(at(0.3, 0.2, 0.0)), ROUNDED),
    ("the lamp at a point that is a pixel", || wall(at(0.0, 0.0, 0.0)), ROUNDED),
    ("the lamp at a corner", || wall(at(-1.0, -1.0, 0.0)), ROUNDED),
    (
        "the lamp 1/1000 before a pixel",
        || wall(at(0.0, 0.0, 1e-3)),
        &[("flat, phong-vertex", Between(1.0, 3.0)), ("phong, blinn-phong", AtMost(0.52))],
    ),
    (
        "the lamp 1/1000 before a pixel, fading by 1/d²",
        || wall(PointLight { falloff: Falloff::Quadratic, ..at(0.0, 0.0, 1e-3) }),
        &[
            ("flat", Between(202.0, 204.0)),
            ("phong-vertex", Between(203.0, 205.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "the lamp 10⁻³⁰ before a pixel, fading by 1/d²",
        || wall(PointLight { falloff: Falloff::Quadratic, ..at(0.0, 0.0, 1e-30) }),
        ROUNDED,
    ),
    (
        "a highlight smaller than a triangle",
        || wall(PointLight { shininess: 1000.0, ..at(0.6, -0.6, 3.0) }),
        &[
            ("flat", Between(73.0, 75.0)),
            ("phong-vertex", Between(108.0, 110.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "E = 0",
        || wall(shining(0.0)),
        &[
            ("flat", Between(24.0, 26.0)),
            ("phong-vertex", Between(11.0, 13.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "E = 0 on a ball",
        || ball(shining(0.0)),
        &[
            ("flat", Between(104.0, 106.0)),
            ("phong-vertex", Between(92.0, 94.0)),
            ("phong, blinn-phong", AtMost(0.7)),
        ],
    ),
    (
        "E = 1",
        || wall(shining(1.0)),
        &[
            ("flat", Between(86.0, 88.0)),
            ("phong-vertex", Between(53.0, 55.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "E = 1 on a ball",
        || ball(shining(1.0)),
        &[
            ("flat", Between(16.0, 18.0)),
            ("phong-vertex", Between(3.0, 5.0)),
            ("phong", AtMost(1.2)),
            ("blinn-phong", AtMost(0.8)),
        ],
    ),
    (
        "E = 33.5",
        || wall(shining(33.5)),
        &[
            ("flat", Between(111.0, 113.0)),
            ("phong-vertex", Between(105.0, 107.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "E = 10⁴",
        || wall(PointLight { shininess: 1e4, ..at(0.6, -0.6, 3.0) }),
        &[
            ("flat", Between(92.0, 94.0)),
            ("phong-vertex", Between(101.0, 103.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "E = 10⁴ on a ball",
        || ball(PointLight { shininess: 1e4, ..at(0.6, -0.6, 3.0) }),
        &[("flat, phong-vertex", Between(5.0, 7.0)), ("phong", AtMost(0.9)), ("blinn-phong", AtMost(1.7))],
    ),
    (
        "normals 90° apart",
        || {
            Stage::wall(
                [
                    Vec3::new(-1.0, 0.0, 1.0),
                    Vec3::new(1.0, 0.0, 1.0),
                    Vec3::new(1.0, 0.0, 1.0),
                    Vec3::new(-1.0, 0.0, 1.0),
                ],
                at(1.0, 1.0, 2.0),
            )
        },
        &[
            ("flat", Between(112.0, 114.0)),
            ("phong-vertex", Between(152.0, 154.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "normals 178° apart",
        || {
            Stage::wall(
                [
                    Vec3::new(-57.0, 0.0, 1.0),
                    Vec3::new(57.0, 0.0, 1.0),
                    Vec3::new(57.0, 0.0, 1.0),
                    Vec3::new(-57.0, 0.0, 1.0),
                ],
                at(1.0, 1.0, 2.0),
            )
        },
        &[
            ("flat", Between(81.0, 83.0)),
            ("phong-vertex", Between(91.0, 93.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "opposite normals, which cancel in the middle",
        || {
            let across = Vec3::new(0.6, 0.0, 0.8);
            Stage::wall([-across, across, across, -across], at(1.0, 1.0, 2.0))
        },
        &[
            ("flat", Between(81.0, 83.0)),
            ("phong-vertex", Between(56.0, 58.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "no normals",
        || Stage::without_normals(at(1.0, 1.0, 2.0)),
        &[("flat", Between(81.0, 83.0)), ("phong-vertex, phong, blinn-phong", AtMost(0.52))],
    ),
    (
        "a ball of 7,520 triangles",
        || ball(at(1.0, 1.0, 2.0)),
        &[
            ("flat", Between(28.0, 30.0)),
            ("phong-vertex", Between(17.0, 19.0)),
            ("phong", AtMost(1.1)),
            ("blinn-phong", AtMost(0.9)),
        ],
    ),
    (
        "a ball of 168 triangles",
        || Stage::sphere([8, 12], Vec3::ONE, at(1.0, 1.0, 2.0)),
        &[
            ("flat", Between(129.0, 131.0)),
            ("phong-vertex", Between(101.0, 103.0)),
            ("phong", Between(25.0, 27.0)),
            ("blinn-phong", Between(13.0, 15.0)),
        ],
    ),
    (
        "a ball, the lamp near its side and fading by 1/d",
        || ball(PointLight { falloff: Falloff::Linear, ..at(0.8, 0.6, 1.0) }),
        &[
            ("flat", Between(52.0, 54.0)),
            ("phong-vertex", Between(20.0, 22.0)),
            ("phong", AtMost(2.0)),
            ("blinn-phong", AtMost(1.6)),
        ],
    ),
    ("a ball, the lamp in its middle", || ball(at(0.0, 0.0, 0.0)), ROUNDED),
    ("a ball, the lamp behind it", || ball(at(0.0, 0.0, -3.0)), ROUNDED),
    (
        "an egg",
        || egg(at(1.0, 1.0, 2.0)),
        &[
            ("flat", Between(34.0, 36.0)),
            ("phong-vertex", Between(10.0, 12.0)),
            ("phong", AtMost(1.0)),
            ("blinn-phong", AtMost(0.8)),
        ],
    ),
    (
        "an egg, normals by M alone",
        || Stage {
            normals_by: Some(Mat3::from_diagonal(Vec3::new(1.0, 0.4, 0.7))),
            ..egg(at(1.0, 1.0, 2.0))
        },
        &[
            ("flat", Between(34.0, 36.0)),
            ("phong-vertex", Between(82.0, 84.0)),
            ("phong", Between(94.0, 96.0)),
            ("blinn-phong", Between(96.0, 98.0)),
        ],
    ),
    (
        "a ball enlarged all around, normals by M alone",
        || Stage {
            normals_by: Some(Mat3::from_diagonal(Vec3::splat(1.1))),
            ..Stage::sphere([48, 80], Vec3::splat(1.1), at(1.0, 1.0, 2.0))
        },
        &[
            ("flat", Between(25.0, 27.0)),
            ("phong-vertex", Between(19.0, 21.0)),
            ("phong", AtMost(1.0)),
            ("blinn-phong", AtMost(0.9)),
        ],
    ),
    (
        "a wall stretched, slanted and turned",
        slanting,
        &[
            ("flat", Between(49.0, 51.0)),
            ("phong-vertex", Between(22.0, 24.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "the same, normals by M alone",
        || {
            let stage = slanting();
            Stage { normals_by: Some(Mat3::from_mat4(stage.to_world)), ..stage }
        },
        &[
            ("flat", Between(49.0, 51.0)),
            ("phong-vertex", Between(81.0, 83.0)),
            ("phong", Between(55.0, 57.0)),
            ("blinn-phong", Between(56.0, 58.0)),
        ],
    ),
    (
        "a wall mirrored",
        || {
            let normals =
                [Vec3::new(-0.4, -0.4, 1.0), Vec3::new(0.4, -0.4, 1.0), Vec3::ONE, Vec3::new(-0.4, 0.4, 1.0)];
            Stage {
                to_world: scale(Vec3::new(-1.0, 1.0, 1.0)),
                cull: Cull::Front,
                ..Stage::wall(normals, at(1.0, 1.0, 2.0))
            }
        },
        &[
            ("flat", Between(193.0, 195.0)),
            ("phong-vertex", Between(155.0, 157.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "a floor in steep perspective",
        || {
            let floor = Mat4::from_mat3(affine::rotate_x(-80.0)) * scale(Vec3::new(1.0, 3.0, 1.0));
            Stage { to_world: floor, ..wall(at(0.4, 0.5, 1.0)) }
        },
        &[
            ("flat", Between(76.0, 78.0)),
            ("phong-vertex", Between(125.0, 127.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "the lamp 10⁶ away",
        || wall(at(6e5, 0.0, 8e5)),
        &[
            ("flat", Between(15.0, 17.0)),
            ("phong-vertex", Between(11.0, 13.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "the lamp 10¹⁸ away",
        || wall(at(6e17, 0.0, 8e17)),
        &[
            ("flat", Between(15.0, 17.0)),
            ("phong-vertex", Between(11.0, 13.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "the lamp 10²⁰ away: it has no direction",
        || wall(at(6e19, 0.0, 8e19)),
        &[("flat, phong-vertex, phong", Between(97.0, 99.0)), ("blinn-phong", Between(146.0, 148.0))],
    ),
    (
        "everything 1000 times as large",
        || Stage { to_world: scale(Vec3::splat(1e3)), eye: Vec3::Z * 3e3, ..wall(at(300.0, 200.0, 2000.0)) },
        &[
            ("flat", Between(95.0, 97.0)),
            ("phong-vertex", Between(118.0, 120.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "everything 1/1000 as large",
        || Stage { to_world: scale(Vec3::splat(1e-3)), eye: Vec3::Z * 3e-3, ..wall(at(3e-4, 2e-4, 2e-3)) },
        &[
            ("flat", Between(95.0, 97.0)),
            ("phong-vertex", Between(118.0, 120.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "neither diffuse nor specular",
        || wall(PointLight { diffuse: 0.0, specular: 0.0, ..at(0.3, 0.2, 2.0) }),
        ROUNDED,
    ),
    (
        "a million times too bright",
        || wall(PointLight { diffuse: 1e6, specular: 1e6, ..at(0.3, 0.2, 2.0) }),
        ROUNDED,
    ),
    (
        "too bright in the highlight alone",
        || wall(PointLight { specular: 3.0, ..at(0.3, 0.2, 2.0) }),
        &[
            ("flat", Between(81.0, 83.0)),
            ("phong-vertex", Between(121.0, 123.0)),
            ("phong, blinn-phong", AtMost(0.52)),
        ],
    ),
    (
        "the eye and the lamp in a ball, whose normals point out",
        || Stage {
            eye: Vec3::new(0.0, 0.0, 0.2),
            cull: Cull::Front,
            ..Stage::new(&assets::sphere::sphere(12, 20).to_obj(), at(0.1, 0.2, 0.3))
        },
        ROUNDED,
    ),
];

/// Blinn's model has its own truth.
fn highlight(method: &str) -> Highlight {
    if method == "blinn-phong" { Highlight::Halfway } else { Highlight::Mirrored }
}

#[test]
fn every_method_does_what_it_must() {
    every_method(LESSON.name, METHODS, TABLE, |method: &Method<Draw>, make| {
        let stage = make();
        let (error, pixels) = stage.error(&stage.drawn(method.run), highlight(method.name));
        assert!(pixels > 100, "{pixels} pixels");
        error
    });
}

/// Wrong as they may be, the first two give what they promise, in every scene of few triangles whose normals go the right way.
#[test]
fn once_a_triangle_and_at_its_corners_is_what_it_says() {
    let mut scenes = 0;
    for &(name, make, _) in TABLE {
        let stage = make();
        // Where the lamp has no direction they have none either, and a mirror turns round the triangle's own normal.
        let left_out = ["10²⁰", "mirrored"].iter().any(|part| name.contains(part));
        if stage.normals_by.is_some() || left_out || stage.loaded.model.triangles().len() > 1000 {
            continue;
        }
        scenes += 1;
        for (method, at_corners) in [("flat", false), ("phong-vertex", true)] {
            let (error, pixels) =
                stage.error_of_promise(&stage.drawn(*verify::method(METHODS, method)), at_corners);
            // Corners rounded to 1/256 px move what is steep by a little more than a colour is rounded.
            assert!(error <= 0.8 && pixels > 100, "{name}, {method}: {error} in {pixels} pixels");
        }
    }
    assert!(scenes > 25, "{scenes}");
}

/// How far what becomes of a vector is from the vector of length 1 in its direction.
const LENGTHS: &[Case<Vec3>] = &[
    (
        "of length 1",
        Vec3::new(0.6, 0.0, -0.8),
        &[
            ("never, exact", AtMost(3e-8)),
            ("fast-0", Between(0.0334, 0.0342)),
            ("fast-1", Between(0.00167, 0.00171)),
            ("fast-2", Between(4.27e-6, 4.36e-6)),
        ],
    ),
    (
        "half-way between normals 60° apart",
        Vec3::new(0.0, 0.866_025_4, 0.0),
        &[
            ("never", Between(0.132, 0.136)),
            ("fast-0", Between(0.0237, 0.0243)),
            ("fast-1", Between(0.000863, 0.000881)),
            ("fast-2", Between(1.06e-6, 1.09e-6)),
            ("exact", AtMost(7e-8)),
        ],
    ),
    (
        "half-way between normals 120° apart",
        Vec3::new(0.3, 0.0, 0.4),
        &[
            ("never", Between(0.494, 0.505)),
            ("fast-0", Between(0.0334, 0.0342)),
            ("fast-1", Between(0.00167, 0.00171)),
            ("fast-2", Between(4.27e-6, 4.36e-6)),
            ("exact", AtMost(3e-8)),
        ],
    ),
    (
        "half-way between normals 179° apart",
        Vec3::new(0.0, 0.008_726_535, 0.0),
        &[
            ("never", Between(0.981, 1.002)),
            ("fast-0", Between(0.0099, 0.0102)),
            ("fast-1", Between(0.000151, 0.000155)),
            ("fast-2", AtMost(2e-7)),
            ("exact", Exact),
        ],
    ),
    (
        "what is left where normals cancel but for rounding",
        Vec3::new(6e-8, 0.0, -3e-8),
        &[
            ("never", Between(0.989, 1.01)),
            ("fast-0", Between(0.0122, 0.0126)),
            ("fast-1", Between(0.000229, 0.000235)),
            ("fast-2", AtMost(9e-8)),
            ("exact", AtMost(7e-8)),
        ],
    ),
    ("where normals cancel", Vec3::ZERO, &[("never, fast-0, fast-1, fast-2, exact", Exact)]),
    (
        "10⁻¹⁸ long",
        Vec3::new(3e-19, 9e-19, -3e-19),
        &[
            ("never", Between(0.989, 1.01)),
            ("fast-0", Between(0.0176, 0.018)),
            ("fast-1", Between(0.000472, 0.000482)),
            ("fast-2", AtMost(5e-7)),
            ("exact", AtMost(8e-8)),
        ],
    ),
    (
        "10⁻²³ long",
        Vec3::new(3e-24, 9e-24, -3e-24),
        &[("never, exact", Between(0.99, 1.01)), ("fast-0, fast-1, fast-2", Between(0.989, 1.01))],
    ),
    (
        "10¹⁸ long",
        Vec3::new(3e17, 9e17, -3e17),
        &[
            ("never", Between(9.85e17, 1.005e18)),
            ("fast-0", Between(0.0246, 0.0252)),
            ("fast-1", Between(0.000931, 0.000951)),
            ("fast-2", Between(1.36e-6, 1.39e-6)),
            ("exact", AtMost(3e-8)),
        ],
    ),
    (
        "10²⁰ long",
        Vec3::new(3e19, 9e19, -3e19),
        &[
            ("never", Between(9.85e19, 1.005e20)),
            ("fast-0", Between(4.16, 4.26)),
            ("fast-1, fast-2", Between(f64::INFINITY, f64::INFINITY)),
            ("exact", Between(0.99, 1.01)),
        ],
    ),
    (
        "as long as can be",
        Vec3::MAX,
        &[
            ("never", Between(5.83e38, 5.96e38)),
            ("fast-0", Between(3.05e19, 3.12e19)),
            ("fast-1, fast-2", Between(f64::INFINITY, f64::INFINITY)),
            ("exact", Between(0.99, 1.01)),
        ],
    ),
];

#[test]
fn a_vector_becomes_1_long() {
    every_method(LESSON.name, NORMALISATIONS, LENGTHS, |method: &Method<Normalise>, v| {
        let exact = v.as_dvec3().normalize_or_zero();
        ((method.run.one)(*v).as_dvec3() - exact).length()
    });
}

/// Exponents, and by how many grey levels the power of any cosine is off, at worst, where 1 is white.
const EXPONENTS: &[Case<f32>] = &[
    ("E = 0", 0.0, &[("powf, squaring, table, table-linear", Exact), ("schlick", Between(252.0, 258.0))]),
    (
        "E = 0.4, nearest to 0",
        0.4,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring", Between(252.0, 258.0)),
            ("schlick", Between(47.2, 48.2)),
            ("table", Between(20.8, 21.3)),
            ("table-linear", Between(8.96, 9.15)),
        ],
    ),
    (
        "E = 1",
        1.0,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring, schlick", Exact),
            ("table", Between(0.4995, 0.5005)),
            ("table-linear", AtMost(2e-5)),
        ],
    ),
    (
        "E = 2",
        2.0,
        &[
            ("powf, squaring", AtMost(3e-5)),
            ("schlick", Between(22.7, 23.3)),
            ("table", Between(0.988, 1.009)),
            ("table-linear", AtMost(0.002)),
        ],
    ),
    (
        "E = 4.5, half-way",
        4.5,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring", Between(9.78, 9.98)),
            ("schlick", Between(37.8, 38.6)),
            ("table", Between(2.21, 2.27)),
            ("table-linear", AtMost(0.009)),
        ],
    ),
    (
        "E = 8",
        8.0,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring", AtMost(6e-5)),
            ("schlick", Between(43.5, 44.5)),
            ("table", Between(3.93, 4.02)),
            ("table-linear", AtMost(0.03)),
        ],
    ),
    (
        "E = 32",
        32.0,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring", AtMost(0.0003)),
            ("schlick", Between(49.4, 50.5)),
            ("table", Between(15.3, 15.7)),
            ("table-linear", Between(0.454, 0.464)),
        ],
    ),
    (
        "E = 33.5, half-way",
        33.5,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring", Between(1.37, 1.41)),
            ("schlick", Between(49.4, 50.5)),
            ("table", Between(16.0, 16.4)),
            ("table-linear", Between(0.497, 0.508)),
        ],
    ),
    (
        "E = 128",
        128.0,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring", AtMost(0.0008)),
            ("schlick", Between(50.9, 52.0)),
            ("table", Between(56.0, 57.2)),
            ("table-linear", Between(6.2, 6.33)),
        ],
    ),
    (
        "E = 1000",
        1e3,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring", AtMost(0.005)),
            ("schlick", Between(51.3, 52.4)),
            ("table", Between(216.0, 222.0)),
            ("table-linear", Between(101.0, 104.0)),
        ],
    ),
    (
        "E = 10⁴",
        1e4,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring", AtMost(0.02)),
            ("schlick", Between(51.4, 52.5)),
            ("table", Between(252.0, 258.0)),
            ("table-linear", Between(222.0, 227.0)),
        ],
    ),
    (
        "E = 10⁶",
        1e6,
        &[
            ("powf", AtMost(3e-5)),
            ("squaring", AtMost(0.02)),
            ("schlick", Between(51.4, 52.5)),
            ("table", Between(252.0, 258.0)),
            ("table-linear", Between(251.0, 257.0)),
        ],
    ),
];

#[test]
fn a_cosine_is_raised_to_a_power() {
    every_method(LESSON.name, POWERS, EXPONENTS, |method: &Method<Raise>, &exponent| {
        // Equal steps, and ever smaller ones towards 1, where large exponents are decided.
        let mut numbers: Vec<f32> = (0..=100_000).map(|n| n as f32 / 1e5).collect();
        numbers.extend((0..=24_000).map(|n| 1.0 - (-f64::from(n) / 1000.0).exp2() as f32));
        let exact: Vec<f64> = numbers.iter().map(|&x| f64::from(x).powf(exponent.into())).collect();
        (method.run.all)(exponent, &mut numbers);
        let off = numbers.iter().zip(exact).map(|(&got, exact)| {
            assert!((0.0..=1.0).contains(&got), "{got}");
            (f64::from(got) - exact).abs()
        });
        255.0 * off.fold(0.0, f64::max)
    });
}

/// Twice as many triangles, and four times the fragments, allocate as often: the depths once, the vertices once. A power's
/// table is no exception.
#[test]
fn drawing_allocates_nothing_per_triangle_or_fragment() {
    let powers = POWERS.iter().map(|row| (row.name, row.run.draw));
    for (name, draw) in METHODS.iter().map(|row| (row.name, row.run)).chain(powers) {
        let counts = [([8, 12], 50), ([15, 12], 50), ([8, 12], 100)].map(|(cuts, side)| {
            let stage = Stage::sphere(cuts, Vec3::ONE, at(1.0, 1.0, 2.0));
            let (scene, mut image) = (stage.scene(), Image::new(side, side, Format::Rgb));
            let draw = || drop(draw(&scene, &stage.mesh, Cull::Back, &mut image));
            allocation_counter::measure(draw).count_total
        });
        assert_eq!(counts, [2; 3], "{name}");
    }
}
