//! Pictures that have to stay the same although something about their scenes changes.
//!
//! Nothing here says what a picture shows; each test says which other scene must give the same one
//! (Chen, Cheung and Yiu 1998, "Metamorphic testing"). So the tests need no goldens, and every scene
//! is a test case: those in `scenes` and rooms that are made up from seeds.

#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot set its stage has failed"
)]

mod exceptions;
mod hidden;
mod mirrored;
mod moved;
mod order;
mod rooms;
mod scaled;
mod subject;
mod threads;
mod turned;
mod walls;
mod zeros;
