//! The mean of a texture over what a pixel covers of it.
//!
//! In the pixel all places weigh the same; on the texture near ones weigh more than far ones. So the part
//! of the pixel that shows the surface is cut into bands of nearly one depth, and the mean of each counts
//! as much as the band's area in the pixel. The mean over a band is a sum of texels over a polygon, which by
//! Green's theorem is one along its edges: ∫∫ f dx dy = ∮ F dy with F the sum of a row up to x. Strips of
//! that are differences of a summed-area table, so a band with many texels costs no more than one with
//! few.

use glam::{DVec2, DVec3};

use super::polygon::{Polygon, area};
use super::sums::Sums;
use crate::math::{Footprint, Rgb};

/// How many times as far as the nearest place in a pixel the farthest is that is not summed up in one:
/// what lies beyond is less than this part of the pixel.
const FARTHEST: f64 = 1024.0;

/// The number of bands is the square root of this many times the logarithm of what depths there are.
///
/// Within one, depths differ by a share r, and a weight that is taken for its mean is off by 3/2 r at the
/// ends: where one half of a band is black and the other white, by 3/8 r of the band.
const BANDS: f64 = 1000.0;

/// What the steps that stand for a slanted edge may cut off at most, as a share of their polygon.
const CUT_OFF: f64 = 1.0 / 64.0;

/// The most steps that stand for an edge.
const MOST_STEPS: f64 = 256.0;

/// The mean over the part of a pixel that shows the rectangle from the origin to `size`, all in
/// texels; `None` if no part does, or if it shows only one texel.
pub(super) fn mean(sums: &Sums, footprint: &Footprint, size: DVec2) -> Option<Rgb> {
    let seen = Polygon::showing(footprint, size);
    let depths = || seen.corners().iter().map(|corner| corner.image.z);
    // Depth is one over what lies in z.
    let (far, near) = (
        depths().fold(f64::MAX, f64::min),
        depths().fold(0.0, f64::max),
    );
    if !(far > 0.0 && near <= f64::MAX && seen.area() > 0.0) {
        return None;
    }
    let texels = || seen.places().map(DVec2::floor);
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
        let error_bounds = seen.cut(|image| image.z - low).cut(|image| high - image.z);
        let share = error_bounds.area();
        if let Some(mean) = mean_of_band(sums, &error_bounds)
            && share > 0.0
        {
            sum += mean * share;
            total += share;
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

/// The mean of the texels in a part of a pixel of nearly one depth; `None` if it is too small to have
/// one.
fn mean_of_band(sums: &Sums, error_bounds: &Polygon) -> Option<DVec3> {
    let places = error_bounds.places();
    let low = places.clone().reduce(DVec2::min)?;
    // Whole periods of the texture are taken off, so that no sum is larger than need be.
    let start = (low / sums.sides()).floor() * sums.sides();
    let places = places.map(|place| place - start);
    let area = area(places.clone());
    if !(area != 0.0 && area.is_finite()) {
        return None;
    }
    let next = places.clone().cycle().skip(1);
    let mut sum = DVec3::ZERO;
    for (from, to) in places.zip(next) {
        sum += along_edge(sums, from, to, area.abs());
    }
    let mean = sum / area;
    mean.is_finite().then_some(mean)
}

/// The integral along an edge of a polygon with this area.
fn along_edge(sums: &Sums, from: DVec2, to: DVec2, area: f64) -> DVec3 {
    let way = to - from;
    if way.y == 0.0 {
        return DVec3::ZERO;
    }
    let lines = way.abs().element_sum();
    // Each step cuts off two triangles whose texels may differ.
    let steps = (way.x * way.y).abs() / (8.0 * CUT_OFF * area);
    let steps = steps.ceil().clamp(1.0, MOST_STEPS);
    let mut sum = DVec3::ZERO;
    let mut start = 0.0;
    if lines > 2.0 * steps + 4.0 {
        let mut number = 1.0;
        while number <= steps {
            let end = number / steps;
            let middle = from.x + way.x * ((start + end) / 2.0);
            sum += sums.strip(middle, from.y + way.y * start, from.y + way.y * end);
            (number, start) = (number + 1.0, end);
        }
        return sum;
    }
    // From one texel to the next, which is exact.
    let mut crossings = [0, 1].map(|axis| Crossings::new(from[axis], way[axis]));
    while start < 1.0 {
        let [x, y] = &crossings;
        let end = x.next.min(y.next).min(1.0);
        let middle = from + way * ((start + end) / 2.0);
        sum += sums.row(middle) * (way.y * (end - start));
        for crossing in &mut crossings {
            crossing.pass(end);
        }
        start = end;
    }
    sum
}

/// Where a way crosses the borders of texels along one axis, from 0 at its start to 1 at its end.
#[derive(Debug)]
struct Crossings {
    from: f64,
    way: f64,
    line: f64,
    /// The next crossing.
    next: f64,
}

impl Crossings {
    fn new(from: f64, way: f64) -> Self {
        let line = if way > 0.0 { from.floor() } else { from.ceil() };
        let mut crossings = Self {
            from,
            way,
            line,
            next: 0.0,
        };
        crossings.pass(0.0);
        crossings
    }

    /// Goes on to the first crossing behind this place.
    fn pass(&mut self, place: f64) {
        while self.next <= place {
            self.line += self.way.signum();
            let next = (self.line - self.from) / self.way;
            self.next = if next.is_nan() { f64::MAX } else { next };
        }
    }
}
