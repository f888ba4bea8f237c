//! A walk around the model: the eye on a circle, a picture at each stop.

use std::f32::consts::TAU;

use anyhow::Context;
use common::Vec3;
use common::direction::unit;
use common::program::{Drawing, Flags, write_pictures};
use indicatif::{ProgressBar, ProgressStyle};
use transforms::rotation::rodrigues;

// ANCHOR: turned
/// Where the eye is after a share of a full turn, to the right, about the centre.
#[must_use]
pub fn turned(eye: Vec3, center: Vec3, up: Vec3, share: f32) -> Vec3 {
    let axis = unit(up).unwrap_or(Vec3::Y);
    center + rodrigues(axis, share * TAU) * (eye - center)
}
// ANCHOR_END: turned

/// Draws the pictures that `--turntable` asks for and writes them as NAME-000, NAME-001 and so on.
///
/// # Errors
/// As drawing and writing one.
pub fn run(
    flags: &Flags,
    name: &str,
    draw: &dyn Fn(&Flags) -> anyhow::Result<Drawing>,
) -> anyhow::Result<()> {
    let count = flags.turntable.context("without --turntable there is nothing to turn")?;
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {eta}")?;
    let bar = ProgressBar::new(u64::from(count)).with_style(style);
    for n in 0..count {
        let eye = turned(flags.eye, flags.center, flags.up, f32::from(n) / f32::from(count));
        let drawing = draw(&Flags { eye, ..flags.clone() })?;
        write_pictures(&drawing.picture, flags.out.as_deref(), name, Some(n))?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    common::program::print(&format!("{count} pictures\n"))
}
