//! Diagnostics: errors and warnings about a scene's text.

use std::fmt;
use std::sync::Arc;

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, NamedSource, Report,
};

use super::{Location, Sources};

/// The severity of a diagnostic.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The scene can be rendered, but probably not as intended.
    Warning,
    /// The scene cannot be rendered.
    Error,
}

/// An error or a warning about a scene's text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Warning or error.
    pub severity: Severity,
    /// The mistake, in one sentence without a full stop.
    pub message: String,
    /// The place in the text, and a label that says what was expected there.
    pub place: Option<(Location, String)>,
    /// Advice.
    pub help: Option<String>,
}

impl Diagnostic {
    /// An error at a place; `label` says what was expected there.
    pub fn error(at: Location, message: impl Into<String>, label: impl Into<String>) -> Self {
        Self {
            severity: Severity::Error,
            message: message.into(),
            place: Some((at, label.into())),
            help: None,
        }
    }

    /// A warning at a place.
    pub fn warning(at: Location, message: impl Into<String>, label: impl Into<String>) -> Self {
        Self {
            severity: Severity::Warning,
            ..Self::error(at, message, label)
        }
    }

    /// The same diagnostic with advice.
    #[must_use]
    pub fn help(self, help: impl Into<String>) -> Self {
        Self {
            help: Some(help.into()),
            ..self
        }
    }

    /// The same diagnostic with "did you mean `…`?" if there is a word to suggest.
    #[must_use]
    pub fn suggest(self, word: Option<&str>) -> Self {
        match word {
            Some(word) => self.help(format!("did you mean `{word}`?")),
            None => self,
        }
    }

    /// The same diagnostic with "did you mean "…"?" if there is a name to suggest.
    #[must_use]
    pub fn suggest_name(self, name: Option<&str>) -> Self {
        match name {
            Some(name) => self.help(format!("did you mean {name:?}?")),
            None => self,
        }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.message)
    }
}

/// Diagnostics as text: message, position, source line, label and help.
///
/// `color` adds escape sequences for terminals. Prose is wrapped to `width` columns.
#[must_use]
pub fn render_diagnostics(
    diagnostics: &[Diagnostic],
    sources: &Sources,
    color: bool,
    width: usize,
) -> String {
    let theme = if color {
        GraphicalTheme::unicode()
    } else {
        GraphicalTheme::unicode_nocolor()
    };
    let mut text = String::new();
    for diagnostic in diagnostics {
        let (report, context_lines) = report(diagnostic, sources);
        let handler = GraphicalReportHandler::new_themed(theme.clone())
            .with_width(width)
            .with_links(false)
            .with_context_lines(context_lines);
        // Writing to a String cannot fail.
        let _ = handler.render_report(&mut text, report.as_ref());
        text.push('\n');
    }
    text
}

/// The report for `miette`, and the number of lines to show around the place.
///
/// A line that is too long is not shown: its position and label go into the help.
fn report(diagnostic: &Diagnostic, sources: &Sources) -> (Report, usize) {
    let mut report = MietteDiagnostic::new(diagnostic.message.as_str()).with_severity(
        match diagnostic.severity {
            Severity::Warning => miette::Severity::Warning,
            Severity::Error => miette::Severity::Error,
        },
    );
    let mut help: Vec<String> = diagnostic.help.iter().cloned().collect();
    let mut shown = None;
    if let Some((at, label)) = &diagnostic.place {
        let chain = sources.include_chain(*at).into_iter();
        help.extend(chain.map(|including| format!("included at {}", sources.position(including))));
        let source = sources.get(at.source);
        if source.lines_are_short(*at, 0) {
            report = report.with_label(LabeledSpan::new(Some(label.clone()), at.start, at.length));
            shown = Some((source, usize::from(source.lines_are_short(*at, 1))));
        } else {
            help.insert(0, format!("{label}, at {}", sources.position(*at)));
        }
    }
    if !help.is_empty() {
        report = report.with_help(help.join("\n"));
    }
    match shown {
        None => (report.into(), 0),
        Some((source, context_lines)) => {
            let text = NamedSource::new(&source.name, Arc::clone(&source.text));
            (Report::from(report).with_source_code(text), context_lines)
        }
    }
}
