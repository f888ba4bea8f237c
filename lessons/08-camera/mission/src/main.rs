//! Tries what you wrote in `lib.rs`: `cargo run -p my-camera`.

use std::process::ExitCode;

use camera_tasks::{Camera, MISSION};

fn main() -> ExitCode {
    let student = Camera { basis: my_camera::basis, lookat: my_camera::lookat };
    MISSION.run(&student, cfg!(test))
}
