//! A fine mesh of the surface on which a field is 0: surface nets, then Newton's method.
//!
//! Gibson, "Constrained Elastic Surface Nets" (1998): a vertex in every cell of a grid whose corners are on both
//! sides, and a quadrilateral around every edge of the grid with one end inside and one outside.

use glam::{DVec3, IVec3, Vec3Swizzles};

use super::shape::{BASE, body, head};

/// Side of a cell, in head heights: the lids' edges are some 0.01 thick.
const CELL: f64 = 0.008;
/// Cells along x, y and z: whole blocks.
const CELLS: IVec3 = IVec3::new(208, 192, 144);
/// Side of a block, in cells. A block far from the surface is not looked into.
const BLOCK: i32 = 4;
/// Lower corner of the grid: x = 0 is in its middle, and the base lies in the middle of a layer of cells.
const CORNER: DVec3 = DVec3::new(-0.5 * CELL * CELLS.x as f64, BASE - 1.5 * CELL, -0.5);

/// What a vertex may do without leaving the plane that cuts the bust off.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// On the body, above the base.
    Body,
    /// On the base, inside its rim.
    Base,
    /// On the rim.
    Rim,
}

/// A closed mesh of bare triangles.
#[derive(Clone, Debug, Default)]
pub struct Surface {
    /// Vertices, in head heights.
    pub positions: Vec<DVec3>,
    /// Where each of them is.
    pub places: Vec<Place>,
    /// Indices of vertices, counterclockwise from outside.
    pub triangles: Vec<[usize; 3]>,
}

/// The surface of [`head`].
#[must_use]
pub fn surface() -> Surface {
    let grid = Grid::new();
    let mut mesh = Surface::default();
    let mut vertex = vec![usize::MAX; grid.values.len()];
    for cell in cells(IVec3::ZERO) {
        if let Some((position, place)) = grid.vertex(cell) {
            vertex[index(cell)] = mesh.positions.len();
            mesh.positions.push(position);
            mesh.places.push(place);
        }
    }
    for axis in [IVec3::X, IVec3::Y, IVec3::Z] {
        // The other two axes, in an order that makes a right-handed frame with this one.
        let (u, v) = (axis.zxy(), axis.yzx());
        for corner in cells(u + v) {
            let (from, to) = (grid.value(corner), grid.value(corner + axis));
            if (from < 0.0) == (to < 0.0) {
                continue;
            }
            let mut quad = [-u - v, -v, IVec3::ZERO, -u].map(|back| vertex[index(corner + back)]);
            if from > 0.0 {
                quad.reverse();
            }
            let [a, b, c, d] = quad;
            let length = |i: usize, j: usize| mesh.positions[i].distance_squared(mesh.positions[j]);
            mesh.triangles.extend(if length(a, c) <= length(b, d) {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            });
        }
    }
    mesh
}

/// The direction in which [`body`] grows, and how fast: its gradient by central differences.
#[must_use]
pub fn gradient(p: DVec3) -> DVec3 {
    const STEP: f64 = 2e-4;
    let slope = |axis: DVec3| (body(p + axis * STEP) - body(p - axis * STEP)) / (2.0 * STEP);
    DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z))
}

/// A point near the surface brought closer to it by one of Newton's steps, as far as its place lets it move.
#[must_use]
pub fn settle(mut p: DVec3, place: Place) -> DVec3 {
    if place != Place::Body {
        p.y = BASE;
    }
    if place == Place::Base {
        return p;
    }
    let mut slope = gradient(p);
    if place == Place::Rim {
        slope.y = 0.0;
    }
    // Newton's step along the gradient, no longer than a cell where the gradient almost vanishes.
    p - (slope * body(p) / slope.length_squared().max(0.05)).clamp_length_max(CELL)
}

/// The field at the corners of the cells.
struct Grid {
    /// Far from the surface only the sign counts.
    values: Vec<f64>,
}

impl Grid {
    fn new() -> Self {
        let mut grid = Self { values: vec![1.0; ((CELLS.x + 1) * (CELLS.y + 1) * (CELLS.z + 1)) as usize] };
        // Half a block's diagonal, and a half of that again, since the field is but a bound.
        let reach = f64::from(BLOCK) * CELL * 0.87 * 1.5;
        // The field is symmetric: its left half is enough.
        let half = IVec3::new(CELLS.x / 2, 0, 0);
        for block in boxes(half / BLOCK, CELLS / BLOCK) {
            let corner = block * BLOCK;
            let middle = head(point(corner) + 0.5 * CELL * f64::from(BLOCK));
            for p in boxes(corner, corner + BLOCK + 1) {
                let value = if middle.abs() > reach { middle } else { head(point(p)) };
                for p in [p, IVec3::new(CELLS.x - p.x, p.y, p.z)] {
                    let at = index(p);
                    grid.values[at] = value;
                }
            }
        }
        while grid.fill_ambiguous() {}
        grid
    }

    /// Where two bodies touch at an edge or a corner of the grid the surface would not be a manifold: a corner
    /// more becomes inside. Returns whether there was such a place. Latecki, Eckhardt and Rosenfeld,
    /// "Well-Composed Sets" (1995).
    fn fill_ambiguous(&mut self) -> bool {
        let mut found = false;
        for cell in cells(IVec3::ZERO) {
            let corners: [IVec3; 8] =
                std::array::from_fn(|n| cell + IVec3::new(n as i32 & 1, n as i32 >> 1 & 1, n as i32 >> 2));
            let inside = corners.map(|p| self.value(p) < 0.0);
            if inside == [inside[0]; 8] {
                continue;
            }
            // Each face of the cell by two neighbours of a corner of it; then the cell's four diagonals.
            let face = |n: usize, a: usize, b: usize| {
                let [p, q, r, s] = [n, n ^ a, n ^ a ^ b, n ^ b].map(|n| inside[n]);
                p == r && q == s && p != q
            };
            let faces = [(0, 1, 2), (7, 1, 2), (0, 2, 4), (7, 2, 4), (0, 4, 1), (7, 4, 1)];
            let across = |&(n, a, b): &(usize, usize, usize)| face(n, a, b);
            let alone = |n: usize| (0..8).all(|m| (inside[m] == inside[n]) == (m == n || m == 7 - n));
            let fill = if let Some((n, a, _)) = faces.into_iter().find(across) {
                if inside[n] { n ^ a } else { n }
            } else if let Some(n) = (0..4).find(|&n| alone(n)) {
                if inside[n] { n ^ 1 } else { n }
            } else {
                continue;
            };
            let at = index(corners[fill]);
            self.values[at] = -1e-6;
            found = true;
        }
        found
    }

    fn value(&self, p: IVec3) -> f64 {
        self.values[index(p)]
    }

    /// The middle of the points at which the cell's edges cross the surface, settled.
    fn vertex(&self, cell: IVec3) -> Option<(DVec3, Place)> {
        let (mut sum, mut on_base, mut on_body) = (DVec3::ZERO, 0, 0);
        for axis in [IVec3::X, IVec3::Y, IVec3::Z] {
            for side in [IVec3::ZERO, axis.yzx(), axis.zxy(), axis.yzx() + axis.zxy()] {
                let (a, b) = (cell + side, cell + side + axis);
                let (from, to) = (self.value(a), self.value(b));
                if (from < 0.0) != (to < 0.0) {
                    let crossing = point(a).lerp(point(b), from / (from - to));
                    sum += crossing;
                    let low = crossing.y < BASE + CELL;
                    if low && BASE - crossing.y > body(crossing) { on_base += 1 } else { on_body += 1 }
                }
            }
        }
        let place = match (on_base, on_body) {
            (0, 0) => return None,
            (0, _) => Place::Body,
            (_, 0) => Place::Base,
            _ => Place::Rim,
        };
        Some((settle(sum / f64::from(on_base + on_body), place), place))
    }
}

/// Where a corner's value is in the list.
fn index(p: IVec3) -> usize {
    ((p.x * (CELLS.y + 1) + p.y) * (CELLS.z + 1) + p.z) as usize
}

/// The cells, from this one on.
fn cells(first: IVec3) -> impl Iterator<Item = IVec3> {
    boxes(first, CELLS)
}

/// A corner in space.
fn point(p: IVec3) -> DVec3 {
    CORNER + p.as_dvec3() * CELL
}

/// The whole-numbered points from `first` up to, but without, `end`.
fn boxes(first: IVec3, end: IVec3) -> impl Iterator<Item = IVec3> {
    (first.x..end.x).flat_map(move |x| {
        (first.y..end.y).flat_map(move |y| (first.z..end.z).map(move |z| IVec3::new(x, y, z)))
    })
}
