//! Which surfaces lie in the same plane.

use std::collections::HashMap;

use glam::DVec3;

use crate::math::{Flat, Support};
use crate::surface::Surface;

/// The sheet that each surface lies on: surfaces in one plane share it, every other has its own.
#[must_use]
pub fn supports(surfaces: &[Box<dyn Surface>]) -> Vec<Support> {
    let mut known: HashMap<[u64; 4], Support> = HashMap::new();
    let numbered = (0u32..).map(Support).zip(surfaces);
    numbered
        .map(|(own, surface)| match surface.flat() {
            Some(flat) => *known.entry(key(&flat)).or_insert(own),
            None => own,
        })
        .collect()
}

/// The bits of a plane's equation, the same for both of its sides.
fn key(flat: &Flat) -> [u64; 4] {
    let first = flat
        .normal
        .to_array()
        .into_iter()
        .find(|component| *component != 0.0);
    let sign = first.map_or(1.0, f64::signum);
    // Adding zero turns −0 into +0, which is the same plane.
    let normal = flat.normal * sign + DVec3::ZERO;
    let distance = normal.dot(flat.point) + 0.0;
    [
        normal.x.to_bits(),
        normal.y.to_bits(),
        normal.z.to_bits(),
        distance.to_bits(),
    ]
}
