//! Where points appear.

use glam::DVec3;

use super::Camera;

impl Camera {
    /// The image of a point in homogeneous coordinates: its place in pixels from the centre of the
    /// lower-left one, times its depth, and its depth. It is linear in the point, so a line's image
    /// is a line, and what is behind the eye has a depth below zero.
    #[must_use]
    pub fn image(&self, point: DVec3) -> DVec3 {
        let way = point - self.viewpoint;
        let depth = self.depth(way);
        let image = way - self.lower_left * depth;
        let along = |axis: DVec3, span: f64| {
            image.dot(axis) / axis.length_squared() * span - self.inset * depth
        };
        DVec3::new(
            along(self.right, self.span[0]),
            along(self.up, self.span[1]),
            depth,
        )
    }

    /// How far a way from the eye leads into the picture; to the window's plane it is 1.
    #[must_use]
    pub fn depth(&self, way: DVec3) -> f64 {
        let normal = self.right.cross(self.up);
        way.dot(normal) / self.lower_left.dot(normal)
    }
}
