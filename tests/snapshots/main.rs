//! What each method of each lesson draws.
//!
//! Small pictures are text; whole ones are PNG, drawn by the lesson's program. The tolerance is 0: lines and
//! `edges` compute in integers, and what is computed in floats uses +, −, ×, ÷ and √ alone, which IEEE 754
//! defines to the last bit on every platform.

mod lines;
mod triangles;
mod wireframe;
