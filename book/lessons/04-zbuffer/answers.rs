//! The numbers of the chapter's worked example, computed by the lesson's own code.

use common::Vec3;
use zbuffer::depth_at;

#[test]
fn a_depth_by_weights() {
    assert!((depth_at(Vec3::new(4.0, 2.0, -1.0), Vec3::new(0.2, 0.3, 0.5)) - 0.9).abs() < 1e-6);
}
