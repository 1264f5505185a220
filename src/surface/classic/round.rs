//! Spheres and ellipsoids by the textbook's quadratic.

use glam::DVec3;

use super::Scalar;
use super::solid::{Meeting, Solid};
use super::vector::{Line, Vector};

/// The nearer root of `a t² + 2 b t + c = 0`, where the line through `origin` along `dir` enters a
/// sphere around the world's origin; a touch is a miss.
///
/// `a = d·d`, `b = o·d`, `c = o·o − r²` and the discriminant `b² − a c` (Whitted 1980, "An improved
/// illumination model for shaded display", and every textbook since). Far away, `b²` and `a c` are
/// large and nearly equal, and what they differ by is lost.
fn enters<T: Scalar>(origin: Vector<T>, dir: Vector<T>, radius: T) -> Option<T> {
    let a = dir.dot(dir);
    let b = origin.dot(dir);
    let c = origin.dot(origin) - radius * radius;
    let discriminant = b * b - a * c;
    (discriminant > T::zero()).then(|| (-b - discriminant.sqrt()) / a)
}

/// A sphere, seen from outside.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sphere<T> {
    center: Vector<T>,
    radius: T,
}

impl<T: Scalar> Sphere<T> {
    pub(super) fn of(center: DVec3, radius: f64) -> Self {
        Self {
            center: Vector::of(center),
            radius: T::of(radius),
        }
    }
}

impl<T: Scalar> Solid<T> for Sphere<T> {
    #[inline]
    fn meets(&self, line: &Line<T>, counts: impl Fn(T) -> bool) -> Option<Meeting<T>> {
        let t = enters(line.origin - self.center, line.dir, self.radius)?;
        counts(t).then(|| {
            let point = line.at(t);
            Meeting {
                t,
                point,
                normal: (point - self.center).unit(),
                lasthit: [T::zero(); 2],
            }
        })
    }
}

/// An ellipsoid along the world's axes, seen from outside.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ellipsoid<T> {
    center: Vector<T>,
    axes: Vector<T>,
}

impl<T: Scalar> Ellipsoid<T> {
    pub(super) fn of(center: DVec3, axes: DVec3) -> Self {
        Self {
            center: Vector::of(center),
            axes: Vector::of(axes),
        }
    }
}

impl<T: Scalar> Solid<T> for Ellipsoid<T> {
    /// In the space where the ellipsoid is the unit sphere, and `t` is what it was.
    #[inline]
    fn meets(&self, line: &Line<T>, counts: impl Fn(T) -> bool) -> Option<Meeting<T>> {
        let origin = (line.origin - self.center).over(self.axes);
        let t = enters(origin, line.dir.over(self.axes), T::one())?;
        counts(t).then(|| {
            let point = line.at(t);
            let on_sphere = (point - self.center).over(self.axes);
            Meeting {
                t,
                point,
                normal: on_sphere.over(self.axes).unit(),
                lasthit: [T::zero(); 2],
            }
        })
    }
}
