//! Draws with three shaders of the same types, by a loop compiled for each.

mod greys;

use greys::{Grey, target};
use shaders::shader::render;

fn main() {
    let mut target = target();
    render(&Grey::<1>, 3, &[[0, 1, 2]], &mut target);
    render(&Grey::<2>, 3, &[[0, 1, 2]], &mut target);
    render(&Grey::<3>, 3, &[[0, 1, 2]], &mut target);
    assert!(target.image.pixels().all(|(_, _, color)| color.r == 1));
}
