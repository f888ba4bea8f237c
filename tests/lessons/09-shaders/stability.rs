use checks::view::on_level;
use common::{Attributes, Color, DVec3, Format, Image, Mat4, Model, Vec3, Vec4};
use gouraud::corner_normals;
use shaders::lighting::{Lighting, Quantized};
use shaders::program::{Shader, render};
use shaders::{METHODS, SHADERS, Scene, Target};
use transforms::{projection, viewport};
use verify::{SPHERE, method};

const BOTH: Attributes = Attributes { normals: true, uvs: true };

fn sphere() -> Model {
    Model::read(SPHERE.as_ref(), BOTH).unwrap()
}

fn scene<'a>(model: &'a Model, texture: &'a Image, to_screen: Mat4) -> Scene<'a> {
    let normals = corner_normals(model);
    Scene { model, normals, texture: Some(texture), light: Vec3::Z, to_screen, levels: 6 }
}

/// What a shader draws by a method into a square picture: the target, and how many triangles were left out.
fn drawn(scene: &Scene, shader: &str, way: &str, side: u16) -> (Target, usize) {
    let mut target = Target::new(Image::new(side, side, Format::Rgb));
    let left_out = method(METHODS, way)(method(SHADERS, shader))(scene, &mut target);
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
    let to_screen = viewport(200.0, 200.0, 0.5) * projection(f32::INFINITY);
    let all = scene(&model, &texture, to_screen);
    let blank = Image::new(200, 200, Format::Rgb);

    let mut flat = blank.clone();
    let flat_depths = zbuffer::z_f32(&zbuffer::surfaces(&model, Vec3::Z, &blank), &mut flat);
    let mut textured = blank.clone();
    let textured_depths =
        (method(textures::METHODS, "nearest").draw)(&model, &texture, Vec3::Z, &mut textured);
    let mut smooth = blank;
    let smooth_scene =
        gouraud::Scene { model: &model, normals: corner_normals(&model), texture: &texture, light: Vec3::Z };
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

    fn triangle(&self, face: usize) -> Option<usize> {
        // The third triangle is rejected: it would cover everything.
        (face < 2).then_some(face)
    }

    fn vertex(&self, face: usize, corner: usize) -> (Vec4, ()) {
        let (x, y) = [(-1.0, -1.0), (33.0, -1.0), (-1.0, 33.0)][corner];
        (Vec4::new(x, y, [2.0, 1.0, 9.0][face], 1.0), ())
    }

    fn fragment(&self, face: usize, (): ()) -> Option<Color> {
        match face {
            0 => None,
            _ => Some(Color::RED),
        }
    }
}

/// What is dropped in front leaves neither colour nor depth, so that what lies behind it is seen.
#[test]
fn a_discarded_fragment_leaves_colour_and_depth_alone() {
    let mut target = Target::new(Image::new(16, 16, Format::Rgb));
    assert_eq!(render(&Holes, 3, &mut target), 0);
    for (x, y, color) in target.image.pixels() {
        assert_eq!((color, target.depths.get(x, y)), (Color::RED, 1.0));
    }
    let mut empty = Target::new(Image::new(16, 16, Format::Rgb));
    render(&Holes, 1, &mut empty);
    assert!(empty.depths == Target::new(Image::new(16, 16, Format::Rgb)).depths);
}

/// From the dark side all is dropped, triangles or fragments: not one depth is kept.
#[test]
fn the_dark_side_is_dropped() {
    let text = b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n";
    let (model, texture) = (Model::parse(text, BOTH).unwrap(), texture());
    let mut all = scene(&model, &texture, viewport(20.0, 20.0, 0.5));
    all.light = Vec3::new(0.0, 0.6, -0.8);
    for shader in SHADERS {
        for way in METHODS {
            let (target, _) = drawn(&all, shader.name, way.name, 20);
            let blank = Target::new(Image::new(20, 20, Format::Rgb));
            assert!(target.depths == blank.depths && target.image == blank.image, "{}", shader.name);
        }
    }
}

/// ⌊N·min(i, 1)⌋ / N, in whole numbers: i = n/240 for N that divide 240, where every quotient is exact enough.
#[test]
fn quantized_shows_as_many_levels_as_asked_for() {
    let (model, texture) = (sphere(), texture());
    for levels in [1, 2, 3, 4, 5, 6, 240] {
        let all = Scene { levels, ..scene(&model, &texture, Mat4::IDENTITY) };
        let shader = Quantized::new(&all);
        let mut seen = Vec::new();
        for n in -240..=480_i32 {
            // In the middle between two of 240 steps, so that rounding has no say.
            let intensity = shader.intensity((), (n as f32 + 0.5) / 240.0);
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
    let (model, texture) = (sphere(), texture());
    let one = Scene { levels: 1, ..scene(&model, &texture, viewport(99.0, 99.0, 0.5)) };
    let (target, _) = drawn(&one, "quantized", "generic", 99);
    let (smooth, _) = drawn(&one, "gouraud", "generic", 99);
    assert!(target.image.pixels().all(|pixel| pixel.2 == Color::BLACK || pixel.2 == Color::WHITE));
    assert!(target.image.pixels().filter(|pixel| pixel.2 == Color::WHITE).count() < 9);
    assert!(target.depths == smooth.depths);
}

/// Triangles with a corner at w ≤ 1e-6 are left out and counted, once each.
#[test]
fn what_reaches_behind_the_eye_is_left_out_and_counted() {
    let text = b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 0 2\nv 0 0 9\nvt 0 0\nvn 0 0 1\n\
                 f 1/1/1 2/1/1 3/1/1\nf 1/1/1 2/1/1 4/1/1\nf 1/1/1 2/1/1 5/1/1\nf 4/1/1 4/1/1 5/1/1\n";
    let (model, texture) = (Model::parse(text, BOTH).unwrap(), texture());
    let to_screen = viewport(20.0, 20.0, 0.4) * projection(2.0);
    let mut all = scene(&model, &texture, to_screen);
    all.light = Vec3::new(0.0, 0.6, 0.8);
    for shader in SHADERS {
        for way in METHODS {
            let (target, left_out) = drawn(&all, shader.name, way.name, 20);
            // The flat shaders reject what faces away, here two of the three, before anyone knows where it is.
            let expected = if shader.name.starts_with("flat") { 1 } else { 3 };
            assert_eq!(left_out, expected, "{}, {}", shader.name, way.name);
            assert!(target.depths.get(10, 10) == 0.0);
        }
    }
}

/// From the eye at z = 2, a corner at z has w = 1 − z/2: 5e-6 is still in front of it, 5e-7 is not.
#[test]
fn just_before_the_eye_is_before_it() {
    for (z, left_out) in [(1.99999, 0), (1.999_999, 1)] {
        let text = format!("v -1 -1 0\nv 1 -1 0\nv 0 0 {z}\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n");
        let (model, texture) = (Model::parse(text.as_bytes(), BOTH).unwrap(), texture());
        let all = scene(&model, &texture, viewport(20.0, 20.0, 0.4) * projection(2.0));
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
    let warp = |distance: f32| {
        let to_screen = viewport(200.0, 200.0, 0.4) * projection(distance);
        let floor = Scene { light: Vec3::Y, ..scene(&model, &texture, to_screen) };
        let (target, _) = drawn(&floor, "flat-texture", "generic", 200);
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
        let largest = warp(distance);
        assert!((largest - expected).abs() < 1.0, "from {distance}: {largest} texels, not {expected}");
    }
}

/// Twice as many triangles, and four times the fragments, allocate as often: the buffers once, nothing for a
/// triangle or a fragment.
#[test]
fn drawing_allocates_nothing_per_triangle_or_fragment() {
    let texture = texture();
    let count = |repeated: usize, side: u16, way: &dyn Fn(&Scene, Image)| {
        let text = sphere_text(repeated);
        let model = Model::parse(text.as_bytes(), BOTH).unwrap();
        let all = scene(&model, &texture, viewport(f32::from(side), f32::from(side), 0.5));
        let image = Image::new(side, side, Format::Rgb);
        allocation_counter::measure(|| way(&all, image)).count_total
    };
    type Way = Box<dyn Fn(&Scene, Image)>;
    let mut ways: Vec<(String, Way)> = Vec::new();
    for shader in SHADERS {
        for way in METHODS {
            let draw = (way.run)(&shader.run);
            let run = move |scene: &Scene, image: Image| {
                draw(scene, &mut Target::new(image));
            };
            ways.push((format!("{}, {}", shader.name, way.name), Box::new(run)));
        }
    }
    let draw = method(textures::METHODS, "nearest").draw;
    let run = move |scene: &Scene, mut image: Image| {
        draw(scene.model, scene.texture.unwrap(), scene.light, &mut image);
    };
    ways.push(("lesson 5".into(), Box::new(run)));
    for (name, way) in &ways {
        // One for the depths.
        let counts = [(1, 50), (2, 50), (1, 100)].map(|(repeated, side)| count(repeated, side, way));
        assert_eq!(counts, [1, 1, 1], "{name}");
    }
}

/// The sphere of 24 triangles, so many times over.
fn sphere_text(times: usize) -> String {
    let text = assets::sphere::sphere(4, 4).to_obj();
    let faces: String =
        text.lines().filter(|line| line.starts_with('f')).map(|line| format!("{line}\n")).collect();
    text + &faces.repeat(times - 1)
}
