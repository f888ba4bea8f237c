//! What the book shows of lesson 1, beside its chapter.

#[cfg(test)]
mod answers;
pub(crate) mod figures;

use crate::lessons::Lesson;

pub(crate) const LESSON: Lesson = Lesson {
    lesson: lines::LESSON,
    methods: "ten, from a loop with a magic number to Bresenham's and Wu's algorithms",
    picture: "Two lines",
    more_pictures: &[],
    figures: figures::FIGURES,
};
