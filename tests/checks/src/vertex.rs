//! The pixel in which a vertex of a model lies, in whole numbers.

/// ⌊(x + 1)·size/2⌋ without any rounding, and size − 1 for exactly 1: the column of a coordinate, or its row.
///
/// # Panics
/// Where the coordinate is not finite or beyond ±2⁶⁰.
#[must_use]
pub fn pixel(coordinate: f32, size: i32) -> i128 {
    assert!(coordinate.abs() <= (1_u64 << 60) as f32);
    // What lies below 2⁻⁶⁰ matters by its sign only: near 0 there is no border but 0 itself, and elsewhere an f32
    // has no digits down there.
    const BITS: u32 = 60;
    let scaled = f64::from(coordinate) * (1_u64 << BITS) as f64;
    let whole = if scaled.abs() < 1.0 { scaled.signum() * scaled.abs().ceil() } else { scaled.floor() };
    let size = i128::from(size);
    if coordinate == 1.0 { size - 1 } else { ((whole as i128 + (1 << BITS)) * size) >> (BITS + 1) }
}

#[cfg(test)]
mod tests {
    use super::pixel;

    #[test]
    fn a_pixel_begins_at_its_left_border() {
        let columns = [-1.0, -1e-30, 0.0, 1e-30, 0.5, 1.0f32.next_down(), 1.0, 3.0, -1.0f32.next_up()];
        assert_eq!(columns.map(|x| pixel(x, 4)), [0, 1, 2, 2, 3, 3, 3, 8, -1]);
        // 2/3 as f32 lies above 2/3, and (2/3 + 1)·3/2 is 2.5.
        assert_eq!([2.0f32 / 3.0, 1.0 / 3.0, (1.0f32 / 3.0).next_down()].map(|x| pixel(x, 3)), [2, 2, 1]);
    }
}
