//! Projection of points.

use glam::DVec3;

use super::Camera;

impl Camera {
    /// The image of a point: raster position times depth, and depth.
    ///
    /// The map to these homogeneous coordinates is linear, so lines become lines. Points behind the viewpoint have a negative depth.
    #[must_use]
    pub fn image(&self, point: DVec3) -> DVec3 {
        let offset = point - self.viewpoint;
        let depth = self.depth(offset);
        let image = offset - self.lower_left * depth;
        let along = |axis: DVec3, pixels: f64| {
            image.dot(axis) / axis.length_squared() * pixels - self.inset * depth
        };
        DVec3::new(
            along(self.right, self.pixels[0]),
            along(self.up, self.pixels[1]),
            depth,
        )
    }

    /// The depth of an offset from the viewpoint; 1 in the window's plane.
    #[must_use]
    pub fn depth(&self, offset: DVec3) -> f64 {
        let normal = self.right.cross(self.up);
        offset.dot(normal) / self.lower_left.dot(normal)
    }
}
