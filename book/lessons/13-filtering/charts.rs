//! Lesson 13: the colour of a pixel's footprint, smaller levels, and where texels are kept.

use checks::footprint::{Outside, Plane, Texture as Exact, code};
use checks::ray::Screen;
use clipping::{Cull, Drawn};
use common::{Color, Format, Image, Mat4, Method, Vec2, Vec3};
use fastrand::Rng;
use filtering::layout::Keep;
use filtering::mipmap::Mipmap;
use filtering::{Footprint, LAYOUTS, METHODS, MIPMAPS, Sampler, Texture, Wrap};
use glam::{DMat3, DVec2, DVec3};

use crate::figures::picture::method;
use crate::lessons::filtering::figures::{Subject, floor_of, of_light, over_the_floor, squares};
use crate::measuring::finish::{flip, rms};
use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::models::texture;
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

/// What all errors here are.
const ERROR: Quantity = Quantity {
    name: "RMS difference of a picture",
    unit: "grey levels of 255",
    limit: (10.0, "within 10 levels"),
};

pub(crate) const METHODS_CHART: Chart = Chart {
    name: "13-filtering",
    job: "Lesson 13, the colour of a footprint",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: ERROR,
    further: &["flip", "reference_off"],
    samples: "pictures of 64×64 px of a plane at a random angle up to 85° and distance, with the crate's side or checks on it",
    exhaustive: false,
    proved: &[],
    errors: method_errors,
    timed: "the lesson's floor to the horizon, 800×800 px",
    throughput: "Mpx/s",
    work: method_work,
    sizes: Sizes { name: "texels across the texture", all: &[16, 64, 256, 1024, 2048], usual: 256 },
    stability: Stability {
        stress: "texels across a pixel, seen head-on",
        falling: false,
        error: Quantity {
            name: "RMS difference",
            unit: "grey levels of 255",
            limit: (10.0, "10 grey levels"),
        },
        measure: method_stability,
    },
    wrong: &[],
    advice: &[
        ("trilinear", "always, unless floors are to be sharp"),
        ("anisotropic", "floors, roads and walls seen at a flat angle"),
        ("bilinear", "pictures that are never made smaller"),
        ("bilinear-8", "the same in whole numbers, as graphics cards do it"),
        ("nearest", "where texels are to be seen"),
    ],
};

pub(crate) const MIPMAPS_CHART: Chart = Chart {
    name: "13-filtering-mipmaps",
    job: "Lesson 13, making smaller levels",
    methods: || MIPMAPS.iter().map(|method| method.name).collect(),
    error: ERROR,
    further: &["flip", "darker"],
    samples: "the same pictures, at angles up to 45°, by trilinear",
    exhaustive: false,
    proved: &[],
    errors: mipmap_errors,
    timed: "all levels of a texture of 256×256 texels",
    throughput: "Mtexel/s",
    work: mipmap_work,
    sizes: Sizes { name: "texels across the texture", all: &[16, 64, 256, 1024], usual: 256 },
    stability: Stability {
        stress: "texels across a pixel, seen head-on",
        falling: false,
        error: Quantity {
            name: "RMS difference",
            unit: "grey levels of 255",
            limit: (10.0, "10 grey levels"),
        },
        measure: mipmap_stability,
    },
    wrong: &[],
    advice: &[
        ("box-linear", "always"),
        ("lanczos-linear", "where levels are made once and looked at for long"),
        ("box-encoded", "textures whose numbers are no colours"),
    ],
};

pub(crate) const LAYOUTS_CHART: Chart = Chart {
    name: "13-filtering-layouts",
    job: "Lesson 13, where texels are kept",
    methods: || LAYOUTS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "lines of memory fetched",
        unit: "a look-up",
        limit: (1.0, "within one a look-up"),
    },
    further: &[],
    samples: "walks of 512 bilinear look-ups, a texel apart, in random directions over 1024×1024 texels",
    exhaustive: false,
    proved: &[],
    errors: layout_errors,
    timed: "1024×1024 bilinear look-ups, straight up, in a texture of 4096×4096 texels",
    throughput: "Mlookup/s",
    work: layout_work,
    sizes: Sizes { name: "texels across the texture", all: &[64, 256, 1024, 4096], usual: 4096 },
    stability: Stability {
        stress: "angle of the walk to the rows, degrees",
        falling: false,
        error: Quantity { name: "lines of memory fetched", unit: "a look-up", limit: (1.0, "one a look-up") },
        measure: layout_stability,
    },
    wrong: &[],
    advice: &[
        ("rows", "here, where a look-up computes for longer than it waits"),
        ("tiles-4x4", "where lines of memory are what counts, as in hardware"),
        ("morton", "where nobody knows how large lines and caches are"),
    ],
};

/// A texture as the lesson has it, and as it is, to be repeated.
struct Textured {
    image: Image,
    exact: Exact,
}

/// The crate's side, and checks of 16 texels.
fn subjects() -> Vec<Textured> {
    let subject = |image: Image| Textured { exact: Exact::new(&image, Outside::Again), image };
    vec![subject(texture()), subject(squares(16))]
}

/// A picture of a plane before an eye.
struct View {
    plane: Plane,
    screen: Screen,
    side: i32,
    /// What of a texture each pixel sees at its centre; none beyond the plane's horizon.
    seen: Vec<Option<(Vec2, Footprint)>>,
    /// What it should show, from 0 to 255, of the texture of that number, and with half as many rays each way.
    expected: Vec<[f64; 3]>,
    roughly: Vec<[f64; 3]>,
    subject: usize,
}

/// Rays for each pixel, each way, which is a mean over so many texels each way.
fn rays(texels: f64) -> u32 {
    (2.0 * texels).clamp(16.0, 512.0) as u32
}

impl View {
    /// Of a plane that is turned about the vertical axis and then about the line of sight, each pixel straight ahead as
    /// wide as so many texels.
    fn new(
        random: &mut Rng,
        subjects: &[Textured],
        (side, tilt, texels): (i32, f64, f64),
        rays: u32,
    ) -> Self {
        let screen = Screen::ahead(40.0, DVec2::splat(side.into()));
        let pixel = 2.0 * screen.high.x / f64::from(side);
        let subject = random.usize(..subjects.len());
        let size = f64::from(subjects[subject].image.width());
        // At the depth 1 a texel is as large as the share of a pixel that it is to be.
        let texture = size * pixel / texels;
        let turn =
            DMat3::from_rotation_z(std::f64::consts::TAU * random.f64()) * DMat3::from_rotation_y(tilt);
        let (u, v) = (turn * DVec3::X * texture, turn * DVec3::Y * texture);
        let origin = -DVec3::Z - u * random.f64() - v * random.f64();
        let plane = Plane { origin, u, v };
        let pixels = || (0..side * side).map(|n| (n % side, n / side));
        let center = |x: i32, y: i32| DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let seen = pixels().map(|(x, y)| {
            let uv = plane.met(screen.through(x, y))?;
            let [right, up] = plane.moves(&screen, center(x, y))?;
            Some((uv.as_vec2(), Footprint { x: right.as_vec2(), y: up.as_vec2() }))
        });
        let exact = &subjects[subject].exact;
        let mean = |rays: u32| {
            let light = |(x, y)| {
                plane.seen(exact, &screen, [x, y], [rays; 2]).map_or([0.0; 3], |light| light.map(code))
            };
            pixels().map(light).collect::<Vec<_>>()
        };
        let (expected, roughly) = (mean(rays), mean(rays / 2));
        Self { plane, screen, side, seen: seen.collect(), expected, roughly, subject }
    }

    /// The picture by some way to find a colour; black where rays meet nothing.
    fn picture(&self, color: impl Fn(Vec2, Footprint) -> Color) -> Image {
        let mut image = Image::new(self.side as u16, self.side as u16, Format::Rgb);
        for (n, seen) in self.seen.iter().enumerate() {
            let (x, y) = (n as i32 % self.side, n as i32 / self.side);
            if let (Some((uv, footprint)), true) = (seen, self.is_whole(x, y)) {
                image.set(x, y, color(*uv, *footprint));
            }
        }
        image
    }

    /// Whether all of a pixel sees the plane.
    fn is_whole(&self, x: i32, y: i32) -> bool {
        let corner = |dx: i32, dy: i32| {
            let at = DVec2::new(f64::from(x + dx), f64::from(y + dy));
            self.plane.met(self.screen.direction(at)).is_some()
        };
        [(0, 0), (1, 0), (0, 1), (1, 1)].into_iter().all(|(dx, dy)| corner(dx, dy))
    }
}

/// The mean difference of a picture from a brighter one.
fn darker(got: &Image, expected: &[[f64; 3]]) -> f64 {
    let sum: f64 = expected.iter().flatten().sum::<f64>();
    let got: f64 = got.buffer().iter().map(|&channel| f64::from(channel)).sum();
    (sum - got) / (3.0 * expected.len() as f64)
}

fn mean(values: &[f32]) -> f64 {
    values.iter().map(|value| f64::from(*value)).sum::<f64>() / values.len() as f64
}

/// A random plane: each angle up to a largest one, from twice as large to 16 times as small, each power equally likely.
fn random_view(random: &mut Rng, subjects: &[Textured], largest: f64) -> View {
    let tilt = largest.to_radians() * random.f64();
    let texels = 2f64.powf(5.0 * random.f64() - 1.0);
    View::new(random, subjects, (64, tilt, texels), 32)
}

fn textures(subjects: &[Textured], mipmap: &Mipmap) -> Vec<Texture> {
    subjects.iter().map(|subject| mipmap.texture(&subject.image, Wrap::Repeat)).collect()
}

fn method_errors(effort: Effort) -> Vec<Errors> {
    let subjects = subjects();
    let textures = textures(&subjects, &of_light().expect("the lesson has it"));
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), METHODS_CHART.further.len());
    for _ in 0..effort.samples(200) {
        let view = random_view(&mut random, &subjects, 85.0);
        let off = of_rays(&view);
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let texture = &textures[view.subject];
            let picture = view.picture(|uv, footprint| (method.run.color)(texture, uv, footprint));
            let wrong = rms(&picture, &view.expected, |_| true);
            errors.add(wrong, wrong, &[mean(&flip(&picture, &view.expected)), off]);
        }
    }
    errors
}

/// The RMS difference that half as many rays make: the error of the reference is less than that.
fn of_rays(view: &View) -> f64 {
    let squares =
        view.expected.as_flattened().iter().zip(view.roughly.as_flattened()).map(|(a, b)| (a - b).powi(2));
    (squares.sum::<f64>() / (3.0 * view.expected.len() as f64)).sqrt()
}

fn mipmap_errors(effort: Effort) -> Vec<Errors> {
    let subjects = subjects();
    let textures: Vec<Vec<Texture>> = MIPMAPS.iter().map(|mipmap| textures(&subjects, &mipmap.run)).collect();
    let trilinear = trilinear();
    let mut random = effort.random();
    let mut errors = Errors::table(MIPMAPS.len(), MIPMAPS_CHART.further.len());
    for _ in 0..effort.samples(200) {
        let view = random_view(&mut random, &subjects, 45.0);
        for (textures, errors) in textures.iter().zip(&mut errors) {
            let picture =
                view.picture(|uv, footprint| (trilinear.color)(&textures[view.subject], uv, footprint));
            let wrong = rms(&picture, &view.expected, |_| true);
            let further = [mean(&flip(&picture, &view.expected)), darker(&picture, &view.expected)];
            errors.add(wrong, wrong, &further);
        }
    }
    errors
}

fn trilinear() -> &'static Sampler {
    method(METHODS, "trilinear").expect("the lesson has it")
}

/// How a colour is found in the texture of that number.
type Way = Box<dyn Fn(usize, Vec2, Footprint) -> Color>;

/// Smaller and smaller, head-on: for each way, the mean of its pictures' errors at 1, 2, 4 … 256 texels to a pixel.
fn minified(effort: Effort, ways: &[Way]) -> Vec<Series> {
    let subjects = subjects();
    let mut random = effort.random();
    let mut series = vec![Series::new(); ways.len()];
    for power in 0..=8 {
        let texels = 2f64.powi(power);
        let pictures = effort.samples(40);
        let mut sums = vec![0.0; ways.len()];
        for _ in 0..pictures {
            let view = View::new(&mut random, &subjects, (8, 0.0, texels), rays(texels));
            for (way, sum) in ways.iter().zip(&mut sums) {
                let picture = view.picture(|uv, footprint| way(view.subject, uv, footprint));
                *sum += rms(&picture, &view.expected, |_| true);
            }
        }
        series.iter_mut().zip(&sums).for_each(|(line, sum)| line.push((texels, sum / pictures as f64)));
    }
    series
}

/// A way to find a colour in one of some textures.
fn way(textures: Vec<Texture>, sampler: &'static Sampler) -> Way {
    Box::new(move |subject, uv, footprint| (sampler.color)(&textures[subject], uv, footprint))
}

fn method_stability(effort: Effort) -> Vec<Series> {
    let mipmap = of_light().expect("the lesson has it");
    let ways: Vec<_> =
        METHODS.iter().map(|method| way(textures(&subjects(), &mipmap), &method.run)).collect();
    minified(effort, &ways)
}

fn mipmap_stability(effort: Effort) -> Vec<Series> {
    let ways: Vec<_> =
        MIPMAPS.iter().map(|mipmap| way(textures(&subjects(), &mipmap.run), trilinear())).collect();
    minified(effort, &ways)
}

/// The lesson's floor with the crate's side on it, that many texels across, kept until the program ends.
fn floor(texels: usize) -> &'static Subject {
    let image = texture().scale(texels as u16, texels as u16);
    let floor = floor_of(image, of_light().expect("the lesson has it")).expect("the lesson has a floor");
    Box::leak(Box::new(floor))
}

/// Draws a floor, from above lit, into a square picture.
pub(crate) fn drawing(
    floor: &'static Subject,
    to_clip: Mat4,
    side: u16,
    sampler: &'static Sampler,
) -> impl FnMut() -> Drawn + 'static {
    let mut image = Image::new(side, side, Format::Rgb);
    move || (sampler.draw)(&[floor.surface(Vec3::Y, to_clip)], Cull::Back, &mut image)
}

fn method_work(size: usize, _: Effort) -> Vec<Work> {
    const SIDE: u16 = 800;
    let floor = floor(size);
    let to_clip = over_the_floor([SIDE, SIDE]).expect("it looks somewhere");
    let drawing = |method: &'static Method<Sampler>| drawing(floor, to_clip, SIDE, &method.run);
    let depths = drawing(&METHODS[0])().depths;
    let pixels = (0..i32::from(SIDE)).flat_map(|y| (0..i32::from(SIDE)).map(move |x| (x, y)));
    let covered = pixels.filter(|&(x, y)| depths.get(x, y) < 1.0).count() as f64;
    METHODS.iter().map(|method| Work::new(covered, drawing(method))).collect()
}

fn mipmap_work(size: usize, _: Effort) -> Vec<Work> {
    let image = texture().scale(size as u16, size as u16);
    let work = |mipmap: &'static Method<Mipmap>| {
        let image = image.clone();
        Work::new((size * size) as f64, move || mipmap.run.levels(&image, Wrap::Repeat).len())
    };
    MIPMAPS.iter().map(work).collect()
}

/// How many lines of memory a walk fetches for each of its look-ups, if those of the last one are still there.
fn lines(layout: &Method<Keep>, from: DVec2, angle: f64) -> f64 {
    const LOOKUPS: u32 = 512;
    let step = DVec2::from_angle(angle);
    let (mut last, mut fetched) = (Vec::new(), 0);
    for n in 0..LOOKUPS {
        let at = from + step * f64::from(n);
        let texel = |dx: f64, dy: f64| {
            let inside = |x: f64| (x.floor() as i64).rem_euclid(SIDE.into()) as u32;
            (layout.run.place)([SIDE; 2], [inside(at.x - 0.5 + dx), inside(at.y - 0.5 + dy)]) / 16
        };
        let mut lines = vec![texel(0.0, 0.0), texel(1.0, 0.0), texel(0.0, 1.0), texel(1.0, 1.0)];
        lines.sort_unstable();
        lines.dedup();
        fetched += lines.iter().filter(|line| !last.contains(*line)).count();
        last = lines;
    }
    fetched as f64 / f64::from(LOOKUPS)
}

/// Texels across the texture in which lines are counted.
const SIDE: u32 = 1024;

fn somewhere(random: &mut Rng) -> DVec2 {
    DVec2::new(random.f64(), random.f64()) * f64::from(SIDE)
}

fn layout_errors(effort: Effort) -> Vec<Errors> {
    let mut random = effort.random();
    let mut errors = Errors::table(LAYOUTS.len(), 0);
    for _ in 0..effort.samples(10_000) {
        let (from, angle) = (somewhere(&mut random), std::f64::consts::TAU * random.f64());
        for (method, errors) in LAYOUTS.iter().zip(&mut errors) {
            let fetched = lines(method, from, angle);
            errors.add(fetched, fetched, &[]);
        }
    }
    errors
}

fn layout_stability(effort: Effort) -> Vec<Series> {
    let angles = [1.0, 2.0, 5.0, 10.0, 14.0, 20.0, 30.0, 45.0, 60.0, 75.0, 90.0];
    let mean = |method: &Method<Keep>, angle: f64| {
        let mut random = effort.random();
        let walks = effort.samples(200);
        let all = (0..walks).map(|_| lines(method, somewhere(&mut random), angle.to_radians()));
        all.sum::<f64>() / walks as f64
    };
    LAYOUTS.iter().map(|method| angles.map(|angle| (angle, mean(method, angle))).to_vec()).collect()
}

/// Walks of 1024×1024 look-ups over a texture, its rows at that angle to those of the texture, in degrees.
pub(crate) fn walks(side: usize, angle: f32) -> Vec<Work> {
    const LOOKUPS: usize = 1024;
    let image = texture().scale(side as u16, side as u16);
    let step = Vec2::from_angle(angle.to_radians()) / side as f32;
    let work = |method: &'static Method<Keep>| {
        let walk = (method.run.walk)(&image);
        let mut colors = vec![Color::BLACK; LOOKUPS * LOOKUPS];
        Work::new(colors.len() as f64, move || {
            walk(Vec2::splat(0.25), Footprint { x: step, y: step.perp() }, LOOKUPS, &mut colors);
            colors[LOOKUPS]
        })
    };
    LAYOUTS.iter().map(work).collect()
}

fn layout_work(size: usize, _: Effort) -> Vec<Work> {
    walks(size, 90.0)
}
