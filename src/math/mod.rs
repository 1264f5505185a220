//! Numbers, colours, points, rays and the flat things they meet.
//!
//! The one scalar of the crate is `f64`; vectors are `glam`'s [`glam::DVec3`].

mod bounds;
mod flat;
mod frame;
mod numerics;
mod ray;
mod rectangle;
mod rgb;
mod segment;
mod vector;

pub use bounds::Bounds;
pub use flat::{Crossing, Flat, Side};
pub use frame::Frame;
pub use numerics::Numerics;
pub use ray::{Point, Ray, Span, Support};
pub use rectangle::Rectangle;
pub use rgb::Rgb;
pub use segment::Segment;
pub use vector::{direction, unit};
