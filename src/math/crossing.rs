//! Crossings of lines and planes.

use glam::DVec3;

use super::error_bounds::{GRAZING, HEIGHT, QUOTIENT, SLOPE, UNDERFLOW};
use super::exact::Sign;
use super::{Decisions, Flat, Ray, RayOrigin, Segment, Side, Span};

/// The crossing of a line and a plane ahead, not yet divided: `t = height / slope`.
#[derive(Debug, Clone, Copy)]
pub struct Crossing {
    /// The vector from the plane's point to the ray's origin.
    pub origin: DVec3,
    /// The height of the plane above the origin, along the normal: `N = −n·c`.
    pub height: f64,
    /// The rise of the ray along the normal per unit of `t`: `D = n·d`.
    pub slope: f64,
    /// True if the ray rises along the normal: the exact sign of the slope.
    pub rises: bool,
    /// The error bound of `height`.
    pub doubt: f64,
    /// The error bound of the origin, if the origin lies within it of the plane.
    ///
    /// Such a ray crosses the plane at its start, and its line decides little there.
    pub at_start: Option<f64>,
    /// The kind of crossing, if the ray is nearly parallel to the plane.
    pub grazing: Option<Grazing>,
}

/// A crossing nearly along the plane; only exact arithmetic decides its borders.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grazing {
    /// The ray crosses the plane ahead.
    Ahead,
    /// Rounding has put the origin beyond a plane that the ray has not crossed yet.
    Behind,
}

impl Crossing {
    /// Returns whether borders are tested exactly even far from the rounded point.
    #[must_use]
    #[inline(always)]
    pub fn is_delicate(&self) -> bool {
        self.at_start.is_some() || self.grazing.is_some()
    }

    /// The distance of the crossing, above zero.
    #[must_use]
    pub fn distance(&self) -> f64 {
        const SMALLEST: f64 = f64::from_bits(1);
        // Within rounding of the plane, the height can have the wrong sign.
        (self.height / self.slope).max(SMALLEST)
    }

    /// Returns whether the crossing certainly lies beyond a span; needs no division.
    #[must_use]
    #[inline(always)]
    pub fn is_beyond(&self, span: Span) -> bool {
        // At the start, the height can have the wrong sign; no crossing is nearer then.
        let ahead = if self.rises {
            self.height
        } else {
            -self.height
        };
        ahead - self.doubt > span.max() * (self.slope.abs() + SLOPE)
    }

    /// The error bound of a distance.
    #[must_use]
    pub fn error(&self, t: f64) -> f64 {
        (self.doubt + SLOPE * t) / self.slope.abs() + QUOTIENT * t
    }
}

/// The least slope that is not [`GRAZING`] for any surface's normal in the plane.
const STEEP: f64 = GRAZING + 2.0 * SLOPE;

/// The error that rounded values do not decide.
#[derive(Debug, Clone, Copy)]
pub struct InDoubt;

impl Flat {
    /// The crossing of a segment whose ends are strictly on opposite sides.
    ///
    /// Only then can a surface in this plane occlude. `end` is the side of the segment's end.
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

    /// The crossing of a ray and the plane ahead; a ray along the plane has none.
    #[must_use]
    #[inline(always)]
    pub fn crossing(&self, ray: &Ray) -> Option<Crossing> {
        let certain = self.certain_crossing(ray);
        certain.unwrap_or_else(|InDoubt| self.doubtful_crossing(ray))
    }

    /// The crossing of a ray and the plane ahead, by rounded values.
    ///
    /// # Errors
    /// Returns [`InDoubt`] if the error bounds do not decide.
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

    /// The crossing of a ray and the plane ahead, where rounded values do not decide.
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
        // A slope too small for a double is still not zero.
        let steepness = exact.to_f64().abs().max(UNDERFLOW);
        ahead.then(|| Crossing {
            slope: if rises { steepness } else { -steepness },
            rises,
            at_start,
            grazing: self.grazing(ray, slope, rises, at_start),
            ..crossing
        })
    }

    /// The kind of crossing, if the ray is nearly parallel to the plane.
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
        // All surfaces in this plane have to decide alike.
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

    /// The side on which a ray starts, and the origin's error bound if inherited.
    ///
    /// A point within rounding of the plane inherits the side of the ray that arrived there.
    // The origin of a ray that leaves a surface is rounded, so close to this plane its own side
    // means nothing. The arriving ray did not cross the plane, so the origin has the side of that
    // ray's origin, which may in turn lie close to the plane. A ray that left this very plane is on
    // the side to which it went. Nothing leaks through the edges and corners of a room.
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

    /// The height of a hit above the plane; `None` if its sign is uncertain.
    fn certain_height(&self, hit: &RayOrigin<'_>) -> Option<f64> {
        let (way, size) = hit.point.seen_from(self.point);
        let height = self.normal.dot(way);
        let is_certain = height.abs() > HEIGHT * size + self.slack + hit.rounding();
        is_certain.then_some(height)
    }

    /// Returns whether a ray leaves a hit within rounding of the plane.
    #[must_use]
    pub fn is_next_to_start(&self, ray: &Ray) -> bool {
        let ray_origin = ray.spawned_from;
        ray_origin.is_some_and(|ray_origin| self.certain_height(ray_origin).is_none())
    }
}
