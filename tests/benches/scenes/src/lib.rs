//! What lesson 17 is measured by: [`SCENES`], each the same in every run, the [`methods`] that draw them, and [`rounds`],
//! which times things in turn, by a [`clock`](clock::Clock).
//!
//! Tests, benchmarks, charts and the comparison with other renderers share them.
//!
//! | module | scenes |
//! |---|---|
//! | [`models`] | the head, a torus knot |
//! | [`layers`] | layers that fill the picture, nearest or farthest first |
//! | [`soup`] | a million small triangles anywhere |
//! | [`grid`] | the picture in triangles of one size |

pub mod clock;
pub mod grid;
pub mod layers;
pub mod methods;
pub mod models;
pub mod rounds;
pub mod soup;
mod stage;

use clipping::Cull;
use common::{Format, Image, Mat4, Vec3};
use filtering::Surface;
use filtering::scene::Filterable;

/// A scene: one textured mesh, smoothly lit, before a camera.
pub struct Scene {
    /// Width and height of its picture.
    pub size: [u16; 2],
    /// The mesh, with its normals and its texture.
    pub object: Filterable,
    /// Projection × view.
    pub to_clip: Mat4,
    /// Unit vector towards the light.
    pub light: Vec3,
}

impl Scene {
    /// Which triangles are left out in all scenes.
    pub const CULL: Cull = Cull::Back;

    /// What lesson 13 draws.
    #[must_use]
    pub fn surface(&self) -> Surface<'_> {
        self.object.surface(self.light, self.to_clip)
    }

    /// A picture of its size, of four bytes a pixel as other renderers' are.
    #[must_use]
    pub fn canvas(&self) -> Image {
        Image::new(self.size[0], self.size[1], Format::Rgba)
    }
}

/// A scene that can be made.
pub struct Recipe {
    /// By which it is asked for.
    pub name: &'static str,
    /// What is seen.
    pub title: &'static str,
    /// Makes it, which takes up to some seconds.
    ///
    /// # Panics
    /// Where an asset of the course is missing.
    pub make: fn() -> Scene,
}

/// The size of most pictures.
pub const FULL: [u16; 2] = [1920, 1080];

/// All scenes.
pub const SCENES: &[Recipe] = &[
    Recipe { name: "head-800", title: "the head, 800×800", make: || models::head([800, 800]) },
    Recipe { name: "head", title: "the head", make: || models::head(FULL) },
    Recipe { name: "knot", title: "a torus knot of 40,000 triangles", make: models::knot },
    Recipe { name: "front-20", title: "20 layers, front to back", make: || layers::front(20, 0.0) },
    Recipe { name: "back-20", title: "20 layers, back to front", make: || layers::back(20, 0.0) },
    Recipe {
        name: "tilted-front-20",
        title: "20 tilted layers, front to back",
        make: || layers::front(20, layers::TILT),
    },
    Recipe {
        name: "tilted-back-20",
        title: "20 tilted layers, back to front",
        make: || layers::back(20, layers::TILT),
    },
    Recipe { name: "front-200", title: "200 layers, front to back", make: || layers::front(200, 0.0) },
    Recipe { name: "back-200", title: "200 layers, back to front", make: || layers::back(200, 0.0) },
    Recipe {
        name: "tilted-front-200",
        title: "200 tilted layers, front to back",
        make: || layers::front(200, layers::TILT),
    },
    Recipe {
        name: "tilted-back-200",
        title: "200 tilted layers, back to front",
        make: || layers::back(200, layers::TILT),
    },
    Recipe { name: "soup", title: "10⁶ triangles of 4 px", make: || soup::soup(1_000_000, 4.0) },
    Recipe { name: "size-1", title: "triangles of 1 px", make: || grid::grid(1.0) },
    Recipe { name: "size-4", title: "triangles of 4 px", make: || grid::grid(4.0) },
    Recipe { name: "size-16", title: "triangles of 16 px", make: || grid::grid(16.0) },
    Recipe { name: "size-64", title: "triangles of 64 px", make: || grid::grid(64.0) },
    Recipe { name: "size-256", title: "triangles of 256 px", make: || grid::grid(256.0) },
    Recipe { name: "size-1024", title: "triangles of 1,024 px", make: || grid::grid(1024.0) },
    Recipe { name: "size-4096", title: "triangles of 4,096 px", make: || grid::grid(4096.0) },
    Recipe { name: "size-16384", title: "triangles of 16,384 px", make: || grid::grid(16_384.0) },
    Recipe { name: "size-65536", title: "triangles of 65,536 px", make: || grid::grid(65_536.0) },
    Recipe { name: "size-screen", title: "2 triangles that fill the picture", make: || grid::grid(1e6) },
];

/// The scene of that name, if there is one.
#[must_use]
pub fn find(name: &str) -> Option<&'static Recipe> {
    SCENES.iter().find(|recipe| recipe.name == name)
}

#[cfg(test)]
mod tests;
