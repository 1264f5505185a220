//! Helpers of the tests: random numbers and scenes, files, pictures, runs of the program.

pub mod files;
pub mod floors;
pub mod golden;
pub mod random;
pub mod scenes;
pub mod shell;
pub mod texts;
