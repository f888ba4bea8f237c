use std::f64::consts::TAU;

use blending::cutout::{Cutout, FERN};
use blending::glass::{Rosette, draw};
use blending::{LESSON, Over, SPACES, TRANSPARENCY, Transparency, TwoShift};
use checks::layers::{self, Pane};
use checks::picture::distance;
use common::{Color, Format, Image};
use verify::assert_similar;

fn rosette(way: Transparency, side: u16) -> Image {
    let mut image = Image::new(side, side, Format::Rgb);
    draw(way, Over(TwoShift), &mut image);
    image
}

#[test]
fn a_rosette_of_glass() {
    for row in TRANSPARENCY {
        assert_similar(&LESSON, &format!("glass-{}", row.name), &rosette(row.run, 200));
    }
}

#[test]
fn a_frond_in_each_space() {
    let cutout = Cutout::read(FERN).unwrap();
    for row in SPACES {
        let mut image = Image::new(200, 200, Format::Rgb);
        cutout.enlarged(&row.run, &mut image);
        assert_similar(&LESSON, &format!("fern-{}", row.name), &image);
    }
}

/// The rosette is the same all around but for its colours: seen in grey, turned by a sixth it is itself. Drawn without an order
/// it is not.
#[test]
fn only_an_order_for_each_pixel_is_the_same_all_around() {
    // Alphas alone show which pane is on top where all panes but one are black.
    let changed = |way: Transparency| {
        let size = 240.0;
        let Rosette { opaque, transparent } = Rosette::new(common::Vec2::splat(size));
        let pane = |n: usize| {
            let mut panes = transparent.clone();
            for (m, surface) in panes.iter_mut().enumerate().take(6) {
                let (r, g, b) = if m == n { (255, 255, 255) } else { (0, 0, 0) };
                surface.color = Color { r, g, b, a: 150 };
            }
            let mut image = Image::new(240, 240, Format::Rgb);
            let mut target = blending::Framebuffer::new(&mut image, blending::State::OFF);
            blending::plain::draw(&opaque, &mut target);
            let blending::Framebuffer { image: target, depths, .. } = target;
            way.draw(&panes, Over(TwoShift), target, &depths);
            image
        };
        let (first, next) = (pane(0), pane(1));
        // The next one, turned back by a sixth, looked up at the nearest pixel.
        let (sin, cos) = (TAU / 6.0).sin_cos();
        let moved = first.pixels().filter(|&(x, y, color)| {
            let (u, v) = (f64::from(x) + 0.5 - 120.0, f64::from(y) + 0.5 - 120.0);
            let at = |w: f64| (w + 120.0).floor() as i32;
            let other = next.get(at(u * cos - v * sin), at(u * sin + v * cos));
            other.is_some_and(|other| distance(color, other) > 24)
        });
        moved.count()
    };
    for row in TRANSPARENCY {
        let moved = changed(row.run);
        // Pixels at sides may be off by one; wrong panes on top are thousands.
        let expected = match row.run {
            Transparency::Drawn | Transparency::Sorted => 2000..20_000,
            _ => 0..1200,
        };
        assert!(expected.contains(&moved), "{}: {moved}", row.name);
    }
}

/// How many layers there are, and that each pane lies over the next: at the middle of their common part.
#[test]
fn each_pane_lies_over_the_next() {
    let Rosette { opaque, transparent } = Rosette::new(common::Vec2::splat(240.0));
    let panes = |surfaces: &[zbuffer::Surface]| -> Vec<Pane> {
        surfaces.iter().map(|surface| (surface.corners, surface.color)).collect()
    };
    let (opaque, transparent) = (panes(&opaque), panes(&transparent));
    let at = |x, y| layers::at(Color::WHITE, &opaque, &transparent, x, y).layers;
    let mut over = 0;
    for n in 0..6 {
        let angle = TAU * (f64::from(n) + 1.4) / 6.0;
        let place = |w: f64| (120.0 + 80.0 * w) as i32;
        let layers = at(place(angle.cos()), place(angle.sin()));
        let [far, near] = layers[..] else { panic!("{n}: {layers:?}") };
        let colors = [transparent[(n as usize + 1) % 6].1, transparent[n as usize].1];
        assert_eq!([far.1, near.1], colors, "{n}");
        over += 1;
    }
    assert_eq!(over, 6);
}
