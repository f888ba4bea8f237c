//! What each method of each lesson draws.
//!
//! Small pictures are text; whole ones are PNG, drawn by the lesson's program. Up to lesson 6 the tolerance is 0:
//! lines and `edges` compute in integers, and what is computed in floats uses +, −, ×, ÷ and √ alone, which
//! IEEE 754 defines to the last bit on every platform.
//!
//! From lesson 7 on there are sines, which platforms round differently, and matrix products, which glam computes
//! with fused multiplications on some processors. Both move a corner by an ulp or so: an intensity may then be
//! rounded to the other side, and a pixel at a side or at a texel's border change hands.

mod camera;
mod defaults;
mod gouraud;
mod lines;
mod shaders;
mod textures;
mod transforms;
mod triangles;
mod wireframe;
mod zbuffer;
