//! As many rays through each pixel as its error asks for.

use super::sample_accumulator::{Around, BORDER, Found, SampleAccumulator};
use super::{Both, Probe, Seed, Tracer, edge_detector::EdgeDetector};
use crate::camera::{Pattern, SamplePositions};
use crate::film::Region;
use crate::math::Rgb;
use crate::plan::{Outlines, Plan};
use crate::scene::RenderSettings;
use crate::texture::Filter;

/// Sends rays through pixels until their errors are probably within the picture's `max-error`.
///
/// Each pixel takes the first places of its Sobol sequence: four at first, or as many as `samples`
/// says, then half as many more or a third, up to the next power of two, and so on. Whether it goes on
/// depends on its own rays, on the first ones of the pixels around it, and on the outlines through
/// it; so a pixel is the same in any part of the picture.
///
/// Where a filter shows each ray its share of a pixel, rays with smaller shares are sent anew, until that
/// makes no difference: no filter is exact everywhere, and it may be off alike for all rays.
#[derive(Debug, Clone, Copy)]
pub(super) struct Adaptive<'a> {
    tracer: Tracer<'a>,
    picture: &'a RenderSettings,
    outlines: &'a Outlines,
    /// What it looks for in a pixel.
    watch: EdgeDetector<'a>,
    /// `None` if each ray shows one place.
    filter: Option<Filter>,
}

/// About how many rays go through a pixel in which black borders on white, if a picture has these
/// settings; the most that any edge of a surface takes, as long as its shades are even.
#[must_use]
pub fn rays_at_a_border(picture: &RenderSettings) -> u32 {
    let first = picture.first_rays();
    if picture.max_error == 0.0 {
        return picture.samples;
    }
    let rays = libm::pow(BORDER / picture.max_error, 4.0 / 3.0);
    #[expect(clippy::cast_possible_truncation, reason = "limited below")]
    #[expect(clippy::cast_sign_loss, reason = "positive")]
    let rays = rays.round() as u32;
    rays.clamp(first, first.max(RenderSettings::MOST_ADAPTIVE))
}

impl<'a> Adaptive<'a> {
    /// `None` if the picture asks for the same number of rays everywhere.
    pub(super) fn new(tracer: Tracer<'a>, plan: &'a Plan<'a>) -> Option<Self> {
        let is_filtered = plan.scene.is_filtered();
        Some(Self {
            tracer,
            picture: &plan.scene.settings,
            outlines: plan.outlines.as_ref()?,
            watch: EdgeDetector::new(plan),
            filter: is_filtered.then_some(plan.scene.settings.texture_filter),
        })
    }

    /// Draws a part of the picture, in pieces that are not so wide that much has to be kept in mind.
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
        let size = [self.picture.width, self.picture.height];
        let wide = part.grown_within(size);
        let outlines = self.outlines.over(wide);
        let pilots: Vec<_> = wide
            .pixels()
            .map(|place| self.pilot(place, outlines.nearest(place), probe))
            .collect();
        let pilot = |[column, row]: [usize; 2]| {
            &pilots[(row - wide.top) * wide.width + (column - wide.left)]
        };
        for place in part.pixels() {
            let own = *pilot(place);
            let around = Region::around(place, size).pixels().map(pilot);
            let around = around.fold(Around::of(&own), |all, it| all.and(Around::of(it)));
            paint(place, self.refined(own, around, place, probe));
        }
    }

    /// The colour of one pixel; onlookers do not see the rays of those around it.
    pub(super) fn color(&self, place: [usize; 2], probe: &mut impl Probe) -> Rgb {
        let size = [self.picture.width, self.picture.height];
        let wide = Region::around(place, size);
        let outlines = self.outlines.over(wide);
        let own = self.pilot(place, outlines.nearest(place), probe);
        let others = wide.pixels().filter(|other| *other != place);
        let others = others.map(|other| self.pilot(other, outlines.nearest(other), &mut ()));
        let around = others.fold(Around::of(&own), |all, it| all.and(Around::of(&it)));
        self.refined(own, around, place, probe)
    }

    /// The first rays of a pixel, through which an outline of this depth runs.
    fn pilot(&self, place: [usize; 2], outline: f64, probe: &mut impl Probe) -> SampleAccumulator {
        // What is well behind all that was met is not seen.
        const NEAR: f64 = 1.0 + 1.0 / 64.0;
        let count = self.picture.first_rays();
        let mut tally = SampleAccumulator::NOTHING;
        if outline.is_finite() || self.filter.is_some() {
            let watch = self.send_watched(&mut tally, 4, count / 4, place, probe);
            tally.outlined = outline <= watch.farthest() * NEAR;
        } else {
            self.send(&mut tally, 4, count / 4, place, probe);
        }
        tally
    }

    /// The colour of a pixel, after as many more rays as it takes.
    fn refined(
        &self,
        mut tally: SampleAccumulator,
        around: Around,
        place: [usize; 2],
        probe: &mut impl Probe,
    ) -> Rgb {
        let RenderSettings {
            transfer,
            max_error,
            ..
        } = *self.picture;
        // Where a filter is not exact, nobody knows how far it is off before it was asked twice.
        let mut moved = if tally.is_exact { 0.0 } else { f64::MAX };
        loop {
            let error = tally.error(around, transfer).max(moved);
            if error <= max_error || tally.count >= RenderSettings::MOST_ADAPTIVE {
                return tally.mean();
            }
            if self.filter.is_some() {
                let smaller = self.with_smaller_shares(&tally, error, place, probe);
                // It is off in proportion to the sides of its shares at worst.
                let times = f64::from(smaller.count) / f64::from(tally.count);
                moved = smaller.moved_from(&tally, transfer) / (times.sqrt() - 1.0);
                tally = smaller;
            } else {
                let size = tally.size();
                self.send(&mut tally, 2, size, place, probe);
                tally.put_together();
            }
        }
    }

    /// Two or four times as many rays, all sent anew, by how far off the pixel is.
    ///
    /// Large shares take long, so few steps are better than small ones.
    fn with_smaller_shares(
        &self,
        tally: &SampleAccumulator,
        error: f64,
        place: [usize; 2],
        probe: &mut impl Probe,
    ) -> SampleAccumulator {
        // What twice as many rays make of an error at a border.
        const LESS: f64 = 0.594_603_557_501_360_5; // 2^(-3/4)
        let is_near = error * LESS <= self.picture.max_error;
        let times = if is_near { 2 } else { 4 };
        let count = (tally.count * times).min(RenderSettings::MOST_ADAPTIVE);
        let mut more = SampleAccumulator::NOTHING;
        more.outlined = tally.outlined;
        self.send_watched(&mut more, 4, count / 4, place, probe);
        more
    }

    /// Sends rays as [`send`](Self::send), and tells what they met.
    fn send_watched(
        &self,
        tally: &mut SampleAccumulator,
        parts: u32,
        size: u32,
        place: [usize; 2],
        probe: &mut impl Probe,
    ) -> EdgeDetector<'a> {
        let onlooker: &mut dyn Probe = probe;
        let mut both = Both(onlooker, self.watch);
        self.send(tally, parts, size, place, &mut both);
        let watch = both.1;
        match self.filter {
            None => {}
            Some(Filter::Exact) => {
                tally.found = watch.path().map_or(Found::Borders, Found::One);
                tally.is_exact = watch.is_exact();
            }
            Some(_) => tally.is_exact = false,
        }
        watch
    }

    /// Sends so many parts of so many rays each through a pixel.
    fn send(
        &self,
        tally: &mut SampleAccumulator,
        parts: u32,
        size: u32,
        [column, row]: [usize; 2],
        probe: &mut impl Probe,
    ) {
        // The camera counts rows from the bottom.
        let row = self.picture.height as usize - 1 - row;
        let end = tally.count + parts * size;
        let places = SamplePositions::new(Pattern::Sobol, column, row, end);
        #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^53")]
        let (x, y) = (column as f64, row as f64);
        let tracer = Tracer {
            rays: end,
            ..self.tracer
        };
        while tally.count < end {
            let [dx, dy] = places.at(tally.count);
            let seed = Seed::shared(places.seed, tally.count);
            tally.add(tracer.sees_as(x + dx, y + dy, seed, probe));
            if (end - tally.count).is_multiple_of(size) {
                tally.close_part();
            }
        }
    }
}
