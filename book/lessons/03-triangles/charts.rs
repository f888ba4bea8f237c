//! Lesson 3: the pixels of a triangle.

use std::collections::BTreeSet;

use checks::coverage::Triangle as Exact;
use common::{Bounds, Color, Format, IVec2, Image, Method, Vec2};
use fastrand::Rng;
use triangles::{METHODS, Triangle};

use crate::measuring::measure::{Effort, Errors, Work};
use crate::measuring::table::{Chart, Quantity, Series, Sizes, Stability};

pub(crate) const CHART: Chart = Chart {
    name: "03-triangles",
    job: "Lesson 3, the pixels of a triangle",
    methods: || METHODS.iter().map(|method| method.name).collect(),
    error: Quantity {
        name: "pixels missing, extra or doubled, in a triangle",
        unit: "px",
        limit: (0.5, "without a wrong pixel"),
    },
    further: &["missing", "extra", "doubled"],
    samples: "random triangles of up to 64 px, half of them with corners on whole pixels",
    exhaustive: false,
    proved: &["edges"],
    errors,
    timed: "random triangles of 100 px each, in a picture of 1500×1500",
    throughput: "Mpx/s",
    work,
    sizes: Sizes {
        name: "pixels a triangle",
        all: &[1, 10, 100, 1000, 10_000, 100_000, 1_000_000],
        usual: 100,
    },
    stability: Stability {
        stress: "distance of a mesh of 2×72 triangles from the origin, px",
        falling: false,
        error: Quantity { name: "holes and doubled pixels", unit: "% of the mesh's", limit: (0.0, "none") },
        measure: stability,
    },
    wrong: &["outline"],
    advice: &[
        ("edges", "always"),
        ("barycentric", "to explain it, with corners within some 10⁴ px; neighbours that may share pixels"),
    ],
};

fn random_corners(random: &mut Rng, side: f32) -> [Vec2; 3] {
    let whole = random.bool();
    let mut coordinate = || random.f32() * side;
    let corners = [(); 3].map(|()| Vec2::new(coordinate(), coordinate()));
    if whole { corners.map(Vec2::round) } else { corners }
}

fn errors(effort: Effort) -> Vec<Errors> {
    const SIDE: i32 = 64;
    let window = Bounds { min: IVec2::splat(-2), max: IVec2::splat(SIDE + 2) };
    let width = (SIDE + 5) as usize;
    let mut random = effort.random();
    let mut errors = Errors::table(METHODS.len(), CHART.further.len());
    for _ in 0..effort.samples(20_000) {
        let corners = random_corners(&mut random, SIDE as f32);
        let expected = Exact::new(corners);
        let mut right = vec![false; width * width];
        let place = |x: i32, y: i32| (y + 2) as usize * width + (x + 2) as usize;
        expected.pixels(window).into_iter().for_each(|(x, y)| right[place(x, y)] = true);
        for (method, errors) in METHODS.iter().zip(&mut errors) {
            let mut visits = vec![0_u32; width * width];
            (method.run.visit)(corners, window, &mut |x, y, _| visits[place(x, y)] += 1);
            let count = |fault: fn(bool, u32) -> u32| {
                f64::from(
                    right.iter().zip(&visits).map(|(&right, &visits)| fault(right, visits)).sum::<u32>(),
                )
            };
            let missing = count(|right, visits| u32::from(right && visits == 0));
            let extra = count(|right, visits| u32::from(!right && visits > 0));
            let doubled = count(|_, visits| visits.saturating_sub(1));
            let wrong = missing + extra + doubled;
            errors.add(wrong, wrong, &[missing, extra, doubled]);
        }
    }
    errors
}

/// Triangles of that many pixels, of random shapes that are not too thin, in a picture of so many pixels a
/// side.
pub(crate) fn random_triangles(size: usize, picture: u16, random: &mut Rng) -> Vec<[Vec2; 3]> {
    // A triangle in a square covers between a quarter and a half of it.
    let side = (size as f32 * 2.7).sqrt();
    let mut triangle = || loop {
        let [a, b, c] = [(); 3].map(|()| Vec2::new(random.f32(), random.f32()));
        let area = (b - a).perp_dot(c - a).abs() / 2.0;
        if area > 0.2 {
            // Scaled to the very size.
            let side = side * (size as f32 / (area * side * side)).sqrt();
            let room = (f32::from(picture) - side).max(0.0);
            let corner = Vec2::new(random.f32(), random.f32()) * room;
            return [a, b, c].map(|point| corner + point * side);
        }
    };
    (0..(200_000 / size).max(4)).map(|_| triangle()).collect()
}

/// Each method drawing such triangles.
fn work(size: usize, effort: Effort) -> Vec<Work> {
    const SIDE: u16 = 1500;
    let triangles = random_triangles(size, SIDE, &mut effort.random());
    let draws = |draw: fn([Vec2; 3], &mut Image, Color), amount: usize| {
        let (triangles, mut image) = (triangles.clone(), Image::new(SIDE, SIDE, Format::Rgb));
        Work::new(amount as f64, move || {
            triangles.iter().for_each(|&corners| draw(corners, &mut image, Color::WHITE));
            image.get(0, 0)
        })
    };
    let nothing = draws(|_, _, _| {}, 0);
    let work = |method: &Method<Triangle>| draws(method.run.draw, done(method, &triangles));
    std::iter::once(nothing).chain(METHODS.iter().map(work)).collect()
}

/// How many of the pixels that should be a method finds, of a few triangles and so of all of them.
fn done(method: &Method<Triangle>, triangles: &[[Vec2; 3]]) -> usize {
    const FEW: usize = 200;
    let few = &triangles[..triangles.len().min(FEW)];
    let found = few.iter().map(|&corners| {
        let low = corners.into_iter().reduce(Vec2::min).unwrap_or_default().floor().as_ivec2();
        let high = corners.into_iter().reduce(Vec2::max).unwrap_or_default().ceil().as_ivec2();
        let window = Bounds { min: low - 1, max: high + 1 };
        let mut visited = BTreeSet::new();
        (method.run.visit)(corners, window, &mut |x, y, _| {
            visited.insert((x, y));
        });
        Exact::new(corners).pixels(window).into_iter().filter(|pixel| visited.contains(pixel)).count()
    });
    found.sum::<usize>() * triangles.len() / few.len()
}

/// A mesh that covers each pixel of a window once, farther and farther from the origin.
fn stability(effort: Effort) -> Vec<Series> {
    let shifts = (0..=7).map(|power| 10f64.powi(power));
    let share = |method: &Method<Triangle>, shift: f64| {
        let mut random = effort.random();
        let (mut wrong, mut all) = (0, 0);
        for _ in 0..effort.samples(200) {
            let mesh = mesh(&mut random, shift as f32);
            let (wrong_here, all_here) = holes_and_doubles(method, &mesh, shift as i32);
            wrong += wrong_here;
            all += all_here;
        }
        100.0 * f64::from(wrong) / f64::from(all)
    };
    METHODS.iter().map(|method| shifts.clone().map(|shift| (shift, share(method, shift))).collect()).collect()
}

/// Cells of 6 px in a square of 36 px, each cut in two, the corners inside moved by up to 0.9 px.
///
/// At 10⁷ f32 moves them by up to ½ px more. Up to 1.5 px in all, no cell is bent inwards and the triangles
/// still cover each point once.
fn mesh(random: &mut Rng, shift: f32) -> Vec<[Vec2; 3]> {
    const CELLS: usize = 6;
    let corners: Vec<Vec<Vec2>> = (0..=CELLS)
        .map(|j| {
            let corner = |i: usize, random: &mut Rng| {
                let inside = |n: usize| (1..CELLS).contains(&n);
                let mut moved = |n| if inside(n) { random.f32() * 1.8 - 0.9 } else { 0.0 };
                Vec2::new(i as f32 * 6.0 + moved(i), j as f32 * 6.0 + moved(j)) + shift
            };
            (0..=CELLS).map(|i| corner(i, random)).collect()
        })
        .collect();
    let cells = (0..CELLS).flat_map(|j| (0..CELLS).map(move |i| (i, j)));
    cells
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [corners[j][i], corners[j][i + 1], corners[j + 1][i + 1], corners[j + 1][i]];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

/// How many pixels in the middle of the mesh are covered by no triangle or several, and of how many.
fn holes_and_doubles(method: &Method<Triangle>, mesh: &[[Vec2; 3]], shift: i32) -> (u32, u32) {
    const SIDE: i32 = 24;
    let window = Bounds { min: IVec2::splat(shift + 6), max: IVec2::splat(shift + 6 + SIDE - 1) };
    let mut visits = vec![0_u32; (SIDE * SIDE) as usize];
    for corners in mesh {
        (method.run.visit)(*corners, window, &mut |x, y, _| {
            visits[((y - window.min.y) * SIDE + x - window.min.x) as usize] += 1;
        });
    }
    (visits.iter().filter(|&&visits| visits != 1).count() as u32, visits.len() as u32)
}
