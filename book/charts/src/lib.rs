//! The book's figures, and, with the feature `measure`, which is on unless it is turned off, its charts.
//!
//! Whoever only reads the book needs the figures alone: the charts are measured once and committed, and what measures
//! them takes longer to build than the lessons.

pub mod figures;
pub mod lessons;
#[cfg(feature = "measure")]
pub mod measuring;
#[path = "../../pages/mod.rs"]
mod pages;
