//! The course as a whole: every lesson has what belongs to it; the missions as a student meets them.

mod lessons;
mod missions;
