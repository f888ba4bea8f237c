//! Half a pixel: what is drawn of a sphere against its true outline, wherever it is.

use std::sync::{Arc, LazyLock};

use checks::apart::from_triangle;
use checks::outline::Ellipse;
use common::{DVec2, DVec3, Method, Vec3};
use fastrand::Rng;
use scene::levels::{Sizes, error, spheres};
use scene::{Levels, METHODS, Shape, sphere};

use crate::stage::{Stage, WHITE};

/// The sizes of a row of `METHODS`.
fn method(name: &str) -> Sizes {
    Method::find(METHODS, name).unwrap().run
}

/// The steps of `by-size`.
static STEPS: LazyLock<Arc<Levels>> = LazyLock::new(|| spheres(method("by-size"), &WHITE));

/// How far the nearest point of all triangles is from the middle, by the triangles' planes; corners in `f64`, or as they are.
fn nearest(shape: &Shape, corner: impl Fn(Vec3) -> DVec3) -> f64 {
    let triangles = shape.triangles.iter();
    let places =
        triangles.map(|triangle| triangle.map(|vertex| corner(shape.vertices[vertex as usize].position)));
    places.map(|triangle| from_triangle(DVec3::ZERO, triangle)).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_error_is_that_of_the_facet_nearest_to_the_middle() {
    let mut sizes =
        vec![[2, 3], [2, 4], [3, 3], [2, 100], [100, 3], [5, 7], [7, 5], [33, 20], [64, 9], [101, 200]];
    sizes.extend(method("by-size"));
    for [latitudes, longitudes] in sizes {
        let shape = sphere(latitudes, longitudes);
        let expected = error(latitudes, longitudes);
        // Rounded to `f32`, a corner is off by 2⁻²⁵ in each direction; made 1 long again, across the sphere alone, which moves a
        // plane by the square of that.
        let [as_is, exact] = [nearest(&shape, Vec3::as_dvec3), nearest(&shape, |p| p.as_dvec3().normalize())]
            .map(|near| 1.0 - near);
        assert!((as_is - expected).abs() < 1.2e-7, "{latitudes}x{longitudes}: {as_is}, not {expected}");
        assert!((exact - expected).abs() < 4e-8, "{latitudes}x{longitudes}: {exact}, not {expected}");
        assert!(shape.vertices.iter().all(|vertex| (vertex.position.as_dvec3().length() - 1.0).abs() < 1e-7));
    }
}

/// Each step has about twice the triangles of the last and half its error, and `METHODS` say of their own how far they go.
#[test]
fn steps_double() {
    let sizes = method("by-size");
    for pair in sizes.windows(2) {
        let [coarse, fine] = [pair[0], pair[1]].map(|[latitudes, longitudes]| {
            ((2 * longitudes * (latitudes - 1)) as f64, error(latitudes, longitudes))
        });
        assert!((1.7..=2.6).contains(&(fine.0 / coarse.0)), "{pair:?}");
        assert!((1.7..=2.4).contains(&(coarse.1 / fine.1)), "{pair:?}");
    }
    for fixed in ["8x16", "32x64", "128x256"] {
        assert!(sizes.contains(&method(fixed)[0]), "{fixed} is one of the steps");
    }
    let radii = [[8, 16], [32, 64], [128, 256]].map(|[a, b]| (0.5 / error(a, b)).floor());
    assert_eq!(radii, [13.0, 207.0, 3320.0]);
}

/// Sizes of pictures, square or not.
const PICTURES: [[u16; 2]; 5] = [[160, 120], [1024, 768], [300, 40], [50, 400], [2000, 2000]];

/// A sphere or an ellipsoid anywhere before a camera, near or far.
fn stage(rng: &mut Rng) -> Stage {
    let mut between = |low: f32, high: f32| low + (high - low) * rng.f32();
    let mut radius = || between(0.2, 3.0);
    let scale = [radius(), radius(), -radius()];
    let degrees = [between(-180.0, 180.0), between(-180.0, 180.0), between(-180.0, 180.0)];
    let [x, y, far, fov] = [between(-0.6, 0.6), between(-0.6, 0.6), between(-0.3, 6.0), between(5.0, 130.0)];
    let scale = if between(0.0, 1.0) < 0.5 { Vec3::splat(scale[0]) } else { scale.into() };
    let size = PICTURES[rng.usize(..PICTURES.len())];
    let half = (fov / 2.0).to_radians().tan();
    // As far as the largest radius and more, at a place of the picture.
    let depth = scale.abs().max_element() * (1.05 + far.exp() / half.min(1.0) * 0.1);
    let aspect = f32::from(size[0]) / f32::from(size[1]);
    let place = Stage::at(x * depth * half * aspect, y * depth * half, -depth);
    Stage { scale, degrees: degrees.into(), ..place.seen(size, fov) }
}

/// Whole outlines, in the picture: as many as asked for.
fn outlines(count: usize, mut visit: impl FnMut(&Stage, &Ellipse)) {
    let mut rng = Rng::with_seed(16);
    let stages = std::iter::repeat_with(|| stage(&mut rng));
    let shown =
        stages.filter_map(|stage| Some((stage, stage.outline().filter(|outline| stage.shows(outline))?)));
    shown.take(count).for_each(|(stage, outline)| visit(&stage, &outline));
}

/// The mesh that is chosen is off by half a pixel at most: not in sum, nor on average. And it is hardly ever much finer than it
/// must be: of the steps, the coarsest that would do, or one or two finer, as the bound is for the sphere's nearest point and for
/// the picture's corner, and its outline is in neither.
#[test]
fn by_size_is_off_by_half_a_pixel_at_most() {
    let mut finer = [0; 12];
    let (mut worst, mut too_near) = (0.0_f64, 0);
    outlines(1500, |stage, outline| {
        let pixels = stage.pixels_per_unit(&STEPS);
        if pixels > 3320.0 {
            too_near += 1;
            return;
        }
        let chosen = STEPS.choose(pixels);
        let off = stage.off(chosen, outline);
        worst = worst.max(off);
        assert!(off <= 0.5, "{off} px by {} triangles: {stage:?}", chosen.triangles());
        let all = STEPS.all();
        let number = |triangles| all.iter().position(|(mesh, _)| mesh.triangles() == triangles).unwrap();
        let needed = all.iter().position(|(mesh, _)| stage.off(mesh, outline) <= 0.5).unwrap();
        finer[number(chosen.triangles()) - needed] += 1;
    });
    assert!(
        worst > 0.4 && too_near < 50,
        "at most {worst} px; {too_near} nearer than the finest step reaches"
    );
    assert!(finer[..3].iter().sum::<i32>() > 1250, "{finer:?}");
}

/// What is fixed is off by as much as it happens to be, and drawn in as many triangles.
#[test]
fn what_is_fixed_is_too_coarse_or_too_fine() {
    let fixed = ["8x16", "32x64", "128x256"].map(|name| spheres(method(name), &WHITE));
    let (mut coarse, mut fine) = ([0_i32; 3], [0_i32; 3]);
    outlines(300, |stage, outline| {
        // Its area in the picture, but for a factor: half of it is for the triangles that are seen.
        let pixels = outline.area() / 2.0;
        for (n, levels) in fixed.iter().enumerate() {
            let mesh = levels.finest();
            coarse[n] += i32::from(stage.off(mesh, outline) > 0.5);
            fine[n] += i32::from(mesh.triangles() as f64 > pixels);
        }
    });
    let near =
        |found: [i32; 3], expected: [i32; 3]| found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 3);
    assert!(near(coarse, [154, 36, 0]), "more than half a pixel off, of 300: {coarse:?}");
    assert!(near(fine, [141, 220, 273]), "more triangles than pixels, of 300: {fine:?}");
}

/// From afar, all that is fixed is worked through for one pixel.
#[test]
fn one_pixel_takes_as_many_triangles_as_the_table_has() {
    let stage = Stage::at(0.5, 0.5, -200.0);
    let drawn = METHODS.iter().map(|method| {
        let (image, counts) = stage.drawn(&spheres(method.run, &WHITE));
        assert_eq!(image.pixels().filter(|(.., color)| color.r > 0).count(), 1);
        let counts = counts.triangles;
        (method.name, counts.vertices, counts.filled + counts.culled + counts.outside)
    });
    let expected =
        [("8x16", 151, 224), ("32x64", 2143, 3968), ("128x256", 33_151, 65_024), ("by-size", 26, 24)];
    assert_eq!(drawn.collect::<Vec<_>>(), expected);
}

/// In pixels: just those centres are covered that are within the outline, but for half a pixel along it; the corners of triangles
/// are rounded to 1/256 px, and so two may be beyond it by less than that.
#[test]
fn no_pixel_is_off_by_more_than_half_of_one() {
    outlines(60, |stage, outline| {
        if stage.size[0] > 400 {
            return;
        }
        let (image, _) = stage.drawn(&STEPS);
        for (x, y, color) in image.pixels() {
            let center = DVec2::new(x.into(), y.into()) + 0.5;
            let covered = color.r > 0;
            if covered != outline.contains(center) {
                let off = outline.distance(center);
                assert!((-0.504..0.004).contains(&off), "({x}, {y}) is {off} px off: {stage:?}");
            }
        }
    });
}
