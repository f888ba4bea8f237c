//! Mission 6: smooth shading, judged.

mod faults;

use std::process::ExitCode;

use common::{Image, Vec3};
use gouraud_tasks::given::Scene;
use gouraud_tasks::{Drawn, Gouraud, MISSION};
use judge::Judge;

const JUDGE: Judge<Gouraud> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Gouraud = Gouraud { intensities: gouraud::intensities, gouraud };

fn gouraud(scene: &Scene, image: &mut Image, place: &dyn Fn(Vec3) -> Option<Vec3>) -> Drawn {
    let &Scene { model, normals, texture, light } = scene;
    let scene = gouraud::Scene { model, normals, texture, wrap: gouraud::Wrap::Clamp, light };
    let gouraud::Drawn { depths, left_out } = gouraud::gouraud(&scene, image, place);
    Drawn { depths, left_out }
}

fn main() -> ExitCode {
    JUDGE.run()
}
