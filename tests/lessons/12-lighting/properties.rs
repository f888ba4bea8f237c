use std::f64::consts::TAU;

use checks::lamp::{Highlight, Lamp, level};
use clipping::Cull;
use common::{Color, Format, Image, Mat3, Vec2, Vec3};
use fastrand::Rng;
use lighting::normalisation::{Fast, MAGIC};
use lighting::reflection::{Halfway, Mirrored, PointLit};
use lighting::shader::{PerCorner, PerPixel, PerTriangle, draw};
use lighting::surface::{Shape, Smooth, Surface};
use lighting::{Falloff, METHODS, NORMALISATIONS, POWERS, PointLight, Reflected, Scene, blinn_phong, phong};
use proptest::prelude::*;
use shaders::Lit;
use shaders::lighting::{Flat, Gouraud};
use shaders::shader::Shader;
use shaders::source::{Texture, White};
use transforms::rotation::rodrigues;
use verify::method;

use crate::stage::{SIDE, Stage};

type Model = fn(Vec3, Vec3, Vec3, &PointLight) -> Reflected;

const MODELS: [(Model, Highlight); 2] = [(phong, Highlight::Mirrored), (blinn_phong, Highlight::Halfway)];

/// Any number that is not NaN or infinite, each exponent as likely as the next, and 0.
fn finite() -> impl Strategy<Value = f32> {
    prop_oneof![8 => any::<u32>().prop_map(f32::from_bits).prop_filter("finite", |n| n.is_finite()), 1 => Just(0.0)]
}

fn any_point() -> impl Strategy<Value = Vec3> {
    [finite(), finite(), finite()].prop_map(Vec3::from_array)
}

/// A point of a scene.
fn point() -> impl Strategy<Value = Vec3> {
    [-4.0f32..4.0, -4.0f32..4.0, -4.0f32..4.0].prop_map(Vec3::from_array)
}

fn falloff() -> impl Strategy<Value = Falloff> {
    prop_oneof![Just(Falloff::None), Just(Falloff::Linear), Just(Falloff::Quadratic)]
}

fn light(places: impl Strategy<Value = Vec3>, most: f32) -> impl Strategy<Value = PointLight> {
    let share = || prop_oneof![1 => Just(0.0), 4 => 0.0f32..=1.0, 1 => 0.0..=most];
    let shininess = prop_oneof![1 => Just(0.0), 4 => 0.0f32..200.0, 1 => 0.0..=most];
    (places, share(), share(), share(), shininess, falloff()).prop_map(
        |(position, ambient, diffuse, specular, shininess, falloff)| PointLight {
            position,
            ambient,
            diffuse,
            specular,
            shininess,
            falloff,
        },
    )
}

fn exact(light: &PointLight) -> Lamp {
    Lamp {
        position: light.position.as_dvec3(),
        ambient: light.ambient.into(),
        diffuse: light.diffuse.into(),
        specular: light.specular.into(),
        shininess: light.shininess.into(),
        fading: light.falloff as i32,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    /// Whatever finite numbers there are: shares are numbers, not negative, and finite, and black stays black without a
    /// highlight.
    #[test]
    fn nothing_is_nan_and_nothing_negative(point in any_point(), normal in any_point(), eye in any_point(), light in light(any_point(), 1e6)) {
        for (model, _) in MODELS {
            let Reflected { body, highlight } = model(point, normal, eye, &light);
            prop_assert!(body.is_finite() && body >= light.ambient, "{body}");
            prop_assert!(highlight.is_finite() && highlight >= 0.0, "{highlight}");
            let black = Reflected { body, highlight: 0.0 }.color(Color::BLACK);
            prop_assert_eq!(black, Color::BLACK);
        }
    }

    /// Where all is of a scene's size, both models are what `f64` gives: off by rounding, of which an exponent makes as many
    /// times more, and a distance that is small once more.
    #[test]
    fn a_point_is_lit_as_in_f64(point in point(), normal in point(), eye in point(), light in light(point(), 100.0)) {
        let distance = |to: Vec3| (to - point).length();
        prop_assume!(normal.length() > 1e-3 && distance(eye) > 0.1 && distance(light.position) > 0.1);
        for (model, highlight) in MODELS {
            let [body, shine] = exact(&light).on(point.as_dvec3(), normal.as_dvec3(), eye.as_dvec3(), highlight);
            let got = model(point, normal, eye, &light);
            // Where the light just grazes the surface, rounding says whether there is a highlight.
            let [n, l] = [normal, light.position - point].map(|v| v.as_dvec3().normalize());
            prop_assume!(n.dot(l).abs() > 1e-5);
            let fading = (light.position - point).length().powi(-exact(&light).fading).max(1.0);
            let off = (f64::from(got.body) - body).abs();
            prop_assert!(off <= 1e-5 * f64::from(light.ambient + light.diffuse * fading), "{} {body}", got.body);
            let off = (f64::from(got.highlight) - shine).abs();
            // A half-way vector between opposite directions is as long as what rounding left of it.
            let [l, v] = [light.position - point, eye - point].map(Vec3::normalize);
            let half = (l + v).length();
            let bound = 1e-5 * f64::from(light.specular * fading * (1.0 + light.shininess) / half.min(1.0));
            prop_assert!(off <= bound.max(1e-30) || light.shininess < 1.0, "{} {shine}", got.highlight);
        }
    }

    /// Turn all of it, and nothing changes but by rounding.
    #[test]
    fn the_world_may_be_turned(point in point(), normal in point(), eye in point(), light in light(point(), 1.0), axis in point(), angle in 0.0..TAU) {
        let distance = |to: Vec3| (to - point).length();
        prop_assume!(normal.length() > 1e-3 && distance(eye) > 0.1 && distance(light.position) > 0.1 && axis.length() > 0.1);
        let facing = normal.normalize().dot((light.position - point).normalize());
        let half = (light.position - point).normalize() + (eye - point).normalize();
        prop_assume!(facing.abs() > 1e-4 && half.length() > 0.01 && (light.shininess == 0.0 || light.shininess >= 1.0));
        let turn: Mat3 = rodrigues(axis.normalize(), angle as f32);
        for (model, _) in MODELS {
            let here = model(point, normal, eye, &light);
            let turned = PointLight { position: turn * light.position, ..light };
            let there = model(turn * point, turn * normal, turn * eye, &turned);
            let fading = (light.position - point).length().powi(-exact(&light).fading).max(1.0);
            prop_assert!((here.body - there.body).abs() <= 2e-5 * fading, "{here:?} {there:?}");
            let bound = 1e-5 * fading * (1.0 + light.shininess) / half.length().min(1.0);
            prop_assert!((here.highlight - there.highlight).abs() <= bound, "{here:?} {there:?}");
        }
    }

    /// More specular light never makes anything darker; a higher exponent never makes it brighter; and what is linear is.
    #[test]
    fn more_light_is_never_darker(point in point(), normal in point(), eye in point(), light in light(point(), 2.0), more in 0.0f32..2.0) {
        for (model, _) in MODELS {
            let here = model(point, normal, eye, &light);
            let shinier = model(point, normal, eye, &PointLight { specular: light.specular + more, ..light });
            prop_assert!(shinier.highlight >= here.highlight && shinier.body == here.body);
            let smaller = model(point, normal, eye, &PointLight { shininess: light.shininess + more, ..light });
            prop_assert!(smaller.highlight <= here.highlight * 1.000_001 && smaller.body == here.body);
            let brighter = model(point, normal, eye, &PointLight { diffuse: light.diffuse + more, ambient: light.ambient + more, ..light });
            prop_assert!(brighter.body >= here.body && brighter.highlight == here.highlight);
            let base = Color::rgb(200, 100, 0);
            prop_assert!(shinier.color(base) >= here.color(base));
        }
    }

    /// A normal counts by its direction alone.
    #[test]
    fn a_normal_may_have_any_length(point in point(), normal in point(), eye in point(), light in light(point(), 2.0), power in -20i32..20) {
        for (model, _) in MODELS {
            let longer = normal * 2f32.powi(power);
            prop_assert_eq!(model(point, normal, eye, &light), model(point, longer, eye, &light));
        }
    }

    /// A colour is the one that `f64` gives, rounded; alpha is the surface's.
    #[test]
    fn a_colour_is_the_sum_of_its_two_shares(base in any::<[u8; 4]>(), body in 0.0f32..3.0, highlight in 0.0f32..2.0) {
        let [r, g, b, a] = base;
        let color = Reflected { body, highlight }.color(Color { r, g, b, a });
        prop_assert_eq!(color.a, a);
        for (got, base) in [(color.r, r), (color.g, g), (color.b, b)] {
            let exact = level(base.into(), [body.into(), highlight.into()]);
            prop_assert!((f64::from(got) - exact).abs() <= 0.5001, "{got} {exact}");
        }
    }

    /// Powers of cosines are from 0 to 1 and grow with the cosine, but for rounding, whatever the exponent.
    #[test]
    fn powers_stay_in_range_and_in_order(exponent in prop_oneof![0.0f32..100.0, 0.0f32..=1e6], a in 0.0f32..=1.0, b in 0.0f32..=1.0) {
        for row in POWERS {
            let [low, high] = [a.min(b), a.max(b)].map(|x| (row.run.one)(exponent, x));
            prop_assert!((0.0..=1.0).contains(&low) && (0.0..=1.0).contains(&high), "{}: {low} {high}", row.name);
            prop_assert!(low <= high * 1.000_01, "{}: {low} {high}", row.name);
            prop_assert_eq!((row.run.one)(exponent, 1.0), 1.0, "{}", row.name);
        }
    }

    /// The function for one and that for many are the same.
    #[test]
    fn one_by_one_or_all_at_once(exponent in 0.0f32..1000.0, numbers in prop::collection::vec(0.0f32..=1.0, 0..20), vectors in prop::collection::vec(point(), 0..20)) {
        for row in POWERS {
            let mut all = numbers.clone();
            (row.run.all)(exponent, &mut all);
            prop_assert_eq!(all, numbers.iter().map(|&x| (row.run.one)(exponent, x)).collect::<Vec<_>>());
        }
        for row in NORMALISATIONS {
            let mut all = vectors.clone();
            (row.run.all)(&mut all);
            prop_assert_eq!(all, vectors.iter().map(|&v| (row.run.one)(v)).collect::<Vec<_>>());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Where all corners are one as to the light, so are all methods but for the triangle's own normal: with light and eye so
    /// far away that they are in one direction from everywhere, and one normal.
    #[test]
    fn with_one_normal_from_afar_corners_are_as_good_as_pixels(normal in point(), to_light in point()) {
        prop_assume!(normal.z > 0.5 && to_light.length() > 0.5);
        let light = PointLight { position: to_light * 1e6, specular: 0.0, ..PointLight::default() };
        let stage = Stage::wall([normal; 4], light);
        let [corners, pixels] = ["phong-vertex", "phong"].map(|name| stage.drawn(*method(METHODS, name)));
        let differ = corners.pixels().map(|(x, y, color)| color.r.abs_diff(pixels.get(x, y).unwrap().r)).max();
        prop_assert!(differ <= Some(1));
    }

    /// Whatever the light is, each method draws the same pixels, and nothing but grey of a white surface.
    #[test]
    fn every_method_draws_the_same_pixels(light in light(any_point(), 1e6), corners in prop::array::uniform4(point())) {
        let ambient = light.ambient.max(0.01);
        let stage = Stage::wall(corners, PointLight { ambient, ..light });
        for row in METHODS {
            let picture = stage.drawn(row.run);
            let covered = picture.pixels().filter(|pixel| pixel.2 != Color::BLACK).count();
            prop_assert_eq!(covered, 39 * 39, "{}", row.name);
            let grey = picture.pixels().all(|(.., color)| color.r == color.g && color.g == color.b);
            prop_assert!(grey, "{}", row.name);
            let least = (255.0 * ambient).round().min(255.0) as u8;
            prop_assert!(picture.pixels().all(|(.., color)| color.r == 0 || color.r >= least), "{}", row.name);
        }
    }
}

/// Each mantissa of two exponents, all there are: after an even number of halvings it is the same again.
#[test]
fn the_fast_root_is_as_near_as_it_promises() {
    let worst = |root: fn(f32) -> f32| {
        let all = (1f32.to_bits()..4f32.to_bits()).map(f32::from_bits);
        all.map(|x| (f64::from(root(x)) * f64::from(x).sqrt() - 1.0).abs()).fold(0.0, f64::max)
    };
    let found =
        [worst(Fast::<0>::inverse_root), worst(Fast::<1>::inverse_root), worst(Fast::<2>::inverse_root)];
    // C. Lomont (*Fast inverse square root*, 2003) gives 3.44 % and 0.175 % for this constant.
    for (found, promised) in found.into_iter().zip([0.0344, 0.001_753, 4.8e-6]) {
        assert!(found <= promised && found > 0.95 * promised, "{found:e} instead of {promised:e}");
    }
    assert_eq!(MAGIC, 0x5f37_59df);
}

/// The other exponents, and a number that is none.
#[test]
fn the_fast_root_is_one_for_every_normal_number() {
    let mut rng = Rng::with_seed(12);
    for _ in 0..100_000 {
        let x = f32::from_bits(rng.u32(f32::MIN_POSITIVE.to_bits()..f32::INFINITY.to_bits()));
        let error = f64::from(Fast::<2>::inverse_root(x)) * f64::from(x).sqrt() - 1.0;
        assert!(error.abs() < 4.8e-6, "{x:e}: {error:e}");
    }
    assert!(Fast::<2>::inverse_root(0.0).is_finite());
}

/// What is at the point itself has no direction, and what has no normal no side: there is ambient light alone.
#[test]
fn without_a_direction_there_is_ambient_light_alone() {
    let light = PointLight { position: Vec3::new(0.5, 0.25, 0.0), ..PointLight::default() };
    let ambient = Reflected { body: light.ambient, highlight: 0.0 };
    for (model, _) in MODELS {
        assert_eq!(model(light.position, Vec3::Z, Vec3::Z, &light), ambient);
        assert_eq!(model(Vec3::ZERO, Vec3::ZERO, Vec3::Z, &light), ambient);
        let quadratic = PointLight { falloff: Falloff::Quadratic, ..light };
        assert_eq!(model(light.position, Vec3::Z, Vec3::Z, &quadratic), ambient);
        // From the point itself no highlight is seen, but the light is.
        let above = PointLight { position: Vec3::Z, ..light };
        let at_the_eye = model(Vec3::ZERO, Vec3::Z, Vec3::ZERO, &PointLight { specular: 0.0, ..above });
        assert_eq!(at_the_eye.body, light.ambient + light.diffuse);
    }
}

/// From nearer than 10⁻⁶ light is as strong as from there.
#[test]
fn light_fades_with_the_distance_but_is_never_infinite() {
    for (squared, shares) in [
        (4.0, [1.0, 0.5, 0.25]),
        (1.0, [1.0; 3]),
        (0.25, [1.0, 2.0, 4.0]),
        (1e-12, [1.0, 1e6, 1e12]),
        (0.0, [1.0, 1e6, 1e12]),
    ] {
        let got = [Falloff::None, Falloff::Linear, Falloff::Quadratic].map(|falloff| falloff.share(squared));
        assert!(
            got.iter().zip(shares).all(|(got, share)| (got / share - 1.0).abs() < 1e-6),
            "{squared}: {got:?}"
        );
    }
}

/// A scene is charged for what its shader uses: bytes that are interpolated for each pixel.
#[test]
fn a_shader_interpolates_what_it_uses_and_no_more() {
    fn varying<S: Shader>() -> usize {
        size_of::<S::Varying>()
    }
    assert_eq!(varying::<Lit<White, Flat>>(), 0);
    assert_eq!(varying::<Lit<Texture, Gouraud>>(), size_of::<(Vec2, f32)>());
    assert_eq!(varying::<PerTriangle<PointLit<Mirrored>>>(), size_of::<Vec2>());
    assert_eq!(varying::<PerCorner<PointLit<Mirrored>>>(), size_of::<(Vec2, (f32, f32))>());
    assert_eq!(varying::<PerPixel<PointLit<Halfway>>>(), size_of::<(Vec2, (Vec3, Vec3))>());
}

/// Smooth, and half as glossy.
struct Worn;

impl Surface for Worn {
    type Constant = ();
    type Varying = Vec3;

    fn triangle(&self, _: &Scene, _: usize) {}

    fn corner(&self, scene: &Scene, face: usize, corner: usize) -> Vec3 {
        Smooth.corner(scene, face, corner)
    }

    fn at(&self, scene: &Scene, (): (), uv: Vec2, normal: Vec3) -> Shape {
        Shape { gloss: 0.5, ..Smooth.at(scene, (), uv, normal) }
    }
}

/// A surface half as glossy under a light is drawn as a glossy one under a light half as specular.
#[test]
fn gloss_is_a_share_of_the_highlight() {
    let light = PointLight { position: Vec3::new(0.3, 0.2, 2.0), ..PointLight::default() };
    let drawn = |light: PointLight, worn: bool| {
        let stage = Stage::wall([Vec3::Z; 4], light);
        let (scene, mut image) = (stage.scene(), Image::new(SIDE, SIDE, Format::Rgb));
        if worn {
            draw(&PerPixel::<PointLit<Halfway>, _>::new(&scene, Worn), &stage.mesh, Cull::Back, &mut image);
        } else {
            draw(&PerPixel::<PointLit<Halfway>, _>::new(&scene, Smooth), &stage.mesh, Cull::Back, &mut image);
        }
        image
    };
    let half = drawn(PointLight { specular: light.specular / 2.0, ..light }, false);
    assert!(drawn(light, true) == half && drawn(light, false) != half);
}
