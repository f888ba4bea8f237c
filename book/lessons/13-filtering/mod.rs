//! What the book shows of lesson 13, beside its chapter.

#[cfg(test)]
mod answers;
#[cfg(feature = "measure")]
pub(crate) mod charts;
pub(crate) mod figures;
mod sketches;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: filtering::LESSON,
    methods: "five ways to find the colour of a pixel in a texture, three to make its smaller levels, three to go beyond its \
              border, three to keep it in memory",
    picture: "The head on the floor, its checks even to the horizon",
    more_pictures: &[],
    figures: figures::FIGURES,
    #[cfg(feature = "measure")]
    charts: &[charts::METHODS_CHART, charts::MIPMAPS_CHART, charts::LAYOUTS_CHART],
};
