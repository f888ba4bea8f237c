//! What paint, relief and shine are made of.

use glam::DVec3;

use super::shape::step;

/// 1 at 0, falling smoothly to 0 at ±1.
#[must_use]
pub fn bump(t: f64) -> f64 {
    1.0 - step(t.abs())
}

/// Value noise from 0 to 1: random numbers at whole points, smoothly joined.
#[must_use]
pub fn noise(p: DVec3) -> f64 {
    let low = p.floor();
    let [tx, ty, tz] = (p - low).to_array().map(step);
    let [x, y, z] = low.to_array().map(|n| n as i64 as u64);
    let random = |dx: u64, dy: u64, dz: u64| {
        let [x, y, z] = [x.wrapping_add(dx), y.wrapping_add(dy), z.wrapping_add(dz)];
        let mut n = x.wrapping_mul(0x9e37_79b9_7f4a_7c15)
            ^ y.wrapping_mul(0xc2b2_ae3d_27d4_eb4f)
            ^ z.wrapping_mul(0x1656_67b1_9e37_79f9);
        n = (n ^ (n >> 32)).wrapping_mul(0xd6e8_feb8_6659_fd93);
        n = (n ^ (n >> 32)).wrapping_mul(0xd6e8_feb8_6659_fd93);
        ((n ^ (n >> 32)) >> 40) as f64 / f64::from(1 << 24)
    };
    let row = |y: u64, z: u64| random(0, y, z) + (random(1, y, z) - random(0, y, z)) * tx;
    let plane = |z: u64| row(0, z) + (row(1, z) - row(0, z)) * ty;
    plane(0) + (plane(1) - plane(0)) * tz
}
