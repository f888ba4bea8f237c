//! The slides' renderer, as their listings have it in C++ (*Z-buffering*, *Textures*, *Refactor*): for every pixel
//! of the bounding box the weights by a cross product, in floats; a z-buffer of floats; pictures of any number
//! of bytes a pixel, read and written by bounds-checked `get` and `set`; a shader with virtual functions.
//!
//! It has what -O3 would find, and more: the matrices are multiplied once, not once a corner.

use common::{Image, Mat4, Model, Vec2, Vec3, Vec4Swizzles};
use shaders::Uniforms;
use transforms::viewport;

/// The slides' colour: up to four bytes.
#[derive(Clone, Copy, Default)]
struct TgaColor {
    raw: [u8; 4],
}

/// The slides' picture: rows of pixels of so many bytes.
pub(crate) struct TgaImage {
    width: i32,
    height: i32,
    bytes: usize,
    data: Vec<u8>,
}

impl TgaImage {
    fn get(&self, x: i32, y: i32) -> TgaColor {
        let mut color = TgaColor::default();
        if x >= 0 && y >= 0 && x < self.width && y < self.height {
            let at = (x + y * self.width) as usize * self.bytes;
            let pixel = &self.data[at..at + self.bytes];
            color.raw.iter_mut().zip(pixel).for_each(|(to, from)| *to = *from);
        }
        color
    }

    fn set(&mut self, x: i32, y: i32, color: TgaColor) {
        if x >= 0 && y >= 0 && x < self.width && y < self.height {
            let at = (x + y * self.width) as usize * self.bytes;
            self.data[at..at + self.bytes].copy_from_slice(&color.raw[..self.bytes]);
        }
    }
}

/// The slides' shader: it keeps what it computed for the corners.
trait Shader {
    fn vertex(&mut self, face: usize, corner: usize) -> Vec3;
    fn fragment(&self, bary: Vec3, color: &mut TgaColor) -> bool;
}

struct GouraudTexture<'a> {
    model: &'a Model,
    normals: &'a [[Vec3; 3]],
    light: Vec3,
    to_screen: Mat4,
    texture: &'a TgaImage,
    intensities: Vec3,
    uvs: [Vec2; 3],
}

impl Shader for GouraudTexture<'_> {
    fn vertex(&mut self, face: usize, corner: usize) -> Vec3 {
        self.intensities[corner] = self.normals[face][corner].dot(self.light);
        self.uvs[corner] = self.model.uv(face, corner);
        let p = self.to_screen * self.model.position(face, corner).extend(1.0);
        p.xyz() / p.w
    }

    fn fragment(&self, bary: Vec3, color: &mut TgaColor) -> bool {
        let intensity = self.intensities.dot(bary);
        if intensity < 0.0 {
            return false;
        }
        let uv = self.uvs[0] * bary.x + self.uvs[1] * bary.y + self.uvs[2] * bary.z;
        let (width, height) = (self.texture.width as f32, self.texture.height as f32);
        *color = self.texture.get((uv.x * width) as i32, (uv.y * height) as i32);
        for channel in &mut color.raw[..3] {
            *channel = (f32::from(*channel) * intensity) as u8;
        }
        true
    }
}

/// A picture and its z-buffer.
pub(crate) struct Listing {
    image: TgaImage,
    zbuffer: Vec<f32>,
}

impl Listing {
    pub(crate) fn new(side: u16) -> Self {
        let pixels = usize::from(side) * usize::from(side);
        let image = TgaImage { width: side.into(), height: side.into(), bytes: 3, data: vec![0; 3 * pixels] };
        Self { image, zbuffer: vec![f32::NEG_INFINITY; pixels] }
    }

    pub(crate) fn texture(image: &Image) -> TgaImage {
        let data = image.pixels().flat_map(|(_, _, color)| [color.r, color.g, color.b]).collect();
        TgaImage { width: image.width(), height: image.height(), bytes: 3, data }
    }

    /// How many pixels are not black.
    pub(crate) fn drawn(&self) -> usize {
        self.image.data.chunks(3).filter(|pixel| *pixel != [0; 3]).count()
    }

    pub(crate) fn draw(&mut self, scene: &Uniforms, texture: &TgaImage) {
        let (width, height) = (self.image.width as f32, self.image.height as f32);
        let mut shader = GouraudTexture {
            model: scene.model,
            normals: scene.normals,
            light: scene.light,
            to_screen: viewport(width, height, 0.5) * scene.to_clip,
            texture,
            intensities: Vec3::ZERO,
            uvs: [Vec2::ZERO; 3],
        };
        // Without this the compiler would see that there is but one shader, which the slides' could not.
        let shader: &mut dyn Shader = std::hint::black_box(&mut shader);
        for face in 0..scene.model.faces().len() {
            let screen = [shader.vertex(face, 0), shader.vertex(face, 1), shader.vertex(face, 2)];
            self.triangle(&screen, shader);
        }
    }

    fn triangle(&mut self, t: &[Vec3; 3], shader: &dyn Shader) {
        let low = t[0].min(t[1]).min(t[2]).max(Vec3::ZERO);
        let high = t[0].max(t[1]).max(t[2]);
        let right = (high.x as i32).min(self.image.width - 1);
        let top = (high.y as i32).min(self.image.height - 1);
        for y in low.y as i32..=top {
            for x in low.x as i32..=right {
                let b = barycentric(t, x as f32, y as f32);
                if b.x >= 0.0 && b.y >= 0.0 && b.z >= 0.0 {
                    let z = b.x * t[0].z + b.y * t[1].z + b.z * t[2].z;
                    let at = (x + self.image.width * y) as usize;
                    if self.zbuffer[at] < z {
                        let mut color = TgaColor::default();
                        if shader.fragment(b, &mut color) {
                            self.zbuffer[at] = z;
                            self.image.set(x, y, color);
                        }
                    }
                }
            }
        }
    }
}

fn barycentric(t: &[Vec3; 3], x: f32, y: f32) -> Vec3 {
    let along = Vec3::new(t[1].x - t[0].x, t[2].x - t[0].x, t[0].x - x);
    let up = Vec3::new(t[1].y - t[0].y, t[2].y - t[0].y, t[0].y - y);
    let u = along.cross(up);
    if u.z.abs() < 1.0 {
        return Vec3::new(-1.0, 1.0, 1.0);
    }
    Vec3::new(1.0 - (u.x + u.y) / u.z, u.x / u.z, u.y / u.z)
}
