//! Where a line passes through a ball.

use glam::DVec3;

use crate::math::Decisions;
use crate::math::error_bounds::{UNDERFLOW, UNIT};
use crate::math::exact::{Distance, Exact, Sign};

/// A line and a ball around the origin, seen from the ray's origin.
///
/// With `a = d·d`, half of the chord is `√((r² − |c − (c·d/a) d|²)/a)`: the distance of the line
/// from the centre does not cancel, however far away the ray's origin is (Haines, Günther and
/// Akenine-Möller 2019, "Precision Improvements for Ray/Sphere Intersection").
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    /// `−c·d/a`: how far ahead the line is nearest to the centre.
    ahead: f64,
    /// The square of half the chord, not divided by `a`; not positive where the line passes by.
    half_squared: f64,
    /// `d·d`.
    speed_squared: f64,
    /// How far at most `c·d/a` is from the exact value, in units of `|d|`.
    doubt: f64,
    /// How far at most `half_squared` is from the exact value.
    half_squared_doubt: f64,
}

/// How far rounding puts a chord off, in units of `size`.
///
/// Let every component of `c` have `o` roundings, and of `d` have `e`. The product `c·d` has `o + e + 3`, `a` has
/// `2e + 3`, and with the division that makes `f = c·d/a` off by `(o + 3e + 7) u`, in units of a direction of unit
/// length. One more is for the sum with half the chord, and one, there as everywhere, for the rounding of the
/// bound itself.
///
/// Whatever `f` is off by, `δ`, it moves the foot `p = c − f d` along the line, at right angles to where it ought
/// to be, and so counts by its square only. In other directions `p` is off by `η`: the roundings of `c` and of
/// `d`, the product and the difference, `(o + e + 2) u`. So `|p|²` is off by `η (2|p| + η) + |δ d|²`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Roundings {
    /// What `f` is off by, and the sum.
    along: f64,
    /// What the foot is off by across the line.
    across: f64,
}

impl Roundings {
    /// Of a ball as it is: `c` is rounded twice and `d` is exact; but `a` is said to be 1, so that `f` is off
    /// by 8 u for the length of `d`, where others have 4 for `a` and the division.
    pub(super) const OF_BALL: Self = Self {
        along: 15.0 * UNIT,
        across: 5.0 * UNIT,
    };

    /// Of an ellipsoid in the space where it is a ball: both are multiplied by the reciprocals of the axes,
    /// one more. That these are rounded, too, is as if the axes were: the same for `c` and `d`.
    pub(super) const OF_ELLIPSOID: Self = Self {
        along: 15.0 * UNIT,
        across: 7.0 * UNIT,
    };
}

/// The quadratic equation `a t² − 2 b t + c = 0` of the distances at which a ray meets a round
/// surface, exactly.
#[derive(Debug)]
pub(super) struct Quadratic {
    pub(super) a: Exact,
    pub(super) b: Exact,
    pub(super) c: Exact,
    /// How far at most the ray's origin is from where it ought to be.
    pub(super) rounding: f64,
}

impl Chord {
    /// The chord of a line from `origin`, a vector from the centre, along `dir`; `None` where the
    /// line certainly leads away from the ball or passes by.
    ///
    /// `size` bounds the sum of the lengths that `origin` was computed from.
    #[inline(always)]
    pub(super) fn new(
        origin: DVec3,
        size: f64,
        dir: DVec3,
        speed_squared: f64,
        radius: f64,
        roundings: Roundings,
    ) -> Option<Self> {
        // The terms of the discriminant `(c·d)² − a (c·c − r²)` have up to 21 roundings.
        const OF_DISCRIMINANT: f64 = 64.0 * UNIT;
        let along = origin.dot(dir);
        // Most lines pass by so clearly that even the cancelling form says so. No term of it is
        // larger than `a (size² + r²)`.
        let discriminant =
            along * along - speed_squared * (origin.length_squared() - radius * radius);
        let largest = speed_squared * (size * size + radius * radius);
        if discriminant < -OF_DISCRIMINANT * largest {
            return None;
        }
        // With a direction longer than 1, `along` is larger as well, and so is what it is off by.
        if along > roundings.along * size * dir.abs().element_sum() {
            return None;
        }
        Some(Self::of_line(
            origin,
            size,
            dir,
            speed_squared,
            radius,
            roundings,
        ))
    }

    /// The chord of a line, whichever way it leads.
    #[inline(always)]
    pub(super) fn of_line(
        origin: DVec3,
        size: f64,
        dir: DVec3,
        speed_squared: f64,
        radius: f64,
        roundings: Roundings,
    ) -> Self {
        let (doubt, across) = (roundings.along * size, roundings.across * size);
        let foot = origin.dot(dir) / speed_squared;
        let nearest = origin - dir * foot;
        let (nearest_squared, radius_squared) = (nearest.length_squared(), radius * radius);
        Self {
            ahead: -foot,
            half_squared: radius_squared - nearest_squared,
            speed_squared,
            doubt,
            half_squared_doubt: of_squares(nearest_squared + radius_squared, across, radius)
                + doubt * doubt,
        }
    }

    /// The distance at which the line enters the ball, and how far at most it is from the exact
    /// one; `None` if the line passes by or only touches, or starts inside or leads away.
    ///
    /// `astray` bounds how far the ray's origin can be from where it ought to be.
    #[inline(always)]
    pub(super) fn entry(
        &self,
        astray: f64,
        equation: impl FnOnce() -> Quadratic,
    ) -> Option<(f64, f64)> {
        if self.half_squared < -self.half_squared_doubt {
            return None;
        }
        if self.half_squared > self.half_squared_doubt {
            let speed = self.speed_squared.sqrt();
            let half = self.half_squared.sqrt();
            let (t, error) = (self.ahead - half / speed, self.error(half, speed));
            if t > error + astray / speed {
                return Some((t, error));
            }
            if t < -error - astray / speed {
                return None;
            }
        }
        self.exact_entry(equation)
    }

    /// [`entry`](Self::entry) where rounded values leave doubt.
    ///
    /// A ray that starts on something that touches the ball is not inside of it.
    #[cold]
    #[inline(never)]
    fn exact_entry(&self, equation: impl FnOnce() -> Quadratic) -> Option<(f64, f64)> {
        let Quadratic { a, b, c, rounding } = equation();
        let discriminant = &b.squared() - &(&a * &c);
        Decisions::note(discriminant.sign() == Sign::Zero);
        let speed = self.speed_squared.sqrt();
        let half = self.half_squared.max(0.0).sqrt();
        let (t, error) = (self.ahead - half / speed, self.error(half, speed));
        let close = rounding > 0.0 && t.abs() <= error + rounding / speed;
        let met = (c.sign() == Sign::Positive || close)
            && b.sign() == Sign::Positive
            && discriminant.sign() == Sign::Positive;
        met.then(|| (above_zero(t), error))
    }

    /// The distance at which a line from inside comes out, and how far at most it is from the
    /// exact one.
    ///
    /// What starts inside comes out ahead, even if rounding has put its start outside.
    pub(super) fn exit(&self) -> (f64, f64) {
        let speed = self.speed_squared.sqrt();
        let half = self.half_squared.max(0.0).sqrt();
        let t = self.ahead + half / speed;
        (above_zero(t), self.error(half, speed))
    }

    /// The same for a line that starts on the ball and leads inside: the whole chord is twice the
    /// way to its middle. Nothing cancels, and the start itself is no solution.
    pub(super) fn whole(&self) -> (f64, f64) {
        let error = self.doubt / self.speed_squared.sqrt();
        (above_zero(2.0 * self.ahead), 2.0 * error)
    }

    /// How far at most the distances of both ends are off.
    pub(super) fn error_of_end(&self) -> f64 {
        self.error(self.half_squared.max(0.0).sqrt(), self.speed_squared.sqrt())
    }

    /// How far at most the distance is off.
    ///
    /// `|√(x + e) − √x|` is at most `|e| / (√x + √(x − |e|))`, and `√(x − |e|)` no less than `√x − |e|/√x`;
    /// nor is it ever more than `√|e|`. Eight more in half of the chord are for both roots, for `a`, for the
    /// division and the sum.
    fn error(&self, half: f64, speed: f64) -> f64 {
        let off = self.half_squared_doubt;
        let of_half = if half * half > off {
            off * half / (2.0 * half * half - off)
        } else {
            off.sqrt()
        };
        (self.doubt + of_half + 8.0 * UNIT * half) / speed
    }
}

impl Quadratic {
    /// The distance at which the ray enters; of use only where it does.
    pub(super) fn entry(self) -> Option<Distance> {
        Some(Distance::smaller_root(self.a, self.b, &self.c))
    }

    /// The distance at which a ray from inside comes out.
    pub(super) fn exit(self) -> Option<Distance> {
        if (&self.b.squared() - &(&self.a * &self.c)).sign() == Sign::Negative {
            // Rounding has put the start outside, and the line past the ball.
            return Some(Distance::quotient(self.b, self.a));
        }
        Some(Distance::larger_root(self.a, self.b, &self.c))
    }

    /// The distance at which a ray that starts on the surface, `c = 0`, comes out.
    pub(super) fn whole(self) -> Option<Distance> {
        Some(Distance::quotient(&self.b + &self.b, self.a))
    }
}

/// The sign of `|origin|² − r²`: negative inside of a ball; `None` where rounding leaves doubt.
///
/// `size` and `origin` are as for a [`Chord`]; `rounding` bounds how far the origin can be from
/// where it ought to be.
pub(super) fn side_of_ball(
    origin: DVec3,
    size: f64,
    rounding: f64,
    radius: f64,
    roundings: Roundings,
) -> Option<Sign> {
    let (squared, radius_squared) = (origin.length_squared(), radius * radius);
    let doubt = of_squares(
        squared + radius_squared,
        roundings.across * size + rounding,
        radius,
    );
    let height = squared - radius_squared;
    (height.abs() > doubt).then(|| Sign::of(height))
}

/// How far at most the difference of `x²` and `r²` is from the exact one, if their sum is this and
/// `x` is off by `doubt` at most.
#[inline(always)]
fn of_squares(squares: f64, doubt: f64, radius: f64) -> f64 {
    // A square changes by δ (2|x| + δ), and 2|x| ≤ x²/r + r. The sum of squares has three roundings, and the
    // difference one. And a ball's r² has one, while an ellipsoid's axes may be off by u, and so its square by 2 u.
    doubt * (squares / radius + doubt) + 5.0 * UNIT * squares
}

/// A distance that is known to be above zero.
fn above_zero(t: f64) -> f64 {
    t.max(f64::from_bits(1))
}

/// Whether a place lies beyond the point at which a line is nearest to a ball's centre; the sum of
/// `parts` leads there from the centre, and `exact` is its scalar product with the line's direction.
#[inline]
pub(super) fn is_beyond(parts: [DVec3; 2], dir: DVec3, exact: impl FnOnce() -> Exact) -> bool {
    // Two roundings in the way and, in the space of an ellipsoid, two in both; a product and two
    // sums.
    const ROUNDINGS: f64 = 9.0 * UNIT;
    let [near, far] = parts;
    let along = (near + far).dot(dir);
    if along.abs() > ROUNDINGS * (near.abs() + far.abs()).dot(dir.abs()) + UNDERFLOW {
        return along > 0.0;
    }
    let along = exact();
    Decisions::note(along.sign() == Sign::Zero);
    along.sign() == Sign::Positive
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
                rounding: 0.0,
            }
        };
        let size = origin.abs().element_sum();
        let chord = Chord::new(origin, size, dir, 1.0, 1.0, Roundings::OF_BALL)?;
        chord.entry(0.0, equation).map(|(t, _)| t)
    }

    #[test]
    fn the_near_side_is_hit_and_a_touch_is_a_miss() {
        assert_eq!(entry([0.0, 0.0, 5.0]), Some(4.0));
        assert_eq!(entry([1.0, 0.0, 5.0]), None);
        assert_eq!(entry([0.0, 0.0, 0.0]), None);
        // On the ball itself the distance is zero, which does not count.
        assert_eq!(entry([0.0, 0.0, 1.0]), None);
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
