//! Which surfaces lie on the same sheet.

use std::collections::HashMap;

use glam::DVec3;

use crate::math::CarrierId;
use crate::surface::Surface;

/// The sheet that each surface lies on: surfaces in one plane share it, and so do round ones of
/// the same shape in the same place; every other has its own.
///
/// What makes two sheets one are the bits of the numbers that decide: a plane's point and
/// normal, which surfaces in one plane share since they were loaded, or a centre and half axes.
#[must_use]
pub fn supports(surfaces: &[Box<dyn Surface>]) -> Vec<CarrierId> {
    let mut known: HashMap<(bool, [[u64; 3]; 2]), CarrierId> = HashMap::new();
    let numbered = (0u32..).map(CarrierId).zip(surfaces);
    numbered
        .map(|(own, surface)| {
            let flat = surface.flat().map(|flat| (true, flat.decisive()));
            let round = surface.round().map(|round| (false, round));
            let sheet = flat.or(round);
            sheet.map_or(own, |(flat, vectors)| {
                *known.entry((flat, vectors.map(bits))).or_insert(own)
            })
        })
        .collect()
}

fn bits(vector: DVec3) -> [u64; 3] {
    // Adding zero turns −0 into +0, which is the same place.
    (vector + DVec3::ZERO).to_array().map(f64::to_bits)
}
