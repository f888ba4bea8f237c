//! What the book shows of lesson 4, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: zbuffer::LESSON,
    methods: "the painter's order, depths of 16 and 24 bits, depths in floats",
    picture: "The head, flat-shaded",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::CHART],
};
