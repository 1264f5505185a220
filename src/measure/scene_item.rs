//! Surfaces and lights as answers name them.

use serde::Serialize;

use crate::language::Sources;
use crate::plan::Cause;

/// A surface or light of the scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct SceneItem {
    /// Kind and name.
    pub(crate) title: String,
    /// `file:line:column`, if it was read from a text.
    pub(crate) place: Option<String>,
}

impl SceneItem {
    pub(super) fn of(cause: &Cause, sources: &Sources) -> Self {
        Self {
            title: cause.title.clone(),
            place: cause.location.map(|at| sources.position(at)),
        }
    }
}
