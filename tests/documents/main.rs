//! The documents and examples: their commands, figures, tables and pictures are what is made.

mod commands;
mod effects_page;
mod examples;
mod laws;
mod numerics_pictures;
