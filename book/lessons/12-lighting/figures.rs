//! Chapter 12: a point light.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_6, LN_2, PI, TAU};
use std::path::Path;

use anyhow::Context;
use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh};
use common::{Attributes, Color, Image, Mat3, Mat4, Vec2, Vec3};
use lighting::reflection::Reflection;
use lighting::shader::{PerPixel, draw};
use lighting::surface::Smooth;
use lighting::tangent::{tangents, turned};
use lighting::{
    Draw, Falloff, LOOKS, METHODS, Maps, NORMALISATIONS, POWERS, PointLight, Reflected, Scene, blinn_phong,
    phong,
};
use perspective::scene::Loaded;
use perspective::{perspective, view};
use textures::Wrap;
use transforms::affine::rotate_y;
use transforms::scale;

use crate::figures::picture::{all_beside, beside, canvas, method, model, painted, paste, texture};
use crate::figures::shape::ball;
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, ORANGE, PALE, PURPLE, Sheet};
use crate::figures::{Drawing, Figure};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "lighting-head",
        "A head twice. On the left it is matt, and lit from a direction. On the right a lamp near it makes highlights on \
         the forehead, the nose, the cheek and the eyes, and the far side is dim, not black.",
        head,
    ),
    Figure::new(
        "lighting-parts",
        "A head four times: dim and without shape; lit from one side, matt; black with small white highlights; and all of \
         it together.",
        parts,
    ),
    Figure::new(
        "lighting-lambert",
        "Two surfaces from the side, each under a beam of the same width. The level one is lit on as much as the beam is \
         wide; the one that is tilted by 60° on twice as much.",
        lambert,
    ),
    Figure::new(
        "lighting-mirror",
        "A surface from the side with its normal n upwards. The arrow l leads to the light, up to the right; it is a part \
         along the normal and a part along the surface. The arrow r leads as far up, to the left.",
        mirror,
    ),
    Figure::new(
        "lighting-powers",
        "Four bells about 0°, of the exponents 4, 16, 64 and 256. Each is half as wide as the one before.",
        powers,
    ),
    Figure::new(
        "lighting-halfway",
        "A surface with its normal n, a light to the right and an eye to the left of it. r is the mirrored l; the angle \
         from r to v is called ρ. h is half-way between l and v; the angle from n to h is called δ, and is half of it.",
        halfway,
    ),
    Figure::new(
        "lighting-ratio",
        "A curve that begins at a factor of 4 for an angle of 0° between light and eye and falls to 2.9 at 90° and 2.1 at \
         120°. Two dashed lines enclose it: 4, and 4 times the square of a cosine.",
        ratio,
    ),
    Figure::new(
        "lighting-streaks",
        "A dark floor with the reflection of a lamp, twice. On the left it is a wide spot; on the right a long narrow \
         streak towards the viewer.",
        streaks,
    ),
    Figure::new(
        "lighting-stretched",
        "A flat ball twice, under a lamp above it on the right. On the left the border of the light and the highlight are \
         those of a round ball; on the right the top is lit as far as the rim, and the highlight is wide.",
        stretched,
    ),
    Figure::new(
        "lighting-chord",
        "Two arrows of the same length, 60° apart, and between them five others that end on the straight line between the \
         ends of the two. The arc on which arrows of full length would end lies farther out.",
        chord,
    ),
    Figure::new(
        "lighting-swims",
        "Five pictures of a turning ball of few triangles, in two rows. In the upper one the highlight is weak and wide, \
         becomes a bright hexagon, moves to the right with it and fades; in the lower one it is the same round spot in all \
         five.",
        swims,
    ),
    Figure::new(
        "lighting-brightest",
        "The brightest pixel of a highlight against the angle by which a ball has turned: level for blinn-phong, and for \
         phong-vertex a chain of three arches that reach it from far below.",
        brightest,
    ),
    Figure::new(
        "lighting-falloff",
        "A floor under a lamp three times. The spot of light is wide, less wide, and narrow.",
        falloff,
    ),
    Figure::new(
        "lighting-inverse-root",
        "The product of √x and its inverse root from x = 1 to 4: without a step two arches between 0.966 and 1.034, \
         with one step nearly straight, and just below 1.",
        inverse_root,
    ),
    Figure::new(
        "lighting-power-ways",
        "Powers of x from 0.9 to 1: a curve that rises steeply to 1, Schlick's fraction far above it, and a table's steps \
         about the curve.",
        power_ways,
    ),
    Figure::new(
        "lighting-looks",
        "A head and a ball four times each. By flat both have facets, and the head's highlights are single triangles; by \
         phong-vertex the ball is smooth and has no highlight at all; by phong it has a small round one, by blinn-phong a \
         larger one in the same place.",
        looks,
    ),
    Figure::new(
        "lighting-rows",
        "The highlight of a ball of few triangles five times: a square with a dark border; hardly to be seen; round; and \
         twice the same again.",
        rows,
    ),
    Figure::new(
        "lighting-highlights",
        "The highlight of a ball five times: round; the same; much larger and fading slowly; in a few rings; and round \
         again.",
        highlights,
    ),
    Figure::new(
        "lighting-behind",
        "A ball with the light from behind, three times. With the exponent 1 a broad highlight ends at a sharp edge; with \
         4 at a fainter one; with 32 no edge is seen.",
        behind,
    ),
    Figure::new(
        "lighting-map",
        "Two square pictures of patches. On the left they are of all colours of the rainbow; on the right nearly all is of \
         one light blue, in which finer lines are seen.",
        maps,
    ),
    Figure::new(
        "lighting-tangents",
        "A triangle twice: in the plane of u and v with a grid, and in space, where the grid is slanted and stretched. \
         There arrows T and B lead along its lines.",
        tangents_of_a_triangle,
    ),
    Figure::new(
        "lighting-mirrored",
        "A wall with eight round bosses, lit from the left, whose right half is the mirror image of its left. In the upper \
         picture all are lit from the upper left; in the lower one those of the right half are lit from below.",
        mirrored,
    ),
    Figure::new(
        "lighting-few",
        "A head three times: coarse, with edges at its cheek and chin; the same outline with a smooth, detailed face; and \
         the same face with a smooth outline.",
        few,
    ),
    Figure::new(
        "lighting-ear",
        "The right side of a head twice. On the left the ear is all dark, in the midst of lit hair and cheek; on the right its \
         rim shines.",
        ear,
    ),
    Figure::new(
        "lighting-surfaces",
        "A head five times: smooth; twice with fine hair and pores; with dull skin and shining lips and eyes; and as a \
         cartoon in a few tones inside a black line, on white.",
        surfaces,
    ),
    Figure::new(
        "lighting-short",
        "A ball of few triangles with a round highlight, and the same ball with a dim square in its place.",
        short,
    ),
    Figure::new(
        "lighting-leak",
        "A ball with the lamp behind it, lit along its right rim, and the same ball with a glow on its dark side.",
        leak,
    ),
];

/// From where something is seen: the eye, what it looks at, and the field of view in degrees.
pub(crate) type Seen = (Vec3, Vec3, f32);
/// As the lesson's program sees the head.
pub(crate) const SEEN: Seen = (Vec3::new(0.55, 0.35, 2.35), Vec3::new(0.0, 0.12, 0.0), 45.0);
/// A ball from the front.
const FRONT: Seen = (Vec3::new(0.0, 0.0, 3.6), Vec3::ZERO, 34.0);
/// All that the shaders need.
pub(crate) const ALL: Attributes = Attributes { normals: true, uvs: true };
/// What a ball is made of.
const ENAMEL: Color = Color::rgb(0x2f, 0x74, 0xb5);

/// A model with its mesh.
type Subject = (Loaded, Mesh);

fn subject(model: common::Model, texture: Image) -> Subject {
    let loaded = Loaded::new(model, texture, Wrap::Clamp);
    let mesh = indexed(&loaded.model, &loaded.normals, ALL);
    (loaded, mesh)
}

fn of_head() -> anyhow::Result<Subject> {
    Ok(subject(model()?, texture()?))
}

/// A ball of one colour, with as many sectors as half of its bands twice.
fn of_ball(sectors: usize, color: Color) -> anyhow::Result<Subject> {
    Ok(subject(ball(sectors / 2, sectors)?, painted(1, 1, |_, _| color)))
}

/// To clip space, for a square picture.
pub(crate) fn camera((eye, center, fov): Seen) -> anyhow::Result<Mat4> {
    let view = view(eye, center, Vec3::Y).context("the eye is at the centre")?;
    Ok(perspective(fov, 1.0, 0.1, 100.0)? * view)
}

/// A square picture of a subject where a matrix puts it, drawn three times as large, so that it is smooth.
fn lit(
    (loaded, mesh): &Subject,
    to_world: Mat4,
    seen: Seen,
    light: PointLight,
    draw: Draw,
    side: u16,
) -> anyhow::Result<Image> {
    let scene = Scene::placed(loaded, to_world, camera(seen)?, seen.0, light).context("it is not flat")?;
    let mut image = canvas(3 * side);
    draw(&scene, mesh, Cull::Back, &mut image);
    Ok(image.scale(side, side))
}

fn head() -> anyhow::Result<Drawing> {
    let head = of_head()?;
    // As lesson 11 draws it, from the same side.
    let mut before = canvas(1350);
    let light = PointLight::default();
    let uniforms = head.0.uniforms(light.position.normalize(), camera(SEEN)?);
    clipping::draw(&[(uniforms, &head.1)], Cull::Back, Clipping::GuardBand, &mut before);
    let after = lit(&head, Mat4::IDENTITY, SEEN, light, *method(METHODS, "blinn-phong")?, 450)?;
    beside([&before.scale(450, 450), &after])
}

fn parts() -> anyhow::Result<Drawing> {
    let head = of_head()?;
    let light = PointLight::default();
    let dark = PointLight { ambient: 0.0, diffuse: 0.0, specular: 0.0, ..light };
    let lights = [
        PointLight { ambient: light.ambient, ..dark },
        PointLight { diffuse: light.diffuse, ..dark },
        PointLight { specular: light.specular, ..dark },
        light,
    ];
    let draw = *method(METHODS, "blinn-phong")?;
    all_beside(lights.map(|light| lit(&head, Mat4::IDENTITY, SEEN, light, draw, 300)))
}

fn lambert() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-3.3, -1.9), (7.6, 3.2));
    for (middle, tilt) in [(at(-1.4, 0.0), 0.0), (at(4.3, 0.0), FRAC_PI_3)] {
        let along = Vec2::from_angle(tilt);
        let normal = along.perp();
        // Where the beam's two sides meet the surface.
        let ends = [-0.5, 0.5].map(|x: f32| middle + along * (x / tilt.cos()));
        sheet.polygon(&[ends[0], ends[1], ends[1].with_y(2.8), ends[0].with_y(2.8)], AMBER, "none");
        sheet.line(middle - along * 1.75, middle + along * 1.75, BLACK, 2.4);
        sheet.line(ends[0], ends[1], ORANGE, 6.0);
        for x in [-0.25, 0.25] {
            let top = middle + at(x, 2.7);
            let foot = middle + along * (x / tilt.cos());
            sheet.arrow(top, foot + at(0.0, 0.05), GREY);
        }
        sheet.arrow(middle, middle + normal * 1.5, BLUE);
        sheet.text(middle + normal * 1.75, "n", BLUE);
        if tilt > 0.0 {
            sheet.dashed(middle, middle + at(0.0, 2.6), BLACK, 1.6);
            sheet.arc(middle, 0.95, FRAC_PI_2, FRAC_PI_2 + tilt, BLACK);
            sheet.text(middle + 1.22 * Vec2::from_angle(FRAC_PI_2 + 0.62 * tilt), "θ", BLACK);
            sheet.text_right_of(ends[1] + at(0.25, -0.4), "1 / cos θ", ORANGE);
        } else {
            sheet.text(middle - at(0.0, 0.4), "1", ORANGE);
        }
        sheet.text(middle + at(0.0, 3.05), "1 wide", GREY);
    }
    sheet.finish()
}

/// The ground of a surface from the side, and its normal.
fn ground(sheet: &mut Sheet, half: f32) {
    sheet.rectangle((-half, -0.45), (half, 0.0), PALE, "none");
    sheet.line((-half, 0.0), (half, 0.0), BLACK, 2.4);
}

fn mirror() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-4.2, -0.5), (4.2, 3.75));
    let length = 3.2;
    let l = length * at(0.8, 0.6);
    let along = l.with_x(0.0);
    ground(&mut sheet, 4.0);
    sheet.dashed(l, along, FAINT, 2.0);
    sheet.dashed(l * at(-1.0, 1.0), along, FAINT, 2.0);
    sheet.arrow((0.0, 0.0), (0.0, length), BLUE);
    sheet.arrow(along, l - at(0.1, 0.0), GREY);
    sheet.arrow(along, (l - at(0.1, 0.0)) * at(-1.0, 1.0), GREY);
    sheet.arrow((0.0, 0.0), l, ORANGE);
    sheet.arrow((0.0, 0.0), l * at(-1.0, 1.0), GREEN);
    sheet.arrow((0.0, 0.0), along, BLACK);
    sheet.text((0.0, length + 0.25), "n", BLUE);
    sheet.text_right_of(l + at(0.15, 0.1), "l", ORANGE);
    sheet.text_left_of(l * at(-1.0, 1.0) + at(-0.15, 0.1), "r", GREEN);
    sheet.text_right_of((0.15, 1.15), "(n·l) n", BLACK);
    sheet.text((1.35, along.y + 0.3), "l − (n·l) n", GREY);
    sheet.text((-1.35, along.y + 0.3), "turned round", GREY);
    sheet.finish()
}

fn powers() -> anyhow::Result<Drawing> {
    let (wide, up) = (9.0, 5.0);
    let power = method(POWERS, "powf")?.one;
    let mut sheet = Sheet::new((-wide / 2.0 - 0.6, -0.75), (wide / 2.0 + 0.6, up + 0.5));
    let place = |degrees: f32| degrees / 90.0 * wide / 2.0;
    sheet.axes((0.0, 0.0), (-wide / 2.0, 0.0), (wide / 2.0, up), 1.5);
    sheet.dashed((-wide / 2.0, up / 2.0), (wide / 2.0, up / 2.0), FAINT, 1.6);
    for (exponent, ink) in [(4.0_f32, GREY), (16.0, GREEN), (64.0, BLUE), (256.0, ORANGE)] {
        let points = (-180..=180).map(|n| n as f32 / 2.0);
        sheet.polyline(
            points.map(|degrees| (place(degrees), up * power(exponent, degrees.to_radians().cos().max(0.0)))),
            ink,
            2.8,
        );
        // Where it is one half, by the chapter's formula.
        let half = (2.0 * LN_2 / exponent).sqrt().to_degrees();
        sheet.dot((place(half), up / 2.0), ink);
        let line = (exponent.log2() - 2.0) / 2.0;
        sheet.text_right_of((2.9, up - 0.5 * line), &format!("α = {exponent}"), ink);
    }
    for degrees in [-90.0, -45.0, 0.0, 45.0, 90.0] {
        sheet.line((place(degrees), -0.1), (place(degrees), 0.1), GREY, 1.6);
        sheet.text((place(degrees), -0.45), &format!("{degrees}°").replace('-', "−"), BLACK);
    }
    sheet.text_left_of((-0.12, up), "1", BLACK);
    sheet.text_left_of((-wide / 2.0 + 0.2, up / 2.0 + 0.25), "½", GREY);
    sheet.finish()
}

fn halfway_between() -> [(Vec2, &'static str, Ink); 5] {
    // l at −40° from the normal, v at 64°: r at 40°, h at 12°.
    let from_normal = |degrees: f32| Vec2::from_angle(FRAC_PI_2 + degrees.to_radians());
    [
        (from_normal(0.0), "n", BLUE),
        (from_normal(-40.0), "l", ORANGE),
        (from_normal(64.0), "v", PURPLE),
        (from_normal(40.0), "r", GREEN),
        (from_normal(12.0), "h", BLACK),
    ]
}

fn halfway() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-4.3, -0.5), (4.0, 4.0));
    let length = 3.3;
    ground(&mut sheet, 3.9);
    for (direction, name, ink) in halfway_between() {
        sheet.arrow((0.0, 0.0), direction * length, ink);
        sheet.text(direction * (length + 0.3), name, ink);
    }
    let angle = |degrees: f32| FRAC_PI_2 + degrees.to_radians();
    sheet.arc((0.0, 0.0), 2.3, angle(40.0), angle(64.0), GREEN);
    sheet.text(2.58 * Vec2::from_angle(angle(52.0)), "ρ", GREEN);
    sheet.arc((0.0, 0.0), 2.3, angle(0.0), angle(12.0), BLUE);
    sheet.text(2.58 * Vec2::from_angle(angle(6.0)), "δ", BLUE);
    sheet.finish()
}

/// The factor for Blinn's exponent that makes both models' highlights on a ball most alike, by the sum of squares over all
/// normals, for Phong's exponent and the angle between light and eye.
pub(crate) fn best_ratio(exponent: f32, between: f32) -> f32 {
    const RINGS: usize = 160;
    const PARTS: usize = 40;
    // Far away, so that directions are those from the origin.
    let [at_light, at_eye] = [0.5_f32, -0.5].map(|side| {
        let angle = side * between;
        Vec3::new(angle.sin(), 0.0, angle.cos()) * 1e4
    });
    // No highlight is seen farther from the middle.
    let reach = (7.0 / exponent.sqrt()).min(FRAC_PI_2);
    let normals: Vec<(f32, Vec3)> = (0..RINGS)
        .flat_map(|ring| (0..PARTS).map(move |part| (ring, part)))
        .map(|(ring, part)| {
            let tilt = (ring as f32 + 0.5) / RINGS as f32 * reach;
            let turn = (part as f32 + 0.5) / PARTS as f32 * TAU;
            (tilt.sin(), Vec3::new(tilt.sin() * turn.cos(), tilt.sin() * turn.sin(), tilt.cos()))
        })
        .filter(|(_, normal)| normal.dot(at_light) > 0.0 && normal.dot(at_eye) > 0.0)
        .collect();
    let light =
        |shininess: f32| PointLight { position: at_light, specular: 1.0, shininess, ..PointLight::default() };
    let phongs: Vec<f32> = normals
        .iter()
        .map(|&(_, normal)| phong(Vec3::ZERO, normal, at_eye, &light(exponent)).highlight)
        .collect();
    let apart = |ratio: f32| -> f64 {
        let light = light(ratio * exponent);
        let square = |(&(area, normal), phong): (&(f32, Vec3), &f32)| {
            let off = blinn_phong(Vec3::ZERO, normal, at_eye, &light).highlight - phong;
            f64::from(area * off * off)
        };
        normals.iter().zip(&phongs).map(square).sum()
    };
    // The sum has one valley.
    let (mut low, mut high) = (1.0_f32, 6.0_f32);
    for _ in 0..30 {
        let [third, two_thirds] = [1.0, 2.0].map(|n| low + (high - low) * n / 3.0);
        if apart(third) < apart(two_thirds) { high = two_thirds } else { low = third }
    }
    (low + high) / 2.0
}

fn ratio() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.9, -1.2), (9.9, 5.6));
    let (across, up) = (9.0 / 120.0, 1.15);
    sheet.axes((0.0, 0.0), (0.0, 0.0), (9.4, 5.2), 1.5);
    for factor in [1.0, 2.0, 3.0, 4.0] {
        sheet.line((0.0, up * factor), (9.2, up * factor), FAINT, 1.2);
        sheet.text_left_of((-0.15, up * factor), &format!("{factor}"), BLACK);
    }
    for degrees in [0.0, 30.0, 60.0, 90.0, 120.0] {
        sheet.line((degrees * across, -0.1), (degrees * across, 0.1), GREY, 1.6);
        sheet.text((degrees * across, -0.45), &format!("{degrees}°"), BLACK);
    }
    sheet.dashed((0.0, 4.0 * up), (9.0, 4.0 * up), GREY, 2.0);
    let angles = || (0..=24).map(|n| n as f32 * 5.0);
    let cosine = |degrees: f32| (degrees.to_radians() / 2.0).cos();
    sheet.polyline(angles().map(|degrees| (degrees * across, up * 4.0 * cosine(degrees).powi(2))), GREY, 2.0);
    sheet.polyline(
        angles().map(|degrees| (degrees * across, up * best_ratio(32.0, degrees.to_radians()))),
        BLUE,
        3.2,
    );
    sheet.text_right_of((6.6, 4.0 * up + 0.3), "along: 4", GREY);
    sheet.text_right_of((1.9, 1.9), "across: 4 cos² γ", GREY);
    sheet.text_right_of((6.0, 3.2 * up + 0.15), "measured", BLUE);
    sheet.text((4.5, -1.05), "between light and eye, 2γ", GREY);
    sheet.finish()
}

/// A level floor at the height −1, of a colour, painted point by point: what a ray through each pixel meets.
fn floor_painted(
    (width, height): (u16, u16),
    (eye, down): (Vec3, f32),
    color: impl Fn(Vec3) -> Color,
) -> Image {
    // Three by three rays a pixel.
    let large = painted(3 * width, 3 * height, |x, y| {
        let across = |n: i32, of: u16| (n as f32 + 0.5) / (3.0 * f32::from(of)) * 2.0 - 1.0;
        let aspect = f32::from(width) / f32::from(height);
        let (right, up) = (across(x, width) * aspect * 0.5, across(y, height) * 0.5);
        let ray = Mat3::from_rotation_x(-down) * Vec3::new(right, up, -1.0);
        if ray.y >= -1e-4 {
            return Color::BLACK;
        }
        color(eye + ray * (-1.0 - eye.y) / ray.y)
    });
    large.scale(width, height)
}

fn streaks() -> anyhow::Result<Drawing> {
    let eye = Vec3::new(0.0, 0.0, 3.0);
    let light = PointLight {
        position: Vec3::new(0.0, -0.35, -9.0),
        ambient: 0.25,
        diffuse: 0.3,
        specular: 0.85,
        ..PointLight::default()
    };
    type Model = fn(Vec3, Vec3, Vec3, &PointLight) -> Reflected;
    let models: [(Model, f32); 2] = [(phong, 16.0), (blinn_phong, 64.0)];
    let pictures = models.map(|(model, shininess)| {
        let light = PointLight { shininess, ..light };
        floor_painted((450, 260), (eye, 0.2), |point| {
            model(point, Vec3::Y, eye, &light).color(Color::rgb(0x2a, 0x3a, 0x4c))
        })
    });
    beside(&pictures)
}

fn stretched() -> anyhow::Result<Drawing> {
    beside(&stretched_pictures(450)?)
}

/// A ball of half its height, with its normals by M alone, and by the inverse transpose.
pub(crate) fn stretched_pictures(side: u16) -> anyhow::Result<[Image; 2]> {
    let (loaded, mesh) = of_ball(96, ENAMEL)?;
    let eye = Vec3::new(0.0, 0.9, 3.4);
    let light = PointLight { position: Vec3::new(2.2, 2.2, 2.4), ..PointLight::default() };
    let flat = scale(Vec3::new(1.0, 0.5, 1.0));
    let right = Scene::placed(&loaded, flat, camera((eye, Vec3::ZERO, 40.0))?, eye, light)
        .context("it is not flat")?;
    let wrong = Scene { normals_to_world: Mat3::from_mat4(flat), ..right };
    let draw = method(METHODS, "blinn-phong")?;
    let picture = |scene: Scene| {
        let mut image = canvas(3 * side);
        draw(&scene, &mesh, Cull::Back, &mut image);
        image.scale(side, side)
    };
    Ok([wrong, right].map(picture))
}

fn chord() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-4.3, -0.4), (4.3, 5.4));
    let length = 4.4;
    let [a, b] = [FRAC_PI_6, -FRAC_PI_6].map(|turn| length * Vec2::from_angle(FRAC_PI_2 + turn));
    sheet.arc((0.0, 0.0), length, FRAC_PI_2 - FRAC_PI_6, FRAC_PI_2 + FRAC_PI_6, GREY);
    sheet.dashed(a, b, ORANGE, 2.0);
    for n in 1..6 {
        let t = n as f32 / 6.0;
        let mean = a.lerp(b, t);
        sheet.dashed(mean, mean.normalize() * length, FAINT, 1.8);
        sheet.arrow((0.0, 0.0), mean, ORANGE);
    }
    for (normal, name) in [(a, "a"), (b, "b")] {
        sheet.arrow((0.0, 0.0), normal, BLUE);
        sheet.text(normal * 1.07, name, BLUE);
    }
    sheet.arc((0.0, 0.0), 0.9, FRAC_PI_2 - FRAC_PI_6, FRAC_PI_2 + FRAC_PI_6, BLACK);
    sheet.text_left_of((-0.62, 0.75), "φ", BLACK);
    sheet.text((0.0, length + 0.35), "1 long", GREY);
    sheet.text_right_of((1.5, 1.6), "as interpolated", ORANGE);
    sheet.finish()
}

/// Where the turning ball's lamp is.
const BESIDE: Vec3 = Vec3::new(1.6, 0.0, 4.0);

/// The turning ball of 16 sectors by one method, after a share of a sector.
fn turning(
    subject: &Subject,
    (name, shininess): (&str, f32),
    sectors: f32,
    side: u16,
) -> anyhow::Result<Image> {
    let light =
        PointLight { position: BESIDE, shininess, diffuse: 0.45, specular: 0.55, ..PointLight::default() };
    let turn = Mat4::from_mat3(rotate_y(sectors * 360.0 / 16.0));
    lit(subject, turn, FRONT, light, *method(METHODS, name)?, side)
}

/// Both models, with exponents that make their highlights alike.
const ALIKE: [(&str, f32); 2] = [("phong-vertex", 8.0), ("blinn-phong", 32.0)];

fn swims() -> anyhow::Result<Drawing> {
    const SIDE: u16 = 180;
    let subject = of_ball(16, ENAMEL)?;
    let mut sheet = Image::new(5 * SIDE, 2 * SIDE, common::Format::Rgb);
    for (row, way) in ALIKE.into_iter().enumerate() {
        for column in 0..5 {
            let image = turning(&subject, way, column as f32 / 5.0, SIDE)?;
            let at = [column * i32::from(SIDE), (1 - row as i32) * i32::from(SIDE)];
            paste(&image, &mut sheet, at);
        }
    }
    Ok(Drawing::Pixels(sheet, 1))
}

fn brightest() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.3, -1.2), (9.9, 5.6));
    let (across, up) = (3.0, 5.0 / 255.0);
    sheet.axes((0.0, 0.0), (0.0, 0.0), (9.3, 5.3), 1.5);
    for level in [0.0, 85.0, 170.0, 255.0] {
        sheet.line((0.0, up * level), (9.2, up * level), FAINT, 1.2);
        sheet.text_left_of((-0.15, up * level), &format!("{level}"), BLACK);
    }
    // Red is what the ball's own colour has least of: there the highlight is nearly alone.
    let subject = of_ball(16, Color::BLACK)?;
    for (way, ink) in ALIKE.into_iter().zip([ORANGE, BLUE]) {
        let points = (0..=72).map(|n| -> anyhow::Result<(f32, f32)> {
            let sectors = n as f32 / 24.0;
            let image = turning(&subject, way, sectors, 80)?;
            let most = image.pixels().map(|(_, _, color)| color.r).max().unwrap_or(0);
            Ok((sectors * across, up * f32::from(most)))
        });
        sheet.polyline(points.collect::<anyhow::Result<Vec<_>>>()?, ink, 3.0);
    }
    for n in 0..=3 {
        let x = n as f32 * across;
        sheet.line((x, -0.1), (x, 0.1), GREY, 1.6);
        sheet.text((x, -0.45), &format!("{n}"), BLACK);
    }
    sheet.text((4.6, -1.05), "turned by so many sectors", GREY);
    sheet.text_right_of((6.3, 3.2), "blinn-phong", BLUE);
    sheet.text_right_of((6.2, 0.9), "phong-vertex", ORANGE);
    sheet.finish()
}

fn falloff() -> anyhow::Result<Drawing> {
    let eye = Vec3::new(0.0, 0.6, 2.6);
    let light = PointLight {
        // 1 above the floor, where all three are alike.
        position: Vec3::new(0.0, 0.0, -1.4),
        ambient: 0.0,
        diffuse: 1.0,
        specular: 0.0,
        ..PointLight::default()
    };
    let pictures = [Falloff::None, Falloff::Linear, Falloff::Quadratic].map(|falloff| {
        let light = PointLight { falloff, ..light };
        floor_painted((300, 220), (eye, 0.35), |point| {
            blinn_phong(point, Vec3::Y, eye, &light).color(Color::rgb(0xf4, 0xe6, 0xc8))
        })
    });
    beside(&pictures)
}

fn inverse_root() -> anyhow::Result<Drawing> {
    let scale = |product: f32| (product - 1.0) * 60.0;
    let mut sheet = Sheet::new((-0.95, -3.0), (10.0, 2.9));
    sheet.axes((0.0, 0.0), (0.0, -2.5), (8.4, 2.5), 1.5);
    for (steps, ink) in [("fast-0", ORANGE), ("fast-1", BLUE)] {
        let one = method(NORMALISATIONS, steps)?.one;
        // A vector of length √x becomes one of length √x · 1/√x.
        let points = (0..=480).map(|n| n as f32 / 240.0);
        sheet.polyline(points.map(|e| (4.0 * e, scale(one(Vec3::X * (e / 2.0).exp2()).x))), ink, 2.8);
    }
    for (e, name) in [(0, "x = 1"), (1, "2"), (2, "4")] {
        let x = 4.0 * e as f32;
        sheet.dashed((x, -2.5), (x, 2.5), FAINT, 1.4);
        sheet.text((x, -2.8), name, BLACK);
    }
    for product in [0.97, 1.0, 1.03] {
        sheet.text_left_of((-0.12, scale(product)), &format!("{product}"), BLACK);
    }
    sheet.text_right_of((8.1, 1.3), "no step", ORANGE);
    sheet.text_right_of((8.1, 0.35), "one step", BLUE);
    sheet.finish()
}

fn power_ways() -> anyhow::Result<Drawing> {
    const EXPONENT: f32 = 32.0;
    let mut sheet = Sheet::new((-0.8, -0.75), (9.6, 5.6));
    let (wide, up) = (9.0, 5.2);
    let place = |x: f32| (x - 0.9) * 10.0 * wide;
    sheet.axes((0.0, 0.0), (0.0, 0.0), (wide + 0.3, up + 0.2), 1.5);
    for (name, ink, width) in [("schlick", ORANGE, 2.8), ("table", GREEN, 1.8), ("powf", BLUE, 3.2)] {
        let one = method(POWERS, name)?.one;
        let points = (0..=900).map(|n| 0.9 + n as f32 / 9000.0);
        sheet.polyline(points.map(|x| (place(x), up * one(EXPONENT, x))), ink, width);
    }
    for x in [0.9, 0.95, 1.0] {
        sheet.line((place(x), -0.1), (place(x), 0.1), GREY, 1.6);
        sheet.text((place(x), -0.45), &format!("{x}"), BLACK);
    }
    for y in [0.5, 1.0] {
        sheet.line((0.0, up * y), (wide, up * y), FAINT, 1.2);
        sheet.text_left_of((-0.12, up * y), &format!("{y}"), BLACK);
    }
    sheet.text((1.7, up * 0.38), "Schlick", ORANGE);
    sheet.text_right_of((6.1, up * 0.12), "the power, α = 32", BLUE);
    sheet.text_right_of((6.9, up * 0.3), "the table", GREEN);
    sheet.finish()
}

fn looks() -> anyhow::Result<Drawing> {
    const SIDE: u16 = 225;
    let subjects = [(of_ball(16, ENAMEL)?, (Vec3::new(0.0, 0.5, 3.6), Vec3::ZERO, 34.0)), (of_head()?, SEEN)];
    let mut sheet = Image::new(4 * SIDE, 2 * SIDE, common::Format::Rgb);
    for (row, (subject, seen)) in subjects.iter().enumerate() {
        for (column, method) in METHODS.iter().enumerate() {
            let light = PointLight { position: Vec3::new(1.6, 1.4, 2.4), ..PointLight::default() };
            let image = lit(subject, Mat4::IDENTITY, *seen, light, method.run, SIDE)?;
            paste(&image, &mut sheet, [column, row].map(|n| n as i32 * i32::from(SIDE)));
        }
    }
    Ok(Drawing::Pixels(sheet, 1))
}

/// A ball from the front with the lamp above on the right, by one way to draw, and a part of it if that is asked for.
fn ball_by(draw: Draw, sectors: usize, light: PointLight, fov: f32) -> anyhow::Result<Image> {
    let subject = of_ball(sectors, ENAMEL)?;
    lit(&subject, Mat4::IDENTITY, (FRONT.0, FRONT.1, fov), light, draw, 180)
}

fn rows() -> anyhow::Result<Drawing> {
    let light = PointLight { position: Vec3::new(1.2, 1.2, 4.0), ..PointLight::default() };
    all_beside(NORMALISATIONS.iter().map(|row| ball_by(row.run.draw, 16, light, 20.0)))
}

fn highlights() -> anyhow::Result<Drawing> {
    let light = PointLight {
        position: Vec3::new(0.0, 0.0, 4.0),
        ambient: 0.1,
        diffuse: 0.2,
        specular: 0.8,
        ..PointLight::default()
    };
    all_beside(POWERS.iter().map(|row| ball_by(row.run.draw, 96, light, 16.0)))
}

fn behind() -> anyhow::Result<Drawing> {
    let subject = of_ball(96, ENAMEL)?;
    let draw = *method(METHODS, "blinn-phong")?;
    let position = 4.0 * Vec3::new((0.68 * PI).sin(), 0.15, (0.68 * PI).cos());
    all_beside([1.0, 4.0, 32.0].map(|shininess| {
        let light = PointLight { position, shininess, ..PointLight::default() };
        lit(&subject, Mat4::IDENTITY, FRONT, light, draw, 300)
    }))
}

fn short() -> anyhow::Result<Drawing> {
    let light = PointLight { position: Vec3::new(1.2, 1.2, 4.0), ..PointLight::default() };
    let subject = of_ball(16, ENAMEL)?;
    all_beside(["exact", "never"].map(|name| {
        let draw = method(NORMALISATIONS, name)?.draw;
        lit(&subject, Mat4::IDENTITY, FRONT, light, draw, 440)
    }))
}

/// Blinn's model with a fault: nobody asks whether the light is behind the surface.
struct Leaking(PointLight);

impl Reflection for Leaking {
    fn new(light: &PointLight) -> Self {
        Self(*light)
    }

    fn reflect(&self, point: Vec3, normal: Vec3, eye: Vec3) -> Reflected {
        let PointLight { position, ambient, diffuse, specular, shininess, .. } = self.0;
        let [n, l, v] = [normal, position - point, eye - point].map(Vec3::normalize_or_zero);
        let half = (l + v).normalize_or_zero();
        Reflected {
            body: ambient + diffuse * n.dot(l).max(0.0),
            highlight: specular * n.dot(half).max(0.0).powf(shininess),
        }
    }
}

fn leak() -> anyhow::Result<Drawing> {
    let subject = of_ball(96, ENAMEL)?;
    let position = 4.0 * Vec3::new((0.72 * PI).sin(), 0.15, (0.72 * PI).cos());
    let light = PointLight { position, shininess: 16.0, ..PointLight::default() };
    let ways: [Draw; 2] = [*method(METHODS, "blinn-phong")?, |scene, mesh, cull, image| {
        draw(&PerPixel::<Leaking>::new(scene, Smooth), mesh, cull, image)
    }];
    all_beside(ways.map(|way| lit(&subject, Mat4::IDENTITY, FRONT, light, way, 440)))
}

/// A picture of the course's assets.
fn asset(name: &str) -> anyhow::Result<Image> {
    Ok(Image::read(&Path::new(ASSETS).join(name))?)
}

const ASSETS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets");

/// The head in 638 triangles.
fn of_low_head() -> anyhow::Result<Subject> {
    let model = common::Model::read(&Path::new(ASSETS).join("head-low.obj"), ALL)?;
    Ok(subject(model, texture()?))
}

/// A subject by one of the looks, with these maps.
fn looking(
    (loaded, mesh): &Subject,
    seen: Seen,
    light: PointLight,
    (name, maps): (&str, &Maps),
    side: u16,
) -> anyhow::Result<Image> {
    let scene =
        Scene::placed(loaded, Mat4::IDENTITY, camera(seen)?, seen.0, light).context("it is not flat")?;
    let mut image = canvas(3 * side);
    (method(LOOKS, name)?.draw)(&scene, maps, mesh, Cull::Back, &mut image);
    Ok(image.scale(side, side))
}

/// The head's maps for a look.
pub(crate) fn maps_of(name: &str) -> anyhow::Result<Maps> {
    let look = method(LOOKS, name)?;
    let Maps { normals, shine } = Maps::default();
    let read = |file: Option<&str>, otherwise: Image| -> anyhow::Result<Image> {
        file.map_or(Ok(otherwise), |file| Ok(Image::read(Path::new(file))?))
    };
    Ok(Maps { normals: read(look.normals, normals)?, shine: read(look.shine, shine)? })
}

fn maps() -> anyhow::Result<Drawing> {
    let maps = ["head-normals.png", "head-tangents.png"].map(|name| Ok(asset(name)?.scale(440, 440)));
    all_beside(maps)
}

fn tangents_of_a_triangle() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.6, -1.05), (11.4, 4.5));
    // In the plane of (u, v), and in space, seen straight from before it.
    let uvs = [at(0.2, 0.15), at(0.85, 0.3), at(0.4, 0.9)];
    let places = [at(6.0, 0.2), at(10.4, -0.2), at(8.6, 3.6)];
    let flat = uvs.map(|uv| uv * 4.0);
    sheet.arrow((0.0, 0.0), (4.4, 0.0), GREY);
    sheet.arrow((0.0, 0.0), (0.0, 4.3), GREY);
    sheet.text((4.45, -0.4), "u", GREY);
    sheet.text((-0.35, 4.2), "v", GREY);
    let [t, b] = tangents(places.map(|p| p.extend(0.0)), uvs).context("the triangle has an area")?;
    // They are as long as they are for a patch of the triangle's area.
    let area = f64::from((uvs[1] - uvs[0]).perp_dot(uvs[2] - uvs[0]));
    let [t, b] = [t, b].map(|side| (side / area).as_vec3().truncate());
    let place = |uv: Vec2| places[0] + (uv.x - uvs[0].x) * t + (uv.y - uvs[0].y) * b;
    sheet.polygon(&flat, PALE, BLACK);
    sheet.polygon(&places, PALE, BLACK);
    for n in 0..=5 {
        let share = n as f32 * 0.2;
        for [from, to] in [[at(share, 0.0), at(share, 1.0)], [at(0.0, share), at(1.0, share)]] {
            sheet.line(from * 4.0, to * 4.0, FAINT, 1.4);
            // Of the grid on the triangle only what lies on it.
            let inside: Vec<Vec2> = (0..=100)
                .map(|step| from.lerp(to, step as f32 / 100.0))
                .filter(|uv| {
                    let side = |n: usize| (uvs[(n + 1) % 3] - uvs[n]).perp_dot(uv - uvs[n]) >= 0.0;
                    side(0) && side(1) && side(2)
                })
                .map(place)
                .collect();
            if let [first, .., last] = inside[..] {
                sheet.line(first, last, FAINT, 1.4);
            }
        }
    }
    for (n, (uv, place)) in flat.into_iter().zip(places).enumerate() {
        let name = ["0", "1", "2"][n];
        let away = [at(-0.3, -0.25), at(0.3, -0.2), at(0.0, 0.35)][n];
        for at in [uv, place] {
            sheet.dot(at, BLACK);
            sheet.text(at + away, name, BLACK);
        }
    }
    let foot = at(0.42, 0.42);
    for (step, name, ink) in [(at(0.2, 0.0), "T", ORANGE), (at(0.0, 0.2), "B", BLUE)] {
        sheet.arrow(foot * 4.0, (foot + step) * 4.0, ink);
        sheet.arrow(place(foot), place(foot + step), ink);
        sheet.text(place(foot + step * 1.35), name, ink);
    }
    sheet.text((2.0, -0.85), "the map", GREY);
    sheet.text((8.4, -0.85), "the triangle", GREY);
    sheet.finish()
}

/// Round bosses in tangent space, four to a square; (u, v) from 0 to 2 and 0 to 1.
fn boss(uv: Vec2) -> Vec3 {
    let from_middle = (uv * 2.0).fract() - 0.5;
    let slope = 0.42 - from_middle.length();
    // A cap of a ball: it leans outwards, and ends at a rim.
    if slope > 0.0 { (from_middle * 1.7).extend(1.0).normalize() } else { Vec3::Z }
}

fn mirrored() -> anyhow::Result<Drawing> {
    let light = PointLight { position: Vec3::new(-2.0, 1.2, 1.2), shininess: 24.0, ..PointLight::default() };
    let eye = Vec3::new(1.0, 0.5, 3.0);
    // The wall from (0, 0) to (2, 1); on its right half u runs back.
    let picture = |asked: bool| {
        painted(900, 225, |x, y| {
            let wide = at_pixel(x, y) / 225.0;
            let (point, back) = (Vec3::new(wide.x / 2.0, wide.y / 2.0, 0.0), wide.x > 2.0);
            let uv = if back { Vec2::new(4.0 - wide.x, wide.y) } else { wide };
            let tangent = if back { Vec3::NEG_X } else { Vec3::X };
            let handed = if back && asked { -1.0 } else { 1.0 };
            let normal = turned(boss(uv / 2.0), tangent.extend(handed), Vec3::Z);
            blinn_phong(point, normal, eye, &light).color(Color::rgb(0xc9, 0x9a, 0x5b))
        })
    };
    let mut both = Image::new(900, 454, common::Format::Rgb);
    paste(&picture(true), &mut both, [0, 229]);
    paste(&picture(false), &mut both, [0, 0]);
    Ok(Drawing::Pixels(both, 1))
}

fn at_pixel(x: i32, y: i32) -> Vec2 {
    Vec2::new(x as f32 + 0.5, y as f32 + 0.5)
}

/// From near, so that the outline of the cheek is seen.
const NEAR: Seen = (Vec3::new(0.55, 0.35, 2.35), Vec3::new(0.0, 0.28, 0.0), 30.0);

fn few() -> anyhow::Result<Drawing> {
    let low = of_low_head()?;
    let text = assets::head::model_of(22_400).to_obj();
    let fine = subject(crate::figures::shape::parsed(&text)?, texture()?);
    let map = Maps { normals: asset("head-low-tangents.png")?, ..Maps::default() };
    let none = Maps::default();
    let light = PointLight { specular: 0.25, diffuse: 0.6, ..PointLight::default() };
    all_beside(
        [(&low, "plain", &none), (&low, "tangent-normals", &map), (&fine, "plain", &none)]
            .map(|(subject, name, maps)| looking(subject, NEAR, light, (name, maps), 300)),
    )
}

fn ear() -> anyhow::Result<Drawing> {
    let head = of_head()?;
    let seen = (Vec3::new(-2.3, 0.2, 0.5), Vec3::new(-0.3, 0.16, -0.1), 17.0);
    let light = PointLight { position: Vec3::new(-2.0, 1.2, 1.6), ..PointLight::default() };
    all_beside(
        ["object-normals", "tangent-normals"]
            .map(|name| looking(&head, seen, light, (name, &maps_of(name)?), 440)),
    )
}

fn surfaces() -> anyhow::Result<Drawing> {
    let head = of_head()?;
    let light = PointLight::default();
    all_beside(LOOKS.iter().map(|row| looking(&head, NEAR, light, (row.name, &maps_of(row.name)?), 300)))
}
