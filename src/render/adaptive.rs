//! Adaptive sampling: as many rays through each pixel as its error requires.

use super::sample_accumulator::{Content, EDGE_ERROR, Neighborhood, SampleAccumulator};
use super::{Both, Probe, Seed, Tracer, edge_detector::EdgeDetector};
use crate::camera::{Pattern, SamplePositions};
use crate::film::Region;
use crate::math::Rgb;
use crate::plan::{Outlines, Plan};
use crate::scene::RenderSettings;
use crate::texture::Filter;

/// Samples pixels until their estimated errors are within `max-error`.
///
/// Each pixel takes the first points of its Sobol sequence: four, or `samples` rounded up to a
/// power of two. Then the count grows by a half and by a third in turn, so every other count is a
/// power of two. The decision to go on depends on the pixel's own samples, on the first samples of
/// its neighbours, and on the outlines through it. So a pixel is the same in any part of the
/// picture.
///
/// With a texture filter, each ray covers a share of the pixel. Then all rays are traced again with
/// smaller shares until the mean no longer changes, because a filter's error may be equal for all
/// rays.
#[derive(Debug, Clone, Copy)]
pub(super) struct Adaptive<'a> {
    tracer: Tracer<'a>,
    settings: &'a RenderSettings,
    outlines: &'a Outlines,
    /// The initial state of the edge detector of a pixel.
    detector: EdgeDetector<'a>,
    /// The texture filter; `None` if each ray shows one point.
    filter: Option<Filter>,
}

/// The approximate number of rays through a pixel with a black-and-white edge.
///
/// It is the largest number for any edge between surfaces of uniform colour.
#[must_use]
pub fn rays_at_a_border(settings: &RenderSettings) -> u32 {
    let first = settings.first_rays();
    if settings.max_error == 0.0 {
        return settings.samples;
    }
    let rays = libm::pow(EDGE_ERROR / settings.max_error, 4.0 / 3.0);
    #[expect(clippy::cast_possible_truncation, reason = "limited below")]
    #[expect(clippy::cast_sign_loss, reason = "positive")]
    let rays = rays.round() as u32;
    rays.clamp(first, first.max(RenderSettings::MOST_ADAPTIVE))
}

impl<'a> Adaptive<'a> {
    /// An adaptive sampler; `None` if the number of rays per pixel is fixed.
    pub(super) fn new(tracer: Tracer<'a>, plan: &'a Plan<'a>) -> Option<Self> {
        let is_filtered = plan.scene.is_filtered();
        Some(Self {
            tracer,
            settings: &plan.scene.settings,
            outlines: plan.outlines.as_ref()?,
            detector: EdgeDetector::new(plan),
            filter: is_filtered.then_some(plan.scene.settings.texture_filter),
        })
    }

    /// Draws a part of the picture, in pieces of limited width to limit memory.
    pub(super) fn draw(&self, part: Region, pixels: &mut [Rgb], probe: &mut impl Probe) {
        const WIDEST: usize = 256;
        let [left, top, right, _] = part.bounds();
        for left in (left..right).step_by(WIDEST) {
            let piece = Region {
                left,
                width: WIDEST.min(right - left),
                ..part
            };
            self.draw_piece(piece, probe, |[column, row], color| {
                pixels[(row - top) * part.width + column - part.left] = color;
            });
        }
    }

    fn draw_piece(
        &self,
        part: Region,
        probe: &mut impl Probe,
        mut paint: impl FnMut([usize; 2], Rgb),
    ) {
        let size = [self.settings.width, self.settings.height];
        let wide = part.grown_within(size);
        let outlines = self.outlines.over(wide);
        let pilots: Vec<_> = wide
            .pixels()
            .map(|pixel| self.pilot(pixel, outlines.nearest(pixel), probe))
            .collect();
        let pilot = |[column, row]: [usize; 2]| {
            &pilots[(row - wide.top) * wide.width + (column - wide.left)]
        };
        for pixel in part.pixels() {
            let own = *pilot(pixel);
            let neighborhood = Region::around(pixel, size).pixels().map(pilot);
            let neighborhood = neighborhood.fold(Neighborhood::of(&own), |all, it| {
                all.and(Neighborhood::of(it))
            });
            paint(pixel, self.refined(own, neighborhood, pixel, probe));
        }
    }

    /// The colour of one pixel; the probe does not observe the rays of its neighbours.
    pub(super) fn color(&self, pixel: [usize; 2], probe: &mut impl Probe) -> Rgb {
        let size = [self.settings.width, self.settings.height];
        let wide = Region::around(pixel, size);
        let outlines = self.outlines.over(wide);
        let own = self.pilot(pixel, outlines.nearest(pixel), probe);
        let others = wide.pixels().filter(|other| *other != pixel);
        let others = others.map(|other| self.pilot(other, outlines.nearest(other), &mut ()));
        let neighborhood = others.fold(Neighborhood::of(&own), |all, it| {
            all.and(Neighborhood::of(&it))
        });
        self.refined(own, neighborhood, pixel, probe)
    }

    /// The first samples of a pixel, whose nearest outline has this depth.
    fn pilot(&self, pixel: [usize; 2], outline: f64, probe: &mut impl Probe) -> SampleAccumulator {
        // An outline well behind all hits is hidden.
        const NEAR: f64 = 1.0 + 1.0 / 64.0;
        let count = self.settings.first_rays();
        let mut samples = SampleAccumulator::NOTHING;
        if outline.is_finite() || self.filter.is_some() {
            let detector = self.send_detecting(&mut samples, 4, count / 4, pixel, probe);
            samples.has_outline = outline <= detector.farthest_depth() * NEAR;
        } else {
            self.send(&mut samples, 4, count / 4, pixel, probe);
        }
        samples
    }

    /// The colour of a pixel, after as many more rays as its error requires.
    fn refined(
        &self,
        mut samples: SampleAccumulator,
        neighborhood: Neighborhood,
        pixel: [usize; 2],
        probe: &mut impl Probe,
    ) -> Rgb {
        let RenderSettings {
            transfer,
            max_error,
            ..
        } = *self.settings;
        // The error of an inexact filter is estimated from two sizes of shares.
        let mut change = if samples.is_exact { 0.0 } else { f64::MAX };
        loop {
            let error = samples.error(neighborhood, transfer).max(change);
            if error <= max_error || samples.count >= RenderSettings::MOST_ADAPTIVE {
                return samples.mean();
            }
            if self.filter.is_some() {
                let smaller = self.with_smaller_shares(&samples, error, pixel, probe);
                // At worst, a filter's error is proportional to the sides of the shares.
                let times = f64::from(smaller.count) / f64::from(samples.count);
                change = smaller.change_from(&samples, transfer) / (times.sqrt() - 1.0);
                samples = smaller;
            } else {
                let size = samples.size();
                self.send(&mut samples, 2, size, pixel, probe);
                samples.merge_parts();
            }
        }
    }

    /// New samples, two or four times as many, depending on the error.
    ///
    /// Large shares are slow to filter, so few large steps are faster than many small ones.
    fn with_smaller_shares(
        &self,
        samples: &SampleAccumulator,
        error: f64,
        pixel: [usize; 2],
        probe: &mut impl Probe,
    ) -> SampleAccumulator {
        // The factor by which twice as many rays reduce the error at an edge.
        const LESS: f64 = 0.594_603_557_501_360_5; // 2^(-3/4)
        let is_near = error * LESS <= self.settings.max_error;
        let times = if is_near { 2 } else { 4 };
        let count = (samples.count * times).min(RenderSettings::MOST_ADAPTIVE);
        let mut more = SampleAccumulator::NOTHING;
        more.has_outline = samples.has_outline;
        self.send_detecting(&mut more, 4, count / 4, pixel, probe);
        more
    }

    /// Traces rays as [`send`](Self::send), and returns the edge detector.
    fn send_detecting(
        &self,
        samples: &mut SampleAccumulator,
        parts: u32,
        size: u32,
        pixel: [usize; 2],
        probe: &mut impl Probe,
    ) -> EdgeDetector<'a> {
        let outer: &mut dyn Probe = probe;
        let mut both = Both(outer, self.detector);
        self.send(samples, parts, size, pixel, &mut both);
        let detector = both.1;
        match self.filter {
            None => {}
            Some(Filter::Exact) => {
                samples.content = detector
                    .path_hash()
                    .map_or(Content::Edges, Content::Uniform);
                samples.is_exact = detector.is_exact();
            }
            Some(_) => samples.is_exact = false,
        }
        detector
    }

    /// Traces `parts` parts of `size` rays each through a pixel.
    fn send(
        &self,
        samples: &mut SampleAccumulator,
        parts: u32,
        size: u32,
        [column, row]: [usize; 2],
        probe: &mut impl Probe,
    ) {
        // The camera counts rows from the bottom.
        let row = self.settings.height as usize - 1 - row;
        let end = samples.count + parts * size;
        let places = SamplePositions::new(Pattern::Sobol, column, row, end);
        #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^53")]
        let (x, y) = (column as f64, row as f64);
        let tracer = Tracer {
            rays: end,
            ..self.tracer
        };
        while samples.count < end {
            let [dx, dy] = places.at(samples.count);
            let seed = Seed::shared(places.seed, samples.count);
            samples.add(tracer.sees_as(x + dx, y + dy, seed, probe));
            if (end - samples.count).is_multiple_of(size) {
                samples.close_part();
            }
        }
    }
}
