//! Chords: the intersections of a line and a sphere.

use glam::DVec3;

use crate::math::Decisions;
use crate::math::error_bounds::{
    BALL_ACROSS, BALL_ALONG, DISCRIMINANT, ELLIPSOID_ACROSS, ELLIPSOID_ALONG, HALF_CHORD, NEAREST,
    SQUARES, UNDERFLOW,
};
use crate::math::exact::{Distance, Exact, Sign};

/// The chord of a line in a sphere around the origin.
///
/// With `a = d·d`, half of the chord is `√((r² − |c − (c·d/a) d|²)/a)`. The distance of the line
/// from the centre does not cancel, however far away the ray's origin is (Haines, Günther and
/// Akenine-Möller 2019, "Precision Improvements for Ray/Sphere Intersection").
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    /// The distance of the chord's middle, `−c·d/a`.
    ahead: f64,
    /// The square of half the chord, times `a`; not positive for a line that misses.
    half_squared: f64,
    /// `d·d`.
    speed_squared: f64,
    /// The error bound of `c·d/a`, in units of `|d|`.
    ahead_error: f64,
    /// The error bound of `half_squared`.
    half_squared_error: f64,
}

/// The rounding errors of a chord, in units of `size`.
// An error δ of f = c·d/a moves the foot p = c − f d along the line, at right angles to its true
// position, and so counts by its square only. In other directions p has an error η from the
// roundings of c and d, the product and the difference. So |p|² is off by η (2|p| + η) + |δ d|².
#[derive(Debug, Clone, Copy)]
pub(super) struct Roundings {
    /// The error of `f` and of the sum with half the chord.
    along: f64,
    /// The error of the foot across the line.
    across: f64,
}

impl Roundings {
    /// The errors for a sphere, with `a` taken to be 1.
    pub(super) const OF_BALL: Self = Self {
        along: BALL_ALONG,
        across: BALL_ACROSS,
    };

    /// The errors for an ellipsoid, in the space where it is a sphere.
    pub(super) const OF_ELLIPSOID: Self = Self {
        along: ELLIPSOID_ALONG,
        across: ELLIPSOID_ACROSS,
    };
}

/// The exact equation `a t² − 2 b t + c = 0` of the distances of a round surface.
#[derive(Debug)]
pub(super) struct Quadratic {
    pub(super) a: Exact,
    pub(super) b: Exact,
    pub(super) c: Exact,
    /// The error bound of the ray's origin.
    pub(super) rounding: f64,
}

impl Chord {
    /// The chord of a line from `origin`, a vector from the centre, along `dir`.
    ///
    /// `None` if the line certainly misses the sphere or leads away from it. `size` bounds the sum
    /// of the lengths that `origin` was computed from.
    #[inline(always)]
    pub(super) fn new(
        origin: DVec3,
        size: f64,
        dir: DVec3,
        speed_squared: f64,
        radius: f64,
        roundings: Roundings,
    ) -> Option<Self> {
        let along = origin.dot(dir);
        // Most lines miss so clearly that even the cancelling form decides. No term of it is
        // larger than a (size² + r²).
        let discriminant =
            along * along - speed_squared * (origin.length_squared() - radius * radius);
        let largest = speed_squared * (size * size + radius * radius);
        if discriminant < -DISCRIMINANT * largest {
            return None;
        }
        // With a direction longer than 1, `along` is larger as well, and so is its error.
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

    /// The chord of a line, also if it leads away.
    #[inline(always)]
    pub(super) fn of_line(
        origin: DVec3,
        size: f64,
        dir: DVec3,
        speed_squared: f64,
        radius: f64,
        roundings: Roundings,
    ) -> Self {
        let (along, across) = (roundings.along * size, roundings.across * size);
        let foot = origin.dot(dir) / speed_squared;
        let nearest = origin - dir * foot;
        let (nearest_squared, radius_squared) = (nearest.length_squared(), radius * radius);
        Self {
            ahead: -foot,
            half_squared: radius_squared - nearest_squared,
            speed_squared,
            ahead_error: along,
            half_squared_error: of_squares(nearest_squared + radius_squared, across, radius)
                + along * along,
        }
    }

    /// The distance at which the line enters the sphere, and its error bound.
    ///
    /// `None` if the line misses, touches, starts inside or leads away. `origin_error` bounds the
    /// error of the ray's origin.
    #[inline(always)]
    pub(super) fn entry(
        &self,
        origin_error: f64,
        equation: impl FnOnce() -> Quadratic,
    ) -> Option<(f64, f64)> {
        if self.half_squared < -self.half_squared_error {
            return None;
        }
        if self.half_squared > self.half_squared_error {
            let speed = self.speed_squared.sqrt();
            let half = self.half_squared.sqrt();
            let (t, error) = (self.ahead - half / speed, self.error(half, speed));
            if t > error + origin_error / speed {
                return Some((t, error));
            }
            if t < -error - origin_error / speed {
                return None;
            }
        }
        self.exact_entry(equation)
    }

    /// [`entry`](Self::entry) by exact arithmetic.
    // A ray that starts on a surface that touches the sphere is not inside of it.
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

    /// The distance at which a line from inside leaves, and its error bound.
    ///
    /// The distance is positive even if rounding has put the start outside.
    pub(super) fn exit(&self) -> (f64, f64) {
        let speed = self.speed_squared.sqrt();
        let half = self.half_squared.max(0.0).sqrt();
        let t = self.ahead + half / speed;
        (above_zero(t), self.error(half, speed))
    }

    /// The same for a line that starts on the sphere and leads inside.
    ///
    /// The chord is twice the distance to its middle. Nothing cancels, and the start is no
    /// solution.
    pub(super) fn whole(&self) -> (f64, f64) {
        let error = self.ahead_error / self.speed_squared.sqrt();
        (above_zero(2.0 * self.ahead), 2.0 * error)
    }

    /// The error bound of the distances of both ends.
    pub(super) fn error_of_end(&self) -> f64 {
        self.error(self.half_squared.max(0.0).sqrt(), self.speed_squared.sqrt())
    }

    /// The error bound of a distance.
    // |√(x + e) − √x| is at most |e| / (√x + √(x − |e|)), where √(x − |e|) is at least √x − |e|/√x.
    // It is never more than √|e|.
    fn error(&self, half: f64, speed: f64) -> f64 {
        let off = self.half_squared_error;
        let of_half = if half * half > off {
            off * half / (2.0 * half * half - off)
        } else {
            off.sqrt()
        };
        (self.ahead_error + of_half + HALF_CHORD * half) / speed
    }
}

impl Quadratic {
    /// The distance at which the ray enters; meaningless if it misses.
    pub(super) fn entry(self) -> Option<Distance> {
        Some(Distance::smaller_root(self.a, self.b, &self.c))
    }

    /// The distance at which a ray from inside leaves.
    pub(super) fn exit(self) -> Option<Distance> {
        if (&self.b.squared() - &(&self.a * &self.c)).sign() == Sign::Negative {
            // Rounding has put the start outside, and the line misses the sphere.
            return Some(Distance::quotient(self.b, self.a));
        }
        Some(Distance::larger_root(self.a, self.b, &self.c))
    }

    /// The distance at which a ray that starts on the surface, `c = 0`, leaves.
    pub(super) fn whole(self) -> Option<Distance> {
        Some(Distance::quotient(&self.b + &self.b, self.a))
    }
}

/// The sign of `|origin|² − r²`, negative inside; `None` if uncertain.
///
/// `size` and `origin` are as for a [`Chord`]; `rounding` bounds the error of the ray's origin.
pub(super) fn side_of_ball(
    origin: DVec3,
    size: f64,
    rounding: f64,
    radius: f64,
    roundings: Roundings,
) -> Option<Sign> {
    let (squared, radius_squared) = (origin.length_squared(), radius * radius);
    let bound = of_squares(
        squared + radius_squared,
        roundings.across * size + rounding,
        radius,
    );
    let height = squared - radius_squared;
    (height.abs() > bound).then(|| Sign::of(height))
}

/// The error bound of `x² − r²`, from the sum of both squares and the error of `x`.
#[inline(always)]
fn of_squares(squares: f64, error: f64, radius: f64) -> f64 {
    // A square changes by δ (2|x| + δ), and 2|x| ≤ x²/r + r.
    error * (squares / radius + error) + SQUARES * squares
}

/// A distance limited to numbers above zero.
fn above_zero(t: f64) -> f64 {
    t.max(f64::from_bits(1))
}

/// Returns whether a point is beyond the foot of a sphere's centre on a line.
///
/// The sum of `parts` leads from the centre to the point; `exact` is its product with `dir`.
#[inline]
pub(super) fn is_beyond(parts: [DVec3; 2], dir: DVec3, exact: impl FnOnce() -> Exact) -> bool {
    let [near, far] = parts;
    let along = (near + far).dot(dir);
    if along.abs() > NEAREST * (near.abs() + far.abs()).dot(dir.abs()) + UNDERFLOW {
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
        // On the sphere itself the distance is zero, which does not count.
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
