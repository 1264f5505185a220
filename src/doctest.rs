//! What the examples in this crate's documentation are checked with.
