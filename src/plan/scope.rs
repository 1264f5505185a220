//! How much of what a scene could show is simulated.

/// How much of what a scene could show is simulated. The picture does not depend on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scope {
    /// Only what the scene calls for: what is proven to change nothing is left out.
    #[default]
    CalledFor,
    /// Everything, however useless: every surface is asked, every effect computed.
    Everything,
}
