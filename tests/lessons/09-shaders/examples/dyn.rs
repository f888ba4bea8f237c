//! Draws with three shaders of the same types, by one loop that calls any of them.

mod greys;

use common::Color;
use greys::{Grey, target};
use shaders::shader::{Shader, render};

fn main() {
    let mut target = target();
    let shaders: [&dyn Shader<Constant = (), Varying = (), Output = Color>; 3] =
        [&Grey::<1>, &Grey::<2>, &Grey::<3>];
    for shader in shaders {
        render(shader, 3, &[[0, 1, 2]], &mut target);
    }
    assert!(target.image.pixels().all(|(_, _, color)| color.r == 1));
}
