//! The slides' renderer, as a student would write it in C++ from the listings (*Z-buffering*, *Textures*,
//! *Gouraud*, *Refactor*): for every pixel of the bounding box the weights by a cross product, in floats; a
//! z-buffer of floats; pictures read and written by bounds-checked `get` and `set`.
//!
//! It has what a compiler's -O3 would find or a student would do: the matrices multiplied once, the shader's code
//! inlined instead of called through a table, three bytes a pixel known beforehand.

use common::{Image, Vec2, Vec3, Vec4Swizzles};
use shaders::Scene;

/// The slides' picture: rows of three bytes.
pub(crate) struct Tga {
    width: i32,
    height: i32,
    data: Vec<u8>,
}

impl Tga {
    fn get(&self, x: i32, y: i32) -> [u8; 3] {
        if x < 0 || y < 0 || x >= self.width || y >= self.height {
            return [0; 3];
        }
        let at = (x + y * self.width) as usize * 3;
        [self.data[at], self.data[at + 1], self.data[at + 2]]
    }

    fn set(&mut self, x: i32, y: i32, color: [u8; 3]) {
        if x < 0 || y < 0 || x >= self.width || y >= self.height {
            return;
        }
        let at = (x + y * self.width) as usize * 3;
        self.data[at..at + 3].copy_from_slice(&color);
    }
}

/// A picture and its z-buffer.
pub(crate) struct Listing {
    image: Tga,
    zbuffer: Vec<f32>,
}

impl Listing {
    pub(crate) fn new(side: u16) -> Self {
        let pixels = usize::from(side) * usize::from(side);
        let image = Tga { width: side.into(), height: side.into(), data: vec![0; 3 * pixels] };
        Self { image, zbuffer: vec![f32::NEG_INFINITY; pixels] }
    }

    pub(crate) fn texture(image: &Image) -> Tga {
        let data = image.pixels().flat_map(|(_, _, color)| [color.r, color.g, color.b]).collect();
        Tga { width: image.width(), height: image.height(), data }
    }

    /// How many pixels are not black.
    pub(crate) fn drawn(&self) -> usize {
        self.image.data.chunks(3).filter(|pixel| *pixel != [0; 3]).count()
    }

    pub(crate) fn draw(&mut self, scene: &Scene, texture: &Tga) {
        for face in 0..scene.model.faces().len() {
            let screen = [0, 1, 2].map(|corner| {
                let p = scene.to_screen * scene.model.position(face, corner).extend(1.0);
                p.xyz() / p.w
            });
            let uvs = [0, 1, 2].map(|corner| scene.model.uv(face, corner));
            let normals = scene.normals[face];
            let intensities = Vec3::from_array(normals.map(|normal| normal.dot(scene.light)));
            self.triangle(screen, uvs, intensities, texture);
        }
    }

    fn triangle(&mut self, t: [Vec3; 3], uvs: [Vec2; 3], intensities: Vec3, texture: &Tga) {
        let low = t[0].min(t[1]).min(t[2]).max(Vec3::ZERO);
        let high = t[0].max(t[1]).max(t[2]);
        let right = (high.x as i32).min(self.image.width - 1);
        let top = (high.y as i32).min(self.image.height - 1);
        for y in low.y as i32..=top {
            for x in low.x as i32..=right {
                let b = barycentric(&t, x as f32, y as f32);
                if b.x >= 0.0 && b.y >= 0.0 && b.z >= 0.0 {
                    let z = b.x * t[0].z + b.y * t[1].z + b.z * t[2].z;
                    let at = (x + self.image.width * y) as usize;
                    if self.zbuffer[at] < z {
                        let intensity = intensities.dot(b);
                        if intensity >= 0.0 {
                            let uv = uvs[0] * b.x + uvs[1] * b.y + uvs[2] * b.z;
                            let texel = texture.get(
                                (uv.x * texture.width as f32) as i32,
                                (uv.y * texture.height as f32) as i32,
                            );
                            self.zbuffer[at] = z;
                            self.image.set(x, y, texel.map(|channel| (f32::from(channel) * intensity) as u8));
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
