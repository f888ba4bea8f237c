//! Tries what you wrote in `lib.rs`: `cargo run -p my-scene`.

use std::process::ExitCode;

use scene_tasks::{MISSION, Scene};

fn main() -> ExitCode {
    let student = Scene { sphere: my_scene::sphere, orbit: my_scene::orbit };
    MISSION.run(&student, cfg!(test))
}
