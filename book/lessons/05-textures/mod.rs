//! What the book shows of lesson 5, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: textures::LESSON,
    methods: "two lookups as the slides have them, the nearest texel, repetition",
    picture: "The head with skin and hair",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::CHART],
};
