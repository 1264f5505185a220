//! What a pixel covers of a surface.

use glam::{DVec2, DVec3};

/// What a pixel covers of a plane: the image of a square of side 1 around the origin.
///
/// The square's place `(s, t)` lies at `x/w, y/w` on the plane, where `(x, y, w)` is `center` plus
/// `s` and `t` times the two steps: a projective map (Heckbert 1989, "Fundamentals of Texture Mapping
/// and Image Warping"). Places with `w` not above zero are beyond the horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// The middle of the square.
    pub center: DVec3,
    /// What one step to the right and one upwards in the square add.
    pub steps: [DVec3; 2],
}

/// A place on a surface, and how far a pixel reaches from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// The place that the pixel's middle shows.
    pub place: DVec2,
    /// The way from there to what the next pixel on the right and the one above would show, if it
    /// went on evenly.
    pub steps: [DVec2; 2],
}

impl Footprint {
    /// The same on a plane with other units of length.
    #[must_use]
    pub fn over(self, unit: DVec2) -> Self {
        let over = |image: DVec3| image / unit.extend(1.0);
        Self {
            center: over(self.center),
            steps: self.steps.map(over),
        }
    }

    /// The image of a place in the square.
    #[must_use]
    pub fn image(&self, place: DVec2) -> DVec3 {
        let [right, up] = self.steps;
        self.center + right * place.x + up * place.y
    }

    /// The footprint where it is smallest: to first order, from its middle.
    #[must_use]
    pub fn spread(&self) -> Spread {
        let depth = self.center.z;
        let place = self.center.truncate() / depth;
        let steps = self.steps;
        Spread {
            place,
            steps: steps.map(|step| (step.truncate() - place * step.z) / depth),
        }
    }
}

impl Spread {
    /// The same with other units of length.
    #[must_use]
    pub fn over(self, unit: DVec2) -> Self {
        Self {
            place: self.place / unit,
            steps: self.steps.map(|step| step / unit),
        }
    }

    /// The longer axis of the ellipse that a circle of diameter 1 in the square becomes, and the length of the
    /// shorter one: the singular values of the two steps.
    #[must_use]
    pub fn axes(&self) -> (DVec2, f64) {
        let [right, up] = self.steps;
        // The matrix of the steps times its transpose.
        let xx = right.x * right.x + up.x * up.x;
        let xy = right.x * right.y + up.x * up.y;
        let yy = right.y * right.y + up.y * up.y;
        let half = (xx - yy) / 2.0;
        let squared = (xx + yy) / 2.0 + (half * half + xy * xy).sqrt();
        let long = squared.sqrt();
        // Of two forms of the same direction, the one that does not cancel.
        let along = if xx >= yy {
            DVec2::new(squared - yy, xy)
        } else {
            DVec2::new(xy, squared - xx)
        };
        let along = along.try_normalize().unwrap_or(DVec2::X);
        let short = right.perp_dot(up).abs() / long;
        (along * long, if short.is_nan() { 0.0 } else { short })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_of_a_turned_ellipse() {
        let (long, short) = Spread {
            place: DVec2::ZERO,
            steps: [DVec2::new(3.0, 3.0), DVec2::new(-1.0, 1.0)],
        }
        .axes();
        assert!((long.length() - 18f64.sqrt()).abs() < 1e-12, "{long}");
        assert!((long.x - long.y).abs() < 1e-12, "{long}");
        assert!((short - 2f64.sqrt()).abs() < 1e-12, "{short}");
    }

    #[test]
    fn the_first_order_of_a_projective_map() {
        let footprint = Footprint {
            center: DVec3::new(4.0, 6.0, 2.0),
            steps: [DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.0, 1.0, -0.5)],
        };
        let Spread { place, steps } = footprint.spread();
        assert_eq!(place, DVec2::new(2.0, 3.0));
        assert_eq!(steps, [DVec2::new(0.5, 0.0), DVec2::new(0.5, 1.25)]);
    }
}
