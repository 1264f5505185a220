//! Words for the person at the shell: results on standard output, the rest on standard error.

use std::io::{self, ErrorKind, IsTerminal, Write};

use clap::Args;
use serde_json::{Value, json};

use super::{Color, Global, Status};
use crate::language::{Diagnostic, Severity, Sources, render_diagnostics};

/// Whether results are for programs.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct Json {
    /// Print the answer as JSON on standard output, one line for each scene.
    #[arg(long)]
    json: bool,
}

impl Json {
    pub(super) fn is_asked(self) -> bool {
        self.json
    }
}

/// How much to say, and how.
#[derive(Debug)]
pub(super) struct Messages {
    pub(super) quiet: bool,
    pub(super) verbose: bool,
    color: bool,
    width: usize,
}

impl Messages {
    pub(super) fn new(global: &Global) -> Self {
        const DEFAULT_WIDTH: usize = 100;
        let terminal = io::stderr().is_terminal();
        let allowed = |name| std::env::var_os(name).is_none_or(|value| value.is_empty());
        let dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
        let forced = std::env::var_os("CLICOLOR_FORCE").is_some_and(|value| value != "0");
        let color = match global.color {
            Color::Always => true,
            Color::Never => false,
            Color::Auto => allowed("NO_COLOR") && (forced || terminal && !dumb),
        };
        let console = terminal_size::terminal_size_of(io::stderr());
        let width = console.map_or(DEFAULT_WIDTH, |(width, _)| {
            usize::from(width.0).clamp(40, 120)
        });
        Self {
            quiet: global.quiet,
            verbose: global.verbose,
            color,
            width,
        }
    }

    /// Says something that is not a result, unless asked to be quiet.
    pub(super) fn note(&self, text: &str) {
        if !self.quiet {
            self.error(text);
        }
    }

    /// Says that something went wrong.
    pub(super) fn error(&self, text: &str) {
        // With standard error closed there is nobody to tell.
        let _ = writeln!(io::stderr().lock(), "{text}");
    }

    /// Shows what is wrong with a scene.
    pub(super) fn problems(&self, problems: &[Diagnostic], sources: &Sources) {
        let shown: Vec<_> = problems
            .iter()
            .filter(|problem| !self.quiet || problem.severity == Severity::Error)
            .cloned()
            .collect();
        let text = render_diagnostics(&shown, sources, self.color, self.width);
        let _ = io::stderr().lock().write_all(text.as_bytes());
    }

    /// Says how many parts of a batch went well, if there are several.
    pub(super) fn tally(&self, statuses: &[Status]) {
        if statuses.len() > 1 {
            let ok = statuses
                .iter()
                .filter(|status| **status == Status::Done)
                .count();
            self.note(&format!("{ok} ok, {} failed", statuses.len() - ok));
        }
    }

    /// Prints a result, and gives the status to end with.
    ///
    /// A reader that has seen enough and closed the pipe is no error.
    pub(super) fn result(&self, text: &str, status: Status) -> Status {
        let mut out = io::stdout().lock();
        match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
            Err(error) if error.kind() != ErrorKind::BrokenPipe => {
                self.error(&format!("error: cannot write to standard output: {error}"));
                status.worst(Status::Io)
            }
            _ => status,
        }
    }
}

/// Problems as JSON values.
pub(super) fn problems_json(problems: &[Diagnostic], sources: &Sources) -> Vec<Value> {
    let as_json = |problem: &Diagnostic| {
        let place = problem.place.as_ref().map(|(at, label)| {
            let source = sources.get(at.source);
            let (line, column) = source.line_and_column(at.start);
            json!({ "file": source.name, "line": line, "column": column, "expected": label })
        });
        let severity = match problem.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        let (message, help) = (&problem.message, &problem.help);
        json!({ "severity": severity, "message": message, "place": place, "help": help })
    };
    problems.iter().map(as_json).collect()
}
