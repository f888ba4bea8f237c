//! Lesson 6: smooth shading.
//!
//! **You will see** lesson 5's head without its facets. **New:** a normal at each corner, shared by the
//! triangles that meet there; the brightness is computed at the corners and interpolated between them
//! (H. Gouraud, *Continuous shading of curved surfaces*, IEEE Transactions on Computers C-20, 1971).
//!
//! The job: the brightness at each pixel. From lesson 5 comes the texel, from lesson 4 the depth test.
//!
//! [`METHODS`] holds three ways: no shading at all, flat, Gouraud's.
//!
//! Conventions: as in lessons 4 and 5, but nothing is left out: what faces away from the light is black. The
//! brightness is clamped at 0 **after** interpolation, so that the line between light and dark does not follow
//! the triangles' sides. Normals and light are in the same space.

pub mod flags;
pub mod normals;

use common::{Color, Image, Lesson, Method, Model, Table, Vec2, Vec3};
use textures::{interpolate, repeat, texel};
use triangles::flat_intensity;
use zbuffer::{DepthBuffer, fill_nearest, to_screen};

pub use normals::corner_normals;
pub use textures::Wrap;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 6,
    name: "gouraud",
    title: "Smooth shading",
    job: "smooth shading",
    tables: &[Table { name: "", job: "Shade smoothly", rows: || Method::rows(METHODS) }],
};

/// What is drawn, and under which light.
pub struct Scene<'a> {
    /// Positions and texture coordinates.
    pub model: &'a Model,
    /// The unit normals at the corners of each triangle.
    pub normals: &'a [[Vec3; 3]],
    /// The texture.
    pub texture: &'a Image,
    /// What the texture is outside.
    pub wrap: Wrap,
    /// Unit vector from the surface to the light.
    pub light: Vec3,
}

/// What a drawing leaves behind besides the picture.
pub struct Drawn {
    /// The nearest depth in each pixel.
    pub depths: DepthBuffer<f32>,
    /// How many triangles were left out since a corner of theirs has no place in the picture.
    pub left_out: usize,
}

/// Draws a scene as lessons 4 and 5 place it.
pub type Draw = fn(&Scene, &mut Image) -> Drawn;

/// The ways to shade, from the first idea to the last.
pub const METHODS: &[Method<Draw>] = &[
    Method {
        name: "none",
        run: |scene, image| {
            let place = as_it_stands(image.size());
            draw(scene, image, place, |_, _| |_| 1.0)
        },
        promise: "the texture's colours as they are",
        failure: "no shape to be seen",
    },
    Method {
        name: "flat",
        run: |scene, image| {
            let place = as_it_stands(image.size());
            draw(scene, image, place, |_, corners| {
                let intensity = flat_intensity(corners, scene.light);
                move |_| intensity
            })
        },
        promise: "the right brightness for flat faces; needs no normals",
        failure: "facets on what should be smooth, however many triangles; the eye exaggerates them",
    },
    Method {
        name: "gouraud",
        run: |scene, image| {
            let place = as_it_stands(image.size());
            gouraud(scene, image, place)
        },
        promise: "smooth; on a sphere the error falls with the square of the triangles' size",
        failure: "a highlight smaller than a triangle is lost; corners of a cube look rounded",
    },
];

/// Draws a scene with the brightness interpolated between the corners. `place` puts a point into the picture
/// (x and y in pixels, z the depth) or nowhere.
// ANCHOR: gouraud
pub fn gouraud(scene: &Scene, image: &mut Image, place: impl Fn(Vec3) -> Option<Vec3>) -> Drawn {
    draw(scene, image, place, |n, _| {
        let intensities = intensities(scene.normals[n], scene.light);
        move |weights| intensities.dot(weights).max(0.0)
    })
}

/// The brightness at three corners: the cosine of the angle between normal and light, below 0 in the dark.
#[must_use]
pub fn intensities(normals: [Vec3; 3], light: Vec3) -> Vec3 {
    Vec3::from_array(normals.map(|normal| normal.dot(light)))
}
// ANCHOR_END: gouraud

/// Places points as lessons 4 and 5 do, without perspective.
fn as_it_stands(size: Vec2) -> impl Fn(Vec3) -> Option<Vec3> {
    move |point| Some(to_screen(point, size))
}

/// As [`draw_sampled`], with the sample that the scene's texture has outside.
fn draw<S: Fn(Vec3) -> f32>(
    scene: &Scene,
    image: &mut Image,
    place: impl Fn(Vec3) -> Option<Vec3>,
    shade: impl Fn(usize, [Vec3; 3]) -> S,
) -> Drawn {
    // A loop for each, so that no pixel asks which it is.
    match scene.wrap {
        Wrap::Clamp => draw_sampled(scene, image, place, shade, texel),
        Wrap::Repeat => draw_sampled(scene, image, place, shade, repeat),
    }
}

/// Draws a textured scene, whose `sample` gives the texel of (u, v). `shade` gives the brightness in a triangle, by its number
/// and corners, as a function of the barycentric weights; `place` puts a point into the picture or nowhere.
// ANCHOR: draw
pub fn draw_sampled<S: Fn(Vec3) -> f32>(
    scene: &Scene,
    image: &mut Image,
    place: impl Fn(Vec3) -> Option<Vec3>,
    shade: impl Fn(usize, [Vec3; 3]) -> S,
    sample: impl Fn(&Image, Vec2) -> Color,
) -> Drawn {
    let mut drawn = Drawn { depths: DepthBuffer::new(image, f32::NEG_INFINITY), left_out: 0 };
    for (n, (corners, uvs)) in scene.model.faces().zip(scene.model.face_uvs()).enumerate() {
        let [Some(a), Some(b), Some(c)] = corners.map(&place) else {
            drawn.left_out += 1;
            continue;
        };
        let intensity = shade(n, corners);
        fill_nearest(
            [a, b, c],
            &mut drawn.depths,
            |depth| depth,
            |x, y, weights| {
                let color = sample(scene.texture, interpolate(uvs, weights));
                image.set(x, y, color.shaded(intensity(weights)));
            },
        );
    }
    drawn
}
// ANCHOR_END: draw
