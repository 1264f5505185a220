//! The scene language as data: what a scene may say, what one says, and what is wrong with it.
//!
//! Two readers turn text into [`Node`]s, one builder turns nodes into a scene, and every part of a
//! scene can [describe](Node::new) itself as a node again. So the same few types carry a scene in
//! both directions, and [`Schema`] is the only place where words, types and defaults are written.

mod joined;
mod node;
mod problem;
mod schema;
mod source;
mod suggest;
mod value;
mod value_error;
mod words;

pub use joined::joined;
pub use node::{Entry, Node};
pub use problem::{Problem, Severity, render_problems};
pub use schema::{Attribute, Default, Naming, Range, Reference, Schema, Takes};
pub use source::{Location, Source, Sources};
pub use suggest::did_you_mean;
pub use value::Value;
pub use value_error::ValueError;
pub(crate) use words::words;
