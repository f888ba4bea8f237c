//! Lesson 17: the same pixels, by each method.

use std::rc::Rc;

use clipping::Cull;
use common::{Format, Image, Method, Vec3};
use fastrand::Rng;
use filtering::Surface;
use perspective::{perspective, view};
use speed::{METHODS, Picture, Renderer};
use speed_scenes::{Scene, grid};

use super::figures::{SIZE, camera, subjects};
use crate::lessons::filtering::figures::{LIGHT, Subject};
use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

/// In place of a size: the lesson's own picture.
const OWN: usize = 0;

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "17-speed",
    job: "Lesson 17, the same pixels",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "pixels unlike lesson 13's",
        unit: "a picture",
        limit: (1.0, "within one a picture"),
    },
    further: &[],
    samples: "pictures of 120×90 px of the head on the floor from anywhere around it, all filters",
    exhaustive: false,
    proved: &["simple", "blocks", "simd", "tiles", "hierarchical-depth", "deferred", "threads"],
    errors: method_errors,
    timed: "the lesson's own picture, 800×800 px, trilinear; threads: with one",
    throughput: "Mpx/s",
    work: method_work,
    sizes: Sizes {
        name: "pixels a triangle",
        all: &[1, 4, 16, 64, 256, 1024, 4096, 16_384, 65_536, 1_000_000],
        usual: OWN,
    },
    stability: Stability {
        stress: "pixels of the picture's side",
        falling: false,
        error: Quantity {
            name: "pixels unlike lesson 13's",
            unit: "a picture",
            limit: (1.0, "one a picture"),
        },
        measure: method_stability,
    },
    wrong: &[],
    advice: &[
        ("threads", "always, where nothing else needs the cores"),
        ("deferred", "one core; shaders that drop no fragment"),
        ("hierarchical-depth", "shaders that drop fragments, front to back"),
        ("simple", "a few small triangles, and to compare with"),
    ],
};

/// How many pixels of two pictures differ.
fn differing(one: &Image, other: &Image) -> f64 {
    one.pixels().zip(other.pixels()).filter(|(a, b)| a.2 != b.2).count() as f64
}

/// For each method, how many pixels of a picture of the lesson's subjects are others than those of the first.
fn unlike(subjects: &[Subject], random: &mut Rng, [width, height]: [u16; 2], filter: usize) -> Vec<f64> {
    let around = std::f32::consts::TAU * random.f32();
    let (high, far) = (2.0 * random.f32() - 0.3, 1.5 + 3.0 * random.f32());
    let eye = Vec3::new(far * around.sin(), high, far * around.cos());
    let look = view(eye, Vec3::new(0.0, -0.2, 0.0), Vec3::Y).expect("the eye is not at the centre");
    let aspect = f32::from(width) / f32::from(height);
    let to_clip = perspective(50.0, aspect, 0.1, 100.0).expect("there is such a camera") * look;
    let surfaces: Vec<Surface> =
        subjects.iter().map(|subject| subject.surface(LIGHT.normalize(), to_clip)).collect();
    let picture = Picture { surfaces: &surfaces, cull: Cull::Back };
    let draw = |method: &Method<Renderer>| {
        let mut image = Image::new(width, height, Format::Rgb);
        let mut drawer = method.run.drawer([width.into(), height.into()], filter, 2);
        drawer(&picture, &mut image);
        image
    };
    let pictures: Vec<Image> = METHODS.iter().map(draw).collect();
    pictures.iter().map(|image| differing(image, &pictures[0])).collect()
}

fn method_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let subjects = subjects().expect("the course has both");
    let mut errors = Errors::table(METHODS.len(), 0);
    for n in 0..effort.samples(200) {
        let filter = n % filtering::METHODS.len();
        let unlike = unlike(&subjects, &mut random, [120, 90], filter);
        errors.iter_mut().zip(unlike).for_each(|(errors, unlike)| errors.add(unlike, unlike, &[]));
    }
    errors
}

fn method_stability(effort: Effort) -> Vec<Series> {
    let mut random = effort.random();
    let subjects = subjects().expect("the course has both");
    let mut series = vec![Series::new(); METHODS.len()];
    // About what tiles and blocks have.
    for side in [1, 3, 8, 13, 31, 64, 65, 129, 257] {
        let unlike = unlike(&subjects, &mut random, [side; 2], 0);
        series.iter_mut().zip(unlike).for_each(|(line, unlike)| line.push((side.into(), unlike)));
    }
    series
}

fn method_work(size: usize, _: Effort) -> Vec<Work> {
    if size == OWN { own_picture() } else { scene_works(grid::grid(size as f32), METHODS) }
}

fn own_picture() -> Vec<Work> {
    let subjects = Rc::new(subjects().expect("the course has both"));
    let to_clip = camera().expect("it looks somewhere");
    let trilinear = filtering::METHODS.iter().position(|row| row.name == "trilinear").unwrap_or(0);
    let work = |method: &Method<Renderer>| {
        let subjects = Rc::clone(&subjects);
        let mut image = Image::new(SIZE, SIZE, Format::Rgb);
        let mut draw = method.run.drawer([SIZE.into(); 2], trilinear, 1);
        Work::new(f64::from(SIZE) * f64::from(SIZE), move || {
            let surfaces = [0, 1].map(|n: usize| subjects[n].surface(LIGHT.normalize(), to_clip));
            draw(&Picture { surfaces: &surfaces, cull: Cull::Back }, &mut image)
        })
    };
    METHODS.iter().map(work).collect()
}

/// Draws a scene on one thread with the nearest texel; counted are the picture's pixels.
pub(crate) fn scene_works<'a>(
    scene: Scene,
    methods: impl IntoIterator<Item = &'a Method<Renderer>>,
) -> Vec<Work> {
    let scene = Rc::new(scene);
    let work = |method: &Method<Renderer>| {
        let scene = Rc::clone(&scene);
        let [width, height] = scene.size;
        let mut image = scene.canvas();
        let mut draw = method.run.drawer([width.into(), height.into()], 0, 1);
        Work::new(f64::from(width) * f64::from(height), move || {
            draw(&Picture { surfaces: &[scene.surface()], cull: Scene::CULL }, &mut image)
        })
    };
    methods.into_iter().map(work).collect()
}
