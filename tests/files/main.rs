//! Bad files and bad places, as a user meets them: one line that says what is wrong, exit code 1, nothing lost and
//! nothing half-written. And the assets, made again.

mod assets;
mod formats;
mod fuzz;
mod models;
mod pictures;

use verify::names;
use verify::usage::assert_fails;
