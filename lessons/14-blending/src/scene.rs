//! Entities: models at their places in the world, opaque or not.

use clipping::{Clipping, Counts, Cull, Drawn, Mesh, render};
use common::{Color, Image, Mat4, Vec2, Vec3};
use filtering::filter::Trilinear;
use filtering::scene::Filterable;
use filtering::shader::Filtered;
use lighting::toon::Swollen;
use lighting::{PointLight, Scene};
use shaders::target::Target;
use transforms::normal_matrix;

use crate::blend::BlendStage;
use crate::lamp::Lamp;
use crate::state::State;
use crate::target::Framebuffer;
use crate::translucent::Translucent;
use crate::transparency::{Transparency, gather};

/// Who looks at the entities, and by which light.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// From the world to clip space.
    pub to_clip: Mat4,
    /// The eye in the world.
    pub eye: Vec3,
    /// The light.
    pub light: PointLight,
}

/// A model at its place in the world.
#[derive(Clone, Copy)]
pub struct Entity<'a> {
    /// The model with its texture.
    pub model: &'a Filterable,
    /// From the model's space to the world, which must not flatten it.
    pub to_world: Mat4,
    /// Its alpha, from 0 to 1: below 1 one sees through it.
    pub alpha: f32,
}

/// The shader of an entity: lesson 13's texture under lesson 12's lamp, with the entity's alpha.
pub type EntityShader<'a> = Translucent<Filtered<'a, Trilinear, Lamp<'a>>>;

impl<'a> Entity<'a> {
    /// It as lesson 12 sees it. `None` where its place flattens it.
    #[must_use]
    pub fn scene(&self, view: &View) -> Option<Scene<'a>> {
        let uniforms = self.model.surface(Vec3::ZERO, view.to_clip * self.to_world).uniforms;
        let normals_to_world = normal_matrix(&self.to_world)?;
        let &View { eye, light, .. } = view;
        Some(Scene { uniforms, to_world: self.to_world, normals_to_world, eye, light })
    }

    /// Its vertices and triangles.
    #[must_use]
    pub fn mesh(&self) -> &'a Mesh {
        self.model.mesh()
    }

    /// Its shader, in a picture of that size. `None` where its place flattens it.
    #[must_use]
    pub fn shader(&self, view: &View, size: Vec2) -> Option<EntityShader<'a>> {
        let scene = self.scene(view)?;
        let (texture, lighting) = (self.model.texture(), Lamp::new(scene));
        let shader = Filtered { uniforms: scene.uniforms, texture, filter: Trilinear, lighting, size };
        Some(Translucent { shader, alpha: self.alpha, vertices: () })
    }

    /// Whether nothing is seen through it: neither its own alpha nor any texel's is below 1.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.alpha >= 1.0 && self.model.is_opaque()
    }

    /// Draws it to any target.
    pub fn draw(&self, view: &View, cull: Cull, target: &mut impl Target<Color>) -> Counts {
        let size = (target.bounds().max + 1).as_vec2();
        let Some(shader) = self.shader(view, size) else { return Counts::default() };
        render(&shader, self.mesh(), cull, Clipping::GuardBand, target)
    }

    /// Draws its shape in one colour, swollen by so much of the world's units.
    pub fn draw_shape(
        &self,
        color: Color,
        width: f32,
        view: &View,
        target: &mut impl Target<Color>,
    ) -> Counts {
        let Some(scene) = self.scene(view) else { return Counts::default() };
        render(&Swollen::new(&scene, width, color), self.mesh(), Cull::Back, Clipping::GuardBand, target)
    }
}

/// Draws entities over a picture: first the opaque ones, then those that one sees through, as they come.
// ANCHOR: draw
pub fn draw<B: BlendStage>(entities: &[Entity], view: &View, blend: B, image: &mut Image) -> Drawn {
    let (target, mut counts) = opaque(entities, view, image);
    let mut target = target.under(State::blending(blend));
    for entity in entities.iter().filter(|entity| !entity.is_opaque()) {
        counts += entity.draw(view, Cull::Back, &mut target);
    }
    Drawn { depths: target.depths, counts }
}

/// The opaque ones.
fn opaque<'a>(entities: &[Entity], view: &View, image: &'a mut Image) -> (Framebuffer<'a, State>, Counts) {
    let mut counts = Counts::default();
    let mut target = Framebuffer::new(image, State::OFF);
    for entity in entities.iter().filter(|entity| entity.is_opaque()) {
        counts += entity.draw(view, Cull::Back, &mut target);
    }
    (target, counts)
}
// ANCHOR_END: draw

/// The same, but those that one sees through in one of the ways of [`TRANSPARENCY`](crate::TRANSPARENCY), with what of them
/// `cull` does not leave out. They leave no depths behind.
// ANCHOR: draw_by
pub fn draw_by(
    transparency: Transparency,
    entities: &[Entity],
    view: &View,
    cull: Cull,
    blend: impl BlendStage,
    image: &mut Image,
) -> Drawn {
    let size = image.size();
    let (Framebuffer { image, depths, .. }, mut counts) = opaque(entities, view, image);
    let transparent = entities.iter().filter(|entity| !entity.is_opaque());
    let shaders: Vec<_> =
        transparent.filter_map(|entity| Some((entity.shader(view, size)?, entity.mesh()))).collect();
    let mut triangles = Vec::new();
    for (shader, mesh) in &shaders {
        counts += gather(shader, mesh, cull, size, &mut triangles);
    }
    transparency.draw(&triangles, blend, image, &depths);
    Drawn { depths, counts }
}
// ANCHOR_END: draw_by
