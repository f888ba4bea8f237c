//! Lesson 13's shader, eight pixels at once.

use common::Color;
use fearless_simd::Simd;
use filtering::filter::{Anisotropic, Bilinear, Bilinear8, Filter, Nearest, Trilinear};
use filtering::footprint::Asked;
use filtering::layout::Layout;
use filtering::shader::Filtered;
use perspective::lighting::Clamped;
use shaders::shader::Shader;

use crate::eight::{Eight, Wide, each, packed};

/// A filter that may have a way for eight pixels.
pub trait WideFilter: Filter<Footprint: Asked<Constant: Send + Sync + 'static>> + Default + Sync {}

impl WideFilter for Nearest {}
impl WideFilter for Bilinear {}
impl WideFilter for Bilinear8 {}
impl WideFilter for Trilinear {}
impl WideFilter for Anisotropic {}

impl<F: WideFilter, O: Layout> Wide for Filtered<'_, F, Clamped, O> {
    fn keeps_all(&self) -> bool {
        true
    }

    #[inline(always)]
    fn shade<S: Simd>(
        &self,
        _: S,
        constant: Self::Constant,
        varyings: [Self::Varying; 3],
        eight: &Eight<S>,
    ) -> ([u32; 8], u8) {
        let mut colors = [0; 8];
        each(eight.asked, |lane| {
            let color = self.fragment(constant, eight.fragment(lane, varyings));
            colors[lane] = packed(color.unwrap_or(Color::BLACK));
        });
        (colors, eight.asked)
    }
}
