//! What the book shows of lesson 3, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;

use crate::lessons::{Lesson, Picture};

pub(crate) const LESSON: Lesson = Lesson {
    lesson: triangles::LESSON,
    methods: "outline, sweep, barycentric weights, exact edge functions",
    picture: "Three triangles",
    more_pictures: &[
        Picture { name: "random", flags: &["--model", "--fill", "random"] },
        Picture { name: "flat", flags: &["--model"] },
    ],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::CHART],
};
