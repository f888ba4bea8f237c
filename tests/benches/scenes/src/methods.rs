//! The course's ways to draw the scenes.

use clipping::Counts;
use common::{Image, Method};
use filtering::Surface;
use speed::{METHODS, Picture};

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

/// Draws a scene's surface over whatever was in a picture, again and again.
pub type Drawer = Box<dyn FnMut(&Surface, &mut Image) -> Counts>;

/// All methods. The others are compared with the first.
#[must_use]
pub fn ways() -> Vec<Way> {
    let threads = |plan: Option<speed::Plan>| -> &[usize] {
        if plan.is_some_and(|plan| plan.threads != 1) { &[1, 2] } else { &[1] }
    };
    METHODS.iter().map(|row| Way { name: row.name, threads: threads(row.run.plan) }).collect()
}

/// Who draws by a method, with one of the filters and so many threads, pictures of that size.
///
/// # Panics
/// Where there is no such method or filter.
#[must_use]
pub fn drawer(method: &str, filter: &str, threads: usize, size: [u16; 2]) -> Drawer {
    let method = Method::find(METHODS, method).expect("it is one of the table");
    let filter =
        filtering::METHODS.iter().position(|row| row.name == filter).expect("it is one of the table");
    let mut draw = method.run.drawer(size.map(i32::from), filter, threads);
    Box::new(move |surface, image| {
        draw(&Picture { surfaces: std::slice::from_ref(surface), cull: Scene::CULL }, image)
    })
}
