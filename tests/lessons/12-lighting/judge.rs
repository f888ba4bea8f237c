//! Mission 12: what a surface reflects of a point light, judged.

mod faults;

use std::process::ExitCode;

use common::Vec3;
use judge::Judge;
use lighting::{Falloff, PointLight};
use lighting_tasks::{Lighting, MISSION, given};

const JUDGE: Judge<Lighting> = Judge { mission: MISSION, reference: RIGHT, faults: faults::FAULTS };

/// The lesson's own.
const RIGHT: Lighting = Lighting { blinn_phong };

/// The lesson's function, for the mission's light.
fn blinn_phong(point: Vec3, normal: Vec3, eye: Vec3, light: &given::PointLight) -> given::Reflected {
    let &given::PointLight { position, ambient, diffuse, specular, shininess } = light;
    let light = PointLight { position, ambient, diffuse, specular, shininess, falloff: Falloff::None };
    let lighting::Reflected { body, highlight } = lighting::blinn_phong(point, normal, eye, &light);
    given::Reflected { body, highlight }
}

fn main() -> ExitCode {
    JUDGE.run()
}
