//! Tries what you wrote in `lib.rs`: `cargo run -p my-lighting`.

use std::process::ExitCode;

use lighting_tasks::{Lighting, MISSION};

fn main() -> ExitCode {
    MISSION.run(&Lighting { blinn_phong: my_lighting::blinn_phong }, cfg!(test))
}
