//! Lesson 15: the share of a pixel that a triangle covers.

use antialiasing::area::{area, clipped};
use antialiasing::coverage;
use antialiasing::pattern::{PATTERNS, PLACES, Place};
use common::{IVec2, Vec2, Vec4Swizzles};
use sheet::{AMBER, BLACK, BLUE, FAINT, GREY, ORANGE, Sheet};

use crate::{Drawing, Figure, Input, Values, View, number, whole};

/// The samples of a pixel under an edge.
pub(crate) const EDGE: Figure = Figure {
    name: "antialiasing-patterns",
    stays: false,
    hint: "Turn the edge, and move it across the pixel.",
    inputs: &[
        Input::Slider {
            label: "Angle of the edge, in degrees",
            from: 20.0,
            range: [-180.0, 180.0],
            step: 1.0,
        },
        Input::Slider { label: "From the middle, in px", from: 0.1, range: [-0.7, 0.7], step: 0.01 },
    ],
    draw: edge,
};

/// The middles of 4×4 squares.
const GRID: [Place; 16] = {
    let mut places = [[0; 2]; 16];
    let mut n = 0;
    while n < 16 {
        places[n] = [2 + 4 * (n as i32 % 4), 2 + 4 * (n as i32 / 4)];
        n += 1;
    }
    places
};

fn edge(mut values: Values) -> View {
    let [degrees, off] = [values.number(), values.number()];
    // A triangle so large that of its sides only this one comes near the pixel.
    let along = Vec2::from_angle(degrees.to_radians());
    let on_edge = Vec2::splat(0.5) + along.perp() * off;
    let corners = [on_edge - along * 40.0, on_edge - along.perp() * 40.0, on_edge + along * 40.0];
    let part: Vec<Vec2> = clipped(corners, IVec2::ZERO)
        .corners()
        .iter()
        .map(|corner| corner.position.xy() * PLACES as f32)
        .collect();
    let patterns = PATTERNS.into_iter().chain([&GRID[..]]);
    let names = ["1", "2", "4", "8", "16", "4 × 4"];
    let mut sheet = Sheet::new((-0.5, -4.0), (58.5, 39.5));
    let mut counts = Vec::new();
    for (n, (pattern, name)) in patterns.zip(names).enumerate() {
        let low = Vec2::new(21.0 * (n % 3) as f32, if n < 3 { 22.0 } else { 0.0 });
        sheet.polygon(&part.iter().map(|&corner| low + corner).collect::<Vec<_>>(), AMBER, "none");
        sheet.rectangle(low, low + 16.0, "none", GREY);
        for line in 1..PLACES {
            let line = line as f32;
            sheet.line(low + Vec2::new(line, 0.0), low + Vec2::new(line, 16.0), FAINT, 0.8);
            sheet.line(low + Vec2::new(0.0, line), low + Vec2::new(16.0, line), FAINT, 0.8);
        }
        let mask = coverage(corners, IVec2::ZERO, pattern);
        for (s, &[x, y]) in pattern.iter().enumerate() {
            sheet.dot(low + Vec2::new(x as f32, y as f32), if mask >> s & 1 == 1 { BLUE } else { GREY });
        }
        let count = format!("{} of {}", mask.count_ones(), pattern.len());
        sheet.text(
            low + Vec2::new(8.0, -2.2),
            &format!("{name}: {count}"),
            if n == 5 { ORANGE } else { BLACK },
        );
        counts.push(count);
    }
    let told = format!(
        "The edge at {}° covers {} of the pixel (amber). Of the samples it covers {} (blue); of the grid {}.",
        whole(degrees),
        number(area(corners, IVec2::ZERO) as f32),
        counts[..5].join(", "),
        counts[5],
    );
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}
