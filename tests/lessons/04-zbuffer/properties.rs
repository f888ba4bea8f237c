use checks::visibility::nearest;
use common::{Color, Format, Image, Vec3};
use proptest::prelude::*;
use verify::window;
use zbuffer::{METHODS, Surface};

const SIDE: i32 = 24;

/// Up to twenty triangles in and about a picture of 24×24 px, with depths from -1 to 1, each in its own colour.
fn surfaces() -> impl Strategy<Value = Vec<Surface>> {
    let corner = || (-6.0f32..30.0, -6.0f32..30.0, -1.0f32..1.0).prop_map(Vec3::from);
    prop::collection::vec([corner(), corner(), corner()], 1..20).prop_map(|triangles| {
        let color = |n: usize| Color::rgb(n as u8 + 1, 0, 0);
        triangles.into_iter().enumerate().map(|(n, corners)| Surface { corners, color: color(n) }).collect()
    })
}

fn draw(method: &str, surfaces: &[Surface]) -> Image {
    let mut image = Image::new(SIDE as u16, SIDE as u16, Format::Rgb);
    (verify::method(METHODS, method).draw)(surfaces, &mut image);
    image
}

/// How near two depths may come before a method cannot tell them apart: two levels, or some roundings of f32.
fn resolution(method: &str) -> f64 {
    match method {
        "z16" => 2.0 * 2.0 / 65_534.0,
        _ => 1e-6,
    }
}

proptest! {
    /// Of equal surfaces the first drawn stays, also where its corners come in another order or the other way round.
    #[test]
    fn the_first_of_equal_surfaces_stays(surfaces in surfaces()) {
        for method in ["z16", "z24", "z-f32"] {
            let Surface { corners: [a, b, c], .. } = surfaces[0];
            let orders = [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]];
            let all = |first: usize| -> Vec<Surface> {
                let turned = (first..first + 6).map(|n| orders[n % 6]).zip([Color::RED, Color::GREEN].into_iter().chain([Color::WHITE; 4]));
                turned.map(|(corners, color)| Surface { corners, color }).collect()
            };
            for first in 0..6 {
                let image = draw(method, &all(first));
                prop_assert!(image.pixels().all(|pixel| [Color::BLACK, Color::RED].contains(&pixel.2)), "{}", method);
            }
        }
    }

    /// Wherever the nearest depth is the nearest by more than a rounding, the nearest triangle is seen.
    #[test]
    fn the_nearest_is_seen(surfaces in surfaces()) {
        let triangles: Vec<_> = surfaces.iter().map(|surface| surface.corners).collect();
        for method in ["z16", "z24", "z-f32"] {
            let picture = draw(method, &surfaces);
            for (x, y, color) in picture.pixels() {
                let expected = match nearest(&triangles, x, y) {
                    Some(seen) if seen.gap > resolution(method) => surfaces[seen.triangle].color,
                    Some(_) => continue,
                    None => Color::BLACK,
                };
                prop_assert_eq!(color, expected, "{} at ({}, {})", method, x, y);
            }
        }
    }

    /// The order of the triangles shows only where two depths are nearly one.
    #[test]
    fn the_order_of_triangles_does_not_matter(
        (surfaces, shuffled) in surfaces().prop_flat_map(|all| (Just(all.clone()), Just(all).prop_shuffle())),
    ) {
        let triangles: Vec<_> = surfaces.iter().map(|surface| surface.corners).collect();
        for method in ["z16", "z24", "z-f32"] {
            let [a, b] = [draw(method, &surfaces), draw(method, &shuffled)];
            for (x, y, color) in a.pixels() {
                let clear = nearest(&triangles, x, y).is_none_or(|seen| seen.gap > resolution(method));
                prop_assert!(!clear || b.get(x, y) == Some(color), "{method} at ({x}, {y})");
            }
        }
    }

    /// Every method colours the same pixels: those that some triangle covers.
    #[test]
    fn every_method_covers_the_same(surfaces in surfaces()) {
        let covered = |method: &str| -> Vec<bool> {
            draw(method, &surfaces).pixels().map(|pixel| pixel.2 != Color::BLACK).collect()
        };
        let expected = covered("painter");
        for method in METHODS {
            prop_assert_eq!(&covered(method.name), &expected, "{}", method.name);
        }
    }

    /// Any numbers at all: nothing panics, and level triangles have their depth to the last bit.
    #[test]
    fn no_number_panics(corners in any::<[[f32; 3]; 3]>(), depth in -1e30f32..1e30) {
        let wild = Surface { corners: corners.map(Vec3::from_array), color: Color::WHITE };
        let level = [(0.0, 0.0), (50.0, 0.0), (0.0, 50.0)].map(|(x, y)| Vec3::new(x, y, depth));
        let level = Surface { corners: level, color: Color::RED };
        for method in METHODS {
            draw(method.name, &[wild, level]);
        }
        let mut image = Image::new(SIDE as u16, SIDE as u16, Format::Rgb);
        let depths = zbuffer::z_f32(&[level], &mut image);
        let bounds = window(SIDE, SIDE);
        prop_assert!((bounds.min.x..=bounds.max.x).all(|n| depths.get(n, n) == depth));
    }
}
