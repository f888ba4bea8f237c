//! What a frame costs besides time: no memory after the first.

use clipping::Cull;
use common::{Color, Format, Image};
use speed::Plan;

use crate::canvas::frame;
use crate::soup::{Corner, Soup};

const SIZE: [u16; 2] = [200, 150];

/// Triangles over the whole picture, some of them large, some small, in turns about its middle.
fn turning() -> Soup {
    let corner = |angle: f32, reach: f32, n: u8| {
        let (sin, cos) = angle.sin_cos();
        let [x, y] = [100.0 + reach * cos, 75.0 + reach * sin].map(|place| (place * 256.0) as i32);
        Corner { x, y, z: f32::from(n) / 260.0, w: 1.0 + f32::from(n % 7) }
    };
    let triangle = |n: u8| {
        let angle = f32::from(n) * 0.7;
        let reach = f32::from(n % 50) * 5.0;
        [corner(angle, reach, n), corner(angle + 0.5, reach + 20.0, n), corner(angle + 1.5, reach + 9.0, n)]
    };
    Soup::apart(&(0..250).map(triangle).collect::<Vec<_>>(), SIZE)
}

#[test]
fn a_frame_allocates_nothing_after_the_first() {
    for tile in [None, Some(8), Some(64)] {
        for (hierarchical, deferred) in [(false, false), (true, false), (false, true), (true, true)] {
            let plan = Plan { tile, hierarchical, deferred, threads: 1 };
            let mut frame = frame(SIZE, plan);
            let mut image = Image::new(SIZE[0], SIZE[1], Format::Rgb);
            let soup = turning();
            let mesh = soup.mesh();
            let mut allocations = || {
                allocation_counter::measure(|| {
                    frame.clear(Color::BLACK);
                    frame.draw(&soup.shader(), &mesh, Cull::None);
                    frame.draw(&soup.shader(), &mesh, Cull::Back);
                    frame.copy_to(&mut image);
                })
                .count_total
            };
            let [first, second, third] = [allocations(), allocations(), allocations()];
            assert!(first > 0, "{plan:?}: something is kept");
            assert_eq!([second, third], [0; 2], "{plan:?}");
        }
    }
}
