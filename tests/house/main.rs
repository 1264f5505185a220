//! The house: its floors, its files, its numbers and what a new surface takes.

mod contributing;
mod epsilons;
mod layers;
