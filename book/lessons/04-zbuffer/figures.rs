//! Chapter 4: the nearest surface.

use common::{Color, Format, Image, Vec2, Vec3};
use triangles::{draw_model, fill, flat_intensity};
use zbuffer::{DepthBuffer, METHODS, Surface, depth_at, fill_nearest, surfaces, z_f32};

use crate::figures::picture::{all_beside, beside, canvas, method, model};
use crate::figures::sheet::{BLACK, BLUE, FAINT, GREEN, GREY, Ink, ORANGE, PALE, SKY, Sheet};
use crate::figures::{Drawing, Figure};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "zbuffer-head",
        "The head, lit from the front, and beside it the same in greys of depth: the nose is white, the shoulders \
         are dark.",
        head,
    ),
    Figure::new(
        "zbuffer-before",
        "The head twice. On the left the eyeballs, the inside of the mouth and the backs of the ears shine \
         through; on the right they are hidden.",
        before,
    ),
    Figure::new(
        "zbuffer-top",
        "Three surfaces seen from above, as lines that slant and cross. Where a line is the nearest one to the \
         viewer below, it is bold.",
        from_above,
    ),
    Figure::new(
        "zbuffer-steps",
        "Three rows of bars, a bar for each pixel, after each of three surfaces is drawn. Bars grow where a \
         nearer surface comes and stay where a farther one does.",
        steps,
    ),
    Figure::new(
        "zbuffer-plane",
        "A triangle lies on the ground; above its corners stand posts of different heights, and a slanting \
         triangle rests on them. A fourth post rises to it from a point inside.",
        plane,
    ),
    Figure::new(
        "zbuffer-numbers",
        "A triangle on a grid with its depth written into each covered pixel. A step to the right adds 2, a step \
         up takes 1 away.",
        numbers,
    ),
    Figure::new(
        "zbuffer-cut",
        "Two triangles that cut each other. On the left one of them covers the other completely, on the right \
         each is in front in its half.",
        || compared(&["painter", "z-f32"], &cutting(), 150),
    ),
    Figure::new(
        "zbuffer-cycle",
        "Three bars, each over the next one and under the one before. On the left the circle is broken: one bar \
         lies over both others.",
        || compared(&["painter", "z-f32"], &cycle(), 150),
    ),
    Figure::new(
        "zbuffer-long",
        "A large slanting triangle and a small one before its far end. On the left the large one hides the small \
         one.",
        || compared(&["painter", "z-f32"], &long(), 150),
    ),
    Figure::new(
        "zbuffer-levels",
        "Two axes of depth from minus one to one. On the upper one marks are evenly spaced; on the lower one they \
         crowd around zero.",
        levels,
    ),
    Figure::new(
        "zbuffer-fighting",
        "Two parallel surfaces, close together, by three methods. With z16 they show in stripes; with z24 and \
         z-f32 only the nearer one is seen.",
        || compared(&["z16", "z24", "z-f32"], &slanting(4e-6), 200),
    ),
    Figure::new(
        "zbuffer-coplanar",
        "Two triangles in one slanting plane. Where they overlap, z16 shows specks of the second one, and z-f32 \
         stripes of it.",
        || compared(&["z16", "z-f32"], &coplanar(), 100),
    ),
];

const COLORS: [Color; 3] = [Color::rgb(86, 160, 211), Color::rgb(242, 193, 78), Color::rgb(213, 94, 0)];

fn head() -> anyhow::Result<Drawing> {
    let mut image = canvas(600);
    let depths = z_f32(&surfaces(&model()?, Vec3::Z, &image), &mut image);
    beside([&image, &depths.picture()])
}

/// Lesson 3's picture and lesson 4's.
fn before() -> anyhow::Result<Drawing> {
    let model = model()?;
    let [mut before, mut after] = [(); 2].map(|()| canvas(600));
    draw_model(&model, method(triangles::METHODS, "edges")?, &mut before, |_, corners| {
        Some(flat_intensity(corners, Vec3::Z)).filter(|&i| i >= 0.0).map(Color::gray)
    });
    z_f32(&surfaces(&model, Vec3::Z, &after), &mut after);
    beside([&before, &after])
}

/// How many pixels the row of the next two figures has.
const ROW: u16 = 24;

/// Surfaces seen from above: two ends, x in pixels and depth, and a colour.
const ABOVE: [([Vec2; 2], Ink, &str); 3] = [
    ([Vec2::new(3.0, 1.2), Vec2::new(17.0, 1.2)], BLUE, "blue"),
    ([Vec2::new(10.0, 0.4), Vec2::new(22.0, 2.6)], GREEN, "green"),
    ([Vec2::new(1.0, 2.4), Vec2::new(14.0, 0.2)], ORANGE, "red"),
];

/// Draws such a surface into a picture of one row; calls `visit` where it is seen.
fn draw_above([from, to]: [Vec2; 2], depths: &mut DepthBuffer<f32>, mut visit: impl FnMut(usize)) {
    let corner = |end: Vec2, y: f32| Vec3::new(end.x, y, end.y);
    let [a, b, c, d] = [corner(from, -9.0), corner(to, -9.0), corner(to, 9.0), corner(from, 9.0)];
    for corners in [[a, b, c], [a, c, d]] {
        fill_nearest(corners, depths, |depth| depth, |x, _, _| visit(x as usize));
    }
}

fn row() -> DepthBuffer<f32> {
    DepthBuffer::new(&Image::new(ROW, 1, Format::Gray), f32::NEG_INFINITY)
}

fn from_above() -> anyhow::Result<Drawing> {
    // The viewer is below: what is near is low.
    let stretch = 3.2;
    let place = |x: f32, depth: f32| Vec2::new(x, -depth * stretch);
    let mut sheet = Sheet::new((-1.0, -13.0), (25.0, 1.0));
    let mut depths = row();
    let mut seen = [None; ROW as usize];
    for (n, &(ends, ink, _)) in ABOVE.iter().enumerate() {
        let [from, to] = ends.map(|end| place(end.x, end.y));
        sheet.line(from, to, ink, 1.5);
        draw_above(ends, &mut depths, |x| seen[x] = Some(n));
    }
    for (x, surface) in seen.iter().enumerate() {
        let Some(n) = surface else { continue };
        let ([from, to], ink, _) = ABOVE[*n];
        let at = |x: f32| place(x, from.y + (x - from.x) / (to.x - from.x) * (to.y - from.y));
        let left = x as f32;
        sheet.line(at(left), at(left + 1.0), ink, 6.0);
    }
    for x in [2.0, 5.0, 8.0, 11.0] {
        sheet.arrow((x, -12.6), (x, -10.8), GREY);
    }
    sheet.text_right_of((12.5, -11.7), "you look from here", GREY);
    sheet.text((2.0, 0.2), "far", GREY);
    sheet.finish()
}

fn steps() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.0, -0.6), (25.0, 17.4));
    let mut depths = row();
    let mut inks = [FAINT; ROW as usize];
    for (n, &(ends, ink, name)) in ABOVE.iter().enumerate() {
        draw_above(ends, &mut depths, |x| inks[x] = ink);
        let floor = (2 - n) as f32 * 6.0;
        for (x, fill) in inks.iter().enumerate() {
            let depth = depths.get(x as i32, 0);
            let (left, top) = (x as f32 + 0.08, floor + depth.max(0.0) * 1.5);
            if depth.is_finite() {
                sheet.rectangle((left, floor), (left + 0.84, top), fill, "none");
            }
        }
        sheet.line((0.0, floor), (24.0, floor), BLACK, 1.5);
        let words = format!("{}the {name} one", if n == 0 { "after " } else { "then " });
        sheet.text((12.0, floor + 4.8), &words, ink);
    }
    sheet.finish()
}

fn plane() -> anyhow::Result<Drawing> {
    // Ground coordinates, drawn slantwise.
    let ground = |x: f32, y: f32| Vec2::new(x + 0.45 * y, 0.42 * y);
    let up = |at: Vec2, z: f32| at + Vec2::new(0.0, z);
    let corners = [(0.0, 0.4, 0.9, "A"), (6.0, 0.0, 2.4, "B"), (1.6, 4.0, 1.5, "C")];
    let mut sheet = Sheet::new((-0.9, -0.5), (7.1, 4.0));
    let low = corners.map(|(x, y, ..)| ground(x, y));
    let high = corners.map(|(x, y, z, _)| up(ground(x, y), z));
    sheet.polygon(&low, PALE, GREY);
    let weights = Vec3::new(0.3, 0.4, 0.3);
    let mean = |points: [Vec2; 3]| points[0] * weights.x + points[1] * weights.y + points[2] * weights.z;
    let depth = depth_at(Vec3::new(0.9, 2.4, 1.5), weights);
    let p = mean(low);
    sheet.line(low[2], high[2], GREY, 2.0);
    sheet.polygon(&high, SKY, BLUE);
    sheet.line(low[0], high[0], GREY, 2.0);
    sheet.line(low[1], high[1], GREY, 2.0);
    sheet.dashed(p, up(p, depth), ORANGE, 2.4);
    sheet.dot(p, ORANGE);
    sheet.dot(up(p, depth), ORANGE);
    for (n, (_, _, z, name)) in corners.into_iter().enumerate() {
        let away = [Vec2::new(-0.35, 0.0), Vec2::new(0.3, 0.0), Vec2::new(0.0, -0.25)][n];
        sheet.text(low[n] + if n == 2 { Vec2::new(0.35, 0.1) } else { away }, name, BLACK);
        let beside = [Vec2::new(-0.45, 0.1), Vec2::new(0.45, 0.1), Vec2::new(0.0, 0.3)][n];
        sheet.text(high[n] + beside, &format!("{z:.1}"), BLUE);
    }
    sheet.text(p + Vec2::new(0.3, -0.1), "P", ORANGE);
    sheet.text(up(p, depth) + Vec2::new(0.45, 0.15), &format!("{depth:.2}"), ORANGE);
    sheet.finish()
}

fn numbers() -> anyhow::Result<Drawing> {
    let corners =
        [(0.5, 0.5), (10.5, 1.5), (3.5, 6.5)].map(|(x, y): (f32, f32)| Vec3::new(x, y, 2.0 * x - y + 10.5));
    let mut sheet = Sheet::new(Vec2::ZERO, (11.0, 7.0));
    sheet.grid((0, 0), (11, 7));
    let z = Vec3::from_array(corners.map(|corner| corner.z));
    let mut found = Vec::new();
    let bounds = Image::new(11, 7, Format::Gray).bounds();
    fill(corners.map(Vec3::truncate), bounds, |x, y, weights| found.push((x, y, depth_at(z, weights))));
    sheet.pixels(found.iter().map(|&(x, y, _)| (x, y)), SKY);
    sheet.polygon(&corners.map(Vec3::truncate), "none", BLACK);
    for (x, y, depth) in found {
        sheet.text((x as f32 + 0.5, y as f32 + 0.5), &format!("{depth:.0}"), BLACK);
    }
    sheet.finish()
}

/// Scenes by methods, side by side.
fn compared(names: &[&str], scene: &[[Vec3; 3]], side: u16) -> anyhow::Result<Drawing> {
    let colored = scene.iter().zip(COLORS.iter().cycle());
    let surfaces: Vec<Surface> = colored.map(|(&corners, &color)| Surface { corners, color }).collect();
    all_beside(names.iter().map(|name| {
        let mut image = canvas(side);
        (method(METHODS, name)?.draw)(&surfaces, &mut image);
        Ok(image)
    }))
}

fn cutting() -> Vec<[Vec3; 3]> {
    let one = [(8.0, 20.0), (140.0, 40.0), (50.0, 140.0)].map(|(x, y)| Vec3::new(x, y, x / 150.0 - 0.5));
    let other = [(20.0, 120.0), (35.0, 8.0), (144.0, 95.0)].map(|(x, y)| Vec3::new(x, y, 0.45 - x / 150.0));
    vec![one, other]
}

/// Three bars, each over the next one at one end and under it at the other.
fn cycle() -> Vec<[Vec3; 3]> {
    let bar = |turn: u8| {
        [(-70.0, -52.0, 0.4), (-58.0, -12.0, 0.4), (68.0, -27.0, -0.8)].map(|(x, y, z)| {
            let third = Vec2::from_angle(std::f32::consts::TAU / 3.0 * f32::from(turn));
            (third.rotate(Vec2::new(x, y)) * 0.84 + 75.0).extend(z)
        })
    };
    vec![bar(0), bar(1), bar(2)]
}

fn long() -> Vec<[Vec3; 3]> {
    vec![
        [Vec3::new(8.0, 10.0, -1.0), Vec3::new(142.0, 10.0, 1.0), Vec3::new(142.0, 140.0, 1.0)],
        [Vec3::new(12.0, 34.0, -0.5), Vec3::new(88.0, 6.0, -0.5), Vec3::new(50.0, 96.0, -0.5)],
    ]
}

/// Two parallel planes, the far one drawn first, in a scene whose depth goes from −1 to 1.
fn slanting(distance: f32) -> Vec<[Vec3; 3]> {
    let plane = |corners: [(f32, f32); 3], nearer: f32| {
        corners.map(|(x, y)| Vec3::new(x, y, x / 1700.0 - y / 2300.0 + nearer))
    };
    let beside = |depth: f32| [(-9.0, 0.0), (-8.0, 0.0), (-8.0, 1.0)].map(|(x, y)| Vec3::new(x, y, depth));
    let far = plane([(10.0, 20.0), (190.0, 40.0), (70.0, 190.0)], 0.0);
    let near = plane([(30.0, 170.0), (60.0, 12.0), (192.0, 130.0)], distance);
    vec![far, near, beside(-1.0), beside(1.0)]
}

fn coplanar() -> Vec<[Vec3; 3]> {
    let plane = |corners: [(f32, f32); 3]| corners.map(|(x, y)| Vec3::new(x, y, (x + y) / 190.0 - 0.7));
    vec![plane([(5.3, 10.1), (95.2, 20.4), (35.7, 95.5)]), plane([(15.1, 85.3), (30.6, 6.2), (96.4, 65.9)])]
}

/// The numbers of a tiny fixed-point format and of a tiny floating-point format.
fn levels() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.08, -0.22), (1.08, 0.82));
    let mut axis = |y: f32, numbers: &[f32], ink: Ink, words: &str| {
        sheet.line((-1.0, y), (1.0, y), GREY, 1.5);
        for &number in numbers {
            sheet.line((number, y - 0.05), (number, y + 0.05), ink, 2.0);
        }
        sheet.text((0.0, y + 0.17), words, ink);
    };
    let even: Vec<f32> = (0..=32_u8).map(|n| f32::from(n) / 16.0 - 1.0).collect();
    // Two bits behind the leading one, and four exponents; below, what is left.
    let mut floats: Vec<f32> =
        (1..=4).flat_map(|e| (4..8_u8).map(move |m| f32::from(m) / 8.0 / 2f32.powi(e - 1))).collect();
    floats.extend([1.0, 0.0, 1.0 / 64.0, 1.0 / 32.0, 3.0 / 64.0]);
    let mirrored: Vec<f32> = floats.iter().flat_map(|&n| [n, -n]).collect();
    axis(0.5, &even, BLUE, "levels: evenly spaced");
    axis(0.0, &mirrored, ORANGE, "floats: finest near 0");
    for (x, name) in [(-1.0, "−1"), (0.0, "0"), (1.0, "1")] {
        sheet.text((x, -0.15), name, BLACK);
    }
    sheet.finish()
}
