//! Rows of pixels with one camera ray each, decided span by span where possible.

use super::tracer::nothing;
use super::{Event, Probe, RayKind, Seed, Tracer};
use crate::camera::PixelSpan;
use crate::film::Region;
use crate::math::{Crossings, Rgb};
use crate::visibility::{Primitive, Visible};

/// The largest number of pixels in a span.
///
/// With fewer pixels, the decision about a span saves less. With more, several surfaces are visible
/// in more of the spans.
const LONGEST: usize = 32;

impl<'a> Tracer<'a> {
    /// Draws a part of the picture, with one ray through the centre of each pixel.
    pub(super) fn draw(&self, part: Region, pixels: &mut [Rgb], probe: &mut impl Probe) {
        let height = self.plan.scene.settings.height as usize;
        for (number, pixels) in pixels.chunks_mut(part.width).enumerate() {
            // The picture's rows are counted from the top, the camera's from the bottom.
            let from_bottom = height - 1 - (part.top + number);
            let row = self.plan.camera.row(f64::from(to_u32(from_bottom)));
            let mut first = to_u32(part.left);
            for pixels in pixels.chunks_mut(LONGEST) {
                let span = PixelSpan {
                    row: &row,
                    first,
                    count: to_u32(pixels.len()),
                };
                self.draw_span(&span, pixels, probe);
                first += span.count;
            }
        }
    }

    fn draw_span(&self, span: &PixelSpan<'_>, pixels: &mut [Rgb], probe: &mut impl Probe) {
        let bounds = self.plan.screen_bounds.as_ref();
        match bounds.map_or(Visible::Several, |bounds| bounds.along(span)) {
            Visible::Nothing => {
                for pixel in pixels {
                    probe.on(Event::Ray(RayKind::Camera, Rgb::WHITE));
                    *pixel = nothing(probe);
                }
            }
            Visible::One(primitive) => self.draw_one(primitive, span, pixels, probe),
            Visible::Several => self.draw_each(span, pixels, probe),
        }
    }

    fn draw_each(&self, span: &PixelSpan<'_>, pixels: &mut [Rgb], probe: &mut impl Probe) {
        for (x, pixel) in span.centers().zip(pixels) {
            *pixel = self.sees(x, span.row.y, probe);
        }
    }

    /// Draws a pixel span in which only one surface can be visible.
    fn draw_one(
        &self,
        primitive: &Primitive<'a>,
        span: &PixelSpan<'_>,
        pixels: &mut [Rgb],
        probe: &mut impl Probe,
    ) {
        let screen = self.plan.camera.screen();
        let crossings = primitive.plane.map_or(Crossings::Unknown, |plane| {
            plane.crossings(&span.packet(), screen)
        });
        match crossings {
            Crossings::Never => {
                for pixel in pixels {
                    tested_once(probe);
                    *pixel = nothing(probe);
                }
            }
            Crossings::Unknown if screen.is_some() => self.draw_each(span, pixels, probe),
            Crossings::Unknown | Crossings::Always => {
                self.draw_packet(primitive, span, pixels, probe);
            }
        }
    }

    /// Draws a pixel span in which one surface can be visible, without limits of hits.
    fn draw_packet(
        &self,
        primitive: &Primitive<'a>,
        span: &PixelSpan<'_>,
        pixels: &mut [Rgb],
        probe: &mut impl Probe,
    ) {
        let row = span.row;
        let mut rays = [row.ray(0.0); LONGEST];
        let mut hits = [None; LONGEST];
        for (x, ray) in span.centers().zip(&mut rays) {
            ray.dir = row.dir(x);
        }
        let (rays, hits) = (&rays[..pixels.len()], &mut hits[..pixels.len()]);
        primitive.surface.shape().intersect_batch(rays, hits);
        let places = span.centers().zip(pixels);
        for ((ray, hit), (x, pixel)) in rays.iter().zip(hits).zip(places) {
            tested_once(probe);
            *pixel = match hit {
                Some(hit) => {
                    let seed = Seed::of_place(x, row.y);
                    self.shown([x, row.y], ray, (primitive, hit), seed, probe)
                }
                None => nothing(probe),
            };
        }
    }
}

/// Reports a camera ray for which one surface is tested.
fn tested_once(probe: &mut impl Probe) {
    probe.on(Event::Ray(RayKind::Camera, Rgb::WHITE));
    probe.on(Event::HitTests(1));
}

fn to_u32(number: usize) -> u32 {
    #[expect(clippy::cast_possible_truncation, reason = "sides are far below 2^32")]
    let number = number as u32;
    number
}
