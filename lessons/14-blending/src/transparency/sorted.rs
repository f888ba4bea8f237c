//! Whole triangles, from far to near.

use common::Image;
use zbuffer::DepthBuffer;

use super::Fill;
use super::drawn::Layered;
use crate::blend::BlendStage;

// ANCHOR: sorted
/// By the mean of their corners' depths, as lesson 4's painter has it. Of equal depths the one that comes first is drawn
/// first.
pub(super) fn draw(
    transparent: &[impl Fill],
    blend: impl BlendStage,
    image: &mut Image,
    depths: &DepthBuffer<f32>,
) {
    let mut order: Vec<_> = transparent.iter().collect();
    order.sort_by(|a, b| b.depth_sum().total_cmp(&a.depth_sum()));
    let mut target = Layered { image, depths, blend };
    order.into_iter().for_each(|triangle| triangle.fill(&mut target));
}
// ANCHOR_END: sorted
