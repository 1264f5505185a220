//! Where a line passes through a ball.

use glam::DVec3;

use crate::math::Decisions;
use crate::math::band::UNIT;
use crate::math::exact::{Distance, Exact, Sign};

/// A line and a ball around the origin, seen from the ray's origin.
///
/// The half chord is `√(r² − |c − (c·d)d|²)`: the distance of the line from the centre does not
/// cancel, however far away the ray's origin is (Haines, Günther and Akenine-Möller 2019,
/// "Precision Improvements for Ray/Sphere Intersection").
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    /// `−c·d`: how far ahead the line is nearest to the centre.
    ahead: f64,
    /// The square of half the chord's length; not positive where the line passes by.
    half_squared: f64,
    /// How far at most `ahead` is from the exact value.
    doubt: f64,
    /// How far at most `half_squared` is from the exact value.
    half_squared_doubt: f64,
}

/// The quadratic equation `a t² − 2 b t + c = 0` of the distances at which a ray meets a round
/// surface, exactly.
#[derive(Debug)]
pub(super) struct Quadratic {
    pub(super) a: Exact,
    pub(super) b: Exact,
    pub(super) c: Exact,
}

impl Chord {
    /// The chord of a line from `origin`, a vector from the centre, with unit direction `dir`.
    ///
    /// `size` bounds the sum of the lengths that `origin` was computed from.
    pub(super) fn new(origin: DVec3, size: f64, dir: DVec3, radius: f64) -> Self {
        // Every component of `origin` has at most 5 roundings (in an ellipsoid's space, where
        // those of `dir` count too), the scalar product 3 more, the difference 3 more: no
        // component of `nearest` is further off than 12 u of `size`, nor is the whole vector than
        // 24 u.
        let doubt = 24.0 * UNIT * size;
        let along = origin.dot(dir);
        let nearest = origin - dir * along;
        let (nearest_squared, radius_squared) = (nearest.length_squared(), radius * radius);
        let squares = nearest_squared + radius_squared;
        Self {
            ahead: -along,
            half_squared: radius_squared - nearest_squared,
            doubt,
            // A square changes by δ (2|x| + δ), and 2|x| ≤ (x² + r²)/r.
            half_squared_doubt: doubt * (squares / radius + doubt) + 5.0 * UNIT * squares,
        }
    }

    /// The distance at which the line enters the ball, and how far at most it is from the exact
    /// one; `None` if the line passes by or only touches, or starts inside or leads away.
    ///
    /// `rounding` is how far the ray's origin can be from where it ought to be: one that starts on
    /// something that touches the ball is not inside of it.
    pub(super) fn entry(
        &self,
        rounding: f64,
        equation: impl FnOnce() -> Quadratic,
    ) -> Option<(f64, f64)> {
        if self.ahead < -self.doubt || self.half_squared < -self.half_squared_doubt {
            Decisions::filtered(1);
            return None;
        }
        if self.half_squared > self.half_squared_doubt {
            let half = self.half_squared.sqrt();
            let (t, error) = (self.ahead - half, self.error(half));
            if t > error + rounding {
                Decisions::filtered(3);
                return Some((t, error));
            }
            if t < -error - rounding {
                Decisions::filtered(3);
                return None;
            }
        }
        self.exact_entry(rounding, &equation())
    }

    /// [`entry`](Self::entry) where rounded values leave doubt.
    #[cold]
    fn exact_entry(&self, rounding: f64, equation: &Quadratic) -> Option<(f64, f64)> {
        let Quadratic { a, b, c } = equation;
        let discriminant = &b.squared() - &(a * c);
        Decisions::exact(discriminant.sign() == Sign::Zero);
        let half = self.half_squared.max(0.0).sqrt();
        let (t, error) = (self.ahead - half, self.error(half.max(f64::MIN_POSITIVE)));
        let outside = c.sign() == Sign::Positive || t.abs() <= error + rounding && rounding > 0.0;
        let met = outside && b.sign() == Sign::Positive && discriminant.sign() == Sign::Positive;
        met.then(|| (t.max(f64::from_bits(1)), error.min(2.0 * self.ahead.abs() + rounding)))
    }

    /// How far at most the distance is off, for a half chord that is not zero.
    fn error(&self, half: f64) -> f64 {
        // √(x + e) − √x ≤ e/√x, and no more than √e.
        let of_half = (self.half_squared_doubt / half).min(self.half_squared_doubt.sqrt());
        self.doubt + of_half + 2.0 * UNIT * (self.ahead.abs() + half)
    }
}

impl Quadratic {
    /// The distance at which the ray enters; of use only where it does.
    pub(super) fn entry(self) -> Option<Distance> {
        Some(Distance::smaller_root(self.a, self.b, &self.c))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::exact::ExactVector;

    fn entry(origin: [f64; 3]) -> Option<f64> {
        let (origin, dir) = (DVec3::from_array(origin), DVec3::NEG_Z);
        let equation = || {
            let (origin, dir) = (ExactVector::from(origin), ExactVector::from(dir));
            Quadratic {
                a: dir.dot(&dir),
                b: -&origin.dot(&dir),
                c: &origin.dot(&origin) - &Exact::from(1.0),
            }
        };
        let chord = Chord::new(origin, origin.abs().element_sum(), dir, 1.0);
        chord.entry(0.0, equation).map(|(t, _)| t)
    }

    #[test]
    fn the_near_side_is_hit_and_a_touch_is_a_miss() {
        assert_eq!(entry([0.0, 0.0, 5.0]), Some(4.0));
        assert_eq!(entry([1.0, 0.0, 5.0]), None);
        assert_eq!(entry([0.0, 0.0, 0.0]), None);
        assert_eq!(entry([0.0, 0.0, -5.0]), None);
    }

    #[test]
    fn one_rounding_beside_the_touch_decides_right() {
        for far in [2.0, 1e4, 1e8, 1e10] {
            assert!(entry([1.0f64.next_down(), 0.0, far]).is_some(), "{far}");
            assert_eq!(entry([1.0, 0.0, far]), None, "{far}");
            assert_eq!(entry([1.0f64.next_up(), 0.0, far]), None, "{far}");
        }
    }
}
