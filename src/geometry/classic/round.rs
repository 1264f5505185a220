//! Spheres and ellipsoids by the textbook's quadratic.

use glam::DVec3;

use super::{ClassicHit, ClassicRay};
use crate::geometry::round::Round;
use crate::geometry::{Ellipsoid, Sphere};
use crate::math::classic::{Scalar, Vector};

/// The distances at which a line enters and leaves a sphere around the origin.
///
/// A line that only touches misses. The roots are those of `a t² + 2 b t + c = 0` with `a = d·d`,
/// `b = o·d`, `c = o·o − r²` (Whitted 1980, "An improved illumination model for shaded display").
/// Far away, `b²` and `a c` are large and nearly equal, so the discriminant `b² − a c` cancels.
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

/// The nearer root if it counts; the other one for a ray that can be inside.
fn nearest<T: Scalar>([near, far]: [T; 2], entered: bool, counts: impl Fn(T) -> bool) -> Option<T> {
    if counts(near) {
        return Some(near);
    }
    (entered && counts(far)).then_some(far)
}

/// The hit on a sphere.
#[inline]
pub(super) fn sphere<T: Scalar>(
    sphere: &Sphere,
    ray: &ClassicRay<T>,
    counts: impl Fn(T) -> bool,
) -> Option<ClassicHit<T>> {
    let center = Vector::of(sphere.center());
    let roots = roots(ray.origin - center, ray.dir, T::of(sphere.radius()))?;
    let t = nearest(roots, sphere.is_entered(), counts)?;
    let point = ray.at(t);
    Some(ClassicHit::new(t, point, (point - center).unit()))
}

/// The hit on an ellipsoid along the world's axes, in its unit sphere's space.
#[inline]
pub(super) fn ellipsoid<T: Scalar>(
    ellipsoid: &Ellipsoid,
    ray: &ClassicRay<T>,
    counts: impl Fn(T) -> bool,
) -> Option<ClassicHit<T>> {
    let [center, axes]: [Vector<T>; 2] = ellipsoid.extent().map(|it: DVec3| Vector::of(it));
    let origin = (ray.origin - center).over(axes);
    let roots = roots(origin, ray.dir.over(axes), T::one())?;
    let t = nearest(roots, ellipsoid.is_entered(), counts)?;
    let point = ray.at(t);
    let on_sphere = (point - center).over(axes);
    Some(ClassicHit::new(t, point, on_sphere.over(axes).unit()))
}
