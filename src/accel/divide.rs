//! Planes between lamps and the round things next to them.

use glam::DVec3;

use super::shields::BLUR;
use crate::math::exact::{Exact, ExactVector, Sign};
use crate::math::{Flat, Point, direction};

/// A plane that has a round thing behind it and a lamp before it, both of which may touch it.
///
/// From a place that is clearly before it, too, the thing hides nothing of the lamp, even if the two
/// touch. Let the place be `h` above the plane, and the way to a point of the lamp no longer than `D`.
/// That way does not go below the plane. Let the ray that is asked be within `ε` of it, which is what
/// rounding makes of it. If it enters a ball of radius `r` below the plane, its foot `F` from the
/// centre `C` is in the ball, and no more than `ε` below the plane; so `F − C` rises by `r − ε` at least,
/// and leads aside by `√(2 r ε)` at most. The ray's direction falls by `h/D`, but for rounding; and as
/// it is at right angles to `F − C`, `(r − ε) h/D ≤ √(2 r ε)`. If `h² r > 8 ε D²`, that is not so: then the
/// foot is not before the ray's end, and what is only entered beyond that hides nothing.
///
/// An ellipsoid is a ball of radius 1 in a space where no length is divided by less than its shortest
/// half axis, and no height by more than its longest: `h² short³/long² > 8 ε D²`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Divide {
    point: DVec3,
    normal: DVec3,
    /// How far the point, and what it is a plane of, can be off.
    slack: f64,
    /// `short³/long²`.
    thickness: f64,
    /// The sum of all lengths that it is made of.
    size: f64,
}

impl Divide {
    /// The plane of a lamp, for something round with this centre and these half axes that is behind it
    /// or touches it.
    pub(super) fn of_pane(flat: &Flat, reach: f64, [center, axes]: [DVec3; 2]) -> Self {
        let lamp = Point::exact(flat.point).size() + reach;
        Self {
            point: flat.point,
            normal: flat.normal,
            slack: flat.slack(),
            thickness: thickness(axes),
            size: lamp + Point::exact(center).size() + axes.element_sum(),
        }
    }

    /// A plane between a lamp that is a ball and the ball around something round; `None` if they
    /// overlap.
    pub(super) fn of_globe(globe: (DVec3, f64), [center, axes]: [DVec3; 2]) -> Option<Self> {
        let radius = axes.max_element();
        let way = &ExactVector::from(globe.0) - &ExactVector::from(center);
        let radii = &Exact::from(globe.1) + &Exact::from(radius);
        let gap = &way.dot(&way) - &radii.squared();
        (gap.sign() != Sign::Negative).then(|| {
            let normal = direction(way.rounded());
            Self {
                point: center + normal * radius,
                normal,
                slack: 0.0,
                thickness: thickness(axes),
                size: Point::exact(globe.0).size()
                    + globe.1
                    + Point::exact(center).size()
                    + axes.element_sum(),
            }
        })
    }

    /// Whether a place that is off by so much is before the plane for certain, so that the thing hides
    /// nothing of the lamp from there.
    pub(super) fn has_before_it(&self, place: &Point, astray: f64) -> bool {
        let (way, length) = place.seen_from(self.point);
        let size = length + self.size;
        let doubt = BLUR * size + 8.0 * (astray + self.slack);
        let height = self.normal.dot(way) - doubt;
        height > 0.0 && height * height * self.thickness > doubt * size * size
    }
}

fn thickness(axes: DVec3) -> f64 {
    let (short, long) = (axes.min_element(), axes.max_element());
    short * (short / long) * (short / long)
}
