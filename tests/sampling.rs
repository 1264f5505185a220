//! Where rays go through pixels, how many, and through which pixels.

#[path = "sampling/patterns.rs"]
mod patterns;
