//! Where each point of the head lies in its texture.
//!
//! Most of it is unwrapped around a vertical axis, as a label from a bottle, with the seam at the back and more
//! room for the front. What that would stretch or lay over something else has a patch of its own, in a strip along
//! the bottom: the crown, the ears' fronts and backs, the hollows of nose and mouth, the base, an eye. Since paint
//! depends on the point in space, colours agree on both sides of every border.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::shape::{BASE, EYE, EYE_RADIUS, ear, mouth, nostril, step};

/// Width and height of the texture.
pub const SIZE: u16 = 1024;

/// A part of the texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chart {
    /// Around the axis.
    Around,
    /// The top of the head, from above.
    Crown,
    /// An ear from its side; both share the patch.
    EarFront,
    /// An ear's back from its side, through it.
    EarBack,
    /// Nostrils and mouth from the front, through the lips.
    Hollow,
    /// The base.
    Base,
    /// An eyeball from the front; both share the patch.
    Eye,
}

/// The chart for a triangle of the head; `normal` points outwards.
#[must_use]
pub fn chart(corners: [DVec3; 3], normal: DVec3) -> Chart {
    let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    let side = DVec3::new(middle.x.abs(), middle.y, middle.z);
    if corners.iter().all(|p| p.y == BASE) {
        Chart::Base
    } else if corners.iter().any(|p| p.y > 0.44) {
        Chart::Crown
    } else if mouth(side).min(nostril(side)) < 0.003 {
        Chart::Hollow
    } else if ear(side) < 0.006 && side.distance(DVec3::new(0.34, -0.04, -0.04)) < 0.22 {
        let outwards = DVec3::new(0.88 * middle.x.signum(), 0.0, 0.475);
        if normal.dot(outwards) > 0.0 { Chart::EarFront } else { Chart::EarBack }
    } else {
        Chart::Around
    }
}

/// Height of the strip of patches, in texels.
const STRIP: f64 = 144.0;
/// The middle and the radius of the eye's patch, in texels.
const EYE_MIDDLE: DVec2 = DVec2::splat(72.0);
const EYE_REACH: f64 = 62.0;

impl Chart {
    /// The texture coordinates of a point, which is near `near`: of the two sides of the seam, that one's.
    #[must_use]
    pub fn uv(self, p: DVec3, near: DVec3) -> DVec2 {
        // Along the ear's plate, which stands off the head, and up.
        let side = DVec2::new(0.1 - 0.88 * p.z + 0.475 * (p.x.abs() - 0.32), p.y + 0.22);
        let texel = match self {
            Self::Around => return around(p, near),
            // Left edge, texels per head height, and the point in the patch.
            Self::Eye => EYE_MIDDLE + eye(p) * EYE_REACH,
            Self::EarFront => DVec2::new(144.0, 8.0) + side * 340.0,
            Self::EarBack => DVec2::new(272.0, 8.0) + side * 340.0,
            Self::Crown => DVec2::new(474.0, 72.0) + DVec2::new(p.x, -0.05 - p.z) * 180.0,
            Self::Hollow => DVec2::new(630.0, 8.0) + DVec2::new(p.x, p.y + 0.38) * 480.0,
            Self::Base => DVec2::new(850.0, 72.0) + DVec2::new(p.x, p.z + 0.1) * 120.0,
        };
        texel / f64::from(SIZE)
    }
}

/// Around the axis: the angle and the height, both warped.
fn around(p: DVec3, near: DVec3) -> DVec2 {
    /// What is beyond the seam on either side, for triangles that lie across it.
    const BEYOND: f64 = 0.06;
    /// How far up the skull it goes, in radians: above is the crown's own patch.
    const CROWN: f64 = 1.12;
    let turn = |p: DVec3| libm::atan2(p.x, p.z + 0.02) / PI;
    let (mut t, close) = (turn(p), turn(near));
    if (t - close).abs() > 1.0 {
        t += 2.0 * close.signum();
    }
    // Four times as many texels per degree in front as at the back.
    let warped = |t: f64| t * (1.6 - 0.6 * t.abs());
    let u = 0.5 + 0.5 * warped(t) / warped(1.0 + BEYOND);

    // Over the skull along a circle, straight down the face. Under nose and chin the surface turns inwards, on
    // the shoulders outwards: there the way from the axis counts, too, so that no two points meet.
    let (middle, radius) = (0.1, 0.36);
    let fold = |y: f64, r: f64| {
        if y > middle {
            return middle + radius * libm::atan2(y - middle, r);
        }
        let inwards = 0.35 * step((middle - y) / 0.2);
        let outwards = 1.1 * step((-0.6 - y) / 0.15);
        let way = y + (inwards - outwards) * (r - 0.18);
        // Less room for the shoulders.
        if way < -0.6 { -0.6 + 0.5 * (way + 0.6) } else { way }
    };
    let (bottom, top) = (fold(BASE, 0.76), middle + radius * CROWN);
    let from_axis = (p.x * p.x + (p.z + 0.02) * (p.z + 0.02)).sqrt();
    let strip = STRIP / f64::from(SIZE);
    DVec2::new(u, strip + (1.0 - strip) * (fold(p.y, from_axis) - bottom) / (top - bottom))
}

/// A point of an eyeball in the unit disc: the angle from straight ahead, up to 80°; behind is the disc's edge.
fn eye(p: DVec3) -> DVec2 {
    let q = (p - DVec3::new(EYE.x * p.x.signum(), EYE.y, EYE.z)) / EYE_RADIUS;
    let angle = libm::acos(q.z.clamp(-1.0, 1.0)).to_degrees() / 80.0;
    q.truncate().normalize_or_zero() * angle.min(1.0)
}

/// The texels of the eye's patch, and a few around it: column, row, and the point of the unit eyeball that each shows.
pub fn eye_texels() -> impl Iterator<Item = (i32, i32, DVec3)> {
    let disc = |x: i32, y: i32| (DVec2::new(f64::from(x), f64::from(y)) - (EYE_MIDDLE - 0.5)) / EYE_REACH;
    let texels = (0..144).flat_map(|y| (0..144).map(move |x| (x, y)));
    texels.map(move |(x, y)| (x, y, disc(x, y))).filter(|(.., disc)| disc.length() < 1.1).map(
        |(x, y, disc)| {
            let disc = disc.clamp_length_max(1.0);
            let angle = (disc.length() * 80.0).to_radians();
            (x, y, (disc.normalize_or_zero() * libm::sin(angle)).extend(libm::cos(angle)))
        },
    )
}
