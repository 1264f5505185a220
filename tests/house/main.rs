//! The house: its floors, its files, its words, its numbers and what a new surface takes.

mod code;
mod contributing;
mod epsilons;
mod imports;
mod layers;
mod project;
mod words;
mod workspace;
