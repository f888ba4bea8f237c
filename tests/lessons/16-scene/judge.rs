//! Mission 16: a sphere of triangles and a camera on an orbit, judged.

mod faults;

use std::process::ExitCode;

use judge::Judge;
use scene_tasks::given::{Shape, Vertex};
use scene_tasks::{MISSION, Scene};

const JUDGE: Judge<Scene> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Scene = Scene { sphere, orbit: scene::orbit };

fn sphere(latitudes: usize, longitudes: usize) -> Shape {
    let scene::Shape { vertices, triangles } = scene::sphere(latitudes, longitudes);
    let given = |scene::Vertex { position, normal, uv }| Vertex { position, normal, uv };
    Shape { vertices: vertices.into_iter().map(given).collect(), triangles }
}

fn main() -> ExitCode {
    JUDGE.run()
}
