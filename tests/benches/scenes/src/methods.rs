//! The course's ways to draw the scenes.

use std::hint::black_box;

use common::Image;
use filtering::Surface;
use filtering::filter::{Filter, Nearest, Trilinear};

use crate::Scene;

/// Draws on so many threads.
pub type Draw = fn(&Surface, usize, &mut Image);

/// The names of the filters.
pub const FILTERS: [&str; 2] = ["nearest", "trilinear"];

/// A method.
pub struct Row {
    /// Its name.
    pub name: &'static str,
    /// With each of the filters.
    pub draw: [Draw; FILTERS.len()],
    /// With how many threads it is timed.
    pub threads: &'static [usize],
}

/// All methods. The others are compared with the first.
pub const METHODS: &[Row] =
    &[Row { name: "simple", draw: [simple::<Nearest>, simple::<Trilinear>], threads: &[1] }];

/// Lesson 13's.
fn simple<F: Filter + Default>(surface: &Surface, _: usize, image: &mut Image) {
    black_box(filtering::draw(std::slice::from_ref(surface), F::default(), Scene::CULL, image).counts);
}
