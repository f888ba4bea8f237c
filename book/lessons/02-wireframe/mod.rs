//! What the book shows of lesson 2, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: wireframe::LESSON,
    methods: "each triangle's sides, or each edge once",
    picture: "A wireframe",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::CHART],
};
