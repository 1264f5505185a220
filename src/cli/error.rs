//! Failure of a command: an exit code and a reason, or the errors in a scene.

use std::path::Path;

use super::Status;
use super::input::title;
use super::messages::problems_json;
use crate::language::ValueError;
use crate::read::SceneError;

/// Failure of a command for one scene.
#[derive(Debug)]
pub(super) struct CommandError {
    pub(super) status: Status,
    pub(super) cause: Cause,
}

/// Cause of a failure.
#[derive(Debug)]
pub(super) enum Cause {
    /// A sentence without a full stop.
    Reason(String),
    /// Errors at places in a scene's text.
    Scene(SceneError),
}

impl CommandError {
    pub(super) fn new(status: Status, reason: impl Into<String>) -> Self {
        let cause = Cause::Reason(reason.into());
        Self { status, cause }
    }

    /// The failure of a command line that makes no sense.
    pub(super) fn usage(reason: impl Into<String>) -> Self {
        Self::new(Status::Usage, reason)
    }

    /// The failure to read or write a file.
    pub(super) fn io(reason: impl Into<String>) -> Self {
        Self::new(Status::Io, reason)
    }

    /// The failure to write to a place with this name.
    pub(super) fn write(name: impl std::fmt::Display, error: impl std::fmt::Display) -> Self {
        Self::io(format!("cannot write {name}: {error}"))
    }

    /// A refused value of the scene or file with this title.
    pub(super) fn value(status: Status, title: &str, error: &ValueError) -> Self {
        let ValueError { reason, advice, .. } = error;
        Self::new(status, format!("{title}: {reason}; {advice}"))
    }

    /// A text that is not a scene.
    pub(super) fn scene(error: SceneError) -> Self {
        Self {
            status: Status::BadInput,
            cause: Cause::Scene(error),
        }
    }

    /// One line of JSON about this scene.
    pub(super) fn json(&self, scene: &Path) -> String {
        let (error, problems) = match &self.cause {
            Cause::Reason(reason) => (Some(reason), Vec::new()),
            Cause::Scene(error) => (None, problems_json(&error.diagnostics, &error.sources)),
        };
        let line = serde_json::json!({
            "scene": title(scene),
            "exit": self.status.code(),
            "error": error,
            "problems": problems,
        });
        format!("{line}\n")
    }
}
