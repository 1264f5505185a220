//! What is wrong with a scene, said so that the user can mend it.

use std::fmt;
use std::sync::Arc;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource, SourceCode,
};

use super::{Location, Sources};

/// How bad a problem is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The scene can be rendered, but probably not as meant.
    Warning,
    /// The scene cannot be rendered.
    Error,
}

/// One mistake in a scene file: what, where, and what to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// Where, and what was expected there.
    pub place: Option<(Location, String)>,
    /// What to do about it.
    pub help: Option<String>,
}

impl Problem {
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

    /// The same problem with advice.
    #[must_use]
    pub fn help(self, help: impl Into<String>) -> Self {
        Self {
            help: Some(help.into()),
            ..self
        }
    }

    /// The same problem with "did you mean `…`?" if there is a word to suggest.
    #[must_use]
    pub fn suggest(self, word: Option<&str>) -> Self {
        match word {
            Some(word) => self.help(format!("did you mean `{word}`?")),
            None => self,
        }
    }

    /// The same problem with "did you mean "…"?" if there is a name to suggest.
    #[must_use]
    pub fn suggest_name(self, name: Option<&str>) -> Self {
        match name {
            Some(name) => self.help(format!("did you mean {name:?}?")),
            None => self,
        }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.message)
    }
}

/// The problems as a person reads them: file, line, caret, what was expected, what to do.
///
/// `color` is for terminals; `width` is the number of columns that prose is wrapped to.
#[must_use]
pub fn render_problems(
    problems: &[Problem],
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
    for problem in problems {
        let report = Report::new(problem, sources);
        let handler = GraphicalReportHandler::new_themed(theme.clone())
            .with_width(width)
            .with_links(false)
            .with_context_lines(report.context_lines);
        // Writing to a String cannot fail.
        let _ = handler.render_report(&mut text, &report);
        text.push('\n');
    }
    text
}

/// A problem joined with the text it is about, as `miette` wants it.
#[derive(Debug)]
struct Report<'a> {
    problem: &'a Problem,
    /// The text to show a part of; `None` for a problem without place, and for one on a line that
    /// is too long to be shown.
    source: Option<NamedSource<Arc<str>>>,
    /// How many lines to show before and after it.
    context_lines: usize,
    help: Option<String>,
}

impl<'a> Report<'a> {
    fn new(problem: &'a Problem, sources: &Sources) -> Self {
        let mut help: Vec<String> = problem.help.iter().cloned().collect();
        let mut context_lines = 0;
        let source = problem.place.as_ref().and_then(|(at, label)| {
            for including in sources.include_chain(*at) {
                help.push(format!("included at {}", sources.position(including)));
            }
            let source = sources.get(at.source);
            if !source.lines_are_short(*at, 0) {
                help.insert(0, format!("{label}, at {}", sources.position(*at)));
                return None;
            }
            context_lines = usize::from(source.lines_are_short(*at, 1));
            Some(NamedSource::new(&source.name, Arc::clone(&source.text)))
        });
        Self {
            problem,
            source,
            context_lines,
            help: (!help.is_empty()).then(|| help.join("\n")),
        }
    }
}

impl fmt::Display for Report<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.problem.fmt(out)
    }
}

impl std::error::Error for Report<'_> {}

impl Diagnostic for Report<'_> {
    fn severity(&self) -> Option<miette::Severity> {
        Some(match self.problem.severity {
            Severity::Warning => miette::Severity::Warning,
            Severity::Error => miette::Severity::Error,
        })
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help
            .as_ref()
            .map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.source.as_ref().map(|source| source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let (at, label) = self
            .problem
            .place
            .as_ref()
            .filter(|_| self.source.is_some())?;
        let span = LabeledSpan::new(Some(label.clone()), at.start, at.length);
        Some(Box::new(std::iter::once(span)))
    }
}
