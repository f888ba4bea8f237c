//! Lesson 3: triangles.

use common::{Bounds, DVec3, IVec2, Method, Vec2, Vec3};
use sheet::{AMBER, BLACK, BLUE, GREEN, GREY, Ink, MINT, ORANGE, PURPLE, ROSE, SKY, Sheet};
use triangles::barycentric::weights;
use triangles::edges::Setup;

use crate::few::Few;
use crate::input::named;
use crate::{Drawing, Figure, Input, Values, View, number};

/// A point and the three areas that it makes with the sides.
pub(crate) const AREAS: Figure = Figure {
    name: "triangles-areas",
    stays: false,
    hint: "Drag P, out of the triangle too, or a corner; or move it by the arrow keys.",
    inputs: &[
        corner("Corner A", [0.0, 0.0]),
        corner("Corner B", [6.0, 0.6]),
        corner("Corner C", [2.0, 3.8]),
        corner("Point P", [2.5, 1.5]),
    ],
    draw: areas,
};

const fn corner(label: &'static str, from: [f64; 2]) -> Input {
    Input::Point { label, from, low: [-1.0, -1.0], high: [8.0, 4.4], step: 0.1 }
}

/// Twice the area of a triangle: above 0 where it runs counterclockwise.
fn area([a, b, c]: [Vec2; 3]) -> f32 {
    (b - a).perp_dot(c - a)
}

fn areas(mut values: Values) -> View {
    let [a, b, c, p] = [values.point(), values.point(), values.point(), values.point()];
    let weights = weights([a, b, c], p);
    let parts = [
        ("A", "α", "PBC", [p, b, c], SKY, a),
        ("B", "β", "PCA", [p, c, a], AMBER, b),
        ("C", "γ", "PAB", [p, a, b], MINT, c),
    ];
    let whole = area([a, b, c]);
    let mut sheet = Sheet::new((-1.4, -1.4), (8.4, 4.8));
    // What pulls P out is seen through the others: its outline alone, over them.
    let is_negative = |part: [Vec2; 3]| area(part) * whole < 0.0;
    for (.., part, fill, _) in parts.into_iter().filter(|part| !is_negative(part.3)) {
        sheet.polygon(&part, fill, BLACK);
    }
    for (.., part, _, _) in parts.into_iter().filter(|part| is_negative(part.3)) {
        sheet.polygon(&part, "none", ORANGE);
    }
    sheet.polygon(&[a, b, c], "none", BLACK);
    let middle = (a + b + c) / 3.0;
    for (name, .., at) in parts {
        sheet.text(at + (at - middle).normalize_or_zero() * 0.42, name, BLACK);
    }
    sheet.text(p - Vec2::new(0.0, 0.42), "P", ORANGE);
    let shares = weights.map(|weights| weights.to_array());
    let share = |n: usize| shares.map_or("–".into(), |shares| number(shares[n]));
    for (_, weight, _, part, ..) in
        parts.into_iter().filter(|part| area(part.3).abs() > 3.0 && !is_negative(part.3))
    {
        sheet.text((part[0] + part[1] + part[2]) / 3.0, weight, BLACK);
    }
    let sign = |n: usize| match shares.map(|shares| shares[n]) {
        Some(share) if share > 0.0 => "+",
        Some(share) if share < 0.0 => "−",
        _ => "0",
    };
    let told = match shares {
        None => "The corners lie on one line: there is no area to have a share of.".into(),
        Some(shares) => format!(
            "P is {}: α = {}, β = {}, γ = {}.",
            if shares.iter().all(|&share| share >= 0.0) { "inside" } else { "outside" },
            share(0),
            share(1),
            share(2),
        ),
    };
    let mut table = vec![["", "twice the area", "sign", "share"].map(String::from).to_vec()];
    for (n, (_, weight, name, part, ..)) in parts.into_iter().enumerate() {
        table.push(vec![name.into(), number(area(part)), sign(n).into(), format!("{weight} = {}", share(n))]);
    }
    table.push(vec![
        "ABC".into(),
        number(whole),
        String::new(),
        if shares.is_some() { "1".into() } else { "–".into() },
    ]);
    View { drawing: Drawing::Sheet(sheet), told, table }
}

/// Two triangles with a common side, and three rules for the centres on it.
pub(crate) const TOP_LEFT: Figure = Figure {
    name: "triangles-top-left",
    stays: false,
    hint: "Drag a corner over the pixels' centres, or move it by the arrow keys. Choose another rule.",
    inputs: &[
        half_pixel("Lower left corner", [1.5, 1.5]),
        half_pixel("Lower right corner", [7.5, 1.5]),
        half_pixel("Upper right corner", [7.5, 7.5]),
        half_pixel("Upper left corner", [1.5, 7.5]),
        Input::Choice { label: "Rule", rows: || Method::rows(RULES), from: "top-left" },
    ],
    draw: top_left,
};

const fn half_pixel(label: &'static str, from: [f64; 2]) -> Input {
    Input::Point { label, from, low: [0.0, 0.0], high: [PIXELS.x as f64, PIXELS.y as f64], step: 0.5 }
}

/// Columns and rows of the grid.
const PIXELS: IVec2 = IVec2::new(12, 9);

/// Whether a centre is inside, by the three edge functions there and the triangle.
type Rule = fn(DVec3, &Setup) -> bool;

const RULES: &[Method<Rule>] = &[
    Method {
        name: "E ≥ 0",
        run: |edges, _| edges.cmpge(DVec3::ZERO).all(),
        promise: "no centre on a common side is left out",
        failure: "both triangles have it",
    },
    Method {
        name: "E > 0",
        run: |edges, _| edges.cmpgt(DVec3::ZERO).all(),
        promise: "no centre on a common side is drawn twice",
        failure: "neither triangle has it",
    },
    Method {
        name: "top-left",
        run: |edges, setup| edges.cmpge(setup.inside).all(),
        promise: "a centre on a common side has one owner",
        failure: "-",
    },
];

/// The pixels that a triangle has by a rule.
fn owned(corners: [Vec2; 3], rule: Rule) -> Vec<IVec2> {
    let Some(setup) = Setup::new(corners, Bounds { min: IVec2::ZERO, max: PIXELS - 1 }) else {
        return Vec::new();
    };
    let Bounds { min, max } = setup.bounds;
    let pixels = (min.y..=max.y).flat_map(|y| (min.x..=max.x).map(move |x| IVec2::new(x, y)));
    let edges = |pixel: IVec2| {
        let steps = (pixel - min).as_dvec2();
        setup.edges + setup.right * steps.x + setup.up * steps.y
    };
    pixels.filter(|&pixel| rule(edges(pixel), &setup)).collect()
}

fn top_left(mut values: Values) -> View {
    let [a, b, c, d] = [values.point(), values.point(), values.point(), values.point()];
    let rule = values.choice(named!(RULES));
    let halves = [[a, b, c], [a, c, d]];
    let [first, second] = halves.map(|half| owned(half, rule.run));
    let [ours, theirs] = halves.map(|half| owned(half, RULES[2].run));
    let mut sheet = Sheet::new((-0.5, -0.5), PIXELS.as_vec2() + 0.5);
    sheet.grid((0, 0), PIXELS.into());
    let (mut twice, mut neither) = (0, 0);
    for pixel in (0..PIXELS.y).flat_map(|y| (0..PIXELS.x).map(move |x| IVec2::new(x, y))) {
        let fill: Option<Ink> = match (first.contains(&pixel), second.contains(&pixel)) {
            (true, true) => Some(ROSE),
            (true, false) => Some(SKY),
            (false, true) => Some(AMBER),
            (false, false) => None,
        };
        let lost = fill.is_none() && (ours.contains(&pixel) || theirs.contains(&pixel));
        twice += i32::from(fill == Some(ROSE));
        neither += i32::from(lost);
        if let Some(fill) = fill {
            sheet.pixel(pixel.x, pixel.y, fill);
        }
        sheet.dot(pixel.as_vec2() + 0.5, if lost { ORANGE } else { GREY });
    }
    halves.iter().for_each(|half| sheet.polygon(half, "none", BLACK));
    let told = format!(
        "{}: {} pixels are the one triangle's (blue), {} the other's (amber); {twice} of them are both's (rose), {neither} \
         that one should have are neither's (orange centre).",
        rule.name,
        first.len(),
        second.len(),
    );
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}

/// The signs of the three edge functions, all over the plane.
pub(crate) const SIGN: Figure = Figure {
    name: "triangles-sign",
    stays: false,
    hint: "Drag P or a corner, or move it by the arrow keys. What happens when the corners run clockwise?",
    inputs: &[
        in_plane("Corner A", [-1.6, -1.0]),
        in_plane("Corner B", [1.9, -0.6]),
        in_plane("Corner C", [-0.2, 1.7]),
        in_plane("Point P", [0.2, -0.1]),
    ],
    draw: sign,
};

const fn in_plane(label: &'static str, from: [f64; 2]) -> Input {
    Input::Point { label, from, low: [-4.0, -2.4], high: [4.0, 2.6], step: 0.1 }
}

fn sign(mut values: Values) -> View {
    /// Places of the map along x and y.
    const MAP: [i32; 2] = [22, 13];
    const LOW: Vec2 = Vec2::new(-4.4, -2.6);
    const STEP: f32 = 0.4;
    let corners = [values.point(), values.point(), values.point()];
    let p = values.point();
    let edge = |n: usize, at: Vec2| area([corners[n], corners[(n + 1) % 3], at]);
    let signs = |at: Vec2| [0, 1, 2].map(|n| if edge(n, at) > 0.0 { "+" } else { "−" });
    let mut sheet = Sheet::new(LOW, LOW + Vec2::new(MAP[0] as f32, MAP[1] as f32) * STEP);
    let mut regions: Few<[&str; 3], Vec<Vec2>> = Few::new();
    for (x, y) in (0..MAP[1]).flat_map(|y| (0..MAP[0]).map(move |x| (x, y))) {
        let low = LOW + Vec2::new(x as f32, y as f32) * STEP;
        let signs = signs(low + STEP / 2.0);
        regions.of(signs).push(low + STEP / 2.0);
        // As many minuses, as far from the inside.
        let fill = match signs.into_iter().filter(|&sign| sign == "−").count() {
            0 => Some(SKY),
            1 => None,
            2 => Some(AMBER),
            _ => Some(ROSE),
        };
        if let Some(fill) = fill {
            sheet.rectangle(low, low + STEP, fill, "none");
        }
    }
    // P tells those of its own region.
    for (region, places) in regions.all().iter().filter(|(region, _)| *region != signs(p)) {
        let middle = places.iter().sum::<Vec2>() / places.len() as f32;
        sheet.text(middle, &region.join(" "), GREY);
    }
    for n in 0..3 {
        let (from, to) = (corners[n], corners[(n + 1) % 3]);
        let along = (to - from).normalize_or_zero() * 1.35;
        sheet.dashed(from - along, to + along, GREY, 1.5);
    }
    for (n, ink) in [BLUE, ORANGE, GREEN].into_iter().enumerate() {
        sheet.arrow(corners[n], corners[(n + 1) % 3], ink);
    }
    let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    for (corner, name) in corners.into_iter().zip(["A", "B", "C"]) {
        sheet.text(corner + (corner - middle).normalize_or_zero() * 0.38, name, BLACK);
    }
    sheet.text(p - Vec2::new(0.0, 0.38), &format!("P  {}", signs(p).join(" ")), BLACK);
    let values = ["AB", "BC", "CA"].into_iter().enumerate();
    let values: Vec<String> =
        values.map(|(n, side)| format!("E of {side} is {}", number(edge(n, p)))).collect();
    let way = if edge(0, corners[2]) > 0.0 { "counterclockwise" } else { "not counterclockwise" };
    let told = format!("The corners run {way}. At P, {}: {}.", values.join(", "), signs(p).join(" "));
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}

/// The sweep, row by row.
pub(crate) const SWEEP: Figure = Figure {
    name: "triangles-sweep",
    stays: false,
    hint: "Drag a corner, or move it by the arrow keys. Move the slider up, row by row.",
    inputs: &[
        whole_pixel("Corner A", [1.5, 1.5]),
        whole_pixel("Corner B", [15.5, 5.5]),
        whole_pixel("Corner C", [5.5, 10.5]),
        Input::Slider {
            label: "Rows filled, from the lowest",
            from: 11.0,
            range: [0.0, SWEPT.y as f64],
            step: 1.0,
        },
    ],
    draw: sweep,
};

/// Columns and rows of the sweep's grid.
const SWEPT: IVec2 = IVec2::new(17, 12);

const fn whole_pixel(label: &'static str, from: [f64; 2]) -> Input {
    Input::Point {
        label,
        from,
        low: [0.5, 0.5],
        high: [SWEPT.x as f64 - 0.5, SWEPT.y as f64 - 0.5],
        step: 1.0,
    }
}

fn sweep(mut values: Values) -> View {
    let centers = [values.point(), values.point(), values.point()];
    let rows = values.number() as i32;
    // The sweep's corners are whole pixels, which it rounds to.
    let corners = centers.map(Vec2::floor);
    let mut visits: Few<(i32, i32), u32> = Few::new();
    let mut ends: Few<i32, Option<[i32; 2]>> = Few::new();
    triangles::slides::sweep(corners, Bounds { min: IVec2::ZERO, max: SWEPT - 1 }, |x, y, _| {
        if y < rows {
            *visits.of((x, y)) += 1;
            let [left, right] = ends.of(y).get_or_insert([x; 2]);
            (*left, *right) = (x.min(*left), x.max(*right));
        }
    });
    let heights = Vec3::from_array(corners.map(|corner| corner.y));
    let middle = heights.element_sum() - heights.min_element() - heights.max_element();
    let mut sheet = Sheet::new(Vec2::ZERO, SWEPT.as_vec2());
    sheet.grid((0, 0), SWEPT.into());
    for &((x, y), times) in visits.all() {
        let half = if (y as f32) < middle { SKY } else { AMBER };
        sheet.pixel(x, y, if times > 1 { ROSE } else { half });
    }
    sheet.polygon(&centers, "none", BLACK);
    let height = middle + 0.5;
    sheet.dashed((0.2, height), (SWEPT.x as f32 - 0.2, height), PURPLE, 2.0);
    let twice = visits.all().iter().filter(|(_, times)| *times > 1).count();
    let row = match ends.all().iter().max() {
        Some((y, Some([left, right]))) => format!("the last one, row {y}, goes from x = {left} to {right}"),
        _ => "no row yet".into(),
    };
    let told = format!(
        "{} rows are filled, {row}; {} pixels, {twice} of them twice, since the row of the middle corner belongs to both halves.",
        ends.all().len(),
        visits.all().len(),
    );
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the rule that the lesson's `fill` has, what is drawn here is what it draws.
    #[test]
    fn top_left_is_the_lessons() {
        for corners in [[(1.5, 1.5), (7.5, 1.5), (7.5, 7.5)], [(0.0, 8.5), (11.5, 3.0), (4.5, 4.5)]] {
            let corners = corners.map(Vec2::from);
            let mut filled = Vec::new();
            let bounds = Bounds { min: IVec2::ZERO, max: PIXELS - 1 };
            triangles::fill(corners, bounds, |x, y, _| filled.push(IVec2::new(x, y)));
            assert_eq!(owned(corners, RULES[2].run), filled);
        }
    }
}
