//! Fewer triangles: edges are collapsed where that changes the shape least.
//!
//! Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics" (1997). A vertex carries the
//! quadric of the planes it stands for; an edge becomes the point at which the sum of its two quadrics is least.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use glam::{DMat3, DVec3};

use super::shape::BASE;
use super::surface::{Place, Surface};

/// The sum of squared distances from planes, as pᵀ·a·p + 2·b·p + c.
#[derive(Clone, Copy)]
struct Quadric {
    a: DMat3,
    b: DVec3,
    c: f64,
}

impl Quadric {
    const ZERO: Self = Self { a: DMat3::ZERO, b: DVec3::ZERO, c: 0.0 };

    /// The plane through a triangle, as heavy as its area times a weight.
    fn of([p, q, r]: [DVec3; 3], weight: f64) -> Self {
        let cross = (q - p).cross(r - p);
        let normal = cross.normalize_or_zero();
        let (heavy, offset) = (cross.length() * weight, -normal.dot(p));
        let a = DMat3::from_cols(normal * normal.x, normal * normal.y, normal * normal.z) * heavy;
        Self { a, b: normal * (offset * heavy), c: offset * offset * heavy }
    }

    fn plus(self, other: Self) -> Self {
        Self { a: self.a + other.a, b: self.b + other.b, c: self.c + other.c }
    }

    fn error(&self, p: DVec3) -> f64 {
        p.dot(self.a * p) + 2.0 * self.b.dot(p) + self.c
    }

    /// The point of least error, if the planes fix one well enough.
    fn best(&self) -> Option<DVec3> {
        let size = (self.a.x_axis.x + self.a.y_axis.y + self.a.z_axis.z) / 3.0;
        let determinant = self.a.determinant();
        (determinant > 1e-4 * size * size * size).then(|| self.a.inverse() * -self.b)
    }
}

/// An edge that may be collapsed.
struct Candidate {
    cost: f64,
    ends: [usize; 2],
    /// How often each end had moved when this was computed.
    moves: [u32; 2],
    to: DVec3,
}

/// The cheapest comes first; of equal ones, that of the lowest indices.
impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        other
            .cost
            .total_cmp(&self.cost)
            .then_with(|| other.ends.cmp(&self.ends))
            .then_with(|| other.moves.cmp(&self.moves))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}

/// The mesh with at most so many triangles, as long as edges are left that can be collapsed. `weight` says how
/// much an error counts at a point.
#[must_use]
pub fn decimate(mesh: Surface, limit: usize, weight: impl Fn(DVec3) -> f64) -> Surface {
    let mut work = Work::new(mesh, weight);
    while work.left > limit {
        let Some(candidate) = work.heap.pop() else { break };
        let [a, b] = candidate.ends;
        if candidate.moves == [work.moves[a], work.moves[b]] && work.allowed(&candidate) {
            work.collapse(&candidate);
        }
    }
    work.finish()
}

struct Work<W> {
    mesh: Surface,
    quadrics: Vec<Quadric>,
    /// The triangles around each vertex; none around one that is gone.
    around: Vec<Vec<usize>>,
    moves: Vec<u32>,
    heap: BinaryHeap<Candidate>,
    /// How many triangles are left.
    left: usize,
    weight: W,
}

impl<W: Fn(DVec3) -> f64> Work<W> {
    fn new(mesh: Surface, weight: W) -> Self {
        let count = mesh.positions.len();
        let mut work = Self {
            quadrics: vec![Quadric::ZERO; count],
            around: vec![Vec::new(); count],
            moves: vec![0; count],
            heap: BinaryHeap::new(),
            left: mesh.triangles.len(),
            weight,
            mesh,
        };
        for (n, &triangle) in work.mesh.triangles.iter().enumerate() {
            let corners = triangle.map(|i| work.mesh.positions[i]);
            let quadric = Quadric::of(corners, (work.weight)((corners[0] + corners[1] + corners[2]) / 3.0));
            for i in triangle {
                work.around[i].push(n);
                work.quadrics[i] = work.quadrics[i].plus(quadric);
            }
        }
        for n in 0..work.left {
            let [a, b, c] = work.mesh.triangles[n];
            // Every edge is in two triangles, once in each direction.
            for [from, to] in [[a, b], [b, c], [c, a]] {
                if from < to {
                    work.offer(from, to);
                }
            }
        }
        work
    }

    /// Puts an edge among the candidates.
    fn offer(&mut self, a: usize, b: usize) {
        let ends = [a.min(b), a.max(b)];
        let [p, q] = ends.map(|i| self.mesh.positions[i]);
        let [first, second] = ends.map(|i| self.mesh.places[i]);
        let quadric = self.quadrics[a].plus(self.quadrics[b]);
        let middle = (p + q) / 2.0;
        let near = |best: &DVec3| best.distance_squared(middle) < p.distance_squared(q);
        // A vertex on the rim stays on it, whatever it is joined with.
        let to = match first.cmp(&second) {
            Ordering::Greater => p,
            Ordering::Less => q,
            Ordering::Equal => {
                let to = quadric.best().filter(near).unwrap_or(middle);
                if first == Place::Body { to } else { DVec3::new(to.x, BASE, to.z) }
            }
        };
        // Where all is flat, short edges go first; before all, triangles of the base that rounding turned over.
        let spoilt =
            |&n: &usize| self.mesh.triangles[n].contains(&b) && self.turned_over(self.mesh.triangles[n]);
        let error = if self.around[a].iter().any(spoilt) { -1.0 } else { quadric.error(to).max(0.0) };
        let cost = error + 1e-9 * (self.weight)(middle) * p.distance_squared(q);
        self.heap.push(Candidate { cost, ends, moves: ends.map(|i| self.moves[i]), to });
    }

    /// Whether a triangle of the base, which faces downwards, faces up or is a sliver.
    fn turned_over(&self, triangle: [usize; 3]) -> bool {
        let [p, q, r] = triangle.map(|i| self.mesh.positions[i]);
        let on_base = triangle.iter().all(|&i| self.mesh.places[i] != Place::Body);
        on_base && (q - p).cross(r - p).y > -0.02 * p.distance_squared(q).max(p.distance_squared(r))
    }

    fn neighbours(&self, vertex: usize) -> Vec<usize> {
        let corners = self.around[vertex].iter().flat_map(|&n| self.mesh.triangles[n]);
        let mut neighbours: Vec<usize> = corners.filter(|&i| i != vertex).collect();
        neighbours.sort_unstable();
        neighbours.dedup();
        neighbours
    }

    /// Whether the mesh stays a closed surface with its rim, and no triangle turns over or becomes a sliver.
    fn allowed(&self, Candidate { ends: [a, b], to, .. }: &Candidate) -> bool {
        // The link condition: two vertices and no more are neighbours of both ends.
        let [of_a, of_b] = [*a, *b].map(|i| self.neighbours(i));
        let shared: Vec<usize> = of_a.iter().copied().filter(|i| of_b.contains(i)).collect();
        if shared.len() != 2 || shared.iter().any(|&i| self.around[i].len() == 3) {
            return false;
        }
        // Two vertices of the rim may be joined along it only: one neighbour on the base, one above.
        let places = &self.mesh.places;
        if places[*a] == Place::Rim && places[*b] == Place::Rim {
            let on_base = |i: &&usize| places[**i] != Place::Body;
            if shared.iter().filter(on_base).count() != 1 {
                return false;
            }
        }
        let rim = self.mesh.places[*a].max(self.mesh.places[*b]) == Place::Rim;
        let stays = |&n: &usize| {
            let triangle = self.mesh.triangles[n];
            if triangle.contains(a) && triangle.contains(b) || self.turned_over(triangle) {
                return true;
            }
            let on_rim = |&i: &usize| self.mesh.places[i] == Place::Rim || ((i == *a || i == *b) && rim);
            if triangle.iter().all(on_rim) {
                return false;
            }
            let before = triangle.map(|i| self.mesh.positions[i]);
            let after = triangle.map(|i| if i == *a || i == *b { *to } else { self.mesh.positions[i] });
            let area = |[p, q, r]: [DVec3; 3]| (q - p).cross(r - p);
            let [p, q, r] = after;
            let longest = p.distance_squared(q).max(q.distance_squared(r)).max(r.distance_squared(p));
            let (old, new) = (area(before), area(after));
            new.dot(old) > 0.3 * new.length() * old.length() && new.length() > 0.08 * longest
        };
        self.around[*a].iter().chain(&self.around[*b]).all(stays)
    }

    fn collapse(&mut self, candidate: &Candidate) {
        let [a, b] = candidate.ends;
        self.mesh.positions[a] = candidate.to;
        self.mesh.places[a] = self.mesh.places[a].max(self.mesh.places[b]);
        self.quadrics[a] = self.quadrics[a].plus(self.quadrics[b]);
        self.moves[a] += 1;
        self.moves[b] += 1;
        for n in std::mem::take(&mut self.around[b]) {
            if self.mesh.triangles[n].contains(&a) {
                for i in self.mesh.triangles[n] {
                    self.around[i].retain(|&m| m != n);
                }
                self.left -= 1;
            } else {
                self.mesh.triangles[n] = self.mesh.triangles[n].map(|i| if i == b { a } else { i });
                self.around[a].push(n);
            }
        }
        for neighbour in self.neighbours(a) {
            self.offer(a, neighbour);
        }
    }

    /// What is left, numbered anew in the old order.
    fn finish(self) -> Surface {
        let mut mesh = Surface::default();
        let mut number = vec![usize::MAX; self.around.len()];
        for i in (0..number.len()).filter(|&i| !self.around[i].is_empty()) {
            number[i] = mesh.positions.len();
            mesh.positions.push(self.mesh.positions[i]);
            mesh.places.push(self.mesh.places[i]);
        }
        let alive = |n: &usize| self.around[self.mesh.triangles[*n][0]].contains(n);
        let triangles = (0..self.mesh.triangles.len()).filter(alive);
        mesh.triangles = triangles.map(|n| self.mesh.triangles[n].map(|i| number[i])).collect();
        mesh
    }
}
