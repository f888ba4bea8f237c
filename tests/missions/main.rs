//! The missions: known faults, put into the lessons' own functions, are recognised; and the starters and their
//! solutions, in a copy of the workspace.

mod faults;
mod workspace;
