//! The figures of the pages that are no lesson's.

pub(crate) mod front;
pub(crate) mod wrong;
