//! The numbers of the classic algorithm, and its tolerances.

use std::fmt::Debug;

use num_traits::Float;

/// A floating-point number: `f64` or `f32`.
pub trait Scalar: Float + Debug + Send + Sync + 'static {
    /// The least distance of a hit, and of an occluder before a light; world units.
    ///
    /// A ray that leaves a surface hits it again at a distance that is mere rounding. The classic
    /// algorithm ignores nearer hits. If the offset is too small, surfaces shadow and mirror
    /// themselves in specks. If it is too large, contact shadows and thin gaps vanish. No number
    /// suits every scene, because rounding grows with the coordinates.
    // These are the smallest in common use. For coordinates of about 10 and a ray that leaves a
    // plane at one degree, rounding is 10⁻¹³ in f64, where programs use 10⁻³ to 10⁻⁹. It is near
    // 10⁻⁴ in f32, where programs use 10⁻³ or 10⁻⁴.
    const OFFSET: Self;

    /// The determinant, an area, below which a ray is parallel to a triangle.
    ///
    /// If it is too small, the quotients are noise. If it is too large, small triangles vanish.
    /// Published programs use from 10⁻⁶ (Möller and Trumbore 1997) down to the machine epsilon, the
    /// value here.
    const PARALLEL: Self;

    /// The nearest number of this type.
    fn of(number: f64) -> Self;

    /// The same number in 64 bits.
    fn wide(self) -> f64;

    /// The angle of the point (x, y), the same on every machine.
    fn angle(y: Self, x: Self) -> Self;

    /// The angle with this sine, the same on every machine.
    fn angle_of_sine(sine: Self) -> Self;

    /// C's `(int)`: towards zero.
    ///
    /// Cases that C leaves undefined give the nearest `int`, and 0 for not-a-number.
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
