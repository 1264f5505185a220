//! From values between code values to one of them.

use crate::language::words;

/// How a value between two code values becomes one of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rounding {
    /// To the nearest code value, halves upward.
    #[default]
    Nearest,
    /// To the next lower one, as the course's programs did.
    Truncate,
}

words!(Rounding {
    Nearest: "round",
    Truncate: "truncate",
});

impl Rounding {
    /// The smallest value that becomes a code, in units of half a code.
    pub(super) fn halves(self, code: u16) -> u32 {
        match self {
            Self::Nearest => (2 * u32::from(code)).saturating_sub(1),
            Self::Truncate => 2 * u32::from(code),
        }
    }
}
