//! What the book shows of lesson 15, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;
pub(crate) mod sketches;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: antialiasing::LESSON,
    methods: "nine ways to find how much of a pixel a triangle covers, two to make one colour of its samples, two to keep them",
    picture: "The head before rays of thin triangles, without stairs",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART, charts::RESOLVES_CHART, charts::STORAGES_CHART],
};
