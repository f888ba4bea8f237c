//! What mission 13 gives: the levels of a texture as light, what a texture is outside of itself, and a floor. Nothing of lesson
//! 13 is in it, so that the program in which a submission runs has nothing of it either.

use std::sync::LazyLock;

use common::{Color, Format, Image, Vec2, Vec3};

/// What is found where (u, v) leave the square from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrap {
    /// The texel at the border.
    Clamp,
    /// The texture again and again.
    Repeat,
    /// The texture and its mirror image in turn.
    Mirror,
}

impl Wrap {
    /// Which texel of a row of n, from 0 to n − 1, stands for texel i, which may be any whole number.
    #[must_use]
    pub fn texel(self, i: i32, n: i32) -> i32 {
        match self {
            Self::Clamp => i.clamp(0, n - 1),
            Self::Repeat => i.rem_euclid(n),
            Self::Mirror => {
                let i = i.rem_euclid(2 * n);
                i.min(2 * n - 1 - i)
            }
        }
    }
}

/// How far (u, v) move from a pixel to its neighbours; a texture is 1 wide and 1 high.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint {
    /// To the next one on the right.
    pub x: Vec2,
    /// To the one above.
    pub y: Vec2,
}

/// The texels of a texture, or of a smaller version of it.
#[derive(Clone, Debug)]
pub struct Level {
    /// The texels as codes.
    pub image: Image,
}

impl Level {
    /// How many texels a row has.
    #[must_use]
    pub fn width(&self) -> i32 {
        self.image.width()
    }

    /// How many rows there are.
    #[must_use]
    pub fn height(&self) -> i32 {
        self.image.height()
    }

    /// The light of the texel in column i, from 0 to the width − 1, and row j, from 0, at the bottom, to the height − 1: red,
    /// green and blue from 0 to 255.
    ///
    /// # Panics
    /// Outside.
    #[must_use]
    pub fn light(&self, i: i32, j: i32) -> Vec3 {
        let color = self.image.get(i, j);
        let Some(Color { r, g, b, .. }) = color else {
            panic!("there is no texel in column {i} and row {j} of {}x{}", self.width(), self.height())
        };
        Vec3::from_array([r, g, b].map(|code| LIGHT[usize::from(code)]))
    }
}

/// The light of each code, from 0 to 255, by sRGB.
static LIGHT: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|code| {
        let share = code as f64 / 255.0;
        let light = if share <= 0.040_45 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) };
        (255.0 * light) as f32
    })
});

/// The code of a light.
#[must_use]
pub fn color(light: Vec3) -> Color {
    let code = |light: f32| {
        let light = light / 255.0;
        let share = if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
        (255.0 * share + 0.5) as u8
    };
    Color::rgb(code(light.x), code(light.y), code(light.z))
}

/// A picture and its smaller versions, down to 1×1, each half as wide and as high as the one before, by the mean light of four
/// texels. The sides must be the same power of 2.
#[must_use]
pub fn levels(image: Image) -> Vec<Level> {
    let mut levels = vec![Level { image }];
    while let Some(fine) = levels.last().filter(|level| level.width() > 1) {
        let side = (fine.width() / 2) as u16;
        let mut image = Image::new(side, side, Format::Rgb);
        for (x, y, _) in image.clone().pixels() {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| fine.light(2 * x + i, 2 * y + j));
            image.set(x, y, color(four.into_iter().sum::<Vec3>() / 4.0));
        }
        levels.push(Level { image });
    }
    levels
}

/// The light at (u, v) between the centres of four texels.
pub type Bilinear = fn(&Level, Vec2, Wrap) -> Vec3;

/// The level whose texels are as large as a footprint in a texture of that size is long.
pub type LevelOf = fn(Footprint, Vec2) -> f32;

/// Draws a floor to the horizon, covered with a texture of these levels, 1 wide. `eye` is over it, and looks along −z, a little
/// down.
pub fn floor(levels: &[Level], eye: Vec3, bilinear: Bilinear, level: LevelOf, image: &mut Image) {
    let size = image.size();
    let (sin, cos) = 0.35_f32.sin_cos();
    // The ray of a pixel is forward + right·x + up·y, with x and y in pixels from the middle.
    let [right, up] = [Vec3::X, Vec3::new(0.0, cos, -sin)].map(|way| way / size.y);
    let forward = Vec3::new(0.0, -sin, -cos);
    let base = Vec2::new(levels[0].width() as f32, levels[0].height() as f32);
    let on_floor = |v: Vec3| Vec2::new(v.x, -v.z);
    for y in 0..image.height() {
        for x in 0..image.width() {
            let place = Vec2::new(x as f32, y as f32) + 0.5 - size / 2.0;
            let ray = forward + right * place.x + up * place.y;
            // So far above the horizon as this is, or nearly, there is sky.
            if ray.y > -1e-3 {
                image.set(x, y, Color::rgb(120, 150, 190));
                continue;
            }
            let uv = on_floor(eye - ray * (eye.y / ray.y));
            // The derivative of a quotient.
            let step = |way: Vec3| on_floor(-eye.y * (way - ray * (way.y / ray.y)) / ray.y);
            let footprint = Footprint { x: step(right), y: step(up) };
            let last = levels.len() - 1;
            let level = level(footprint, base).clamp(0.0, last as f32);
            let (finer, share) = (level as usize, level.fract());
            let [a, b] = [finer, (finer + 1).min(last)].map(|n| bilinear(&levels[n], uv, Wrap::Repeat));
            image.set(x, y, color(a + (b - a) * share));
        }
    }
}
