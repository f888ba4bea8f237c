//! The lessons' loops over pixels that take longest in figures that move, each in the code once.
//!
//! A generic loop is compiled with the crate that asks for it, and as that crate is. All else of the figures is compiled to be
//! small, which makes loops half as fast; these are in a crate of their own, which the profile `live` has compiled to be quick
//! as well. The figures that call them, and the tests that they draw what the lessons draw, are in `live`.

pub mod counted;
pub mod filters;
pub mod layers;
pub mod lights;
pub mod looks;
pub mod shades;
