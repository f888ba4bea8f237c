//! The ground floor of *Pixel by Pixel*: what every lesson stands on and none of them teaches.
//!
//! | module | what is there |
//! |---|---|
//! | [`image`] | [`Image`], an 8-bit picture; [`Bounds`], a rectangle of pixels |
//! | [`mod@file`] | pictures to and from TGA and PNG, files written whole or not at all |
//! | [`color`] | [`Color`] |
//! | [`direction`] | vectors made 1 long, however long they were |
//! | [`model`] | [`Model`], the triangles of an OBJ file, checked |
//! | [`printable`] | text from outside, as it can be shown in a line |
//! | [`placement`] | where a model is put when it is read |
//! | [`lesson`] | [`Lesson`], what a lesson is called |
//! | [`method`] | [`Method`], one row of a lesson's table of methods |
//! | [`compare`] | what differs between two pictures |
//! | [`program`] | what all lessons' programs have in common: flags, files, errors |
//! | [`terminal`] | what a program says |
//! | [`preview`] | a picture in the terminal |
//!
//! Vectors and matrices are [glam](https://docs.rs/glam)'s, re-exported here by name, so that a lesson
//! depends on `common` alone.

pub mod color;
pub mod compare;
pub mod direction;
mod error;
pub mod file;
pub mod image;
mod kind;
pub mod lesson;
mod memory;
pub mod method;
pub mod model;
mod obj;
pub mod placement;
pub mod preview;
pub mod printable;
pub mod program;
pub mod terminal;

pub use color::Color;
pub use error::{Error, PictureError};
pub use glam::{
    DMat3, DVec2, DVec3, DVec4, IVec2, Mat3, Mat4, Quat, Vec2, Vec2Swizzles, Vec3, Vec3Swizzles, Vec4,
    Vec4Swizzles,
};
pub use image::{Bounds, Format, Image};
pub use lesson::{Lesson, Table};
pub use method::Method;
pub use model::{Attributes, Model};
