//! Lesson 15: what its methods draw, where they fail, what its program is asked.

mod shading;
