//! Tries what you wrote in `lib.rs`: `cargo run -p my-perspective`.

use std::process::ExitCode;

use perspective_tasks::{MISSION, Perspective};

fn main() -> ExitCode {
    let student = Perspective {
        frustum: my_perspective::frustum,
        perspective_weights: my_perspective::perspective_weights,
    };
    MISSION.run(&student, cfg!(test))
}
