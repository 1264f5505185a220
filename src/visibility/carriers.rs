//! The carriers of surfaces: planes and round shapes that several can share.

use std::collections::HashMap;

use glam::DVec3;

use crate::math::CarrierId;
use crate::surface::Surface;

/// The carrier of each surface: its plane, or its centre and half axes.
///
/// Surfaces share a carrier if its numbers have the same bits: a plane's point and normal, or a
/// centre and half axes. Loading a scene gives coplanar surfaces the same plane.
#[must_use]
pub fn carriers(surfaces: &[Box<dyn Surface>]) -> Vec<CarrierId> {
    let mut known: HashMap<(bool, [[u64; 3]; 2]), CarrierId> = HashMap::new();
    let numbered = (0u32..).map(CarrierId).zip(surfaces);
    numbered
        .map(|(own, surface)| {
            let shape = surface.shape();
            let plane = shape.carrier().map(|plane| (true, plane.decisive()));
            let round = shape.round().map(|round| (false, round));
            plane.or(round).map_or(own, |(is_plane, vectors)| {
                *known.entry((is_plane, vectors.map(bits))).or_insert(own)
            })
        })
        .collect()
}

fn bits(vector: DVec3) -> [u64; 3] {
    // Adding zero turns −0 into +0, which is the same number.
    (vector + DVec3::ZERO).to_array().map(f64::to_bits)
}
