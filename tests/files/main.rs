//! Bad files and bad places, as a user meets them: one line that says what is wrong, exit code 1, nothing lost and
//! nothing half-written. What is shown in a terminal. And the assets, made again.

mod assets;
mod formats;
mod fuzz;
mod models;
mod pictures;
#[cfg(target_os = "linux")]
mod terminals;

use verify::names;
use verify::usage::assert_fails;
