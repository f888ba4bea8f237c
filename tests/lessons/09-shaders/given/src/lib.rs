//! What mission 9 gives: the two traits of a look, and a loop that draws with any. It is made of lessons 3 to 7, so that the
//! program in which a submission runs has nothing of lesson 9.

use common::{Color, Image, Mat4, Model, Vec2, Vec3, Vec4Swizzles};
use transforms::scale;
use zbuffer::{DepthBuffer, fill_depths, to_screen};

/// What the shaders read, the same for all vertices and fragments of a picture.
#[derive(Clone, Copy)]
pub struct Uniforms<'a> {
    /// The triangles, with texture coordinates if the shader needs them.
    pub model: &'a Model,
    /// The unit normals at the corners of each triangle, if the shader needs them.
    pub normals: &'a [[Vec3; 3]],
    /// The texture, if the shader needs it.
    pub texture: Option<&'a Image>,
    /// Unit vector from the surface to the light.
    pub light: Vec3,
    /// From the model's space to the square of the picture and depth, before division by w.
    pub to_clip: Mat4,
    /// Steps of the quantized shader, at least 1.
    pub levels: u16,
}

impl<'a> Uniforms<'a> {
    /// A model as it stands, without normals or texture, lit from the front, in six steps.
    #[must_use]
    pub fn new(model: &'a Model) -> Self {
        Self { model, normals: &[], texture: None, light: Vec3::Z, to_clip: Mat4::IDENTITY, levels: 6 }
    }
}

/// Lets a length of 1 take up `zoom` times the smaller side of a picture of that size, to the right and up.
#[must_use]
pub fn fit(zoom: f32, size: Vec2) -> Mat4 {
    scale((2.0 * zoom * size.min_element() / size).extend(1.0))
}

/// What can be interpolated.
pub trait Varying: Copy {
    /// The sum of three corners' values, each times its weight.
    #[must_use]
    fn interpolate(corners: [Self; 3], weights: Vec3) -> Self;
}

impl Varying for () {
    fn interpolate(_: [(); 3], _: Vec3) {}
}

impl Varying for f32 {
    fn interpolate(corners: [f32; 3], weights: Vec3) -> f32 {
        Vec3::from_array(corners).dot(weights)
    }
}

impl Varying for Vec2 {
    fn interpolate([a, b, c]: [Vec2; 3], weights: Vec3) -> Vec2 {
        a * weights.x + b * weights.y + c * weights.z
    }
}

/// A way to light a surface.
pub trait Lighting {
    /// What is the same all over a triangle.
    type Constant: Copy;
    /// What it interpolates.
    type Varying: Varying;
    /// What is the same all over this triangle, or `None` to leave it out.
    fn triangle(&self, uniforms: &Uniforms, face: usize) -> Option<Self::Constant>;
    /// Its value at a corner.
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> Self::Varying;
    /// The brightness at a pixel: 1 is full, 0 black, below 0 drops the fragment.
    fn intensity(&self, constant: Self::Constant, varying: Self::Varying) -> f32;
}

/// A source of colour.
pub trait Source {
    /// What it interpolates.
    type Varying: Varying;
    /// Its value at a corner.
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> Self::Varying;
    /// The colour at a pixel.
    fn color(&self, uniforms: &Uniforms, varying: Self::Varying) -> Color;
}

/// White all over.
#[derive(Clone, Copy, Debug)]
pub struct White;

impl Source for White {
    type Varying = ();

    fn corner(&self, _: &Uniforms, _: usize, _: usize) {}

    fn color(&self, _: &Uniforms, (): ()) -> Color {
        Color::WHITE
    }
}

/// A picture and the depths of what is seen in it.
#[derive(Clone, Debug)]
pub struct Framebuffer {
    /// The picture.
    pub image: Image,
    /// The nearest depth in each pixel.
    pub depths: DepthBuffer<f32>,
}

impl Framebuffer {
    /// With nothing in it yet but that picture.
    #[must_use]
    pub fn new(image: Image) -> Self {
        let depths = DepthBuffer::new(&image, f32::NEG_INFINITY);
        Self { image, depths }
    }
}

/// Draws a model in the colours of a source under a lighting. A triangle with a corner at the eye's height or behind it is left
/// out.
pub fn draw<L: Lighting, S: Source>(uniforms: &Uniforms, source: S, lighting: L, target: &mut Framebuffer) {
    let Framebuffer { image, depths } = target;
    let (model, size) = (uniforms.model, image.size());
    let place = |p: &Vec3| {
        let p = uniforms.to_clip * p.extend(1.0);
        (p.w > 1e-6).then(|| to_screen(p.xyz() / p.w, size))
    };
    let places: Vec<Option<Vec3>> = model.positions().iter().map(place).collect();
    for (face, triangle) in model.triangles().iter().enumerate() {
        let Some(constant) = lighting.triangle(uniforms, face) else { continue };
        let [Some(a), Some(b), Some(c)] = triangle.map(|vertex| places[vertex as usize]) else { continue };
        let lit = [0, 1, 2].map(|corner| lighting.corner(uniforms, face, corner));
        let colored = [0, 1, 2].map(|corner| source.corner(uniforms, face, corner));
        fill_depths([a, b, c], depths.bounds(), |x, y, depth, weights| {
            if depths.is_nearer(x, y, depth) {
                let intensity = lighting.intensity(constant, L::Varying::interpolate(lit, weights));
                if intensity >= 0.0 {
                    let color = source.color(uniforms, S::Varying::interpolate(colored, weights));
                    depths.set(x, y, depth);
                    image.set(x, y, color.shaded(intensity));
                }
            }
        });
    }
}
