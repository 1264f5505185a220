//! Shapes that lie in a plane.

use std::fmt;

use glam::DVec3;

use crate::math::exact::ExactVector;
use crate::math::{ExactGeometry, Flat, Line};

/// A shape in a plane, with straight borders if it is bounded.
///
/// Borders and corners are listed in one order: that of the exact geometry.
pub trait Planar: fmt::Debug {
    /// The carrier plane.
    fn carrier(&self) -> &Flat;

    /// The plane and the borders as the scene file has them, without rounding.
    fn exact_geometry(&self) -> ExactGeometry;

    /// Takes over the plane and the borders that the shape shares with others.
    fn share(&mut self, plane: &Flat, borders: &[Option<Line>]);

    /// The corners, counter-clockwise from the front; empty if unbounded.
    fn outline(&self) -> Vec<DVec3> {
        Vec::new()
    }

    /// The same corners, exactly.
    fn exact_corners(&self) -> Vec<ExactVector> {
        Vec::new()
    }

    /// The borders that decide hits; empty if the shape is unbounded.
    fn borders(&self) -> &[Line] {
        &[]
    }

    /// A bound of the distance between the shape's own borders and those that decide.
    fn border_error(&self) -> f64 {
        0.0
    }
}
