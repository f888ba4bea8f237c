//! What the book shows of lesson 9, beside its chapter.

#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: shaders::LESSON,
    methods: "five shaders, through `dyn` or generic",
    picture: "The head four times, flat and smooth, white and textured",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART, charts::WHITE_CHART, charts::TEXTURED_CHART],
};
