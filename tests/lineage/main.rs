//! The lineage: what the chapter and the rules around it ask, kept by tests.
//!
//! R1–R45 are the chapter's requirements and G1–G16 its gaps; `docs/lineage.md` lists them all with
//! the tests that keep them, and `table` checks that list against this folder. A test's comment
//! begins with the numbers that it keeps.

#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot set its stage has failed"
)]

mod camera;
mod film;
mod lighting;
mod lights;
mod mirrors;
mod other_surfaces;
mod planes;
mod properties;
mod refusals;
mod rooms;
mod round_things;
mod shadows;
mod steadiness;
mod table;
mod texture_lookup;
mod texture_scale;
mod tiles;
mod tools;
mod transparency;
mod whole_model;
