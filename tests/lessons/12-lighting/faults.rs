//! Wrong versions of mission 12, by which the judge knows what was done.

use common::Vec3;
use judge::Fault;
use lighting_tasks::Lighting;
use lighting_tasks::given::{PointLight, Reflected};

use crate::RIGHT;

/// A version of the model, from the point, the normal, the eye and the light.
macro_rules! version {
    (|$point:ident, $normal:ident, $eye:ident, $light:ident| $result:expr) => {
        Lighting {
            blinn_phong: |$point, $normal, $eye, $light| {
                let _ = ($point, $normal, $eye, $light);
                $result
            },
        }
    };
}

fn unit(v: Vec3) -> Vec3 {
    v.normalize_or_zero()
}

/// Blinn's model by three directions, as they are given.
fn by_directions(n: Vec3, l: Vec3, v: Vec3, light: &PointLight) -> Reflected {
    by_cosines(n.dot(l), n.dot(unit(l + v)), light)
}

/// The model by the two cosines.
fn by_cosines(straight: f32, highlight: f32, light: &PointLight) -> Reflected {
    if straight <= 0.0 {
        return Reflected { body: light.ambient, highlight: 0.0 };
    }
    Reflected {
        body: light.ambient + light.diffuse * straight,
        highlight: light.specular * highlight.max(0.0).powf(light.shininess),
    }
}

/// The two cosines as they are, n·l and n·h.
fn cosines(point: Vec3, normal: Vec3, eye: Vec3, light: &PointLight) -> [f32; 2] {
    let (n, l, v) = (unit(normal), unit(light.position - point), unit(eye - point));
    [n.dot(l), n.dot(unit(l + v))]
}

/// The lesson's result, changed where light falls on the surface, which is where the cosine is above 0.
fn lit(
    (point, normal, eye, light): (Vec3, Vec3, Vec3, &PointLight),
    change: impl Fn(Reflected, f32, f32) -> Reflected,
) -> Reflected {
    let right = (RIGHT.blinn_phong)(point, normal, eye, light);
    let [straight, halfway] = cosines(point, normal, eye, light);
    if straight <= 0.0 { right } else { change(right, straight, halfway.max(0.0)) }
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Lighting>] = &[
    Fault {
        cause: "the direction runs from the light to the point: it is the light's position less the point",
        hint: Some(1),
        versions: &[version!(|point, normal, eye, light| {
            by_directions(unit(normal), unit(point - light.position), unit(eye - point), light)
        })],
    },
    Fault {
        cause: "the light's position is taken for the direction to it: the point has to be subtracted",
        hint: Some(1),
        versions: &[
            version!(|point, normal, eye, light| {
                by_directions(unit(normal), unit(light.position), unit(eye - point), light)
            }),
            version!(|point, normal, eye, light| {
                by_directions(unit(normal), unit(light.position), unit(eye), light)
            }),
        ],
    },
    Fault {
        cause: "the direction to the light is not made 1 long",
        hint: Some(1),
        versions: &[
            version!(|point, normal, eye, light| {
                by_directions(unit(normal), light.position - point, unit(eye - point), light)
            }),
            version!(|point, normal, eye, light| {
                by_directions(unit(normal), light.position - point, eye - point, light)
            }),
            // In the cosine alone.
            version!(|point, normal, eye, light| {
                let [_, halfway] = cosines(point, normal, eye, light);
                by_cosines(unit(normal).dot(light.position - point), halfway, light)
            }),
        ],
    },
    Fault {
        cause: "ambient light is missing: it is added, whatever falls on the surface",
        hint: None,
        versions: &[
            version!(|point, normal, eye, light| {
                let right = (RIGHT.blinn_phong)(point, normal, eye, light);
                Reflected { body: right.body - light.ambient, ..right }
            }),
            version!(|point, normal, eye, light| {
                lit((point, normal, eye, light), |right, _, _| Reflected {
                    body: right.body - light.ambient,
                    ..right
                })
            }),
        ],
    },
    Fault {
        cause: "ambient light is dimmed by the cosine as well: it comes from everywhere, and only diffuse light is",
        hint: None,
        versions: &[
            version!(|point, normal, eye, light| {
                lit((point, normal, eye, light), |right, straight, _| Reflected {
                    body: (light.ambient + light.diffuse) * straight,
                    ..right
                })
            }),
            version!(|point, normal, eye, light| {
                lit((point, normal, eye, light), |right, straight, _| Reflected {
                    body: light.ambient * light.diffuse * straight,
                    ..right
                })
            }),
        ],
    },
    Fault {
        cause: "diffuse light does not depend on the angle: multiply it by n · l",
        hint: None,
        versions: &[version!(|point, normal, eye, light| {
            lit((point, normal, eye, light), |right, _, _| Reflected {
                body: light.ambient + light.diffuse,
                ..right
            })
        })],
    },
    Fault {
        cause: "the highlight is part of the body: it is white, whatever the surface's colour, and has a number of its own",
        hint: None,
        versions: &[version!(|point, normal, eye, light| {
            lit((point, normal, eye, light), |right, _, _| Reflected {
                body: right.body + right.highlight,
                highlight: 0.0,
            })
        })],
    },
    Fault {
        cause: "the direction runs from the eye to the point: it is the eye less the point",
        hint: Some(2),
        versions: &[version!(|point, normal, eye, light| {
            by_directions(unit(normal), unit(light.position - point), unit(point - eye), light)
        })],
    },
    Fault {
        cause: "the eye's position is taken for the direction to it: the point has to be subtracted",
        hint: Some(2),
        versions: &[version!(|point, normal, eye, light| {
            by_directions(unit(normal), unit(light.position - point), unit(eye), light)
        })],
    },
    Fault {
        cause: "the two directions are of different lengths when they are added: only then is their sum in the middle, \
                when each is 1 long",
        hint: Some(2),
        versions: &[
            version!(|point, normal, eye, light| {
                let [straight, _] = cosines(point, normal, eye, light);
                let halfway = unit(light.position - point + eye - point);
                by_cosines(straight, unit(normal).dot(halfway), light)
            }),
            version!(|point, normal, eye, light| {
                by_directions(unit(normal), unit(light.position - point), eye - point, light)
            }),
        ],
    },
    Fault {
        cause: "the half-way vector is not made 1 long: the sum of two unit vectors is up to 2 long, their mean up to 1",
        hint: Some(2),
        versions: &[
            version!(|point, normal, eye, light| {
                let (n, l, v) = (unit(normal), unit(light.position - point), unit(eye - point));
                by_cosines(n.dot(l), n.dot(l + v), light)
            }),
            version!(|point, normal, eye, light| {
                let (n, l, v) = (unit(normal), unit(light.position - point), unit(eye - point));
                by_cosines(n.dot(l), n.dot((l + v) / 2.0), light)
            }),
        ],
    },
    Fault {
        cause: "this is Phong's highlight, of the mirrored direction and the eye: Blinn's is of the normal and the half-way \
                vector",
        hint: Some(2),
        versions: &[version!(|point, normal, eye, light| {
            let (n, l, v) = (unit(normal), unit(light.position - point), unit(eye - point));
            by_cosines(n.dot(l), (2.0 * n.dot(l) * n - l).dot(v), light)
        })],
    },
    Fault {
        cause: "the highlight is of the half-way vector and the eye, or the light: it is of the half-way vector and the normal",
        hint: Some(2),
        versions: &[version!(|point, normal, eye, light| {
            let (n, l, v) = (unit(normal), unit(light.position - point), unit(eye - point));
            by_cosines(n.dot(l), v.dot(unit(l + v)), light)
        })],
    },
    Fault {
        cause: "the power is missing: the cosine is raised to the shininess, which makes it small beside the highlight's middle",
        hint: Some(3),
        versions: &[
            version!(|point, normal, eye, light| {
                lit((point, normal, eye, light), |right, _, halfway| Reflected {
                    highlight: light.specular * halfway,
                    ..right
                })
            }),
            version!(|point, normal, eye, light| {
                lit((point, normal, eye, light), |right, _, halfway| Reflected {
                    highlight: light.specular * halfway * light.shininess,
                    ..right
                })
            }),
        ],
    },
    Fault {
        cause: "specular light is raised to the power with the cosine: first the power, then times specular",
        hint: Some(3),
        versions: &[version!(|point, normal, eye, light| {
            lit((point, normal, eye, light), |right, _, halfway| Reflected {
                highlight: (light.specular * halfway).powf(light.shininess),
                ..right
            })
        })],
    },
    Fault {
        cause: "the highlight is not multiplied by specular",
        hint: None,
        versions: &[version!(|point, normal, eye, light| {
            lit((point, normal, eye, light), |right, _, halfway| Reflected {
                highlight: halfway.powf(light.shininess),
                ..right
            })
        })],
    },
    Fault {
        cause: "the highlight is dimmed by n · l as well: in this model it is not",
        hint: None,
        versions: &[version!(|point, normal, eye, light| {
            lit((point, normal, eye, light), |right, straight, _| Reflected {
                highlight: right.highlight * straight,
                ..right
            })
        })],
    },
    Fault {
        cause: "a light behind the surface takes light away: where n · l is below 0, no diffuse light is added",
        hint: Some(3),
        versions: &[
            version!(|point, normal, eye, light| {
                let [straight, halfway] = cosines(point, normal, eye, light);
                let highlight = light.specular * halfway.max(0.0).powf(light.shininess);
                Reflected { body: light.ambient + light.diffuse * straight, highlight }
            }),
            version!(|point, normal, eye, light| {
                let [straight, _] = cosines(point, normal, eye, light);
                let right = (RIGHT.blinn_phong)(point, normal, eye, light);
                Reflected { body: light.ambient + light.diffuse * straight, ..right }
            }),
        ],
    },
    Fault {
        cause: "a light behind the surface lights it as one in front does: a cosine below 0 counts as 0, not as its size",
        hint: Some(3),
        versions: &[
            version!(|point, normal, eye, light| {
                let [straight, halfway] = cosines(point, normal, eye, light);
                by_cosines(straight.abs(), halfway, light)
            }),
            version!(|point, normal, eye, light| {
                let [straight, halfway] = cosines(point, normal, eye, light);
                by_cosines(straight.abs(), halfway.abs(), light)
            }),
        ],
    },
    Fault {
        cause: "a light behind the surface makes a highlight: where n · l is not above 0, there is none",
        hint: Some(3),
        versions: &[version!(|point, normal, eye, light| {
            let [straight, halfway] = cosines(point, normal, eye, light);
            let highlight = light.specular * halfway.max(0.0).powf(light.shininess);
            Reflected { body: light.ambient + light.diffuse * straight.max(0.0), highlight }
        })],
    },
    Fault {
        cause: "the dark side is black: ambient light is seen there, too",
        hint: None,
        versions: &[version!(|point, normal, eye, light| {
            let [straight, _] = cosines(point, normal, eye, light);
            if straight <= 0.0 {
                return Reflected { body: 0.0, highlight: 0.0 };
            }
            (RIGHT.blinn_phong)(point, normal, eye, light)
        })],
    },
    Fault {
        cause: "a half-way vector behind the surface makes a highlight, or NaN: before the power, a cosine below 0 counts as 0",
        hint: Some(3),
        versions: &[
            version!(|point, normal, eye, light| {
                let [straight, halfway] = cosines(point, normal, eye, light);
                let right = by_cosines(straight, halfway, light);
                if straight <= 0.0 {
                    return right;
                }
                Reflected { highlight: light.specular * halfway.powf(light.shininess), ..right }
            }),
            version!(|point, normal, eye, light| {
                let [straight, halfway] = cosines(point, normal, eye, light);
                by_cosines(straight, halfway.abs(), light)
            }),
            // Clamped after the power.
            version!(|point, normal, eye, light| {
                let [straight, halfway] = cosines(point, normal, eye, light);
                let right = by_cosines(straight, halfway, light);
                if straight <= 0.0 {
                    return right;
                }
                Reflected { highlight: light.specular * halfway.powf(light.shininess).max(0.0), ..right }
            }),
        ],
    },
    Fault {
        cause: "the normal is not made 1 long: between corners it is shorter, and here it may have any length",
        hint: Some(1),
        versions: &[version!(|point, normal, eye, light| {
            by_directions(normal, unit(light.position - point), unit(eye - point), light)
        })],
    },
    Fault {
        cause: "a direction of length 0 makes NaN: normalize_or_zero() leaves it 0, normalize() divides by 0",
        hint: Some(1),
        versions: &[
            version!(|point, normal, eye, light| {
                let (n, l) = (normal.normalize(), (light.position - point).normalize());
                by_directions(n, l, (eye - point).normalize(), light)
            }),
            version!(|point, normal, eye, light| {
                by_directions(normal.normalize(), unit(light.position - point), unit(eye - point), light)
            }),
            version!(|point, normal, eye, light| {
                by_directions(unit(normal), (light.position - point).normalize(), unit(eye - point), light)
            }),
        ],
    },
];

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
        JUDGE.earns_nothing(&Lighting { blinn_phong: |_, _, _, _| Reflected { body: 0.0, highlight: 0.0 } });
    }

    /// Versions that are not those of the table, for what they share with one of them.
    #[test]
    fn each_fault_is_recognised() {
        let light = |blinn_phong, check, words| JUDGE.recognises(&Lighting { blinn_phong }, check, words);
        light(
            |point, normal, eye, light| {
                let l = (point - light.position).normalize_or_zero();
                let v = (eye - point).normalize_or_zero();
                let n = normal.normalize_or_zero();
                let diffuse = n.dot(l).max(0.0);
                let power = if diffuse > 0.0 { n.dot((l + v).normalize_or_zero()).max(0.0) } else { 0.0 };
                Reflected {
                    body: light.ambient + light.diffuse * diffuse,
                    highlight: light.specular * power.powf(light.shininess),
                }
            },
            "body",
            "from the light to the point",
        );
        light(
            |point, normal, eye, light| {
                let (n, l) = (normal.normalize_or_zero(), (light.position - point).normalize_or_zero());
                let r = n * (2.0 * n.dot(l)) - l;
                let shine = r.dot((eye - point).normalize_or_zero()).max(0.0).powf(light.shininess);
                let seen = n.dot(l) > 0.0;
                Reflected {
                    body: light.ambient + light.diffuse * n.dot(l).max(0.0),
                    highlight: if seen { light.specular * shine } else { 0.0 },
                }
            },
            "highlight",
            "Phong's highlight",
        );
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
