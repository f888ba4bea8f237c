//! What triangles are drawn to whose edges are to be smooth, and the loops over it.

use blending::Operations;
use clipping::render::{Vertices, triangles_with};
use clipping::{Clipping, Counts, Cull, Mesh};
use common::{Color, Image, Vec2, Vec4};
use shaders::shader::{Fragment, Shader, Varying};
use zbuffer::{DepthBuffer, Surface};

use crate::resolve::Resolve;

// ANCHOR: canvas
/// What takes triangles and becomes a picture with smooth edges: a picture and more.
pub trait Canvas {
    /// What a sample keeps for the stencil.
    type Stencil;

    /// For a picture so wide and so high, all black, of which alpha covers no share.
    fn new(size: [usize; 2]) -> Self;

    /// Forgets all that was drawn: the picture is of one colour, and nothing is in front of it. With `alpha_to_coverage` a
    /// fragment's alpha is, from now on, the share of the samples that it covers.
    fn clear(&mut self, background: Color, alpha_to_coverage: bool);

    /// The size, in pixels, of what triangles are drawn to, which may be larger than the picture.
    fn size(&self) -> Vec2;

    /// Draws one triangle under a state of lesson 14. Corners are in the window: x and y in pixels of that size, the depth,
    /// and 1/w, above 0; the triangle is left out where lesson 10's loop would leave it out. `shade` makes a fragment's
    /// colour, or `None`, which leaves colours and depths as they are.
    ///
    /// The tests come first, with all that they do to the stencil, as for lesson 14's targets without `Late`: what `shade` or
    /// alpha then leaves out has counted as passing. OpenGL has it so only where early tests are asked for; else it counts
    /// just what is drawn. As the depth is tested before `shade` is asked, no shader can replace it.
    fn fill<V: Varying>(
        &mut self,
        state: impl Operations<Stencil = Self::Stencil>,
        corners: [Vec4; 3],
        varyings: [V; 3],
        shade: impl FnMut(Fragment<V>) -> Option<Color>,
    );

    /// Puts into a picture what is seen, of the size that this was made for.
    fn resolve(&self, resolve: Resolve, picture: &mut Image);

    /// The nearest depth of a sample in each pixel of such a picture; 1 where nothing is.
    fn depths(&self, picture: &Image) -> DepthBuffer<f32>;
}
// ANCHOR_END: canvas

// ANCHOR: render
/// Draws a mesh with any shader, as lesson 11's loop does.
///
/// # Panics
/// Where the mesh has a vertex or a face that the shader has not.
pub fn render<S: Shader<Output = Color> + ?Sized, C: Canvas>(
    shader: &S,
    mesh: &Mesh,
    cull: Cull,
    state: impl Operations<Stencil = C::Stencil>,
    canvas: &mut C,
) -> Counts {
    render_with(&mut Vertices::default(), shader, mesh, cull, state, canvas)
}

/// The same with vertices that are kept from one mesh to the next, whose memory is used again.
///
/// # Panics
/// As [`render`].
pub fn render_with<S: Shader<Output = Color> + ?Sized, C: Canvas>(
    vertices: &mut Vertices<S::Varying>,
    shader: &S,
    mesh: &Mesh,
    cull: Cull,
    state: impl Operations<Stencil = C::Stencil>,
    canvas: &mut C,
) -> Counts {
    let size = canvas.size();
    triangles_with(vertices, shader, mesh, cull, Clipping::GuardBand, size, |constant, corners, varyings| {
        canvas.fill(state, corners, varyings, |fragment| shader.fragment(constant, fragment));
    })
}
// ANCHOR_END: render

/// Draws a triangle in the window of a picture, `scale` times as large; its corners are x and y in pixels and z the depth.
pub fn plain<C: Canvas>(
    &Surface { corners, color }: &Surface,
    state: impl Operations<Stencil = C::Stencil>,
    scale: Vec2,
    canvas: &mut C,
) {
    let scale = scale.extend(1.0);
    canvas.fill(state, corners.map(|corner| (corner * scale).extend(1.0)), [(); 3], |_| Some(color));
}
