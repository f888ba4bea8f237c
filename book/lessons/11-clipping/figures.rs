//! Chapter 11: every triangle, wherever the eye is.

use std::path::Path;

use anyhow::Context;
use clipping::assembly::Topology;
use clipping::clip::cut;
use clipping::mesh::indexed;
use clipping::plane::{PLANES, distance};
use clipping::render::Clipping;
use clipping::{ClipVertex, Cull, METHODS, Mesh, Polygon, SLABS, clip, draw};
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec2, Vec3, Vec4, Vec4Swizzles};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use shaders::Uniforms;
use textures::Wrap;
use triangles::fill;

use crate::figures::picture::{all_beside, canvas, method, model, painted, texture};
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, ORANGE, PALE, PAPER, SKY, Sheet};
use crate::figures::{Drawing, Figure};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "clipping-head",
        "A head on a chequered floor, from close above the floor, twice. On the left the near part of the floor is \
         missing; on the right it reaches to the lower border of the picture.",
        head,
    ),
    Figure::new(
        "clipping-steps",
        "A column of boxes with arrows between them: vertices and their numbers, triangles, triangles that face the eye, \
         polygons in the frustum, triangles in the window. The arrows are called assembly, culling, clipping, and \
         division and viewport.",
        steps,
    ),
    Figure::new(
        "clipping-assembly",
        "Seven numbered points three times. As a list they make two triangles, and one point is left over; as a strip \
         five triangles in a row; as a fan five triangles about the first point.",
        assembly,
    ),
    Figure::new(
        "clipping-facing",
        "A box from above, and an eye before it. The normal of the near side and the way from there to the eye enclose a \
         small angle, those of the far side an angle of more than a right one.",
        of_facing,
    ),
    Figure::new(
        "clipping-flip",
        "From the side: an eye, the picture before it, and an edge of the floor that leads from a point in front of the \
         eye to one behind it. The line through the eye and the point behind it meets the picture above the horizon. The \
         edge's image goes from the other point down, and from above down to this one.",
        flip,
    ),
    Figure::new(
        "clipping-planes",
        "Axes x and w, and two lines through the origin, w = x and w = −x. Above both is what is seen. Below both is \
         nothing that fulfils a condition.",
        planes,
    ),
    Figure::new(
        "clipping-cases",
        "A plane and an edge, four times. The edge is inside, and its first corner is marked; it leaves, and its first \
         corner and the cut are marked; it is outside, and nothing is marked; it enters, and the cut is marked.",
        cases,
    ),
    Figure::new(
        "clipping-polygon",
        "A square picture and a triangle that is larger, four times. The triangle is cut at the left side, then at the \
         right, the lower and the upper one, and has 4, 5, 6 and 7 corners.",
        polygon,
    ),
    Figure::new(
        "clipping-cracks",
        "A floor of triangles that meet far behind the eye, twice. On the left black wedges gape between them; on the \
         right the floor is whole.",
        cracks,
    ),
    Figure::new(
        "clipping-band",
        "A small rectangle, the picture, in the middle of a larger one, the guard band. A triangle inside of the picture, \
         one across its border and one beside it lie in the band; a fourth reaches from the picture out of the band.",
        band,
    ),
    Figure::new(
        "clipping-culled",
        "A head, and in orange what of it faces away: the inside of its far side, the backs of the eyes, the inside of the nose and \
         the mouth.",
        culled,
    ),
    Figure::new("clipping-inside", "The inside of a head: the face from behind, without a gap.", inside),
    Figure::new(
        "clipping-divided",
        "A floor in strips that reaches from before the eye to the horizon, and the same with a sky full of torn strips.",
        divided,
    ),
    Figure::new(
        "clipping-turned",
        "A head, and the same head's far side from inside, where the near one should be.",
        turned,
    ),
];

/// The camera of the lesson's picture.
pub(crate) const EYE: Vec3 = Vec3::new(1.7, -0.72, 2.5);
pub(crate) const CENTER: Vec3 = Vec3::new(0.0, -0.2, 0.0);
const LIGHT: Vec3 = Vec3::new(0.4, 0.8, 0.8);

/// All that the lesson's look needs.
pub(crate) const ALL: Attributes = Attributes { normals: true, uvs: true };

/// A model with its mesh.
type Subject = (Loaded, Mesh);

fn subject(model: Model, texture: Image, wrap: Wrap) -> Subject {
    let loaded = Loaded::new(model, texture, wrap);
    let mesh = indexed(&loaded.model, &loaded.normals, ALL);
    (loaded, mesh)
}

fn of_head() -> anyhow::Result<Subject> {
    Ok(subject(model()?, texture()?, Wrap::Clamp))
}

pub(crate) fn floor() -> anyhow::Result<Subject> {
    let [model, texture] = SLABS.map(Path::new);
    Ok(subject(Model::read(model, ALL)?, Image::read(texture)?, Wrap::Repeat))
}

/// To clip space from an eye, for a square picture.
pub(crate) fn to_clip(fov: f32, eye: Vec3, center: Vec3) -> anyhow::Result<Mat4> {
    let view = view(eye, center, Vec3::Y).context("the eye is at the centre")?;
    Ok(perspective(fov, 1.0, 0.1, 100.0)? * view)
}

/// A square picture of subjects, drawn three times as large, so that it is smooth.
fn picture(
    subjects: &[Subject],
    (cull, clipping): (Cull, Clipping),
    (light, to_clip): (Vec3, Mat4),
    side: u16,
) -> Image {
    let mut image = canvas(3 * side);
    let models: Vec<(Uniforms, &Mesh)> =
        subjects.iter().map(|(loaded, mesh)| (loaded.uniforms(light.normalize(), to_clip), mesh)).collect();
    draw(&models, cull, clipping, &mut image);
    image.scale(side, side)
}

fn head() -> anyhow::Result<Drawing> {
    let subjects = [of_head()?, floor()?];
    all_beside(["leave-out", "guard-band"].map(|name| {
        let way = (Cull::Back, *method(METHODS, name)?);
        Ok(picture(&subjects, way, (LIGHT, to_clip(45.0, EYE, CENTER)?), 450))
    }))
}

fn steps() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-2.9, -8.9), (9.3, 0.7));
    let at = Vec2::new;
    let steps = [
        (AMBER, "vertices", "in clip space, and numbers", "assembly"),
        (SKY, "triangles", "three vertices each", "culling"),
        (SKY, "those that face us", "some half of them", "clipping"),
        (SKY, "polygons", "inside of the frustum", "÷ w, viewport"),
        (SKY, "triangles in pixels", "for the fill of lesson 10", ""),
    ];
    for (n, (fill, name, what, next)) in steps.iter().enumerate() {
        let center = at(0.0, -2.0 * n as f32);
        sheet.labelled(center, at(2.5, 0.5), fill, name);
        sheet.text_right_of(center + at(2.9, 0.0), what, GREY);
        if !next.is_empty() {
            sheet.arrow(center - at(0.0, 0.5), center - at(0.0, 1.47), BLACK);
            sheet.text_right_of(
                center + at(0.35, -1.0),
                next,
                if *next == "÷ w, viewport" { ORANGE } else { BLUE },
            );
        }
    }
    sheet.finish()
}

fn assembly() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.45, -1.15), (13.6, 3.0));
    let numbers: Vec<u32> = (0..7).collect();
    let around = |n: u32| Vec2::from_angle((180.0 - 36.0 * (n as f32 - 1.0)).to_radians()) * 2.0;
    let list = [(0.0, 0.1), (1.5, 0.0), (0.5, 1.4), (2.0, 1.5), (3.3, 1.1), (2.9, 2.5), (3.4, 0.1)];
    let places: [(&str, Topology, f32, Vec<Vec2>); 3] = [
        ("list", Topology::List, 1.7, list.map(Vec2::from).to_vec()),
        (
            "strip",
            Topology::Strip,
            6.35,
            (0..7).map(|n| Vec2::new(4.7 + 0.55 * n as f32, [0.3, 2.1][n % 2])).collect(),
        ),
        (
            "fan",
            Topology::Fan,
            11.2,
            (0..7).map(|n| Vec2::new(11.2, 0.1) + if n == 0 { Vec2::ZERO } else { around(n) }).collect(),
        ),
    ];
    for (name, topology, middle, points) in places {
        for triangle in topology.triangles(&numbers) {
            sheet.polygon(&triangle.map(|n| points[n as usize]), SKY, BLUE);
        }
        let center = points.iter().sum::<Vec2>() / 7.0;
        for (n, &point) in points.iter().enumerate() {
            sheet.dot(point, BLACK);
            // Away from the middle; the fan's first one below.
            let away = match (topology, n) {
                (Topology::Fan, 0) => Vec2::NEG_Y,
                (Topology::Strip, _) => Vec2::Y * [-1.0, 1.0][n % 2],
                _ => (point - center).normalize_or_zero(),
            };
            sheet.text(point + away * 0.42, &n.to_string(), BLACK);
        }
        sheet.text((middle, -0.95), name, GREY);
    }
    sheet.finish()
}

/// A right angle and more, less: what one sees of a box's sides, from above.
fn of_facing() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-3.9, -3.6), (5.4, 3.6));
    let eye = Vec2::new(-0.6, -3.1);
    let turn = Vec2::from_angle(0.5);
    let corner = |x: f32, y: f32| turn.rotate(Vec2::new(x, y)) * 1.25 + Vec2::new(0.6, 0.9);
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    sheet.polygon(&corners, PALE, GREY);
    for (side, ink, words) in [([0, 1], GREEN, "faces the eye"), ([2, 3], ORANGE, "faces away")] {
        let [a, b] = side.map(|n: usize| corners[n]);
        let middle = (a + b) / 2.0;
        let normal = -(b - a).perp().normalize();
        let way = (eye - middle).normalize();
        sheet.line(a, b, ink, 4.0);
        sheet.dashed(middle, eye, FAINT, 1.8);
        sheet.arrow(middle, middle + 1.5 * normal, ink);
        sheet.arrow(middle, middle + 1.5 * way, BLACK);
        sheet.text(middle + 1.8 * normal, "n", ink);
        sheet.text_right_of(middle + 1.8 * normal + Vec2::new(0.3, 0.0), words, ink);
    }
    sheet.dot(eye, BLACK);
    sheet.text_left_of(eye - Vec2::new(0.25, 0.0), "eye", BLACK);
    sheet.finish()
}

fn flip() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-3.0, -2.1), (5.3, 1.75));
    // Depth to the right, the picture at the depth 1.
    let (a, b) = (at(4.0, -1.0), at(-2.0, -1.0));
    let [seen_a, seen_b] = [a, b].map(|p| p / p.x);
    sheet.dashed((-2.7, 0.0), (4.9, 0.0), FAINT, 1.6);
    sheet.line(b, a, BLUE, 4.0);
    sheet.line(at(0.0, 0.0), a, FAINT, 1.8);
    sheet.line(b, at(2.4, 1.2), FAINT, 1.8);
    sheet.line((1.0, -1.9), (1.0, 1.6), GREY, 1.4);
    sheet.arrow(seen_a, (1.0, -1.95), GREEN);
    sheet.arrow((1.0, 1.6), seen_b + at(0.0, 0.03), GREEN);
    sheet.dashed(seen_a, seen_b, ORANGE, 3.4);
    for (p, ink) in [(a, BLUE), (b, BLUE), (seen_a, GREEN), (seen_b, GREEN), (at(0.0, 0.0), BLACK)] {
        sheet.dot(p, ink);
    }
    sheet.text(a + at(0.1, -0.28), "a", BLUE);
    sheet.text(b + at(0.0, -0.28), "b", BLUE);
    sheet.text_left_of((-0.12, 0.18), "eye", BLACK);
    sheet.text_right_of((1.12, -0.68), "Y = −¼", GREEN);
    sheet.text_left_of(seen_b + at(-0.12, 0.1), "Y = ½", GREEN);
    sheet.text_right_of(at(1.15, 1.5), "the image", GREEN);
    sheet.text_right_of(at(1.15, 0.2), "not the image", ORANGE);
    sheet.text_right_of((3.9, 0.2), "horizon", GREY);
    sheet.text_left_of((0.9, 1.5), "picture", GREY);
    sheet.finish()
}

fn planes() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-4.4, -2.6), (4.4, 3.4));
    sheet.polygon(&[at(0.0, 0.0), at(3.1, 3.1), at(-3.1, 3.1)], SKY, "none");
    sheet.polygon(&[at(0.0, 0.0), at(2.3, -2.3), at(-2.3, -2.3)], PALE, "none");
    sheet.arrow((-4.0, 0.0), (4.1, 0.0), GREY);
    sheet.arrow((0.0, -0.7), (0.0, 3.3), GREY);
    sheet.text((4.15, -0.35), "x", GREY);
    sheet.text_left_of((-0.15, 3.2), "w", GREY);
    for (side, ink) in [(1.0, BLUE), (-1.0, ORANGE)] {
        sheet.line(at(-2.3 * side, -2.3), at(3.1 * side, 3.1), ink, 2.8);
        // Inwards, from the plane.
        let foot = at(2.1 * side, 2.1);
        sheet.arrow(foot, foot + at(-0.55 * side, 0.55), ink);
    }
    sheet.text_left_of((4.4, 1.25), "right: −x + w ≥ 0", BLUE);
    sheet.text_right_of((-4.4, 1.25), "left: x + w ≥ 0", ORANGE);
    sheet.text((-0.75, 2.4), "seen", BLACK);
    sheet.text((0.0, -1.6), "behind the eye", GREY);
    sheet.finish()
}

fn cases() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.1, -1.5), (13.7, 3.0));
    let cases = [
        (at(0.5, 0.5), at(1.1, 2.1), "1. inside", "first corner"),
        (at(0.6, 0.6), at(2.4, 2.0), "2. leaves", "first, and cut"),
        (at(2.3, 0.5), at(2.6, 2.1), "3. outside", "nothing"),
        (at(2.4, 0.6), at(0.6, 2.0), "4. enters", "cut"),
    ];
    for (n, (from, to, name, adds)) in cases.into_iter().enumerate() {
        let left = at(3.5 * n as f32, 0.0);
        // The plane is upright; inside is on its left.
        let plane = 1.6;
        sheet.rectangle(left, left + at(plane, 2.6), SKY, "none");
        sheet.line(left + at(plane, 0.0), left + at(plane, 2.6), BLACK, 2.0);
        let along = (to - from).normalize();
        sheet.arrow(left + from, left + to - 0.08 * along, GREY);
        let inside = |p: Vec2| p.x <= plane;
        if inside(from) {
            sheet.dot(left + from, ORANGE);
        }
        if inside(from) != inside(to) {
            let share = (plane - from.x) / (to.x - from.x);
            sheet.dot(left + from.lerp(to, share), ORANGE);
        }
        sheet.text(left + at(1.55, -0.5), name, BLACK);
        sheet.text(left + at(1.55, -1.15), adds, ORANGE);
    }
    sheet.finish()
}

fn polygon() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-2.3, -7.6), (8.1, 2.6));
    // All at w = 1, so that clip space is the picture.
    let corner = |x: f32, y: f32| ClipVertex { position: Vec4::new(x, y, 0.0, 1.0), varying: () };
    let triangle = Polygon::new(&[corner(-2.0, -0.5), corner(1.6, -1.5), corner(0.5, 2.0)]);
    let [_, _, sides @ ..] = PLANES;
    let mut rest = triangle;
    for (n, (plane, name)) in sides.into_iter().zip(["left", "right", "bottom", "top"]).enumerate() {
        rest = clip(&rest, plane);
        let middle = at(5.6 * (n % 2) as f32, -5.0 * (n / 2) as f32);
        let places = |polygon: &Polygon<()>| -> Vec<Vec2> {
            polygon.corners().iter().map(|corner| middle + corner.position.xy()).collect()
        };
        sheet.rectangle(middle - 1.0, middle + 1.0, PALE, GREY);
        sheet.polygon(&places(&triangle), "none", FAINT);
        sheet.polygon(&places(&rest), SKY, BLUE);
        for place in places(&rest) {
            sheet.dot(place, BLUE);
        }
        let corners = rest.corners().len();
        sheet.text(middle + at(0.0, -2.3), &format!("after {name}: {corners} corners"), BLACK);
    }
    sheet.finish()
}

/// Where an edge passes a plane, from the distances of its ends.
type Cut = fn([ClipVertex<()>; 2], [f64; 2]) -> ClipVertex<()>;

/// From the first end of the edge on, in `f32`: a neighbour that walks the other way finds another point.
fn one_way([a, b]: [ClipVertex<()>; 2], [from, to]: [f64; 2]) -> ClipVertex<()> {
    let t = (from / (from - to)) as f32;
    ClipVertex { position: a.position + t * (b.position - a.position), varying: () }
}

/// A floor of triangles, so many at a time in one of two blues, of each of which `rest` leaves a polygon without dents; what is left is divided
/// by its w and filled.
fn flat(
    (triangles, at_a_time): (&[[Vec3; 3]], usize),
    to_clip: Mat4,
    side: u16,
    rest: impl Fn([ClipVertex<()>; 3]) -> Vec<ClipVertex<()>>,
) -> Image {
    let mut image = canvas(side);
    let (bounds, size) = (image.bounds(), image.size());
    for (n, triangle) in triangles.iter().enumerate() {
        let rest = rest(triangle.map(|p| ClipVertex { position: to_clip * p.extend(1.0), varying: () }));
        let places: Vec<Vec2> =
            rest.iter().map(|corner| (corner.position.xy() / corner.position.w + 1.0) * size / 2.0).collect();
        let color = [Color::rgb(0x5a, 0xa9, 0xd6), Color::rgb(0x2f, 0x86, 0xbd)][n / at_a_time % 2];
        let order: Vec<u32> = (0..places.len() as u32).collect();
        for triangle in Topology::Fan.triangles(&order) {
            fill(triangle.map(|n| places[n as usize]), bounds, |x, y, _| image.set(x, y, color));
        }
    }
    image
}

fn cracks() -> anyhow::Result<Drawing> {
    // Triangles that meet far behind the eye.
    let hub = Vec3::new(1531.3, -1.0, 3_000_000.7);
    let ring = |n: i32| Vec3::new(n as f32 * 1.3 - 26.0, -1.0, -30.0);
    let triangles: Vec<[Vec3; 3]> = (0..40).map(|n| [hub, ring(n + 1), ring(n)]).collect();
    // The near plane so far away that the cut is seen.
    let to_clip = perspective(45.0, 1.0, 1.6, 1000.0)? * Mat4::from_rotation_x(0.3);
    all_beside([one_way as Cut, cut].map(|cut| {
        let image = flat((&triangles, 1), to_clip, 220, |corners| cut_by(corners, PLANES[0], cut));
        Ok(image.scale(440, 440))
    }))
}

fn divided() -> anyhow::Result<Drawing> {
    let mut triangles = Vec::new();
    for [near, far] in [[-4.0, -30.0], [3.0, -4.0]] {
        for n in 0..12 {
            let [left, right] = [n, n + 1].map(|n| n as f32 * 2.0 - 12.0);
            let corners = [(left, near), (right, near), (right, far), (left, far)];
            let [a, b, c, d] = corners.map(|(x, z)| Vec3::new(x, -1.0, z));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let to_clip = perspective(60.0, 1.0, 0.1, 1000.0)?;
    let right = flat((&triangles, 2), to_clip, 440, |corners| cut_by(corners, PLANES[0], cut));
    let wrong = flat((&triangles, 2), to_clip, 440, |corners| corners.to_vec());
    all_beside([Ok(right), Ok(wrong)])
}

fn turned() -> anyhow::Result<Drawing> {
    let head = [of_head()?];
    let to_clip = to_clip(36.0, EYE, Vec3::ZERO)?;
    // A light that both sides of the head get some of.
    let from_the_left = Vec3::new(-0.4, 0.8, 0.5);
    all_beside(
        [Cull::Back, Cull::Front]
            .map(|cull| Ok(picture(&head, (cull, Clipping::GuardBand), (from_the_left, to_clip), 440))),
    )
}

/// What of a triangle is inside of a plane, cut in a way of its own.
fn cut_by(corners: [ClipVertex<()>; 3], plane: Vec4, cut: Cut) -> Vec<ClipVertex<()>> {
    let mut rest = Vec::new();
    for n in 0..3 {
        let ends = [corners[n], corners[(n + 1) % 3]];
        let distances = ends.map(|end| distance(plane, end.position));
        let [first, second] = distances.map(|distance| distance >= 0.0);
        if first {
            rest.push(ends[0]);
        }
        if first != second {
            rest.push(cut(ends, distances));
        }
    }
    rest
}

fn band() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-5.2, -3.4), (6.6, 3.4));
    sheet.rectangle((-5.0, -3.2), (5.0, 3.2), PALE, GREY);
    sheet.rectangle((-1.6, -1.05), (1.6, 1.05), PAPER, BLACK);
    let triangles: [([Vec2; 3], Ink, Ink); 4] = [
        ([at(-0.7, -0.5), at(0.2, -0.4), at(-0.3, 0.3)], SKY, BLUE),
        ([at(-0.9, 0.55), at(-2.1, 2.6), at(-3.3, 1.2)], SKY, BLUE),
        ([at(2.3, -1.2), at(3.6, -2.6), at(4.2, -1.1)], "none", GREY),
        ([at(0.7, 0.1), at(6.4, 1.3), at(5.9, 2.9)], AMBER, ORANGE),
    ];
    for (corners, fill, ink) in triangles {
        sheet.polygon(&corners, fill, ink);
    }
    sheet.line((5.0, -3.2), (5.0, 3.2), GREY, 1.8);
    sheet.text((0.75, -0.75), "picture", BLACK);
    sheet.text_right_of((-4.8, -2.85), "guard band", GREY);
    sheet.text((-3.35, 0.6), "filled as it is", BLACK);
    sheet.text((3.4, -0.8), "rejected", GREY);
    sheet.text((4.15, 1.4), "cut", BLACK);
    sheet.finish()
}

fn culled() -> anyhow::Result<Drawing> {
    let head = of_head()?;
    let (loaded, _) = &head;
    let to_clip = to_clip(36.0, EYE, Vec3::ZERO)?;
    let front = picture(std::slice::from_ref(&head), (Cull::Back, Clipping::GuardBand), (EYE, to_clip), 450);
    let orange = painted(1, 1, |_, _| Color::rgb(0xf0, 0x8a, 0x3c));
    let mut away = subject(loaded.model.clone(), orange, Wrap::Clamp);
    // What faces away shows its other side, and is lit there.
    away.0.normals.iter_mut().flatten().for_each(|normal| *normal = -*normal);
    let back = picture(&[away], (Cull::Front, Clipping::GuardBand), (EYE, to_clip), 450);
    all_beside([Ok(front), Ok(back)])
}

fn inside() -> anyhow::Result<Drawing> {
    let mut head = of_head()?;
    head.0.normals.iter_mut().flatten().for_each(|normal| *normal = -*normal);
    let view =
        view(Vec3::new(0.0, 0.0, -0.35), Vec3::new(0.0, 0.0, 1.0), Vec3::Y).context("it looks somewhere")?;
    let to_clip = perspective(100.0, 1.6, 0.01, 100.0)? * view;
    let mut image = Image::new(1440, 900, Format::Rgb);
    let light = Vec3::new(0.0, 0.25, -1.0).normalize();
    draw(&[(head.0.uniforms(light, to_clip), &head.1)], Cull::None, Clipping::GuardBand, &mut image);
    Ok(Drawing::Pixels(image.scale(720, 450), 1))
}
