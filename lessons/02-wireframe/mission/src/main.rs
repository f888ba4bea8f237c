//! Tries what you wrote in `lib.rs`: `cargo run -p my-wireframe`.

use std::process::ExitCode;

use wireframe_tasks::{MISSION, Wireframe};

fn main() -> ExitCode {
    let student = Wireframe { wireframe: my_wireframe::wireframe, to_pixel: my_wireframe::to_pixel };
    MISSION.run(&student, cfg!(test))
}
