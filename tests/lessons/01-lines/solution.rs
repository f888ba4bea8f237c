//! All of mission 1.
use common::{Color, IVec2, Image};

/// Bresenham's way, in 64 bits.
pub fn line(a: IVec2, b: IVec2, image: &mut Image, color: Color) {
    let wide = |p: IVec2| (i64::from(p.x), i64::from(p.y));
    let (a, b) = (wide(a), wide(b));
    let steep = (b.0 - a.0).abs() < (b.1 - a.1).abs();
    let flip = |p: (i64, i64)| if steep { (p.1, p.0) } else { p };
    let (mut a, mut b) = (flip(a), flip(b));
    if a.0 > b.0 {
        std::mem::swap(&mut a, &mut b);
    }
    let (length, rise, sign) = (b.0 - a.0, (b.1 - a.1).abs(), (b.1 - a.1).signum());
    let (mut y, mut error) = (a.1, -length);
    for x in a.0..=b.0 {
        let (px, py) = flip((x, y));
        image.set(px as i32, py as i32, color);
        error += 2 * rise;
        if error > 0 {
            y += sign;
            error -= 2 * length;
        }
    }
}
