//! Along the longer axis of what a pixel covers.

use super::pyramid::Pyramid;
use super::{Texture, Wrap};
use crate::math::{Rgb, Spread};

/// The most places that one pixel looks at.
const MOST_PROBES: f64 = 16.0;

/// The mean of some places along the longer axis of a footprint, each as large as the shorter axis,
/// or larger where that would be more than 16 of them (after `McCormack` and others 1999, "Feline: Fast
/// Elliptical Lines for Anisotropic Texture Mapping").
pub(super) fn anisotropic(
    pyramid: &Pyramid,
    texture: &Texture,
    spread: &Spread,
    wraps: [Wrap; 2],
) -> Rgb {
    let (axis, short) = spread.axes();
    let long = axis.length();
    // Between curved mirrors a beam can spread beyond all numbers.
    if !long.is_finite() {
        return texture.mean();
    }
    let probes = (long / short.max(1.0)).ceil().clamp(1.0, MOST_PROBES);
    let size = short.max(long / probes);
    let (mut sum, mut number) = (Rgb::BLACK, 0.0);
    while number < probes {
        let place = spread.place + axis * ((number + 0.5) / probes - 0.5);
        sum += pyramid.at(texture, place, size, wraps);
        number += 1.0;
    }
    sum / probes
}
