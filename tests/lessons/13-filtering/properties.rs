use std::cell::RefCell;

use checks::footprint::{Plane, Texture as Exactly, code, light};
use checks::ray::Screen;
use clipping::assembly::Topology;
use clipping::mesh::Vertex;
use clipping::{Clipping, Cull, Mesh, render};
use common::{Color, DVec2, Format, Image, Model, Vec2, Vec3, Vec4};
use fastrand::Rng;
use filtering::filter::{Filter, Nearest};
use filtering::footprint::{Asked, Axes, Gradients};
use filtering::layout::{Layout, Morton, Rows, Tiles};
use filtering::light::{Codes, ENCODED, SRGB};
use filtering::shader::Filtered;
use filtering::{
    Footprint, LAYOUTS, Level, METHODS, MIPMAPS, Texture, WRAPS, Wrap, bilinear, bilinear_8, level, nearest,
};
use perspective::depth::ZF32;
use perspective::{Framebuffer, perspective};
use proptest::prelude::*;
use shaders::Uniforms;
use shaders::lighting::Lighting;
use verify::method;

use crate::stability::{noise, outside, plain};

/// Any number at all, each exponent as likely as the next, and NaN, and infinite ones.
fn any_number() -> impl Strategy<Value = f32> {
    any::<u32>().prop_map(f32::from_bits)
}

fn any_wrap() -> impl Strategy<Value = Wrap> {
    (0..WRAPS.len()).prop_map(|n| WRAPS[n].run)
}

fn any_color() -> impl Strategy<Value = Color> {
    any::<[u8; 4]>().prop_map(|[r, g, b, a]| Color { r, g, b, a })
}

/// A picture of one colour.
fn constant(width: u16, height: u16, color: Color) -> Image {
    let mut image = Image::new(width, height, Format::Rgba);
    for (x, y, _) in image.clone().pixels() {
        image.set(x, y, color);
    }
    image
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Of one colour there is that colour, wherever and however large a pixel is, by each method, from levels made in each way:
    /// also where (u, v) or the footprint is NaN or infinite.
    #[test]
    fn one_colour_stays_that_colour(
        (width, height, color) in (1_u16..9, 1_u16..9, any_color()), wrap in any_wrap(),
        numbers in proptest::collection::vec(any_number(), 6),
    ) {
        let image = constant(width, height, color);
        let [u, v, xu, xv, yu, yv] = numbers[..] else { unreachable!() };
        let footprint = Footprint { x: Vec2::new(xu, xv), y: Vec2::new(yu, yv) };
        for mipmap in MIPMAPS {
            let texture = mipmap.run.texture(&image, wrap);
            for method in METHODS {
                let got = (method.run.color)(&texture, Vec2::new(u, v), footprint);
                prop_assert_eq!(got, color, "{}, {}", method.name, mipmap.name);
            }
        }
    }

    /// Whatever numbers it is given, no method makes a channel brighter or darker than it is anywhere in the texture.
    #[test]
    fn no_colour_is_made_that_is_not_between_texels(
        (width, height) in (1_u16..9, 1_u16..9), wrap in any_wrap(), numbers in proptest::collection::vec(any_number(), 6),
    ) {
        let image = noise(width, height);
        let [u, v, xu, xv, yu, yv] = numbers[..] else { unreachable!() };
        let footprint = Footprint { x: Vec2::new(xu, xv), y: Vec2::new(yu, yv) };
        let texture = method(MIPMAPS, "box-linear").texture(&image, wrap);
        for method in METHODS {
            let got = (method.run.color)(&texture, Vec2::new(u, v), footprint);
            for channel in [|c: Color| c.r, |c: Color| c.g, |c: Color| c.b] {
                let values = || image.pixels().map(|pixel| channel(pixel.2));
                let (low, high) = (values().min().unwrap(), values().max().unwrap());
                prop_assert!((low..=high).contains(&channel(got)), "{}: {got:?}", method.name);
            }
        }
    }

    /// All levels of one colour are of that colour, each side half as long as before, down to one texel.
    #[test]
    fn all_levels_of_one_colour_are_of_that_colour(
        (width, height, color) in (1_u16..70, 1_u16..70, any_color()), wrap in any_wrap(),
    ) {
        for mipmap in MIPMAPS {
            let levels = mipmap.run.levels(&constant(width, height, color), wrap);
            let (mut w, mut h) = (i32::from(width), i32::from(height));
            for image in &levels {
                prop_assert_eq!((image.width(), image.height()), (w, h));
                prop_assert!(image.pixels().all(|pixel| pixel.2 == color), "{}", mipmap.name);
                (w, h) = ((w / 2).max(1), (h / 2).max(1));
            }
            let last = &levels[levels.len() - 1];
            prop_assert_eq!((last.width(), last.height()), (1, 1));
        }
    }

    /// The mean light of each level is that of the picture, to within the rounding of codes: half a code, which at white is
    /// 1.14 of 255.
    #[test]
    fn levels_keep_the_mean(width in 1_u16..40, height in 1_u16..40) {
        let image = noise(width, height);
        for (name, codes, rounding) in [("box-linear", &SRGB, 1.15), ("box-encoded", &ENCODED, 0.5001)] {
            let mean = |image: &Image| {
                let sum: Vec4 = image.pixels().map(|pixel| codes.light(pixel.2)).sum();
                sum / (image.width() * image.height()) as f32
            };
            let levels = method(MIPMAPS, name).levels(&image, Wrap::Repeat);
            for level in &levels {
                let off = (mean(level) - mean(&image)).abs().max_element();
                prop_assert!(off <= rounding, "{name}, {}x{}: {off}", level.width(), level.height());
            }
        }
    }

    /// Bilinear is what the four texels about (u, v) are, linear between their centres; with weights of 8 bits, off by no
    /// more than 1/512 of their differences in each direction.
    #[test]
    fn bilinear_lies_between_its_four_texels(
        (width, height) in (1_u16..20, 1_u16..20), wrap in any_wrap(), (u, v) in (-4.0_f32..4.0, -4.0_f32..4.0),
    ) {
        let image = noise(width, height);
        let level: Level = Level::new(&image, &SRGB);
        let exactly = Exactly::new(&image, outside(wrap)).at(DVec2::new(u.into(), v.into()));
        let [got, by_8_bits] = [bilinear, bilinear_8].map(|f| f(&level, Vec2::new(u, v), wrap).to_array());
        let around = |u: f32, n: u16| {
            let left = (f64::from(u) * f64::from(n) - 0.5).floor() as i64;
            // Where rounding may bring u past a centre, its neighbours count, too.
            (left - 1..=left + 2).map(move |i| wrap.any_texel(i, n.into()) as i32)
        };
        let light = |(i, j)| level.lights()[(j * level.width() + i) as usize];
        let texels: Vec<Vec4> =
            around(u, width).flat_map(|i| around(v, height).map(move |j| (i, j))).map(light).collect();
        for channel in 0..3 {
            let values = || texels.iter().map(|texel| texel[channel]);
            let (low, high) = (values().fold(f32::MAX, f32::min), values().fold(f32::MIN, f32::max));
            prop_assert!((low - 1e-4..=high + 1e-4).contains(&got[channel]));
            prop_assert!((f64::from(got[channel]) - 255.0 * exactly[channel]).abs() < 0.01);
            let off = (by_8_bits[channel] - got[channel]).abs();
            prop_assert!(off <= (high - low) / 256.0 + 1e-3, "{off} of {}", high - low);
        }
    }

    /// A period on there is the same, to the last bit; and a mirror's other side is what this side is.
    #[test]
    fn wraps_are_periodic((u, v) in (-4000_i32..4000, -4000_i32..4000), (m, n) in (-100_i32..100, -100_i32..100)) {
        let image = noise(11, 6);
        let level: Level = Level::new(&image, &SRGB);
        let at = |u: i32, v: i32| Vec2::new(u as f32, v as f32) / 256.0;
        for wrap in [Wrap::Repeat, Wrap::Mirror] {
            let period = 256 * wrap.period();
            let [here, there] = [at(u, v), at(u + period * m, v + period * n)];
            prop_assert_eq!(bilinear(&level, here, wrap), bilinear(&level, there, wrap));
            prop_assert_eq!(nearest(&level, here, wrap), nearest(&level, there, wrap));
        }
        let [here, behind] = [at(u, v), at(-u, -v)].map(|uv| bilinear(&level, uv, Wrap::Mirror));
        prop_assert!((here - behind).abs().max_element() < 1e-2);
    }

    /// Nearest is lesson 5's lookup, wherever (u, v) are, with what lesson 5 has outside of a texture.
    #[test]
    fn nearest_is_that_of_lesson_5(u in any_number(), v in any_number(), (s, t) in (-3.0_f32..3.0, -3.0_f32..3.0)) {
        let image = noise(7, 5);
        let level: Level = Level::new(&image, &SRGB);
        for uv in [Vec2::new(u, v), Vec2::new(s, t), Vec2::new(s, v)] {
            prop_assert_eq!(nearest(&level, uv, Wrap::Clamp), textures::texel(&image, uv));
            prop_assert_eq!(nearest(&level, uv, Wrap::Repeat), textures::repeat(&image, uv));
        }
    }

    /// Each layout has each texel in a place of its own.
    #[test]
    fn every_layout_keeps_every_texel(width in 1_u16..70, height in 1_u16..70) {
        fn keeps<L: Layout>(image: &Image) -> bool {
            let (width, height) = (image.width() as u32, image.height() as u32);
            let layout = L::new(width, height);
            let places = (0..height).flat_map(|y| (0..width).map(move |x| layout.place(x, y)));
            let mut places: Vec<usize> = places.collect();
            places.sort_unstable();
            places.dedup();
            let level = Level::<L>::new(image, &SRGB);
            places.len() == (width * height) as usize
                && places[places.len() - 1] < layout.texels()
                && image.pixels().all(|(x, y, color)| level.texel(x, y) == color)
        }
        let image = noise(width, height);
        prop_assert!(keeps::<Rows>(&image) && keeps::<Tiles>(&image) && keeps::<Morton>(&image));
        // And no more padding than is told.
        let (w, h) = (u32::from(width), u32::from(height));
        let texels = (w * h) as usize;
        prop_assert_eq!(Rows::new(w, h).texels(), texels);
        prop_assert!(Tiles::new(w, h).texels() <= ((w + 3) * (h + 3)) as usize);
        prop_assert!(Morton::new(w, h).texels() < 4 * texels);
    }

    /// All layouts give the same colours.
    #[test]
    fn a_walk_is_the_same_in_every_layout(
        (width, height) in (1_u16..40, 1_u16..40), numbers in proptest::collection::vec(-2.0_f32..2.0, 6),
    ) {
        let image = noise(width, height);
        let [u, v, xu, xv, yu, yv] = numbers[..] else { unreachable!() };
        let step = Footprint { x: Vec2::new(xu, xv), y: Vec2::new(yu, yv) };
        let walked = LAYOUTS.iter().map(|row| {
            let mut colors = vec![Color::BLACK; 20];
            (row.run.walk)(&image)(Vec2::new(u, v), step, 5, &mut colors);
            colors
        });
        let walked: Vec<Vec<Color>> = walked.collect();
        prop_assert!(walked.iter().all(|colors| *colors == walked[0]));
        let level: Level = Level::new(&image, &SRGB);
        let last = Vec2::new(u, v) + step.x * 4.0 + step.y * 3.0;
        prop_assert_eq!(walked[0][19], SRGB.color(bilinear(&level, last, Wrap::Repeat)));
    }

    /// The level is the logarithm of the longer side in texels, and so continuous; the axes are those of the ellipse.
    #[test]
    fn the_level_is_the_logarithm_of_the_longer_side(
        numbers in proptest::collection::vec(-1.0_f32..1.0, 4), power in -12_i32..12, (width, height) in (1_u16..5000, 1_u16..5000),
    ) {
        let [xu, xv, yu, yv] = [0, 1, 2, 3].map(|n| numbers[n] * 2f32.powi(power));
        let footprint = Footprint { x: Vec2::new(xu, xv), y: Vec2::new(yu, yv) };
        let size = Vec2::new(width.into(), height.into());
        let [x, y] = [footprint.x, footprint.y].map(|side| side.as_dvec2() * size.as_dvec2());
        let longest = x.length().max(y.length());
        prop_assert!((f64::from(level(footprint, size)) - longest.log2()).abs() < 3e-6);

        let Axes { direction, major, minor } = footprint.texels(size).axes();
        // The largest and the smallest radius that the ellipse has in any direction.
        let radius = |angle: f64| (x * angle.cos() + y * angle.sin()).length();
        let turns = (0..720).map(|n| radius(f64::from(n) * std::f64::consts::PI / 720.0));
        let (low, high) = turns.fold((f64::MAX, 0.0_f64), |(low, high), r| (low.min(r), high.max(r)));
        let slack = 1e-2 * high;
        prop_assert!((f64::from(major) - high).abs() < slack && (f64::from(minor) - low).abs() < slack);
        // In its direction it is as long as that: the mean square of the two sides along it.
        let along = direction.as_dvec2();
        prop_assert!((along.length() - 1.0).abs() < 1e-5);
        let squares = along.dot(x).powi(2) + along.dot(y).powi(2);
        prop_assert!((squares.sqrt() - f64::from(major)).abs() < 1e-3 * high);
    }
}

/// Of a picture's mirror image the levels are the mirror images, but for a code where rounding decides.
#[test]
fn levels_of_a_mirror_image_are_mirrored() {
    let mirrored = |image: &Image| {
        let mut mirror = image.clone();
        for (x, y, color) in image.pixels() {
            mirror.set(image.width() - 1 - x, image.height() - 1 - y, color);
        }
        mirror
    };
    for (width, height) in [(48, 48), (47, 33), (7, 5), (1, 40), (2, 2)] {
        let image = noise(width, height);
        for (mipmap, wrap) in MIPMAPS.iter().flat_map(|mipmap| WRAPS.iter().map(move |wrap| (mipmap, wrap))) {
            let [levels, behind] =
                [&image, &mirrored(&image)].map(|image| mipmap.run.levels(image, wrap.run));
            for (level, behind) in levels.iter().zip(&behind) {
                for ((x, y, a), (.., b)) in level.pixels().zip(mirrored(behind).pixels()) {
                    let off = [a.r.abs_diff(b.r), a.g.abs_diff(b.g), a.b.abs_diff(b.b)];
                    let names = [mipmap.name, wrap.name];
                    assert!(off.into_iter().all(|off| off <= 1), "{names:?}, ({x}, {y}): {a:?}, {b:?}");
                }
            }
        }
    }
}

/// Any number of a texel stands for what a row of textures has there, each as the wrap has it.
#[test]
fn any_texel_is_one_of_a_row_of_textures() {
    for n in 1..9_i64 {
        let once = || 0..n;
        let there_and_back: Vec<i64> = once().chain(once().rev()).collect();
        for i in -40..40_i64 {
            let around = |period: &[i64]| period[i.rem_euclid(period.len() as i64) as usize];
            let expected = [i.clamp(0, n - 1), around(&once().collect::<Vec<_>>()), around(&there_and_back)];
            for (wrap, expected) in [Wrap::Clamp, Wrap::Repeat, Wrap::Mirror].into_iter().zip(expected) {
                assert_eq!(wrap.any_texel(i, n), expected, "{wrap:?}: {i} of {n}");
                // Where filters ask for it, the short form says the same.
                if (-1..=n * i64::from(wrap.period())).contains(&i) {
                    assert_eq!(i64::from(wrap.texel(i as i32, n as i32)), expected, "{wrap:?}: {i} of {n}");
                }
            }
        }
    }
}

/// Each bit of x and y has its place, of textures as large as there are.
#[test]
fn mortons_bits_are_in_turn() {
    for (width, height) in [(1 << 16, 1 << 16), (1 << 16, 1 << 9), (1 << 3, 1 << 16)] {
        let layout = Morton::new(width, height);
        let mut next = 0;
        for bit in 0..16 {
            for (x, y) in [(1 << bit, 0), (0, 1 << bit)].into_iter().filter(|&(x, y)| x < width && y < height)
            {
                assert_eq!(layout.place(x, y), 1 << next, "({x}, {y}) of {width}x{height}");
                next += 1;
            }
        }
        assert_eq!(layout.place(width - 1, height - 1) + 1, layout.texels());
    }
}

/// A footprint of no size has axes of none, in some direction.
#[test]
fn what_stands_still_has_no_axes() {
    assert_eq!(Footprint::default().axes(), Axes { direction: Vec2::X, major: 0.0, minor: 0.0 });
    assert_eq!(level(Footprint::default(), Vec2::splat(64.0)), f32::NEG_INFINITY);
}

/// Every code, and lights next to every border between codes.
#[test]
fn codes_are_rounded_as_they_are_seen() {
    let grey = |codes: &Codes, light: f32| codes.color(Vec4::new(light, light, light, 255.0)).r;
    let mut rng = Rng::with_seed(15);
    for n in 0..=255_u8 {
        let color = Color { r: n, g: 255 - n, b: n / 2, a: n };
        for codes in [&SRGB, &ENCODED] {
            assert_eq!(codes.color(codes.light(color)), color);
        }
        assert!((f64::from(SRGB.light(color).x) - 255.0 * light(n.into())).abs() < 1e-5, "{n}");
        assert_eq!(ENCODED.light(color), Vec4::new(n.into(), (255 - n).into(), (n / 2).into(), n.into()));
        let border = 255.0 * light(f64::from(n) + 0.5);
        for off in [1e-6, 1e-3] {
            if n < 255 {
                assert_eq!(grey(&SRGB, (border * (1.0 + off)) as f32), n + 1, "{n}");
                assert_eq!(grey(&ENCODED, n as f32 + 0.5), n + 1, "{n}");
            }
            assert_eq!(grey(&SRGB, (border * (1.0 - off)) as f32), n, "{n}");
        }
        assert_eq!(grey(&ENCODED, (n as f32 + 0.5).next_down()), n);
        // The first f32 that is not below the border has the upper code.
        let above = if f64::from(border as f32) < border { (border as f32).next_up() } else { border as f32 };
        assert_eq!([grey(&SRGB, above), grey(&SRGB, above.next_down())], [n.saturating_add(1), n], "{n}");
    }
    for _ in 0..200_000 {
        let light = 255.0 * rng.f32() * rng.f32() * rng.f32();
        let exact = code(f64::from(light) / 255.0);
        let near_a_border = ((exact - 0.5).fract() - 0.5).abs() > 0.4999;
        assert!(near_a_border || f64::from(grey(&SRGB, light)) == exact.round(), "{light}: {exact}");
    }
    for (light, code) in
        [(-1.0, 0), (f32::NEG_INFINITY, 0), (f32::NAN, 0), (255.1, 255), (1e30, 255), (f32::INFINITY, 255)]
    {
        assert_eq!([grey(&SRGB, light), grey(&ENCODED, light)], [code; 2], "{light}");
    }
}

/// A triangle's corners in eye space and their (u, v), anywhere.
fn triangle(rng: &mut Rng) -> ([Vec3; 3], [Vec2; 3]) {
    let mut number = |reach: f32| (2.0 * rng.f32() - 1.0) * reach;
    let corners = [(); 3].map(|()| Vec3::new(number(6.0), number(6.0), number(8.0) - 4.0));
    (corners, [(); 3].map(|()| Vec2::new(number(9.0), number(9.0))))
}

/// The plane that a triangle and its (u, v) lie in; `None` where these are next to being on a line.
fn plane([a, b, c]: [Vec3; 3], uvs: [Vec2; 3]) -> Option<Plane> {
    let [a, b, c] = [a, b, c].map(Vec3::as_dvec3);
    let [p, q, r] = uvs.map(Vec2::as_dvec2);
    let (du, dv) = (q - p, r - p);
    let area = du.perp_dot(dv);
    // (b − a, c − a) = (U, V)·(du, dv).
    let u = ((b - a) * dv.y - (c - a) * du.y) / area;
    let v = ((c - a) * du.x - (b - a) * dv.x) / area;
    let thick = (b - a).cross(c - a).length() > 1.0 && area.abs() > 1.0;
    thick.then_some(Plane { origin: a - u * p.x - v * p.y, u, v })
}

const SIDE: i32 = 40;

/// By how much a footprint is off as a share of its length, or, where this is small, of a tenth of a texture: (u, v), up
/// to 9 here, are rounded.
fn off(got: Footprint, exact: [DVec2; 2]) -> f64 {
    let length = exact[0].length() + exact[1].length();
    ((got.x.as_dvec2() - exact[0]).length() + (got.y.as_dvec2() - exact[1]).length()) / length.max(0.1)
}

/// Derivatives from the corners are those that rays next to each other show, also where corners are behind the eye.
#[test]
fn footprints_are_what_rays_show() {
    let camera = perspective(70.0, 1.0, 0.1, 100.0).unwrap();
    let screen = Screen::ahead(70.0, DVec2::splat(SIDE.into()));
    let mut rng = Rng::with_seed(16);
    let (mut seen, mut behind) = (0, 0);
    while seen < 30_000 {
        let (corners, uvs) = triangle(&mut rng);
        let Some(plane) = plane(corners, uvs) else { continue };
        let clip = corners.map(|corner| camera * corner.extend(1.0));
        let gradients = Gradients::new(clip, uvs, Vec2::splat(SIDE as f32));
        let (x, y) = (rng.i32(0..SIDE), rng.i32(0..SIDE));
        let Some(uv) = plane.met(screen.through(x, y)) else { continue };
        let depth = -(plane.origin + plane.u * uv.x + plane.v * uv.y).z;
        let center = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        // Not where a ray passes next to the plane's horizon.
        let Some(exact) = plane.moves(&screen, center).filter(|_| depth < 50.0) else { continue };
        let got = gradients.footprint(x, y, uv.as_vec2());
        let off = off(got, exact);
        assert!(off < 1e-4, "{corners:?} {uvs:?} at ({x}, {y}): {got:?}, not {exact:?}: {off}");
        seen += 1;
        behind += u32::from(corners.iter().any(|corner| corner.z > 0.0));
    }
    assert!(behind > 5000, "{behind}");
}

/// Keeps the footprints that it is given.
#[derive(Clone, Copy)]
struct Kept<'a>(&'a RefCell<Vec<(Vec2, Footprint)>>);

impl Filter for Kept<'_> {
    type Footprint = Footprint;

    fn color<L: Layout>(self, _: &Texture<L>, uv: Vec2, footprint: Footprint) -> Color {
        self.0.borrow_mut().push((uv, footprint));
        Color::WHITE
    }
}

/// Full light, and no normals.
#[derive(Clone, Copy)]
struct Bright;

impl Lighting for Bright {
    type Constant = ();
    type Varying = ();

    fn triangle(&self, _: &Uniforms, _: usize) -> Option<()> {
        Some(())
    }

    fn corner(&self, _: &Uniforms, _: usize, _: usize) {}

    fn intensity(&self, (): (), (): ()) -> f32 {
        1.0
    }
}

/// What a drawing of triangles of a model gives to the filter at each pixel, also of triangles that are cut.
#[test]
fn a_filter_is_given_the_footprint_of_its_pixel() {
    let to_clip = perspective(70.0, 1.0, 0.1, 100.0).unwrap();
    let screen = Screen::ahead(70.0, DVec2::splat(SIDE.into()));
    let texture: Texture = Texture::new(&plain(), Wrap::Repeat, &SRGB);
    let mut rng = Rng::with_seed(17);
    let (mut pixels, mut cut) = (0, 0);
    for _ in 0..3000 {
        let (corners, uvs) = triangle(&mut rng);
        let Some(plane) = plane(corners, uvs) else { continue };
        let lines = [0, 1, 2].map(|n: usize| {
            let (Vec3 { x, y, z }, Vec2 { x: u, y: v }) = (corners[n], uvs[n]);
            format!("v {x:?} {y:?} {z:?}\nvt {u:?} {v:?}\n")
        });
        let text = format!("{}f 1/1 2/2 3/3\n", lines.concat());
        let needs = common::Attributes { normals: false, uvs: true };
        let model = Model::parse(text.as_bytes(), needs).unwrap();
        let vertices = [0, 1, 2].map(|n| Vertex { position: n, face: 0, corner: n }).to_vec();
        let mesh = Mesh { vertices, topology: Topology::List, indices: vec![0, 1, 2], faces: vec![0] };
        let kept = RefCell::new(Vec::new());
        let shader = Filtered {
            uniforms: Uniforms { to_clip, ..Uniforms::new(&model) },
            texture: &texture,
            filter: Kept(&kept),
            lighting: Bright,
            size: Vec2::splat(SIDE as f32),
        };
        let mut image = Image::new(SIDE as u16, SIDE as u16, Format::Rgb);
        let counts =
            render(&shader, &mesh, Cull::None, Clipping::GuardBand, &mut Framebuffer::new(&mut image, ZF32));
        for (uv, got) in kept.into_inner() {
            // Which pixel it is, (u, v) tell.
            let point = plane.origin + plane.u * f64::from(uv.x) + plane.v * f64::from(uv.y);
            let place =
                (point.truncate() / -point.z - screen.low) / (screen.high - screen.low) * f64::from(SIDE);
            let center = place.floor() + 0.5;
            assert!((place - center).abs().max_element() < 0.1, "{place} is no centre");
            // Near a horizon the corners, rounded to 1/256 px, move (u, v) by a part of the footprint.
            let far = |at: DVec2| {
                plane.met(screen.direction(at)).map(|uv| (plane.origin + plane.u * uv.x + plane.v * uv.y).z)
            };
            let [Some(here), Some(right), Some(above)] =
                [center, center + DVec2::X, center + DVec2::Y].map(far)
            else {
                continue;
            };
            let Some(exact) = plane
                .moves(&screen, center)
                .filter(|_| (right / here - 1.0).abs().max((above / here - 1.0).abs()) < 0.1)
            else {
                continue;
            };
            let off = off(got, exact);
            assert!(off < 0.02, "{corners:?} {uvs:?} at {place}: {got:?}, not {exact:?}: {off}");
            pixels += 1;
            cut += usize::from(counts.cut > 0);
        }
    }
    assert!(pixels > 100_000 && cut > 20_000, "{pixels}, {cut}");
}

/// Who asks for no footprint keeps nothing of a triangle.
#[test]
fn what_is_not_asked_for_is_not_there() {
    fn kept<F: Filter>(_: F) -> usize {
        size_of::<<F::Footprint as Asked>::Constant>()
    }
    use filtering::filter::{Anisotropic, Bilinear, Bilinear8, Trilinear};
    assert_eq!([kept(Nearest), kept(Bilinear), kept(Bilinear8)], [0; 3]);
    assert_eq!([kept(Trilinear), kept(Anisotropic)], [size_of::<Gradients>(); 2]);
    // And no gradients are computed: they are not even asked for.
    <() as Asked>::triangle(|| panic!("nobody asks for gradients"));
}

/// A texture of an empty picture is black.
#[test]
fn a_picture_without_pixels_is_black() {
    for (width, height) in [(0, 0), (3, 0), (0, 3)] {
        let image = Image::new(width, height, Format::Rgb);
        for mipmap in MIPMAPS {
            let texture = mipmap.run.texture(&image, Wrap::Repeat);
            for method in METHODS {
                let got =
                    (method.run.color)(&texture, Vec2::splat(0.3), Footprint { x: Vec2::X, y: Vec2::Y });
                assert_eq!(got, Color::BLACK, "{}, {}", method.name, mipmap.name);
            }
        }
    }
}
