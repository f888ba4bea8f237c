//! Lesson 16.
