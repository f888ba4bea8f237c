//! Lesson 15: the share of a pixel that a triangle covers.
//!
//! **You will see** the head of the lessons before without the stairs at its border, before a fan of triangles thinner than a
//! pixel, and a part of both enlarged. **New:** a pixel is asked at several places, its samples, what of it a triangle covers;
//! each sample has its own depth and colour, but what a triangle looks like is computed once a pixel.
//!
//! The job: draw edges that lie across pixels. [`pattern`](mod@pattern) has the places of the samples,
//! [`coverage`](mod@coverage) tells which of them a triangle covers, [`canvas`] is what triangles are drawn to and
//! [`multisampled`] the one that has samples; [`ordered`] draws a larger picture instead, and [`area`] cuts a triangle to
//! each pixel's square. [`storage`] keeps colours ([`STORAGES`]), [`resolve`](mod@resolve) makes one of several
//! ([`RESOLVES`]), [`alpha`] lets a texture's border cover samples, [`scene`] is what this lesson draws. From lesson 3 come
//! edges, asked at other places than a centre; from lesson 11 the triangles, from lesson 14 what happens to a fragment, which
//! happens to each sample here: all unchanged.
//!
//! Conventions: as in lesson 14. A place in a pixel is counted from its lower left corner, y up, in 1/16 px; a mask has bit s
//! set where sample s is meant.

pub mod alpha;
pub mod area;
pub mod canvas;
pub mod cover;
pub mod coverage;
pub mod multisampled;
pub mod ordered;
pub mod pattern;
pub mod resolve;
pub mod scene;
pub mod storage;

use clipping::Counts;
use common::{Image, Lesson, Method, Table};
use zbuffer::DepthBuffer;

use area::Area;
use multisampled::{Multisampled, PerSample};
use ordered::Ordered;
use storage::{Compressed, Samples};

pub use alpha::alpha_to_coverage;
pub use canvas::{Canvas, render};
pub use coverage::coverage;
pub use pattern::{PATTERNS, pattern};
pub use resolve::{RESOLVES, resolve, resolve_linear};
pub use scene::{Scene, World};

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 15,
    name: "antialiasing",
    title: "Antialiasing",
    job: "the share of a pixel that a triangle covers",
    tables: &[
        Table { name: "", job: "Draw an edge across pixels", rows: || Method::rows(METHODS) },
        Table { name: "resolves", job: "Make one colour of several", rows: || Method::rows(RESOLVES) },
        Table { name: "storages", job: "Keep the colours of samples", rows: || Method::rows(STORAGES) },
    ],
};

/// Draws one scene after the other, and keeps its samples from each to the next: no samples are allocated again.
pub type Frames = Box<dyn FnMut(&Scene, &mut Image) -> Counts>;

/// One way to draw scenes, compiled for just this.
#[derive(Clone, Copy)]
pub struct Draw {
    /// Draws a scene into a picture.
    pub picture: fn(&Scene, &mut Image) -> Counts,
    /// The nearest depth in each pixel of such a picture.
    pub depths: fn(&Scene, &Image) -> DepthBuffer<f32>,
    /// Draws scenes into pictures of one size.
    pub frames: fn([usize; 2]) -> Frames,
    /// How many depths and colours it keeps for each pixel.
    pub samples: usize,
}

impl Draw {
    const fn to<C: Canvas<Stencil = ()> + 'static>(samples: usize) -> Self {
        Self {
            picture: |scene, picture| scene.draw::<C>(picture),
            depths: |scene, picture| scene.depths::<C>(picture),
            frames: |size| {
                let mut canvas = C::new(size);
                Box::new(move |scene, picture| {
                    let counts = scene.draw_to(picture, &mut canvas);
                    canvas.resolve(scene.resolve, picture);
                    counts
                })
            },
            samples,
        }
    }
}

/// The ways to draw what covers a share of a pixel, from the first idea to the last.
pub const METHODS: &[Method<Draw>] = &[
    Method {
        name: "none",
        run: Draw::to::<Multisampled<1, Samples<1>>>(1),
        promise: "one sample, the centre: a pixel is covered or not, as in lessons 3 to 14",
        failure: "stairs; what is thinner than a pixel falls into pieces",
    },
    Method {
        name: "ssaa-4",
        run: Draw::to::<Multisampled<4, Samples<4>, PerSample>>(4),
        promise: "four samples, each shaded by itself: smooths textures and highlights, too",
        failure: "five levels at an edge; four times the shading",
    },
    Method {
        name: "ssaa-16",
        run: Draw::to::<Multisampled<16, Samples<16>, PerSample>>(16),
        promise: "sixteen samples, each shaded by itself: the yardstick for the others",
        failure: "sixteen times the shading",
    },
    Method {
        name: "ordered-16",
        run: Draw::to::<Ordered>(16),
        promise: "a picture four times as wide and high, averaged: needs nothing new",
        failure: "sixteen samples, but an edge along an axis passes four at a time: five levels; sixteen times the shading",
    },
    Method {
        name: "msaa-2",
        run: Draw::to::<Multisampled<2, Compressed<2>>>(2),
        promise: "two samples, shaded once a pixel: hardly more than none",
        failure: "three levels at an edge; textures and highlights stay as they are",
    },
    Method {
        name: "msaa-4",
        run: Draw::to::<Multisampled<4, Compressed<4>>>(4),
        promise: "four samples, shaded once a pixel",
        failure: "five levels at an edge; textures and highlights stay as they are",
    },
    Method {
        name: "msaa-8",
        run: Draw::to::<Multisampled<8, Compressed<8>>>(8),
        promise: "eight samples, shaded once a pixel",
        failure: "nine levels at an edge; textures and highlights stay as they are",
    },
    Method {
        name: "msaa-16",
        run: Draw::to::<Multisampled<16, Compressed<16>>>(16),
        promise: "sixteen samples, shaded once a pixel: edges as ssaa-16 has them",
        failure: "what is thinner than the gaps between samples; textures and highlights stay as they are; 16 depths a pixel",
    },
    Method {
        name: "area",
        run: Draw::to::<Area>(1),
        promise: "the exact share of the pixel, to a 255th, by cutting the triangle to the pixel's square; opaque only",
        failure: "a share has no place: at a common side up to a quarter of what is behind shines through, hidden things too; \
                  shares below 1/510 are lost, however many",
    },
];

/// The ways to keep the colours of sixteen samples. All draw the same pixels.
pub const STORAGES: &[Method<Draw>] = &[
    Method {
        name: "samples",
        run: Draw::to::<Multisampled<16, Samples<16>>>(16),
        promise: "a colour for each sample, written and read one by one",
        failure: "sixteen colours a pixel, though all are one in most",
    },
    Method {
        name: "compressed",
        run: Draw::to::<Multisampled<16, Compressed<16>>>(16),
        promise: "one colour where all samples have it: written, blended and resolved once",
        failure: "at edges the samples are compared whenever one is drawn; 5 bytes a pixel more, and saves none",
    },
];
