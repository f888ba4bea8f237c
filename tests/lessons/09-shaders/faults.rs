//! Wrong versions of mission 9, by which the judge knows what was done.

use common::{Color, Vec2};
use judge::Fault;
use shaders_tasks::Shaders;
use shaders_tasks::given::{Lighting, Source, Uniforms, White, draw};
use textures::texel;

use crate::RIGHT;

// A row's functions may capture nothing, so that it takes macros to build them from others.

/// `Gouraud` made of other functions.
macro_rules! gouraud {
    ($corner:expr, $pixel:expr) => {
        Shaders {
            gouraud: |uniforms, target| draw(uniforms, White, Bright($corner, $pixel), target),
            gouraud_texture: |uniforms, target| draw(uniforms, TEXTURE, Bright($corner, $pixel), target),
            ..RIGHT
        }
    };
}

/// `Quantized` made of other functions.
macro_rules! quantized {
    ($corner:expr, $pixel:expr) => {
        Shaders {
            quantized: |uniforms, target| draw(uniforms, White, Bright($corner, $pixel), target),
            quantized_texture: |uniforms, target| draw(uniforms, TEXTURE, Bright($corner, $pixel), target),
            ..RIGHT
        }
    };
}

/// `Texture` made of other functions.
macro_rules! texture {
    ($corner:expr, $pixel:expr) => {
        Shaders {
            gouraud_texture: |uniforms, target| draw(uniforms, Colored($corner, $pixel), GOURAUD, target),
            quantized_texture: |uniforms, target| draw(uniforms, Colored($corner, $pixel), QUANTIZED, target),
            ..RIGHT
        }
    };
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Shaders>] = &[
    Fault {
        cause: "dark fragments are drawn black: leave the intensity below 0, and they are dropped",
        hint: Some(2),
        versions: &[gouraud!(CORNER, |_, i| i.max(0.0)), gouraud!(CORNER, |_, i| i.clamp(0.0, 1.0))],
    },
    Fault {
        cause: "the light comes from behind: it points from the surface to the light",
        hint: None,
        versions: &[gouraud!(CORNER, |_, i| -i), gouraud!(|u, face, n| -CORNER(u, face, n), |_, i| i)],
    },
    Fault {
        cause: "the brightness is clamped at the corners: what is dark counts when it is interpolated",
        hint: Some(1),
        versions: &[
            gouraud!(|u, face, n| CORNER(u, face, n).max(0.0), |_, i| i),
            quantized!(|u, face, n| CORNER(u, face, n).max(0.0), cut),
        ],
    },
    Fault {
        cause: "the light is not asked: the brightness is the normal times `light`, not the normal's z",
        hint: None,
        versions: &[gouraud!(|u, face, n| u.normals[face][n].z, |_, i| i)],
    },
    Fault {
        cause: "the light is made 1 long: a longer one is brighter",
        hint: None,
        versions: &[gouraud!(|u, face, n| u.normals[face][n].dot(u.light.normalize()), |_, i| i)],
    },
    Fault {
        cause: "the brightness is cut down to 1: under a bright light it may be more, only Quantized has min(i, 1)",
        hint: None,
        versions: &[gouraud!(CORNER, |_, i| i.min(1.0))],
    },
    Fault {
        cause: "the sign is lost: what faces away from the light is below 0, not bright",
        hint: None,
        versions: &[
            gouraud!(CORNER, |_, i| i.abs()),
            gouraud!(|u, face, n| CORNER(u, face, n).abs(), |_, i| i),
        ],
    },
    Fault {
        cause: "every corner has the first one's normal: it is normals[face][corner]",
        hint: None,
        versions: &[gouraud!(|u, face, _| CORNER(u, face, 0), |_, i| i)],
    },
    Fault {
        cause: "the corners are mixed up: the normal is normals[face][corner]",
        hint: None,
        versions: &[
            gouraud!(|u, face, n| CORNER(u, face, (n + 1) % 3), |_, i| i),
            gouraud!(|u, face, n| CORNER(u, face, (n + 2) % 3), |_, i| i),
        ],
    },
    Fault {
        cause: "the texture is upside down: v = 0 is its bottom row",
        hint: None,
        versions: &[texture!(UV, |u, uv| look_up(u, Vec2::new(uv.x, 1.0 - uv.y)))],
    },
    Fault {
        cause: "u and v are swapped",
        hint: None,
        versions: &[texture!(UV, |u, uv| look_up(u, Vec2::new(uv.y, uv.x)))],
    },
    Fault {
        cause: "every corner has the first one's (u, v): it is model.uv(face, corner)",
        hint: None,
        versions: &[texture!(|u, face, _| UV(u, face, 0), look_up)],
    },
    Fault {
        cause: "the corners are mixed up: (u, v) is model.uv(face, corner)",
        hint: None,
        versions: &[
            texture!(|u, face, n| UV(u, face, (n + 1) % 3), look_up),
            texture!(|u, face, n| UV(u, face, (n + 2) % 3), look_up),
        ],
    },
    Fault {
        cause: "there need not be a texture, and unwrap() panics: without one the colour is black",
        hint: Some(4),
        versions: &[texture!(UV, |u, uv| texel(u.texture.unwrap(), uv))],
    },
    Fault {
        cause: "without a texture it is not black",
        hint: Some(4),
        versions: &[texture!(UV, |u, uv| u.texture.map_or(Color::WHITE, |texture| texel(texture, uv)))],
    },
    Fault {
        cause: "rounded to the nearest step: cut off with floor()",
        hint: None,
        versions: &[quantized!(CORNER, |n, i| (n * i.min(1.0)).round() / n)],
    },
    Fault {
        cause: "rounded up to the next step: cut off with floor()",
        hint: None,
        versions: &[quantized!(CORNER, |n, i| (n * i.min(1.0)).ceil() / n)],
    },
    Fault {
        cause: "there are no steps: ⌊N * min(i, 1)⌋ / N",
        hint: None,
        versions: &[quantized!(CORNER, |_, i| i), quantized!(CORNER, |_, i| i.min(1.0))],
    },
    Fault {
        cause: "cut off towards 0: a brightness just below 0 becomes 0 and is drawn black; floor() goes down",
        hint: Some(2),
        versions: &[quantized!(CORNER, |n, i| (n * i.min(1.0)).trunc() / n)],
    },
    Fault {
        cause: "it is not multiplied by N: without that floor() leaves 0 or 1",
        hint: None,
        versions: &[
            quantized!(CORNER, |_, i| i.min(1.0).floor()),
            quantized!(CORNER, |n, i| i.min(1.0).floor() / n),
        ],
    },
    Fault {
        cause: "the highest step is missing: i is cut down to 1, before it is multiplied, not the step to N - 1",
        hint: None,
        versions: &[quantized!(CORNER, |n, i| (n * i).floor().min(n - 1.0) / n)],
    },
    Fault {
        cause: "it is not divided by N: the steps go from 0 to 1",
        hint: None,
        versions: &[quantized!(CORNER, |n, i| (n * i.min(1.0)).floor())],
    },
    Fault {
        cause: "the steps are made at the corners, and smooth again between them: make them at each pixel",
        hint: Some(1),
        versions: &[quantized!(|u, face, n| cut(u.levels.into(), CORNER(u, face, n)), |_, i| i)],
    },
    Fault {
        cause: "the number of levels is fixed: it is given, as `levels`",
        hint: None,
        versions: &[
            quantized!(CORNER, |_, i| cut(5.0, i)),
            quantized!(CORNER, |_, i| cut(6.0, i)),
            quantized!(CORNER, |_, i| cut(4.0, i)),
        ],
    },
    Fault {
        cause: "one level less: there are N, so multiply by N, not by N - 1",
        hint: None,
        versions: &[
            quantized!(CORNER, |n, i| cut(n - 1.0, i)),
            quantized!(CORNER, |n, i| (n * i.min(1.0)).floor() / (n - 1.0)),
        ],
    },
    Fault {
        cause: "what is brighter than 1 is not cut down: it is N * min(i, 1)",
        hint: None,
        versions: &[quantized!(CORNER, |n, i| (n * i).floor() / n)],
    },
    Fault {
        cause: "dark fragments of the quantized look are drawn black: leave the intensity below 0",
        hint: Some(2),
        versions: &[
            quantized!(CORNER, |n, i| cut(n, i.max(0.0))),
            quantized!(CORNER, |n, i| cut(n, i).max(0.0)),
        ],
    },
];

/// The lesson's brightness at a corner.
const CORNER: fn(&Uniforms, usize, usize) -> f32 = |u, face, corner| u.normals[face][corner].dot(u.light);

/// The lesson's (u, v) at a corner.
const UV: fn(&Uniforms, usize, usize) -> Vec2 = |u, face, corner| u.model.uv(face, corner);

fn cut(levels: f32, i: f32) -> f32 {
    (levels * i.min(1.0)).floor() / levels
}

fn look_up(uniforms: &Uniforms, uv: Vec2) -> Color {
    uniforms.texture.map_or(Color::BLACK, |texture| texel(texture, uv))
}

/// The parts as they should be.
const GOURAUD: Bright = Bright(CORNER, |_, i| i);
const QUANTIZED: Bright = Bright(CORNER, cut);
const TEXTURE: Colored = Colored(UV, look_up);

/// A brightness at a corner, and of the levels and what was interpolated of it that at a pixel. It leaves no triangle
/// out, as a student's.
struct Bright(fn(&Uniforms, usize, usize) -> f32, fn(f32, f32) -> f32);

impl Lighting for Bright {
    type Constant = f32;
    type Varying = f32;

    fn triangle(&self, uniforms: &Uniforms, _: usize) -> Option<f32> {
        Some(f32::from(uniforms.levels))
    }

    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> f32 {
        (self.0)(uniforms, face, corner)
    }

    fn intensity(&self, levels: f32, varying: f32) -> f32 {
        (self.1)(levels, varying)
    }
}

/// A (u, v) at a corner, and the colour there.
struct Colored(fn(&Uniforms, usize, usize) -> Vec2, fn(&Uniforms, Vec2) -> Color);

impl Source for Colored {
    type Varying = Vec2;

    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> Vec2 {
        (self.0)(uniforms, face, corner)
    }

    fn color(&self, uniforms: &Uniforms, uv: Vec2) -> Color {
        (self.1)(uniforms, uv)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JUDGE;

    #[test]
    fn the_reference_earns_ten_points_for_any_seed() {
        JUDGE.check();
    }

    #[test]
    fn to_do_nothing_earns_nothing() {
        JUDGE.earns_nothing(&Shaders {
            gouraud: |_, _| (),
            gouraud_texture: |_, _| (),
            quantized: |_, _| (),
            quantized_texture: |_, _| (),
        });
    }

    #[test]
    fn each_fault_is_recognised() {
        let reference = JUDGE.reference;
        JUDGE.recognises(&gouraud!(CORNER, |_, i| -i), "gouraud", "behind");
        JUDGE.recognises(&gouraud!(CORNER, |_, i| i.max(0.0)), "dropped", "drawn black");
        let rounded = quantized!(CORNER, |n, i| (n * i.clamp(-1.0, 1.0) + 0.5).floor() / n);
        JUDGE.recognises(&rounded, "steps", "rounded to the nearest step");
        let smooth = Shaders {
            quantized: reference.gouraud,
            quantized_texture: reference.gouraud_texture,
            ..reference
        };
        JUDGE.recognises(&smooth, "steps", "there are no steps");
        let upside_down = Shaders {
            gouraud_texture: |uniforms, target| {
                let Some(texture) = uniforms.texture else { return draw(uniforms, TEXTURE, GOURAUD, target) };
                let mut texture = texture.clone();
                texture.flip_vertically();
                // In the check the square is as bright above as below.
                draw(&Uniforms { texture: Some(&texture), ..*uniforms }, TEXTURE, GOURAUD, target);
            },
            ..reference
        };
        JUDGE.recognises(&upside_down, "texture", "upside down");
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
