//! As many rays through each pixel as its error asks for.

use super::tally::{BORDER, Colors, Tally};
use super::{Both, Probe, Seed, Tracer, watch::Watch};
use crate::camera::{Pattern, Places};
use crate::film::Region;
use crate::math::Rgb;
use crate::plan::{Outlines, Plan};
use crate::scene::{Picture, Scene};
use crate::surface::Surface;
use crate::texture::Filter;

/// Sends rays through pixels until their errors are probably within the picture's `max-error`.
///
/// Each pixel takes the first places of its Sobol sequence: four at first, or as many as `samples`
/// says, then half as many more or a third, up to the next power of two, and so on. Whether it goes on
/// depends on its own rays, on the first ones of the pixels around it, and on the outlines through
/// it; so a pixel is the same in any part of the picture.
///
/// Where a filter shows each ray about what its share of the pixel is, twice as many rays with half the
/// shares are sent anew, until that makes no difference, too.
#[derive(Debug, Clone, Copy)]
pub(super) struct Adaptive<'a> {
    tracer: Tracer<'a>,
    picture: &'a Picture,
    outlines: &'a Outlines,
    /// Whether a filter shows each ray its share of the pixel, and not exactly.
    is_rough: bool,
}

/// About how many rays go through a pixel in which black borders on white, if a picture has these
/// settings; the most that any edge of a surface takes, as long as its shades are even.
#[must_use]
pub fn rays_at_a_border(picture: &Picture) -> u32 {
    let first = picture.first_rays();
    if picture.max_error == 0.0 {
        return picture.samples;
    }
    let rays = libm::pow(BORDER / picture.max_error, 4.0 / 3.0);
    #[expect(clippy::cast_possible_truncation, reason = "limited below")]
    #[expect(clippy::cast_sign_loss, reason = "positive")]
    let rays = rays.round() as u32;
    rays.clamp(first, first.max(Picture::MOST_ADAPTIVE))
}

impl<'a> Adaptive<'a> {
    /// `None` if the picture asks for the same number of rays everywhere.
    pub(super) fn new(tracer: Tracer<'a>, plan: &'a Plan<'a>) -> Option<Self> {
        Some(Self {
            tracer,
            picture: &plan.scene.picture,
            outlines: plan.outlines.as_ref()?,
            is_rough: is_rough(plan.scene),
        })
    }

    /// Draws a part of the picture, in pieces that are not so wide that much has to be kept in mind.
    pub(super) fn draw(&self, part: Region, pixels: &mut [Rgb], probe: &mut impl Probe) {
        const WIDEST: usize = 256;
        let [left, top, right, _] = part.corners();
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
            .places()
            .map(|place| self.pilot(place, outlines.nearest(place), probe))
            .collect();
        let pilot = |[column, row]: [usize; 2]| {
            &pilots[(row - wide.top) * wide.width + (column - wide.left)]
        };
        for place in part.places() {
            let own = *pilot(place);
            let around = Region::around(place, size).places().map(pilot);
            let around = around.fold(own.range, |all, it| all.and(it.range));
            paint(place, self.refined(own, around, place, probe));
        }
    }

    /// The colour of one pixel; onlookers do not see the rays of those around it.
    pub(super) fn color(&self, place: [usize; 2], probe: &mut impl Probe) -> Rgb {
        let size = [self.picture.width, self.picture.height];
        let wide = Region::around(place, size);
        let outlines = self.outlines.over(wide);
        let own = self.pilot(place, outlines.nearest(place), probe);
        let others = wide.places().filter(|other| *other != place);
        let others = others.map(|other| self.pilot(other, outlines.nearest(other), &mut ()));
        let around = others.fold(own.range, |all, it| all.and(it.range));
        self.refined(own, around, place, probe)
    }

    /// The first rays of a pixel, through which an outline of this depth runs.
    fn pilot(&self, place: [usize; 2], outline: f64, probe: &mut impl Probe) -> Tally {
        // What is well behind all that was met is not seen.
        const NEAR: f64 = 1.0 + 1.0 / 64.0;
        let count = self.picture.first_rays();
        let mut tally = Tally::NOTHING;
        if outline.is_finite() {
            let onlooker: &mut dyn Probe = probe;
            let mut both = Both(onlooker, Watch::new(&self.tracer.plan.camera));
            self.send(&mut tally, 4, count / 4, place, &mut both);
            tally.outlined = outline <= both.1.farthest() * NEAR;
        } else {
            self.send(&mut tally, 4, count / 4, place, probe);
        }
        tally
    }

    /// The colour of a pixel, after as many more rays as it takes.
    fn refined(
        &self,
        mut tally: Tally,
        around: Colors,
        place: [usize; 2],
        probe: &mut impl Probe,
    ) -> Rgb {
        let Picture {
            transfer,
            max_error,
            ..
        } = *self.picture;
        let mut moved = if self.is_rough { f64::MAX } else { 0.0 };
        while tally.count < Picture::MOST_ADAPTIVE
            && tally.error(around, transfer).max(moved) > max_error
        {
            if self.is_rough {
                let mut more = tally.begun_anew();
                self.send(&mut more, 4, tally.count / 2, place, probe);
                // A filter is off in proportion to the area that it takes in, so it is still off by this.
                moved = more.moved_from(&tally, transfer);
                tally = more;
            } else {
                let size = tally.size();
                self.send(&mut tally, 2, size, place, probe);
                tally.put_together();
            }
        }
        tally.mean()
    }

    /// Sends so many parts of so many rays each through a pixel.
    fn send(
        &self,
        tally: &mut Tally,
        parts: u32,
        size: u32,
        [column, row]: [usize; 2],
        probe: &mut impl Probe,
    ) {
        // The camera counts rows from the bottom.
        let row = self.picture.height as usize - 1 - row;
        let end = tally.count + parts * size;
        let places = Places::new(Pattern::Sobol, column, row, end);
        #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^53")]
        let (x, y) = (column as f64, row as f64);
        let tracer = Tracer {
            rays: if self.is_rough { end } else { self.tracer.rays },
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

/// Whether more than its share of a pixel can come into the colour of a ray, or less.
///
/// The exact filter takes in just the share, unless round mirrors or glass bend it.
fn is_rough(scene: &Scene) -> bool {
    let bends = |surface: &dyn Surface| {
        let material = &surface.common().material;
        material.sends_on() && (surface.round().is_some() || material.ior.is_some())
    };
    let mut surfaces = scene.surfaces.iter();
    scene.is_filtered()
        && (scene.picture.texture_filter != Filter::Exact
            || surfaces.any(|surface| bends(&**surface)))
}
