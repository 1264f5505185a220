//! Lamps: what they give, what stands in their way, and what is spent on finding out.

mod light;
mod proofs;
mod shadow;
mod touching;

use heliodon::film::Film;
use heliodon::plan::Scope;
use heliodon::read::{Options, read_bytes};
use heliodon::render::{Counts, Render};

/// The picture of a scene of which every ray counts and colours do not fade on the way to the eye.
fn picture(text: &str, scope: Scope) -> (Film, Counts) {
    let text = format!("lighting {{ view-falloff \"none\" }}\n{text}");
    let reading = read_bytes("lamps", text.into_bytes(), "".into(), &Options::default());
    let reading = reading.unwrap_or_else(|no| panic!("{:#?}", no.diagnostics));
    Render::new(&reading.scene)
        .scope(scope)
        .film()
        .expect("a possible picture")
}

/// The picture of a scene, as it is drawn.
fn drawn(text: &str) -> (Film, Counts) {
    picture(text, Scope::CalledFor)
}

/// The bits of all colours, row by row.
fn bits(film: &Film) -> Vec<[u64; 3]> {
    let places = (0..film.height()).flat_map(|y| (0..film.width()).map(move |x| (x, y)));
    places
        .map(|(x, y)| film.pixel(x, y).channels().map(f64::to_bits))
        .collect()
}
