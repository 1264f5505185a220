//! Draws every texture picture of the project's scenes, from code alone.
//!
//! Usage: `textures [DIRECTORY]`; the directory defaults to `textures`. The output is the same,
//! byte for byte, on every run and every platform: all noise comes from integer hashes, and only
//! arithmetic and square roots, which IEEE 754 defines exactly, are used on the numbers.

mod angle;
mod arrow;
mod brick;
mod brush;
mod bust;
mod canvas;
mod cloud;
mod colour;
mod complexion;
mod dusk;
mod face;
mod farm;
mod hair;
mod hull;
mod noise;
mod oak;
mod planet;
mod portrait;
mod shape;
mod slide;
mod solid;
mod stained_glass;
mod stroke;
mod tile;
mod vector;
mod wing;
mod winglet;

use canvas::Canvas;
use std::error::Error;
use std::path::PathBuf;

/// A file name and the function that draws the picture of that name.
type Entry = (&'static str, fn() -> Canvas);

/// All the pictures, the quick ones first.
const PICTURES: [Entry; 13] = [
    ("arrow-8x8.png", arrow::draw),
    ("oak-128.png", oak::draw),
    ("tile-128.png", tile::draw),
    ("brick-128.png", brick::draw_small),
    ("brick-384.png", brick::draw_large),
    ("hull-512.png", hull::draw),
    ("stained-glass.png", stained_glass::draw),
    ("slide.png", slide::draw),
    ("planet-512.png", planet::draw),
    ("dusk-1024.png", dusk::draw),
    ("dusk-sun-1024.png", dusk::draw_with_sun),
    ("wing-1024.png", wing::draw),
    ("portrait.png", portrait::draw),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let directory = arguments
        .next()
        .map_or_else(|| PathBuf::from("textures"), PathBuf::from);
    if arguments.next().is_some() {
        return Err("usage: textures [DIRECTORY]".into());
    }
    std::fs::create_dir_all(&directory)?;
    for (name, draw) in PICTURES {
        let path = directory.join(name);
        draw().write(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}
