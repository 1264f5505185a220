//! Spheres and ellipsoids by the textbook's quadratic.

use glam::DVec3;

use super::Scalar;
use super::solid::{Meeting, Solid};
use super::vector::{Line, Vector};

/// The roots of `a t² + 2 b t + c = 0`, where the line through `origin` along `dir` enters and leaves
/// a sphere around the world's origin; a touch is a miss.
///
/// `a = d·d`, `b = o·d`, `c = o·o − r²` and the discriminant `b² − a c` (Whitted 1980, "An improved
/// illumination model for shaded display", and every textbook since). Far away, `b²` and `a c` are
/// large and nearly equal, and what they differ by is lost.
fn roots<T: Scalar>(origin: Vector<T>, dir: Vector<T>, radius: T) -> Option<[T; 2]> {
    let a = dir.dot(dir);
    let b = origin.dot(dir);
    let c = origin.dot(origin) - radius * radius;
    let discriminant = b * b - a * c;
    (discriminant > T::zero()).then(|| {
        let root = discriminant.sqrt();
        [(-b - root) / a, (-b + root) / a]
    })
}

/// The nearer root if it counts; from inside, if rays can be there, the other one.
fn meets<T: Scalar>([near, far]: [T; 2], entered: bool, counts: impl Fn(T) -> bool) -> Option<T> {
    if counts(near) {
        return Some(near);
    }
    (entered && counts(far)).then_some(far)
}

/// A sphere, seen from outside, and from inside too if it is entered.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sphere<T> {
    center: Vector<T>,
    radius: T,
    entered: bool,
}

impl<T: Scalar> Sphere<T> {
    pub(super) fn of(center: DVec3, radius: f64, entered: bool) -> Self {
        Self {
            center: Vector::of(center),
            radius: T::of(radius),
            entered,
        }
    }
}

impl<T: Scalar> Solid<T> for Sphere<T> {
    #[inline]
    fn meets(&self, line: &Line<T>, counts: impl Fn(T) -> bool) -> Option<Meeting<T>> {
        let roots = roots(line.origin - self.center, line.dir, self.radius)?;
        let t = meets(roots, self.entered, counts)?;
        let point = line.at(t);
        Some(Meeting {
            t,
            point,
            normal: (point - self.center).unit(),
            lasthit: [T::zero(); 2],
        })
    }
}

/// An ellipsoid along the world's axes, seen as a sphere is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ellipsoid<T> {
    center: Vector<T>,
    axes: Vector<T>,
    entered: bool,
}

impl<T: Scalar> Ellipsoid<T> {
    pub(super) fn of(center: DVec3, axes: DVec3, entered: bool) -> Self {
        Self {
            center: Vector::of(center),
            axes: Vector::of(axes),
            entered,
        }
    }
}

impl<T: Scalar> Solid<T> for Ellipsoid<T> {
    /// In the space where the ellipsoid is the unit sphere, and `t` is what it was.
    #[inline]
    fn meets(&self, line: &Line<T>, counts: impl Fn(T) -> bool) -> Option<Meeting<T>> {
        let origin = (line.origin - self.center).over(self.axes);
        let roots = roots(origin, line.dir.over(self.axes), T::one())?;
        let t = meets(roots, self.entered, counts)?;
        let point = line.at(t);
        let on_sphere = (point - self.center).over(self.axes);
        Some(Meeting {
            t,
            point,
            normal: on_sphere.over(self.axes).unit(),
            lasthit: [T::zero(); 2],
        })
    }
}
