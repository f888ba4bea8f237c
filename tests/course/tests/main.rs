//! The course as a whole: every lesson has what belongs to it, and one more is soon added; the missions as a student
//! meets them; and the learner's way through it.

mod answers;
mod copy;
mod lessons;
mod missions;
mod one_more;
mod way;
