//! Refraction: what `ior` does to rays and pictures, measured against closed forms.

#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot set its stage has failed"
)]

mod closed_forms;
mod nesting;
mod pictures;
mod rays;
mod tools;
