//! Right-angled axes in a plane.

use glam::DVec3;

use super::unit;
use crate::language::Refusal;

/// The axes of a plane: `x` grows to the right, `y` upward, the normal towards the viewer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Unit vector along which the plane's own x coordinate grows.
    pub x: DVec3,
    /// Unit vector along which the plane's own y coordinate grows: `normal × x`.
    pub y: DVec3,
}

impl Frame {
    /// The axes of the plane with this unit normal, from any `xdir` that is not along the normal.
    ///
    /// `xdir` is projected into the plane and made unit.
    ///
    /// # Errors
    /// Refuses an `xdir` that is zero or parallel to the normal.
    pub fn new(normal: DVec3, xdir: DVec3) -> Result<Self, Refusal> {
        let advice = "xdir is the direction in which the surface's own x grows, such as 1 0 0";
        let expected = "expected a direction that is not the normal's";
        let refusal = |reason: &str| Refusal::new("xdir", reason, advice).expected(expected);
        let xdir = unit(xdir).ok_or_else(|| refusal("xdir is zero"))?;
        // The cross product vanishes exactly when the two are parallel, before any projection.
        let across =
            unit(normal.cross(xdir)).ok_or_else(|| refusal("xdir is parallel to the normal"))?;
        Ok(Self {
            x: across.cross(normal),
            y: across,
        })
    }

    /// The axes of a plane for which no direction is asked: along the world's x, or its z for
    /// planes that face along x.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_are_right_angled_and_right_handed() {
        let normal = unit(DVec3::new(1.0, 2.0, 2.0)).expect("not zero");
        let frame = Frame::new(normal, DVec3::new(5.0, 1.0, 0.0)).expect("a frame");
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
