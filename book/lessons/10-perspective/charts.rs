//! Lesson 10: attributes over a triangle, what a depth buffer keeps, and divisions.

use common::{Attributes, Bounds, Format, IVec2, Image, Method, Model, Vec2, Vec3, Vec4};
use fastrand::Rng;
use glam::{DMat3, DVec2};
use gouraud::corner_normals;
use perspective::division::Reciprocal;
use perspective::{DEPTHS, DIVISIONS, Draw, Interpolate, Keep, METHODS, Planes, perspective};
use shaders::Uniforms;
use textures::Wrap;

use crate::lessons::perspective::figures::gap;
use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::texture;
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

/// Texels each way: an attribute from 0 to 1 goes over so many.
const TEXELS: f64 = 256.0;

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "10-perspective",
    job: "Lesson 10, attributes over a triangle",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "how far from the right texel",
        unit: "texels of a texture of 256",
        limit: (0.5, "within ½ texel"),
    },
    further: &[],
    samples: "triangles in a picture of 256×256, their corners' depths up to 4 times the nearest",
    exhaustive: false,
    proved: &[],
    errors: method_errors,
    timed: "a textured wall of 32 triangles that leads away, in a picture of 800×800",
    throughput: "Mpx/s",
    work: method_work,
    sizes: Sizes { name: "triangles", all: &[2, 8, 32, 128, 512, 2048, 8192, 32_768], usual: 32 },
    stability: Stability {
        stress: "how much deeper a triangle's farthest corner is, over the nearest one's depth",
        falling: false,
        error: Quantity {
            name: "largest error, triangles of 256 px",
            unit: "texels of a texture of 256",
            limit: (0.5, "½ texel"),
        },
        measure: method_stability,
    },
    wrong: &[],
    advice: &[
        ("per-pixel", "always, on today's processors"),
        ("every-8", "where a division takes as long as several pixels, and an error of some texels may show"),
        ("every-16", "where it takes as long as many pixels, and a ripple may show"),
        ("affine", "triangles that are hardly deeper on one side than on the other"),
    ],
};

pub(crate) const DEPTHS_CHART: Chart = Chart {
    name: "10-perspective-depths",
    job: "Lesson 10, keeping depths",
    methods: || DEPTHS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "smallest gap that is told apart",
        unit: "of the distance",
        limit: (1e-6, "within a millionth of the distance"),
    },
    further: &[],
    samples: "distances between the near plane and a far plane at 10⁵ times its depth, each digit of them equally often",
    exhaustive: false,
    proved: &[],
    errors: depth_errors,
    timed: "eight walls of 800×800 px one behind the other, the nearest one first",
    throughput: "Mpx/s",
    work: depth_work,
    sizes: Sizes { name: "walls", all: &[1, 2, 4, 8, 16], usual: 8 },
    stability: Stability {
        stress: "depth of the far plane over that of the near one",
        falling: false,
        error: Quantity {
            name: "smallest gap that is told apart, at worst",
            unit: "of the distance",
            limit: (1e-3, "a thousandth of the distance"),
        },
        measure: depth_stability,
    },
    wrong: &[],
    advice: &[
        ("reversed-z-f32", "always, where the buffer holds floats"),
        ("z-f32", "small scenes: a far plane at no more than a thousand times the near one's depth"),
        ("z24", "small scenes, where the buffer holds whole numbers"),
        ("w", "where the distance itself is needed afterwards"),
        ("logarithmic", "where the buffer holds whole numbers and the scene is deep"),
    ],
};

pub(crate) const DIVISIONS_CHART: Chart = Chart {
    name: "10-perspective-divisions",
    job: "Lesson 10, one over w",
    methods: || DIVISIONS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "error of 1/x", unit: "of 1/x", limit: (0.5 / 1024.0, "within ½ texel of 1024")
    },
    further: &[],
    samples: "every f32 from 1 to 2, as the errors are the same in every octave",
    exhaustive: true,
    proved: &[],
    errors: division_errors,
    timed: "1,000 numbers in a list",
    throughput: "Mop/s",
    work: division_work,
    sizes: Sizes { name: "numbers", all: &[1000], usual: 1000 },
    stability: Stability {
        stress: "x",
        falling: false,
        error: Quantity {
            name: "largest error of 1/x",
            unit: "of 1/x",
            limit: (0.5 / 1024.0, "½ texel of 1024"),
        },
        measure: division_stability,
    },
    wrong: &[],
    advice: &[
        ("exact", "unless a division is what a program waits for"),
        ("fast-2", "where it is, and a texture has less than some 70,000 texels each way"),
        ("fast-1", "where it is, and a texture has less than some 200 texels each way"),
    ],
};

/// Side of the picture of random triangles.
const SIDE: i32 = 256;

/// A triangle in the window, its depths, and what its corners have, in texels.
struct Triangle {
    corners: [DVec2; 3],
    depths: [f64; 3],
    texels: [Vec2; 3],
}

impl Triangle {
    /// With depths up to `ratio` times the nearest, which some corner reaches, and corners on 1/256 px, so that nobody
    /// rounds them. None too thin.
    fn random(random: &mut Rng, ratio: f64) -> Self {
        loop {
            let mut place = || f64::from(random.i32(0..SIDE * 256)) / 256.0;
            let corners = [(); 3].map(|()| DVec2::new(place(), place()));
            if (corners[1] - corners[0]).perp_dot(corners[2] - corners[0]).abs() < 8192.0 {
                continue;
            }
            let depths = [1.0, ratio, ratio.powf(random.f64())];
            let texels = [(); 3].map(|()| Vec2::new(random.f32(), random.f32()) * TEXELS as f32);
            return Self { corners, depths, texels };
        }
    }

    /// What is seen at a point of the window: where the ray from the eye through it meets the triangle.
    fn exact(&self, at: DVec2) -> DVec2 {
        let corner = |n: usize| self.corners[n].extend(1.0) * self.depths[n];
        let meets = DMat3::from_cols(corner(0), corner(1), corner(2)).inverse() * at.extend(1.0);
        let weights = meets / meets.element_sum();
        let [a, b, c] = self.texels.map(Vec2::as_dvec2);
        a * weights.x + b * weights.y + c * weights.z
    }

    /// The largest and the mean error of a method, in texels.
    fn errors(&self, method: &Method<Interpolate>) -> (f64, f64) {
        let corner = |n: usize| {
            let DVec2 { x, y } = self.corners[n];
            Vec4::new(x as f32, y as f32, 0.5, (1.0 / self.depths[n]) as f32)
        };
        let bounds = Bounds { min: IVec2::ZERO, max: IVec2::splat(SIDE - 1) };
        let (mut largest, mut sum, mut count) = (0.0_f64, 0.0, 0_u32);
        (method.run.visit)([0, 1, 2].map(corner), self.texels, bounds, &mut |x, y, _, texel| {
            let at = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let off = texel.as_dvec2().distance(self.exact(at));
            largest = largest.max(off);
            sum += off;
            count += 1;
        });
        (largest, sum / f64::from(count.max(1)))
    }
}

fn method_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), 0);
    for _ in 0..effort.samples(1000) {
        let ratio = 1.0 + 3.0 * random.f64();
        let triangle = Triangle::random(&mut random, ratio);
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let (largest, mean) = triangle.errors(method);
            errors.add(largest, mean, &[]);
        }
    }
    errors
}

/// Corners deeper and deeper behind the nearest one.
fn method_stability(effort: Effort) -> Vec<Series> {
    let shares = (0..=14).map(|n| 10f64.powf(f64::from(n) / 2.0 - 3.0));
    let worst = |method: &Method<Interpolate>, share: f64| {
        let mut random = effort.random();
        let triangles =
            (0..effort.samples(200)).map(|_| Triangle::random(&mut random, 1.0 + share).errors(method).0);
        triangles.fold(0.0, f64::max)
    };
    METHODS.iter().map(|method| shares.clone().map(|share| (share, worst(method, share))).collect()).collect()
}

/// A wall that fills the view, of so many triangles, from the depth 1 at the left side to 4 at the right one.
fn wall(triangles: usize, farther: f32) -> Model {
    let cells = ((triangles / 2) as f64).sqrt().round() as usize;
    let mut text = String::from("vn 0 0 1\n");
    for (row, column) in (0..=cells).flat_map(|row| (0..=cells).map(move |column| (row, column))) {
        let (u, v) = (column as f32 / cells as f32, row as f32 / cells as f32);
        let depth = (1.0 + 3.0 * u) * farther;
        // At every depth a little more than the view is high or wide.
        let (x, y) =
            (1.02 * (2.0 * u - 1.0).mul_add(4.0, 3.0 * (1.0 - u)) * farther, 4.2 * (2.0 * v - 1.0) * farther);
        text += &format!("v {x} {y} {}\nvt {u} {v}\n", -depth);
    }
    let corner = |row: usize, column: usize| {
        let n = row * (cells + 1) + column + 1;
        format!("{n}/{n}/1")
    };
    for (row, column) in (0..cells).flat_map(|row| (0..cells).map(move |column| (row, column))) {
        let lower = [corner(row, column), corner(row, column + 1)];
        let upper = [corner(row + 1, column + 1), corner(row + 1, column)];
        text += &format!("f {} {} {} {}\n", lower[0], lower[1], upper[0], upper[1]);
    }
    Model::parse(text.as_bytes(), Attributes { normals: true, uvs: true }).expect("the wall is a model")
}

/// The planes of what is timed.
const PLANES: Planes = Planes { near: 0.1, far: 1000.0 };

/// Draws walls in a picture of 800×800, again and again; what is counted are fragments.
fn work(draw: Draw, walls: &'static [(Model, Vec<[Vec3; 3]>)], texture: &'static Image) -> Work {
    const SIDE: u16 = 800;
    let to_clip = perspective(90.0, 1.0, PLANES.near, PLANES.far).expect("it is a camera");
    let uniforms: Vec<Uniforms> = walls
        .iter()
        .map(|(model, normals)| Uniforms {
            normals,
            texture: Some(texture),
            wrap: Wrap::Repeat,
            to_clip,
            ..Uniforms::new(model)
        })
        .collect();
    let mut image = Image::new(SIDE, SIDE, Format::Rgb);
    let amount = f64::from(SIDE) * f64::from(SIDE) * walls.len() as f64;
    Work::new(amount, move || draw(&uniforms, PLANES, &mut image).left_out)
}

/// Walls one behind the other, kept until the program ends.
fn walls(triangles: usize, count: usize) -> &'static [(Model, Vec<[Vec3; 3]>)] {
    let walls = (0..count).map(|n| {
        let model = wall(triangles, 1.0 + 0.05 * n as f32);
        let normals = corner_normals(&model);
        (model, normals)
    });
    Box::leak(walls.collect())
}

fn method_work(size: usize, _: Effort) -> Vec<Work> {
    let (walls, texture) = (walls(size, 1), &*Box::leak(Box::new(texture())));
    let keep = &Method::find(DEPTHS, "z-f32").expect("the lesson has it").run;
    METHODS.iter().map(|method| work((method.run.draw)(keep), walls, texture)).collect()
}

fn depth_work(size: usize, _: Effort) -> Vec<Work> {
    let (walls, texture) = (walls(32, size), &*Box::leak(Box::new(texture())));
    let way = &Method::find(METHODS, "per-pixel").expect("the lesson has it").run;
    DEPTHS.iter().map(|method| work((way.draw)(&method.run), walls, texture)).collect()
}

/// A distance between the planes, each power of ten equally likely.
fn distance(random: &mut Rng, planes: Planes) -> f64 {
    let (near, far) = (f64::from(planes.near), f64::from(planes.far));
    near * (far / near).powf(random.f64())
}

fn depth_errors(effort: Effort) -> Vec<Errors> {
    let planes = Planes { near: 1.0, far: 1e5 };
    let mut random = effort.random();
    let mut errors = Errors::table(DEPTHS.len(), 0);
    for _ in 0..effort.samples(20_000) {
        let distance = distance(&mut random, planes);
        for (method, errors) in DEPTHS.iter().zip(&mut errors) {
            let gap = gap(&method.run, planes, distance);
            errors.add(gap, gap, &[]);
        }
    }
    errors
}

fn depth_stability(effort: Effort) -> Vec<Series> {
    let worst = |method: &Method<Keep>, ratio: f64| {
        let planes = Planes { near: 1.0, far: ratio as f32 };
        let mut random = effort.random();
        let some = (0..effort.samples(4000)).map(|_| distance(&mut random, planes));
        // The far plane is where most of them are worst.
        let all = some.chain([f64::from(planes.far)]);
        all.map(|distance| gap(&method.run, planes, distance)).fold(0.0, f64::max)
    };
    let ratios = (2..=16).map(|half| 10f64.powf(f64::from(half) / 2.0));
    DEPTHS.iter().map(|method| ratios.clone().map(|ratio| (ratio, worst(method, ratio))).collect()).collect()
}

/// The relative error of a reciprocal. A result that is no number, or 0, is as wrong as can be.
fn off(reciprocal: fn(f32) -> f32, x: f32) -> f64 {
    let product = f64::from(reciprocal(x)) * f64::from(x);
    if product.is_finite() && product > 0.0 { (product - 1.0).abs() } else { f64::INFINITY }
}

fn division_errors(effort: Effort) -> Vec<Errors> {
    let mut errors = Errors::table(DIVISIONS.len(), 0);
    let every = if effort.quick { 20 } else { 1 };
    for bits in (1.0_f32.to_bits()..2.0_f32.to_bits()).step_by(every) {
        let x = f32::from_bits(bits);
        for (method, errors) in DIVISIONS.iter().zip(&mut errors) {
            let off = off(method.run.one, x);
            errors.add(off, off, &[]);
        }
    }
    errors
}

fn division_work(size: usize, effort: Effort) -> Vec<Work> {
    let mut random = effort.random();
    let numbers: Vec<f32> = (0..size).map(|_| 0.5 + random.f32()).collect();
    let work = |method: &Method<Reciprocal>| {
        // The reciprocal of a reciprocal is the number again, or nearly: all stay about 1 however often this is done.
        let (mut numbers, all) = (numbers.clone(), method.run.all);
        Work::new(size as f64, move || {
            all(&mut numbers);
            numbers[0]
        })
    };
    DIVISIONS.iter().map(work).collect()
}

/// Larger and larger numbers, up to the largest: their reciprocals get too small for the trick.
fn division_stability(effort: Effort) -> Vec<Series> {
    let exponents = [0, 10, 20, 40, 60, 80, 100, 110, 120, 124, 125, 126, 127];
    let worst = |method: &Method<Reciprocal>, exponent: i32| {
        let mut random = effort.random();
        let some = (0..effort.samples(1000)).map(|_| (1.0 + random.f32() * 0.999) * 2f32.powi(exponent));
        some.map(|x| off(method.run.one, x)).fold(0.0, f64::max)
    };
    DIVISIONS
        .iter()
        .map(|method| {
            exponents.map(|exponent| (f64::from(exponent).exp2(), worst(method, exponent))).to_vec()
        })
        .collect()
}
