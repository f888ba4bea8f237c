//! Mission 4: the nearest surface, judged.

mod faults;

use std::process::ExitCode;

use common::{Format, Image, Vec3};
use judge::Judge;
use zbuffer_tasks::given::{DepthBuffer, Surface};
use zbuffer_tasks::{MISSION, Zbuffer};

const JUDGE: Judge<Zbuffer> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Zbuffer = Zbuffer { fill_nearest, z_f32 };

fn fill_nearest(
    corners: [Vec3; 3],
    depths: &mut DepthBuffer<f32>,
    store: fn(f32) -> f32,
    visit: &mut dyn FnMut(i32, i32, Vec3),
) {
    let last = depths.bounds().max;
    let image = Image::new((last.x + 1) as u16, (last.y + 1) as u16, Format::Gray);
    let mut own = zbuffer::DepthBuffer::new(&image, f32::NEG_INFINITY);
    image.pixels().for_each(|(x, y, _)| own.set(x, y, depths.get(x, y)));
    zbuffer::fill_nearest(corners, &mut own, store, visit);
    image.pixels().for_each(|(x, y, _)| depths.set(x, y, own.get(x, y)));
}

fn z_f32(surfaces: &[Surface], image: &mut Image) -> DepthBuffer<f32> {
    let own: Vec<zbuffer::Surface> =
        surfaces.iter().map(|&Surface { corners, color }| zbuffer::Surface { corners, color }).collect();
    let own = zbuffer::z_f32(&own, image);
    let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
    image.pixels().for_each(|(x, y, _)| depths.set(x, y, own.get(x, y)));
    depths
}

fn main() -> ExitCode {
    JUDGE.run()
}
