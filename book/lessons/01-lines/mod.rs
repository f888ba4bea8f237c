//! What the book shows of lesson 1, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: lines::LESSON,
    methods: "eleven, from a loop with a magic number to Bresenham's, Wu's, and one of equal thickness in all directions",
    picture: "Two lines",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::CHART, charts::COVERAGE_CHART],
};
