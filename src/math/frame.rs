//! Orthogonal axes in a plane.

use dashu_ratio::RBig;
use glam::DVec3;

use super::exact::{ExactVector, RationalVector};
use super::{Flat, Ray, unit};
use crate::language::ValueError;

/// The axes of a plane: `x` to the right, `y` upward, the normal to the viewer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Unit vector along which the plane's own x coordinate grows.
    pub x: DVec3,
    /// Unit vector along which the plane's own y coordinate grows: `normal × x`.
    pub y: DVec3,
}

impl Frame {
    /// The axes of the plane with this normal, from an `xdir` not along the normal.
    ///
    /// `xdir` is projected into the plane exactly. Both axes are then made unit and rounded once.
    ///
    /// # Errors
    /// Returns an error if `xdir` is zero or within 2⁻²⁰ rad, a fifth of a second, of the normal. A
    /// projection so short is mostly the rounding of its decimals.
    pub fn new(normal: DVec3, xdir: DVec3) -> Result<Self, ValueError> {
        Self::of(xdir, &ExactFrame::new(normal, xdir))
    }

    /// The rounded axes of an exact frame.
    pub(crate) fn of(xdir: DVec3, exact: &ExactFrame) -> Result<Self, ValueError> {
        let advice = "xdir is the direction in which the surface's own x grows, such as 1 0 0";
        let expected = "expected a direction that is not the normal's";
        let error = |reason: &str| ValueError::new("xdir", reason, advice).expected(expected);
        if xdir == DVec3::ZERO {
            return Err(error("xdir is zero"));
        }
        if exact.x.is_zero() {
            return Err(error("xdir is parallel to the normal"));
        }
        // |n × x|² < 2⁻⁴⁰ |n|² |x|²
        let across = exact.y.dot(&exact.y) * RBig::from(1u64 << 40);
        let lengths = exact.normal.dot(&exact.normal) * exact.xdir.dot(&exact.xdir);
        if across < lengths {
            return Err(error("xdir is nearly parallel to the normal"));
        }
        Ok(Self {
            x: exact.x.unit(),
            y: exact.y.unit(),
        })
    }

    /// The default axes: along the world's x, or its z for planes that face along x.
    #[must_use]
    pub fn any(normal: DVec3) -> Self {
        let axis = if normal.y == 0.0 && normal.z == 0.0 {
            DVec3::NEG_Z
        } else {
            DVec3::X
        };
        // The axis is not parallel to the normal, so the cross product is not zero.
        let y = unit(normal.cross(axis)).unwrap_or(DVec3::Y);
        Self {
            x: y.cross(normal),
            y,
        }
    }
}

impl Frame {
    /// The exact offset of a ray's crossing from the plane's point, along both axes.
    ///
    /// `None` if the ray runs along the plane.
    // With m = d × c it is (y·m, −x·m) divided by n·d.
    #[must_use]
    pub fn exact_offset(&self, flat: &Flat, ray: &Ray) -> Option<[RBig; 2]> {
        let dir = ExactVector::from(ray.dir);
        let slope = dir.dot(&flat.normal.into()).to_rational();
        if slope.is_zero() {
            return None;
        }
        let moment = dir.cross(&ray.origin.exactly_from(flat.point));
        let along = |axis: DVec3| moment.dot(&axis.into()).to_rational() / &slope;
        Some([along(self.y), along(-self.x)])
    }
}

/// The exact axes of a plane, of any length.
#[derive(Debug, Clone)]
pub struct ExactFrame {
    /// The normal as given.
    pub normal: RationalVector,
    /// The direction of x as given.
    pub xdir: RationalVector,
    /// `xdir` projected into the plane.
    pub x: RationalVector,
    /// `normal × xdir`.
    pub y: RationalVector,
}

impl ExactFrame {
    /// The axes from the decimals of a scene.
    #[must_use]
    pub fn new(normal: DVec3, xdir: DVec3) -> Self {
        let normal = RationalVector::of_decimals(normal);
        let xdir = RationalVector::of_decimals(xdir);
        let y = normal.cross(&xdir);
        Self {
            x: y.cross(&normal),
            y,
            normal,
            xdir,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_are_right_angled_and_right_handed() {
        let given = DVec3::new(1.0, 2.0, 2.0);
        let normal = unit(given).expect("not zero");
        let frame = Frame::new(given, DVec3::new(5.0, 1.0, 0.0)).expect("a frame");
        for product in [
            frame.x.dot(frame.y),
            frame.x.dot(normal),
            frame.y.dot(normal),
        ] {
            assert!(product.abs() < 1e-15, "{product}");
        }
        assert!(frame.x.cross(frame.y).dot(normal) > 0.99);
    }

    #[test]
    fn an_xdir_along_the_normal_or_of_no_length_is_refused() {
        let parallel = Frame::new(DVec3::Y, DVec3::new(0.0, -7.0, 0.0));
        assert_eq!(
            parallel.unwrap_err().reason,
            "xdir is parallel to the normal"
        );
        let zero = Frame::new(DVec3::Y, DVec3::ZERO);
        assert_eq!(zero.unwrap_err().reason, "xdir is zero");
    }
}
