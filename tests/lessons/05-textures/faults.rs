//! Wrong versions of mission 5, by which the judge knows what was done.

use common::{Color, Image, Model, Vec2, Vec2Swizzles, Vec3};
use judge::Fault;
use textures_tasks::Textures;
use triangles::flat_intensity;
use zbuffer::{DepthBuffer, fill_nearest, to_screen};

use crate::RIGHT;

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Textures>] = &[
    Fault {
        cause: "half a texel off: a texel is a square, so cut off and do not round",
        hint: Some(2),
        versions: &[
            Textures { texel: |t, uv| at(t, (uv * t.size()).round()), ..RIGHT },
            Textures { texel: |t, uv| clamped(t, (uv * t.size()).round()), ..RIGHT },
        ],
    },
    Fault {
        cause: "stretched to w - 1: texels are w wide, so it is u * w, and only what is beyond the last one is clamped",
        hint: None,
        versions: &[
            Textures { texel: |t, uv| clamped(t, (uv * (t.size() - 1.0)).floor()), ..RIGHT },
            Textures { texel: |t, uv| clamped(t, (uv * (t.size() - 1.0)).round()), ..RIGHT },
            Textures { texel: |t, uv| at(t, uv * (t.size() - 1.0)), ..RIGHT },
        ],
    },
    Fault {
        cause: "the texture is upside down: v = 0 is its bottom row, as y = 0 is",
        hint: Some(4),
        versions: &[Textures { texel: |t, uv| textures::texel(t, Vec2::new(uv.x, 1.0 - uv.y)), ..RIGHT }],
    },
    Fault {
        cause: "u and v are swapped: u goes along x, v along y",
        hint: Some(4),
        versions: &[
            Textures { texel: |t, uv| textures::texel(t, Vec2::new(uv.y, uv.x)), ..RIGHT },
            Textures {
                texel: |t, uv| {
                    let at = uv * t.size();
                    clamped(t, Vec2::new(at.y, at.x))
                },
                ..RIGHT
            },
            Textures {
                texel: |t, uv| {
                    let at = (uv * t.size()).floor().as_ivec2().max(t.bounds().min).min(t.bounds().max);
                    t.get(at.y, at.x).unwrap_or(Color::BLACK)
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the width is used for v as well: rows are counted by the height",
        hint: None,
        versions: &[Textures { texel: |t, uv| clamped(t, (uv * t.size().x).floor()), ..RIGHT }],
    },
    Fault {
        cause: "width and height are swapped: u is stretched to the width, v to the height",
        hint: None,
        versions: &[Textures { texel: |t, uv| clamped(t, (uv * t.size().yx()).floor()), ..RIGHT }],
    },
    Fault {
        cause: "cut off before it is stretched: of u from 0 to 1 only 0 is left; multiply first",
        hint: None,
        versions: &[
            Textures { texel: |t, uv| clamped(t, uv.floor() * t.size()), ..RIGHT },
            Textures { texel: |t, uv| clamped(t, uv.trunc() * t.size()), ..RIGHT },
        ],
    },
    Fault {
        cause: "black outside: there as well, not only at u = 1, it is the nearest texel that exists",
        hint: Some(3),
        versions: &[Textures {
            texel: |t, uv| {
                let at = (uv * t.size()).floor();
                at_last(t, uv, at)
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "black at u = 1 and outside: take the nearest texel that exists",
        hint: Some(3),
        versions: &[
            Textures { texel: |t, uv| at(t, (uv * t.size()).floor()), ..RIGHT },
            Textures { texel: textures::truncate, ..RIGHT },
        ],
    },
    Fault {
        cause: "it is clamped to 0 and 1 before it is stretched: at u = 1 that is w, and the last texel is w - 1",
        hint: Some(3),
        versions: &[
            Textures { texel: |t, uv| at(t, (uv.clamp(Vec2::ZERO, Vec2::ONE) * t.size()).floor()), ..RIGHT },
            Textures {
                texel: |t, uv| exact(t, (uv.clamp(Vec2::ZERO, Vec2::ONE) * t.size()).floor()),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "there is no texel at u = 1 and outside, and unwrap() panics: take the nearest one that exists",
        hint: Some(3),
        versions: &[
            Textures { texel: |t, uv| exact(t, (uv * t.size()).floor()), ..RIGHT },
            Textures { texel: |t, uv| exact(t, uv * t.size()), ..RIGHT },
        ],
    },
    Fault {
        cause: "the texture is repeated: from u = 1 on and outside, take the nearest texel that exists",
        hint: Some(3),
        versions: &[
            Textures { texel: textures::repeat, ..RIGHT },
            Textures { texel: |t, uv| textures::texel(t, uv.fract()), ..RIGHT },
            Textures { texel: |t, uv| textures::texel(t, uv.fract_gl()), ..RIGHT },
        ],
    },
    Fault {
        cause: "a texture without texels makes it panic: get() gives None there, for which the answer is black",
        hint: None,
        versions: &[
            Textures {
                texel: |t, uv| {
                    let at = (uv * t.size()).floor().as_ivec2();
                    let (x, y) = (at.x.clamp(0, t.width() - 1), at.y.clamp(0, t.height() - 1));
                    t.get(x, y).unwrap_or(Color::BLACK)
                },
                ..RIGHT
            },
            Textures {
                texel: |t, uv| {
                    let at = (uv * t.size()).floor().as_ivec2().max(t.bounds().min).min(t.bounds().max);
                    t.get(at.x, at.y).unwrap()
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the weights are turned: the first one belongs to the first corner",
        hint: None,
        versions: &[
            Textures { interpolate: |[a, b, c], w| textures::interpolate([b, c, a], w), ..RIGHT },
            Textures { interpolate: |[a, b, c], w| textures::interpolate([c, a, b], w), ..RIGHT },
            Textures { interpolate: |[a, b, c], w| textures::interpolate([a, c, b], w), ..RIGHT },
            Textures { interpolate: |[a, b, c], w| textures::interpolate([c, b, a], w), ..RIGHT },
        ],
    },
    Fault {
        cause: "the plain mean, without the weights: each corner's value is multiplied by its own",
        hint: None,
        versions: &[
            Textures { interpolate: |[a, b, c], _| (a + b + c) / 3.0, ..RIGHT },
            Textures { interpolate: |uvs, w| textures::interpolate(uvs, w) / 3.0, ..RIGHT },
        ],
    },
    Fault {
        cause: "the light is forgotten: a colour is shaded(intensity)",
        hint: None,
        versions: &[
            with_draw(|model, light, image, color| draw(model, light, image, color, |_, _| Some(1.0))),
            with_draw(|model, light, image, color| {
                draw(model, light, image, color, |corners, light| lit(corners, light).map(|_| 1.0))
            }),
        ],
    },
    Fault {
        cause: "what faces away from the light is drawn: leave it out where the intensity is below 0",
        hint: None,
        versions: &[
            with_draw(|model, light, image, color| {
                draw(model, light, image, color, |c, light| Some(flat_intensity(c, light)))
            }),
            with_draw(|model, light, image, color| {
                draw(model, light, image, color, |c, light| Some(flat_intensity(c, light).abs()))
            }),
        ],
    },
    Fault {
        cause: "there is no depth test, the last one drawn is seen: fill_nearest() has it, with one buffer for all",
        hint: Some(1),
        versions: &[with_draw(|model, light, image, color| {
            let empty = DepthBuffer::new(image, f32::NEG_INFINITY);
            for (corners, uvs) in model.faces().zip(model.face_uvs()) {
                if let Some(intensity) = lit(corners, light) {
                    let mut own = empty.clone();
                    paint(corners, uvs, intensity, &mut own, image, color);
                }
            }
            empty
        })],
    },
    Fault {
        cause: "one colour for all of a triangle: (u, v) is interpolated at each pixel, by its weights",
        hint: None,
        versions: &[
            with_draw(|model, light, image, color| one_color(model, light, image, color, Vec3::X)),
            with_draw(|model, light, image, color| one_color(model, light, image, color, Vec3::Y)),
            with_draw(|model, light, image, color| one_color(model, light, image, color, Vec3::Z)),
            with_draw(|model, light, image, color| {
                one_color(model, light, image, color, Vec3::splat(1.0 / 3.0))
            }),
        ],
    },
    Fault {
        cause: "the normal is that of the corners in the picture: light falls on the model's",
        hint: None,
        versions: &[with_draw(|model, light, image, color| {
            let size = image.size();
            let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
            for (corners, uvs) in model.faces().zip(model.face_uvs()) {
                if let Some(intensity) = lit(corners.map(|corner| to_screen(corner, size)), light) {
                    paint(corners, uvs, intensity, &mut depths, image, color);
                }
            }
            depths
        })],
    },
    Fault {
        cause: "the light is not asked: it is given, as `light`",
        hint: None,
        versions: &[with_draw(|model, _, image, color| {
            textures::draw_textured(model, Vec3::Z, image, color)
        })],
    },
    Fault {
        cause: "the farthest is seen: the depth is stored as it is, |depth| depth",
        hint: None,
        versions: &[with_draw(|model, light, image, color| {
            let size = image.size();
            let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
            for (corners, uvs) in model.faces().zip(model.face_uvs()) {
                if let Some(intensity) = lit(corners, light) {
                    let screen = corners.map(|corner| to_screen(corner, size));
                    fill_nearest(
                        screen,
                        &mut depths,
                        |depth| -depth,
                        |x, y, w| {
                            image.set(x, y, color(textures::interpolate(uvs, w)).shaded(intensity));
                        },
                    );
                }
            }
            depths
        })],
    },
    Fault {
        cause: "width and height of the picture are swapped: to_screen() takes image.size()",
        hint: None,
        versions: &[with_draw(|model, light, image, color| {
            let size = image.size().yx();
            let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
            for (corners, uvs) in model.faces().zip(model.face_uvs()) {
                if let Some(intensity) = lit(corners, light) {
                    let screen = corners.map(|corner| to_screen(corner, size));
                    fill_nearest(
                        screen,
                        &mut depths,
                        |depth| depth,
                        |x, y, w| {
                            image.set(x, y, color(textures::interpolate(uvs, w)).shaded(intensity));
                        },
                    );
                }
            }
            depths
        })],
    },
    Fault {
        cause: "where nothing is drawn the depth is a number: begin with f32::NEG_INFINITY, which is behind all",
        hint: None,
        versions: &[
            with_draw(|model, light, image, color| begun(model, light, image, color, -1.0)),
            with_draw(|model, light, image, color| begun(model, light, image, color, f32::MIN)),
            with_draw(|model, light, image, color| begun(model, light, image, color, -1000.0)),
        ],
    },
    Fault {
        cause: "the buffer starts too near, what is behind that is not drawn: begin with f32::NEG_INFINITY",
        hint: None,
        versions: &[with_draw(|model, light, image, color| begun(model, light, image, color, 0.0))],
    },
];

const fn with_draw(draw_textured: textures_tasks::Draw) -> Textures {
    Textures { draw_textured, ..RIGHT }
}

/// The texel at a place, cut off towards 0, or black.
fn at(texture: &Image, place: Vec2) -> Color {
    let place = place.as_ivec2();
    texture.get(place.x, place.y).unwrap_or(Color::BLACK)
}

/// The texel at a place, or a panic.
fn exact(texture: &Image, place: Vec2) -> Color {
    let place = place.as_ivec2();
    texture.get(place.x, place.y).unwrap()
}

/// The texel at a place, or black; the last one at a coordinate of exactly 1.
fn at_last(texture: &Image, uv: Vec2, place: Vec2) -> Color {
    let last = texture.bounds().max;
    let mut place = place.as_ivec2();
    if uv.x == 1.0 {
        place.x = last.x;
    }
    if uv.y == 1.0 {
        place.y = last.y;
    }
    texture.get(place.x, place.y).unwrap_or(Color::BLACK)
}

/// The nearest texel.
fn clamped(texture: &Image, place: Vec2) -> Color {
    at(texture, place.max(Vec2::ZERO).min(texture.size() - 1.0))
}

fn lit(corners: [Vec3; 3], light: Vec3) -> Option<f32> {
    Some(flat_intensity(corners, light)).filter(|&intensity| intensity >= 0.0)
}

/// The model, each triangle as bright as it is said to be, if at all.
fn draw(
    model: &Model,
    light: Vec3,
    image: &mut Image,
    color: &dyn Fn(Vec2) -> Color,
    intensity: fn([Vec3; 3], Vec3) -> Option<f32>,
) -> DepthBuffer<f32> {
    let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
    for (corners, uvs) in model.faces().zip(model.face_uvs()) {
        if let Some(intensity) = intensity(corners, light) {
            paint(corners, uvs, intensity, &mut depths, image, color);
        }
    }
    depths
}

/// As it should be, but for what the buffer begins with.
fn begun(
    model: &Model,
    light: Vec3,
    image: &mut Image,
    color: &dyn Fn(Vec2) -> Color,
    first: f32,
) -> DepthBuffer<f32> {
    let mut depths = DepthBuffer::new(image, first);
    for (corners, uvs) in model.faces().zip(model.face_uvs()) {
        if let Some(intensity) = lit(corners, light) {
            paint(corners, uvs, intensity, &mut depths, image, color);
        }
    }
    depths
}

/// As it should be, but with the same weights at all pixels of a triangle.
fn one_color(
    model: &Model,
    light: Vec3,
    image: &mut Image,
    color: &dyn Fn(Vec2) -> Color,
    weights: Vec3,
) -> DepthBuffer<f32> {
    let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
    for (corners, uvs) in model.faces().zip(model.face_uvs()) {
        if let Some(intensity) = lit(corners, light) {
            paint(corners, [textures::interpolate(uvs, weights); 3], intensity, &mut depths, image, color);
        }
    }
    depths
}

fn paint(
    corners: [Vec3; 3],
    uvs: [Vec2; 3],
    intensity: f32,
    depths: &mut DepthBuffer<f32>,
    image: &mut Image,
    color: &dyn Fn(Vec2) -> Color,
) {
    let size = image.size();
    let screen = corners.map(|corner| to_screen(corner, size));
    fill_nearest(
        screen,
        depths,
        |depth| depth,
        |x, y, weights| {
            image.set(x, y, color(textures::interpolate(uvs, weights)).shaded(intensity));
        },
    );
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
        JUDGE.earns_nothing(&Textures {
            texel: |_, _| Color::BLACK,
            interpolate: |_, _| Vec2::ZERO,
            draw_textured: |_, _, image, _| DepthBuffer::new(image, f32::NEG_INFINITY),
        });
    }

    #[test]
    fn each_fault_is_recognised() {
        let reference = JUDGE.reference;
        let check = |texel, check, words| {
            JUDGE.recognises(&Textures { texel, ..reference }, check, words);
        };
        check(textures::round, "within", "half a texel off");
        check(textures::truncate, "border", "black at u = 1");
        check(textures::repeat, "border", "repeated");
        check(|texture, uv| textures::texel(texture, Vec2::new(uv.x, 1.0 - uv.y)), "texels", "upside down");
        check(|texture, uv| textures::texel(texture, Vec2::new(uv.y, uv.x)), "texels", "u and v are swapped");
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
