//! Plots on logarithmic axes, as SVG for light and dark pages and as characters.
//!
//! [`Figure`] draws curves in panels, [`Scatter`] named dots. Both know nothing of what they show.

mod axis;
mod characters;
mod figure;
mod frame;
mod labels;
mod scatter;
mod svg;

pub use figure::{Curve, Figure, Panel, Scale};

pub(super) use characters::names;
pub(super) use scatter::{Dot, Scatter};
pub(super) use svg::escaped;

/// Style sheet of a plot.
pub(super) const STYLE: &str = include_str!("plot.css");

/// Class that gives an element a hue; any number has one, and `None` is the colour of text.
pub(super) fn color_class(hue: Option<usize>) -> String {
    const HUES: usize = 8;
    hue.map_or("plain".to_owned(), |hue| format!("hue-{}", hue % HUES))
}
