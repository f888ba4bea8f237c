//! The window.

use crate::simulation::Simulation;

/// Shows a simulation.
///
/// # Errors
/// Where there is no display.
pub fn run(_: Simulation, _: (u16, u16)) -> anyhow::Result<()> {
    anyhow::bail!("there is no display to open a window on; --out FILE draws into a file")
}
