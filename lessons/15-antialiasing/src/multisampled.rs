//! A picture with several samples in each pixel.
//!
//! **Once a pixel.** What a triangle covers, and how deep it is, is told at each sample; what colour it has, once a pixel, as
//! long as some sample is seen. So an edge costs depths and colours, and no shading (K. Akeley, *Reality Engine graphics*,
//! SIGGRAPH 1993, has it so; Vulkan 1.3 calls it *multisampling*).
//!
//! **Where in the pixel.** At its centre, if that is covered. Else what is interpolated there lies outside of the triangle: a
//! texture coordinate beyond the border, a brightness that no corner has. So it is taken at the centroid of the covered
//! samples then, which is inside of the triangle, as every mean of points in it is.

use blending::Operations;
use common::{Bounds, Color, DVec3, IVec2, Image, Vec2, Vec3, Vec4, Vec4Swizzles};
use perspective::interpolation::relative;
use perspective::perspective_weights;
use shaders::shader::{Fragment, Varying};
use zbuffer::{DepthBuffer, depth_at};

use crate::alpha::alpha_to_coverage;
use crate::canvas::Canvas;
use crate::coverage::{Places, Small, all};
use crate::pattern::{Place, pattern};
use crate::resolve::Resolve;
use crate::storage::Storage;

/// Where a fragment of a pixel is shaded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum At {
    /// At the pixel's centre, inside of the triangle or not.
    Center,
    /// At the pixel's centre where it is covered, else at the centroid of the samples that are.
    #[default]
    Centroid,
    /// At each sample by itself.
    Sample,
}

/// A way to shade.
pub trait Shading: Copy + Default {
    /// Where a fragment is shaded.
    fn at(self) -> At;
}

/// Chosen when the program runs. The others are known when the loop is compiled.
impl Shading for At {
    #[inline]
    fn at(self) -> Self {
        self
    }
}

/// [`At::Center`], for those who want to see what is wrong with it.
#[derive(Clone, Copy, Debug, Default)]
pub struct PerCenter;

impl Shading for PerCenter {
    #[inline]
    fn at(self) -> At {
        At::Center
    }
}

/// [`At::Centroid`]: multisampling.
#[derive(Clone, Copy, Debug, Default)]
pub struct PerPixel;

impl Shading for PerPixel {
    #[inline]
    fn at(self) -> At {
        At::Centroid
    }
}

/// [`At::Sample`]: supersampling.
#[derive(Clone, Copy, Debug, Default)]
pub struct PerSample;

impl Shading for PerSample {
    #[inline]
    fn at(self) -> At {
        At::Sample
    }
}

/// A picture with `N` samples in each pixel. Each has a colour, a depth, and, where `K` is not `()`, a stencil value.
pub struct Multisampled<const N: usize, C, H = PerPixel, K = ()> {
    /// The colours, pixel by pixel, rows from the bottom.
    pub colors: C,
    /// The depths of what is seen, 1 at first.
    pub depths: Vec<[f32; N]>,
    /// What is kept for the stencil.
    pub stencils: Vec<[K; N]>,
    bounds: Bounds,
    places: Places<N>,
    alpha_to_coverage: bool,
    shading: H,
}

impl<const N: usize, C: Storage<N>, H, K: Copy + Default> Multisampled<N, C, H, K> {
    /// For a picture so many pixels wide and high, with the samples at the first `N` of these places, 32 at most.
    ///
    /// # Panics
    /// Where there are fewer places.
    #[must_use]
    pub fn with_places([width, height]: [usize; 2], places: &[Place], shading: H) -> Self {
        let pixels = width * height;
        Self {
            colors: C::new(pixels),
            depths: vec![[1.0; N]; pixels],
            stencils: vec![[K::default(); N]; pixels],
            bounds: Bounds { min: IVec2::ZERO, max: IVec2::new(width as i32, height as i32) - 1 },
            places: Places::new(places),
            alpha_to_coverage: false,
            shading,
        }
    }
}

impl<const N: usize, C, H, K> Multisampled<N, C, H, K> {
    /// How many pixels a row has.
    #[inline]
    pub(crate) fn width(&self) -> usize {
        self.bounds.max.x as usize + 1
    }
}

/// How deep a triangle is at the samples of its pixels.
struct Plane<const N: usize> {
    corners: Vec3,
    farthest: f64,
    per_edge: DVec3,
    offsets: [f64; N],
}

impl<const N: usize> Plane<N> {
    /// From the depths of the corners, and what the edge functions are more at each sample than at the centre.
    #[inline]
    fn new(corners: Vec3, per_area: f64, offsets: &[DVec3; N]) -> Self {
        let farthest = corners.min_element();
        let per_edge = (corners - farthest).as_dvec3() * per_area;
        Self {
            corners,
            farthest: farthest.into(),
            per_edge,
            offsets: offsets.map(|offset| offset.dot(per_edge)),
        }
    }

    // ANCHOR: depths
    /// The depths at the samples of a pixel, from the edge functions at its centre, where it may be far outside of the
    /// triangle, and f32 too coarse. A single sample is the centre, and as deep as lesson 4 has it, to the last bit.
    #[inline(always)]
    fn depths(&self, edges: DVec3, per_area: f64) -> [f32; N] {
        if N == 1 {
            return [depth_at(self.corners, (edges * per_area).as_vec3()); N];
        }
        let center = self.farthest + self.per_edge.dot(edges);
        self.offsets.map(|offset| (center + offset) as f32)
    }
    // ANCHOR_END: depths
}

// ANCHOR: centroid
/// The edge functions at the centroid of those samples whose bits are set: the mean of those at the samples, as they are
/// linear. None of these is negative, so the mean is not, but by rounding: of triangles wider than 2¹⁶ px edge functions may be
/// more than an `f64` holds exactly, and a mean next to 0 may end a little below it.
#[cold]
#[inline(never)]
fn at_centroid<const N: usize>(edges: DVec3, offsets: &[DVec3; N], samples: u32) -> DVec3 {
    let sum: DVec3 = (0..N).filter(|s| samples >> s & 1 == 1).map(|s| offsets[s]).sum();
    let count = f64::from(samples.count_ones());
    (edges * count + sum) / count
}
// ANCHOR_END: centroid

impl<const N: usize, C: Storage<N>, H: Shading, K: Copy + Default> Canvas for Multisampled<N, C, H, K> {
    type Stencil = K;

    /// The places are those of the standard pattern, and `N` is 1, 2, 4, 8 or 16.
    fn new(size: [usize; 2]) -> Self {
        Self::with_places(size, pattern(N), H::default())
    }

    fn clear(&mut self, background: Color, alpha_to_coverage: bool) {
        self.alpha_to_coverage = alpha_to_coverage;
        self.colors.clear(background);
        self.depths.fill([1.0; N]);
        self.stencils.fill([K::default(); N]);
    }

    fn size(&self) -> Vec2 {
        (self.bounds.max + 1).as_vec2()
    }

    // ANCHOR: fill
    #[inline]
    fn fill<V: Varying>(
        &mut self,
        state: impl Operations<Stencil = K>,
        corners: [Vec4; 3],
        varyings: [V; 3],
        mut shade: impl FnMut(Fragment<V>) -> Option<Color>,
    ) {
        let z = Vec3::from_array(corners.map(|corner| corner.z));
        let Some(inverse_w) = relative(corners).filter(|_| z.is_finite()) else { return };
        let Some(setup) = self.places.setup(corners.map(Vec4::xy), self.bounds) else { return };
        let offsets = self.places.offsets(&setup);
        let plane = Plane::new(z, setup.per_area, &offsets);
        let width = self.width();
        let Self { colors, depths: kept, stencils, places, alpha_to_coverage: by_alpha, shading, .. } = self;
        let by_alpha = *by_alpha;
        let small = Small::new(&setup, &offsets);
        for y in setup.bounds.min.y..=setup.bounds.max.y {
            let row = places.row(&setup, small.as_ref(), y);
            let mut edges = row.edges;
            let first = y as usize * width;
            for x in row.touched.clone() {
                let (covered, at, pixel) = (row.mask(x, edges), edges, first + x as usize);
                edges += setup.right;
                if N > 1 && covered == 0 {
                    continue;
                }
                // 1. Which samples are seen, and how deep they are.
                let depths = plane.depths(at, setup.per_area);
                let (kept, stencils) = (&mut kept[pixel], &mut stencils[pixel]);
                let mut test = |s: usize| state.test(IVec2::new(x, y), depths[s], kept[s], &mut stencils[s]);
                let mut seen = 0;
                if covered == all::<N>() || size_of::<K>() == 0 {
                    // Without a stencil no test leaves a trace, and to test all samples at once takes less than to choose.
                    (0..N).for_each(|s| seen |= if test(s) { 1 << s } else { 0 });
                    seen &= covered;
                } else {
                    (0..N).for_each(|s| seen |= u32::from(covered >> s & 1 == 1 && test(s)) << s);
                }
                // 2. What they look like, and what they keep.
                let mut draw = |samples: u32| {
                    let at = match shading.at() {
                        _ if N == 1 => at,
                        At::Center => at,
                        At::Centroid if row.has_center(x, at) => at,
                        At::Centroid => at_centroid(at, &offsets, covered),
                        At::Sample => at_centroid(at, &offsets, samples),
                    };
                    let weights = (at * setup.per_area).as_vec3();
                    let varying = V::interpolate(varyings, perspective_weights(weights, inverse_w));
                    let fragment = Fragment { x, y, depth: depth_at(z, weights), varying };
                    let Some(color) = shade(fragment) else { return };
                    let covered = if by_alpha { alpha_to_coverage(color.a, N as u32) } else { all::<N>() };
                    let samples = samples & covered;
                    colors.change(pixel, samples, |kept| state.color(color, kept));
                    if state.writes_depth() && samples == all::<N>() {
                        *kept = depths;
                    } else if state.writes_depth() {
                        (0..N)
                            .for_each(|s| kept[s] = if samples >> s & 1 == 1 { depths[s] } else { kept[s] });
                    }
                };
                if N > 1 && shading.at() == At::Sample {
                    (0..N).filter(|s| seen >> s & 1 == 1).for_each(|s| draw(1 << s));
                } else if seen != 0 {
                    draw(seen);
                }
            }
        }
    }
    // ANCHOR_END: fill

    fn resolve(&self, resolve: Resolve, picture: &mut Image) {
        picture.set_all(|pixel| match self.colors.colors(pixel) {
            [color] => *color,
            samples => resolve(samples),
        });
    }

    fn depths(&self, picture: &Image) -> DepthBuffer<f32> {
        let mut nearest = DepthBuffer::new(picture, 1.0);
        for ((x, y), depths) in pixels(self.bounds).zip(&self.depths) {
            nearest.set(x, y, depths.iter().copied().fold(1.0, f32::min));
        }
        nearest
    }
}

/// The pixels of a picture, rows from the bottom.
pub(crate) fn pixels(Bounds { min, max }: Bounds) -> impl Iterator<Item = (i32, i32)> {
    (min.y..=max.y).flat_map(move |y| (min.x..=max.x).map(move |x| (x, y)))
}
