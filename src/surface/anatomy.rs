//! What a surface is made of, in plain numbers, for numerics other than its own.

use glam::{DVec2, DVec3};

use crate::material::Material;
use crate::texture::TextureMap;

/// A shape and what covers it.
#[derive(Debug, Clone, Copy)]
pub struct Anatomy<'a> {
    /// Where the surface is.
    pub shape: Shape,
    /// What is seen on it.
    pub cover: Cover<'a>,
}

/// A shape in world coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// An unbounded plane.
    Plane {
        /// A point in it.
        point: DVec3,
        /// Its unit normal.
        normal: DVec3,
    },
    /// A rectangle.
    Rectangle {
        /// Its lower-left corner.
        corner: DVec3,
        /// Its unit axes: x, y and the normal.
        axes: [DVec3; 3],
        /// Width along x, height along y.
        size: DVec2,
    },
    /// A triangle, lit on the side from which its corners run counter-clockwise.
    Triangle {
        /// Its corners.
        vertices: [DVec3; 3],
        /// Its unit normal.
        normal: DVec3,
    },
    /// A sphere.
    Sphere {
        /// Its centre.
        center: DVec3,
        /// Its radius.
        radius: f64,
    },
    /// An ellipsoid along the world's axes.
    Ellipsoid {
        /// Its centre.
        center: DVec3,
        /// Its half axes.
        axes: DVec3,
    },
}

impl Shape {
    /// The point that the scene gives for it: a point in the plane, a corner, or the centre.
    #[must_use]
    pub fn anchor(&self) -> DVec3 {
        match *self {
            Self::Plane { point, .. } => point,
            Self::Rectangle { corner, .. } => corner,
            Self::Triangle { vertices, .. } => vertices[0],
            Self::Sphere { center, .. } | Self::Ellipsoid { center, .. } => center,
        }
    }
}

/// What is seen on a surface.
#[derive(Debug, Clone, Copy)]
pub enum Cover<'a> {
    /// Its material.
    Plain,
    /// An image, upright on a rectangle.
    Image(&'a TextureMap),
    /// An image wrapped around a sphere or an ellipsoid.
    Globe(&'a TextureMap),
    /// Tiles of the material and another one.
    Tiles {
        /// The unit vectors along which the tiles are counted.
        axes: [DVec3; 2],
        /// The size of a tile.
        tile: DVec2,
        /// Where the tiles are counted from.
        start: super::TileStart,
        /// The material of every other tile.
        alternate: &'a Material,
    },
    /// Something of its own, which only the surface itself knows.
    Own,
}

impl<'a> Anatomy<'a> {
    /// A shape that shows its material.
    #[must_use]
    pub fn plain(shape: Shape) -> Self {
        Self {
            shape,
            cover: Cover::Plain,
        }
    }

    /// The same shape with this cover.
    #[must_use]
    pub fn covered(self, cover: Cover<'a>) -> Self {
        Self { cover, ..self }
    }
}
