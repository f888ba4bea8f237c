//! Lesson 12: a point light on a surface, vectors made 1 long, and powers.

use checks::lamp::{Ellipsoid, Highlight, Lamp, level};
use checks::ray::Screen;
use clipping::Cull;
use clipping::mesh::indexed;
use common::{Color, DVec2, DVec3, Format, Image, Mat4, Method, Model, Vec3};
use fastrand::Rng;
use lighting::normalisation::Normalise;
use lighting::power::Raise;
use lighting::{Draw, METHODS, NORMALISATIONS, POWERS, PointLight, Scene};
use perspective::scene::Loaded;
use textures::Wrap;

use crate::lessons::gouraud::charts::light as direction;
use crate::lessons::lighting::figures::{ALL, camera};
use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::{TRIANGLES, USUAL, sphere, texture};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "12-lighting",
    job: "Lesson 12, light on a surface",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "difference from a smooth sphere",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &[],
    samples: "a white sphere of 5,000 triangles, exponent 32, under lamps in random places, 128×128 px, its rim left out",
    exhaustive: false,
    proved: &[],
    errors: method_errors,
    timed: "a textured sphere of 5,000 triangles in a picture of 800×800",
    throughput: "Mpx/s",
    work: method_work,
    sizes: Sizes { name: "triangles", all: TRIANGLES, usual: USUAL },
    stability: Stability {
        stress: "exponent of the highlight",
        falling: false,
        error: Quantity {
            name: "largest difference, sphere of 5,000 triangles",
            unit: "grey levels of 255",
            limit: (2.0, "2 levels"),
        },
        measure: method_stability,
    },
    wrong: &[],
    advice: &[
        ("blinn-phong", "whatever shines"),
        ("phong", "where highlights are to look as in Phong's model, with a quarter of the exponent"),
        ("phong-vertex", "matt surfaces, and triangles smaller than any highlight"),
        ("flat", "things with flat faces"),
    ],
};

pub(crate) const NORMALISATIONS_CHART: Chart = Chart {
    name: "12-lighting-normalisations",
    job: "Lesson 12, vectors made 1 long",
    methods: || NORMALISATIONS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "difference of a lit white pixel",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &[],
    samples: "points between corners up to 20° apart, in and beside a highlight of exponent 32, by Blinn's model",
    exhaustive: false,
    proved: &[],
    errors: normalisation_errors,
    timed: "1,000 interpolated normals in a list, copied there first",
    throughput: "Mop/s",
    work: normalisation_work,
    sizes: Sizes { name: "normals", all: &[1000], usual: 1000 },
    stability: Stability {
        stress: "exponent of the highlight",
        falling: false,
        error: Quantity {
            name: "largest difference of a lit white pixel",
            unit: "grey levels of 255",
            limit: (0.5, "½ level"),
        },
        measure: normalisation_stability,
    },
    wrong: &["never"],
    advice: &[
        ("exact", "unless roots are what a program waits for"),
        ("fast-2", "where they are"),
        ("fast-1", "where they are, and nothing shines"),
    ],
};

pub(crate) const POWERS_CHART: Chart = Chart {
    name: "12-lighting-powers",
    job: "Lesson 12, the power of a cosine",
    methods: || POWERS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "difference of a highlight of S = 0.4",
        unit: "grey levels of 255",
        limit: (0.5, "within ½ level"),
    },
    further: &[],
    samples: "lots of 1,000 numbers from 0 to 1, exponent 32",
    exhaustive: false,
    proved: &[],
    errors: power_errors,
    timed: "100,000 numbers from ½ to 1 in a list, copied there first, exponent 32",
    throughput: "Mop/s",
    work: power_work,
    sizes: Sizes { name: "numbers", all: &[100, 1000, 10_000, 100_000], usual: 100_000 },
    stability: Stability {
        stress: "exponent of the highlight",
        falling: false,
        error: Quantity {
            name: "largest difference of a highlight of S = 0.4",
            unit: "grey levels of 255",
            limit: (0.5, "½ level"),
        },
        measure: power_stability,
    },
    wrong: &[],
    advice: &[
        ("powf", "always"),
        ("squaring", "whole exponents, where pictures are to be the same on every platform to the last bit"),
        ("table-linear", "exponents up to 50, where logarithms are slow"),
    ],
};

/// The exponent of the lesson's light, and its share of the highlight.
const USUAL_LIGHT: (f32, f32) = (32.0, 0.4);

/// Exponents for the stability of all three tables.
const EXPONENTS: [f32; 14] =
    [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0, 2048.0, 4096.0, 10_000.0];

/// A model, kept until the program ends.
fn kept(model: &Model, texture: Image) -> &'static Loaded {
    Box::leak(Box::new(Loaded::new(model.clone(), texture, Wrap::Clamp)))
}

/// One white texel.
fn white() -> Image {
    let mut white = Image::new(1, 1, Format::Rgb);
    white.set(0, 0, Color::WHITE);
    white
}

/// The camera before the sphere: where the eye is, and its field of view.
const EYE: Vec3 = Vec3::new(0.0, 0.0, 3.6);
const FOV: f32 = 34.0;

/// A scene with a model in the middle.
fn scene(loaded: &Loaded, light: PointLight) -> Scene<'_> {
    let camera = camera((EYE, Vec3::ZERO, FOV)).expect("it looks somewhere");
    Scene::placed(loaded, Mat4::IDENTITY, camera, EYE, light).expect("it is not flat")
}

fn exact(light: &PointLight) -> Lamp {
    Lamp {
        position: light.position.as_dvec3(),
        ambient: light.ambient.into(),
        diffuse: light.diffuse.into(),
        specular: light.specular.into(),
        shininess: light.shininess.into(),
        fading: 0,
    }
}

/// Which highlight a method has.
fn highlight(method: &Method<Draw>) -> Highlight {
    if method.name == "blinn-phong" { Highlight::Halfway } else { Highlight::Mirrored }
}

/// Each pixel's point of the smooth sphere: where it is seen at less than 66° from straight on.
fn seen(side: u16) -> Vec<(i32, i32, DVec3)> {
    let (screen, eye) = (Screen::ahead(FOV.into(), DVec2::splat(side.into())), EYE.as_dvec3());
    let ball = Ellipsoid(DVec3::ONE);
    let pixels = (0..i32::from(side)).flat_map(|y| (0..i32::from(side)).map(move |x| (x, y)));
    pixels
        .filter_map(|(x, y)| {
            let point = ball.hit(eye, screen.through(x, y))?;
            (point.dot((eye - point).normalize()) > 0.4).then_some((x, y, point))
        })
        .collect()
}

/// The largest and the mean difference between a drawn sphere and a smooth one.
fn difference(
    method: &Method<Draw>,
    loaded: &Loaded,
    light: PointLight,
    seen: &[(i32, i32, DVec3)],
) -> (f64, f64) {
    let mut image = Image::new(128, 128, Format::Rgb);
    let mesh = indexed(&loaded.model, &loaded.normals, ALL);
    (method.run)(&scene(loaded, light), &mesh, Cull::Back, &mut image);
    let (lamp, which) = (exact(&light), highlight(method));
    let (mut largest, mut sum) = (0.0_f64, 0.0);
    for &(x, y, point) in seen {
        let exact = level(255.0, lamp.on(point, point, EYE.as_dvec3(), which));
        let off = (f64::from(image.get(x, y).map_or(0, |color| color.r)) - exact).abs();
        largest = largest.max(off);
        sum += off;
    }
    (largest, sum / seen.len() as f64)
}

/// A lamp in a random place before the sphere.
fn lamp(random: &mut Rng) -> PointLight {
    PointLight { position: direction(random) * (1.5 + 4.0 * random.f32()), ..PointLight::default() }
}

fn method_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let (ball, seen) = (kept(sphere(USUAL), white()), seen(128));
    let mut errors = Errors::table(METHODS.len(), 0);
    for _ in 0..effort.samples(400) {
        let light = lamp(&mut random);
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let (largest, mean) = difference(method, ball, light, &seen);
            errors.add(largest, mean, &[]);
        }
    }
    errors
}

fn method_work(size: usize, _: Effort) -> Vec<Work> {
    let ball = kept(sphere(size), texture());
    let mesh = indexed(&ball.model, &ball.normals, ALL);
    let work = |method: &'static Method<Draw>| {
        let (scene, mesh) = (scene(ball, PointLight::default()), mesh.clone());
        let mut image = Image::new(800, 800, Format::Rgb);
        let depths = (method.run)(&scene, &mesh, Cull::Back, &mut image).depths;
        let seen = image.pixels().filter(|&(x, y, _)| depths.get(x, y) < 1.0).count();
        Work::new(seen as f64, move || (method.run)(&scene, &mesh, Cull::Back, &mut image).counts)
    };
    METHODS.iter().map(work).collect()
}

/// Smaller and smaller highlights.
fn method_stability(effort: Effort) -> Vec<Series> {
    let (ball, seen) = (kept(sphere(USUAL), white()), seen(128));
    let worst = |method: &Method<Draw>, shininess: f32| {
        let mut random = effort.random();
        let lights = (0..effort.samples(40)).map(|_| PointLight { shininess, ..lamp(&mut random) });
        lights.map(|light| difference(method, ball, light, &seen).0).fold(0.0, f64::max)
    };
    let series = |method: &Method<Draw>| {
        EXPONENTS.map(|exponent| (f64::from(exponent), worst(method, exponent))).to_vec()
    };
    METHODS.iter().map(series).collect()
}

/// A point of a surface: its normal as it was interpolated, a lamp, and an eye.
struct Spot {
    normal: Vec3,
    lamp: Vec3,
    eye: Vec3,
}

impl Spot {
    /// Between three corners whose normals are up to 10° from a direction in the middle; the normal of a mirror that shows the
    /// lamp is up to 20° from that.
    fn random(random: &mut Rng) -> Self {
        let anywhere = |random: &mut Rng| {
            let direction = direction(random);
            if random.bool() { direction } else { -direction }
        };
        let near = |middle: Vec3, degrees: f32, random: &mut Rng| {
            let aside = middle.cross(anywhere(random)).normalize_or_zero();
            let (sin, cos) = (degrees * random.f32()).to_radians().sin_cos();
            (middle * cos + aside * sin).normalize()
        };
        let middle = anywhere(random);
        let corners = [(); 3].map(|()| near(middle, 10.0, random));
        let [a, b] = [(); 2].map(|()| random.f32());
        let (a, b) = if a + b > 1.0 { (1.0 - a, 1.0 - b) } else { (a, b) };
        let normal = corners[0] * a + corners[1] * b + corners[2] * (1.0 - a - b);
        let half = near(middle, 20.0, random);
        let to_eye = near(middle, 50.0, random);
        let to_lamp = 2.0 * half.dot(to_eye) * half - to_eye;
        let mut away = || 1.0 + 3.0 * random.f32();
        Self { normal, lamp: to_lamp * away(), eye: to_eye * away() }
    }

    /// By how many levels a white pixel is off.
    fn off(&self, method: &Method<Normalise>, shininess: f32) -> f64 {
        let &Self { normal, lamp, eye } = self;
        let light = PointLight { position: lamp, shininess, ..PointLight::default() };
        let got = (method.run.reflect)(Vec3::ZERO, normal, eye, &light);
        let [body, shine] =
            exact(&light).on(DVec3::ZERO, normal.as_dvec3(), eye.as_dvec3(), Highlight::Halfway);
        255.0 * (f64::from(got.body) - body + f64::from(got.highlight) - shine).abs()
    }
}

fn normalisation_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(NORMALISATIONS.len(), 0);
    for _ in 0..effort.samples(200_000) {
        let spot = Spot::random(&mut random);
        for (method, errors) in NORMALISATIONS.iter().zip(&mut errors) {
            let off = spot.off(method, USUAL_LIGHT.0);
            errors.add(off, off, &[]);
        }
    }
    errors
}

fn normalisation_work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    let normals: Vec<Vec3> = (0..size).map(|_| Spot::random(&mut random).normal).collect();
    let work = |method: &Method<Normalise>| {
        let (normals, mut list, all) = (normals.clone(), normals.clone(), method.run.all);
        Work::new(size as f64, move || {
            list.copy_from_slice(&normals);
            all(&mut list);
            list[0]
        })
    };
    NORMALISATIONS.iter().map(work).collect()
}

/// Smaller and smaller highlights.
fn normalisation_stability(effort: Effort) -> Vec<Series> {
    let worst = |method: &Method<Normalise>, exponent: f32| {
        let mut random = effort.random();
        let spots = (0..effort.samples(20_000)).map(|_| Spot::random(&mut random));
        spots.map(|spot| spot.off(method, exponent)).fold(0.0, f64::max)
    };
    let series = |method: &Method<Normalise>| {
        EXPONENTS.map(|exponent| (f64::from(exponent), worst(method, exponent))).to_vec()
    };
    NORMALISATIONS.iter().map(series).collect()
}

/// By how many levels a highlight is off where its cosine is x.
fn off(method: &Method<Raise>, exponent: f32, x: f32) -> f64 {
    let exact = f64::from(x).powf(exponent.into());
    255.0 * f64::from(USUAL_LIGHT.1) * (f64::from((method.run.one)(exponent, x)) - exact).abs()
}

fn power_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(POWERS.len(), 0);
    for _ in 0..effort.samples(400) {
        let lot: Vec<f32> = (0..1000).map(|_| random.f32()).collect();
        for (method, errors) in POWERS.iter().zip(&mut errors) {
            let offs = lot.iter().map(|&x| off(method, USUAL_LIGHT.0, x));
            let (largest, sum) =
                offs.fold((0.0_f64, 0.0), |(largest, sum), off| (largest.max(off), sum + off));
            errors.add(largest, sum / lot.len() as f64, &[]);
        }
    }
    errors
}

fn power_work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    // No power of these is so small that a processor computes it in another, slower way.
    let numbers: Vec<f32> = (0..size).map(|_| 0.5 + 0.5 * random.f32()).collect();
    let work = |method: &Method<Raise>| {
        let (numbers, mut list, all) = (numbers.clone(), numbers.clone(), method.run.all);
        Work::new(size as f64, move || {
            list.copy_from_slice(&numbers);
            all(USUAL_LIGHT.0, &mut list);
            list[0]
        })
    };
    POWERS.iter().map(work).collect()
}

/// Smaller and smaller highlights; between two powers of two, numbers that lie in the highlight.
fn power_stability(effort: Effort) -> Vec<Series> {
    let worst = |method: &Method<Raise>, exponent: f32| {
        let mut random = effort.random();
        // Cosines whose power is above 1/1000, so that narrow highlights are looked at as closely as wide ones.
        let least = 0.001_f32.powf(1.0 / exponent);
        let some = (0..effort.samples(2000)).map(|_| least + (1.0 - least) * random.f32());
        some.map(|x| off(method, exponent, x)).fold(0.0, f64::max)
    };
    let series = |method: &Method<Raise>| {
        EXPONENTS.map(|exponent| (f64::from(exponent), worst(method, exponent))).to_vec()
    };
    POWERS.iter().map(series).collect()
}
