//! Pixel footprints on surfaces.

use glam::{DVec2, DVec3};

/// The footprint of a pixel on a plane: the image of the centred unit square.
///
/// The point `(s, t)` of the square lies at `x/w, y/w` on the plane. There `(x, y, w)` is `center`
/// plus `s` and `t` times the two steps: a projective map (Heckbert 1989, "Fundamentals of Texture
/// Mapping and Image Warping"). Points with `w ≤ 0` are beyond the horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// The middle of the square.
    pub center: DVec3,
    /// The change for one step to the right and for one step up in the square.
    pub steps: [DVec3; 2],
}

/// A footprint to first order: a point, and its change from pixel to pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// The point at the pixel's middle.
    pub place: DVec2,
    /// The change of the point to the next pixel on the right and to the one above.
    pub steps: [DVec2; 2],
}

impl Footprint {
    /// The same footprint in other units of length.
    #[must_use]
    pub fn over(self, unit: DVec2) -> Self {
        let over = |image: DVec3| image / unit.extend(1.0);
        Self {
            center: over(self.center),
            steps: self.steps.map(over),
        }
    }

    /// The image of a point in the square.
    #[must_use]
    pub fn image(&self, place: DVec2) -> DVec3 {
        let [right, up] = self.steps;
        self.center + right * place.x + up * place.y
    }

    /// The footprint to first order, from its middle.
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
    /// The same in other units of length.
    #[must_use]
    pub fn over(self, unit: DVec2) -> Self {
        Self {
            place: self.place / unit,
            steps: self.steps.map(|step| step / unit),
        }
    }

    /// The longer axis of the image of a circle, and the length of the shorter one.
    ///
    /// The circle has diameter 1; the lengths are the singular values of the two steps.
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
        // The one of two equal directions that does not cancel.
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
