use blending::blend::BlendStage;
use blending::cutout::{Cutout, FERN, WALL};
use blending::{SPACES, Space};
use checks::cutout::Cutout as Exactly;
use checks::footprint::{code, light};
use common::{Color, DVec2, Format, Image, Vec2};
use fastrand::Rng;
use filtering::{Wrap, bilinear};
use proptest::prelude::*;
use verify::method;
use verify::stability::Must::{AtMost, Between, Exact};
use verify::stability::{Case, every_method};

/// Whether it mixes light, and whether its colours are multiplied by their alpha.
fn kind(name: &str) -> (bool, bool) {
    (name.starts_with("linear"), name.ends_with("premultiplied"))
}

/// What a colour with straight alpha over another gives, from 0 to 255, rounded nowhere.
fn mixed(source: u8, alpha: u8, destination: u8, linear: bool) -> f64 {
    let share = f64::from(alpha) / 255.0;
    let [source, destination] = [source, destination].map(f64::from);
    if linear {
        code(light(source) * share + light(destination) * (1.0 - share))
    } else {
        source * share + destination * (1.0 - share)
    }
}

fn gray(level: u8, a: u8) -> Color {
    Color { r: level, g: level, b: level, a }
}

/// All colours, alphas and destinations: straight colours are mixed as exactly as 8 bits can be. That is what `over` does, where
/// the codes are mixed.
#[test]
fn straight_colours_are_rounded_once() {
    let [encoded, linear] = ["encoded-straight", "linear-straight"].map(|name| *method(SPACES, name));
    for (source, alpha) in (0..=255_u8).flat_map(|source| (0..=255_u8).map(move |alpha| (source, alpha))) {
        assert_eq!(linear.stored(gray(source, alpha)), gray(source, alpha));
        for destination in 0..=255_u8 {
            let (layer, below) = (gray(source, alpha), gray(destination, 255));
            assert_eq!(encoded.color(layer, below), blending::over(layer, below));
            // Of light, every third, and near the ends all: the reference takes a power for each.
            if (u32::from(source) + u32::from(destination) + u32::from(alpha)).is_multiple_of(7) {
                let exact = mixed(source, alpha, destination, true);
                let off = (f64::from(linear.color(layer, below).r) - exact).abs();
                assert!(off <= 0.501, "{source} by {alpha} over {destination}: off by {off}");
            }
        }
    }
}

/// Premultiplied, they are rounded when they are kept, and again when they are mixed.
#[test]
fn premultiplied_colours_are_rounded_twice() {
    for (name, least, most) in [("encoded-premultiplied", 0.9, 1.0), ("linear-premultiplied", 0.9, 1.0)] {
        let (space, mut worst) = (method(SPACES, name), 0.0_f64);
        let linear = kind(name).0;
        let numbers = || (0..=255_u8).step_by(5);
        for (source, alpha) in (0..=255_u8).flat_map(|source| numbers().map(move |alpha| (source, alpha))) {
            let stored = space.stored(gray(source, alpha));
            for destination in numbers() {
                let exact = mixed(source, alpha, destination, linear);
                let got = space.color(stored, gray(destination, 255));
                assert_eq!(got.a, 255);
                worst = worst.max((f64::from(got.r) - exact).abs());
            }
        }
        assert!((least..=most).contains(&worst), "{name}: {worst}");
    }
}

/// Alphas of 0 and 255 change nothing wrong, in any space and over any alpha.
#[test]
fn the_ends_of_alpha_are_exact() {
    let mut rng = Rng::with_seed(1);
    for row in SPACES {
        for _ in 0..100_000 {
            let [source, destination] =
                [(); 2].map(|()| Color { r: rng.u8(..), g: rng.u8(..), b: rng.u8(..), a: rng.u8(..) });
            let nothing = row.run.stored(Color { a: 0, ..source });
            assert_eq!(row.run.color(nothing, destination), destination, "{}", row.name);
            let whole = row.run.stored(Color { a: 255, ..source });
            assert_eq!(row.run.color(whole, destination), whole, "{}", row.name);
            assert_eq!(whole, Color { a: 255, ..source }, "{}", row.name);
        }
    }
}

/// By hand: half of red over green.
#[test]
fn red_over_green() {
    let red = Color { a: 128, ..Color::RED };
    let seen = SPACES.iter().map(|row| row.run.color(row.run.stored(red), Color::GREEN));
    let [dark, bright] = [Color::rgb(128, 127, 0), Color::rgb(188, 187, 0)];
    assert_eq!(seen.collect::<Vec<_>>(), [dark, dark, bright, bright]);
}

/// A premultiplied colour may add light and hide nothing; straight, an alpha of 0 hides all of itself.
#[test]
fn a_premultiplied_colour_may_glow() {
    let glow = Color { r: 100, g: 50, b: 0, a: 0 };
    let over = |name| method(SPACES, name).color(glow, Color::rgb(10, 20, 30));
    assert_eq!(over("encoded-premultiplied"), Color::rgb(110, 70, 30));
    assert_eq!([over("encoded-straight"), over("linear-straight")], [Color::rgb(10, 20, 30); 2]);
}

/// A cut-out, drawn so many times larger, about a point of it, over a colour.
struct Shown {
    picture: fn() -> Image,
    scale: f32,
    middle: Vec2,
    below: Color,
}

fn shown(picture: fn() -> Image, scale: f32, below: Color) -> Shown {
    Shown { picture, scale, middle: Vec2::splat(0.5), below }
}

/// As large as pictures are drawn here.
const SIZE: [u16; 2] = [61, 47];

/// The point (u, v) at a pixel's centre.
fn uv(shown: &Shown, texels: Vec2, x: i32, y: i32) -> DVec2 {
    let [width, height] = SIZE.map(f64::from);
    let from_middle = DVec2::new(f64::from(x) + 0.5 - width / 2.0, f64::from(y) + 0.5 - height / 2.0);
    shown.middle.as_dvec2() + from_middle / (f64::from(shown.scale) * texels.as_dvec2())
}

/// A space's picture, and what it should be: of light, with colours multiplied by alpha; or whatever `kind` says.
fn compared(space: &Space, shown: &Shown, (linear, premultiplied): (bool, bool)) -> Vec<(Color, [f64; 3])> {
    let mut cutout = Cutout::read(FERN).unwrap();
    cutout.picture = (shown.picture)();
    let mut image = Image::new(SIZE[0], SIZE[1], Format::Rgb);
    for (x, y, _) in image.clone().pixels() {
        image.set(x, y, shown.below);
    }
    cutout.draw(space, shown.scale, shown.middle, &mut image);
    let exactly = Exactly::new(&cutout.picture, linear, premultiplied);
    let inside = |uv: DVec2| uv.min_element() > 1e-3 && uv.max_element() < 1.0 - 1e-3;
    let pixels = image.pixels().map(|(x, y, got)| (got, uv(shown, cutout.picture.size(), x, y)));
    pixels.filter(|(_, uv)| inside(*uv)).map(|(got, uv)| (got, exactly.over(uv, shown.below))).collect()
}

/// By how many grey levels a channel is off in the mean, beyond half a level, which rounding takes, and a little for f32.
fn off(compared: &[(Color, [f64; 3])]) -> f64 {
    let mut sum = 0.0;
    for (got, exact) in compared {
        for (got, exact) in [got.r, got.g, got.b].into_iter().zip(exact) {
            sum += ((f64::from(got) - exact).abs() - 0.51).max(0.0);
        }
    }
    assert!(compared.len() > 400, "{} pixels", compared.len());
    sum / (3 * compared.len()) as f64
}

fn picture(width: u16, height: u16, color: impl Fn(i32, i32) -> Color) -> Image {
    let mut image = Image::new(width, height, Format::Rgba);
    for (x, y, _) in image.clone().pixels() {
        image.set(x, y, color(x, y));
    }
    image
}

const LEAF: Color = Color::rgb(110, 190, 40);
/// What files have where nothing is.
const NOTHING: Color = Color { r: 0, g: 0, b: 0, a: 0 };

/// A leaf on the left, nothing on the right.
fn edge() -> Image {
    picture(16, 16, |x, _| if x < 8 { LEAF } else { NOTHING })
}

fn noise(alphas: fn(&mut Rng) -> u8) -> Image {
    let rng = std::cell::RefCell::new(Rng::with_seed(2));
    picture(16, 16, |_, _| {
        let mut rng = rng.borrow_mut();
        Color { r: rng.u8(..), g: rng.u8(..), b: rng.u8(..), a: alphas(&mut rng) }
    })
}

fn fern() -> Image {
    Image::read(FERN[1].as_ref()).unwrap()
}

/// Cut-outs, and by how many grey levels each space is off what a filter of light shows, alpha counted.
const CUTOUTS: &[Case<fn() -> Shown>] = &[
    (
        "one colour, opaque",
        || shown(|| picture(9, 5, |_, _| LEAF), 9.3, WALL),
        &[("encoded-straight, encoded-premultiplied, linear-straight, linear-premultiplied", Exact)],
    ),
    (
        "nothing at all",
        || shown(|| picture(9, 5, |_, _| NOTHING), 9.3, WALL),
        &[("encoded-straight, encoded-premultiplied, linear-straight, linear-premultiplied", Exact)],
    ),
    (
        "nothing, that has a colour",
        || shown(|| picture(9, 5, |_, _| Color { a: 0, ..LEAF }), 9.3, WALL),
        &[("encoded-straight, encoded-premultiplied, linear-straight, linear-premultiplied", Exact)],
    ),
    (
        "one colour, half transparent",
        || shown(|| picture(9, 5, |_, _| Color { a: 128, ..LEAF }), 9.3, WALL),
        &[
            ("linear-straight, linear-premultiplied", Exact),
            ("encoded-straight, encoded-premultiplied", Between(15.7, 16.4)),
        ],
    ),
    (
        "one colour, half transparent, over itself",
        || shown(|| picture(9, 5, |_, _| Color { a: 128, ..LEAF }), 9.3, LEAF),
        &[("encoded-straight, encoded-premultiplied, linear-straight, linear-premultiplied", Exact)],
    ),
    (
        "one dark colour, nearly transparent, over black",
        || shown(|| picture(9, 5, |_, _| Color { r: 90, g: 60, b: 30, a: 3 }), 9.3, Color::BLACK),
        &[
            ("linear-straight, linear-premultiplied", Exact),
            ("encoded-straight, encoded-premultiplied", Between(0.88, 0.916)),
        ],
    ),
    (
        "noise, opaque",
        || shown(|| noise(|_| 255), 6.0, WALL),
        &[
            ("linear-straight, linear-premultiplied", Exact),
            ("encoded-straight, encoded-premultiplied", Between(12.7, 13.2)),
        ],
    ),
    (
        "noise with any alpha",
        || shown(|| noise(|rng| rng.u8(..)), 6.0, WALL),
        &[
            ("encoded-straight", Between(15.9, 16.5)),
            ("encoded-premultiplied", Between(14.5, 15.1)),
            ("linear-straight", Between(3.05, 3.18)),
            ("linear-premultiplied", AtMost(0.05)),
        ],
    ),
    (
        "noise, there or not",
        || shown(|| noise(|rng| 255 * rng.u8(0..2)), 6.0, WALL),
        &[
            ("encoded-straight", Between(12.9, 13.4)),
            ("encoded-premultiplied", Between(12.6, 13.1)),
            ("linear-straight", Between(5.47, 5.7)),
            ("linear-premultiplied", AtMost(0.05)),
        ],
    ),
    (
        "an edge over a bright wall",
        || shown(edge, 8.0, WALL),
        &[
            ("encoded-straight", Between(3.83, 3.98)),
            ("encoded-premultiplied", Between(1.44, 1.5)),
            ("linear-straight", Between(0.723, 0.752)),
            ("linear-premultiplied", AtMost(0.05)),
        ],
    ),
    (
        "an edge over black",
        || shown(edge, 8.0, Color::BLACK),
        &[
            ("linear-premultiplied", Exact),
            ("encoded-straight", Between(4.7, 4.9)),
            ("encoded-premultiplied", Between(2.32, 2.41)),
            ("linear-straight", Between(2.35, 2.44)),
        ],
    ),
    (
        "an edge over its own colour",
        || shown(edge, 8.0, LEAF),
        &[
            ("linear-premultiplied", Exact),
            ("encoded-straight", Between(2.33, 2.43)),
            ("encoded-premultiplied", AtMost(0.05)),
            ("linear-straight", Between(1.14, 1.19)),
        ],
    ),
    (
        "an edge, its colour carried on where nothing is",
        || shown(|| picture(16, 16, |x, _| Color { a: if x < 8 { 255 } else { 0 }, ..LEAF }), 8.0, WALL),
        &[
            ("encoded-straight", Between(1.45, 1.51)),
            ("encoded-premultiplied", Between(1.44, 1.5)),
            ("linear-straight", AtMost(0.05)),
            ("linear-premultiplied", AtMost(0.05)),
        ],
    ),
    (
        "an edge, each texel a pixel",
        || shown(|| picture(61, 47, |x, y| if x * 2 < y + 30 { LEAF } else { NOTHING }), 1.0, WALL),
        &[("encoded-straight, encoded-premultiplied, linear-straight, linear-premultiplied", Exact)],
    ),
    (
        "one texel",
        || shown(|| picture(1, 1, |_, _| Color { a: 77, ..LEAF }), 50.0, WALL),
        &[
            ("linear-straight, linear-premultiplied", Exact),
            ("encoded-straight, encoded-premultiplied", Between(10.7, 11.1)),
        ],
    ),
    (
        "two texels, one of them there",
        || shown(|| picture(2, 1, |x, _| if x == 0 { LEAF } else { NOTHING }), 40.0, WALL),
        &[
            ("encoded-straight", Between(19.5, 20.3)),
            ("encoded-premultiplied", Between(7.39, 7.7)),
            ("linear-straight", Between(3.64, 3.79)),
            ("linear-premultiplied", AtMost(0.05)),
        ],
    ),
    (
        "the frond over a bright wall",
        || Shown { middle: Vec2::new(0.72, 0.62), ..shown(fern, 5.0, WALL) },
        &[
            ("encoded-straight", Between(5.89, 6.13)),
            ("encoded-premultiplied", Between(4.84, 5.04)),
            ("linear-straight", Between(0.271, 0.282)),
            ("linear-premultiplied", AtMost(0.05)),
        ],
    ),
    (
        "the frond over black",
        || Shown { middle: Vec2::new(0.72, 0.62), ..shown(fern, 5.0, Color::BLACK) },
        &[
            ("encoded-straight", Between(10.2, 10.6)),
            ("encoded-premultiplied", Between(9.13, 9.5)),
            ("linear-straight", Between(2.25, 2.35)),
            ("linear-premultiplied", AtMost(0.05)),
        ],
    ),
    (
        "the frond as large as it is, off the texels' centres",
        || Shown { middle: Vec2::new(0.501, 0.502), ..shown(fern, 1.0, WALL) },
        &[
            ("encoded-straight", Between(4.84, 5.03)),
            ("encoded-premultiplied", Between(4.46, 4.65)),
            ("linear-straight", Between(0.139, 0.144)),
            ("linear-premultiplied", AtMost(0.05)),
        ],
    ),
];

#[test]
fn stability() {
    every_method("spaces", SPACES, CUTOUTS, |row, shown| off(&compared(&row.run, &shown(), (true, true))));
}

/// Each space does what it says: its own mean of its own numbers, and its picture is off by no more than rounding takes, once
/// for straight colours; premultiplied they are rounded when they are kept, and all when they are filtered.
#[test]
fn each_space_is_what_it_says() {
    for row in SPACES {
        let kind = kind(row.name);
        for (name, input, _) in CUTOUTS {
            let compared = compared(&row.run, &input(), kind);
            let off = compared.iter().flat_map(|(got, exact)| {
                [got.r, got.g, got.b]
                    .into_iter()
                    .zip(exact)
                    .map(|(got, exact)| (f64::from(got) - exact).abs())
            });
            let worst = off.fold(0.0, f64::max);
            assert!(worst <= 2.01, "{}, {name}: {worst}", row.name);
        }
    }
}

/// Where a straight cut-out is filtered, its border is darker than both the leaf and the wall; premultiplied it is not.
#[test]
fn only_straight_colours_have_a_fringe() {
    for row in SPACES {
        let seen = compared(&row.run, &shown(edge, 8.0, WALL), (true, true));
        let darkest = seen.iter().map(|(got, _)| got.g).min().unwrap();
        assert_eq!(darkest < LEAF.g - 2, !kind(row.name).1, "{}: {darkest}", row.name);
        let seen = compared(&row.run, &shown(edge, 8.0, LEAF), (true, true));
        let flat = seen.iter().all(|(got, _)| checks::picture::distance(*got, LEAF) <= 1);
        assert_eq!(flat, kind(row.name).1, "{}", row.name);
    }
}

proptest! {
    /// A texture of a space has its colours as the space keeps them, and a filter between four that are alike finds just that.
    #[test]
    fn a_texture_keeps_what_is_stored(texel in any::<[u8; 4]>(), u in -1.0f32..2.0, v in -1.0f32..2.0) {
        let [r, g, b, a] = texel;
        let color = Color { r, g, b, a };
        for row in SPACES {
            let texture = row.run.texture(&picture(3, 2, |_, _| color), Wrap::Repeat);
            let found = bilinear(texture.base(), Vec2::new(u, v), Wrap::Repeat);
            prop_assert_eq!(row.run.codes.color(found), row.run.stored(color), "{}", row.name);
        }
    }

    /// Nothing is brighter than the brighter of the two, nor darker than the darker one.
    #[test]
    fn a_layer_lies_between(source in any::<u8>(), alpha in any::<u8>(), destination in any::<u8>()) {
        for row in SPACES {
            let got = row.run.color(row.run.stored(gray(source, alpha)), gray(destination, 255)).r;
            // A premultiplied one may be off by one, as it is rounded twice.
            let slack = u8::from(kind(row.name).1);
            let (low, high) = (source.min(destination), source.max(destination));
            let range = low.saturating_sub(slack)..=high.saturating_add(slack);
            prop_assert!(range.contains(&got), "{}: {got}, not {range:?}", row.name);
        }
    }
}
