//! Messages: results go to standard output, everything else to standard error.

use std::io::{self, ErrorKind, IsTerminal, Write};
use std::path::Path;

use clap::{Args, ColorChoice};
use serde_json::{Value, json};

use super::error::{Cause, CommandError};
use super::{Global, Status};
use crate::language::{Diagnostic, Severity, Sources, render_diagnostics};

/// The option for results in JSON.
#[derive(Debug, Clone, Copy, Args)]
pub(super) struct Json {
    /// Print the result as JSON on standard output, one line for each scene.
    #[arg(long)]
    json: bool,
}

impl Json {
    pub(super) fn is_asked(self) -> bool {
        self.json
    }
}

/// Amount, colour and width of messages.
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
            ColorChoice::Always => true,
            ColorChoice::Never => false,
            ColorChoice::Auto => allowed("NO_COLOR") && (forced || terminal && !dumb),
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

    /// Prints something that is neither result nor error, unless errors only are wanted.
    pub(super) fn note(&self, text: &str) {
        if !self.quiet {
            print_error(text);
        }
    }

    /// Prints an error.
    pub(super) fn error(&self, reason: &str) {
        print_error(&format!("error: {reason}"));
    }

    /// Prints the cause of a failure, and returns its status.
    pub(super) fn failed(&self, error: &CommandError) -> Status {
        match &error.cause {
            Cause::Reason(reason) => self.error(reason),
            Cause::Scene(scene) => self.problems(&scene.diagnostics, &scene.sources),
        }
        error.status
    }

    /// Prints a command's result, or its failure, which in JSON is a result as well.
    pub(super) fn finish(
        &self,
        scene: &Path,
        json: bool,
        result: Result<(String, Status), CommandError>,
    ) -> Status {
        match result {
            Ok((text, status)) => self.result(&text, status),
            Err(error) => {
                let status = self.failed(&error);
                if json {
                    self.result(&error.json(scene), status)
                } else {
                    status
                }
            }
        }
    }

    /// Prints the problems of a scene.
    pub(super) fn problems(&self, problems: &[Diagnostic], sources: &Sources) {
        let problems = problems.iter();
        let shown = problems.filter(|it| !self.quiet || it.severity == Severity::Error);
        let shown: Vec<_> = shown.cloned().collect();
        let text = render_diagnostics(&shown, sources, self.color, self.width);
        let _ = io::stderr().lock().write_all(text.as_bytes());
    }

    /// Prints how many scenes of a batch succeeded, if there are several.
    pub(super) fn tally(&self, statuses: &[Status]) {
        if statuses.len() > 1 {
            let ok = statuses.iter().filter(|it| **it == Status::Done).count();
            self.note(&format!("{ok} ok, {} failed", statuses.len() - ok));
        }
    }

    /// Prints a result, and returns the status to end with.
    ///
    /// A pipe that its reader has closed is no error.
    pub(super) fn result(&self, text: &str, status: Status) -> Status {
        let mut out = io::stdout().lock();
        match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
            Err(error) if error.kind() != ErrorKind::BrokenPipe => {
                self.error(&format!("cannot write to standard output: {error}"));
                status.max(Status::Io)
            }
            _ => status,
        }
    }
}

/// Prints a line to standard error; if that is closed, there is no place for a message.
fn print_error(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
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
