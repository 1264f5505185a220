//! The `heliodon` program.

fn main() {}
