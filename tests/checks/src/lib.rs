//! What a lesson's result is measured against: exact references, and typed comparisons.
//!
//! | module | reference |
//! |---|---|
//! | [`segment`] | the ideal line, in rational numbers |
//! | [`coverage`] | the pixels of a triangle, the samples of a pixel, and their weights, in `i128` |
//! | [`area`] | how much of a pixel a triangle covers, in rational numbers |
//! | [`visibility`] | the nearest of several triangles, in `f64` |
//! | [`clipspace`] | which side of a triangle of clip space is seen, in `i128`; what a ray meets of it, in `f64` |
//! | [`texel`] | the texel of a texture coordinate, in `i128` |
//! | [`sphere`] | a smooth sphere under a light, by its equation |
//! | [`lamp`] | a smooth surface under a lamp, a ray at a time, in `f64` |
//! | [`matrix`] | the inverse of a matrix, in rational numbers |
//! | [`turn`] | rotations about an axis, in `f64` |
//! | [`view`] | the basis of an eye, and what lies before it, in `f64` |
//! | [`vertex`] | the pixel of a model's vertex, in whole numbers |
//! | [`supersampled`] | a lit scene under a camera, in `f64`, with as many samples a pixel as wanted |
//! | [`ray`] | what a ray from an eye meets, in `f64` |
//! | [`camera`] | a frustum's matrix, and the distance of a depth, in `f64` |
//! | [`footprint`] | what a pixel sees of a textured plane, in `f64`, with as many rays as wanted |
//! | [`samples`] | what each sample of a pixel sees of several triangles, in `i128` and `f64` |
//! | [`edge`] | how well the samples of a pixel show an edge, by its angle, in `f64` |
//! | [`box_filter`] | the mean of all that is seen in a pixel, by cutting what is nearer out of what is farther, in `f64` |
//! | [`fragment`] | what happens to a fragment: tests, blending, logic operations, masks, in whole numbers |
//! | [`assignment`] | the left-handed pipeline of lesson 16's assignment, in `f64` |
//! | [`layers`] | the transparent layers of a pixel, sorted, in `f64`, and each rounded in whole numbers |
//! | [`cutout`] | a texture with alpha, filtered and laid over a colour, in `f64` |
//! | [`outline`] | the outline of a sphere in a picture, an ellipse, in `f64` |
//! | [`apart`] | how far apart two surfaces of triangles are, in `f64` |
//! | [`picture`] | two pictures, fault by fault |
//!
//! Nothing in these calls a lesson, and the references compute nothing the way the lessons do. Pictures are
//! compared by `common`, as under `--compare`.

pub mod apart;
pub mod area;
pub mod assignment;
pub mod box_filter;
pub mod camera;
pub mod clipspace;
pub mod coverage;
pub mod cutout;
pub mod edge;
pub mod footprint;
pub mod fragment;
pub mod lamp;
pub mod layers;
pub mod matrix;
pub mod outline;
pub mod picture;
pub mod ray;
pub mod samples;
pub mod segment;
pub mod sphere;
pub mod supersampled;
pub mod texel;
pub mod turn;
pub mod vertex;
pub mod view;
pub mod visibility;
