//! Lesson 9: any look from one loop, and the looks.

use common::{Format, Image, Method, Vec3};
use gouraud::corner_normals;
use shaders::{Draw, Framebuffer, Look, METHODS, SHADERS, Uniforms};

use crate::lessons::gouraud::charts::light;
use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::{TRIANGLES, USUAL, sphere, texture};
use crate::measuring::scene::{EYE, Subject, channels, draw, exact};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "09-shaders",
    job: "Lesson 9, calling a shader",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "difference from lessons 4 to 6",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &[],
    samples: "spheres of 18 to 5,000 triangles under random lights, as lessons 4 to 6 draw them",
    exhaustive: false,
    proved: &[],
    errors: method_errors,
    timed: "the textured Gouraud sphere of 5,000 triangles in a picture of 800×800",
    throughput: "Mpx/s",
    work: method_work,
    sizes: Sizes { name: "triangles", all: TRIANGLES, usual: USUAL },
    stability: Stability {
        stress: "nearest triangle's distance from the eye, the sphere's radius as the unit",
        falling: true,
        error: Quantity {
            name: "mean difference from the exact picture",
            unit: "grey levels of 255",
            limit: (5.0, "5 levels"),
        },
        measure: method_stability,
    },
    wrong: &[],
    advice: &[
        ("generic", "always, unless shaders are loaded while the program runs"),
        ("dyn", "shaders that are not known when the program is compiled"),
    ],
};

/// The shaders without a texture, and those with one: each table is held against one picture.
const WHITE: [&str; 3] = ["flat", "gouraud", "quantized"];
const TEXTURED: [&str; 2] = ["flat-texture", "gouraud-texture"];

pub(crate) const WHITE_CHART: Chart = Chart {
    name: "09-shaders-looks",
    job: "Lesson 9, what each look without a texture costs",
    methods: || WHITE.to_vec(),
    error: Quantity {
        name: "difference from a smooth surface",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &[],
    samples: "a sphere of 5,000 triangles from the lesson's eye, random lights within 20° of it, 200×200 px",
    exhaustive: false,
    proved: &[],
    errors: |effort| look_errors(&WHITE, effort),
    timed: "such a sphere in a picture of 800×800, by the generic method",
    throughput: "Mpx/s",
    work: |size, _| look_work(&WHITE, size),
    sizes: Sizes { name: "triangles", all: TRIANGLES, usual: USUAL },
    stability: Stability {
        stress: "angle between neighbouring corners of the sphere, degrees",
        falling: false,
        error: Quantity { name: "mean difference", unit: "grey levels of 255", limit: (5.0, "5 levels") },
        measure: |effort| look_stability(&WHITE, effort),
    },
    wrong: &["quantized"],
    advice: &[
        ("gouraud", "round things in one colour"),
        ("flat", "flat faces, previews"),
        ("quantized", "a drawn look, which is no smooth surface and does not try"),
    ],
};

pub(crate) const TEXTURED_CHART: Chart = Chart {
    name: "09-shaders-textured",
    job: "Lesson 9, what each look with a texture costs",
    methods: || TEXTURED.to_vec(),
    error: Quantity { name: "difference from a smooth textured surface", ..WHITE_CHART.error },
    errors: |effort| look_errors(&TEXTURED, effort),
    work: |size, _| look_work(&TEXTURED, size),
    stability: Stability { measure: |effort| look_stability(&TEXTURED, effort), ..WHITE_CHART.stability },
    wrong: &[],
    advice: &[
        ("gouraud-texture", "round things with a texture"),
        ("flat-texture", "textured things with flat faces"),
    ],
    ..WHITE_CHART
};

/// The look of that name.
fn look(name: &str) -> &'static Look {
    &Method::find(SHADERS, name).expect("the lesson has this shader").run
}

/// The drawings of lessons 4, 5 and 6 that shaders must repeat, under an identity view.
fn earlier(name: &str, uniforms: &Uniforms, side: u16) -> Image {
    let mut image = Image::new(side, side, Format::Rgb);
    let texture = uniforms.texture.expect("there is a texture");
    match name {
        "flat" => {
            let surfaces = zbuffer::surfaces(uniforms.model, uniforms.light, &image);
            zbuffer::z_f32(&surfaces, &mut image);
        }
        "flat-texture" => {
            let nearest = Method::find(textures::METHODS, "nearest").expect("lesson 5 has it");
            (nearest.run.draw)(uniforms.model, texture, uniforms.light, &mut image);
        }
        _ => {
            let gouraud = Method::find(gouraud::METHODS, "gouraud").expect("lesson 6 has it");
            let scene = gouraud::Scene {
                model: uniforms.model,
                normals: uniforms.normals,
                texture,
                wrap: gouraud::Wrap::Clamp,
                light: uniforms.light,
            };
            (gouraud.run)(&scene, &mut image);
        }
    }
    image
}

fn method_errors(effort: Effort) -> Vec<Errors> {
    const SIDE: u16 = 200;
    let texture = texture();
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), 0);
    for n in 0..effort.samples(200) {
        let model = sphere([18, 98, 968, USUAL][n % 4]);
        for name in ["flat", "flat-texture", "gouraud-texture"] {
            // Lesson 6 draws in black what a shader leaves out: they agree where nothing faces away.
            let light = if name == "gouraud-texture" { Vec3::Z } else { light(&mut random) };
            let normals = corner_normals(model);
            let uniforms =
                Uniforms { normals: &normals, texture: Some(&texture), light, ..Uniforms::new(model) };
            let expected = earlier(name, &uniforms, SIDE);
            for (method, errors) in METHODS.iter().zip(&mut errors) {
                let got = draw((method.run)(look(name)), &uniforms, SIDE);
                let (largest, mean) = difference(channels(&got.image), channels(&expected), |_| true);
                errors.add(largest, mean, &[]);
            }
        }
    }
    errors
}

/// The largest and the mean difference of a channel, over the pixels that count.
fn difference(
    got: impl Iterator<Item = [f64; 3]>,
    expected: impl Iterator<Item = [f64; 3]>,
    counts: impl Fn(usize) -> bool,
) -> (f64, f64) {
    let (mut largest, mut sum, mut count) = (0.0_f64, 0.0, 0_u32);
    for (_, (a, b)) in got.zip(expected).enumerate().filter(|(n, _)| counts(*n)) {
        let off = (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max);
        largest = largest.max(off);
        sum += off;
        count += 1;
    }
    (largest, sum / f64::from(count.max(1)))
}

/// Draws the lesson's sphere again and again, one piece of work for each renderer.
fn work(draws: impl Iterator<Item = Draw>, size: usize) -> Vec<Work> {
    const SIDE: u16 = 800;
    let model = sphere(size);
    let texture: &'static Image = Box::leak(Box::new(texture()));
    let pixels = |target: &Framebuffer| {
        target.image.pixels().filter(|&(x, y, _)| target.depths.get(x, y) > f32::NEG_INFINITY).count() as f64
    };
    let subject = Subject::new(model, texture);
    draws
        .map(|render| {
            let subject = subject.clone();
            let amount = pixels(&draw(render, &subject.seen(Vec3::Z, EYE), SIDE));
            Work::new(amount, move || draw(render, &subject.seen(Vec3::Z, EYE), SIDE))
        })
        .collect()
}

fn method_work(size: usize, _: Effort) -> Vec<Work> {
    work(METHODS.iter().map(|method| (method.run)(look("gouraud-texture"))), size)
}

fn look_work(names: &[&str], size: usize) -> Vec<Work> {
    work(names.iter().map(|name| look(name).generic), size)
}

/// The mean difference between a drawn sphere and the exact picture, where both show the surface: the largest
/// and the mean.
fn off_exact(render: Draw, shader: &str, triangles: usize, light: Vec3, eye: Vec3, side: u16) -> (f64, f64) {
    let (model, texture) = (sphere(triangles), texture());
    let got = draw(render, &Subject::new(model, &texture).seen(light, eye), side);
    let textured = shader.ends_with("texture");
    let expected = exact(model, textured.then_some(&texture), light, eye, (side, 1));
    let inside: Vec<bool> = got
        .image
        .pixels()
        .zip(&expected)
        .map(|((x, y, _), exact)| got.depths.get(x, y) > f32::NEG_INFINITY && *exact != [0.0; 3])
        .collect();
    difference(channels(&got.image), expected.into_iter(), |n| inside[n])
}

/// A random light within 20° of the eye, so that all that is seen is lit: where a shader leaves out what is dark,
/// what lies behind it is seen, and the difference there says nothing of shading.
fn light_near_eye(random: &mut fastrand::Rng) -> Vec3 {
    (EYE.normalize() + 0.34 * light(random)).normalize()
}

fn look_errors(names: &[&str], effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(names.len(), 0);
    for _ in 0..effort.samples(200) {
        let light = light_near_eye(&mut random);
        for (name, errors) in names.iter().zip(&mut errors) {
            let (largest, mean) = off_exact(look(name).generic, name, USUAL, light, EYE, 200);
            errors.add(largest, mean, &[]);
        }
    }
    errors
}

fn look_stability(names: &[&str], effort: Effort) -> Vec<Series> {
    let sectors = [160_usize, 100, 60, 40, 24, 16, 10, 6, 4];
    let mean = |name: &str, sectors: usize| {
        let mut random = effort.random();
        let lights = effort.samples(20);
        let triangles = 2 * sectors * sectors;
        let off = |_| off_exact(look(name).generic, name, triangles, light_near_eye(&mut random), EYE, 200).1;
        (0..lights).map(off).sum::<f64>() / lights as f64
    };
    names
        .iter()
        .map(|name| sectors.map(|sectors| (360.0 / sectors as f64, mean(name, sectors))).to_vec())
        .collect()
}

/// An eye that comes nearer and nearer to the sphere: affine interpolation warps more and more, and at last
/// triangles reach behind the eye and are left out.
fn method_stability(_: Effort) -> Vec<Series> {
    let heights = [10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01];
    let mean = |method: &Method<fn(&Look) -> Draw>, height: f64| {
        let eye = EYE.normalize() * (1.0 + height) as f32;
        let render = (method.run)(look("gouraud-texture"));
        off_exact(render, "gouraud-texture", 968, EYE.normalize(), eye, 400).1
    };
    METHODS.iter().map(|method| heights.map(|height| (height, mean(method, height))).to_vec()).collect()
}
