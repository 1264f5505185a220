//! The decisions: they are the exact ones, and the ones that are left out change nothing.

mod accelerators;
mod elision;
mod oracle;
mod plan;
