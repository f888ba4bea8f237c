//! What the book shows of lesson 10, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: perspective::LESSON,
    methods: "four ways to interpolate in perspective, five to keep a depth, four to divide",
    picture: "The head on a chequered floor that reaches to the horizon",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART, charts::DEPTHS_CHART, charts::DIVISIONS_CHART],
};
