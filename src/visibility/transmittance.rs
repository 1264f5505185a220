//! Transmittance: the share of light that passes the occluders along a segment.

use super::primitive::Primitive;
use crate::math::{Rgb, Segment};

/// The share of light along a segment that passes occluders, given in file order.
///
/// Opaque surfaces block it. Transparent ones tint it, each once. On each carrier, only the first
/// surface counts.
pub(super) fn transmittance<'e, 'a: 'e>(
    occluders: impl Iterator<Item = &'e Primitive<'a>>,
    segment: &Segment,
) -> Rgb {
    let mut share = Rgb::WHITE;
    let mut crossed = Vec::new();
    for occluder in occluders {
        if occluder
            .carrier
            .is_some_and(|carrier| crossed.contains(&carrier))
        {
            continue;
        }
        if occluder.common.material.transparency == 0.0 {
            return Rgb::BLACK;
        }
        crossed.extend(occluder.carrier);
        let span = segment.limits().span();
        if let Some(hit) = occluder.hits(&segment.ray, span) {
            let texel = occluder.resolve(&hit, &segment.ray).texel;
            share = share * occluder.common.transmits(texel);
        }
    }
    share
}
