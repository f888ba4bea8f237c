//! The lessons: each has its chapter, its figures and its charts in a folder of `book/lessons/`.

use std::path::PathBuf;

use common::Table;

use crate::figures::Figure;
#[cfg(feature = "measure")]
use crate::measuring::table::Chart;

#[path = "../../lessons/15-antialiasing/mod.rs"]
pub(crate) mod antialiasing;
#[path = "../../lessons/14-blending/mod.rs"]
pub(crate) mod blending;
#[path = "../../lessons/08-camera/mod.rs"]
pub(crate) mod camera;
#[path = "../../lessons/11-clipping/mod.rs"]
pub(crate) mod clipping;
#[path = "../../lessons/13-filtering/mod.rs"]
pub(crate) mod filtering;
#[path = "../../lessons/06-gouraud/mod.rs"]
pub(crate) mod gouraud;
#[path = "../../lessons/12-lighting/mod.rs"]
pub(crate) mod lighting;
#[path = "../../lessons/01-lines/mod.rs"]
pub(crate) mod lines;
#[path = "../../lessons/10-perspective/mod.rs"]
pub(crate) mod perspective;
#[path = "../../lessons/16-scene/mod.rs"]
pub(crate) mod scene;
#[path = "../../lessons/09-shaders/mod.rs"]
pub(crate) mod shaders;
#[path = "../../lessons/17-speed/mod.rs"]
pub(crate) mod speed;
#[path = "../../lessons/05-textures/mod.rs"]
pub(crate) mod textures;
#[path = "../../lessons/07-transforms/mod.rs"]
pub(crate) mod transforms;
#[path = "../../lessons/03-triangles/mod.rs"]
pub(crate) mod triangles;
#[path = "../../lessons/02-wireframe/mod.rs"]
pub(crate) mod wireframe;
#[path = "../../lessons/04-zbuffer/mod.rs"]
pub(crate) mod zbuffer;

/// All lessons, in their order.
pub const LESSONS: &[Lesson] = &[
    lines::LESSON,
    wireframe::LESSON,
    triangles::LESSON,
    zbuffer::LESSON,
    textures::LESSON,
    gouraud::LESSON,
    transforms::LESSON,
    camera::LESSON,
    shaders::LESSON,
    perspective::LESSON,
    clipping::LESSON,
    lighting::LESSON,
    filtering::LESSON,
    blending::LESSON,
    antialiasing::LESSON,
    scene::LESSON,
    speed::LESSON,
];

/// What the book shows of a lesson.
pub struct Lesson {
    /// What the lesson says of itself.
    pub lesson: common::Lesson,
    /// Its methods, in a few words.
    pub methods: &'static str,
    /// What its picture, as its program draws it, shows.
    pub picture: &'static str,
    /// Further pictures that its program draws.
    pub more_pictures: &'static [Picture],
    /// The figures of its chapter.
    pub(crate) figures: &'static [Figure],
    /// Its charts: for each table of methods one or more.
    #[cfg(feature = "measure")]
    pub(crate) charts: &'static [Chart],
}

/// A picture that a lesson's program draws.
pub struct Picture {
    /// Of its file, without ending.
    pub name: &'static str,
    /// How to draw it.
    pub flags: &'static [&'static str],
}

impl Lesson {
    /// Its folder in the book, from the book's own.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        PathBuf::from("lessons").join(self.lesson.folder())
    }
}

/// Every table of methods, and what it is called: `07-transforms-rotations`, or `01-lines` for `METHODS`.
pub fn tables() -> impl Iterator<Item = (String, &'static Table)> {
    LESSONS.iter().flat_map(|lesson| {
        let name = |table: &Table| match table.name {
            "" => lesson.lesson.folder(),
            name => format!("{}-{name}", lesson.lesson.folder()),
        };
        lesson.lesson.tables.iter().map(move |table| (name(table), table))
    })
}

/// Every chart of methods, in the order of the lessons.
#[cfg(feature = "measure")]
pub(crate) fn all_charts() -> Vec<&'static Chart> {
    LESSONS.iter().flat_map(|lesson| lesson.charts).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn every_lesson_is_listed_and_in_order() {
        let all = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../lessons");
        let mut folders: Vec<String> = std::fs::read_dir(all)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        folders.sort();
        let listed: Vec<String> = LESSONS.iter().map(|lesson| lesson.lesson.folder()).collect();
        assert_eq!(listed, folders, "what lessons/ holds is listed in book/charts/src/lessons.rs");
    }

    #[test]
    fn no_cell_breaks_its_table() {
        for (name, table) in tables() {
            for row in (table.rows)() {
                for cell in [row.name, row.promise, row.failure] {
                    assert!(!cell.is_empty() && !cell.contains(['|', '\n']), "{name}: {cell}");
                }
            }
        }
    }
}
