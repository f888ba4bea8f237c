//! What the book shows of lesson 14, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;
mod scenes;
mod seen_through;
mod sketches;

use crate::lessons::{Lesson, Picture};

pub(crate) const LESSON: Lesson = Lesson {
    lesson: blending::LESSON,
    methods: "five ways to divide by 255, five to see through several layers, four to keep and to mix colours with an alpha",
    picture: "A wooden crate, and a smaller one before it through which one sees it",
    more_pictures: &[
        Picture { name: "mirror", flags: &["--show", "mirror"] },
        Picture { name: "glass", flags: &["--show", "glass"] },
    ],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART, charts::TRANSPARENCY_CHART, charts::SPACES_CHART],
};
