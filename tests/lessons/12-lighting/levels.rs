//! How many grey levels of a picture it costs to normalise and to raise to powers otherwise than exactly.
//!
//! Each pixel is compared with what `f64` makes of the very position, normal and texel that were interpolated there, so that
//! nothing but the reflection itself is measured.

use std::path::Path;

use checks::lamp::{Highlight, Lamp, level};
use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh, render};
use common::{Bounds, Color, Format, Image, Mat4, Model, Vec2, Vec3, Vec4};
use lighting::{Draw, NORMALISATIONS, POWERS, PointLight, Scene};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use shaders::shader::{Fragment, Shader};
use shaders::target::Target;
use textures::Wrap;
use verify::stability::Must::{AtMost, Between};
use verify::stability::{Case, every_method};

use crate::stage::BOTH;

const SIDE: u16 = 200;

/// What is interpolated at a pixel: (u, v), position, normal.
type Inputs = (Vec2, (Vec3, Vec3));

/// Draws what is interpolated.
struct Show<'a>(Scene<'a>);

impl Shader for Show<'_> {
    type Constant = ();
    type Varying = Inputs;
    type Output = Inputs;

    fn position(&self, vertex: usize) -> Vec4 {
        self.0.uniforms.to_clip * self.0.uniforms.model.positions()[vertex].extend(1.0)
    }

    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    fn corner(&self, face: usize, corner: usize) -> Inputs {
        (self.0.uv(face, corner), (self.0.position(face, corner), self.0.normal(face, corner)))
    }

    fn fragment(&self, (): (), fragment: Fragment<Inputs>) -> Option<Inputs> {
        Some(fragment.varying)
    }
}

/// Takes what is nearest.
struct Nearest(Vec<(f32, Option<Inputs>)>);

impl Target<Inputs> for Nearest {
    fn bounds(&self) -> Bounds {
        verify::window(SIDE.into(), SIDE.into())
    }

    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        depth < self.0[(y * i32::from(SIDE) + x) as usize].0
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, inputs: Inputs) {
        self.0[(y * i32::from(SIDE) + x) as usize] = (depth, Some(inputs));
    }

    fn clear(&mut self) {
        self.0.fill((1.0, None));
    }
}

/// The head as the program draws it.
fn head() -> (Loaded, Mesh) {
    let asset = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../assets").join(name);
    let model = Model::read(&asset("head.obj"), BOTH).unwrap();
    let loaded = Loaded::new(model, Image::read(&asset("head.tga")).unwrap(), Wrap::Clamp);
    let mesh = indexed(&loaded.model, &loaded.normals, BOTH);
    (loaded, mesh)
}

/// The largest error of a picture of the head under a light of that exponent, over all pixels and channels, in levels.
fn error((loaded, mesh): &(Loaded, Mesh), shininess: f32, draw: Draw) -> f64 {
    let eye = Vec3::new(0.55, 0.35, 2.35);
    let camera =
        perspective(45.0, 1.0, 0.1, 100.0).unwrap() * view(eye, Vec3::new(0.0, 0.12, 0.0), Vec3::Y).unwrap();
    let light = PointLight { shininess, ..PointLight::default() };
    let scene = Scene::placed(loaded, Mat4::IDENTITY, camera, eye, light).unwrap();
    let mut seen = Nearest(vec![(1.0, None); usize::from(SIDE) * usize::from(SIDE)]);
    render(&Show(scene), mesh, Cull::Back, Clipping::GuardBand, &mut seen);

    let mut image = Image::new(SIDE, SIDE, Format::Rgb);
    draw(&scene, mesh, Cull::Back, &mut image);
    let lamp = Lamp {
        position: light.position.as_dvec3(),
        ambient: light.ambient.into(),
        diffuse: light.diffuse.into(),
        specular: light.specular.into(),
        shininess: light.shininess.into(),
        fading: 0,
    };
    let mut worst = 0.0_f64;
    for ((.., color), (_, inputs)) in image.pixels().zip(&seen.0) {
        let Some((uv, (point, normal))) = inputs else { continue };
        let lit = lamp.on(point.as_dvec3(), normal.as_dvec3(), eye.as_dvec3(), Highlight::Halfway);
        let Color { r, g, b, .. } = scene.texel(*uv);
        for (got, base) in [(color.r, r), (color.g, g), (color.b, b)] {
            worst = worst.max((f64::from(got) - level(base.into(), lit)).abs());
        }
    }
    worst
}

const NORMALISED: &[Case<f32>] = &[
    (
        "E = 8",
        8.0,
        &[
            ("never", Between(121.0, 135.0)),
            ("fast-0", Between(43.0, 49.0)),
            ("fast-1", Between(3.0, 4.0)),
            ("fast-2, exact", AtMost(0.52)),
        ],
    ),
    (
        "E = 32",
        32.0,
        &[
            ("never", Between(122.0, 136.0)),
            ("fast-0", Between(86.0, 97.0)),
            ("fast-1", Between(10.0, 12.0)),
            ("fast-2", AtMost(0.54)),
            ("exact", AtMost(0.52)),
        ],
    ),
    (
        "E = 128",
        128.0,
        &[
            ("never", Between(118.0, 131.0)),
            ("fast-0", Between(97.0, 109.0)),
            ("fast-1", Between(34.0, 38.0)),
            ("fast-2", Between(0.56, 0.62)),
            ("exact", AtMost(0.52)),
        ],
    ),
    (
        "E = 1000",
        1000.0,
        &[
            ("never", Between(95.0, 106.0)),
            ("fast-0", Between(95.0, 107.0)),
            ("fast-1", Between(92.0, 102.0)),
            ("fast-2", Between(1.0, 1.2)),
            ("exact", AtMost(0.52)),
        ],
    ),
    (
        "E = 10⁴",
        1e4,
        &[
            ("never, fast-1", Between(78.0, 87.0)),
            ("fast-0", Between(97.0, 108.0)),
            ("fast-2", Between(6.0, 8.0)),
            ("exact", AtMost(0.52)),
        ],
    ),
];

#[test]
fn normalising_costs_levels() {
    let head = head();
    every_method("normalisations", NORMALISATIONS, NORMALISED, |method, &exponent| {
        error(&head, exponent, method.run.draw)
    });
}

const RAISED: &[Case<f32>] = &[
    (
        "E = 8",
        8.0,
        &[
            ("powf, squaring, table-linear", AtMost(0.52)),
            ("schlick", Between(17.0, 20.0)),
            ("table", Between(1.8, 2.2)),
        ],
    ),
    (
        "E = 32",
        32.0,
        &[
            ("powf, squaring", AtMost(0.52)),
            ("schlick", Between(19.0, 22.0)),
            ("table", Between(6.0, 7.0)),
            ("table-linear", Between(0.64, 0.71)),
        ],
    ),
    (
        "E = 33.5",
        33.5,
        &[
            ("powf", AtMost(0.52)),
            ("squaring", Between(0.9, 1.2)),
            ("schlick", Between(19.0, 22.0)),
            ("table", Between(6.0, 8.0)),
            ("table-linear", Between(0.66, 0.73)),
        ],
    ),
    (
        "E = 128",
        128.0,
        &[
            ("powf, squaring", AtMost(0.52)),
            ("schlick", Between(19.0, 23.0)),
            ("table", Between(21.0, 24.0)),
            ("table-linear", Between(2.7, 3.3)),
        ],
    ),
    (
        "E = 1000",
        1000.0,
        &[
            ("powf, squaring", AtMost(0.52)),
            ("schlick", Between(20.0, 23.0)),
            ("table", Between(83.0, 93.0)),
            ("table-linear", Between(39.0, 44.0)),
        ],
    ),
    (
        "E = 10⁴",
        1e4,
        &[
            ("powf, squaring", AtMost(0.52)),
            ("schlick", Between(20.0, 23.0)),
            ("table", Between(97.0, 108.0)),
            ("table-linear", Between(85.0, 95.0)),
        ],
    ),
];

#[test]
fn powers_cost_levels() {
    let head = head();
    every_method("powers", POWERS, RAISED, |method, &exponent| error(&head, exponent, method.run.draw));
}
