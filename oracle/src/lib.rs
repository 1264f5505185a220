//! Every decision of the geometry in exact arithmetic, to test the ray tracer against.
//!
//! The tests in `tests/exactness/oracle` ask these questions a few thousand times, and the program
//! `soak` of `heliodon-tools` as often as one likes. The folder's README lists the questions.

pub mod cases;
pub mod decisions;
pub mod floors;
pub mod rational;
pub mod rooms;
pub mod tally;
pub mod truth;
