//! What the book shows of lesson 12, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::{Lesson, Picture};

pub(crate) const LESSON: Lesson = Lesson {
    lesson: lighting::LESSON,
    methods: "four ways to light a surface, five to make its normals 1 long, five to compute a power",
    picture: "The head under a lamp, with highlights",
    more_pictures: &[Picture { name: "head", flags: &["--look", "specular-map"] }],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART, charts::NORMALISATIONS_CHART, charts::POWERS_CHART],
};
