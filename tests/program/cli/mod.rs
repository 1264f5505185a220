//! The program at the shell: exit codes, streams, files. One sentence a test.

mod certify;
mod cost_files;
mod crop;
mod determinism;
mod exit_codes;
mod files;
mod numbers;
mod streams;
