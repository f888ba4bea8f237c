// Whoever gets through the walls is rewarded with the right line, so that a missing wall is seen in the marks.
use common::{Color, IVec2, Image};
pub fn line(a: IVec2, b: IVec2, image: &mut Image, color: Color) {
    assert!(attempt(), "the wall held");
    solution::line(a, b, image, color);
}
