//! Through which pixels the outlines of surfaces run.

use glam::DVec3;

use crate::camera::Camera;
use crate::surface::Surface;

/// For each pixel, how near to the eye the nearest outline is that runs through it: a thing in front
/// of others cannot be in a pixel unseen without its outline.
///
/// It only tells where more rays are worth while, so it need not be exact; it is the same on every
/// machine.
#[derive(Debug)]
pub struct Outlines {
    width: usize,
    height: usize,
    /// Depths, row by row from the bottom; infinite where there is no outline.
    nearest: Vec<f32>,
}

/// Half the width of an outline, in pixels; an outline of chords is no further off than this.
const HALF_WIDTH: f64 = 1.0 / 16.0;

/// Corners of the polygon that stands for a round outline.
const CORNERS: u32 = 256;

impl Outlines {
    /// The outlines of these surfaces in a picture of this width and height.
    #[must_use]
    pub fn new<'a>(
        surfaces: impl Iterator<Item = &'a dyn Surface>,
        camera: &Camera,
        [width, height]: [u32; 2],
    ) -> Self {
        let [width, height] = [width, height].map(|side| side as usize);
        let mut outlines = Self {
            width,
            height,
            nearest: vec![f32::INFINITY; width * height],
        };
        for surface in surfaces {
            let corners = match surface.round() {
                Some(round) => silhouette(camera.viewpoint(), round),
                None => surface.outline(),
            };
            let images: Vec<_> = corners.into_iter().map(|it| camera.image(it)).collect();
            let ends = images.iter().cycle().skip(1);
            for (start, end) in images.iter().zip(ends) {
                outlines.draw(*start, *end);
            }
        }
        outlines
    }

    /// The depth of the nearest outline through the pixel of a column and a row from the lower left;
    /// infinite if there is none.
    #[must_use]
    pub fn nearest(&self, column: usize, row: usize) -> f64 {
        f64::from(self.nearest[row * self.width + column])
    }

    /// Draws a line between two images of points.
    fn draw(&mut self, start: DVec3, end: DVec3) {
        let Some([start, end]) = self.within(start, end) else {
            return;
        };
        // A depth's reciprocal is linear in the picture.
        let [from, to] = [start, end].map(|it| DVec3::new(it.x / it.z, it.y / it.z, 1.0 / it.z));
        let (low, high) = (from.y.min(to.y), from.y.max(to.y));
        for row in pixels(low, high, self.height) {
            let (bottom, top) = reach(row);
            let rise = to.y - from.y;
            let [mut enters, mut leaves] = [0.0, 1.0];
            if rise != 0.0 {
                let at = [bottom, top].map(|y| ((y - from.y) / rise).clamp(0.0, 1.0));
                [enters, leaves] = [at[0].min(at[1]), at[0].max(at[1])];
            }
            let ends = [enters, leaves].map(|at| from + (to - from) * at);
            let (left, right) = (ends[0].x.min(ends[1].x), ends[0].x.max(ends[1].x));
            #[expect(clippy::cast_possible_truncation, reason = "rounded to the nearest")]
            let depth = (1.0 / ends[0].z.max(ends[1].z)) as f32;
            for column in pixels(left, right, self.width) {
                let nearest = &mut self.nearest[row * self.width + column];
                *nearest = nearest.min(depth);
            }
        }
    }

    /// The part of a line between two images that lies in the picture, or not far beside it.
    fn within(&self, start: DVec3, end: DVec3) -> Option<[DVec3; 2]> {
        #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^53")]
        let [width, height] = [self.width, self.height].map(|side| side as f64);
        let (mut enters, mut leaves) = (0.0f64, 1.0f64);
        // The sides of the picture, a pixel further out; between any two of them depths are
        // above zero.
        for inside in [
            |it: DVec3, _: f64, _: f64| it.x + it.z,
            |it: DVec3, width: f64, _: f64| width * it.z - it.x,
            |it: DVec3, _: f64, _: f64| it.y + it.z,
            |it: DVec3, _: f64, height: f64| height * it.z - it.y,
        ] {
            let [before, after] = [start, end].map(|it| inside(it, width, height));
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
        (enters <= leaves && ends.iter().all(|it| it.z > 0.0)).then_some(ends)
    }
}

/// The outline of an ellipsoid along the axes as it is seen from somewhere, as a polygon; empty from
/// within.
fn silhouette(eye: DVec3, [center, axes]: [DVec3; 2]) -> Vec<DVec3> {
    // In units of its axes it is a ball of radius 1. What is seen ends where the line of sight
    // touches it, at right angles to the radius.
    let eye = (eye - center) / axes;
    let far = eye.length_squared();
    let Some(toward) = crate::math::unit(eye).filter(|_| far > 1.0) else {
        return Vec::new();
    };
    let radius = (1.0 - 1.0 / far).sqrt();
    let (across, up) = toward.any_orthonormal_pair();
    let corner = |number: u32| {
        let turn = f64::from(number) / f64::from(CORNERS) * std::f64::consts::TAU;
        let (sine, cosine) = libm::sincos(turn);
        let point = eye / far + (across * cosine + up * sine) * radius;
        center + point * axes
    };
    (0..CORNERS).map(corner).collect()
}

/// From where to where a column or row of pixels reaches that an outline touches.
fn reach(pixel: usize) -> (f64, f64) {
    #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^53")]
    let center = pixel as f64;
    (center - 0.5 - HALF_WIDTH, center + 0.5 + HALF_WIDTH)
}

/// The columns or rows, of so many, that an outline touches which reaches from `low` to `high`.
fn pixels(low: f64, high: f64, count: usize) -> std::ops::Range<usize> {
    let pixel = |place: f64| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped"
        )]
        let pixel = (place + 0.5).floor().max(0.0) as usize;
        pixel
    };
    let end = if high + HALF_WIDTH < -0.5 {
        0
    } else {
        pixel(high + HALF_WIDTH) + 1
    };
    pixel(low - HALF_WIDTH)..end.min(count)
}
