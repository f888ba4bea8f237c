//! Tries what you wrote in `lib.rs`: `cargo run -p my-transforms`.

use std::process::ExitCode;

use transforms_tasks::{MISSION, Transforms};

fn main() -> ExitCode {
    let student = Transforms {
        viewport: my_transforms::viewport,
        projection: my_transforms::projection,
        place: my_transforms::place,
    };
    MISSION.run(&student, cfg!(test))
}
