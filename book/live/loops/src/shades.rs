//! Lesson 6's methods, chosen when the program runs: one loop for all, where the lesson has one for each and for each wrap.

use common::{Image, Vec3};
use gouraud::{Drawn, Scene, draw_sampled, intensities};
use textures::texel;
use triangles::flat_intensity;

/// Any of the lesson's methods.
#[derive(Clone, Copy, PartialEq)]
pub enum Shade {
    /// The colours as they are.
    None,
    /// One brightness a triangle.
    Flat,
    /// The brightness at the corners, interpolated.
    Gouraud,
}

impl Shade {
    /// Draws a scene whose texture is clamped, its points put into the picture by `place`.
    pub fn draw(self, scene: &Scene, image: &mut Image, place: &dyn Fn(Vec3) -> Option<Vec3>) -> Drawn {
        let shade = |n: usize, corners| {
            let at_corners = match self {
                Self::None => Vec3::ONE,
                Self::Flat => Vec3::splat(flat_intensity(corners, scene.light)),
                Self::Gouraud => intensities(scene.normals[n], scene.light),
            };
            move |weights| if self == Self::Gouraud { at_corners.dot(weights).max(0.0) } else { at_corners.x }
        };
        draw_sampled(scene, image, place, shade, texel)
    }

    /// The same with points placed as the lesson's methods place them.
    pub fn draw_as_it_stands(self, scene: &Scene, image: &mut Image) -> Drawn {
        let size = image.size();
        self.draw(scene, image, &|point| Some(zbuffer::to_screen(point, size)))
    }
}
