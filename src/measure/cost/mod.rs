//! Accuracy against time: settings of one scene, each measured against a reference.
//!
//! A [`Sweep`] lists the settings, [`cost`] measures them, and the [`Cost`] prints itself as text,
//! JSON, CSV, plot and page.

mod attribution;
mod choice;
mod csv;
mod draw;
mod features;
mod front;
mod law;
mod measurement;
mod page;
mod pictures;
mod plot;
mod reference;
mod run;
mod sweep;
mod table;
mod varied;
mod words;

pub use attribution::{Breakdown, FeatureShare, OwnError, SurfaceShare};
pub use choice::{Best, Limit};
pub use features::Feature;
pub use law::{Law, Trade, exponent};
pub use measurement::Measurement;
pub use reference::{Reference, Uncertainty};
pub use run::{Cost, CostOptions, cost};
pub use sweep::{Step, Sweep, Variation};
