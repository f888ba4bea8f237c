//! What the book shows of lesson 16, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;
mod sketches;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: scene::LESSON,
    methods: "four ways to choose how many triangles a sphere has; eleven versions of a scene",
    picture: "A head, crates and spheres on a floor that reaches to the horizon, one of them of glass",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART],
};
