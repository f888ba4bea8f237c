//! A block that hides a triangle hides all of it: no pixel that is seen is rejected, however near depths are to each other.

use clipping::{Counts, Cull};
use common::Color;
use fastrand::Rng;
use speed::Plan;

use crate::canvas::{Canvas, Way, differing, drawn};
use crate::soup::{Corner, Soup};

/// A picture of two by two blocks.
const SIZE: [u16; 2] = [16, 16];

/// Two planes that pass through each other at a place in the picture where they are tilted alike but for some bits: in most
/// blocks one is nearer than the other by a bit here and there, as rounding has it.
#[test]
fn nearly_the_same_planes_are_told_apart_pixel_by_pixel() {
    let mut rng = Rng::with_seed(17);
    let mut mixed = 0;
    for n in 0..20_000 {
        let reach = [1, 30, 3000][n % 3];
        let corner = |rng: &mut Rng| {
            (rng.i32(-reach * 256..256 * (16 + reach)), rng.i32(-reach * 256..256 * (16 + reach)))
        };
        let mut points = [(); 3].map(|()| corner(&mut rng));
        let tilt = 10_f32.powi(-rng.i32(0..9));
        let z = [(); 3].map(|()| (0.5 + tilt * (rng.f32() - 0.5)).clamp(0.0, 0.999));
        let triangle = |points: [(i32, i32); 3], z: [f32; 3]| {
            [0, 1, 2].map(|n| Corner { x: points[n].0, y: points[n].1, z: z[n], w: 1.0 })
        };
        let mut triangles = vec![triangle(points, z)];
        for _ in 0..4 {
            // The same plane, a few bits nearer or farther at its corners; or of other corners.
            let bits =
                |z: f32, off: i32| f32::from_bits(z.to_bits().wrapping_add_signed(off)).clamp(0.0, 1.0);
            let moved = z.map(|z| bits(z, rng.i32(-3..=1)));
            points.rotate_left(1);
            triangles.push(triangle(points, [moved[1], moved[2], moved[0]]));
            points.rotate_right(1);
        }
        let soup = Soup::apart(&triangles, SIZE);
        let mesh = soup.mesh();
        let draw = |canvas: &mut Canvas| -> Counts { canvas.draw(&soup.shader(), &mesh, Cull::None) };
        let (expected, _) = drawn(Way::Simple, SIZE, Color::BLACK, draw);
        let first = Soup::apart(&triangles[..1], SIZE);
        let alone = |canvas: &mut Canvas| canvas.draw(&first.shader(), &first.mesh(), Cull::None);
        let (alone, _) = drawn(Way::Simple, SIZE, Color::BLACK, alone);
        let same = expected.pixels().zip(alone.pixels()).filter(|(a, b)| a.2 == b.2).count();
        mixed += usize::from((1..256).contains(&same));
        for deferred in [false, true] {
            let plan = Plan { tile: Some(8), hierarchical: true, deferred, threads: 1 };
            let (got, _) = drawn(Way::tiled(plan), SIZE, Color::BLACK, draw);
            assert_eq!(differing(&expected, &got), None, "{plan:?}: {triangles:?}");
        }
    }
    assert!(mixed > 3000, "{mixed}");
}
