//! The colour along one ray.

use crate::accel::Entry;
use crate::math::{Beam, Ray, Rgb};
use crate::plan::{Plan, Scope};
use crate::surface::Hit;

use super::budget::Budget;
use super::media::Media;
use super::{Errors, Probe, RayKind, Seed, Turn, Unfollowed};

/// Finds the colours of a planned scene.
#[derive(Debug, Clone, Copy)]
pub struct Tracer<'a> {
    pub(super) plan: &'a Plan<'a>,
    /// How many rays go through the pixel, each of which shows a share of it.
    pub(super) rays: u32,
}

/// How a ray came to be where it is.
#[derive(Debug)]
struct Path<'a> {
    /// Distance from the eye to the ray's origin, along all mirrors.
    travelled: f64,
    /// The largest share of the ray's colour that reaches the pixel.
    weight: f64,
    /// What the ray is inside of.
    media: Media<'a>,
    /// What rounding may have done to it.
    errors: Errors,
    /// What tells it from other rays from the eye.
    seed: Seed,
    /// The rays around it, if a filter asks for them.
    beam: Option<&'a Beam>,
}

impl<'a> Tracer<'a> {
    /// A tracer that does what the plan says.
    #[must_use]
    pub fn new(plan: &'a Plan<'a>) -> Self {
        let picture = &plan.scene.picture;
        let rays = match plan.outlines {
            Some(_) => picture.first_rays(),
            None => picture.samples,
        };
        Self { plan, rays }
    }

    /// The colour at a place of the picture, counted in pixels from the lower-left pixel's centre.
    #[inline]
    pub fn sees(&self, x: f64, y: f64, probe: &mut impl Probe) -> Rgb {
        self.sees_as(x, y, Seed::of_place(x, y), probe)
    }

    /// The colour at a place of the picture, where what is chosen on the way is chosen by this seed.
    #[inline]
    pub(super) fn sees_as(&self, x: f64, y: f64, seed: Seed, probe: &mut impl Probe) -> Rgb {
        probe.ray(RayKind::Camera, Rgb::WHITE);
        let plan = self.plan;
        let (ray, mut tests) = (plan.camera.ray(x, y), 0);
        let span = plan.camera.span(&ray);
        let mut met = match &plan.sight {
            Some(sight) => sight.nearest([x, y], &ray, span, &mut tests),
            None => plan.surfaces.nearest(&ray, span, &mut tests),
        };
        probe.hit_tests(tests);
        match &mut met {
            Some((entry, hit)) => self.shown([x, y], &ray, (entry, hit), seed, probe),
            None => nothing(probe),
        }
    }

    /// The colour of what a ray from the eye through a place of the picture has met.
    #[inline]
    pub(super) fn shown(
        &self,
        [x, y]: [f64; 2],
        ray: &Ray,
        met: (&Entry<'a>, &mut Hit),
        seed: Seed,
        probe: &mut impl Probe,
    ) -> Rgb {
        let mut budget = Budget::new(self.plan.scene.picture.missing_light());
        let beam = self.plan.filter.map(|_| self.beam(x, y));
        let path = Path {
            travelled: 0.0,
            weight: 1.0,
            media: Media::Air,
            errors: Errors::default(),
            seed,
            beam: beam.as_ref(),
        };
        let color = self.color_of(met, ray, &path, &mut budget, probe);
        // Adding zero turns −0 into +0, which is the same colour.
        color + Rgb::BLACK
    }

    /// The colour that comes back along a ray; black where there is nothing.
    fn trace(&self, ray: &Ray, path: &Path, budget: &mut Budget, probe: &mut impl Probe) -> Rgb {
        let mut tests = 0;
        let span = self.plan.camera.span(ray);
        let mut met = self.plan.surfaces.nearest(ray, span, &mut tests);
        probe.hit_tests(tests);
        match &mut met {
            Some((entry, hit)) => self.color_of((entry, hit), ray, path, budget, probe),
            None => nothing(probe),
        }
    }

    /// The colour that comes back along a ray from what it met.
    fn color_of(
        &self,
        (entry, hit): (&Entry<'a>, &mut Hit),
        ray: &Ray,
        path: &Path,
        budget: &mut Budget,
        probe: &mut impl Probe,
    ) -> Rgb {
        if let Some(beam) = path.beam {
            hit.texel = self.texel_over(entry, hit, beam);
        }
        let hit = &*hit;
        let follows_errors = probe.follows_errors();
        let errors = if follows_errors {
            path.errors.at(ray, hit, entry.surface)
        } else {
            Errors::default()
        };
        probe.met(entry.index, hit, errors);
        let surface = entry.surface;
        let material = &entry.common.material;
        let travelled = path.travelled + hit.t;
        let divisor = self.plan.scene.lighting.view_falloff.divisor(travelled);
        let everything = self.plan.scope == Scope::Everything;
        let sends_on = entry.sends_on || everything;
        if !sends_on && self.plan.is_unlit() {
            // No ray leaves here, so nothing has to be known of rays that would.
            let color = (surface.getamb(hit) / divisor).saturated();
            probe.own_color(color, Rgb::BLACK);
            probe.came_back(color);
            return color;
        }
        let departure = entry.departure(ray, hit);
        let lit = (&departure, divisor, path.seed);
        let mut color = self.own_color(ray, (entry, hit), lit, probe);
        if !sends_on {
            probe.came_back(color);
            return color;
        }

        let boundary = path.media.boundary(material, ray.dir, hit.normal);
        let everything = everything && path.weight > 0.0;
        let follow = |share: Rgb, (dir, media, turn), kind, budget: &mut _, probe: &mut _| {
            let beam = path
                .beam
                .map(|beam| self.onward(beam, entry, (ray, hit), (kind, dir)));
            let path = Path {
                travelled,
                weight: path.weight * share.largest(),
                media,
                errors: if follows_errors {
                    errors.behind(surface, turn, ray.dir, hit.normal)
                } else {
                    errors
                },
                seed: path.seed.next(),
                beam: beam.as_ref(),
            };
            let uncalled = path.weight == 0.0 && everything;
            let worth = self.is_worth_following(&path, divisor, budget);
            if let (Err(why), false) = (worth, uncalled) {
                Probe::not_followed(probe, kind, why);
                return Rgb::BLACK;
            }
            Probe::ray(probe, kind, share);
            let next = Ray::leaving(&departure, dir);
            // What nothing called for must not move, by so much as a rounding, what others may spend.
            let mut nothing = Budget::NOTHING;
            let budget = if uncalled { &mut nothing } else { budget };
            share * self.trace(&next, &path, budget, probe)
        };
        Probe::own_share(probe, boundary.passing * (1.0 - material.transparency));
        color = color * boundary.passing;
        if material.transparency > 0.0 || everything {
            // Of two rays each may cost what it weighs: in glass both go on and on.
            let is_called = material.transparency > 0.0;
            let aside = is_called.then(|| budget.put_aside(1.0 - boundary.passing));
            let through = boundary.onward.map_or(Rgb::BLACK, |dir| {
                let share = surface.transmits(hit) * boundary.passing;
                let onward = (dir, boundary.beyond, boundary.turn);
                follow(share, onward, RayKind::Transmitted, budget, probe)
            });
            if let Some(aside) = aside {
                budget.take_back(aside);
            }
            color = (color * (1.0 - material.transparency) + through).saturated();
        }
        if !boundary.mirrored.is_black() || everything {
            let onward = (ray.mirrored(hit.normal), path.media, Turn::Mirrored);
            let mirrored = follow(boundary.mirrored, onward, RayKind::Mirror, budget, probe);
            color = (color + mirrored).saturated();
        }
        probe.came_back(color);
        color
    }

    /// Whether a path goes on; if not, what it could still have brought is spent.
    fn is_worth_following(
        &self,
        path: &Path,
        divisor: f64,
        budget: &mut Budget,
    ) -> Result<(), Unfollowed> {
        if path.travelled > self.plan.scene.lighting.reach {
            return Err(Unfollowed::BeyondReach);
        }
        budget.spend(self.plan.tail.of(path.weight, divisor))
    }
}

/// The colour that comes back along a ray that meets nothing.
pub(super) fn nothing(probe: &mut impl Probe) -> Rgb {
    probe.came_back(Rgb::BLACK);
    Rgb::BLACK
}
