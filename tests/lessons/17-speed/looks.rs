//! The shaders of all lessons, each by any plan: their own loop's pixels.

use std::sync::Arc;

use clipping::assembly::Topology;
use clipping::mesh::Vertex;
use clipping::{Counts, Cull, Mesh};
use common::{Attributes, Color, Format, Image, Mat3, Mat4, Model, Vec2, Vec3, Vec4};
use fastrand::Rng;
use filtering::filter::{Anisotropic, Bilinear, Bilinear8, Nearest, Trilinear};
use filtering::scene::Filterable;
use filtering::shader::Filtered;
use filtering::{MIPMAPS, WRAPS};
use lighting::normal_map::ObjectNormals;
use lighting::reflection::{Halfway, Mirrored, PointLit};
use lighting::shader::{PerCorner, PerPixel, PerTriangle};
use lighting::specular_map::Shining;
use lighting::surface::Smooth;
use lighting::tangent::TangentNormals;
use lighting::toon::{Swollen, Toon};
use lighting::{PointLight, Scene};
use perspective::lighting::Clamped;
use perspective::scene::Loaded;
use perspective::{perspective, view};
use proptest::prelude::*;
use proptest::sample::select;
use scene::lamps::Lamps;
use scene::shader::{AtPixels, AtVertices, Look, Placed, Textured};
use scene::{Filtering, Paint};
use shaders::lighting::{Flat, Gouraud, Quantized};
use shaders::shader::{Fragment, Shader, Varying};
use shaders::source::{Texture, White};
use shaders::{Lit, SHADERS};
use speed::eight::EachPixel;
use speed::frame::Shared;

use crate::any_scene::tiled;
use crate::canvas::{Canvas, Way, differing, drawn};

/// A camera before a sphere of radius 1, or in it.
#[derive(Clone, Debug)]
struct Shot {
    size: [u16; 2],
    eye: Vec3,
    center: Vec3,
    fov: f32,
    cull: Cull,
    /// Latitudes of the sphere.
    bands: usize,
    /// How often it has its texture.
    repeats: f32,
    /// The light of lessons 9 and 13, which need not be 1 long.
    light: Vec3,
    seed: u64,
}

impl Shot {
    fn to_clip(&self) -> Mat4 {
        let [width, height] = self.size.map(f32::from);
        let projection = perspective(self.fov, width / height, 0.01, 20.0).unwrap_or_default();
        projection * view(self.eye, self.center, Vec3::Y).unwrap_or_default()
    }

    /// The sphere as text, with normals and texture coordinates, in which some of its normals and places are moved.
    fn model(&self, rng: &mut Rng) -> Model {
        let shape = scene::sphere(self.bands, 2 * self.bands);
        let mut text = String::new();
        for vertex in &shape.vertices {
            let moved = vertex.position * (1.0 + 0.3 * rng.f32());
            let normal = vertex.normal + 0.4 * Vec3::new(rng.f32(), rng.f32(), rng.f32());
            let uv = self.repeats * (vertex.uv - 0.3);
            text += &format!("v {} {} {}\n", moved.x, moved.y, moved.z);
            text += &format!("vn {} {} {}\nvt {} {}\n", normal.x, normal.y, normal.z, uv.x, uv.y);
        }
        for triangle in &shape.triangles {
            let [a, b, c] = triangle.map(|n| n + 1);
            text += &format!("f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}\n");
        }
        Model::parse(text.as_bytes(), BOTH).expect("the text is an OBJ file")
    }

    /// Asserts that a shader's picture is the same by each way.
    fn check<W: Shared>(&self, way: Way, name: &str, shader: &W, mesh: &Mesh) {
        let draw = |canvas: &mut Canvas| canvas.draw(shader, mesh, self.cull);
        let (expected, counts): (Image, Counts) = drawn(Way::Simple, self.size, BACKGROUND, draw);
        for way in [Way::Blocks, way] {
            let (got, got_counts) = drawn(way, self.size, BACKGROUND, draw);
            assert_eq!(differing(&expected, &got), None, "{name} by {way:?}");
            assert_eq!(got_counts, counts, "{name} by {way:?}");
        }
    }

    /// The same of a shader of so many triangles that is asked pixel by pixel, and of it with holes.
    fn check_each(&self, way: Way, name: &str, keeps_all: bool, shader: &impl AnyShader, faces: usize) {
        let vertices = (0..faces as u32)
            .flat_map(|face| (0..3).map(move |corner| Vertex { position: 3 * face + corner, face, corner }));
        let (indices, faces) = ((0..3 * faces as u32).collect(), (0..faces as u32).collect());
        let mesh = Mesh { vertices: vertices.collect(), topology: Topology::List, indices, faces };
        for holes in [false, true] {
            let shader = Erased { shader, holes };
            let name = if holes { &format!("{name} with holes") } else { name };
            self.check(way, name, &EachPixel { shader, keeps_all: keeps_all && !holes }, &mesh);
        }
    }
}

const BOTH: Attributes = Attributes { normals: true, uvs: true };

const BACKGROUND: Color = Color { r: 1, g: 2, b: 3, a: 4 };

/// Colours at random, transparent ones among them.
fn noise(rng: &mut Rng, width: u16, height: u16) -> Image {
    let mut image = Image::new(width, height, Format::Rgba);
    image.set_all(|_| {
        let [r, g, b, a] = rng.u32(..).to_le_bytes();
        Color { r, g, b, a }
    });
    image
}

/// A shader without its types, so that the loops are compiled once for all: what is interpolated are the weights of the triangle's
/// corners, of which it makes what it needs at each pixel.
trait AnyShader: Sync {
    fn position(&self, face: usize, corner: usize) -> Vec4;
    fn is_drawn(&self, face: usize) -> bool;
    fn fragment(&self, face: usize, fragment: Fragment<Vec3>) -> Option<Color>;
}

/// A shader, and the positions of its triangles.
struct With<'a, S>(S, &'a [[u32; 3]]);

impl<S: Shader<Output = Color> + Sync> AnyShader for With<'_, S> {
    fn position(&self, face: usize, corner: usize) -> Vec4 {
        self.0.position(self.1[face][corner] as usize)
    }

    fn is_drawn(&self, face: usize) -> bool {
        self.0.triangle(face).is_some()
    }

    fn fragment(&self, face: usize, fragment: Fragment<Vec3>) -> Option<Color> {
        let Fragment { x, y, depth, varying: weights } = fragment;
        let varying = S::Varying::interpolate([0, 1, 2].map(|corner| self.0.corner(face, corner)), weights);
        self.0.fragment(self.0.triangle(face)?, Fragment { x, y, depth, varying })
    }
}

/// It may be given holes, told by the place in the picture.
struct Erased<'a> {
    shader: &'a dyn AnyShader,
    holes: bool,
}

impl Shader for Erased<'_> {
    type Constant = usize;
    type Varying = Vec3;
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        self.shader.position(vertex / 3, vertex % 3)
    }

    fn triangle(&self, face: usize) -> Option<usize> {
        self.shader.is_drawn(face).then_some(face)
    }

    fn corner(&self, _: usize, corner: usize) -> Vec3 {
        Vec3::AXES[corner]
    }

    fn fragment(&self, face: usize, fragment: Fragment<Vec3>) -> Option<Color> {
        let dropped = self.holes && (fragment.x / 3 + fragment.y / 2) % 2 == 0;
        if dropped { None } else { self.shader.fragment(face, fragment) }
    }
}

fn shot() -> impl Strategy<Value = (Shot, Way)> {
    let near = prop::array::uniform3(-2.5..2.5_f32).prop_map(Vec3::from);
    let size = select(vec![[80, 60], [97, 33], [64, 64], [9, 90]]);
    let cull = select(vec![Cull::None, Cull::Back, Cull::Front]);
    let camera = (near.clone(), near, 20.0..120.0_f32);
    let repeats = select(vec![1.0, 3.0, 3.0, 3.0, 1e5, 1e7, 1e10, 1e30, 3e38]);
    let bright = select(vec![1.0, 1.0, 1.0, 20.0, 1e30, f32::MAX, f32::INFINITY, f32::NAN]);
    let look = (repeats, bright.prop_map(|bright| Vec3::new(0.6, 0.0, 0.8) * bright), cull);
    (size, camera, look, 3..9_usize, any::<u64>(), tiled()).prop_map(
        |(size, (eye, center, fov), (repeats, light, cull), bands, seed, way)| {
            (Shot { size, eye, center, fov, cull, bands, repeats, light, seed }, way)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn lesson_9s_shaders((shot, way) in shot()) {
        let mut rng = Rng::with_seed(shot.seed);
        let texture = noise(&mut rng, 13, 8);
        let loaded = Loaded::new(shot.model(&mut rng), texture, textures::Wrap::Repeat);
        let uniforms = loaded.uniforms(shot.light, shot.to_clip());
        assert_eq!(SHADERS.len(), 5, "a shader is missing here");
        macro_rules! check {
            ($name:literal, $source:expr, $lighting:expr, $keeps_all:expr) => {
                let lit = With(Lit::new(uniforms, $source, $lighting), loaded.model.triangles());
                shot.check_each(way, $name, $keeps_all, &lit, loaded.model.triangles().len());
            };
        }
        check!("flat", White, Flat, true);
        check!("flat-texture", Texture, Flat, true);
        check!("gouraud", White, Gouraud, false);
        check!("gouraud-texture", Texture, Gouraud, false);
        check!("quantized", White, Quantized, false);
        // And lesson 10's.
        check!("clamped", Texture, Clamped, true);
        // One of them with its own types.
        let mesh = clipping::mesh::indexed(&loaded.model, &loaded.normals, BOTH);
        let shader = Lit::new(uniforms, Texture, Gouraud);
        shot.check(way, "gouraud-texture as it is", &EachPixel { shader, keeps_all: false }, &mesh);
    }

    #[test]
    fn lesson_12s_shaders((shot, way) in shot()) {
        let mut rng = Rng::with_seed(shot.seed);
        let [texture, normals, shine] = [(); 3].map(|()| noise(&mut rng, 9, 14));
        let loaded = Loaded::new(shot.model(&mut rng), texture, textures::Wrap::Repeat);
        let scene = &Scene {
            uniforms: loaded.uniforms(Vec3::ZERO, shot.to_clip()),
            to_world: Mat4::IDENTITY,
            normals_to_world: Mat3::IDENTITY,
            eye: shot.eye,
            light: PointLight::default(),
        };
        macro_rules! check {
            ($name:literal, $shader:expr) => {
                let shader = With($shader, loaded.model.triangles());
                shot.check_each(way, $name, true, &shader, loaded.model.triangles().len());
            };
        }
        type Blinn<'a, S> = PerPixel<'a, PointLit<Halfway>, S>;
        check!("flat", PerTriangle::<PointLit<Mirrored>>::new(scene));
        check!("phong-vertex", PerCorner::<PointLit<Mirrored>>::new(scene));
        check!("phong", PerPixel::<PointLit<Mirrored>, _>::new(scene, Smooth));
        check!("blinn-phong", Blinn::new(scene, Smooth));
        check!("object-normals", Blinn::new(scene, ObjectNormals(&normals)));
        check!("tangent-normals", Blinn::new(scene, TangentNormals(&normals)));
        let surface = TangentNormals(&normals);
        check!("specular-map", Blinn::new(scene, Shining { surface, map: &shine }));
        check!("outline", Swollen::new(scene, 0.1, Color::RED));
        check!("toon", PerPixel::<Toon, _>::new(scene, Smooth));
        // One of them with its own types.
        let mesh = clipping::mesh::indexed(&loaded.model, &loaded.normals, BOTH);
        let shader = Blinn::new(scene, TangentNormals(&normals));
        shot.check(way, "tangent-normals as it is", &EachPixel { shader, keeps_all: true }, &mesh);
    }

    #[test]
    fn lesson_13s_shaders((shot, way) in shot(), wrap in select(WRAPS), mipmap in 0..MIPMAPS.len()) {
        let mut rng = Rng::with_seed(shot.seed);
        let (width, height) = (rng.u16(1..40), rng.u16(1..40));
        let texture = noise(&mut rng, width, height);
        let loaded = Loaded::new(shot.model(&mut rng), texture, textures::Wrap::Repeat);
        let model = Filterable::new(loaded, MIPMAPS[mipmap].run, wrap.run);
        let surface = model.surface(shot.light, shot.to_clip());
        let size = Vec2::from_array(shot.size.map(f32::from));
        macro_rules! check {
            ($name:literal, $filter:expr) => {
                let shader = || Filtered {
                    uniforms: surface.uniforms,
                    texture: surface.texture,
                    filter: $filter,
                    lighting: Clamped,
                    size,
                };
                shot.check(way, $name, &shader(), surface.mesh);
                let triangles = surface.uniforms.model.triangles();
                let each = With(shader(), triangles);
                shot.check_each(way, concat!($name, ", pixel by pixel"), true, &each, triangles.len());
            };
        }
        check!("nearest", Nearest);
        check!("bilinear", Bilinear);
        check!("bilinear-8", Bilinear8);
        check!("trilinear", Trilinear);
        check!("anisotropic", Anisotropic);
    }

    #[test]
    fn lesson_16s_shaders((shot, way) in shot()) {
        let mut rng = Rng::with_seed(shot.seed);
        let shape = scene::sphere(shot.bands, 2 * shot.bands);
        let colors: Vec<Color> = shape.vertices.iter().map(|_| Color::random(rng.u64(..))).collect();
        let texture = MIPMAPS[0].run.texture(&noise(&mut rng, 32, 16), filtering::Wrap::Repeat);
        let uvs: Vec<Vec2> = shape.vertices.iter().map(|vertex| 2.0 * vertex.uv).collect();
        let texture = Arc::new(texture);
        let mesh = scene::Mesh::new(&shape, Paint::Texture(texture.clone()));
        let mut lamps = Lamps::default();
        lamps.set(&[PointLight::default(), PointLight { position: -2.0 * Vec3::X, ..PointLight::default() }]);
        let placed = Placed {
            mesh: &mesh,
            to_world: Mat4::IDENTITY,
            normals_to_world: Mat3::IDENTITY,
            eye: shot.eye,
            lamps: &lamps,
        };
        let to_clip = shot.to_clip();
        macro_rules! check {
            ($name:expr, $base:expr, $lighting:expr) => {
                let look = Look { mesh: &mesh, to_clip, base: $base, lighting: $lighting };
                shot.check_each(way, $name, true, &With(look, &shape.triangles), shape.triangles.len());
            };
        }
        let color = Color { a: 100, ..Color::RED };
        check!("colour, unlit", color, ());
        check!("colour, at vertices", color, AtVertices(placed));
        check!("colour, at pixels", color, AtPixels(placed));
        check!("colours, unlit", &colors[..], ());
        check!("colours, at vertices", &colors[..], AtVertices(placed));
        check!("colours, at pixels", &colors[..], AtPixels(placed));
        for filter in [Filtering::Nearest, Filtering::Bilinear, Filtering::Trilinear] {
            let size = Vec2::from_array(shot.size.map(f32::from));
            let base = || Textured { texture: &texture, uvs: &uvs, filter, size };
            let name = |lit: &str| format!("{filter:?}, {lit}");
            check!(&name("unlit"), base(), ());
            check!(&name("at vertices"), base(), AtVertices(placed));
            check!(&name("at pixels"), base(), AtPixels(placed));
            // One of them with its own types.
            let shader = Look { mesh: &mesh, to_clip, base: base(), lighting: AtPixels(placed) };
            let shader = EachPixel { shader, keeps_all: true };
            shot.check(way, &name("at pixels as it is"), &shader, mesh.assembled());
        }
    }
}
