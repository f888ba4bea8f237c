//! Wrong versions of mission 2, by which the judge knows what was done.

use common::{Color, DVec2, IVec2, Image, Model, Vec2, Vec2Swizzles, Vec3};
use judge::Fault;
use wireframe_tasks::Wireframe;

use crate::RIGHT;

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Wireframe>] = &[
    Fault {
        cause: "rounded to the nearest: a pixel is a square, so cut off with floor()",
        hint: Some(2),
        versions: &[
            Wireframe { to_pixel: |p, image| or_last(p, image, stretched(p, image).round()), ..RIGHT },
            Wireframe { to_pixel: |p, image| pixel(stretched(p, image).round()), ..RIGHT },
        ],
    },
    Fault {
        cause: "stretched to width - 1: columns are width pixels wide, (x + 1) * width / 2",
        hint: Some(1),
        versions: &[Wireframe {
            to_pixel: |p, image| pixel(((flat(p) + 1.0) * (size(image) - 1.0) / 2.0).floor()),
            ..RIGHT
        }],
    },
    Fault {
        cause: "x = -1 is not at the left border: 1 is added before anything else, (x + 1) * width / 2",
        hint: Some(1),
        versions: &[
            Wireframe { to_pixel: |p, image| pixel((flat(p) * size(image)).floor()), ..RIGHT },
            Wireframe { to_pixel: |p, image| pixel((flat(p) * size(image) / 2.0).floor()), ..RIGHT },
            Wireframe { to_pixel: |p, image| or_last(p, image, (flat(p) * size(image)).floor()), ..RIGHT },
            Wireframe {
                to_pixel: |p, image| or_last(p, image, (flat(p) * size(image) / 2.0).floor()),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "twice as large as the picture: from -1 to 1 are 2, so it is halved, (x + 1) * width / 2",
        hint: Some(1),
        versions: &[
            Wireframe { to_pixel: |p, image| pixel(((flat(p) + 1.0) * size(image)).floor()), ..RIGHT },
            Wireframe {
                to_pixel: |p, image| or_last(p, image, ((flat(p) + 1.0) * size(image)).floor()),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "cut off before it is stretched: of x + 1 only 0, 1 or 2 is left; multiply first",
        hint: Some(1),
        versions: &[
            Wireframe { to_pixel: |p, image| pixel((flat(p) + 1.0).floor() * size(image) / 2.0), ..RIGHT },
            Wireframe {
                to_pixel: |p, image| or_last(p, image, (flat(p) + 1.0).floor() * size(image) / 2.0),
                ..RIGHT
            },
            Wireframe {
                to_pixel: |p, image| or_last(p, image, (flat(p) + 1.0).trunc() * size(image) / 2.0),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "half of an odd width has a fraction, which whole numbers drop: halve a float",
        hint: None,
        versions: &[
            Wireframe {
                to_pixel: |p, image| {
                    or_last(p, image, ((flat(p) + 1.0) * (size(image) / 2.0).floor()).floor())
                },
                ..RIGHT
            },
            Wireframe {
                to_pixel: |p, image| pixel(((flat(p) + 1.0) * (size(image) / 2.0).floor()).floor()),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the width is used for y as well: rows are counted by the height",
        hint: None,
        versions: &[
            Wireframe {
                to_pixel: |p, image| {
                    let exact = ((flat(p) + 1.0) * f64::from(image.width()) / 2.0).floor();
                    or_last(p, image, exact)
                },
                ..RIGHT
            },
            Wireframe { to_pixel: |p, image| counted(p, [image.width(); 2]), ..RIGHT },
        ],
    },
    Fault {
        cause: "width and height are swapped: x is stretched to the width, y to the height",
        hint: None,
        versions: &[
            Wireframe { to_pixel: |p, image| counted(p, [image.height(), image.width()]), ..RIGHT },
            Wireframe {
                to_pixel: |p, image| pixel(((flat(p) + 1.0) * size(image).yx() / 2.0).floor()),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "column and row are swapped: the pixel is IVec2::new(column, row)",
        hint: None,
        versions: &[Wireframe { to_pixel: |p, image| wireframe::to_pixel(p, image).yx(), ..RIGHT }],
    },
    Fault {
        cause: "it is upside down: y points up, row 0 is the lowest",
        hint: None,
        versions: &[
            Wireframe {
                to_pixel: |p, image| {
                    let right = wireframe::to_pixel(p, image);
                    IVec2::new(right.x, image.height() - 1 - right.y)
                },
                ..RIGHT
            },
            Wireframe {
                to_pixel: |p, image| wireframe::to_pixel(p * Vec3::new(1.0, -1.0, 1.0), image),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "it is mirrored: x points to the right, column 0 is the leftmost",
        hint: None,
        versions: &[Wireframe {
            to_pixel: |p, image| {
                let right = wireframe::to_pixel(p, image);
                IVec2::new(image.width() - 1 - right.x, right.y)
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "y and z are mixed up: z is the one that is dropped",
        hint: None,
        versions: &[Wireframe {
            to_pixel: |p, image| wireframe::to_pixel(Vec3::new(p.x, p.z, 0.0), image),
            ..RIGHT
        }],
    },
    Fault {
        cause: "off by one at the border: x = 1 gives column `width`, which does not exist; there it is width - 1",
        hint: Some(3),
        versions: &[Wireframe { to_pixel: |p, image| pixel(stretched(p, image).floor()), ..RIGHT }],
    },
    Fault {
        cause: "the border has its rule in one direction only: at x = 1 the column is width - 1, at y = 1 the row \
                height - 1",
        hint: Some(3),
        versions: &[
            Wireframe {
                to_pixel: |p, image| or_last(p.with_y(0.0), image, stretched(p, image).floor()),
                ..RIGHT
            },
            Wireframe {
                to_pixel: |p, image| or_last(p.with_x(0.0), image, stretched(p, image).floor()),
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the rule of the border is for 1, not for -1: x = -1 is column 0",
        hint: Some(3),
        versions: &[Wireframe {
            to_pixel: |p, image| {
                let at = |x: f32| if x.abs() == 1.0 { 1.0 } else { x };
                wireframe::to_pixel(Vec3::new(at(p.x), at(p.y), 0.0), image)
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "cut off towards 0: below 0 that is inwards; floor() goes down everywhere",
        hint: Some(2),
        versions: &[
            Wireframe { to_pixel: |p, image| or_last(p, image, stretched(p, image)), ..RIGHT },
            Wireframe { to_pixel: |p, image| or_last(p, image, in_f32(p, image).as_dvec2()), ..RIGHT },
        ],
    },
    Fault {
        cause: "what lies beyond the border is moved onto it: only x = 1 exactly belongs to the last column",
        hint: Some(3),
        versions: &[
            Wireframe { to_pixel: |p, image| pixel(stretched(p, image).floor()).min(last(image)), ..RIGHT },
            Wireframe {
                to_pixel: |p, image| pixel(stretched(p, image).floor()).clamp(IVec2::ZERO, last(image)),
                ..RIGHT
            },
            // The column that is named `width`, with all that is in it.
            Wireframe {
                to_pixel: |p, image| {
                    let cut = pixel(stretched(p, image).floor());
                    cut - IVec2::new((cut.x == image.width()).into(), (cut.y == image.height()).into())
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "computed in f32: x + 1 loses the last bits of x, so a point next to a border moves across; use f64",
        hint: None,
        versions: &[Wireframe {
            to_pixel: |p, image| or_last(p, image, in_f32(p, image).floor().as_dvec2()),
            ..RIGHT
        }],
    },
    Fault {
        cause: "a side of each triangle is missing: the third one goes from c back to a",
        hint: Some(4),
        versions: &[
            Wireframe { wireframe: |model, image, color| some_sides(model, image, color, [0, 1]), ..RIGHT },
            Wireframe { wireframe: |model, image, color| some_sides(model, image, color, [1, 2]), ..RIGHT },
            Wireframe { wireframe: |model, image, color| some_sides(model, image, color, [0, 2]), ..RIGHT },
        ],
    },
    Fault {
        cause: "only the corners are drawn: line() draws what is between two of them",
        hint: None,
        versions: &[Wireframe {
            wireframe: |model, image, color| {
                for corner in model.faces().flatten() {
                    let at = wireframe::to_pixel(corner, image);
                    image.set(at.x, at.y, color);
                }
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "a triangle with a corner outside of the picture is left out: draw it, what is outside draws nothing",
        hint: None,
        versions: &[Wireframe {
            wireframe: |model, image, color| {
                let bounds = image.bounds();
                let inside = |corner: Vec3| {
                    let at = wireframe::to_pixel(corner, image);
                    bounds.contains(at.x, at.y)
                };
                let kept: Vec<[Vec3; 3]> =
                    model.faces().filter(|corners| corners.iter().all(|&corner| inside(corner))).collect();
                for corners in kept {
                    outline(corners, image, color, [0, 1, 2]);
                }
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "the colour is always white: use the one that is given",
        hint: None,
        versions: &[Wireframe {
            wireframe: |model, image, _| wireframe::wireframe(model, image, Color::WHITE),
            ..RIGHT
        }],
    },
];

fn flat(point: Vec3) -> DVec2 {
    point.truncate().as_dvec2()
}

fn size(image: &Image) -> DVec2 {
    image.size().as_dvec2()
}

/// x and y in pixels.
fn stretched(point: Vec3, image: &Image) -> DVec2 {
    (flat(point) + 1.0) * size(image) / 2.0
}

fn in_f32(point: Vec3, image: &Image) -> Vec2 {
    (point.truncate() + 1.0) * image.size() / 2.0
}

/// Towards 0.
fn pixel(exact: DVec2) -> IVec2 {
    exact.as_ivec2()
}

fn last(image: &Image) -> IVec2 {
    image.bounds().max
}

/// The same, but for coordinates of exactly 1.
fn or_last(point: Vec3, image: &Image, exact: DVec2) -> IVec2 {
    let (pixel, last) = (pixel(exact), last(image));
    IVec2::new(if point.x == 1.0 { last.x } else { pixel.x }, if point.y == 1.0 { last.y } else { pixel.y })
}

/// As many columns and rows as are said.
fn counted(point: Vec3, sizes: [i32; 2]) -> IVec2 {
    let number = |x: f32, size: i32| match x {
        1.0 => size - 1,
        x => ((f64::from(x) + 1.0) * f64::from(size) / 2.0).floor() as i32,
    };
    IVec2::new(number(point.x, sizes[0]), number(point.y, sizes[1]))
}

fn some_sides(model: &Model, image: &mut Image, color: Color, sides: [usize; 2]) {
    for corners in model.faces() {
        outline(corners, image, color, sides);
    }
}

fn outline(corners: [Vec3; 3], image: &mut Image, color: Color, sides: impl IntoIterator<Item = usize>) {
    let corners = corners.map(|corner| wireframe::to_pixel(corner, image));
    for n in sides {
        lines::line(corners[n], corners[(n + 1) % 3], image, color);
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
        JUDGE.earns_nothing(&Wireframe { wireframe: |_, _, _| (), to_pixel: |_, _| IVec2::ZERO });
    }

    #[test]
    fn each_fault_is_recognised() {
        let check = |to_pixel, check, words| {
            let functions = Wireframe { wireframe: wireframe::wireframe, to_pixel };
            JUDGE.recognises(&functions, check, words);
        };
        let as_printed: fn(Vec3, &Image) -> IVec2 =
            |p, image| ((p.truncate() + 1.0) * image.size() / 2.0).as_ivec2();
        check(as_printed, "border", "off by one at the border");
        check(as_printed, "outside", "cut off towards 0");
        check(|p, image| ((p.truncate() + 1.0) * image.size() / 2.0).round().as_ivec2(), "pixel", "rounded");
        check(|p, image| wireframe::to_pixel(p * Vec3::new(1.0, -1.0, 1.0), image), "pixel", "upside down");
        check(|p, image| wireframe::to_pixel(p * Vec3::new(-1.0, 1.0, 1.0), image), "pixel", "mirrored");
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
