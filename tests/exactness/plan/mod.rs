//! What a plan leaves out, and how it bounds what it does not follow.

mod counts;
mod seen;
mod stretches;
mod tail;
mod zeros;
