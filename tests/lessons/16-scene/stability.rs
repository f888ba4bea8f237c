//! Yet to come: see the design.
