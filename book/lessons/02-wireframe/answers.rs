//! The numbers of the chapter's worked example, computed by the lesson's own code.

use common::{Format, Image, Vec3};
use wireframe::to_pixel;

#[test]
fn the_table_of_ten_columns() {
    let image = Image::new(10, 10, Format::Gray);
    for (x, column) in [(-1.0, 0), (-0.31, 3), (0.99, 9), (1.0, 9), (-1.05, -1)] {
        assert_eq!(to_pixel(Vec3::new(x, 0.0, 0.0), &image).x, column, "{x}");
    }
}
