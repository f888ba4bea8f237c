//! A flag of the programs that leave out triangles for the side that they show, this lesson's and later ones.

use crate::facing::Cull;

/// `--cull`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct CullFlag {
    /// Which triangles are left out: those that show their back, those that show their front, or none
    #[arg(
        id = "cull",
        long = "cull",
        value_name = "back|front|none",
        value_enum,
        hide_possible_values = true,
        default_value = "back"
    )]
    pub which: Cull,
}
