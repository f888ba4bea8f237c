//! The shaders of all lessons, each by any plan: their own loop's pixels.

use std::sync::Arc;

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
use scene::shader::{AtPixels, AtVertices, Base, Lighting as SceneLighting, Look, Placed, Textured};
use scene::{Filtering, Paint};
use shaders::lighting::{Flat, Gouraud, Lighting, Quantized};
use shaders::shader::{Fragment, Shader, Varying};
use shaders::source::{Source, Texture, White};
use shaders::{Lit, SHADERS, Uniforms};
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

    /// The same of a shader that is asked pixel by pixel, and of it with holes.
    fn check_each<S>(&self, way: Way, name: &str, keeps_all: bool, shader: S, mesh: &Mesh)
    where
        S: Shader<Output = Color> + Sync,
        S::Constant: Send + Sync + 'static,
        S::Varying: Send + Sync + 'static,
    {
        let [whole, holes] = [false, true].map(|holes| AnyShader { shader: &shader, holes });
        self.check(way, name, &EachPixel { shader: whole, keeps_all }, mesh);
        self.check(way, &format!("{name} with holes"), &EachPixel { shader: holes, keeps_all: false }, mesh);
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

/// A shader that computes with these types, so that the loops are compiled once for all of them. It may be given holes, told by the
/// place in the picture.
struct AnyShader<'a, C, V> {
    shader: &'a (dyn Shader<Constant = C, Varying = V, Output = Color> + Sync),
    holes: bool,
}

impl<C: Copy, V: Varying> Shader for AnyShader<'_, C, V> {
    type Constant = C;
    type Varying = V;
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        self.shader.position(vertex)
    }

    fn triangle(&self, face: usize) -> Option<C> {
        self.shader.triangle(face)
    }

    fn corner(&self, face: usize, corner: usize) -> V {
        self.shader.corner(face, corner)
    }

    fn fragment(&self, constant: C, fragment: Fragment<V>) -> Option<Color> {
        let Fragment { x, y, .. } = fragment;
        let dropped = self.holes && (x / 3 + y / 2) % 2 == 0;
        if dropped { None } else { self.shader.fragment(constant, fragment) }
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
        let mesh = clipping::mesh::indexed(&loaded.model, &loaded.normals, BOTH);
        assert_eq!(SHADERS.len(), 5, "a shader is missing here");
        fn check<S, L>(shot: &Shot, way: Way, name: &str, uniforms: Uniforms, mesh: &Mesh, keeps_all: bool)
        where
            S: Source<Varying: Send + Sync + 'static> + Default + Sync,
            L: Lighting<Constant: Send + Sync + 'static, Varying: Send + Sync + 'static> + Default + Sync,
        {
            shot.check_each(way, name, keeps_all, Lit::new(uniforms, S::default(), L::default()), mesh);
        }
        check::<White, Flat>(&shot, way, "flat", uniforms, &mesh, true);
        check::<Texture, Flat>(&shot, way, "flat-texture", uniforms, &mesh, true);
        check::<White, Gouraud>(&shot, way, "gouraud", uniforms, &mesh, false);
        check::<Texture, Gouraud>(&shot, way, "gouraud-texture", uniforms, &mesh, false);
        check::<White, Quantized>(&shot, way, "quantized", uniforms, &mesh, false);
        // And lesson 10's.
        check::<Texture, Clamped>(&shot, way, "clamped", uniforms, &mesh, true);
    }

    #[test]
    fn lesson_12s_shaders((shot, way) in shot()) {
        let mut rng = Rng::with_seed(shot.seed);
        let [texture, normals, shine] = [(); 3].map(|()| noise(&mut rng, 9, 14));
        let loaded = Loaded::new(shot.model(&mut rng), texture, textures::Wrap::Repeat);
        let mesh = clipping::mesh::indexed(&loaded.model, &loaded.normals, BOTH);
        let scene = Scene {
            uniforms: loaded.uniforms(Vec3::ZERO, shot.to_clip()),
            to_world: Mat4::IDENTITY,
            normals_to_world: Mat3::IDENTITY,
            eye: shot.eye,
            light: PointLight::default(),
        };
        let scene = &scene;
        let phong = PerPixel::<PointLit<Mirrored>, _>::new(scene, Smooth);
        let object = PerPixel::<PointLit<Halfway>, _>::new(scene, ObjectNormals(&normals));
        let tangent = PerPixel::<PointLit<Halfway>, _>::new(scene, TangentNormals(&normals));
        let surface = TangentNormals(&normals);
        let shining = PerPixel::<PointLit<Halfway>, _>::new(scene, Shining { surface, map: &shine });
        shot.check_each(way, "flat", true, PerTriangle::<PointLit<Mirrored>>::new(scene), &mesh);
        shot.check_each(way, "phong-vertex", true, PerCorner::<PointLit<Mirrored>>::new(scene), &mesh);
        shot.check_each(way, "phong", true, phong, &mesh);
        shot.check_each(way, "object-normals", true, object, &mesh);
        shot.check_each(way, "tangent-normals", true, tangent, &mesh);
        shot.check_each(way, "specular-map", false, shining, &mesh);
        shot.check_each(way, "outline", true, Swollen::new(scene, 0.1, Color::RED), &mesh);
        shot.check_each(way, "toon", true, PerPixel::<Toon, _>::new(scene, Smooth), &mesh);
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
                shot.check_each(way, concat!($name, ", pixel by pixel"), true, shader(), surface.mesh);
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
        fn check<B, L>(shot: &Shot, way: Way, name: &str, mesh: &scene::Mesh, base: B, lighting: L)
        where
            B: Base<Constant: Send + Sync + 'static, Varying: Send + Sync> + Sync,
            L: SceneLighting<Varying: Send + Sync> + Sync,
        {
            let look = Look { mesh, to_clip: shot.to_clip(), base, lighting };
            shot.check_each(way, name, true, look, mesh.assembled());
        }
        let color = Color { a: 100, ..Color::RED };
        check(&shot, way, "colour, unlit", &mesh, color, ());
        check(&shot, way, "colour, at vertices", &mesh, color, AtVertices(placed));
        check(&shot, way, "colour, at pixels", &mesh, color, AtPixels(placed));
        check(&shot, way, "colours, unlit", &mesh, &colors[..], ());
        check(&shot, way, "colours, at vertices", &mesh, &colors[..], AtVertices(placed));
        check(&shot, way, "colours, at pixels", &mesh, &colors[..], AtPixels(placed));
        for filter in [Filtering::Nearest, Filtering::Bilinear, Filtering::Trilinear] {
            let size = Vec2::from_array(shot.size.map(f32::from));
            let base = || Textured { texture: &texture, uvs: &uvs, filter, size };
            let name = |lit: &str| format!("{filter:?}, {lit}");
            check(&shot, way, &name("unlit"), &mesh, base(), ());
            check(&shot, way, &name("at vertices"), &mesh, base(), AtVertices(placed));
            check(&shot, way, &name("at pixels"), &mesh, base(), AtPixels(placed));
        }
    }
}
