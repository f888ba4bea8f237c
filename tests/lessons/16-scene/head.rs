//! The head in levels: how far apart they are, and what is seen where one takes the place of another.

use std::path::Path;
use std::sync::Arc;

use checks::apart::Surface;
use checks::picture::distance;
use clipping::Cull;
use common::program::model::DEFAULT_TEXTURE;
use common::{Attributes, Color, Image, Mat4, Method, Model, Vec2, Vec3};
use filtering::{MIPMAPS, Wrap};
use lighting::PointLight;
use perspective::{perspective, view};
use scene::frustum::{Sphere, pixels_per_unit};
use scene::head::{STAGES, Stage, head};
use scene::{Entity, Filtering, Levels, Paint, Scene, Shading, Style, Target, render_scene};

/// The triangles of a stage, in `f64`.
fn surface(file: &str) -> Surface {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../assets").join(file);
    let model = Model::read(&path, Attributes::default()).unwrap();
    Surface::new(model.faces().map(|face| face.map(Vec3::as_dvec3)).collect())
}

/// The table's distances are upper bounds, and hardly larger than what was found: the farther of the two ways, as shoulders that
/// coarse triangles cut off are far from these, but these are not far from the shoulders.
#[test]
fn a_stage_is_no_farther_from_the_finest_than_the_table_says() {
    let [coarser @ .., finest] = STAGES else { panic!("no stage") };
    assert_eq!(finest.distance, 0.0);
    let finest = surface(finest.file);
    for stage in coarser {
        let distance = f64::from(stage.distance);
        let (tolerance, coarse) = (distance / 10.0, surface(stage.file));
        let [there, back] = [finest.farthest(&coarse, tolerance), coarse.farthest(&finest, tolerance)];
        let range = 0.87 * distance..=0.9 * distance;
        assert!(
            range.contains(&there.max(back)),
            "{}: {} is not within {range:?}",
            stage.file,
            there.max(back)
        );
    }
}

/// A head of one stage.
fn alone(stage: &Stage, paint: &Paint) -> Arc<Levels> {
    Levels::one(stage.mesh(paint).unwrap())
}

/// The head's texture with all its levels.
fn paint() -> Paint {
    let picture = Image::read(DEFAULT_TEXTURE.as_ref()).unwrap();
    let mipmap = Method::find(MIPMAPS, "box-linear").unwrap().run;
    Paint::Texture(Arc::new(mipmap.texture(&picture, Wrap::Repeat)))
}

/// A camera that looks at the head from a distance, in a square picture.
struct Camera {
    projection: Mat4,
    inverse_camera: Mat4,
    side: u16,
}

/// The background: no pixel of a head is green.
const BEHIND: Color = Color::rgb(0, 255, 0);

impl Camera {
    /// From a direction, so far that a unit of the head is at most so many pixels by what [`pixels_per_unit`] says, all of which
    /// is in the picture.
    fn new(bounds: &Sphere, pixels: f32, from: Vec3) -> Self {
        let side = (2.5 * bounds.radius * pixels).ceil().max(16.0) as u16;
        let projection = perspective(20.0, 1.0, 0.1, 1e4).unwrap();
        let looks = |distance: f32| view(from.normalize() * distance, Vec3::ZERO, Vec3::Y).unwrap();
        let given =
            |distance| pixels_per_unit(&(projection * looks(distance)), bounds, Vec2::splat(side.into()));
        // It falls with the distance.
        let (mut near, mut far) = (bounds.center.length() + bounds.radius, 1e4);
        for _ in 0..60 {
            let middle = f32::midpoint(near, far);
            if given(middle) > pixels { near = middle } else { far = middle }
        }
        Self { projection, inverse_camera: looks(far), side }
    }

    /// What it sees, moved to the right by so many pixels.
    fn sees(&self, levels: &Arc<Levels>, antialiased: bool, moved: f32) -> Image {
        let scene = Scene {
            entities: vec![Entity::new(levels.clone())],
            lights: vec![PointLight { position: Vec3::new(3.0, 4.0, 6.0), ..PointLight::default() }],
            background: BEHIND,
            style: Style { shading: Shading::BlinnPhong, filter: Filtering::Trilinear, cull: Cull::Back },
        };
        let aside = Mat4::from_translation(Vec3::X * (2.0 * moved / f32::from(self.side)));
        let mut target = Target::new(self.side, self.side);
        target.antialiased = antialiased;
        render_scene(&scene, &mut target, &(aside * self.projection), &self.inverse_camera);
        target.into_picture()
    }
}

/// The sum of all differences, each the largest of a pixel's channels.
fn difference(a: &Image, b: &Image) -> f64 {
    a.pixels().zip(b.pixels()).map(|((.., a), (.., b))| f64::from(distance(a, b))).sum()
}

/// Directions all around, from above and from below.
fn directions() -> impl Iterator<Item = Vec3> {
    (0..12_u8).map(|n| {
        let (sin, cos) = (f32::from(n) * 30.0 + 6.0).to_radians().sin_cos();
        Vec3::new(sin, f32::from(n * 7 % 12) / 15.0 - 0.36, cos)
    })
}

/// Where one stage takes the place of another nobody sees it: the picture changes less than half as much as it would if the head
/// moved aside by a quarter of a pixel, since most of a surface is much nearer than what is farthest. So it does not matter if a
/// head on the border between two stages goes to and fro: nothing need make it stay (no hysteresis).
#[test]
fn a_change_of_stage_is_less_than_half_a_move_by_a_quarter_of_a_pixel() {
    let paint = paint();
    let all = head(&paint).unwrap();
    let bounds = Entity::new(all.clone()).bounds();
    for pair in STAGES.windows(2) {
        let [coarse, fine] = [&pair[0], &pair[1]].map(|stage| alone(stage, &paint));
        let pixels = 0.5 / pair[0].distance;
        let chosen = [0.999, 1.001].map(|share| all.choose(pixels * share).triangles());
        assert_eq!(chosen, [pair[0].triangles, pair[1].triangles]);
        for antialiased in [false, true] {
            let (mut change, mut step) = (0.0, 0.0);
            for from in directions() {
                let camera = Camera::new(&bounds, pixels, from);
                let [before, after] = [&coarse, &fine].map(|head| camera.sees(head, antialiased, 0.0));
                change += difference(&before, &after);
                step += difference(&after, &camera.sees(&fine, antialiased, 0.25));
            }
            assert!(change < 0.5 * step, "{}, {antialiased}: {change} of {step}", pair[0].file);
        }
    }
}

/// There, outlines are within a pixel of each other: where just one of the two covers a pixel, the other covers a neighbour.
#[test]
fn a_change_of_stage_moves_no_outline_by_more_than_a_pixel() {
    let paint = paint();
    let bounds = Entity::new(head(&paint).unwrap()).bounds();
    for pair in STAGES.windows(2) {
        let heads = [&pair[0], &pair[1]].map(|stage| alone(stage, &paint));
        let mut moved = 0;
        for from in directions() {
            let camera = Camera::new(&bounds, 0.5 / pair[0].distance, from);
            let [a, b] = heads.each_ref().map(|head| camera.sees(head, false, 0.0));
            for (x, y, color) in a.pixels() {
                let is_head =
                    |image: &Image, x: i32, y: i32| image.get(x, y).is_some_and(|color| color != BEHIND);
                let [in_a, in_b] = [color != BEHIND, is_head(&b, x, y)];
                if in_a != in_b {
                    moved += 1;
                    let other = if in_a { &b } else { &a };
                    let near = (-1..=1).any(|i| (-1..=1).any(|j| is_head(other, x + i, y + j)));
                    assert!(near, "{}: ({x}, {y}) from {from}", pair[0].file);
                }
            }
        }
        assert!(moved > 0, "{}: something changes", pair[0].file);
    }
}
