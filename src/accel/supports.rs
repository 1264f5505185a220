//! Which surfaces lie on the same sheet.

use std::collections::HashMap;

use crate::math::Support;
use crate::surface::Surface;

/// What makes two sheets one: the bits of a plane's equation, or of a centre and half axes.
#[derive(Debug, PartialEq, Eq, Hash)]
enum Sheet {
    Flat([u64; 4]),
    Round([[u64; 3]; 2]),
}

/// The sheet that each surface lies on: surfaces in one plane share it, and so do round ones of
/// the same shape in the same place; every other has its own.
#[must_use]
pub fn supports(surfaces: &[Box<dyn Surface>]) -> Vec<Support> {
    let mut known: HashMap<Sheet, Support> = HashMap::new();
    let numbered = (0u32..).map(Support).zip(surfaces);
    numbered
        .map(|(own, surface)| match sheet(&**surface) {
            Some(sheet) => *known.entry(sheet).or_insert(own),
            None => own,
        })
        .collect()
}

fn sheet(surface: &dyn Surface) -> Option<Sheet> {
    if let Some(flat) = surface.flat() {
        return Some(Sheet::Flat(flat.equation().map(f64::to_bits)));
    }
    // Adding zero turns −0 into +0, which is the same place.
    let bits = |vector: glam::DVec3| (vector + glam::DVec3::ZERO).to_array().map(f64::to_bits);
    surface.round().map(|round| Sheet::Round(round.map(bits)))
}
