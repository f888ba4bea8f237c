//! The missions: the starters and their solutions, in a copy of the workspace.

mod workspace;
