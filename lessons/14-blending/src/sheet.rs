//! Several outputs put to use: colour, normal and distance of what is seen, and a picture made of these three.
//!
//! Light and fog are computed after everything is drawn, once for each pixel, from what the buffers hold: what was hidden costs
//! none of it. (M. Deering and others, *The triangle processor and normal vector shader*, SIGGRAPH 1988, where lighting is
//! deferred so.)

use clipping::{Clipping, Counts, Cull, Drawn, render};
use common::{Color, Format, Image, Vec3};
use filtering::filter::Trilinear;
use filtering::shader::Filtered;
use shaders::Uniforms;
use shaders::lighting::Lighting;

use crate::outputs::{Buffers, Described};
use crate::scene::{Entity, View};
use crate::state::State;
use crate::target::Framebuffer;

/// No light: each surface in its own colour.
struct Unlit;

impl Lighting for Unlit {
    type Constant = ();
    type Varying = ();

    #[inline]
    fn triangle(&self, _: &Uniforms, _: usize) -> Option<()> {
        Some(())
    }

    #[inline]
    fn corner(&self, _: &Uniforms, _: usize, _: usize) {}

    #[inline]
    fn intensity(&self, (): (), (): ()) -> f32 {
        1.0
    }
}

/// The distance at which half of the light is lost in the fog.
const HALF: f32 = 3.0;

/// Draws entities once, and shows in a picture's four quarters their colours, their normals, their distances, and what is made
/// of them. The depths are those of a quarter.
pub fn draw(entities: &[Entity], view: &View, image: &mut Image) -> Drawn {
    let [width, height] = [image.width() / 2, image.height() / 2];
    let mut colors = Image::new(width as u16, height as u16, Format::Rgb);
    let size = colors.size();
    let mut target = Buffers::new(Framebuffer::new(&mut colors, State::OFF));
    let mut counts = Counts::default();
    // ANCHOR: pass
    for entity in entities {
        let Some(scene) = entity.scene(view) else { continue };
        let texture = entity.model.texture();
        let shader = Filtered { uniforms: scene.uniforms, texture, filter: Trilinear, lighting: Unlit, size };
        let shader = Described { shader, scene };
        counts += render(&shader, entity.mesh(), Cull::Back, Clipping::GuardBand, &mut target);
    }
    // ANCHOR_END: pass
    let Buffers { framebuffer, normals, distances } = target;
    let light = view.light.position.normalize_or_zero();
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let (normal, distance) = (normals[(y * width + x) as usize], distances.get(x, y));
        let Some(color) = framebuffer.image.get(x, y) else { continue };
        // Where nothing is, it is infinitely far, and this is 0.
        let nearness = libm::exp2f(-distance / HALF);
        let lit = color.shaded((0.25 + 0.75 * normal.dot(light).max(0.0)) * nearness * 2.0);
        image.set(x, height + y, color);
        image.set(width + x, height + y, if distance.is_finite() { pictured(normal) } else { Color::BLACK });
        image.set(x, y, Color::gray(nearness));
        image.set(width + x, y, lit);
    }
    Drawn { depths: framebuffer.depths, counts }
}

/// A direction as a colour, as lesson 12's maps have it: −1 to 1 become 1 to 255.
fn pictured(direction: Vec3) -> Color {
    let channel = |coordinate: f32| (128.5 + 127.0 * coordinate) as u8;
    Color::rgb(channel(direction.x), channel(direction.y), channel(direction.z))
}
