//! Where a line crosses a plane.

use glam::DVec3;

use super::error_bounds::{GRAZING, HEIGHT, QUOTIENT, SLOPE, UNDERFLOW};
use super::exact::Sign;
use super::{Decisions, Flat, Ray, RayOrigin, Segment, Side, Span};

/// Where a line crosses a plane ahead, not yet divided: `t = height / slope`.
#[derive(Debug, Clone, Copy)]
pub struct Crossing {
    /// From the plane's point to the ray's origin.
    pub origin: DVec3,
    /// How far the origin lies behind the plane, along the normal: `N = −n·c`.
    pub height: f64,
    /// How much the ray rises along the normal per unit of `t`: `D = n·d`.
    pub slope: f64,
    /// Whether the ray rises along the normal; the sign of the slope, for certain.
    pub rises: bool,
    /// How far at most the height is from the true one.
    pub doubt: f64,
    /// How far the origin may be from where it ought to, if it is no further from the plane than
    /// that: the ray crosses the plane at its very start, and there its line says little.
    pub at_start: Option<f64>,
    /// How a ray crosses that is nearly parallel to the plane; `None` for all others.
    pub grazing: Option<Grazing>,
}

/// A crossing so nearly along the plane that only the exact place says what lies there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grazing {
    /// The ray meets the plane ahead.
    Ahead,
    /// Rounding has put the start of the ray beyond the plane, which it has yet to cross.
    Behind,
}

impl Crossing {
    /// Whether borders have to be asked exactly, however far from them the rounded place is.
    #[must_use]
    #[inline(always)]
    pub fn is_delicate(&self) -> bool {
        self.at_start.is_some() || self.grazing.is_some()
    }

    /// The distance of the crossing: above zero, as it lies ahead.
    #[must_use]
    pub fn distance(&self) -> f64 {
        const SMALLEST: f64 = f64::from_bits(1);
        // Within rounding of the plane, the height can have the wrong sign.
        (self.height / self.slope).max(SMALLEST)
    }

    /// Whether the crossing lies beyond a span for certain, before any division.
    #[must_use]
    #[inline(always)]
    pub fn is_beyond(&self, span: Span) -> bool {
        // At the very start, the height can have the wrong sign, and then nothing is nearer.
        let ahead = if self.rises {
            self.height
        } else {
            -self.height
        };
        ahead - self.doubt > span.max() * (self.slope.abs() + SLOPE)
    }

    /// How far at most a distance is from the exact one.
    #[must_use]
    pub fn error(&self, t: f64) -> f64 {
        (self.doubt + SLOPE * t) / self.slope.abs() + QUOTIENT * t
    }
}

/// A slope that is not [`GRAZING`], whichever surface's normal in a plane it was computed with.
const STEEP: f64 = GRAZING + 2.0 * SLOPE;

/// Rounded values do not decide.
#[derive(Debug, Clone, Copy)]
pub struct InDoubt;

impl Flat {
    /// Where a segment crosses the plane, if its ends lie strictly on opposite sides; only then
    /// can a surface in this plane stand between them.
    ///
    /// `end` is the side that the segment's end is on.
    #[must_use]
    #[inline(always)]
    pub fn separates(&self, segment: &Segment, end: Side) -> Option<Crossing> {
        let ray = &segment.ray;
        let origin = ray.origin.from(self.point);
        let height = -self.normal.dot(origin);
        let (start, at_start) = if height.abs() > self.doubt + ray.doubt + ray.astray {
            (Sign::of(-height), None)
        } else {
            self.side_of_origin(ray)
        };
        let rises = match (Side::of(start), end) {
            (Side::Back, Side::Front) => true,
            (Side::Front, Side::Back) => false,
            _ => return None,
        };
        let slope = self.normal.dot(ray.dir);
        Some(Crossing {
            origin,
            height,
            slope,
            rises,
            doubt: self.doubt + ray.doubt,
            at_start,
            grazing: self.grazing(ray, slope, rises, at_start),
        })
    }

    /// Where a ray crosses the plane ahead of its origin; a ray along the plane never does.
    #[must_use]
    #[inline(always)]
    pub fn crossing(&self, ray: &Ray) -> Option<Crossing> {
        let certain = self.certain_crossing(ray);
        certain.unwrap_or_else(|InDoubt| self.doubtful_crossing(ray))
    }

    /// Where a ray crosses the plane ahead, if it does, by rounded values; or that they leave doubt.
    #[inline(always)]
    pub(crate) fn certain_crossing(&self, ray: &Ray) -> Result<Option<Crossing>, InDoubt> {
        let origin = ray.origin.from(self.point);
        let height = -self.normal.dot(origin);
        let slope = self.normal.dot(ray.dir);
        let doubt = self.doubt + ray.doubt;
        let rises = slope > 0.0;
        if height.abs() > doubt + ray.astray && slope.abs() > STEEP {
            return Ok((rises == (height > 0.0)).then_some(Crossing {
                origin,
                height,
                slope,
                rises,
                doubt,
                at_start: None,
                grazing: None,
            }));
        }
        Err(InDoubt)
    }

    /// Where a ray crosses the plane ahead, if it does, where rounded values leave doubt.
    #[cold]
    pub(crate) fn doubtful_crossing(&self, ray: &Ray) -> Option<Crossing> {
        let origin = ray.origin.from(self.point);
        let (height, slope) = (-self.normal.dot(origin), self.normal.dot(ray.dir));
        let crossing = Crossing {
            origin,
            height,
            slope,
            rises: slope > 0.0,
            doubt: self.doubt + ray.doubt,
            at_start: None,
            grazing: self.grazing(ray, slope, slope > 0.0, None),
        };
        if height.abs() > crossing.doubt + ray.astray && slope.abs() > SLOPE {
            return (crossing.rises == (height > 0.0)).then_some(crossing);
        }
        let exact = self.exact_slope(ray.dir);
        let sign = exact.sign();
        Decisions::note(sign == Sign::Zero);
        let (side, at_start) = self.side_of_origin(ray);
        let ahead = -(side * sign) == Sign::Positive;
        let rises = sign == Sign::Positive;
        // A slope so small that no double holds it is still not zero.
        let steepness = exact.to_f64().abs().max(UNDERFLOW);
        ahead.then(|| Crossing {
            slope: if rises { steepness } else { -steepness },
            rises,
            at_start,
            grazing: self.grazing(ray, slope, rises, at_start),
            ..crossing
        })
    }

    /// How a ray crosses the plane if it is nearly parallel to it.
    #[inline(always)]
    fn grazing(
        &self,
        ray: &Ray,
        slope: f64,
        rises: bool,
        at_start: Option<f64>,
    ) -> Option<Grazing> {
        if slope.abs() > STEEP {
            return None;
        }
        // All surfaces in this plane have to agree.
        let grazes = self.decisive.dot(ray.dir).abs() < GRAZING;
        grazes.then(|| {
            let behind =
                || self.exact_side(&ray.origin) == Sign::of(if rises { 1.0 } else { -1.0 });
            if at_start.is_some() && behind() {
                Grazing::Behind
            } else {
                Grazing::Ahead
            }
        })
    }

    /// The side of the plane that a ray starts on; and if it is not measured, how far the origin may
    /// be from where it ought to.
    ///
    /// The start of a ray that leaves a surface is rounded, so close to this plane its own side
    /// means nothing. But the ray that arrived there did not cross the plane, so the side is the
    /// one on which that ray started, which may in its turn have left a surface close to this
    /// plane; and a ray that left this very plane is on the side to which it went. So nothing leaks
    /// through the edges and corners of a room.
    #[cold]
    fn side_of_origin(&self, ray: &Ray) -> (Sign, Option<f64>) {
        let rounding = ray.rounding();
        let mut ray = *ray;
        let mut inherited = false;
        let side = loop {
            let Some(ray_origin) = ray.spawned_from else {
                break self.exact_side(&ray.origin);
            };
            if ray_origin.is_in(self) {
                inherited = true;
                break self.exact_slope(ray.dir).sign();
            }
            if let Some(height) = self.certain_height(ray_origin) {
                break Sign::of(height);
            }
            inherited = true;
            ray = *ray_origin.arriving;
        };
        if !inherited {
            return (side, None);
        }
        Decisions::note(true);
        (side, Some(rounding))
    }
    /// The height of a hit above the plane, unless it is so close to the plane that rounding leaves doubt about
    /// its side.
    fn certain_height(&self, hit: &RayOrigin<'_>) -> Option<f64> {
        let (way, size) = hit.point.seen_from(self.point);
        let height = self.normal.dot(way);
        let is_certain = height.abs() > HEIGHT * size + self.slack + hit.rounding();
        is_certain.then_some(height)
    }

    /// Whether a ray leaves a hit so close to the plane that its side of it is not measured.
    #[must_use]
    pub fn is_next_to_start(&self, ray: &Ray) -> bool {
        let ray_origin = ray.spawned_from;
        ray_origin.is_some_and(|ray_origin| self.certain_height(ray_origin).is_none())
    }
}
