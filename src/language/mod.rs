//! The scene language as data: schemas, nodes, values, sources and diagnostics.
//!
//! Two readers turn text into [`Node`]s, one builder turns nodes into a scene, and each part of a
//! scene describes itself as a node again. A [`Schema`] is the only place that holds words, types
//! and defaults.

mod diagnostic;
mod node;
mod phrases;
mod schema;
mod source;
mod value;
mod value_error;
mod words;

pub use diagnostic::{Diagnostic, Severity, render_diagnostics};
pub use node::{Entry, Node};
pub use phrases::{did_you_mean, joined};
pub use schema::{Attribute, Default, Naming, Range, Reference, Schema, Takes};
pub use source::{Location, Source, Sources};
pub use value::Value;
pub use value_error::ValueError;
pub(crate) use words::words;
