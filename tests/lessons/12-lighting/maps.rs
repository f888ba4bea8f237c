//! Looks that read maps: where each is right, and where it is not.

use std::path::Path;

use assets::head::normals::encoded;
use checks::lamp::{Face, Highlight, Lamp, level};
use checks::picture::mean_difference;
use checks::ray::Screen;
use clipping::Cull;
use clipping::mesh::indexed;
use common::{Color, DVec2, DVec3, Format, Image, Mat4, Method, Model, Vec2, Vec3};
use lighting::normal_map::{ObjectNormals, decoded};
use lighting::specular_map::Shining;
use lighting::surface::{Smooth, Surface};
use lighting::tangent::{TangentNormals, handed, tangents, turned};
use lighting::{LESSON, LOOKS, Look, Maps, PointLight, Scene};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use proptest::prelude::*;
use tempfile::tempdir;
use textures::Wrap;
use transforms::{affine, scale};
use verify::stability::Must::{self, AtMost, Between};
use verify::stability::{Case, every_method};
use verify::{assert_drawn, draw, method};

use crate::stage::BOTH;

/// Width and height of the pictures.
const SIDE: u16 = 24;

const EYE: Vec3 = Vec3::new(0.0, 0.0, 3.0);

/// How a normal of the fine shape leans, in 127ths: to the right, down, and forwards. It is a texel without rounding.
const LEAN: DVec3 = DVec3::new(40.0, -30.0, 110.0);

/// A wall that fills the picture, with one texel in each map.
struct Wall {
    uvs: [(f32, f32); 4],
    normals: [Vec3; 4],
    clockwise: bool,
    to_world: Mat4,
    /// The texel of each map.
    object: DVec3,
    tangent: DVec3,
    /// The normal of the fine shape in the world, of any length; `None` is the wall's own.
    truth: Option<DVec3>,
}

/// Corners from the bottom left, counterclockwise.
const CORNERS: [Vec3; 4] = [
    Vec3::new(-8.0, -8.0, 0.0),
    Vec3::new(8.0, -8.0, 0.0),
    Vec3::new(8.0, 8.0, 0.0),
    Vec3::new(-8.0, 8.0, 0.0),
];

const UPRIGHT: [(f32, f32); 4] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];

/// As the maps were made for it.
fn wall() -> Wall {
    Wall {
        uvs: UPRIGHT,
        normals: [Vec3::Z; 4],
        clockwise: false,
        to_world: Mat4::IDENTITY,
        object: LEAN,
        tangent: LEAN,
        truth: Some(LEAN),
    }
}

fn light() -> PointLight {
    PointLight { shininess: 8.0, ..PointLight::default() }
}

fn texel(n: DVec3) -> Image {
    let [r, g, b] = (n + 128.0).to_array().map(|channel| channel as u8);
    one(Color::rgb(r, g, b))
}

fn one(color: Color) -> Image {
    let mut image = Image::new(1, 1, Format::Rgb);
    image.set(0, 0, color);
    image
}

impl Wall {
    fn model(&self) -> Model {
        let mut text = String::new();
        for (n, ((p, (u, v)), normal)) in CORNERS.iter().zip(self.uvs).zip(self.normals).enumerate() {
            text += &format!("v {} {} {}\nvt {u:e} {v:e}\n", p.x, p.y, p.z);
            text += &format!("vn {} {} {}\n# {n}\n", normal.x, normal.y, normal.z);
        }
        let faces = if self.clockwise { [[1, 3, 2], [1, 4, 3]] } else { [[1, 2, 3], [1, 3, 4]] };
        for face in faces {
            text += &face.iter().fold("f".into(), |line: String, n| format!("{line} {n}/{n}/{n}"));
            text += "\n";
        }
        Model::parse(text.as_bytes(), BOTH).unwrap()
    }

    fn drawn(&self, look: &Look, maps: &Maps) -> Image {
        let loaded = Loaded::new(self.model(), one(Color::WHITE), Wrap::Clamp);
        let mesh = indexed(&loaded.model, &loaded.normals, BOTH);
        let camera = perspective(45.0, 1.0, 0.1, 100.0).unwrap() * view(EYE, Vec3::ZERO, Vec3::Y).unwrap();
        let scene = Scene::placed(&loaded, self.to_world, camera, EYE, light()).unwrap();
        let mut image = Image::new(SIDE, SIDE, Format::Rgb);
        (look.draw)(&scene, maps, &mesh, Cull::None, &mut image);
        image
    }

    /// By how many grey levels a look is off at worst, against rays and the normal that the fine shape has there.
    fn error(&self, look: &Look) -> f64 {
        let in_tangent_space = look.normals.is_some_and(|file| file.contains("tangents"));
        let normals = texel(if in_tangent_space { self.tangent } else { self.object });
        let image = self.drawn(look, &Maps { normals, ..Maps::default() });
        let screen = Screen::ahead(45.0, DVec2::splat(SIDE.into()));
        let place = |p: Vec3| self.to_world.as_dmat4().transform_point3(p.as_dvec3());
        let turn = self.to_world.as_dmat4().inverse().transpose();
        let face = |[a, b, c]: [usize; 3]| Face {
            corners: [a, b, c].map(|n| place(CORNERS[n])),
            normals: [a, b, c].map(|n| turn.transform_vector3(self.normals[n].as_dvec3())),
        };
        let faces = [[0, 1, 2], [0, 2, 3]].map(face);
        let lamp = Lamp {
            position: light().position.as_dvec3(),
            ambient: light().ambient.into(),
            diffuse: light().diffuse.into(),
            specular: light().specular.into(),
            shininess: light().shininess.into(),
            fading: 0,
        };
        let eye = EYE.as_dvec3();
        let off = image.pixels().map(|(x, y, color)| {
            let hit = faces.iter().find_map(|face| face.hit(eye, screen.through(x, y)));
            let (_, point, normal) = hit.expect("it fills the picture");
            let lit = lamp.on(point, self.truth.unwrap_or(normal), eye, Highlight::Halfway);
            (f64::from(color.r) - level(255.0, lit)).abs()
        });
        off.fold(0.0, f64::max)
    }
}

type Make = fn() -> Wall;

/// Half a level is what rounding a colour costs.
const ROUNDED: Must = AtMost(0.52);

/// Walls, and by how many grey levels each look is off at worst.
const TABLE: &[Case<Make>] = &[
    (
        "a wall as the maps were made for it",
        wall,
        &[
            ("plain", Between(84.0, 86.0)),
            ("object-normals, tangent-normals, specular-map", ROUNDED),
            ("toon", Between(135.0, 137.0)),
        ],
    ),
    (
        "turned, with the model",
        || {
            let turn = Mat4::from_mat3(affine::euler(Vec3::new(20.0, -25.0, 40.0)));
            Wall { to_world: turn, truth: Some(turn.as_dmat4().transform_vector3(LEAN)), ..wall() }
        },
        &[
            ("plain", Between(95.0, 97.0)),
            ("object-normals, tangent-normals, specular-map", ROUNDED),
            ("toon", Between(136.0, 138.0)),
        ],
    ),
    (
        "the mirror image of the wall that the maps were made for",
        || Wall {
            uvs: [(1.0, 0.0), (0.0, 0.0), (0.0, 1.0), (1.0, 1.0)],
            truth: Some(DVec3::new(-40.0, -30.0, 110.0)),
            ..wall()
        },
        &[
            ("plain", Between(95.0, 97.0)),
            ("object-normals", Between(133.0, 135.0)),
            ("tangent-normals, specular-map", ROUNDED),
            ("toon", Between(131.0, 133.0)),
        ],
    ),
    (
        "the maps a quarter turn to the left",
        || Wall {
            uvs: [(0.0, 1.0), (0.0, 0.0), (1.0, 0.0), (1.0, 1.0)],
            truth: Some(DVec3::new(30.0, 40.0, 110.0)),
            ..wall()
        },
        &[
            ("plain", Between(94.0, 96.0)),
            ("object-normals", Between(117.0, 119.0)),
            ("tangent-normals, specular-map", ROUNDED),
            ("toon", Between(147.0, 149.0)),
        ],
    ),
    (
        "the maps upside down, as with v from the top",
        || Wall {
            uvs: [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)],
            truth: Some(DVec3::new(40.0, 30.0, 110.0)),
            ..wall()
        },
        &[
            ("plain", Between(94.0, 96.0)),
            ("object-normals", Between(104.0, 106.0)),
            ("tangent-normals, specular-map", ROUNDED),
            ("toon", Between(147.0, 149.0)),
        ],
    ),
    (
        "(u, v) that slant",
        || Wall { uvs: [(0.0, 0.0), (1.0, 0.0), (1.5, 1.0), (0.5, 1.0)], ..wall() },
        &[
            ("plain", Between(84.0, 86.0)),
            ("object-normals, tangent-normals, specular-map", ROUNDED),
            ("toon", Between(135.0, 137.0)),
        ],
    ),
    (
        "(u, v) within 10⁻³⁰",
        || Wall { uvs: UPRIGHT.map(|(u, v)| (u * 1e-30, v * 1e-30)), ..wall() },
        &[
            ("plain", Between(84.0, 86.0)),
            ("object-normals, tangent-normals, specular-map", ROUNDED),
            ("toon", Between(135.0, 137.0)),
        ],
    ),
    (
        "(u, v) within 10³⁰",
        || Wall { uvs: UPRIGHT.map(|(u, v)| (u * 1e30, v * 1e30)), ..wall() },
        &[
            ("plain", Between(84.0, 86.0)),
            ("object-normals, tangent-normals, specular-map", ROUNDED),
            ("toon", Between(135.0, 137.0)),
        ],
    ),
    (
        "(u, v) the same at all corners",
        || Wall { uvs: [(0.5, 0.5); 4], ..wall() },
        &[
            ("plain, tangent-normals, specular-map", Between(84.0, 86.0)),
            ("object-normals", ROUNDED),
            ("toon", Between(135.0, 137.0)),
        ],
    ),
    (
        "(u, v) on a line",
        || Wall { uvs: [(0.0, 0.0), (0.5, 0.25), (1.0, 0.5), (0.5, 0.25)], ..wall() },
        &[
            ("plain, tangent-normals, specular-map", Between(84.0, 86.0)),
            ("object-normals", ROUNDED),
            ("toon", Between(135.0, 137.0)),
        ],
    ),
    (
        "the model mirrored",
        || Wall {
            to_world: scale(Vec3::new(-1.0, 1.0, 1.0)),
            truth: Some(DVec3::new(-40.0, -30.0, 110.0)),
            ..wall()
        },
        &[
            ("plain", Between(95.0, 97.0)),
            ("object-normals, tangent-normals, specular-map", ROUNDED),
            ("toon", Between(244.0, 246.0)),
        ],
    ),
    (
        "the model stretched to three times its width",
        || Wall {
            to_world: scale(Vec3::new(3.0, 1.0, 1.0)),
            truth: Some(LEAN / DVec3::new(3.0, 1.0, 1.0)),
            ..wall()
        },
        &[
            ("plain", Between(63.0, 65.0)),
            ("object-normals", ROUNDED),
            ("tangent-normals, specular-map", Between(51.0, 53.0)),
            ("toon", Between(101.0, 103.0)),
        ],
    ),
    (
        "corners counted clockwise, normals in front",
        || Wall { clockwise: true, ..wall() },
        &[
            ("plain", Between(84.0, 86.0)),
            ("object-normals, tangent-normals, specular-map", ROUNDED),
            ("toon", Between(250.0, 252.0)),
        ],
    ),
    (
        "other normals than the maps were made for",
        || Wall {
            normals: [
                Vec3::new(-0.6, -0.6, 1.0),
                Vec3::new(0.6, -0.6, 1.0),
                Vec3::new(0.6, 0.6, 1.0),
                Vec3::new(-0.6, 0.6, 1.0),
            ],
            ..wall()
        },
        &[
            ("plain", Between(98.0, 100.0)),
            ("object-normals", ROUNDED),
            ("tangent-normals, specular-map", Between(19.0, 21.0)),
            ("toon", Between(143.0, 145.0)),
        ],
    ),
    (
        "a flat map on round normals",
        || Wall {
            normals: [
                Vec3::new(-0.6, -0.6, 1.0),
                Vec3::new(0.6, -0.6, 1.0),
                Vec3::new(0.6, 0.6, 1.0),
                Vec3::new(-0.6, 0.6, 1.0),
            ],
            tangent: DVec3::Z * 127.0,
            truth: None,
            ..wall()
        },
        &[
            ("plain, tangent-normals, specular-map", ROUNDED),
            ("object-normals", Between(98.0, 100.0)),
            ("toon", Between(72.0, 74.0)),
        ],
    ),
    (
        "normals along u",
        || Wall { normals: [Vec3::X; 4], truth: None, ..wall() },
        &[
            ("plain, tangent-normals, specular-map", ROUNDED),
            ("object-normals", Between(151.0, 153.0)),
            ("toon", Between(24.0, 26.0)),
        ],
    ),
    (
        "a normal behind the wall",
        || Wall {
            object: DVec3::new(40.0, -30.0, -110.0),
            tangent: DVec3::new(40.0, -30.0, -110.0),
            truth: Some(DVec3::new(40.0, -30.0, -110.0)),
            ..wall()
        },
        &[
            ("plain", Between(200.0, 202.0)),
            ("object-normals, tangent-normals, specular-map", ROUNDED),
            ("toon", Between(178.0, 180.0)),
        ],
    ),
    (
        "texels of no length",
        || Wall { object: DVec3::ZERO, tangent: DVec3::ZERO, truth: Some(DVec3::ZERO), ..wall() },
        &[
            ("plain", Between(200.0, 202.0)),
            ("object-normals, tangent-normals, specular-map", ROUNDED),
            ("toon", Between(178.0, 180.0)),
        ],
    ),
];

#[test]
fn a_wall_leans_as_its_map_says() {
    every_method(LESSON.name, LOOKS, TABLE, |look: &Method<Look>, wall| wall().error(&look.run));
}

/// Black shows no highlight, white all of it, and grey its share; what is body stays.
#[test]
fn a_specular_map_dims_highlights_alone() {
    let look = method(LOOKS, "specular-map");
    let drawn = |wall: &Wall, level: u8| {
        let maps = Maps { shine: one(Color::rgb(level, level, level)), normals: texel(LEAN) };
        wall.drawn(look, &maps)
    };
    let [none, some, all] = [0, 51, 255].map(|level| drawn(&wall(), level));
    let mut most = 0;
    for (x, y, black) in none.pixels() {
        let [share, white] = [&some, &all].map(|image| f64::from(image.get(x, y).unwrap().r));
        let black = f64::from(black.r);
        assert!((black + (white - black) / 5.0 - share).abs() <= 1.0, "({x}, {y}): {black} {share} {white}");
        most = most.max((white - black) as u8);
    }
    // S is 0.4 of 255, and the highlight's middle is in the picture.
    assert!((100..=102).contains(&most), "{most}");
    let dull = method(LOOKS, "tangent-normals");
    assert_eq!(wall().drawn(dull, &Maps { normals: texel(LEAN), ..Maps::default() }), all);
}

/// What is not read is not looked at.
#[test]
fn looks_without_maps_read_none() {
    let odd = || Maps { normals: texel(-LEAN), shine: one(Color::BLACK) };
    for (look, reads_normals, reads_shine) in [
        ("plain", false, false),
        ("object-normals", true, false),
        ("tangent-normals", true, false),
        ("specular-map", true, true),
        ("toon", false, false),
    ] {
        let look = method(LOOKS, look);
        assert_eq!((look.normals.is_some(), look.shine.is_some()), (reads_normals, reads_shine));
        let plain = wall().drawn(look, &Maps::default());
        let normals = wall().drawn(look, &Maps { normals: odd().normals, ..Maps::default() });
        let shine = wall().drawn(look, &Maps { shine: odd().shine, ..Maps::default() });
        assert_eq!((normals != plain, shine != plain), (reads_normals, reads_shine));
    }
}

/// Bytes kept for each triangle, and interpolated for each pixel besides (u, v) and the position.
#[test]
fn a_look_pays_for_what_it_uses() {
    fn bytes<S: Surface>() -> [usize; 2] {
        [size_of::<S::Constant>(), size_of::<S::Varying>()]
    }
    assert_eq!(bytes::<Smooth>(), [0, 12]);
    assert_eq!(bytes::<ObjectNormals>(), [0, 0]);
    assert_eq!(bytes::<TangentNormals>(), [16, 12]);
    assert_eq!(bytes::<Shining<ObjectNormals>>(), [0, 0]);
}

/// By glTF's custom, 2·c/255 − 1, a flat map leans by a third of a degree, and so by more than a level in a highlight.
#[test]
fn a_flat_map_is_flat() {
    assert_eq!(decoded(Color::rgb(128, 128, 255)), Vec3::Z);
    assert_eq!(decoded(Color::rgb(1, 255, 128)), Vec3::new(-1.0, 1.0, 0.0));
    let gltf = |code: u8| f64::from(code) * 2.0 / 255.0 - 1.0;
    let leaning = DVec3::new(gltf(128), gltf(128), gltf(255)).angle_between(DVec3::Z).to_degrees();
    assert!((0.31..0.32).contains(&leaning), "{leaning}");
}

/// What 8 bits cost: the texels that `assets` makes are read as they were meant.
#[test]
fn what_is_encoded_is_decoded() {
    for n in [LEAN, DVec3::X, DVec3::NEG_ONE, DVec3::new(-0.2, 0.9, -0.4)].map(DVec3::normalize) {
        let off = decoded(encoded(n)).as_dvec3().angle_between(n).to_degrees();
        assert!(off < 0.39, "{n}: {off} degrees");
    }
}

/// The small pictures of the program.
const SMALL: [&str; 2] = ["--size", "200x200"];

/// The head in few triangles, and its own maps.
const LOW: [&str; 4] = [
    "--model",
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/head-low.obj"),
    "--texture",
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/head.tga"),
];
const LOW_TANGENTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/head-low-tangents.png");
const TANGENTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/head-tangents.png");
const OBJECT_NORMALS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets/head-normals.png");

#[test]
fn every_look_shows_the_head() {
    for look in LOOKS {
        assert_drawn(&LESSON, &format!("look-{}", look.name), &[&SMALL[..], &["--look", look.name]].concat());
    }
}

#[test]
fn a_map_gives_few_triangles_a_face() {
    for (name, flags) in [
        ("low-plain", &[][..]),
        ("low-object-normals", &["--look", "object-normals", "--normal-map", OBJECT_NORMALS]),
        ("low-tangent-normals", &["--look", "tangent-normals", "--normal-map", LOW_TANGENTS]),
    ] {
        assert_drawn(&LESSON, name, &[&SMALL[..], &LOW, flags].concat());
    }
}

/// A flat map draws what is drawn without one, to a level: the head has triangles of any shape, and some without a tangent.
#[test]
fn a_flat_map_changes_nothing() {
    let folder = tempdir().unwrap();
    let flat = folder.path().join("flat.png");
    Maps::default().normals.write(&flat).unwrap();
    let plain = draw(LESSON.name, &SMALL);
    let flags = ["--look", "tangent-normals", "--normal-map", flat.to_str().unwrap()];
    let faults = checks::picture::faults(&plain, &draw(LESSON.name, &[&SMALL[..], &flags].concat()), 1);
    assert!(faults.is_empty(), "{} {}", faults.len(), faults[0]);
}

/// The ears, which share a patch, alone: all else of the texture is black, and black shows no highlight.
fn ears() -> [Image; 2] {
    let mut texture = Image::new(1024, 1024, Format::Rgb);
    // From the left edge of the one ear's front to the end of its back.
    let patch = |x: i32, y: i32| (144..400).contains(&x) && y < 144;
    let places = || (0..1024).flat_map(|y| (0..1024).map(move |x| (x, y)));
    places().filter(|&(x, y)| patch(x, y)).for_each(|(x, y)| texture.set(x, y, Color::WHITE));
    [texture.clone(), texture]
}

/// Both ears, each from its own side and with the light on it, by a look that reads this map: the mean difference of the one
/// from the other's mirror image, in grey levels.
fn ears_apart(look: &str, map: &str) -> f64 {
    let folder = tempdir().unwrap();
    let paths = ["texture.png", "shine.png"].map(|name| folder.path().join(name));
    ears().iter().zip(&paths).for_each(|(image, path)| image.write(path).unwrap());
    let [texture, shine] = paths.each_ref().map(|path| path.to_str().unwrap());
    let seen = |side: &str| {
        let [eye, light] = [format!("{side}1.6,0.1,0.8"), format!("{side}2,1.5,0.5")];
        let place = ["--eye", &eye, "--light-at", &light, "--center", "0,0.2,0", "--fov", "25"];
        let flags = ["--texture", texture, "--specular-map", shine, "--specular", "0", "--size", "400x400"];
        draw(LESSON.name, &[&place[..], &flags, &["--look", look, "--normal-map", map]].concat())
    };
    let left = seen("");
    let mut right = seen("-");
    right.flip_horizontally();
    let white = |image: &Image, x, y| image.get(x, y).is_some_and(|color| color.r > 0);
    mean_difference(&left, &right, |x, y| white(&left, x, y) && white(&right, x, y))
}

/// One ear's normals are not the other's: in tangent space they are mirrored with their patch.
#[test]
fn ears_share_a_patch_in_tangent_space_alone() {
    let [object, tangent] = [("object-normals", OBJECT_NORMALS), ("tangent-normals", TANGENTS)]
        .map(|(look, map)| ears_apart(look, map));
    assert!((56.0..60.0).contains(&object) && tangent < 0.1, "{object} {tangent}");
}

/// The two maps of a head say the same of its normals, each in its space: in the middle of most triangles that are larger than a
/// few texels, whether their patch lies mirrored or not. By how many degrees they differ, in the middle and nine times in ten.
#[test]
fn the_maps_agree() {
    let asset = |name: &str| Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../assets")).join(name);
    let [object, tangent, low] = ["head-normals.png", "head-tangents.png", "head-low-tangents.png"]
        .map(|name| Image::read(&asset(name)).unwrap());
    for (name, tangent) in [("head.obj", &tangent), ("head-low.obj", &low)] {
        let model = Model::read(&asset(name), BOTH).unwrap();
        let mut apart = [Vec::new(), Vec::new()];
        for (face, normals) in model.face_normals().enumerate() {
            let positions = [0, 1, 2].map(|corner| model.position(face, corner));
            let uvs = [0, 1, 2].map(|corner| model.uv(face, corner));
            let area = (uvs[1] - uvs[0]).perp_dot(uvs[2] - uvs[0]) / 2.0 * 1024.0 * 1024.0;
            if area.abs() < 8.0 || positions.iter().any(|p| p.x < 0.0) {
                continue;
            }
            let uv = (uvs[0] + uvs[1] + uvs[2]) / 3.0;
            // Behind an eyeball's front its back has the same texels.
            if area < 0.0 && uv.max_element() < 144.0 / 1024.0 {
                continue;
            }
            let normal = (normals[0] + normals[1] + normals[2]).normalize();
            let frame = handed(positions, uvs, normals);
            let [there, here] = [&object, tangent].map(|map| decoded(Wrap::Clamp.texel(map, uv)));
            let degrees = turned(here, frame, normal).angle_between(there).to_degrees();
            apart[usize::from(area < 0.0)].push(degrees);
        }
        let [upright, mirrored] = apart.map(|mut apart| {
            apart.sort_by(f32::total_cmp);
            [apart.len() / 2, apart.len() * 9 / 10].map(|n| apart[n])
        });
        assert!(upright[0] < 0.6 && upright[1] < 2.0, "{name}: {upright:?}");
        // Most of these are in hollows, where several surfaces share texels.
        assert!(mirrored[0] < 3.0, "{name}: {mirrored:?}");
    }
}

fn point() -> impl Strategy<Value = Vec3> {
    [-1.0_f32..1.0, -1.0_f32..1.0, -1.0_f32..1.0].prop_map(Vec3::from_array)
}

/// A triangle with an area, in space and in the map, and normals in front of it.
fn triangle() -> impl Strategy<Value = ([Vec3; 3], [Vec2; 3], [Vec3; 3])> {
    let corners = ([point(), point(), point()], [point(), point(), point()], [point(), point(), point()]);
    let made = corners.prop_filter_map("it is a sliver", |(positions, uvs, leans)| {
        let [a, b, c] = positions;
        let uvs = uvs.map(Vec3::truncate);
        let [s, t] = [uvs[1] - uvs[0], uvs[2] - uvs[0]];
        let front = (b - a).cross(c - a);
        let whole = front.length() > 0.05 && s.perp_dot(t).abs() > 0.05;
        whole.then(|| (positions, uvs, leans.map(|lean| (front.normalize() + 0.3 * lean).normalize())))
    });
    made.boxed()
}

/// A vector of tangent space on a triangle, in the world, with its first corner's normal.
fn leaned((positions, uvs, normals): ([Vec3; 3], [Vec2; 3], [Vec3; 3]), vector: Vec3) -> Vec3 {
    turned(vector, handed(positions, uvs, normals), normals[0])
}

fn near(a: Vec3, b: Vec3) -> Result<(), TestCaseError> {
    prop_assert!((a - b).length() < 2e-4, "{a} {b}");
    Ok(())
}

proptest! {
    /// Along u and v the position changes as the two directions say.
    #[test]
    fn tangents_are_derivatives((positions, uvs, _) in triangle()) {
        let [along_u, along_v] = tangents(positions, uvs).unwrap();
        let ([a, b, c], [i, j, k]) = (positions.map(Vec3::as_dvec3), uvs.map(Vec2::as_dvec2));
        let ([p, q], [s, t]) = ([b - a, c - a], [j - i, k - i]);
        let area = s.perp_dot(t).abs();
        for (side, steps) in [(p, s), (q, t)] {
            let sum = (along_u * steps.x + along_v * steps.y) / area;
            prop_assert!((sum - side).length() < 1e-12, "{sum} {side}");
        }
    }

    /// Lengths and angles stay: the frame has right angles, and is as the map is, mirrored or not.
    #[test]
    fn a_frame_has_right_angles(triangle in triangle(), vector in point()) {
        let frame = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| leaned(triangle, axis));
        for n in 0..3 {
            prop_assert!((frame[n].length() - 1.0).abs() < 1e-5);
            prop_assert!(frame[n].dot(frame[(n + 1) % 3]).abs() < 1e-5);
        }
        near(frame[2], triangle.2[0])?;
        near(leaned(triangle, vector), frame[0] * vector.x + frame[1] * vector.y + frame[2] * vector.z)?;
        let [s, t] = [triangle.1[1] - triangle.1[0], triangle.1[2] - triangle.1[0]];
        prop_assert_eq!(frame[0].cross(frame[1]).dot(frame[2]) > 0.0, s.perp_dot(t) > 0.0);
    }

    /// The other half of a face has the same patch of the map: what is drawn there is the mirror image.
    #[test]
    fn mirrored_triangles_lean_as_mirror_images((positions, uvs, normals) in triangle(), vector in point()) {
        let mirror = Vec3::new(-1.0, 1.0, 1.0);
        let here = leaned((positions, uvs, normals), vector);
        // Counterclockwise in the mirror, too.
        let swapped = |[a, b, c]: [Vec3; 3]| [a, c, b].map(|v| v * mirror);
        let there = leaned((swapped(positions), [uvs[0], uvs[2], uvs[1]], swapped(normals)), vector);
        near(there, here * mirror)?;
    }

    /// A map that is moved, stretched or repeated leans as before; one that is mirrored, as its mirror image.
    #[test]
    fn where_in_the_map_does_not_count(triangle in triangle(), vector in point(), by in point(), wide in 0.1_f32..10.0) {
        let (positions, uvs, normals) = triangle;
        let here = leaned(triangle, vector);
        near(leaned((positions, uvs.map(|uv| uv * wide + by.truncate()), normals), vector), here)?;
        let mirrored = leaned((positions, uvs.map(|uv| Vec2::new(-uv.x, uv.y)), normals), vector);
        near(mirrored, leaned(triangle, vector * Vec3::new(-1.0, 1.0, 1.0)))?;
    }

    /// A frame turns with its model.
    #[test]
    fn a_frame_turns_with_its_model(triangle in triangle(), vector in point(), angles in point()) {
        let turn = affine::euler(angles * 180.0);
        let (positions, uvs, normals) = triangle;
        let there = leaned((positions.map(|p| turn * p), uvs, normals.map(|n| turn * n)), vector);
        near(there, turn * leaned(triangle, vector))?;
    }

    /// Whatever (u, v) and normals are, nothing is NaN that was not before.
    #[test]
    fn nothing_is_lost(positions in [point(), point(), point()], uvs in [point(), point(), point()], n in point(), zero in 0..4) {
        let uvs = uvs.map(|uv| if zero & 1 == 1 { Vec2::splat(uv.x) } else { uv.truncate() });
        let normal = if zero & 2 == 2 { Vec3::ZERO } else { n.normalize_or_zero() };
        let tangent = handed(positions, uvs, [normal; 3]);
        prop_assert!(tangent.is_finite());
        let vector = turned(Vec3::new(0.3, -0.2, 0.9), tangent, normal);
        prop_assert!(vector.is_finite());
        if zero & 2 == 2 {
            prop_assert_eq!(vector, Vec3::ZERO);
        }
    }
}
