//! The keys that a simulation knows.

/// A key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// Ends the program.
    Escape,
    /// Triangles' sides or what is within them.
    F1,
    /// Smooth edges or not.
    F2,
    /// The eye moves to the left.
    Left,
    /// The eye moves to the right.
    Right,
    /// The eye rises.
    Up,
    /// The eye sinks.
    Down,
    /// The eye comes nearer.
    W,
    /// The eye goes farther away.
    S,
}
