//! Lesson 4: the nearest surface.

use common::{Color, Format, Image, Vec3};
use triangles::fill;
use zbuffer::{METHODS, Surface};

use crate::input::named;
use crate::view::beside;
use crate::{Drawing, Figure, Input, Values, View, number};

/// The first surface's colour.
const BLUE: Color = Color::rgb(86, 160, 211);
/// The second one's.
const AMBER: Color = Color::rgb(242, 193, 78);

/// Two triangles in a scene whose depth goes from −1 to 1.
struct Pair {
    surfaces: [Surface; 4],
    /// Width and height of a picture of them.
    side: u16,
}

impl Pair {
    fn new(side: u16, first: [Vec3; 3], second: [Vec3; 3]) -> Self {
        // Beside the picture.
        let end = |depth: f32| [(-9.0, 0.0), (-8.0, 0.0), (-8.0, 1.0)].map(|(x, y)| Vec3::new(x, y, depth));
        let surface = |corners, color| Surface { corners, color };
        let surfaces = [
            surface(first, BLUE),
            surface(second, AMBER),
            surface(end(-1.0), Color::BLACK),
            surface(end(1.0), Color::BLACK),
        ];
        Self { surfaces, side }
    }

    fn canvas(&self) -> Image {
        Image::new(self.side, self.side, Format::Rgb)
    }

    /// Whether both triangles cover a pixel, of each, row by row.
    fn shared(&self) -> Vec<bool> {
        let mut times = vec![0; usize::from(self.side).pow(2)];
        for surface in &self.surfaces[..2] {
            fill(surface.corners.map(Vec3::truncate), self.canvas().bounds(), |x, y, _| {
                times[y as usize * usize::from(self.side) + x as usize] += 1;
            });
        }
        times.into_iter().map(|times| times == 2).collect()
    }

    /// The scene by the methods that keep depths, side by side, in a row below these the depths if they are to be seen; and in
    /// how many of the pixels that both triangles cover the second one is seen.
    fn compared(&self, with_depths: bool) -> (Image, String) {
        let shared = self.shared();
        let (mut pictures, mut depths, mut counts) = (Vec::new(), Vec::new(), Vec::new());
        for (method, depth) in named!(METHODS).iter().filter_map(|method| Some((method, method.run.depth?))) {
            let mut picture = self.canvas();
            (method.run.draw)(&self.surfaces, &mut picture);
            let pixels = (0..picture.height()).flat_map(|y| (0..picture.width()).map(move |x| (x, y)));
            let seen =
                pixels.zip(&shared).filter(|&((x, y), both)| *both && picture.get(x, y) == Some(AMBER));
            counts.push(format!("in {} by {}", seen.count(), method.name));
            if with_depths {
                let gray = depth(&self.surfaces, &picture);
                let mut nearness = self.canvas();
                nearness.set_all(|pixel| Color::gray(f32::from(gray.buffer()[pixel]) / 255.0));
                depths.push(nearness);
            }
            pictures.push(picture);
        }
        let told = format!(
            "Of the {} pixels that both triangles cover, the amber one is seen {}.",
            shared.into_iter().filter(|&both| both).count(),
            counts.join(", "),
        );
        let rows = if with_depths { vec![pictures, depths] } else { vec![pictures] };
        (beside(&rows), told)
    }
}

/// Two triangles that cut each other, and the depths that are kept of them.
pub(crate) const CUT: Figure = Figure {
    name: "zbuffer-cut",
    stays: true,
    hint: "Move the line where the triangles cross, and make them less steep. From left to right by z16, z24 and z-f32; \
           below each picture are the depths that were kept, the nearest one white.",
    inputs: &[
        Input::Slider { label: "They cross at x =", from: 71.0, range: [20.0, 130.0], step: 1.0 },
        Input::Slider { label: "Steepness, in powers of ten", from: 0.0, range: [-7.0, 0.0], step: 0.25 },
    ],
    draw: cut,
};

fn cut(mut values: Values) -> View {
    const SIDE: u16 = 150;
    let at = values.number();
    let steepness = 10.0_f32.powf(values.number()) / f32::from(SIDE);
    let corners = |corners: [(f32, f32); 3], by: f32| corners.map(|(x, y)| Vec3::new(x, y, (x - at) * by));
    let pair = Pair::new(
        SIDE,
        corners([(8.0, 20.0), (140.0, 40.0), (50.0, 140.0)], steepness),
        corners([(20.0, 120.0), (35.0, 8.0), (144.0, 95.0)], -steepness),
    );
    let (image, told) = pair.compared(true);
    View { drawing: Drawing::Pixels(image), told, table: Vec::new() }
}

/// Two parallel planes, and the gap at which they fight.
pub(crate) const FIGHTING: Figure = Figure {
    name: "zbuffer-fighting",
    stays: false,
    hint: "Make the gap between the two surfaces wider and narrower.",
    inputs: &[Input::Slider { label: "Gap, in powers of ten", from: -5.4, range: [-8.0, -3.5], step: 0.05 }],
    draw: fighting,
};

fn fighting(mut values: Values) -> View {
    let gap = 10.0_f32.powf(values.number());
    let plane = |corners: [(f32, f32); 3], nearer: f32| {
        corners.map(|(x, y)| Vec3::new(x, y, x / 1700.0 - y / 2300.0 + nearer))
    };
    let pair = Pair::new(
        200,
        plane([(10.0, 20.0), (190.0, 40.0), (70.0, 190.0)], 0.0),
        plane([(30.0, 170.0), (60.0, 12.0), (192.0, 130.0)], gap),
    );
    let (image, told) = pair.compared(false);
    // Levels from the farthest depth, −1, to the nearest, 1.
    let steps = |levels: i32| number(gap * (levels - 2) as f32 / 2.0);
    let told = format!(
        "The amber surface should be nearer everywhere, by {} steps of z16, or {} of z24. {told}",
        steps(1 << 16),
        steps(1 << 24),
    );
    View { drawing: Drawing::Pixels(image), told, table: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gap of many steps is told apart, one of none is not: the first surface stays.
    #[test]
    fn a_gap_is_seen_where_it_is_wider_than_a_step() {
        let told = FIGHTING.view(&[-3.5]).told;
        let words: Vec<&str> = told.split(' ').collect();
        let all = words[words.iter().position(|word| *word == "pixels").unwrap() - 1];
        assert_eq!(told.matches(&format!("in {all} by")).count(), 3, "{told}");
        assert!(FIGHTING.view(&[-8.0]).told.contains("is seen in 0 by z16"));
    }

    /// Each picture stands above its depths, which are grey inside and black where nothing is.
    #[test]
    fn depths_are_below_their_pictures() {
        let Drawing::Pixels(image) = CUT.view(&[]).drawing else { panic!("it is a sheet") };
        let up = (image.height() + 6) / 2;
        for n in 0..3 {
            let left = n * (image.width() + 6) / 3;
            // In the amber triangle, and in neither.
            assert_eq!(image.get(left + 110, up + 80), Some(AMBER));
            assert_eq!(image.get(left + 2, up + 2), Some(Color::BLACK));
            let Color { r, g, b, .. } = image.get(left + 110, 80).unwrap();
            assert!(r == g && g == b && (20..235).contains(&r), "{r} {g} {b}");
            assert_eq!(image.get(left + 2, up - 10), Some(Color::BLACK));
        }
    }
}
