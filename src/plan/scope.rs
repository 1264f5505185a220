//! The scope of the simulation.

/// The scope of the simulation; the picture does not depend on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scope {
    /// Only effects that the scene contains; work that changes nothing is skipped.
    #[default]
    CalledFor,
    /// Everything: every surface is tested, and every effect is computed.
    Everything,
}
