//! A ray's hit on a shape.

use glam::{DVec2, DVec3};

use crate::math::{Point, Rgb};

/// The hit of a ray on a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Distance along the ray; above zero.
    pub t: f64,
    /// Bound of the difference between `t` and the exact distance.
    pub error: f64,
    /// The hit point, anchored at the shape's own point.
    pub point: Point,
    /// The unit normal as the shape has it, on whichever side the ray came.
    pub normal: DVec3,
    /// The shape's own coordinates.
    ///
    /// On a rectangle the chapter's `lasthit`: the offset from its corner along x and y, in world
    /// units. On a tiled plane, once resolved, the numbers of the tile. Zero elsewhere.
    pub uv: DVec2,
    /// The colour of the image, once resolved; white before, and without an image.
    ///
    /// See [`Surface::resolve`](crate::surface::Surface::resolve).
    pub texel: Rgb,
}

/// The exact texel or tile of a hit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolved {
    /// The coordinates, as in a [`Hit`].
    pub uv: DVec2,
    /// The colour of the surface's image there.
    pub texel: Rgb,
}

impl Hit {
    /// The hit with its exact texel or tile.
    #[must_use]
    #[inline(always)]
    pub fn resolved(self, Resolved { uv, texel }: Resolved) -> Self {
        Self { uv, texel, ..self }
    }

    /// A hit on a shape without coordinates of its own.
    #[inline(always)]
    pub(super) fn new(t: f64, error: f64, point: Point, normal: DVec3) -> Self {
        Self {
            t,
            error,
            point,
            normal,
            uv: DVec2::ZERO,
            texel: Rgb::WHITE,
        }
    }
}
