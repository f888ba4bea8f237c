//! Version 0's formula: places, not pixels; not cast; not of the picture's proportions.

use checks::assignment::{Placement, mirrored, pixel, shown};
use checks::coverage::Triangle;
use common::{Bounds, Color, DVec2, DVec3, IVec2, Image, Mat4, Vec2, Vec3};
use perspective::window;
use proptest::prelude::*;
use scene::levels::spheres;
use scene::versions::orthographic;
use scene::{Entity, Paint, Target, VERSIONS, render_scene};

use crate::pictures::ahead;
use crate::versions::scene_at;

/// The window.
const SIZE: [u16; 2] = [1024, 768];

/// The picture of a version's scene, as large as the assignment's window.
fn large(number: usize) -> Image {
    let mut target = Target::new(SIZE[0], SIZE[1]);
    let projection = (VERSIONS[number].projection)(target.picture().size());
    render_scene(&scene_at(number, 0.0), &mut target, &projection, &Mat4::IDENTITY);
    target.into_picture()
}

/// The first and the last column and row, rows from the bottom, in which something is, within some columns.
fn extent(picture: &Image, columns: std::ops::Range<i32>) -> Bounds {
    let there = picture.pixels().filter(|pixel| columns.contains(&pixel.0) && pixel.2 != Color::BLACK);
    let none = Bounds { min: IVec2::MAX, max: IVec2::MIN };
    there.fold(none, |Bounds { min, max }, (x, y, _)| {
        let at = IVec2::new(x, y);
        Bounds { min: min.min(at), max: max.max(at) }
    })
}

/// Columns and rows.
fn sides(Bounds { min, max }: Bounds) -> [i32; 2] {
    (max - min + 1).to_array()
}

/// Where the course's projection shows a point of the assignment's space, from the upper left corner, y down.
fn place(point: DVec3, size: DVec2) -> DVec2 {
    let clip = orthographic(size.as_vec2()) * mirrored(point).as_vec3().extend(1.0);
    let at = window(clip, size.as_vec2()).expect("nothing is behind an orthographic camera").as_dvec4();
    DVec2::new(at.x, size.y - at.y)
}

/// In f32 a place of up to 2000 px is rounded to 2⁻¹³ px.
const ROUNDED: f64 = 1e-3;

proptest! {
    #[test]
    fn the_projection_is_the_formula(
        point in [-7.0..7.0, -7.0..7.0, 0.0..4.0_f64], size in [1.0..2000.0, 1.0..2000.0_f64],
    ) {
        let (point, size) = (DVec3::from(point).as_vec3().as_dvec3(), DVec2::from(size).round());
        let (got, expected) = (place(point, size), pixel(point, size));
        prop_assert!((got - expected).length() < ROUNDED, "{got}, not {expected}");
    }
}

/// (−5, 5) is the upper left corner of the picture, and so is its pixel (0, 0) if what is cast is a place there; but (5, −5) is
/// the lower right corner, and cast it is in a column and a row that there are not. The middle of 800×600 is where four pixels
/// meet.
#[test]
fn the_formula_gives_places_from_border_to_border() {
    let size = DVec2::new(800.0, 600.0);
    for (point, at) in
        [([-5.0, 5.0], [0.0, 0.0]), ([5.0, -5.0], [800.0, 600.0]), ([0.0, 0.0], [400.0, 300.0])]
    {
        let found = place(DVec2::from(point).extend(0.0), size);
        assert!((found - DVec2::from(at)).length() < ROUNDED, "{point:?} is at {found}");
    }
    let image = Image::new(800, 600, common::Format::Rgb);
    let cast = |x: f64, y: f64| pixel(DVec3::new(x, y, 0.0), size).as_ivec2();
    assert!(image.get(cast(-5.0, 5.0).x, cast(-5.0, 5.0).y).is_some());
    assert_eq!(image.get(cast(5.0, -5.0).x, cast(5.0, -5.0).y), None);
    // The four pixels around the middle are equally far from it.
    for (x, y) in [(399.5, 299.5), (400.5, 299.5), (399.5, 300.5), (400.5, 300.5)] {
        let off = shown(DVec2::new(x, y), size).abs() * size;
        assert!((off - DVec2::splat(5.0)).length() < 1e-9, "{off}");
    }
}

/// What the corners' places are rounded to decides how many pixels the cube has: by centres, as the course has it, or cast, with
/// the last column and row or without them.
#[test]
fn a_cast_moves_sides_by_up_to_a_pixel() {
    let size = DVec2::new(SIZE[0].into(), SIZE[1].into());
    let [low, high] =
        [DVec3::new(-3.0, 0.5, 2.0), DVec3::new(-2.0, -0.5, 2.0)].map(|corner| pixel(corner, size));
    assert!(
        (low - DVec2::new(204.8, 345.6)).length() < 1e-9 && (high - DVec2::new(307.2, 422.4)).length() < 1e-9
    );
    let picture = large(0);
    let white = picture.pixels().filter(|pixel| pixel.0 < 512 && pixel.2 == Color::WHITE).count();
    assert_eq!((white, sides(extent(&picture, 0..512))), (102 * 76, [102, 76]));
    let cast = high.as_ivec2() - low.as_ivec2();
    assert_eq!([cast, cast + 1].map(|sides| sides.x * sides.y), [103 * 77, 104 * 78]);
    // A cast is towards 0: on the left of the picture to the right. Two pixels' width becomes column 0.
    let column = |p: f64| p as i32;
    assert_eq!([-0.9, 0.9].map(column), [0, 0]);
}

/// Pixel for pixel what is exactly covered, corners rounded to 1/256 px.
#[test]
fn version_0_is_exact() {
    let size = DVec2::new(SIZE[0].into(), SIZE[1].into());
    let mut expected = Image::new(SIZE[0], SIZE[1], common::Format::Rgb);
    for (entity, at) in scene_at(0, 0.0).entities.iter().zip([-2.5, 2.5]) {
        let (mesh, placement) = (entity.levels.finest(), Placement::at(at, 0.0, 2.0));
        for face in 0..mesh.triangles() {
            let corners = [0, 1, 2].map(|corner| {
                let own = mesh.positions()[mesh.vertex(face, corner)].as_dvec3();
                let at = pixel(placement.place(mirrored(own)), size);
                DVec2::new(at.x, size.y - at.y).as_vec2()
            });
            let [low, high] = [
                corners.iter().fold(Vec2::MAX, |low, &c| low.min(c)),
                corners.iter().fold(Vec2::MIN, |high, &c| high.max(c)),
            ];
            let bounds = Bounds { min: low.as_ivec2(), max: high.as_ivec2() };
            Triangle::new(corners).pixels(bounds).iter().for_each(|&(x, y)| expected.set(x, y, Color::WHITE));
        }
    }
    let different = large(0).pixels().filter(|&(x, y, color)| expected.get(x, y) != Some(color)).count();
    assert_eq!(different, 0);
}

/// Ten units are as wide as the picture and as high: at 4:3 a cube is a rectangle and a sphere an ellipse. In perspective a
/// sphere straight ahead is round.
#[test]
fn the_formula_stretches_what_the_perspective_does_not() {
    let white = large(0);
    assert_eq!(sides(extent(&white, 0..512)), [102, 76]);
    let [wide, high] = sides(extent(&white, 512..1024));
    assert!((204..=205).contains(&wide) && (153..=154).contains(&high), "{wide}x{high}");
    // A tenth of the picture each way, and half of that.
    let triangle = large(1).pixels().filter(|pixel| pixel.2 != Color::BLACK).count();
    assert!(triangle.abs_diff((102.4 * 76.8 / 2.0) as usize) <= 60, "{triangle}");

    let mut scene = scene_at(0, 0.0);
    let sphere = Entity::new(spheres(&[[32, 64]], &Paint::Color(Color::WHITE)));
    scene.entities = vec![Entity { position: Vec3::new(0.0, 0.0, -3.0), ..sphere }];
    for (projection, is_round) in [(ahead as fn(Vec2) -> Mat4, true), (orthographic, false)] {
        let mut target = Target::new(SIZE[0], SIZE[1]);
        let projection = projection(target.picture().size());
        render_scene(&scene, &mut target, &projection, &Mat4::IDENTITY);
        let [wide, high] = sides(extent(target.picture(), 0..1024));
        assert_eq!(wide.abs_diff(high) <= 1, is_round, "{wide}x{high}");
    }
}
