//! Anisotropic filtering.

use super::Wrap;
use super::bilinear::Image;
use super::pyramid::Pyramid;
use crate::math::{Rgb, Spread};

/// The most mipmap lookups for one pixel.
const MOST_PROBES: f64 = 16.0;

/// The mean of mipmap lookups along the longer axis of a footprint.
///
/// Each covers the shorter axis, or more if that would take above 16 lookups (`McCormack` et al.
/// 1999, "Feline: Fast Elliptical Lines for Anisotropic Texture Mapping"). `None` if the footprint
/// is not finite, as it can be between curved mirrors.
pub(super) fn anisotropic(
    pyramid: &Pyramid,
    base: &impl Image,
    footprint: &Spread,
    wraps: [Wrap; 2],
) -> Option<Rgb> {
    let (axis, short) = footprint.axes();
    let long = axis.length();
    if !long.is_finite() {
        return None;
    }
    let probes = (long / short.max(1.0)).ceil().clamp(1.0, MOST_PROBES);
    let size = short.max(long / probes);
    let (mut sum, mut number) = (Rgb::BLACK, 0.0);
    while number < probes {
        let position = footprint.place + axis * ((number + 0.5) / probes - 0.5);
        sum += pyramid.at(base, position, size, wraps);
        number += 1.0;
    }
    Some(sum / probes)
}
