//! Numbers, colours, points, rays and the flat things they meet.
//!
//! The one scalar of the crate is `f64`; vectors are `glam`'s [`glam::DVec3`].

mod ball;
pub(crate) mod band;
mod beam;
mod blueprint;
mod bounds;
mod crossing;
mod decisions;
pub mod exact;
mod fan;
mod flat;
mod footprint;
pub mod form_factor;
mod frame;
mod grid;
mod limits;
mod line;
mod numerics;
mod point;
mod ray;
mod rectangle;
mod refraction;
mod rgb;
mod scramble;
mod segment;
mod side;
mod span;
mod vector;

pub use ball::{Ball, is_clear};
pub use band::UNIT;
pub use beam::Beam;
pub use blueprint::{Blueprint, Border};
pub use bounds::Bounds;
pub use crossing::{Crossing, Grazing};
pub use decisions::Decisions;
pub use fan::{Crossings, Distances, Fan};
pub use flat::Flat;
pub use footprint::{Footprint, Spread};
pub use frame::{ExactFrame, Frame};
pub use grid::Grid;
pub use limits::Limits;
pub use line::{Line, inside_all};
pub use numerics::Numerics;
pub use point::Point;
pub use ray::{Curve, Departure, Ray, Support};
pub use rectangle::Rectangle;
pub use refraction::Refraction;
pub use rgb::Rgb;
pub use scramble::scramble;
pub use segment::Segment;
pub use side::Side;
pub use span::Span;
pub use vector::{direction, unit};
