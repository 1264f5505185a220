//! The mean of a texture over the footprint of a pixel.
//!
//! Positions of a pixel have equal weights; on the texture, near ones weigh more than far ones. So
//! the part of the pixel that shows the surface is cut into bands of nearly one depth, and the mean
//! of each band is weighted by the band's area in the pixel.
//!
//! The mean over a band is an integral over a polygon of texels. By Green's theorem it is a
//! contour integral, ∫∫ f dx dy = ∮ F dy, where F is the sum of a row up to x. Strips of F are
//! differences of a summed-area table, so the time does not depend on the number of texels.

use glam::{DVec2, DVec3};

use super::polygon::{Polygon, area};
use super::summed_area::SummedAreaTable;
use crate::math::{Footprint, Rgb};

/// Depth beyond which all positions form one band, as a multiple of the nearest.
///
/// They cover less than 1/1024 of the pixel.
const FARTHEST: f64 = 1024.0;

/// Factor in the number of bands, √(factor · ln(depth ratio)).
///
/// If the depths in a band differ by a fraction r, the mean weight is off by 3/2 r at its ends. In
/// a band with a black and a white half that adds up to 3/8 r of the band.
const BANDS: f64 = 1000.0;

/// The most area that the steps of an edge cut off, as a fraction of the polygon.
const CUT_OFF: f64 = 1.0 / 64.0;

/// The most steps of an edge.
const MOST_STEPS: f64 = 256.0;

/// The mean over the part of a pixel that shows a rectangle.
///
/// The rectangle reaches from the origin to `size`, in texels. `None` if no part shows it, or if a single texel covers the part.
pub(super) fn mean(sums: &SummedAreaTable, footprint: &Footprint, size: DVec2) -> Option<Rgb> {
    let shown = Polygon::showing(footprint, size);
    // The last coordinate is the reciprocal of the depth.
    let inverses = || shown.corners().iter().map(|corner| corner.image.z);
    let (far, near) = (
        inverses().fold(f64::MAX, f64::min),
        inverses().fold(0.0, f64::max),
    );
    if !(far > 0.0 && near <= f64::MAX && shown.area() > 0.0) {
        return None;
    }
    let texels = || shown.images().map(DVec2::floor);
    if let Some(first) = texels().next()
        && texels().all(|texel| texel == first)
    {
        return None;
    }
    let cut = far.max(near / FARTHEST);
    let range = libm::log(near / cut);
    let bands = (BANDS * range).sqrt().ceil().max(1.0);
    let (mut sum, mut total) = (DVec3::ZERO, 0.0);
    let mut add = |low: f64, high: f64| {
        let band = shown.clipped(|image| image.z - low);
        let band = band.clipped(|image| high - image.z);
        let weight = band.area();
        if let Some(mean) = mean_of_band(sums, &band)
            && weight > 0.0
        {
            sum += mean * weight;
            total += weight;
        }
    };
    let mut high = near;
    let mut number = 1.0;
    while number < bands {
        let low = near / libm::exp(range * number / bands);
        add(low, high);
        high = low;
        number += 1.0;
    }
    add(cut, high);
    if far < cut {
        add(far, cut);
    }
    (total > 0.0).then(|| sums.color(sum / total))
}

/// The mean texel of a band; `None` if its area is zero or not finite.
fn mean_of_band(sums: &SummedAreaTable, band: &Polygon) -> Option<DVec3> {
    let corners = band.images();
    let low = corners.clone().reduce(DVec2::min)?;
    // Subtracting whole periods of the texture keeps the sums small.
    let start = (low / sums.sides()).floor() * sums.sides();
    let corners = corners.map(|corner| corner - start);
    let area = area(corners.clone());
    if !(area != 0.0 && area.is_finite()) {
        return None;
    }
    let next = corners.clone().cycle().skip(1);
    let mut sum = DVec3::ZERO;
    for (from, to) in corners.zip(next) {
        sum += along_edge(sums, from, to, area.abs());
    }
    let mean = sum / area;
    mean.is_finite().then_some(mean)
}

/// The integral of F dy along an edge of a polygon with an area.
fn along_edge(sums: &SummedAreaTable, from: DVec2, to: DVec2, area: f64) -> DVec3 {
    let edge = to - from;
    if edge.y == 0.0 {
        return DVec3::ZERO;
    }
    let lines = edge.abs().element_sum();
    // Each step cuts off two triangles.
    let steps = (edge.x * edge.y).abs() / (8.0 * CUT_OFF * area);
    let steps = steps.ceil().clamp(1.0, MOST_STEPS);
    let mut sum = DVec3::ZERO;
    let mut start = 0.0;
    if lines > 2.0 * steps + 4.0 {
        let mut number = 1.0;
        while number <= steps {
            let end = number / steps;
            let middle = from.x + edge.x * ((start + end) / 2.0);
            sum += sums.strip(middle, from.y + edge.y * start, from.y + edge.y * end);
            (number, start) = (number + 1.0, end);
        }
        return sum;
    }
    // From texel to texel, which is exact.
    let mut crossings = [0, 1].map(|axis| Crossings::new(from[axis], edge[axis]));
    while start < 1.0 {
        let [x, y] = &crossings;
        let end = x.next.min(y.next).min(1.0);
        let middle = from + edge * ((start + end) / 2.0);
        sum += sums.row(middle) * (edge.y * (end - start));
        for crossing in &mut crossings {
            crossing.pass(end);
        }
        start = end;
    }
    sum
}

/// The crossings of an edge with the texel borders of one axis.
///
/// Their parameters run from 0 at the start of the edge to 1 at its end.
#[derive(Debug)]
struct Crossings {
    from: f64,
    length: f64,
    border: f64,
    /// The parameter of the next crossing.
    next: f64,
}

impl Crossings {
    fn new(from: f64, length: f64) -> Self {
        let mut crossings = Self {
            from,
            length,
            border: if length > 0.0 {
                from.floor()
            } else {
                from.ceil()
            },
            next: 0.0,
        };
        crossings.pass(0.0);
        crossings
    }

    /// Advances to the first crossing after a parameter.
    fn pass(&mut self, parameter: f64) {
        while self.next <= parameter {
            self.border += self.length.signum();
            let next = (self.border - self.from) / self.length;
            self.next = if next.is_nan() { f64::MAX } else { next };
        }
    }
}
