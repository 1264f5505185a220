//! The errors of a scene.

use crate::language::{Diagnostic, Severity, Sources};

/// The most errors that are reported for one scene.
pub const MOST_ERRORS: usize = 20;

/// The diagnostics of a text that is no valid scene.
#[derive(Debug)]
pub struct SceneError {
    /// At most [`MOST_ERRORS`] errors, and all warnings.
    pub diagnostics: Vec<Diagnostic>,
    /// The source texts.
    pub sources: Sources,
}

impl SceneError {
    pub(super) fn new(
        mut errors: Vec<Diagnostic>,
        warnings: Vec<Diagnostic>,
        sources: Sources,
    ) -> Self {
        if errors.len() > MOST_ERRORS {
            let message = match errors.len() - MOST_ERRORS {
                1 => "1 more error is not shown".to_owned(),
                more => format!("{more} more errors are not shown"),
            };
            errors.truncate(MOST_ERRORS);
            errors.push(without_place(message).help("correct the errors above and try again"));
        }
        errors.extend(warnings);
        Self {
            diagnostics: errors,
            sources,
        }
    }
}

/// An error that has no place in a text.
pub(super) fn without_place(message: String) -> Diagnostic {
    Diagnostic {
        severity: Severity::Error,
        message,
        place: None,
        help: None,
    }
}

/// Errors and warnings, each sorted by place; those about a whole text come last.
pub(super) fn sorted(mut diagnostics: Vec<Diagnostic>) -> (Vec<Diagnostic>, Vec<Diagnostic>) {
    diagnostics.sort_by_key(|diagnostic| {
        let place = diagnostic.place.as_ref();
        place.map(|(at, _)| (at.length == 0, at.source, at.start))
    });
    let is_error = |diagnostic: &Diagnostic| diagnostic.severity == Severity::Error;
    diagnostics.into_iter().partition(is_error)
}
