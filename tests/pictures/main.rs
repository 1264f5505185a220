//! The pictures: what they show, and what must not change them.

mod gallery;
mod hard_cases;
mod lamps;
mod metamorphic;
mod picture_hashes;
mod processors;
mod refraction;
mod sampling;
mod texture_filters;
mod textures;
