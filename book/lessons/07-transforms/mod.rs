//! What the book shows of lesson 7, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: transforms::LESSON,
    methods: "a million rotations composed in three ways; three ways to turn, three to undo",
    picture: "The head in perspective",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART, charts::ROTATIONS_CHART, charts::INVERSES_CHART],
};
