//! How much of a highlight each point of the head shows, from 0 to 1, painted as its colours are.

use common::{Color, Format, Image};
use glam::DVec3;

use super::atlas::eye_texels;
use super::noise::{bump, noise};
use super::paint::{Strands, beard, brow, hair, lip, occlusion};
use super::shape::{EYE, MOUTH, body, eye_opening, mouth, nostril, step};
use super::texels::{Sheet, Texel, Texels};

/// Paints the map: the bust, an eye, and what a coarser bust shows beyond the patches of this one.
#[must_use]
pub fn paint(bust: &Texels, coarse: &Texels) -> Image {
    let mut map = Sheet::new(Format::Gray);
    let paint = |Texel { position: p, normal, .. }| gray(skin(p - normal * body(p), normal));
    bust.iter().for_each(|(x, y, texel)| map.set(x, y, paint(texel)));
    // The eye is wet.
    eye_texels().for_each(|(x, y, _)| map.set(x, y, Color::WHITE));
    coarse.iter().for_each(|(x, y, texel)| map.set_unknown(x, y, || paint(texel)));
    map.padded()
}

/// The share of a point of the bust.
fn skin(p: DVec3, normal: DVec3) -> f64 {
    let side = DVec3::new(p.x.abs(), p.y, p.z);
    // Skin shines where it is tight and oily, little on cheeks and neck, and between its pores.
    let oily = |center: DVec3, size: f64| bump(side.distance(center) / size);
    let zones = 0.45 * oily(DVec3::new(0.0, 0.23, 0.38), 0.22)
        + 0.55 * oily(DVec3::new(0.0, -0.13, 0.5), 0.12)
        + 0.3 * oily(DVec3::new(0.17, -0.06, 0.31), 0.1)
        + 0.3 * oily(DVec3::new(0.0, -0.44, 0.41), 0.09);
    let neck = if p.y < -0.5 { 0.12 * step((-0.5 - p.y) / 0.15) } else { 0.0 };
    let mut shine = (0.32 + zones - neck) * (0.8 + 0.4 * noise(p * 130.0));
    shine *= 1.0 - 0.5 * beard(side, p);
    if let Some((on_lips, creases)) = lip(side, p) {
        let middle = 1.0 - 0.3 * step((side.y - MOUTH) / 0.02);
        shine += (middle * (0.75 + 0.25 * creases) - shine) * on_lips;
    }
    // The moist rim of the lids.
    let q = side - EYE;
    if q.z > 0.0 {
        shine += (0.9 - shine) * bump(eye_opening(q) / 0.006);
    }
    if let Some((dense, _)) = brow(side, p) {
        shine += (0.12 - shine) * dense;
    }
    if let Some(Strands { cover, strand, fine }) = hair(side, p) {
        shine += (0.1 + 0.35 * strand * fine - shine) * cover;
    }
    let hollow = step((0.005 - mouth(side)) / 0.004).max(step((0.005 - nostril(side)) / 0.006));
    shine * (1.0 - occlusion(p, normal)) * (1.0 - hollow)
}

/// A share as a texel; the last bits are left out, so that more texels are equal to their neighbour.
fn gray(share: f64) -> Color {
    let level = ((share.clamp(0.0, 1.0) * 255.0 / 8.0).round() * 8.0).min(255.0) as u8;
    Color::rgb(level, level, level)
}
