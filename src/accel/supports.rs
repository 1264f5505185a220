//! Which surfaces lie in the same plane.

use std::collections::HashMap;

use crate::math::Support;
use crate::surface::Surface;

/// The sheet that each surface lies on: surfaces in one plane share it, every other has its own.
#[must_use]
pub fn supports(surfaces: &[Box<dyn Surface>]) -> Vec<Support> {
    let mut known: HashMap<[u64; 4], Support> = HashMap::new();
    let numbered = (0u32..).map(Support).zip(surfaces);
    numbered
        .map(|(own, surface)| match surface.flat() {
            Some(flat) => *known
                .entry(flat.equation().map(f64::to_bits))
                .or_insert(own),
            None => own,
        })
        .collect()
}
