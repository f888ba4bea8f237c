//! Wrong versions of mission 6, by which the judge knows what was done.

use common::{Color, Image, Vec3};
use gouraud_tasks::given::Scene;
use gouraud_tasks::{Draw, Drawn, Gouraud};
use judge::Fault;
use textures::{interpolate, texel};
use zbuffer::{DepthBuffer, fill_nearest};

use crate::RIGHT;

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Gouraud>] = &[
    Fault {
        cause: "the sign is wrong, as if the light came from behind: it points from the surface to the light",
        hint: None,
        versions: &[
            Gouraud { intensities: |normals, light| gouraud::intensities(normals, -light), ..RIGHT },
            with_draw(|scene, image, place| {
                (RIGHT.gouraud)(&Scene { light: -scene.light, ..*scene }, image, place)
            }),
        ],
    },
    Fault {
        cause: "clamped at the corners: below 0 an intensity still counts, clamp what is interpolated",
        hint: Some(3),
        versions: &[
            Gouraud {
                intensities: |normals, light| gouraud::intensities(normals, light).max(Vec3::ZERO),
                ..RIGHT
            },
            with_draw(|scene, image, place| draw(scene, image, place, |i, w| i.max(Vec3::ZERO).dot(w))),
        ],
    },
    Fault {
        cause: "the sign is lost: what faces away from the light is dark, not bright",
        hint: None,
        versions: &[
            Gouraud { intensities: |normals, light| gouraud::intensities(normals, light).abs(), ..RIGHT },
            with_draw(|scene, image, place| draw(scene, image, place, |i, w| i.dot(w).abs())),
            with_draw(|scene, image, place| draw(scene, image, place, |i, w| i.abs().dot(w))),
        ],
    },
    Fault {
        cause: "the corners are swapped: the first intensity is the first normal's",
        hint: None,
        versions: &[
            Gouraud { intensities: |[a, b, c], light| gouraud::intensities([b, c, a], light), ..RIGHT },
            Gouraud { intensities: |[a, b, c], light| gouraud::intensities([c, a, b], light), ..RIGHT },
            Gouraud { intensities: |[a, b, c], light| gouraud::intensities([a, c, b], light), ..RIGHT },
            with_draw(|scene, image, place| {
                draw(scene, image, place, |i, w| Vec3::new(i.y, i.z, i.x).dot(w))
            }),
            with_draw(|scene, image, place| {
                draw(scene, image, place, |i, w| Vec3::new(i.z, i.x, i.y).dot(w))
            }),
        ],
    },
    Fault {
        cause: "one brightness for the whole triangle: interpolate the corners' by the weights",
        hint: Some(1),
        versions: &[
            Gouraud { intensities: |[a, ..], light| Vec3::splat(a.dot(light)), ..RIGHT },
            Gouraud { intensities: |[a, b, c], light| Vec3::splat((a + b + c).dot(light) / 3.0), ..RIGHT },
            with_draw(|scene, image, place| draw(scene, image, place, |i, _| i.x)),
            with_draw(|scene, image, place| draw(scene, image, place, |i, _| i.element_sum() / 3.0)),
        ],
    },
    Fault {
        cause: "the light is forgotten: a texel is shaded(intensity)",
        hint: None,
        versions: &[with_draw(|scene, image, place| draw(scene, image, place, |_, _| 1.0))],
    },
    Fault {
        cause: "the texture is forgotten: the colour is the texel at the interpolated (u, v)",
        hint: None,
        versions: &[with_draw(|scene, image, place| {
            let mut white = Image::new(1, 1, common::Format::Rgb);
            white.set(0, 0, Color::WHITE);
            (RIGHT.gouraud)(&Scene { texture: &white, ..*scene }, image, place)
        })],
    },
    Fault {
        cause: "a triangle with a corner without a place is left out, and counted once in left_out: `continue` with the \
                next one",
        hint: Some(2),
        versions: &[
            with_draw(|scene, image, place| {
                (RIGHT.gouraud)(scene, image, &|p| Some(place(p).unwrap_or_default()))
            }),
            with_draw(|scene, image, place| {
                let mut over = false;
                drawn(scene, image, place, Vec3::dot, |corners, left_out| {
                    over |= corners.contains(&None);
                    *left_out += usize::from(corners.contains(&None));
                    !over
                })
            }),
            with_draw(|scene, image, place| Drawn { left_out: 0, ..(RIGHT.gouraud)(scene, image, place) }),
            with_draw(|scene, image, place| {
                drawn(scene, image, place, Vec3::dot, |corners, left_out| {
                    *left_out += corners.iter().filter(|corner| corner.is_none()).count();
                    !corners.contains(&None)
                })
            }),
            with_draw(|scene, image, place| {
                drawn(scene, image, place, Vec3::dot, |corners, left_out| {
                    *left_out += usize::from(!corners.contains(&None));
                    !corners.contains(&None)
                })
            }),
        ],
    },
    Fault {
        cause: "what faces away from the light is left out, as in lesson 5: here it is drawn, in black",
        hint: None,
        versions: &[
            with_draw(|scene, image, place| facing(scene, image, place, |i, _| i.max_element() >= 0.0)),
            with_draw(|scene, image, place| facing(scene, image, place, |i, _| i.min_element() >= 0.0)),
            with_draw(|scene, image, place| facing(scene, image, place, |_, flat| flat >= 0.0)),
        ],
    },
    Fault {
        cause: "there is no depth test, the last one drawn is seen: one buffer for all triangles, and fill_nearest()",
        hint: Some(1),
        versions: &[with_draw(|scene, image, place| {
            let mut all = Drawn { depths: DepthBuffer::new(image, f32::NEG_INFINITY), left_out: 0 };
            for n in 0..scene.model.triangles().len() {
                all.left_out += triangle(scene, image, place, n);
            }
            all
        })],
    },
];

type Place<'a> = &'a dyn Fn(Vec3) -> Option<Vec3>;

const fn with_draw(gouraud: Draw) -> Gouraud {
    Gouraud { gouraud, ..RIGHT }
}

fn draw(scene: &Scene, image: &mut Image, place: Place, shade: fn(Vec3, Vec3) -> f32) -> Drawn {
    drawn(scene, image, place, shade, |corners, left_out| {
        *left_out += usize::from(corners.contains(&None));
        !corners.contains(&None)
    })
}

/// As the lesson draws, but shaded by some function of intensities and weights, and where `is_drawn`, which counts.
fn drawn(
    scene: &Scene,
    image: &mut Image,
    place: Place,
    shade: fn(Vec3, Vec3) -> f32,
    mut is_drawn: impl FnMut(&[Option<Vec3>; 3], &mut usize) -> bool,
) -> Drawn {
    let mut drawn = Drawn { depths: DepthBuffer::new(image, f32::NEG_INFINITY), left_out: 0 };
    for (n, (corners, uvs)) in scene.model.faces().zip(scene.model.face_uvs()).enumerate() {
        let corners = corners.map(place);
        if is_drawn(&corners, &mut drawn.left_out) {
            let intensities = gouraud::intensities(scene.normals[n], scene.light);
            let corners = corners.map(Option::unwrap_or_default);
            fill_nearest(
                corners,
                &mut drawn.depths,
                |depth| depth,
                |x, y, weights| {
                    let color = texel(scene.texture, interpolate(uvs, weights));
                    image.set(x, y, color.shaded(shade(intensities, weights).max(0.0)));
                },
            );
        }
    }
    drawn
}

/// The triangle of that number, over all there is. Returns how many are left out.
fn triangle(scene: &Scene, image: &mut Image, place: Place, n: usize) -> usize {
    let corners = [0, 1, 2].map(|corner| place(scene.model.position(n, corner)));
    let [Some(a), Some(b), Some(c)] = corners else { return 1 };
    let uvs = [0, 1, 2].map(|corner| scene.model.uv(n, corner));
    let intensities = gouraud::intensities(scene.normals[n], scene.light);
    triangles::fill([a, b, c].map(Vec3::truncate), image.bounds(), |x, y, weights| {
        let color = texel(scene.texture, interpolate(uvs, weights));
        image.set(x, y, color.shaded(intensities.dot(weights).max(0.0)));
    });
    0
}

/// Only triangles of which the intensities at the corners, and the flat one, say so.
fn facing(scene: &Scene, image: &mut Image, place: Place, faces: fn(Vec3, f32) -> bool) -> Drawn {
    let mut n = 0;
    let facing: Vec<bool> = (scene.model.faces().zip(scene.normals))
        .map(|(corners, &normals)| {
            let flat = triangles::flat_intensity(corners, scene.light);
            faces(gouraud::intensities(normals, scene.light), flat)
        })
        .collect();
    drawn(scene, image, place, Vec3::dot, |corners, left_out| {
        n += 1;
        *left_out += usize::from(corners.contains(&None));
        facing[n - 1] && !corners.contains(&None)
    })
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
        JUDGE.earns_nothing(&Gouraud {
            intensities: |_, _| Vec3::ZERO,
            gouraud: |_, image, _| Drawn { depths: DepthBuffer::new(image, f32::NEG_INFINITY), left_out: 0 },
        });
    }

    #[test]
    fn each_fault_is_recognised() {
        let reference = JUDGE.reference;
        let check = |intensities, check, words| {
            let functions = Gouraud { intensities, gouraud: reference.gouraud };
            JUDGE.recognises(&functions, check, words);
        };
        check(|normals, light| gouraud::intensities(normals, -light), "corners", "behind");
        check(
            |normals, light| gouraud::intensities(normals, light).max(Vec3::ZERO),
            "corners",
            "clamped at the corners",
        );
        check(
            |[a, b, c], light| gouraud::intensities([b, c, a], light),
            "corners",
            "the corners are swapped",
        );
        let behind = Gouraud {
            gouraud: |scene, image, place| {
                (RIGHT.gouraud)(&Scene { light: -scene.light, ..*scene }, image, place)
            },
            ..reference
        };
        JUDGE.recognises(&behind, "two sides", "the light came from behind");
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
