//! Pictures of a few triangles in the window, and what there is to see in them.

use antialiasing::{Draw, pattern};
use checks::box_filter;
use common::{Color, Format, Image, Method, Vec3};
use zbuffer::Surface;

/// Triangles over a background.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    /// Width and height, in pixels.
    pub(crate) size: [u16; 2],
    /// The colour of the picture before.
    pub(crate) background: Color,
    /// The triangles, in the order in which they are drawn.
    pub(crate) triangles: Vec<Surface>,
}

impl Scene {
    /// White triangles on black, all at one depth.
    pub(crate) fn white<const N: usize>(size: [u16; 2], triangles: [[[f32; 2]; 3]; N]) -> Self {
        let triangles = triangles.map(|corners| flat(corners, 0.5, Color::WHITE)).to_vec();
        Self { size, background: Color::BLACK, triangles }
    }

    /// All pixels, rows from the bottom.
    pub(crate) fn pixels(&self) -> impl Iterator<Item = (i32, i32)> + use<> {
        let [width, height] = self.size.map(i32::from);
        (0..height).flat_map(move |y| (0..width).map(move |x| (x, y)))
    }

    /// The triangles as references take them, their colours as the codes they are.
    pub(crate) fn surfaces(&self) -> Vec<box_filter::Surface> {
        let surface =
            |&Surface { corners, color }: &Surface| box_filter::Surface { corners, color: codes(color) };
        self.triangles.iter().map(surface).collect()
    }

    /// What a pixel would show of all that is seen in it, rows from the bottom.
    pub(crate) fn truth(&self) -> Vec<[f64; 3]> {
        let [width, height] = self.size.map(i32::from);
        box_filter::picture(&self.surfaces(), codes(self.background), width, height)
    }

    /// What a method with samples should draw, rows from the bottom: the mean of what is seen at the places of its samples;
    /// `None` where that is not certain.
    pub(crate) fn sampled(&self, method: &Method<Draw>) -> Vec<Option<[f64; 3]>> {
        let background = codes(self.background);
        if method.name != "ordered-16" {
            let (surfaces, places) = (self.surfaces(), pattern(method.run.samples));
            return self
                .pixels()
                .map(|(x, y)| checks::samples::mean(&surfaces, background, x, y, places))
                .collect();
        }
        // The centres of a picture four times as large, whose corners are rounded there.
        let larger = |mut surface: box_filter::Surface| {
            surface.corners = surface.corners.map(|corner| corner * Vec3::new(4.0, 4.0, 1.0));
            surface
        };
        let surfaces: Vec<_> = self.surfaces().into_iter().map(larger).collect();
        let mean = |(x, y): (i32, i32)| {
            let mut sum = [0.0; 3];
            for n in 0..16 {
                let (x, y) = (4 * x + n % 4, 4 * y + n / 4);
                let color = checks::samples::mean(&surfaces, background, x, y, &[[8, 8]])?;
                (0..3).for_each(|channel| sum[channel] += color[channel]);
            }
            Some(sum.map(|channel| channel / 16.0))
        };
        self.pixels().map(mean).collect()
    }

    /// What a method draws of it.
    pub(crate) fn drawn(&self, method: &Draw) -> Image {
        let mut image = Image::new(self.size[0], self.size[1], Format::Rgb);
        (method.picture)(&antialiasing::Scene::of(&self.triangles, self.background), &mut image);
        image
    }
}

/// The places of a method's samples, in 1/16 px from the pixel's lower left corner.
pub(crate) fn places(method: &Method<Draw>) -> Vec<[i32; 2]> {
    match method.name {
        "ordered-16" => (0..16).map(|n| [2 + 4 * (n % 4), 2 + 4 * (n / 4)]).collect(),
        _ => pattern(method.run.samples).to_vec(),
    }
}

/// The codes of a colour, as numbers.
pub(crate) fn codes(color: Color) -> [f64; 3] {
    [color.r, color.g, color.b].map(f64::from)
}

/// A triangle at one depth.
pub(crate) fn flat(corners: [[f32; 2]; 3], depth: f32, color: Color) -> Surface {
    Surface { corners: corners.map(|[x, y]| Vec3::new(x, y, depth)), color }
}

/// A triangle whose corners have depths of their own.
pub(crate) fn deep(corners: [[f32; 3]; 3], color: Color) -> Surface {
    Surface { corners: corners.map(Vec3::from), color }
}

/// Corners in the window.
pub(crate) type Corners = [[f32; 2]; 3];

/// Where an upright side is at x, all that is to the right of it in a picture.
pub(crate) fn right_of(x: f32) -> Corners {
    [[x, -50.0], [90.0, 3.0], [x, 56.0]]
}

/// Where a level side is at y, all that is above it in a picture.
pub(crate) fn above(y: f32) -> Corners {
    [[-50.0, y], [56.0, y], [3.0, 90.0]]
}

/// The two halves of a quadrangle, counterclockwise, on either side of the diagonal from its first corner.
pub(crate) fn halves([a, b, c, d]: [[f32; 2]; 4]) -> [Corners; 2] {
    [[a, b, c], [a, c, d]]
}

/// A rectangle as two triangles.
pub(crate) fn rectangle([left, bottom]: [f32; 2], [right, top]: [f32; 2]) -> [Corners; 2] {
    halves([[left, bottom], [right, bottom], [right, top], [left, top]])
}

/// Eight triangles about a point.
pub(crate) fn fan(hub: [f32; 2]) -> Vec<Corners> {
    let rim =
        [[8.2, 3.1], [7.4, 5.6], [5.1, 6.8], [2.3, 6.2], [0.9, 4.4], [1.1, 1.9], [3.6, 0.4], [6.6, 0.8]];
    (0..8).map(|n| [hub, rim[n], rim[(n + 1) % 8]]).collect()
}

/// A fan of twenty triangles, a few tenths of a pixel wide where they are widest.
pub(crate) fn slivers() -> Vec<Corners> {
    let end = |n: i32| [8.5, 0.7 + 0.29 * n as f32];
    (0..20).map(|n| [[0.5, 0.6], end(n), end(n + 1)]).collect()
}

/// Slanting strips a fifth of a pixel wide, each of two triangles.
pub(crate) fn strips() -> Vec<Corners> {
    let at = |n: i32| 0.6 + 0.2 * n as f32;
    (0..20)
        .flat_map(|n| halves([[0.7, at(n)], [8.4, at(n) + 1.7], [8.4, at(n + 1) + 1.7], [0.7, at(n + 1)]]))
        .collect()
}

/// Twelve by nine fields, about half a pixel wide, their corners moved about, each of two triangles.
pub(crate) fn grid() -> Vec<Corners> {
    let corner = |i: i32, j: i32| {
        // Up to a tenth of a pixel to either side.
        let moved = |n: i32| ((n * 37 + 11) % 21 - 10) as f32 / 100.0;
        [0.9 + 0.6 * i as f32 + moved(i + 5 * j), 0.7 + 0.6 * j as f32 + moved(3 * i + 7 * j)]
    };
    let field =
        |i: i32, j: i32| halves([corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]);
    (0..9).flat_map(|j| (0..12).flat_map(move |i| field(i, j))).collect()
}

/// Dark triangles, in two colours by turns, before a white background.
pub(crate) fn on_white(triangles: &[Corners]) -> Scene {
    let dark = [Color::rgb(60, 20, 10), Color::rgb(10, 40, 70)];
    let triangles =
        triangles.iter().enumerate().map(|(n, &corners)| flat(corners, 0.5, dark[n % 2])).collect();
    Scene { size: [9, 7], background: Color::WHITE, triangles }
}

/// A large yellow triangle and, drawn after it, a smaller blue one that reaches over its sides, at these depths.
pub(crate) fn pair(yellow: f32, blue: f32) -> Scene {
    let triangles = vec![
        flat([[0.6, 0.4], [8.3, 1.1], [3.4, 6.7]], yellow, Color::rgb(240, 200, 20)),
        flat([[2.2, 1.3], [8.8, 3.9], [2.6, 5.2]], blue, Color::rgb(20, 60, 220)),
    ];
    Scene { size: [9, 7], background: Color::BLACK, triangles }
}

/// Red behind white that fills the picture and was there first.
pub(crate) fn hidden() -> Scene {
    let white = flat([[-9.0, -9.0], [40.0, -9.0], [-9.0, 40.0]], 0.25, Color::WHITE);
    let red = flat([[2.2, 1.3], [8.8, 3.9], [2.6, 5.2]], 0.75, Color::RED);
    Scene { size: [9, 7], background: Color::BLACK, triangles: vec![white, red] }
}

/// Two dark halves that fill the picture, and behind them white, drawn last.
pub(crate) fn behind_a_side() -> Scene {
    let mut triangles =
        on_white(&halves([[-9.0, -11.0], [22.0, -9.0], [18.0, 20.0], [-8.0, 19.0]])).triangles;
    triangles.push(flat([[-9.0, -9.0], [40.0, -9.0], [-9.0, 40.0]], 0.75, Color::WHITE));
    Scene { size: [9, 7], background: Color::BLACK, triangles }
}

/// Two that pass through each other along a line that is steeper than any side.
pub(crate) fn through() -> Scene {
    let triangles = vec![
        deep([[0.6, 0.4, 0.1], [8.3, 1.1, 0.8], [3.4, 6.7, 0.2]], Color::rgb(240, 200, 20)),
        deep([[0.7, 5.2, 0.9], [1.9, 0.8, 0.6], [8.6, 4.6, 0.1]], Color::rgb(20, 60, 220)),
    ];
    Scene { size: [9, 7], background: Color::BLACK, triangles }
}

/// Three bars, each of which is before the next, and the last before the first.
pub(crate) fn circle() -> Scene {
    let bar = |corners: [[f32; 2]; 4], color: Color| {
        // Near at its first end, far at its second.
        halves(corners).map(|half| {
            let depth = |at: [f32; 2]| if at == corners[0] || at == corners[3] { 0.2 } else { 0.8 };
            deep(half.map(|at| [at[0], at[1], depth(at)]), color)
        })
    };
    let bars = [
        bar([[0.8, 1.2], [8.1, 0.9], [8.2, 2.4], [0.9, 2.7]], Color::rgb(240, 200, 20)),
        bar([[7.9, 0.6], [4.6, 6.7], [3.1, 6.1], [6.4, 0.3]], Color::rgb(20, 60, 220)),
        bar([[4.9, 6.6], [0.7, 1.6], [1.9, 0.8], [6.0, 5.7]], Color::rgb(30, 190, 60)),
    ];
    Scene { size: [9, 7], background: Color::BLACK, triangles: bars.concat() }
}

/// A level triangle, and one that passes through its depth within a pixel, in each row elsewhere.
pub(crate) fn steep() -> Scene {
    let triangles = vec![
        flat([[-9.0, -9.0], [40.0, -9.0], [-9.0, 40.0]], 0.5, Color::rgb(30, 190, 60)),
        deep([[3.1, -1.0, 0.0], [5.2, -1.0, 1.0], [4.3, 9.0, 0.1]], Color::rgb(250, 230, 240)),
    ];
    Scene { size: [9, 7], background: Color::BLACK, triangles }
}

/// White bars half a pixel wide, half a pixel apart.
pub(crate) fn stripes() -> Scene {
    let bars: Vec<Corners> =
        (0..8).flat_map(|n| rectangle([n as f32 + 0.5, 1.0], [n as f32 + 1.0, 6.0])).collect();
    let triangles = bars.into_iter().map(|bar| flat(bar, 0.5, Color::WHITE)).collect();
    Scene { size: [9, 7], background: Color::BLACK, triangles }
}
