//! The eight ways to compare what comes with what is there.

// ANCHOR: compare
/// Which of two values lets a fragment pass. (OpenGL 4.6, *Stencil Test* and *Depth Buffer Test*.)
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Compare {
    /// Nothing passes.
    Never,
    /// What is less than what is there.
    Less,
    /// What is equal to it.
    Equal,
    /// What is less or equal.
    Lequal,
    /// What is greater.
    Greater,
    /// What is not equal.
    Notequal,
    /// What is greater or equal.
    Gequal,
    /// Everything passes.
    Always,
}

impl Compare {
    /// Whether what comes passes against what is there. NaN compares as floats do: it is neither less than anything, nor
    /// equal, nor greater.
    #[inline]
    #[must_use]
    pub fn passes<T: Copy + PartialOrd>(self, incoming: T, kept: T) -> bool {
        match self {
            Self::Never => false,
            Self::Less => incoming < kept,
            Self::Equal => incoming == kept,
            Self::Lequal => incoming <= kept,
            Self::Greater => incoming > kept,
            Self::Notequal => incoming != kept,
            Self::Gequal => incoming >= kept,
            Self::Always => true,
        }
    }
}
// ANCHOR_END: compare
