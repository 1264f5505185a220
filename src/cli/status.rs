//! Exit codes, which scripts rely on.

use std::process::ExitCode;

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Status {
    /// Done.
    Done,
    /// The answer is "no": `check` found errors, or nothing that `cost` tried is good enough.
    No,
    /// The command line makes no sense.
    Usage,
    /// A scene cannot be read as a scene.
    BadInput,
    /// A file is missing or cannot be read or written.
    Io,
    /// A pixel is infinite or not a number; the picture is written all the same.
    NonFinite,
    /// The program has a bug.
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

    /// The status of a batch: that of its worst part.
    pub(super) fn worst(self, other: Self) -> Self {
        const FROM_WORST: [Status; 7] = [
            Status::Bug,
            Status::NonFinite,
            Status::Io,
            Status::BadInput,
            Status::Usage,
            Status::No,
            Status::Done,
        ];
        let found = FROM_WORST
            .into_iter()
            .find(|status| [self, other].contains(status));
        found.unwrap_or(self)
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
        assert_eq!(Done.worst(Done), Done);
        assert_eq!(Done.worst(No), No);
        assert_eq!(BadInput.worst(No), BadInput);
        assert_eq!(BadInput.worst(Io), Io);
        assert_eq!(NonFinite.worst(Io), NonFinite);
        assert_eq!(Bug.worst(NonFinite), Bug);
    }
}
