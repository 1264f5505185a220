//! The numbers that the classic algorithm is written in, and its tolerances.

use std::fmt::Debug;

use num_traits::Float;

/// A floating-point number: `f64` or `f32`.
pub trait Scalar: Float + Debug + Send + Sync + 'static {
    /// How far along a ray, in world units, a hit must lie to count; and how far before a light.
    ///
    /// A ray that leaves a surface finds it again at a distance that is mere rounding, so the
    /// classic algorithm ignores what is nearer than this. Smaller, and surfaces shadow and mirror
    /// themselves in specks; larger, and what really is near is lost: contact shadows, thin gaps,
    /// all of a scene whose unit of length is large. No number is right for every scene, since this
    /// one is absolute and rounding grows with the coordinates.
    ///
    /// These are the smallest in common use. Where coordinates are about 10 and a ray leaves a
    /// plane at an angle of one degree, rounding is 10⁻¹³ in `f64`, for which programs have from
    /// 10⁻³ to 10⁻⁹; it is near 10⁻⁴ in `f32`, for which they have 10⁻³ or 10⁻⁴.
    const OFFSET: Self;

    /// The determinant of a ray and a triangle's edges below which the ray counts as parallel.
    ///
    /// It has the unit of an area. Smaller, and the quotients by it are noise; larger, and small
    /// triangles vanish. Published programs have from 10⁻⁶ (Möller and Trumbore 1997) down to the
    /// machine's own epsilon, which is taken here.
    const PARALLEL: Self;

    /// The nearest number of this kind.
    fn of(number: f64) -> Self;

    /// The same number in 64 bits.
    fn wide(self) -> f64;

    /// The angle of the point (x, y), the same on every machine.
    fn angle(y: Self, x: Self) -> Self;

    /// The angle with this sine, the same on every machine.
    fn angle_of_sine(sine: Self) -> Self;

    /// C's `(int)`: towards zero. What C leaves undefined is the nearest `int`, and 0 for
    /// not-a-number.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "dropping the fraction is meant; casts from float saturate"
    )]
    fn int(self) -> i32 {
        self.wide() as i32
    }
}

impl Scalar for f64 {
    const OFFSET: Self = 1e-9;
    const PARALLEL: Self = Self::EPSILON;

    fn of(number: f64) -> Self {
        number
    }

    fn wide(self) -> f64 {
        self
    }

    fn angle(y: Self, x: Self) -> Self {
        libm::atan2(y, x)
    }

    fn angle_of_sine(sine: Self) -> Self {
        libm::asin(sine)
    }
}

impl Scalar for f32 {
    const OFFSET: Self = 1e-4;
    const PARALLEL: Self = Self::EPSILON;

    #[expect(clippy::cast_possible_truncation, reason = "rounding is meant")]
    fn of(number: f64) -> Self {
        number as Self
    }

    fn wide(self) -> f64 {
        f64::from(self)
    }

    fn angle(y: Self, x: Self) -> Self {
        libm::atan2f(y, x)
    }

    fn angle_of_sine(sine: Self) -> Self {
        libm::asinf(sine)
    }
}
