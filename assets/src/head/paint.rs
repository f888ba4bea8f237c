//! The head's colours, painted texel by texel at the point of the surface that the texel shows.
//!
//! Colours are encoded (sRGB) shares of full brightness. Shadow that light from every side would leave, in
//! sockets, nostrils and ears, is painted in: the field says how open a point is.

use common::{Color, Format, Image};
use glam::DVec3;

use super::atlas::eye_texels;
use super::noise::{bump, noise};
use super::shape::{
    BROW, EYE, EYE_HALF, MOUTH, MOUTH_HALF, NOSE_BASE, above_hairline, body, ear, eye_opening, lips,
    lower_lid, mouth, mouth_line, nostril, step, upper_lid,
};
use super::texels::{Sheet, Texel, Texels};

/// A colour by its hexadecimal digits.
const fn hex(rgb: u32) -> DVec3 {
    DVec3::new(
        ((rgb >> 16) & 255) as f64 / 255.0,
        ((rgb >> 8) & 255) as f64 / 255.0,
        (rgb & 255) as f64 / 255.0,
    )
}

const SKIN: DVec3 = hex(0xd9ab8c);
const SKIN_WARM: DVec3 = hex(0xd39a78);
const SKIN_COOL: DVec3 = hex(0xcba894);
const BLUSH: DVec3 = hex(0xc77b66);
const STUBBLE: DVec3 = hex(0x8f7a6e);
const FRECKLE: DVec3 = hex(0xb5805f);
const LIP: DVec3 = hex(0xb5665c);
const LIP_DARK: DVec3 = hex(0x7c3a36);
const HAIR: DVec3 = hex(0x3a281d);
const HAIR_LIGHT: DVec3 = hex(0x6b4b33);
const HOLLOW: DVec3 = hex(0x3a1512);
const SHADOW: DVec3 = hex(0x8a6152);

/// Paints the texture: the bust, an eye, and what a coarser bust shows beyond the patches of this one.
#[must_use]
pub fn paint(bust: &Texels, coarse: &Texels) -> Image {
    let mut texture = Sheet::new(Format::Rgb);
    // The point on the triangle is brought onto the surface under it.
    let paint = |Texel { position: p, normal, .. }| color(skin(p - normal * body(p), normal));
    bust.iter().for_each(|(x, y, texel)| texture.set(x, y, paint(texel)));
    // Around a patch, where rounding may fetch a texel, it repeats itself.
    texture.grow(4);
    eye_texels().for_each(|(x, y, q)| texture.set(x, y, color(eye(q))));
    coarse.iter().for_each(|(x, y, texel)| texture.set_unknown(x, y, || paint(texel)));
    texture.padded()
}

/// The colour of a point of the bust.
fn skin(p: DVec3, normal: DVec3) -> DVec3 {
    let side = DVec3::new(p.x.abs(), p.y, p.z);
    // Skin: warm and cool areas, pores, freckles.
    let mut c = SKIN
        .lerp(SKIN_WARM, 0.8 * noise(p * 6.0))
        .lerp(SKIN_COOL, 0.6 * step(noise(p * 4.0 + 9.0) * 2.0 - 0.8));
    c *= 0.955 + 0.09 * noise(p * 90.0);
    let blot = |center: DVec3, size: f64| bump(side.distance(center) / size);
    let freckles = blot(DVec3::new(0.12, -0.07, 0.34), 0.16);
    c = c.lerp(FRECKLE, 0.5 * freckles * step((noise(p * 115.0) - 0.68) * 7.0));
    // Blood under thin skin.
    let redness = 0.5 * blot(DVec3::new(0.165, -0.12, 0.3), 0.13)
        + 0.4 * blot(DVec3::new(0.0, -0.14, 0.51), 0.075)
        + 0.2 * blot(DVec3::new(0.0, -0.44, 0.4), 0.08)
        + 0.32 * blot(DVec3::new(0.36, -0.04, -0.05), 0.17);
    c = c.lerp(BLUSH, redness * (0.75 + 0.4 * noise(p * 12.0)));
    // Thin, bluish skin around the eyes.
    c = c.lerp(hex(0xb08a80), 0.45 * blot(EYE + DVec3::new(-0.01, -0.03, 0.04), 0.075));
    c = c.lerp(STUBBLE, 0.42 * beard(side, p));
    c = paint_lips(c, side, p);
    c = paint_lids(c, side);
    if let Some((dense, hair)) = brow(side, p) {
        c = c.lerp(HAIR, dense * (0.7 + 0.3 * hair));
    }
    if let Some(Strands { cover, strand, fine }) = hair(side, p) {
        let tone = HAIR.lerp(HAIR_LIGHT, (0.65 * strand + 0.5 * fine - 0.15).clamp(0.0, 1.0));
        c = c.lerp(tone, cover);
    }
    let closed = occlusion(p, normal);
    c *= DVec3::ONE.lerp(SHADOW, closed);
    let hollow = step((0.005 - mouth(side)) / 0.004).max(step((0.005 - nostril(side)) / 0.006));
    c.lerp(HOLLOW, 0.9 * hollow)
}

/// Where the beard grows, less in some places than in others: speckles on a shade.
pub(super) fn beard(side: DVec3, p: DVec3) -> f64 {
    let edge = 0.03 * (noise(p * 14.0) - 0.5);
    // Below a line from the sideburn over the cheek to the nose, above the throat.
    let cheek = -0.12 - 0.55 * (0.3 - side.x).max(0.0) + 0.25 * (side.z - 0.2).max(0.0);
    let below = step((cheek - side.y + edge) / 0.07);
    let moustache = step((NOSE_BASE - 0.01 - side.y) / 0.03) * step((0.13 - side.x) / 0.03);
    let above = step((side.y + 0.62 + edge) / 0.1) * step((side.z + 0.02) / 0.08);
    below.max(moustache) * above * (0.7 + 0.5 * step(noise(p * 190.0) * 1.6 - 0.5))
}

/// How much a point belongs to the lips, and how high it lies between their creases; both from 0 to 1.
pub(super) fn lip(side: DVec3, p: DVec3) -> Option<(f64, f64)> {
    let t = side.x / MOUTH_HALF;
    if side.z < 0.3 || t > 1.1 || (side.y - MOUTH).abs() > 0.1 {
        return None;
    }
    let on_lips = step((0.0055 - lips(side)) / 0.004) * step((0.96 - t) / 0.25);
    Some((on_lips, noise(DVec3::new(p.x * 170.0, p.y * 20.0, 0.0))))
}

/// The red of the lips, darker towards the line between them.
fn paint_lips(c: DVec3, side: DVec3, p: DVec3) -> DVec3 {
    let Some((on_lips, creases)) = lip(side, p) else { return c };
    let t = side.x / MOUTH_HALF;
    let c = c.lerp(LIP * (0.9 + 0.2 * creases), 0.85 * on_lips);
    let line = bump((side.y - mouth_line(side.x)) / 0.009) * step((1.0 - t) / 0.3);
    c.lerp(LIP_DARK, 0.85 * line)
}

/// The lids' edges: lashes on the upper one, a moist rim below, the pink corner inside.
fn paint_lids(c: DVec3, side: DVec3) -> DVec3 {
    let q = side - EYE;
    let u = q.x / EYE_HALF;
    if q.z < 0.0 || u.abs() > 1.5 || q.y.abs() > 0.08 {
        return c;
    }
    let opening = eye_opening(q);
    let upper = step((q.y - (upper_lid(u) + lower_lid(u)) / 2.0) / 0.004 + 0.5);
    let inside = step(-opening / 0.004);
    // Behind the opening: the corner inside is pink, the rest almost as white as the eye.
    let c = c.lerp(hex(0xd8c2b6).lerp(hex(0xb9746a), step((-0.65 - u) / 0.2)), 0.85 * inside);
    let near = |width: f64| bump(opening.abs() / width);
    let lashes = near(0.0075) * upper * step((u + 1.05) / 0.4) * step((1.1 - u) / 0.25);
    let rim = near(0.004) * (1.0 - upper) * step((u + 0.8) / 0.3) * step((0.9 - u) / 0.3);
    c.lerp(hex(0x2a1a14), 0.9 * lashes).lerp(hex(0x6e4238), 0.55 * rim)
}

/// A brow, of short hairs that lie outwards: how dense it is at a point, and how high the hairs are there; from 0 to 1.
pub(super) fn brow(side: DVec3, p: DVec3) -> Option<(f64, f64)> {
    let t = (side.x - 0.045) / 0.195;
    if side.z < 0.1 || !(-0.2..1.2).contains(&t) {
        return None;
    }
    let middle = BROW - 0.012 + 0.075 * t - 0.085 * t * t;
    let half = 0.019 * (1.0 - 0.62 * t.max(0.0));
    let (along, across) = (side.x, side.y - middle);
    // Hairs grow outwards, and upwards near the nose.
    let lean = across - along * (0.9 - 0.8 * t);
    let hair = noise(DVec3::new(lean * 260.0, along * 24.0, p.x.signum() * 5.0));
    let edge = across.abs() / half + 0.7 * (hair - 0.5);
    let dense = step((1.15 - edge) / 0.6) * step((t + 0.06) / 0.15) * step((1.03 - t) / 0.2);
    Some((dense, hair))
}

/// The hair of the head at a point; all from 0 to 1.
pub(super) struct Strands {
    /// How much of the skin it covers: less at the hairline.
    pub(super) cover: f64,
    /// How high a strand is.
    pub(super) strand: f64,
    /// How high a hair in it is.
    pub(super) fine: f64,
}

/// The hair of the head: strands that run out from the whorl, thinner at the hairline.
pub(super) fn hair(side: DVec3, p: DVec3) -> Option<Strands> {
    let on_ear = step((0.008 - ear(side)) / 0.006);
    let height = above_hairline(side);
    if height < -0.06 || on_ear == 1.0 || side.y < -0.4 {
        return None;
    }
    let from = p - DVec3::new(0.03, 0.4, -0.25);
    let around = libm::atan2(from.x, from.z + 0.4 * from.y.min(0.0));
    let bend = 2.0 * noise(p * 5.0);
    let strand = noise(DVec3::new(around * 60.0 + bend, from.length() * 7.0, 3.0));
    let fine = noise(DVec3::new(around * 170.0 + bend * 3.0, from.length() * 14.0, 7.0));
    let cover = step((height + 0.035 * (strand - 0.5) + 0.035 * (fine - 0.5) + 0.01) / 0.045);
    Some(Strands { cover: cover * (1.0 - on_ear), strand, fine })
}

/// How closed the surroundings of a point are, 0 to 1: along the normal the field grows as fast as the way, unless
/// something else is near. After Evans, "Fast Approximations for Global Illumination on Dynamic Scenes" (2006).
pub(super) fn occlusion(p: DVec3, normal: DVec3) -> f64 {
    let closed: f64 = [0.012, 0.03, 0.06, 0.1]
        .iter()
        .map(|&way| ((way - body(p + normal * way)) / way).clamp(0.0, 1.0))
        .sum();
    (closed / 4.0 * 1.15).min(1.0)
}

/// The colour of a point of the unit eyeball that looks along z: white with a few veins, iris and pupil.
fn eye(q: DVec3) -> DVec3 {
    /// Radius of the iris, in radii of the eyeball: 5.9 of 12 mm, as of an adult.
    const IRIS: f64 = 0.47;
    let r = (q.x * q.x + q.y * q.y).sqrt() / IRIS;
    let around = libm::atan2(q.y, q.x);
    // White, redder away from the iris and at the corners, in the shadow of the upper lid.
    let mut c = hex(0xdfd6cd).lerp(hex(0xc9a596), 0.8 * step((r - 1.45) / 0.7));
    let veins = noise(DVec3::new(q.x * 9.0, q.y * 22.0, 2.0));
    c = c.lerp(hex(0xb87468), 0.35 * bump((veins - 0.5).abs() / 0.05) * step((r - 1.3) / 0.6));
    let rays = noise(DVec3::new(libm::cos(around) * 14.0, libm::sin(around) * 14.0, r * 2.0));
    let iris = hex(0x4c5f5f).lerp(hex(0x8a9684), rays).lerp(hex(0x8a6a3c), 0.7 * bump((r - 0.45) / 0.3));
    let limbus = hex(0x1f2c33);
    let iris = iris.lerp(limbus, step((r - 0.72) / 0.25));
    c = c.lerp(iris, step((1.06 - r) / 0.14));
    c = c.lerp(hex(0x0c0a0a), step((0.45 - r) / 0.07));
    let lid = step((q.y - 0.02) / 0.42);
    c * (1.0 - 0.5 * lid)
}

/// A colour in 8 bits a channel; the last ones are left out, so that more texels are equal to their neighbour.
fn color(c: DVec3) -> Color {
    let [r, g, b] =
        c.to_array().map(|level| ((level.clamp(0.0, 1.0) * 255.0 / 4.0).round() * 4.0).min(255.0) as u8);
    Color::rgb(r, g, b)
}
