//! The program: its commands, options, messages and exit codes.

mod check;
mod cli;
mod cost;
mod explain;
mod no_partial_picture;
mod numerics_option;
mod prices;
