//! Heliodon, a batch ray tracer for planes, textured planes and a few round things.

pub mod accel;
pub mod camera;
pub mod cli;
pub mod doctest;
pub mod film;
pub mod language;
pub mod light;
pub mod material;
pub mod math;
pub mod measure;
pub mod read;
pub mod render;
pub mod scene;
pub mod surface;
pub mod texture;
