//! Command line: arguments, messages, exit codes; one file per command.

mod asked;
mod bug;
mod certificate;
mod check;
mod convert;
mod cost;
mod dump;
mod error;
mod explain;
mod explanation;
mod finished;
mod format_word;
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

use clap::{Args, ColorChoice, Parser, Subcommand};

use messages::Messages;
use status::Status;

/// Batch ray tracer for scenes of planes, textured planes and a few round surfaces.
///
/// Results go to standard output, everything else to standard error.
///
/// Exit codes: 0 success, 1 negative answer, 2 wrong usage, 3 errors in a scene, 4 file error, 5
/// pixels that are not finite, 70 a bug in heliodon.
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
    // After the commands' own options, and before the help itself.
    #[command(flatten, next_display_order = 900)]
    global: Global,
}

/// Options of every command.
#[derive(Debug, Args)]
struct Global {
    /// Print errors only.
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Print more: ray counts, shared borders, the scene's hash.
    #[arg(short, long, global = true)]
    verbose: bool,
    /// Use of colours on standard error; `auto` uses them on terminals.
    #[arg(long, global = true, default_value = "auto", value_name = "WHEN")]
    color: ColorChoice,
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

/// Runs the program with the process's arguments.
#[must_use]
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version go to standard output, mistakes to standard error. If neither can
            // be written to, there is no place for a message.
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
