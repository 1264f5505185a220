//! The outlines of surfaces on the raster.

use std::ops::Range;

use glam::DVec3;

use crate::camera::Camera;
use crate::film::Region;
use crate::math::unit;
use crate::surface::Surface;

/// The outlines of surfaces as lines on the raster.
///
/// They only guide adaptive sampling, so they need not be exact. They are the same on every
/// machine.
#[derive(Debug)]
pub struct Outlines {
    /// The picture's height in pixels.
    height: usize,
    lines: Vec<Line>,
}

/// The ends of a line, as raster coordinates and inverse depths.
///
/// Raster coordinates are in pixels from the centre of the lower-left pixel. Inverse depth is
/// linear on the raster.
type Line = [DVec3; 2];

/// The depth of the nearest outline through each pixel of a part of the picture.
///
/// A surface that covers only a part of a pixel has its outline there.
#[derive(Debug)]
pub struct OutlineDepths {
    part: Region,
    /// Row by row from the top; infinite in pixels without an outline.
    nearest: Vec<f64>,
}

/// Half the width of an outline, in pixels.
///
/// It covers the error of the polygons for round outlines.
const HALF_WIDTH: f64 = 1.0 / 16.0;

/// The number of corners of the polygon that approximates a round outline.
const CORNERS: u32 = 256;

impl Outlines {
    /// The outlines of these surfaces in a picture of this width and height.
    #[must_use]
    pub fn new<'a>(
        surfaces: impl Iterator<Item = &'a dyn Surface>,
        camera: &Camera,
        size: [u32; 2],
    ) -> Self {
        let mut lines = Vec::new();
        for surface in surfaces {
            let corners = match surface.shape().round() {
                Some(round) => silhouette(camera.viewpoint(), round),
                None => surface.shape().outline(),
            };
            let images: Vec<_> = corners.into_iter().map(|it| camera.image(it)).collect();
            let ends = images.iter().cycle().skip(1);
            let sides = images.iter().zip(ends);
            lines.extend(sides.filter_map(|(start, end)| clip([*start, *end], size)));
        }
        Self {
            height: size[1] as usize,
            lines,
        }
    }

    /// The depths of the nearest outlines in a part of the picture.
    #[must_use]
    pub fn over(&self, part: Region) -> OutlineDepths {
        let mut depths = OutlineDepths {
            part,
            nearest: vec![f64::INFINITY; part.width * part.height],
        };
        for line in &self.lines {
            depths.draw(line, self.height);
        }
        depths
    }
}

impl OutlineDepths {
    /// The depth of the nearest outline through a pixel; infinite if there is none.
    ///
    /// The pixel is given by its column and row in the picture, and must lie in the part.
    #[must_use]
    pub fn nearest(&self, [column, row]: [usize; 2]) -> f64 {
        self.nearest[(row - self.part.top) * self.part.width + (column - self.part.left)]
    }

    /// Draws a line of a picture of this height.
    fn draw(&mut self, [from, to]: &Line, height: usize) {
        let [left, top, right, bottom] = self.part.bounds();
        // Lines count rows from the bottom.
        for row in touched([from.y, to.y], height - bottom..height - top) {
            let rise = to.y - from.y;
            let crossings = if rise == 0.0 {
                [0.0, 1.0]
            } else {
                extent(row).map(|y| ((y - from.y) / rise).clamp(0.0, 1.0))
            };
            let [one, other] = crossings.map(|at| *from + (*to - *from) * at);
            let columns = touched([one.x, other.x], left..right);
            let depth = 1.0 / one.z.max(other.z);
            let start = (height - 1 - row - top) * self.part.width;
            for column in columns {
                let nearest = &mut self.nearest[start + column - left];
                *nearest = nearest.min(depth);
            }
        }
    }
}

/// Clips the line between two homogeneous image points to a raster.
///
/// The raster is extended by half a pixel. `None` if no part of the line is inside and in front of
/// the camera.
fn clip([start, end]: [DVec3; 2], size: [u32; 2]) -> Option<Line> {
    let [width, height] = size.map(f64::from);
    // The distance inside each side of the raster, times depth. A point inside two opposite sides
    // has a depth above zero.
    let inside = |DVec3 { x, y, z }| [x + z, width * z - x, y + z, height * z - y];
    let (mut enters, mut leaves) = (0.0f64, 1.0f64);
    for (before, after) in inside(start).into_iter().zip(inside(end)) {
        if before < 0.0 && after < 0.0 {
            return None;
        }
        let crossing = before / (before - after);
        if before < 0.0 {
            enters = enters.max(crossing);
        } else if after < 0.0 {
            leaves = leaves.min(crossing);
        }
    }
    let ends = [enters, leaves].map(|at| start + (end - start) * at);
    let is_seen = enters <= leaves && ends.iter().all(|it| it.z > 0.0);
    is_seen.then(|| ends.map(|it| DVec3::new(it.x / it.z, it.y / it.z, 1.0 / it.z)))
}

/// The silhouette of an axis-aligned ellipsoid from the eye, as a polygon.
///
/// Empty if the eye is inside.
fn silhouette(eye: DVec3, [center, axes]: [DVec3; 2]) -> Vec<DVec3> {
    // In units of its axes it is a ball of radius 1. The silhouette is the circle where lines of
    // sight are tangent to the ball, at right angles to the radius.
    let eye = (eye - center) / axes;
    let far = eye.length_squared();
    let Some(toward) = unit(eye).filter(|_| far > 1.0) else {
        return Vec::new();
    };
    let radius = (1.0 - 1.0 / far).sqrt();
    let (across, up) = toward.any_orthonormal_pair();
    let corner = |number: u32| {
        let angle = f64::from(number) / f64::from(CORNERS) * std::f64::consts::TAU;
        let (sine, cosine) = libm::sincos(angle);
        let point = eye / far + (across * cosine + up * sine) * radius;
        center + point * axes
    };
    (0..CORNERS).map(corner).collect()
}

/// The range of coordinates of outlines that touch a column or row of pixels.
fn extent(pixel: usize) -> [f64; 2] {
    #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^53")]
    let center = pixel as f64;
    [center - 0.5 - HALF_WIDTH, center + 0.5 + HALF_WIDTH]
}

/// The columns or rows that an outline touches between two coordinates.
fn touched([one, other]: [f64; 2], pixels: Range<usize>) -> Range<usize> {
    let (first, last) = (
        one.min(other) - HALF_WIDTH + 0.5,
        one.max(other) + HALF_WIDTH + 0.5,
    );
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "casts from float saturate"
    )]
    let (start, end) = (
        first as usize,
        if last < 0.0 { 0 } else { last as usize + 1 },
    );
    start.max(pixels.start)..end.min(pixels.end)
}
