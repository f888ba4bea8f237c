//! The tests of each lesson, in a folder of the lesson's name.
//!
//! | file | what is in it |
//! |---|---|
//! | `snapshots.rs` | what each method draws, against the `pictures/` beside it |
//! | `stability.rs` | where methods fail, and where they must not: tables of (input, method, what must happen) |
//! | `properties.rs` | what must hold for any input, tried on random ones; `proptest` makes a failing one small |
//!
//! Small pictures are text; whole ones are PNG, drawn by the lesson's program. Up to lesson 6 the tolerance is 0:
//! lines and `edges` compute in integers, and what is computed in floats uses +, −, ×, ÷ and √ alone, which
//! IEEE 754 defines to the last bit on every platform. From lesson 7 on there are sines, which platforms round
//! differently, and matrix products, which glam computes with fused multiplications on some processors. Both move
//! a corner by an ulp or so: an intensity may then be rounded to the other side, and a pixel at a side or at a
//! texel's border change hands.
//!
//! A failure is pinned to the letter, so that a test notices when a method stops failing as the lesson says it
//! does. Every method of a lesson has a row for every input.

mod defaults;

#[path = "08-camera/mod.rs"]
mod camera;
#[path = "06-gouraud/mod.rs"]
mod gouraud;
#[path = "01-lines/mod.rs"]
mod lines;
#[path = "09-shaders/mod.rs"]
mod shaders;
#[path = "05-textures/mod.rs"]
mod textures;
#[path = "07-transforms/mod.rs"]
mod transforms;
#[path = "03-triangles/mod.rs"]
mod triangles;
#[path = "02-wireframe/mod.rs"]
mod wireframe;
#[path = "04-zbuffer/mod.rs"]
mod zbuffer;
