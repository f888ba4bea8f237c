//! Version 11: the course's own scene.

use crate::versions::Version;

/// The version that is drawn unless another one is asked for.
pub const VERSION: Version = Version { number: 11, what: "the course's own scene", ..crate::versions::LAST };
