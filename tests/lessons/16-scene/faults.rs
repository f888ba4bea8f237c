//! Wrong versions of mission 16, by which the judge knows what was done.

use std::f32::consts::{PI, TAU};

use common::{Mat4, Vec2, Vec3};
use judge::Fault;
use scene_tasks::Scene;
use scene_tasks::given::{Shape, Vertex, rotate_x, rotate_y, translate};

use crate::RIGHT;

/// The right sphere, with each vertex changed.
macro_rules! vertices {
    (|$vertex:ident| $changed:expr) => {
        Scene {
            sphere: |latitudes, longitudes| {
                let mut shape = (RIGHT.sphere)(latitudes, longitudes);
                for place in &mut shape.vertices {
                    let $vertex = *place;
                    *place = $changed;
                }
                shape
            },
            ..RIGHT
        }
    };
}

/// Its vertices at another place, from θ and φ, and their normals with them.
macro_rules! places {
    (|$theta:ident, $phi:ident| $place:expr) => {
        Scene {
            sphere: |latitudes, longitudes| {
                rows(latitudes, longitudes, [1, 1], |i, j| {
                    let ($theta, $phi) = angles(i, j, [latitudes, longitudes]);
                    $place
                })
            },
            ..RIGHT
        }
    };
}

/// The right sphere, with other triangles: `first` and `last` tell whether the cell is at a pole, the four corners are those of
/// the cell, upper left, upper right, lower left, lower right.
macro_rules! cells {
    (|$first:ident, $last:ident, $ul:ident, $ur:ident, $ll:ident, $lr:ident| $triangles:expr) => {
        Scene {
            sphere: |latitudes, longitudes| {
                let begin = |i| begin(i, longitudes);
                with_cells(
                    [latitudes, longitudes],
                    longitudes,
                    begin,
                    |$first, $last, [$ul, $ur, $ll, $lr]| $triangles,
                )
            },
            ..RIGHT
        }
    };
}

/// Vertices as [`rows`] counts them: how many less are at a pole, how many more at the seam; and how many rows and columns the
/// angles are divided by.
macro_rules! grids {
    (|$latitudes:ident, $longitudes:ident| $counts:expr, $by:expr) => {
        Scene {
            sphere: |$latitudes, $longitudes| {
                rows($latitudes, $longitudes, $counts, |i, j| {
                    let (theta, phi) = angles(i, j, $by);
                    sphere_at(theta, phi)
                })
            },
            ..RIGHT
        }
    };
}

/// Another camera.
macro_rules! orbits {
    (|$azimuth:ident, $elevation:ident, $distance:ident| $camera:expr) => {
        Scene { orbit: |$azimuth, $elevation, $distance| $camera, ..RIGHT }
    };
}

/// Where a row begins.
fn begin(i: usize, longitudes: usize) -> usize {
    if i == 0 { 0 } else { longitudes + (i - 1) * (longitudes + 1) }
}

/// The triangles of a cell.
fn cell(first: bool, last: bool, [ul, ur, ll, lr]: [u32; 4]) -> Vec<[u32; 3]> {
    match (first, last) {
        (true, _) => vec![[ul, ll, lr]],
        (_, true) => vec![[ul, ll, ur]],
        _ => vec![[ul, ll, lr], [ul, lr, ur]],
    }
}

/// A sphere whose poles have so many vertices less than the other rows, and these one less than columns and one.
fn rows(
    latitudes: usize,
    longitudes: usize,
    [at_poles, seam]: [usize; 2],
    place: impl Fn(usize, usize) -> Vec3,
) -> Shape {
    let mut shape = Shape::default();
    let mut begins = Vec::new();
    for i in 0..=latitudes {
        let is_pole = i == 0 || i == latitudes;
        begins.push(shape.vertices.len());
        let count = longitudes + seam - if is_pole { at_poles } else { 0 };
        for j in 0..count {
            let half = if is_pole && at_poles > 0 { 0.5 } else { 0.0 };
            let uv = Vec2::new((j as f32 + half) / longitudes as f32, 1.0 - i as f32 / latitudes as f32);
            let position = place(i, j);
            shape.vertices.push(Vertex { position, normal: position, uv });
        }
    }
    for i in 0..latitudes {
        for j in 0..longitudes {
            let at = |i: usize, j: usize| {
                let is_pole = i == 0 || i == latitudes;
                let count = longitudes + seam - if is_pole { at_poles } else { 0 };
                (begins[i] + j % count) as u32
            };
            let corners = [at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)];
            shape.triangles.extend(cell(i == 0, i == latitudes - 1, corners));
        }
    }
    shape
}

/// The place at two angles.
fn sphere_at(theta: f32, phi: f32) -> Vec3 {
    Vec3::new(theta.sin() * phi.sin(), theta.cos(), theta.sin() * phi.cos())
}

/// θ and φ of a vertex, where a half turn has so many rows and a whole one so many columns.
fn angles(i: usize, j: usize, [latitudes, longitudes]: [usize; 2]) -> (f32, f32) {
    (PI * i as f32 / latitudes as f32, TAU * j as f32 / longitudes as f32)
}

/// Away from the origin.
fn away(distance: f32) -> Mat4 {
    translate(Vec3::new(0.0, 0.0, distance))
}

fn turn_x(degrees: f32) -> Mat4 {
    Mat4::from_mat3(rotate_x(degrees))
}

fn turn_y(degrees: f32) -> Mat4 {
    Mat4::from_mat3(rotate_y(degrees))
}

/// They are tried in this order.
pub(crate) const FAULTS: &[Fault<Scene>] = &[
    Fault {
        cause: "φ goes round half of the sphere: all the way round is 2π",
        hint: Some(1),
        versions: &[places!(|theta, phi| sphere_at(theta, phi / 2.0))],
    },
    Fault {
        cause: "θ goes round twice as far: from pole to pole it is π",
        hint: Some(1),
        versions: &[places!(|theta, phi| sphere_at(2.0 * theta, phi))],
    },
    Fault {
        cause: "θ is the angle from the equator here: it is counted from the north, where it is 0",
        hint: Some(1),
        versions: &[
            places!(|theta, phi| sphere_at(theta - PI / 2.0, phi)),
            places!(|theta, phi| sphere_at(PI / 2.0 - theta, phi)),
        ],
    },
    Fault {
        cause: "angles in degrees: sin() and cos() take radians",
        hint: Some(1),
        versions: &[places!(|theta, phi| sphere_at(theta.to_degrees(), phi.to_degrees()))],
    },
    Fault {
        cause: "the poles are on another axis: the north is (0, 1, 0)",
        hint: Some(1),
        versions: &[
            places!(|theta, phi| Vec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos())),
            places!(|theta, phi| Vec3::new(theta.sin() * phi.sin(), theta.sin() * phi.cos(), theta.cos())),
            places!(|theta, phi| Vec3::new(theta.cos(), theta.sin() * phi.sin(), theta.sin() * phi.cos())),
            places!(|theta, phi| Vec3::new(theta.cos(), theta.sin() * phi.cos(), theta.sin() * phi.sin())),
        ],
    },
    Fault {
        cause: "φ = 0 faces +x: it faces +z, so that z has the cosine and x the sine",
        hint: Some(1),
        versions: &[
            places!(|theta, phi| Vec3::new(theta.sin() * phi.cos(), theta.cos(), theta.sin() * phi.sin())),
            places!(|theta, phi| Vec3::new(theta.sin() * phi.cos(), theta.cos(), -theta.sin() * phi.sin())),
        ],
    },
    Fault {
        cause: "the columns run the other way: φ grows towards +x",
        hint: Some(1),
        versions: &[places!(|theta, phi| sphere_at(theta, -phi))],
    },
    Fault {
        cause: "the columns begin at the back: φ = 0 faces +z",
        hint: Some(1),
        versions: &[
            places!(|theta, phi| sphere_at(theta, phi + PI)),
            places!(|theta, phi| sphere_at(theta, PI - phi)),
        ],
    },
    Fault {
        cause: "the first row is the south pole: it is the north, (0, 1, 0)",
        hint: Some(1),
        versions: &[places!(|theta, phi| sphere_at(PI - theta, phi))],
    },
    Fault {
        cause: "the radius is not 1",
        hint: None,
        versions: &[
            places!(|theta, phi| sphere_at(theta, phi) / 2.0),
            places!(|theta, phi| sphere_at(theta, phi) * 2.0),
        ],
    },
    Fault {
        cause: "the rows are not rings: x and z are sin θ times the sine and the cosine of φ",
        hint: Some(1),
        versions: &[places!(|theta, phi| Vec3::new(phi.sin(), theta.cos(), phi.cos()))],
    },
    Fault {
        cause: "there is no vertex twice at the seam: a row has one more than there are columns, with u = 1",
        hint: Some(1),
        versions: &[
            grids!(|latitudes, longitudes| [0, 0], [latitudes, longitudes]),
            grids!(|latitudes, longitudes| [longitudes - 1, 0], [latitudes, longitudes]),
        ],
    },
    Fault {
        cause: "the number of vertices at a pole: one for each column, no more and no less",
        hint: Some(1),
        versions: &[
            grids!(|latitudes, longitudes| [0, 1], [latitudes, longitudes]),
            grids!(|latitudes, longitudes| [longitudes, 1], [latitudes, longitudes]),
        ],
    },
    Fault {
        cause: "an angle is divided by one too many or too few: row `latitudes` is at π, column `longitudes` at 2π",
        hint: Some(1),
        versions: &[
            grids!(|latitudes, longitudes| [1, 1], [latitudes + 1, longitudes]),
            grids!(|latitudes, longitudes| [1, 1], [latitudes, longitudes + 1]),
            grids!(|latitudes, longitudes| [1, 1], [latitudes, longitudes - 1]),
            grids!(|latitudes, longitudes| [1, 1], [latitudes - 1, longitudes]),
        ],
    },
    Fault {
        cause: "all triangles are clockwise: from outside, left comes before lower and lower before right",
        hint: Some(2),
        versions: &[cells!(|first, last, ul, ur, ll, lr| {
            let triangles = cell(first, last, [ul, ur, ll, lr]);
            triangles.into_iter().map(|[a, b, c]| [a, c, b]).collect()
        })],
    },
    Fault {
        cause: "of a column's two triangles one is clockwise: (upper left, lower left, lower right) and (upper left, lower right, \
                upper right)",
        hint: Some(2),
        versions: &[
            cells!(|first, last, ul, ur, ll, lr| match cell(first, last, [ul, ur, ll, lr])[..] {
                [a, _] => vec![a, [ul, ur, lr]],
                ref one => one.to_vec(),
            }),
            cells!(|first, last, ul, ur, ll, lr| match cell(first, last, [ul, ur, ll, lr])[..] {
                [_, b] => vec![[ul, lr, ll], b],
                ref one => one.to_vec(),
            }),
        ],
    },
    Fault {
        cause: "the triangles at a pole are clockwise",
        hint: Some(2),
        versions: &[
            cells!(|first, last, ul, ur, ll, lr| if first {
                vec![[ul, lr, ll]]
            } else {
                cell(first, last, [ul, ur, ll, lr])
            }),
            cells!(|first, last, ul, ur, ll, lr| if last {
                vec![[ul, ur, ll]]
            } else {
                cell(first, last, [ul, ur, ll, lr])
            }),
            cells!(|first, last, ul, ur, ll, lr| match (first, last) {
                (true, _) => vec![[ul, lr, ll]],
                (_, true) => vec![[ul, ur, ll]],
                _ => cell(first, last, [ul, ur, ll, lr]),
            }),
        ],
    },
    Fault {
        cause: "the other diagonal: both triangles of a column have its upper left and its lower right vertex",
        hint: Some(2),
        versions: &[cells!(|first, last, ul, ur, ll, lr| match (first, last) {
            (false, false) => vec![[ul, ll, ur], [ur, ll, lr]],
            _ => cell(first, last, [ul, ur, ll, lr]),
        })],
    },
    Fault {
        cause: "two triangles at a pole, one of them without area: there is one for each column",
        hint: Some(2),
        versions: &[cells!(|_first, _last, ul, ur, ll, lr| vec![[ul, ll, lr], [ul, lr, ur]])],
    },
    Fault {
        cause: "triangles are missing: at the poles, in the last column, or in the last row",
        hint: Some(2),
        versions: &[
            cells!(|first, last, ul, ur, ll, lr| match (first, last) {
                (false, false) => cell(first, last, [ul, ur, ll, lr]),
                _ => vec![],
            }),
            cells!(|first, last, ul, ur, ll, lr| if last {
                vec![]
            } else {
                cell(first, last, [ul, ur, ll, lr])
            }),
            cells!(|first, last, ul, ur, ll, lr| if first {
                vec![]
            } else {
                cell(first, last, [ul, ur, ll, lr])
            }),
            cells!(|first, last, ul, ur, ll, lr| match (first, last) {
                (false, false) => vec![[ul, ll, lr]],
                _ => cell(first, last, [ul, ur, ll, lr]),
            }),
            Scene {
                sphere: |latitudes, longitudes| {
                    let begin = |i| begin(i, longitudes);
                    with_cells([latitudes, longitudes], longitudes - 1, begin, cell)
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "a row begins elsewhere: the first row has `longitudes` vertices, each other row before the last one more",
        hint: Some(2),
        versions: &[
            Scene {
                sphere: |latitudes, longitudes| {
                    with_cells([latitudes, longitudes], longitudes, |i| i * (longitudes + 1), cell)
                },
                ..RIGHT
            },
            Scene {
                sphere: |latitudes, longitudes| {
                    with_cells([latitudes, longitudes], longitudes, |i| i * longitudes, cell)
                },
                ..RIGHT
            },
        ],
    },
    Fault {
        cause: "the last column leads back to the first vertex of its row: at the seam it ends at the second one that is there",
        hint: Some(2),
        versions: &[Scene {
            sphere: |latitudes, longitudes| {
                let mut shape = (RIGHT.sphere)(latitudes, longitudes);
                for vertex in shape.triangles.iter_mut().flatten() {
                    let seam =
                        (1..latitudes).find(|&i| begin(i, longitudes) + longitudes == *vertex as usize);
                    if let Some(i) = seam {
                        *vertex = begin(i, longitudes) as u32;
                    }
                }
                shape
            },
            ..RIGHT
        }],
    },
    Fault {
        cause: "normals point inwards: on a unit sphere about the origin the normal is the position",
        hint: Some(3),
        versions: &[vertices!(|vertex| Vertex { normal: -vertex.normal, ..vertex })],
    },
    Fault {
        cause: "normals are left out, or all alike: on a unit sphere about the origin the normal is the position",
        hint: Some(3),
        versions: &[
            vertices!(|vertex| Vertex { normal: Vec3::ZERO, ..vertex }),
            vertices!(|vertex| Vertex { normal: Vec3::Y, ..vertex }),
            vertices!(|vertex| Vertex { normal: Vec3::Z, ..vertex }),
        ],
    },
    Fault {
        cause: "v is upside down: it is 1 in the north and 0 in the south",
        hint: Some(3),
        versions: &[vertices!(|vertex| Vertex { uv: Vec2::new(vertex.uv.x, 1.0 - vertex.uv.y), ..vertex })],
    },
    Fault {
        cause: "u runs from right to left",
        hint: Some(3),
        versions: &[vertices!(|vertex| Vertex { uv: Vec2::new(1.0 - vertex.uv.x, vertex.uv.y), ..vertex })],
    },
    Fault {
        cause: "u and v are exchanged: u goes round, v from pole to pole",
        hint: Some(3),
        versions: &[
            vertices!(|vertex| Vertex { uv: Vec2::new(vertex.uv.y, vertex.uv.x), ..vertex }),
            vertices!(|vertex| Vertex { uv: Vec2::new(1.0 - vertex.uv.y, vertex.uv.x), ..vertex }),
        ],
    },
    Fault {
        cause: "at the poles u is that of the column's left side: it is that of its middle, (j + ½)/longitudes",
        hint: Some(3),
        versions: &[
            Scene { sphere: |latitudes, longitudes| moved_poles(latitudes, longitudes, -0.5), ..RIGHT },
            Scene { sphere: |latitudes, longitudes| moved_poles(latitudes, longitudes, 0.5), ..RIGHT },
        ],
    },
    Fault {
        cause: "texture coordinates are left out",
        hint: Some(3),
        versions: &[vertices!(|vertex| Vertex { uv: Vec2::ZERO, ..vertex })],
    },
    Fault {
        cause: "the camera goes down where it should go up: a turn about x from y to z takes what is at +z down",
        hint: Some(4),
        versions: &[orbits!(|azimuth, elevation, distance| turn_y(azimuth)
            * turn_x(elevation)
            * away(distance))],
    },
    Fault {
        cause: "the camera goes to the left where it should go to the right",
        hint: Some(4),
        versions: &[orbits!(|azimuth, elevation, distance| turn_y(-azimuth)
            * turn_x(-elevation)
            * away(distance))],
    },
    Fault {
        cause: "both turns are the wrong way round",
        hint: Some(4),
        versions: &[orbits!(|azimuth, elevation, distance| turn_y(-azimuth)
            * turn_x(elevation)
            * away(distance))],
    },
    Fault {
        cause: "the turns are in the wrong order: first up, by a turn about x, then round, by one about y",
        hint: Some(4),
        versions: &[
            orbits!(|azimuth, elevation, distance| turn_x(-elevation) * turn_y(azimuth) * away(distance)),
            orbits!(|azimuth, elevation, distance| turn_x(elevation) * turn_y(azimuth) * away(distance)),
        ],
    },
    Fault {
        cause: "the camera turns about itself: it is moved away from the origin first, so that the turns move it, too",
        hint: Some(4),
        versions: &[
            orbits!(|azimuth, elevation, distance| away(distance) * turn_y(azimuth) * turn_x(-elevation)),
            orbits!(|azimuth, elevation, distance| away(distance) * turn_y(azimuth) * turn_x(elevation)),
        ],
    },
    Fault {
        cause: "this is the way from the world to the eye, the inverse of what is asked for: where the camera stands",
        hint: Some(4),
        versions: &[orbits!(|azimuth, elevation, distance| away(-distance)
            * turn_x(elevation)
            * turn_y(-azimuth))],
    },
    Fault {
        cause: "the camera stands at −z with its back to the origin: it looks along −z, so it stands at +z",
        hint: Some(4),
        versions: &[orbits!(|azimuth, elevation, distance| turn_y(azimuth)
            * turn_x(-elevation)
            * away(-distance))],
    },
    Fault {
        cause: "radians: rotate_x and rotate_y take degrees, as they come",
        hint: Some(4),
        versions: &[
            orbits!(|azimuth, elevation, distance| turn_y(azimuth.to_radians())
                * turn_x(-elevation.to_radians())
                * away(distance)),
            orbits!(|azimuth, elevation, distance| turn_y(azimuth.to_degrees())
                * turn_x(-elevation.to_degrees())
                * away(distance)),
        ],
    },
    Fault {
        cause: "azimuth and elevation are exchanged: azimuth turns about y, elevation about x",
        hint: Some(4),
        versions: &[
            orbits!(|azimuth, elevation, distance| turn_y(elevation) * turn_x(-azimuth) * away(distance)),
            orbits!(|azimuth, elevation, distance| turn_x(-azimuth) * turn_y(elevation) * away(distance)),
            orbits!(|azimuth, elevation, distance| turn_y(elevation) * turn_x(azimuth) * away(distance)),
        ],
    },
    Fault {
        cause: "only one of the turns is made",
        hint: Some(4),
        versions: &[
            orbits!(|azimuth, _elevation, distance| turn_y(azimuth) * away(distance)),
            orbits!(|_azimuth, elevation, distance| turn_x(-elevation) * away(distance)),
        ],
    },
    Fault {
        cause: "the distance is left out: the camera stands at the origin",
        hint: Some(4),
        versions: &[orbits!(|azimuth, elevation, _distance| turn_y(azimuth) * turn_x(-elevation))],
    },
];

/// The right sphere's vertices, with other triangles: in so many columns, where row i is taken to begin at `begin(i)`, and each cell
/// has `triangles(at the north pole, at the south pole, its corners)`.
fn with_cells(
    [latitudes, longitudes]: [usize; 2],
    columns: usize,
    begin: impl Fn(usize) -> usize,
    triangles: impl Fn(bool, bool, [u32; 4]) -> Vec<[u32; 3]>,
) -> Shape {
    let mut shape = (RIGHT.sphere)(latitudes, longitudes);
    shape.triangles.clear();
    for i in 0..latitudes {
        for j in 0..columns {
            let [ul, ll] = [i, i + 1].map(|i| (begin(i) + j) as u32);
            shape.triangles.extend(triangles(i == 0, i == latitudes - 1, [ul, ul + 1, ll, ll + 1]));
        }
    }
    shape
}

/// The right sphere, with u at the poles off by so many columns.
fn moved_poles(latitudes: usize, longitudes: usize, columns: f32) -> Shape {
    let mut shape = (RIGHT.sphere)(latitudes, longitudes);
    let last = shape.vertices.len() - longitudes;
    for n in (0..longitudes).chain(last..last + longitudes) {
        shape.vertices[n].uv.x += columns / longitudes as f32;
    }
    shape
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
        JUDGE.earns_nothing(&Scene {
            sphere: |_, _| Shape { vertices: Vec::new(), triangles: Vec::new() },
            orbit: |_, _, _| Mat4::IDENTITY,
        });
    }

    /// Versions that are not those of the table, for what they share with one of them.
    #[test]
    fn each_fault_is_recognised() {
        let orbit = |orbit, words| JUDGE.recognises(&Scene { orbit, ..RIGHT }, "orbit", words);
        orbit(
            |azimuth, elevation, distance| {
                let (sin, cos) = elevation.to_radians().sin_cos();
                let eye = Vec3::new(0.0, -sin, cos) * distance;
                let z = eye / distance;
                let camera = Mat4::from_cols(
                    Vec3::X.extend(0.0),
                    z.cross(Vec3::X).extend(0.0),
                    z.extend(0.0),
                    eye.extend(1.0),
                );
                turn_y(azimuth) * camera
            },
            "goes down where it should go up",
        );
        orbit(
            |azimuth, elevation, distance| (RIGHT.orbit)(azimuth, elevation, distance).inverse(),
            "the inverse of what is asked for",
        );
        let sphere = |sphere, check, words| JUDGE.recognises(&Scene { sphere, ..RIGHT }, check, words);
        sphere(
            |latitudes, longitudes| {
                let mut shape = (RIGHT.sphere)(latitudes, longitudes);
                shape.triangles.iter_mut().for_each(|triangle| triangle.reverse());
                shape
            },
            "winding",
            "all triangles are clockwise",
        );
        sphere(
            |latitudes, longitudes| {
                let mut shape = (RIGHT.sphere)(latitudes, longitudes);
                for vertex in &mut shape.vertices {
                    vertex.position = Vec3::new(vertex.position.z, vertex.position.y, vertex.position.x);
                }
                shape
            },
            "positions",
            "φ = 0 faces +x",
        );
    }

    #[test]
    fn each_is_named_by_what_it_does() {
        JUDGE.check_faults();
    }
}
