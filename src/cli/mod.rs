//! The command line: arguments, messages, exit codes. One file per command.

mod asked;
mod bug;
mod certificate;
mod check;
mod convert;
mod cost;
mod dump;
mod explain;
mod explanation;
mod finished;
mod input;
#[cfg(unix)]
mod interrupt;
mod messages;
mod numbers;
mod output;
mod progress;
mod render;
mod setting_options;
mod shared;
mod stats;
mod status;
mod story;
mod threads;

use std::process::ExitCode;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::film::Format;
use crate::read::Language;
use messages::Messages;
use status::Status;

/// Heliodon renders scenes of planes, textured planes and a few round things.
///
/// Results go to standard output, everything else to standard error. Exit codes: 0 done, 1 the
/// answer is no, 2 wrong usage, 3 wrong scene, 4 files, 5 numbers, 70 a bug.
#[derive(Debug, Parser)]
#[command(
    name = "heliodon",
    version,
    propagate_version = true,
    max_term_width = 100,
    arg_required_else_help = true
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    // Behind what the commands have of their own, and before the help itself.
    #[command(flatten, next_display_order = 900)]
    global: Global,
}

/// What every command takes.
#[derive(Debug, Args)]
struct Global {
    /// Say less: errors only.
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Say more: rays, times, the scene's hash.
    #[arg(short, long, global = true)]
    verbose: bool,
    /// When to use colours on standard error.
    #[arg(
        long,
        global = true,
        value_enum,
        default_value = "auto",
        value_name = "WHEN"
    )]
    color: Color,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Color {
    Auto,
    Always,
    Never,
}

#[derive(Debug, Subcommand)]
enum Command {
    Render(Box<render::Options>),
    Check(check::Options),
    Explain(explain::Options),
    Cost(Box<cost::Options>),
    Dump(dump::Options),
    Convert(convert::Options),
}

/// The formats that `--format` names: a picture's or a scene's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum FormatWord {
    /// Picture: PNG with 8 bits a channel.
    Png,
    /// Picture: PNG with 16 bits a channel.
    Png16,
    /// Picture: binary PPM (P6).
    Ppm,
    /// Picture: 32-bit floats, linear and unclamped.
    Pfm,
    /// Scene: KDL.
    Kdl,
    /// Scene: the course's block grammar.
    Course,
}

impl FormatWord {
    fn picture(self) -> Option<Format> {
        match self {
            Self::Png => Some(Format::Png8),
            Self::Png16 => Some(Format::Png16),
            Self::Ppm => Some(Format::Ppm),
            Self::Pfm => Some(Format::Pfm),
            Self::Kdl | Self::Course => None,
        }
    }

    fn language(self) -> Option<Language> {
        match self {
            Self::Kdl => Some(Language::Kdl),
            Self::Course => Some(Language::Course),
            _ => None,
        }
    }
}

/// Runs the program with the process's arguments.
#[must_use]
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version go to standard output, mistakes to standard error; if neither can
            // be written to, there is nobody to tell.
            let _ = error.print();
            let status = if error.use_stderr() {
                Status::Usage
            } else {
                Status::Done
            };
            return status.into();
        }
    };
    let messages = Messages::new(&arguments.global);
    bug::report_panics();
    #[cfg(unix)]
    interrupt::clean_up();
    bug::guard(|| run(&arguments.command, &messages)).into()
}

fn run(command: &Command, messages: &Messages) -> Status {
    match command {
        Command::Render(options) => render::run(options, messages),
        Command::Check(options) => check::run(options, messages),
        Command::Explain(options) => explain::run(options, messages),
        Command::Cost(options) => cost::run(options, messages),
        Command::Dump(options) => dump::run(options, messages),
        Command::Convert(options) => convert::run(options, messages),
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_options_agree_with_each_other() {
        super::Arguments::command().debug_assert();
    }
}
