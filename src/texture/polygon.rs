//! What of a pixel shows a rectangle.

use glam::{DVec2, DVec3};

use crate::math::Footprint;

/// A corner of a part of a pixel.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Corner {
    /// The place in the pixel, a square of side 1 around the origin.
    pub(super) place: DVec2,
    /// The image of it on the plane, times its last coordinate.
    pub(super) image: DVec3,
}

/// A convex part of a pixel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Polygon {
    corners: [Corner; Self::MOST],
    count: usize,
}

impl Polygon {
    /// A square has four corners, and each line that cuts it adds one at most.
    const MOST: usize = 4 + 4 + 2;

    /// The whole pixel.
    fn square(footprint: &Footprint) -> Self {
        let mut corners = [Corner::default(); Self::MOST];
        let around = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)];
        for (corner, place) in corners.iter_mut().zip(around) {
            let place = DVec2::from(place);
            let image = footprint.image(place);
            *corner = Corner { place, image };
        }
        Self { corners, count: 4 }
    }

    /// The part of a pixel that shows the rectangle from the origin to a corner.
    pub(super) fn showing(footprint: &Footprint, size: DVec2) -> Self {
        Self::square(footprint)
            .cut(|image| image.x)
            .cut(|image| image.y)
            .cut(|image| size.x * image.z - image.x)
            .cut(|image| size.y * image.z - image.y)
    }

    /// The part in which a linear function of the image is not below zero (Sutherland and Hodgman
    /// 1974, "Reentrant Polygon Clipping").
    pub(super) fn cut(self, height: impl Fn(DVec3) -> f64) -> Self {
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
                let share = from_height / (from_height - to_height);
                part.push(Corner {
                    place: from.place + (to.place - from.place) * share,
                    image: from.image + (to.image - from.image) * share,
                });
            }
            if to_height >= 0.0 {
                part.push(*to);
            }
            (from, from_height) = (*to, to_height);
        }
        part
    }

    /// Adds a corner; rounding cannot make more than there may be that matter.
    fn push(&mut self, corner: Corner) {
        if let Some(place) = self.corners.get_mut(self.count) {
            *place = corner;
            self.count += 1;
        }
    }

    /// Its corners in order.
    pub(super) fn corners(&self) -> &[Corner] {
        &self.corners[..self.count]
    }

    /// The share of the pixel.
    pub(super) fn area(&self) -> f64 {
        area(self.corners().iter().map(|corner| corner.place))
    }

    /// Where its corners lie on the plane.
    pub(super) fn places(&self) -> impl Iterator<Item = DVec2> + Clone {
        let images = self.corners().iter().map(|corner| corner.image);
        images.map(|image| image.truncate() / image.z)
    }
}

/// The area of a polygon; below zero if its corners go around clockwise.
pub(super) fn area(corners: impl Iterator<Item = DVec2> + Clone) -> f64 {
    // From its first corner, so that a polygon far away is not lost in rounding.
    let Some(first) = corners.clone().next() else {
        return 0.0;
    };
    let ways = corners.map(|corner| corner - first);
    let pairs = ways.clone().zip(ways.skip(1));
    pairs.map(|(from, to)| from.perp_dot(to)).sum::<f64>() / 2.0
}
