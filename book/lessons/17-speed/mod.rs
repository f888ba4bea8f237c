//! What the book shows of lesson 17, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;
mod sketches;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: speed::LESSON,
    methods: "seven ways to draw the same pixels, each with one idea more than the one before",
    picture: "Lesson 13's picture, the same to the last bit, in a fraction of its time",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART],
};
