//! Exit codes, which scripts rely on.

use std::process::ExitCode;

/// Outcome of a command, from the best to the worst; the worst of a batch is that of the batch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Status {
    /// Success.
    Done,
    /// A negative answer: `check` found errors, or no setting of `cost` is good enough.
    No,
    /// A command line that makes no sense.
    Usage,
    /// A text that is not a scene.
    BadInput,
    /// A file that is missing, or cannot be read or written.
    Io,
    /// A pixel that is infinite or not a number; the picture is written all the same.
    NonFinite,
    /// A bug in the program.
    Bug,
}

impl Status {
    /// The code that the shell sees.
    pub(super) fn code(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::No => 1,
            Self::Usage => 2,
            Self::BadInput => 3,
            Self::Io => 4,
            Self::NonFinite => 5,
            Self::Bug => 70,
        }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        Self::from(status.code())
    }
}

#[cfg(test)]
mod tests {
    use super::Status::{BadInput, Bug, Done, Io, No, NonFinite};

    #[test]
    fn the_worst_of_a_batch_wins() {
        assert_eq!(Done.max(Done), Done);
        assert_eq!(Done.max(No), No);
        assert_eq!(BadInput.max(No), BadInput);
        assert_eq!(BadInput.max(Io), Io);
        assert_eq!(NonFinite.max(Io), NonFinite);
        assert_eq!(Bug.max(NonFinite), Bug);
    }
}
