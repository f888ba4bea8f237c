//! Lesson 15: the share of a pixel that a triangle covers.

use antialiasing::area::{Area, area, clipped};
use antialiasing::multisampled::{At, Multisampled};
use antialiasing::ordered::Ordered;
use antialiasing::pattern::{PATTERNS, PLACES, Place, pattern};
use antialiasing::storage::{Compressed, Samples};
use antialiasing::{Canvas, coverage, resolve};
use blending::State;
use blending::scene::{self, Entity, EntityShader};
use blending::transparency::{Placed, gather};
use clipping::Cull;
use common::{Color, IVec2, Image, Mat4, Method, Vec2, Vec3, Vec4Swizzles};
use lighting::PointLight;
use shaders::shader::{Fragment, Shader};
use sheet::{AMBER, BLACK, BLUE, FAINT, GREY, ORANGE, Sheet};

use crate::head::{self, canvas, method};
use crate::input::with;
use crate::scenes::{SCENE, camera};
use crate::{Drawing, Figure, Input, Values, View, number, whole};

/// The head in few pixels.
pub(crate) const HEAD: Figure = Figure {
    name: "antialiasing-head",
    stays: true,
    hint: "Turn the head by dragging it, or by the sliders. Choose another method.",
    inputs: &[Input::Turn { from: [-72.0, 4.0] }, method(|| Method::rows(antialiasing::METHODS), "msaa-16")],
    draw: antialiased,
};

/// Width and height of the head's picture.
const SIDE: u16 = 88;

/// The lesson's methods, each with its way here.
const WAYS: &[Method<Way>] = &with(
    antialiasing::METHODS,
    [
        Way::None,
        per_sample(4),
        per_sample(16),
        Way::Ordered,
        per_pixel(2),
        per_pixel(4),
        per_pixel(8),
        per_pixel(16),
        Way::Area,
    ],
);

/// Any of the lesson's ways to draw a single opaque model, on four kinds of canvas, where the lesson has nine.
#[derive(Clone, Copy)]
enum Way {
    None,
    Ordered,
    Area,
    /// With so many samples, shaded there.
    Samples {
        count: usize,
        at: At,
    },
}

const fn per_sample(count: usize) -> Way {
    Way::Samples { count, at: At::Sample }
}

const fn per_pixel(count: usize) -> Way {
    Way::Samples { count, at: At::Centroid }
}

impl Way {
    fn draw(self, entity: &Entity, view: &scene::View, picture: &mut Image) {
        const SIZE: [usize; 2] = [SIDE as usize; 2];
        match self {
            Self::None => draw_to(Multisampled::<1, Samples<1>>::new(SIZE), entity, view, picture),
            Self::Ordered => draw_to(Ordered::new(SIZE), entity, view, picture),
            Self::Area => draw_to(Area::new(SIZE), entity, view, picture),
            Self::Samples { count, at } => {
                draw_to(Sixteen::with_places(SIZE, &sixteen(count), at), entity, view, picture);
            }
        }
    }

    fn samples(self) -> usize {
        match self {
            Self::None | Self::Area => 1,
            Self::Ordered => 16,
            Self::Samples { count, .. } => count,
        }
    }
}

type Sixteen = Multisampled<16, Compressed<16>, At>;

/// The places of a standard pattern, each as many times as makes sixteen: what is covered, its centroid and its mean are the
/// same.
fn sixteen(count: usize) -> [Place; 16] {
    std::array::from_fn(|sample| pattern(count)[sample % count])
}

/// Draws a model to a canvas, and that to a picture.
fn draw_to<C: Canvas<Stencil = ()>>(mut canvas: C, entity: &Entity, view: &scene::View, picture: &mut Image) {
    let shader = entity.shader(view, canvas.size()).expect("it is not flat");
    let mut triangles = Vec::new();
    gather(&shader, entity.mesh(), Cull::Back, canvas.size(), &mut triangles);
    for Placed { constant, corners, varyings, .. } in triangles {
        canvas.fill(State::OFF, corners, varyings, |fragment| shade(&shader, constant, fragment));
    }
    canvas.resolve(resolve, picture);
}

/// What the model looks like, on all canvases.
#[inline(never)]
fn shade<'a>(
    shader: &EntityShader<'a>,
    constant: <EntityShader<'a> as Shader>::Constant,
    fragment: Fragment<<EntityShader<'a> as Shader>::Varying>,
) -> Option<Color> {
    shader.fragment(constant, fragment)
}

fn antialiased(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let method = values.choice(WAYS);
    let mut image = canvas(SIDE);
    let (entity, view) = seen(turn);
    method.run.draw(&entity, &view, &mut image);
    let rest = format!("samples of each pixel: {}", method.run.samples());
    head::view(image, method.name, "the head", turn, &rest)
}

/// The head, and from where it is seen.
fn seen(turn: [f32; 2]) -> (Entity<'static>, scene::View) {
    let (to_clip, eye) = camera((Vec3::new(0.0, -0.03, 0.0), 3.46, 45.0), turn);
    let light = PointLight { position: eye + Vec3::Y, ambient: 0.1, diffuse: 0.9, ..PointLight::default() };
    let view = scene::View { to_clip, eye, light };
    (Entity { model: &SCENE[0], to_world: Mat4::IDENTITY, alpha: 1.0 }, view)
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use antialiasing::{METHODS, Scene, World};

    #[test]
    fn the_head_is_as_the_lesson_draws_it() {
        for turn in [[-72.0, 4.0], [0.0, 0.0], [33.0, -50.0], [170.0, 80.0]] {
            let (entity, view) = seen(turn);
            let world = Some(World { entities: &[entity], view, cull: Cull::Back });
            let scene = Scene { world, ..Scene::of(&[], Color::BLACK) };
            for (own, lesson) in WAYS.iter().zip(METHODS) {
                let [mut drawn, mut meant] = [canvas(SIDE), canvas(SIDE)];
                own.run.draw(&entity, &view, &mut drawn);
                (lesson.run.picture)(&scene, &mut meant);
                assert!(drawn == meant, "{}, {turn:?}", own.name);
                assert_eq!(own.run.samples(), lesson.run.samples, "{}", own.name);
            }
        }
    }
}
