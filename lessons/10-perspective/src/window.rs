//! From clip space to the window.

use common::{Vec2, Vec3, Vec4, Vec4Swizzles};
use zbuffer::to_screen;

// ANCHOR: window
/// Where a point of clip space is in a picture of that size: x and y in pixels, z the depth, from 0 on the near plane
/// to 1 on the far one, and as the fourth coordinate 1/w (notes, I.2, *From NDC to window space*).
///
/// By way of the normalized device coordinates x/w, y/w, z/w, each from −1 to 1 in what is seen, as OpenGL has them;
/// in Vulkan's z/w is from 0 to 1 there already. `None` at the eye's depth and behind it, where w ≤ 1e-6.
#[inline]
#[must_use]
pub fn window(clip: Vec4, size: Vec2) -> Option<Vec4> {
    (clip.w > 1e-6).then(|| {
        let Vec3 { x, y, z } = to_screen(clip.xyz() / clip.w, size);
        Vec4::new(x, y, z / 2.0 + 0.5, 1.0 / clip.w)
    })
}
// ANCHOR_END: window
