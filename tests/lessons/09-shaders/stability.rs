use std::cell::RefCell;

use checks::view::on_level;
use common::{Attributes, Bounds, Color, DVec3, Format, Image, Mat4, Model, Vec2, Vec3, Vec4};
use gouraud::corner_normals;
use shaders::lighting::{Lighting, Quantized};
use shaders::shader::{Fragment, Shader, render};
use shaders::target::Target;
use shaders::{Framebuffer, LESSON, METHODS, SHADERS, Uniforms, fit};
use transforms::projection;
use verify::stability::Must::{Exact, Fails};
use verify::stability::{Case, counted, every_method};
use verify::{SPHERE, method};

const BOTH: Attributes = Attributes { normals: true, uvs: true };

fn sphere() -> Model {
    Model::read(SPHERE.as_ref(), BOTH).unwrap()
}

/// A square picture in which a length of 1 is so much of the side, from a distance.
fn to_clip(zoom: f32, distance: f32) -> Mat4 {
    fit(zoom, Vec2::ONE) * projection(distance)
}

/// What a shader draws by a method into a square picture: the target, and how many triangles were left out.
fn drawn(uniforms: &Uniforms, shader: &str, way: &str, side: u16) -> (Framebuffer, usize) {
    let mut target = Framebuffer::new(Image::new(side, side, Format::Rgb));
    let left_out = method(METHODS, way)(method(SHADERS, shader))(uniforms, &mut target);
    (target, left_out)
}

/// Sixteen by sixteen texels, no two of one colour.
fn texture() -> Image {
    let mut texture = Image::new(16, 16, Format::Rgb);
    for (x, y, _) in texture.clone().pixels() {
        texture.set(x, y, Color::rgb(x as u8 * 16 + 15, y as u8 * 16 + 15, 128));
    }
    texture
}

/// Without a view and from infinitely far, the shaders draw what the loops of lessons 4 to 6 drew, depths and all.
#[test]
fn the_shaders_draw_what_lessons_4_to_6_drew() {
    let (model, texture) = (sphere(), texture());
    let normals = corner_normals(&model);
    let to_clip = to_clip(0.5, f32::INFINITY);
    let all = Uniforms { normals: &normals, texture: Some(&texture), to_clip, ..Uniforms::new(&model) };
    let blank = Image::new(200, 200, Format::Rgb);

    let mut flat = blank.clone();
    let flat_depths = zbuffer::z_f32(&zbuffer::surfaces(&model, Vec3::Z, &blank), &mut flat);
    let mut textured = blank.clone();
    let textured_depths =
        (method(textures::METHODS, "nearest").draw)(&model, &texture, Vec3::Z, &mut textured);
    let mut smooth = blank;
    let smooth_scene = gouraud::Scene {
        model: &model,
        normals: &corner_normals(&model),
        texture: &texture,
        wrap: gouraud::Wrap::Clamp,
        light: Vec3::Z,
    };
    let smooth_depths = method(gouraud::METHODS, "gouraud")(&smooth_scene, &mut smooth).depths;
    for (shader, picture, depths) in [
        ("flat", &flat, &flat_depths),
        ("flat-texture", &textured, &textured_depths),
        ("gouraud-texture", &smooth, &smooth_depths),
    ] {
        for way in METHODS {
            let (target, left_out) = drawn(&all, shader, way.name, 200);
            assert!(target.image == *picture, "{shader}, {}", way.name);
            // What lesson 6 draws black, having turned away from the light, lesson 9 leaves out.
            let same = target.depths == *depths || shader == "gouraud-texture";
            assert!(same && left_out == 0, "{shader}, {}", way.name);
        }
    }
}

/// A square before another; the one in front has holes. Both white, one darker.
struct Holes;

impl Shader for Holes {
    type Constant = usize;
    type Varying = ();
    type Output = Color;

    /// Three for each triangle, that covers the whole picture.
    fn position(&self, vertex: usize) -> Vec4 {
        let (x, y) = [(-1.125, -1.125), (3.125, -1.125), (-1.125, 3.125)][vertex % 3];
        Vec4::new(x, y, [2.0, 1.0, 9.0][vertex / 3], 1.0)
    }

    fn triangle(&self, face: usize) -> Option<usize> {
        // The third triangle is rejected: it would cover everything.
        (face < 2).then_some(face)
    }

    fn corner(&self, _: usize, _: usize) {}

    fn fragment(&self, face: usize, _: Fragment<()>) -> Option<Color> {
        match face {
            0 => None,
            _ => Some(Color::RED),
        }
    }
}

/// What is dropped in front leaves neither colour nor depth, so that what lies behind it is seen.
#[test]
fn a_discarded_fragment_leaves_colour_and_depth_alone() {
    let triangles = [[0, 1, 2], [3, 4, 5], [6, 7, 8]];
    let mut target = Framebuffer::new(Image::new(16, 16, Format::Rgb));
    assert_eq!(render(&Holes, 9, &triangles, &mut target), 0);
    for (x, y, color) in target.image.pixels() {
        assert_eq!((color, target.depths.get(x, y)), (Color::RED, 1.0));
    }
    let mut empty = Framebuffer::new(Image::new(16, 16, Format::Rgb));
    render(&Holes, 3, &triangles[..1], &mut empty);
    let nothing = Framebuffer::new(Image::new(16, 16, Format::Rgb));
    assert!(empty.depths == nothing.depths);
    target.clear();
    assert!(target.depths == nothing.depths && target.image == nothing.image);
}

/// From the dark side all is dropped, triangles or fragments: not one depth is kept.
#[test]
fn the_dark_side_is_dropped() {
    let text = b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n";
    let (model, texture) = (Model::parse(text, BOTH).unwrap(), texture());
    let light = Vec3::new(0.0, 0.6, -0.8);
    let normals = corner_normals(&model);
    let all = Uniforms { normals: &normals, texture: Some(&texture), light, ..Uniforms::new(&model) };
    for shader in SHADERS {
        for way in METHODS {
            let (target, _) = drawn(&all, shader.name, way.name, 20);
            let blank = Framebuffer::new(Image::new(20, 20, Format::Rgb));
            assert!(target.depths == blank.depths && target.image == blank.image, "{}", shader.name);
        }
    }
}

/// ⌊N·min(i, 1)⌋ / N, in whole numbers: i = n/240 for N that divide 240, where every quotient is exact enough.
#[test]
fn quantized_shows_as_many_levels_as_asked_for() {
    for levels in [1_u16, 2, 3, 4, 5, 6, 240] {
        let mut seen = Vec::new();
        for n in -240..=480_i32 {
            // In the middle between two of 240 steps, so that rounding has no say.
            let intensity = Quantized.intensity(levels.into(), (n as f32 + 0.5) / 240.0);
            let steps = (i64::from(n.min(239)) * i64::from(levels)).div_euclid(240);
            let expected = if n >= 240 { 1.0 } else { steps as f64 / f64::from(levels) };
            assert!((f64::from(intensity) - expected).abs() < 1e-6, "{levels}: {n}");
            seen.push(intensity.max(-1.0).to_bits());
        }
        seen.retain(|&bits| f32::from_bits(bits) >= 0.0);
        seen.dedup();
        assert_eq!(seen.len(), usize::from(levels) + 1);
    }
}

/// With one level all is black but where the light falls straight, and nothing there is dropped.
#[test]
fn one_level_is_black() {
    let model = sphere();
    let normals = corner_normals(&model);
    let one = Uniforms { levels: 1, normals: &normals, ..Uniforms::new(&model) };
    let (target, _) = drawn(&one, "quantized", "generic", 99);
    let (smooth, _) = drawn(&one, "gouraud", "generic", 99);
    assert!(target.image.pixels().all(|pixel| pixel.2 == Color::BLACK || pixel.2 == Color::WHITE));
    assert!(target.image.pixels().filter(|pixel| pixel.2 == Color::WHITE).count() < 9);
    assert!(target.depths == smooth.depths);
}

/// A face that is seen from a distance of 2, and corners for others: at the eye's height, behind it, at w = 2⁻¹⁹ and at
/// w = 2⁻²⁰.
const SEEN: &str = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 0 2\nv 0 0 9\nv 0 3 1.999996185302734375\n\
    v 0 3 1.9999980926513671875\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n";

/// Further faces, and how many triangles each shader leaves out since a corner is at w ≤ 1e-6.
const NEAR: &[Case<&str>] = &[
    (
        "three that reach behind the eye, two of which face away from the light",
        "f 1/1/1 2/1/1 4/1/1\nf 1/1/1 2/1/1 5/1/1\nf 4/1/1 4/1/1 5/1/1\n",
        &[
            // The flat shaders reject what faces away before anyone knows where it is.
            ("flat, flat-texture", Fails("left out 1")),
            ("gouraud, gouraud-texture, quantized", Fails("left out 3")),
        ],
    ),
    (
        "two that reach behind the eye, one of them dark at all corners: rejected before anyone knows where it is",
        "vn 0 0 -1\nf 4/1/1 4/1/1 5/1/1\nf 1/1/2 2/1/2 5/1/2\n",
        &[("flat, flat-texture, gouraud, gouraud-texture, quantized", Fails("left out 1"))],
    ),
    (
        "a corner at w = 1.9e-6",
        "f 1/1/1 2/1/1 6/1/1\n",
        &[("flat, flat-texture, gouraud, gouraud-texture, quantized", Exact)],
    ),
    (
        "a corner at w = 9.5e-7",
        "f 1/1/1 2/1/1 7/1/1\n",
        &[("flat, flat-texture, gouraud, gouraud-texture, quantized", Fails("left out 1"))],
    ),
];

#[test]
fn what_reaches_behind_the_eye_is_left_out_and_counted() {
    every_method(LESSON.name, SHADERS, NEAR, |shader, faces| {
        let (model, texture) = (Model::parse(format!("{SEEN}{faces}").as_bytes(), BOTH).unwrap(), texture());
        let normals = corner_normals(&model);
        let all = Uniforms {
            normals: &normals,
            texture: Some(&texture),
            light: Vec3::new(0.0, 0.6, 0.8),
            to_clip: to_clip(0.4, 2.0),
            ..Uniforms::new(&model)
        };
        let [by_dyn, by_generic] = ["dyn", "generic"].map(|way| {
            let (target, left_out) = drawn(&all, shader.name, way, 20);
            // The first face is at depth 0; what is not left out lies over it.
            assert_eq!(target.depths.get(10, 10) == 0.0, left_out > 0, "{way}");
            left_out
        });
        counted([("left out", by_dyn), ("by one way alone", by_dyn.abs_diff(by_generic))])
    });
}

/// Triangles whose corners all have this w.
struct At(f32);

impl Shader for At {
    type Constant = ();
    type Varying = ();
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        let (x, y) = [(-1.0, -1.0), (1.0, -1.0), (0.0, 1.0)][vertex];
        Vec4::new(x, y, 0.0, 1.0) * self.0
    }

    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    fn corner(&self, _: usize, _: usize) {}

    fn fragment(&self, (): (), _: Fragment<()>) -> Option<Color> {
        Some(Color::WHITE)
    }
}

/// The limit itself is behind the eye, the next number before it.
#[test]
fn w_of_1e_6_is_behind_the_eye() {
    for (w, left_out) in [(1e-6, 1), (1e-6f32.next_up(), 0)] {
        let mut target = Framebuffer::new(Image::new(8, 8, Format::Rgb));
        assert_eq!(render(&At(w), 3, &[[0, 1, 2]], &mut target), left_out, "{w}");
        assert_eq!(target.image.get(4, 3) == Some(Color::WHITE), left_out == 0, "{w}");
    }
}

/// From the eye at z = 2, a corner at z has w = 1 − z/2: 5e-6 is still in front of it, 5e-7 is not.
#[test]
fn just_before_the_eye_is_before_it() {
    for (z, left_out) in [(1.99999, 0), (1.999_999, 1)] {
        let text = format!("v -1 -1 0\nv 1 -1 0\nv 0 0 {z}\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n");
        let (model, texture) = (Model::parse(text.as_bytes(), BOTH).unwrap(), texture());
        let normals = corner_normals(&model);
        let all = Uniforms {
            normals: &normals,
            texture: Some(&texture),
            to_clip: to_clip(0.4, 2.0),
            ..Uniforms::new(&model)
        };
        assert_eq!(drawn(&all, "gouraud", "generic", 20).1, left_out, "{z}");
    }
}

/// A floor of two triangles half a unit below the eye, seen along z: what the texture shows at each pixel
/// against what the ray through it meets. As (u, v) is interpolated in the picture, both triangles warp it, each
/// in its own way; dividing by w at each pixel would mend this.
#[test]
fn a_floor_warps_under_perspective() {
    let text = b"v -1 -.5 1\nv 1 -.5 1\nv 1 -.5 -1\nv -1 -.5 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    let model = Model::parse(text, BOTH).unwrap();
    // The colour of a texel says where it is.
    let mut texture = Image::new(256, 256, Format::Rgb);
    for (x, y, _) in texture.clone().pixels() {
        texture.set(x, y, Color::rgb(x as u8, y as u8, 255));
    }
    let normals = corner_normals(&model);
    let warp = |shader: &str, distance: f32| {
        let to_clip = to_clip(0.4, distance);
        let floor = Uniforms {
            normals: &normals,
            light: Vec3::Y,
            texture: Some(&texture),
            to_clip,
            ..Uniforms::new(&model)
        };
        let (target, _) = drawn(&floor, shader, "generic", 200);
        let seen = target.image.pixels().filter(|pixel| pixel.2.b > 0);
        let eye = DVec3::Z * f64::from(distance);
        let errors = seen.map(|(x, y, color)| {
            let [x, y] = [x, y].map(|n| ((f64::from(n) + 0.5) / 200.0 - 0.5) / 0.4);
            let met = on_level(-0.5, eye, DVec3::new(x, y, 0.0));
            let exact = [(met.x + 1.0) * 128.0, (1.0 - met.z) * 128.0];
            // A texel's middle is at most half a texel from any point of it.
            let off = [color.r, color.g].map(|texel| f64::from(texel) + 0.5);
            (off[0] - exact[0]).abs().max((off[1] - exact[1]).abs())
        });
        errors.fold(0.0, f64::max)
    };
    for distance in [1.25f32, 2.0, 4.0, 16.0] {
        // From the middle of the floor's length a share of (√r - 1)/(√r + 1) is lost, r being how many times
        // farther its far side is than its near one.
        let root = f64::from((distance + 1.0) / (distance - 1.0)).sqrt();
        let expected = 256.0 * (root - 1.0) / (root + 1.0);
        for shader in ["flat-texture", "gouraud-texture"] {
            let largest = warp(shader, distance);
            let what = format!("{shader} from {distance}: {largest} texels, not {expected}");
            assert!((largest - expected).abs() < 1.0, "{what}");
        }
    }
}

/// Twice as many triangles, and four times the fragments, allocate as often: the buffers once, nothing for a
/// triangle or a fragment.
#[test]
fn drawing_allocates_nothing_per_triangle_or_fragment() {
    let texture = texture();
    let count = |repeated: usize, side: u16, way: &dyn Fn(&Uniforms, Image)| {
        let text = sphere_text(repeated);
        let model = Model::parse(text.as_bytes(), BOTH).unwrap();
        let normals = corner_normals(&model);
        let all = Uniforms { normals: &normals, texture: Some(&texture), ..Uniforms::new(&model) };
        let image = Image::new(side, side, Format::Rgb);
        allocation_counter::measure(|| way(&all, image)).count_total
    };
    type Way = Box<dyn Fn(&Uniforms, Image)>;
    let mut ways: Vec<(String, Way, u64)> = Vec::new();
    for shader in SHADERS {
        for way in METHODS {
            let draw = (way.run)(&shader.run);
            let run = move |uniforms: &Uniforms, image: Image| {
                draw(uniforms, &mut Framebuffer::new(image));
            };
            // One for the depths, one for the vertices' places.
            ways.push((format!("{}, {}", shader.name, way.name), Box::new(run), 2));
        }
    }
    let draw = method(textures::METHODS, "nearest").draw;
    let run = move |uniforms: &Uniforms, mut image: Image| {
        draw(uniforms.model, uniforms.texture.unwrap(), uniforms.light, &mut image);
    };
    ways.push(("lesson 5".into(), Box::new(run), 1));
    for (name, way, buffers) in &ways {
        let counts = [(1, 50), (2, 50), (1, 100)].map(|(repeated, side)| count(repeated, side, way));
        assert_eq!(counts, [*buffers; 3], "{name}");
    }
}

/// The sphere of 24 triangles, so many times over.
fn sphere_text(times: usize) -> String {
    let text = assets::sphere::sphere(4, 4).to_obj();
    let faces: String =
        text.lines().filter(|line| line.starts_with('f')).map(|line| format!("{line}\n")).collect();
    text + &faces.repeat(times - 1)
}

/// A target of another kind: no colours, but what came, and where; the deepest stays; room for 8×8 pixels only.
struct Log {
    deepest: [f32; 64],
    seen: [Option<Fragment<f32>>; 64],
    writes: usize,
}

impl Target<Fragment<f32>> for Log {
    fn bounds(&self) -> Bounds {
        verify::window(8, 8)
    }

    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        depth < self.deepest[(8 * y + x) as usize]
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, output: Fragment<f32>) {
        let place = (8 * y + x) as usize;
        self.deepest[place] = depth;
        self.seen[place] = Some(output);
        self.writes += 1;
    }

    fn clear(&mut self) {
        *self = Self { deepest: [f32::INFINITY; 64], seen: [None; 64], writes: 0 };
    }
}

/// A shader that gives on what it is told, and counts how often it is asked for each vertex.
struct Tell {
    asked: RefCell<[usize; 4]>,
}

impl Shader for Tell {
    type Constant = ();
    type Varying = f32;
    type Output = Fragment<f32>;

    /// A square in the middle, at half the eye's distance; its depth grows to the right.
    fn position(&self, vertex: usize) -> Vec4 {
        self.asked.borrow_mut()[vertex] += 1;
        let (x, y) = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)][vertex];
        Vec4::new(x, y, x, 1.0) * 2.0
    }

    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    /// Grows to the right by 8 over the square.
    fn corner(&self, face: usize, corner: usize) -> f32 {
        [[0.0, 8.0, 8.0], [0.0, 8.0, 0.0]][face][corner]
    }

    fn fragment(&self, (): (), fragment: Fragment<f32>) -> Option<Fragment<f32>> {
        Some(fragment)
    }
}

/// A vertex that triangles share is asked for once; a fragment knows its pixel, its depth and what was
/// interpolated; and what becomes of it is the target's affair.
#[test]
fn vertices_are_asked_once_and_fragments_know_where_they_are() {
    let shader = Tell { asked: RefCell::new([0; 4]) };
    let mut log = Log { deepest: [f32::INFINITY; 64], seen: [None; 64], writes: 0 };
    assert_eq!(render(&shader, 4, &[[0, 1, 2], [0, 2, 3]], &mut log), 0);
    assert_eq!(*shader.asked.borrow(), [1; 4]);
    for (x, y) in (0..8).flat_map(|y| (0..8).map(move |x| (x, y))) {
        let inside = (2..6).contains(&x) && (2..6).contains(&y);
        let seen = log.seen[(8 * y + x) as usize];
        assert_eq!(seen.is_some(), inside, "({x}, {y})");
        if let Some(Fragment { x: column, y: row, depth, varying }) = seen {
            assert_eq!((column, row), (x, y));
            let across = (x as f32 + 0.5 - 2.0) / 4.0;
            assert!((depth - (across - 0.5)).abs() < 1e-6 && (varying - 8.0 * across).abs() < 1e-5);
        }
    }
    assert_eq!(log.writes, 16);
    // A second time nothing is deeper; the target says so, and no depth of the renderer's own.
    render(&shader, 4, &[[0, 1, 2], [0, 2, 3]], &mut log);
    assert_eq!(log.writes, 16);
    log.clear();
    render(&shader, 4, &[[0, 1, 2], [0, 2, 3]], &mut log);
    assert_eq!(log.writes, 16);
}
