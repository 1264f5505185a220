//! The program at the shell: exit codes, streams, files. One sentence a test.

#[path = "cli/shell.rs"]
mod shell;

#[path = "cli/certify.rs"]
mod certify;
#[path = "cli/cost_files.rs"]
mod cost_files;
#[path = "cli/crop.rs"]
mod crop;
#[path = "cli/determinism.rs"]
mod determinism;
#[path = "cli/exit_codes.rs"]
mod exit_codes;
#[path = "cli/files.rs"]
mod files;
#[path = "cli/numbers.rs"]
mod numbers;
#[path = "cli/streams.rs"]
mod streams;
