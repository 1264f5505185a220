//! Drawings of numbers, for light and dark pages.

mod axis;
mod curves;
mod frame;
mod labels;
mod svg;

pub use curves::{Curve, Figure, Panel, Scale};

pub(super) use axis::Axis;
pub(super) use frame::{Frame, number, seconds};
pub(super) use labels::Labels;
pub(super) use svg::{Svg, escaped};

/// The colours and lines of a drawing.
pub(super) const STYLE: &str = include_str!("plot.css");

/// How many hues there are.
pub(super) const HUES: usize = 8;
