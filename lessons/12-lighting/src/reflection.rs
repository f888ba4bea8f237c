//! Models of how a surface reflects a point light, by B. T. Phong (*Illumination for computer generated pictures*,
//! Communications of the ACM 18, 1975) and by J. F. Blinn (*Models of light reflection for computer synthesized pictures*,
//! SIGGRAPH 1977).
//!
//! At a point of a surface there are four unit vectors: its normal *n*, *l* to the light, *v* to the eye, and *r*, which is
//! *l* mirrored at the normal, 2(n·l)n − l. A rough surface sends what falls on it in all directions alike, which is the more
//! the straighter the light falls: D·max(0, n·l), Lambert's law. A smooth one sends some of it along *r*. **Phong** asks how
//! near the eye is to *r*, by the cosine r·v; **Blinn** how near the normal is to the direction half-way between light and
//! eye, h = (l + v)/|l + v|, in which a mirror's normal would have to point, by n·h. An exponent makes the highlight small.
//!
//! The two are alike with about four times the exponent for Blinn's, but only where light and eye are nearly in one
//! direction. Where they are an angle φ apart, n·h falls off across their plane as if the exponent were less by cos² φ/2: the
//! highlight is longer than wide, as measured surfaces have it (A. Ngan, F. Durand and W. Matusik, *Experimental analysis of
//! BRDF models*, Eurographics Symposium on Rendering 2005).

use std::marker::PhantomData;

use common::Vec3;

use crate::light::{PointLight, Reflected};
use crate::normalisation::{Exact, Normalisation};
use crate::power::{Power, Powf};

/// A model of reflection under a light, which it is made for.
pub trait Reflection {
    /// For this light: what is the same at all points is computed here.
    fn new(light: &PointLight) -> Self;

    /// What is reflected to the eye at a point with this normal, which need not be 1 long. All are in the world.
    fn reflect(&self, point: Vec3, normal: Vec3, eye: Vec3) -> Reflected;
}

/// What a highlight is brightest by: the cosine of an angle that is 0 where a mirror would show the light.
pub trait Highlight: Copy {
    /// From the unit vectors n, l and v, and n·l. What is less than `least`, from 0 to 1, may come out as 0.
    fn cosine<N: Normalisation>(normal: Vec3, to_light: Vec3, to_eye: Vec3, n_dot_l: f32, least: f32) -> f32;
}

/// Phong's r·v.
#[derive(Clone, Copy, Debug)]
pub struct Mirrored;

/// Blinn's n·h.
#[derive(Clone, Copy, Debug)]
pub struct Halfway;

// ANCHOR: cosines
impl Highlight for Mirrored {
    #[inline]
    fn cosine<N: Normalisation>(normal: Vec3, to_light: Vec3, to_eye: Vec3, n_dot_l: f32, _: f32) -> f32 {
        (2.0 * n_dot_l * normal - to_light).dot(to_eye)
    }
}

impl Highlight for Halfway {
    #[inline]
    fn cosine<N: Normalisation>(normal: Vec3, to_light: Vec3, to_eye: Vec3, _: f32, least: f32) -> f32 {
        let between = to_light + to_eye;
        // Squares tell without a root what is far from the highlight. A tenth is more than any way to make vectors 1 long
        // is wrong by.
        let along = normal.dot(between).max(0.0);
        if along * along < 0.9 * least * least * between.length_squared() {
            return 0.0;
        }
        normal.dot(N::direction(between))
    }
}
// ANCHOR_END: cosines

/// A point light on a surface: ambient, diffuse and specular, with one of the two highlights, one way to make vectors 1 long
/// and one way to compute powers.
#[derive(Clone, Copy, Debug)]
pub struct PointLit<H, N = Exact, P = Powf> {
    light: PointLight,
    power: P,
    ways: PhantomData<(H, N)>,
}

// ANCHOR: reflect
impl<H: Highlight, N: Normalisation, P: Power> Reflection for PointLit<H, N, P> {
    fn new(light: &PointLight) -> Self {
        Self { light: *light, power: P::new(light.shininess), ways: PhantomData }
    }

    #[inline]
    fn reflect(&self, point: Vec3, normal: Vec3, eye: Vec3) -> Reflected {
        self.reflect_to(point, N::normal(normal), || N::direction(eye - point))
    }
}

impl<H: Highlight, N: Normalisation, P: Power> PointLit<H, N, P> {
    /// The same from the unit vectors n and v, which several lights have in common; v is asked for where there is light.
    #[inline]
    pub fn reflect_to(&self, point: Vec3, n: Vec3, v: impl FnOnce() -> Vec3) -> Reflected {
        let PointLight { position, ambient, diffuse, specular, falloff, .. } = self.light;
        let to_light = position - point;
        let l = N::direction(to_light);
        let n_dot_l = n.dot(l);
        if n_dot_l <= 0.0 {
            return Reflected { body: ambient, highlight: 0.0 };
        }
        let arriving = falloff.share(to_light.length_squared());
        let body = ambient + diffuse * arriving * n_dot_l;
        if specular == 0.0 {
            return Reflected { body, highlight: 0.0 };
        }
        // Rounding may bring a cosine above 1, which the power would make much of.
        let cosine = H::cosine::<N>(n, l, v(), n_dot_l, self.power.least()).clamp(0.0, 1.0);
        Reflected { body, highlight: specular * arriving * self.power.of(cosine) }
    }
}
// ANCHOR_END: reflect

/// What is reflected of a light to the eye by Phong's model, at a point of a surface with this normal. All are in the world;
/// the normal need not be 1 long.
///
/// On the dark side, n·l ≤ 0, there is ambient light alone; so it is where a direction is missing: where the light is at the
/// point itself, and where the normal is 0. A direction counts as missing where it is shorter than 10⁻¹⁹ or longer than
/// 10¹⁹; an eye at the point itself sees no highlight.
#[must_use]
pub fn phong(point: Vec3, normal: Vec3, eye: Vec3, light: &PointLight) -> Reflected {
    PointLit::<Mirrored>::new(light).reflect(point, normal, eye)
}

/// As [`phong`], by Blinn's highlight.
#[must_use]
pub fn blinn_phong(point: Vec3, normal: Vec3, eye: Vec3, light: &PointLight) -> Reflected {
    PointLit::<Halfway>::new(light).reflect(point, normal, eye)
}
