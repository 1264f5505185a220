//! Rows of the picture, one ray for each pixel, in stretches of which much is known at once.

use super::tracer::nothing;
use super::{Probe, RayKind, Seed, Tracer};
use crate::accel::{Ahead, Entry};
use crate::camera::PixelSpan;
use crate::film::Region;
use crate::math::{Crossings, Distances, Rgb};

/// The most pixels in a stretch. Fewer, and what is found out about each is seldom used; more, and in
/// more of them several surfaces can be seen.
const LONGEST: usize = 32;

impl<'a> Tracer<'a> {
    /// Gives the pixels of a part of the picture their colours, each by one ray through its centre.
    pub(super) fn draw(&self, part: Region, pixels: &mut [Rgb], probe: &mut impl Probe) {
        let height = self.plan.scene.settings.height as usize;
        for (number, pixels) in pixels.chunks_mut(part.width).enumerate() {
            // The picture's rows are counted from the top, the camera's from the bottom.
            let from_bottom = height - 1 - (part.top + number);
            let row = self.plan.camera.row(f64::from(small(from_bottom)));
            let mut first = small(part.left);
            for pixels in pixels.chunks_mut(LONGEST) {
                let stretch = PixelSpan {
                    row: &row,
                    first,
                    count: small(pixels.len()),
                };
                self.draw_stretch(&stretch, pixels, probe);
                first += stretch.count;
            }
        }
    }

    fn draw_stretch(&self, stretch: &PixelSpan<'_>, pixels: &mut [Rgb], probe: &mut impl Probe) {
        let sight = self.plan.sight.as_ref();
        match sight.map_or(Ahead::Several, |sight| sight.along(stretch)) {
            Ahead::Nothing => {
                for pixel in pixels {
                    probe.ray(RayKind::Camera, Rgb::WHITE);
                    *pixel = nothing(probe);
                }
            }
            Ahead::One(entry) => self.draw_one(entry, stretch, pixels, probe),
            Ahead::Several => self.draw_each(stretch, pixels, probe),
        }
    }

    fn draw_each(&self, stretch: &PixelSpan<'_>, pixels: &mut [Rgb], probe: &mut impl Probe) {
        for (x, pixel) in stretch.centers().zip(pixels) {
            *pixel = self.sees(x, stretch.row.y, probe);
        }
    }

    /// Draws a stretch through which rays can meet no surface but one.
    fn draw_one(
        &self,
        entry: &Entry<'a>,
        stretch: &PixelSpan<'_>,
        pixels: &mut [Rgb],
        probe: &mut impl Probe,
    ) {
        let screen = self.plan.camera.screen();
        let crossings = entry.flat.map_or(Crossings::Unknown, |flat| {
            flat.crossings(&stretch.packet(), screen)
        });
        let is_plain = self.plan.is_unlit() && probe.only_counts();
        match (crossings, entry.plain.filter(|_| is_plain)) {
            (Crossings::Never, _) => {
                for pixel in pixels {
                    asked_once(probe);
                    *pixel = nothing(probe);
                }
            }
            (Crossings::Always(distances), Some(ambient)) => {
                pixels.iter().for_each(|_| asked_once(probe));
                self.fade(ambient, &distances, stretch, pixels);
            }
            (Crossings::Unknown, _) if screen.is_some() => self.draw_each(stretch, pixels, probe),
            _ => self.draw_together(entry, stretch, pixels, probe),
        }
    }

    /// Draws a stretch through which rays can meet no surface but one, which counts wherever they do.
    fn draw_together(
        &self,
        entry: &Entry<'a>,
        stretch: &PixelSpan<'_>,
        pixels: &mut [Rgb],
        probe: &mut impl Probe,
    ) {
        let row = stretch.row;
        let mut rays = [row.ray(0.0); LONGEST];
        let mut met = [None; LONGEST];
        for (x, ray) in stretch.centers().zip(&mut rays) {
            ray.dir = row.dir(x);
        }
        let (rays, met) = (&rays[..pixels.len()], &mut met[..pixels.len()]);
        entry.surface.meetings(rays, met);
        let places = stretch.centers().zip(pixels);
        for ((ray, met), (x, pixel)) in rays.iter().zip(met).zip(places) {
            asked_once(probe);
            *pixel = match met {
                Some(hit) => {
                    let seed = Seed::of_place(x, row.y);
                    self.shown([x, row.y], ray, (entry, hit), seed, probe)
                }
                None => nothing(probe),
            };
        }
    }

    /// Gives pixels a colour, faded by the distances from the eye.
    fn fade(&self, color: Rgb, distances: &Distances, stretch: &PixelSpan<'_>, pixels: &mut [Rgb]) {
        // Distances first, so that the processor can find several at once.
        let mut found = [0.0; LONGEST];
        for (x, found) in stretch.centers().zip(&mut found) {
            *found = distances.along(stretch.row.dir(x));
        }
        let falloff = self.plan.scene.lighting.view_falloff;
        for (pixel, distance) in pixels.iter_mut().zip(&found) {
            *pixel = (color / falloff.divisor(*distance)).saturated() + Rgb::BLACK;
        }
    }
}

/// Tells of a ray from the eye for which one surface is asked.
fn asked_once(probe: &mut impl Probe) {
    probe.ray(RayKind::Camera, Rgb::WHITE);
    probe.hit_tests(1);
}

fn small(number: usize) -> u32 {
    #[expect(clippy::cast_possible_truncation, reason = "sides are far below 2^32")]
    let small = number as u32;
    small
}
