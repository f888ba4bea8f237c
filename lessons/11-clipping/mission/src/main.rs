//! Tries what you wrote in `lib.rs`: `cargo run -p my-clipping`.

use std::process::ExitCode;

use clipping_tasks::{Clipping, MISSION};

fn main() -> ExitCode {
    let student = Clipping { facing: my_clipping::facing, clip: my_clipping::clip };
    MISSION.run(&student, cfg!(test))
}
