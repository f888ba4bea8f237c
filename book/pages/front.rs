//! The first pages.

use common::compare::Difference;
use common::{Color, IVec2, Image, Vec2, Vec3};
use gouraud::{Scene, Wrap, corner_normals};
use lines::METHODS;
use triangles::{draw_model, flat_intensity};
use zbuffer::to_screen;

use crate::figures::picture::{beside, canvas, method, model, texture};
use crate::figures::{Drawing, Figure};
use crate::lessons::gouraud::figures::smooth;

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "welcome",
        "Four pictures of a head side by side: as a wireframe, with its triangles in random colours, in flat grey, \
         and smoothly lit with its texture.",
        welcome,
    ),
    Figure::new(
        "first-compare",
        "Three small black pictures side by side: two lines by Bresenham's algorithm, the same by the slides' \
         listing, and their difference, in which many pixels of the steep line are orange and blue.",
        compare,
    ),
];

fn welcome() -> anyhow::Result<Drawing> {
    let model = model()?;
    let [mut wires, mut random, mut lit] = [(); 3].map(|()| canvas(600));
    wireframe::wireframe(&model, &mut wires, Color::WHITE);
    let exact = method(triangles::METHODS, "edges")?;
    // What faces away is left out, as there is no depth buffer yet.
    let brightness = |corners| Some(flat_intensity(corners, Vec3::Z)).filter(|&i| i >= 0.0);
    draw_model(&model, exact, &mut random, |n, corners| brightness(corners).map(|_| Color::random(n as u64)));
    draw_model(&model, exact, &mut lit, |_, corners| brightness(corners).map(Color::gray));
    let (texture, normals) = (texture()?, corner_normals(&model));
    let scene =
        Scene { model: &model, normals: &normals, texture: &texture, wrap: Wrap::Clamp, light: Vec3::Z };
    let smooth = smooth(600, &scene, |point| Some(to_screen(point, Vec2::splat(600.0))));
    beside([&wires, &random, &lit, &smooth])
}

fn compare() -> anyhow::Result<Drawing> {
    let draw = |name: &str| -> anyhow::Result<Image> {
        let draw = method(METHODS, name)?.draw;
        let mut image = canvas(100);
        draw(IVec2::new(13, 20), IVec2::new(80, 40), &mut image, Color::WHITE);
        draw(IVec2::new(20, 13), IVec2::new(40, 80), &mut image, Color::RED);
        Ok(image)
    };
    let (a, b) = (draw("bresenham")?, draw("listing")?);
    let difference = Difference::between(&a, &b).picture(&a);
    beside([&a, &b, &difference])
}
