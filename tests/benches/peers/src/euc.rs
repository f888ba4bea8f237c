//! `euc` 0.5: triangles in the plain loop over a box of pixels. It has no threads, and computes a vertex for each corner.

use common::{Mat4, Vec3};
use euc::buffer::Buffer2d;
use euc::rasterizer::{BackfaceCullingEnabled, Triangles};
use euc::{Pipeline, Target};
use filtering::Wrap;
use speed_scenes::Scene;

use crate::buffers::{Corner, buffers};
use crate::painter::Painter;

type Pixel = [u8; 4];

/// What it reads of a scene.
struct Uniforms {
    corners: Vec<Corner>,
    texels: Vec<Pixel>,
    texture: [i32; 2],
    repeats: bool,
    to_clip: Mat4,
    light: Vec3,
}

impl Pipeline for Uniforms {
    type Vertex = u32;
    /// u, v and the brightness.
    type VsOut = (f32, f32, f32);
    type Pixel = Pixel;

    #[inline(always)]
    fn vert(&self, &index: &u32) -> ([f32; 4], Self::VsOut) {
        let Corner { position, normal, uv } = self.corners[index as usize];
        ((self.to_clip * position.extend(1.0)).to_array(), (uv.x, uv.y, normal.dot(self.light)))
    }

    #[inline(always)]
    fn frag(&self, &(u, v, intensity): &Self::VsOut) -> Pixel {
        let [columns, rows] = self.texture;
        let texel = |u: f32, n: i32| {
            let place = if self.repeats { u - u.floor() } else { u };
            ((place * n as f32) as i32).clamp(0, n - 1)
        };
        let place = texel(v, rows) * columns + texel(u, columns);
        let [r, g, b, a] = self.texels[place as usize];
        // A float cast takes what is below 0 for 0.
        let shade = |channel: u8| (f32::from(channel) * intensity + 0.5) as u8;
        [shade(r), shade(g), shade(b), a]
    }
}

/// A scene, and what it is drawn on.
pub(crate) struct Euc {
    uniforms: Uniforms,
    indices: Vec<u32>,
    colors: Buffer2d<Pixel>,
    depths: Buffer2d<f32>,
}

impl Euc {
    pub(crate) fn new(scene: &Scene) -> Self {
        let (corners, indices) = buffers(scene);
        let texture = scene.surface().texture.base();
        let sides = [texture.width(), texture.height()];
        let places = (0..sides[1]).flat_map(|j| (0..sides[0]).map(move |i| (i, j)));
        let texels =
            places.map(|(i, j)| texture.texel(i, j)).map(|color| [color.r, color.g, color.b, color.a]);
        let size = scene.size.map(usize::from);
        let texels = texels.collect();
        let (to_clip, light) = (scene.to_clip, scene.light);
        let repeats = scene.surface().texture.wrap == Wrap::Repeat;
        Self {
            uniforms: Uniforms { corners, texels, texture: sides, repeats, to_clip, light },
            indices,
            colors: Buffer2d::new(size, [0; 4]),
            depths: Buffer2d::new(size, 1.0),
        }
    }
}

impl Painter for Euc {
    fn ready(&mut self, _: &str) {}

    fn draw(&mut self, _: &str) {
        self.colors.clear([0, 0, 0, 255]);
        self.depths.clear(1.0);
        let (colors, depths) = (&mut self.colors, Some(&mut self.depths));
        self.uniforms.draw::<Triangles<'_, _, BackfaceCullingEnabled>, _>(&self.indices, colors, depths);
    }

    fn picture(&self) -> Vec<u8> {
        let rows = self.colors.as_ref().chunks_exact(self.colors.size()[0]).rev();
        rows.flatten().flat_map(|&[r, g, b, _]| [r, g, b]).collect()
    }
}
