//! The documents: their commands, figures, tables and pictures are what the program makes.

mod commands;
mod effects_page;
mod laws;
mod numerics_pictures;
