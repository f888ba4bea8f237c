//! Lesson 14's scene of what one sees through, its target chosen when the program runs: one loop over pixels, where the lesson has
//! one for each way to draw layers.

use blending::scene::{Entity, EntityShader, View};
use blending::target::Framebuffer;
use blending::transparency::{Fill, Placed, gather};
use blending::{Over, State, Transparency, TwoShift};
use clipping::{Counts, Cull};
use common::{Bounds, Color, Image};
use shaders::target::Target;

/// Draws an entity, and over it another one that one sees through.
///
/// # Panics
/// Where an entity is flat.
pub fn draw(
    transparency: Transparency,
    [opaque, transparent]: [&Entity; 2],
    view: &View,
    image: &mut Image,
) -> Counts {
    let size = image.size();
    let [below, above] =
        [opaque, transparent].map(|entity| entity.shader(view, size).expect("it is not flat"));
    let (mut layers, mut counts) = placed(&below, opaque, Cull::Back, image);
    let mut target = Framebuffer::new(image, State::OFF);
    layers.iter().for_each(|layer| layer.fill(&mut target));
    let Framebuffer { image, depths, .. } = target;
    let more;
    (layers, more) = placed(&above, transparent, Cull::None, image);
    counts += more;
    transparency.draw(&layers, Over(TwoShift), image, &depths);
    counts
}

/// The triangles of an entity in the window.
fn placed<'a>(
    shader: &'a EntityShader<'a>,
    entity: &Entity,
    cull: Cull,
    image: &Image,
) -> (Vec<Layer<'a>>, Counts) {
    let mut triangles = Vec::new();
    let counts = gather(shader, entity.mesh(), cull, image.size(), &mut triangles);
    (triangles.into_iter().map(Layer).collect(), counts)
}

/// A triangle that asks its target by calls.
struct Layer<'a>(Placed<'a, EntityShader<'a>>);

impl Fill for Layer<'_> {
    fn depth_sum(&self) -> f32 {
        self.0.depth_sum()
    }

    fn fill(&self, target: &mut impl Target<Color>) {
        self.0.fill(&mut AnyTarget(target));
    }
}

/// Any target.
struct AnyTarget<'a>(&'a mut dyn Target<Color>);

impl Target<Color> for AnyTarget<'_> {
    fn bounds(&self) -> Bounds {
        self.0.bounds()
    }

    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        self.0.test(x, y, depth)
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        self.0.write(x, y, depth, color);
    }

    fn clear(&mut self) {
        self.0.clear();
    }
}
