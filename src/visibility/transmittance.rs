//! The share of light that passes the occluders on its way.

use super::primitive::Primitive;
use crate::math::{Rgb, Segment};

/// The share of light along a segment that passes these occluders, which are in file order.
///
/// Opaque surfaces block it. Transparent ones tint it, each once. Of surfaces on one carrier the first
/// counts.
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
