//! What a plan leaves out, and how it bounds what it does not follow.

#[path = "plan/counts.rs"]
mod counts;
#[path = "plan/seen.rs"]
mod seen;
#[path = "plan/stretches.rs"]
mod stretches;
#[path = "plan/tail.rs"]
mod tail;
#[path = "plan/zeros.rs"]
mod zeros;
