//! What each sample of a pixel sees: whether it is inside, in `i128`; which of several triangles is nearest there, in `f64`.

use common::Vec2;

use crate::box_filter::Surface;
use crate::coverage::Triangle;

/// Depths closer than this are not told apart by numbers of 24 bits between 0 and 1, rounded a few times.
const APART: f64 = 1e-6;

/// The nearest of the surfaces at a sample of the pixel (x, y), the first of equals; `None` within where there is none, and
/// `None` in all where the two nearest are so close that rounding may decide. The place is counted from the pixel's lower
/// left corner, in 1/16 px.
#[must_use]
pub fn nearest(surfaces: &[Surface], x: i32, y: i32, place: [i32; 2]) -> Option<Option<usize>> {
    let depths =
        surfaces.iter().enumerate().filter_map(|(n, surface)| Some((n, depth(surface, x, y, place)?)));
    let mut depths: Vec<(usize, f64)> = depths.collect();
    // A stable sort: equals stay in the order in which they came.
    depths.sort_by(|a, b| a.1.total_cmp(&b.1));
    let gap = depths.windows(2).next().map(|pair| pair[1].1 - pair[0].1);
    let certain = gap.is_none_or(|gap| gap == 0.0 || gap > APART);
    certain.then(|| depths.first().map(|first| first.0))
}

/// The mean of what the samples of the pixel (x, y) see, the background where they see nothing; `None` where it is not certain
/// for one of them.
#[must_use]
pub fn mean(
    surfaces: &[Surface],
    background: [f64; 3],
    x: i32,
    y: i32,
    places: &[[i32; 2]],
) -> Option<[f64; 3]> {
    let mut sum = [0.0; 3];
    for &place in places {
        let color = nearest(surfaces, x, y, place)?.map_or(background, |n| surfaces[n].color);
        (0..3).for_each(|channel| sum[channel] += color[channel]);
    }
    Some(sum.map(|channel| channel / places.len() as f64))
}

/// The depth of a surface's plane at a sample that is inside.
fn depth(surface: &Surface, x: i32, y: i32, place: [i32; 2]) -> Option<f64> {
    let triangle = Triangle::new(surface.corners.map(|corner| Vec2::new(corner.x, corner.y)));
    if triangle.samples(x, y, &[place]) == 0 {
        return None;
    }
    let at = [0, 1].map(|axis| i128::from([x, y][axis]) * 256 + i128::from(place[axis]) * 16);
    let weights = triangle.weights_at(at);
    let [a, b, c] = surface.corners.map(|corner| f64::from(corner.z));
    // Measured from one of the corners, a level triangle has its depth to the last bit.
    Some(a + weights[1] * (b - a) + weights[2] * (c - a))
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::Vec3;

    fn surface(corners: [[f32; 3]; 3], grey: f64) -> Surface {
        Surface { corners: corners.map(Vec3::from), color: [grey; 3] }
    }

    #[test]
    fn each_sample_sees_the_nearest_for_itself() {
        // Left of x = 1/2 the first is nearer, right of it the second; the third is behind both, and smaller.
        let first = surface([[-2.0, -2.0, 0.0], [6.0, -2.0, 0.8], [-2.0, 6.0, 0.0]], 0.25);
        let second = surface([[-2.0, -2.0, 0.5], [6.0, -2.0, -0.3], [-2.0, 6.0, 0.5]], 0.75);
        let third = surface([[0.0, 0.0, 0.9], [1.0, 0.0, 0.9], [0.0, 1.0, 0.9]], 1.0);
        let all = [first, second, third];
        assert_eq!(nearest(&all, 0, 0, [4, 4]), Some(Some(0)));
        assert_eq!(nearest(&all, 0, 0, [12, 4]), Some(Some(1)));
        assert_eq!(nearest(&all, 0, 0, [8, 4]), None);
        assert_eq!(nearest(&[third], 0, 0, [12, 12]), Some(None));
        assert_eq!(mean(&all, [0.0; 3], 0, 0, &[[4, 4], [12, 4], [1, 1], [2, 9]]), Some([0.375; 3]));
        assert_eq!(mean(&[third], [0.5; 3], 0, 0, &[[4, 4], [12, 12]]), Some([0.75; 3]));
        // Of equal depths the first.
        assert_eq!(nearest(&[third, third], 0, 0, [4, 4]), Some(Some(0)));
    }
}
