//! Numbers, colours, points, rays and planes.
//!
//! The scalar type of the crate is `f64`. Vectors are `glam`'s [`glam::DVec3`].

mod ball;
mod beam;
mod bounds;
pub mod classic;
mod crossing;
mod decisions;
pub(crate) mod error_bounds;
pub mod exact;
mod exact_geometry;
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
mod ray_packet;
mod refraction;
mod rgb;
mod scramble;
mod segment;
mod side;
mod span;
mod vector;

pub use ball::{Ball, is_clear};
pub use beam::Beam;
pub use bounds::Bounds;
pub use crossing::{Crossing, Grazing, InDoubt};
pub use decisions::Decisions;
pub use error_bounds::UNIT;
pub use exact_geometry::{Border, ExactGeometry};
pub use flat::Flat;
pub use footprint::{Footprint, Spread};
pub use frame::{ExactFrame, Frame};
pub use grid::Grid;
pub use limits::Limits;
pub use line::{Line, inside_all};
pub use numerics::Numerics;
pub use point::Point;
pub use ray::{CarrierId, Curve, Ray, RayOrigin};
pub use ray_packet::{Crossings, RayPacket};
pub use refraction::Refraction;
pub use rgb::Rgb;
pub use scramble::scramble;
pub use segment::Segment;
pub use side::Side;
pub use span::Span;
pub use vector::{direction, unit};
