//! The course's ways to draw the scenes.

use clipping::Counts;
use common::{Image, Method};
use filtering::{METHODS, Surface};

use crate::Scene;

/// The filters of lesson 13 with which methods are timed.
pub const FILTERS: [&str; 2] = ["nearest", "trilinear"];

/// A method.
pub struct Way {
    /// Its name.
    pub name: &'static str,
    /// With how many threads it is timed.
    pub threads: &'static [usize],
}

/// Draws a scene's surface in a picture that is black, again and again.
pub type Drawer = Box<dyn FnMut(&Surface, &mut Image) -> Counts>;

/// All methods. The others are compared with the first.
#[must_use]
pub fn ways() -> Vec<Way> {
    vec![Way { name: "simple", threads: &[1] }]
}

/// Who draws by a method, with one of the filters and so many threads, pictures of that size.
///
/// # Panics
/// Where there is no such filter.
#[must_use]
pub fn drawer(_method: &str, filter: &str, _threads: usize, _size: [u16; 2]) -> Drawer {
    let filter = Method::find(METHODS, filter).expect("it is one of the table");
    Box::new(|surface, image| (filter.run.draw)(std::slice::from_ref(surface), Scene::CULL, image).counts)
}
