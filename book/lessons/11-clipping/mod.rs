//! What the book shows of lesson 11, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: clipping::LESSON,
    methods: "five ways with what reaches behind the eye, three to tell the side that is seen, three to hand over a mesh",
    picture: "The head from close above a floor that passes behind the eye",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART, charts::FACINGS_CHART, charts::ASSEMBLIES_CHART],
};
