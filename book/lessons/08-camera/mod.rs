//! What the book shows of lesson 8, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: camera::LESSON,
    methods: "the slides' view matrix, the right one, and one for centres far away",
    picture: "The head from above and the right",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::CHART],
};
