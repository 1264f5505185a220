//! The part of a pixel that shows a rectangle.

use glam::{DVec2, DVec3};

use crate::math::Footprint;

/// A corner of a part of a pixel.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Corner {
    /// Position in the pixel, a square of side 1 around the origin.
    position: DVec2,
    /// Its image on the plane in homogeneous coordinates.
    pub(super) image: DVec3,
}

/// A convex part of a pixel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Polygon {
    corners: [Corner; Self::MOST],
    count: usize,
}

impl Polygon {
    /// The most corners: a square has four, and each of six clips adds at most one.
    const MOST: usize = 4 + 4 + 2;

    /// The whole pixel.
    fn square(footprint: &Footprint) -> Self {
        let mut corners = [Corner::default(); Self::MOST];
        let square = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)];
        for (corner, position) in corners.iter_mut().zip(square) {
            let position = DVec2::from(position);
            let image = footprint.image(position);
            *corner = Corner { position, image };
        }
        Self { corners, count: 4 }
    }

    /// The part of a pixel that shows the rectangle from the origin to `size`.
    pub(super) fn showing(footprint: &Footprint, size: DVec2) -> Self {
        Self::square(footprint)
            .clipped(|image| image.x)
            .clipped(|image| image.y)
            .clipped(|image| size.x * image.z - image.x)
            .clipped(|image| size.y * image.z - image.y)
    }

    /// The part in which a linear function of the image is not negative.
    ///
    /// Source: Sutherland and Hodgman 1974, "Reentrant Polygon Clipping".
    pub(super) fn clipped(self, height: impl Fn(DVec3) -> f64) -> Self {
        let mut corners = self.corners().iter();
        if corners.all(|corner| height(corner.image) >= 0.0) {
            return self;
        }
        let mut part = Self {
            corners: self.corners,
            count: 0,
        };
        let mut from = match self.corners().last() {
            Some(corner) => *corner,
            None => return part,
        };
        let mut from_height = height(from.image);
        for to in self.corners() {
            let to_height = height(to.image);
            if (from_height >= 0.0) != (to_height >= 0.0) {
                let fraction = from_height / (from_height - to_height);
                part.push(Corner {
                    position: from.position + (to.position - from.position) * fraction,
                    image: from.image + (to.image - from.image) * fraction,
                });
            }
            if to_height >= 0.0 {
                part.push(*to);
            }
            (from, from_height) = (*to, to_height);
        }
        part
    }

    /// Adds a corner.
    ///
    /// Corners beyond [`MOST`](Self::MOST) arise from rounding and do not matter.
    fn push(&mut self, corner: Corner) {
        if let Some(free) = self.corners.get_mut(self.count) {
            *free = corner;
            self.count += 1;
        }
    }

    /// The corners in order.
    pub(super) fn corners(&self) -> &[Corner] {
        &self.corners[..self.count]
    }

    /// Its area, as a fraction of the pixel.
    pub(super) fn area(&self) -> f64 {
        area(self.corners().iter().map(|corner| corner.position))
    }

    /// The positions of its corners on the plane.
    pub(super) fn images(&self) -> impl Iterator<Item = DVec2> + Clone {
        let images = self.corners().iter().map(|corner| corner.image);
        images.map(|image| image.truncate() / image.z)
    }
}

/// The area of a polygon, negative if its corners run clockwise.
pub(super) fn area(corners: impl Iterator<Item = DVec2> + Clone) -> f64 {
    // Differences to the first corner keep the precision of a polygon far from the origin.
    let Some(first) = corners.clone().next() else {
        return 0.0;
    };
    let edges = corners.map(|corner| corner - first);
    let pairs = edges.clone().zip(edges.skip(1));
    pairs.map(|(from, to)| from.perp_dot(to)).sum::<f64>() / 2.0
}
