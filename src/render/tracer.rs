//! The colour along one ray.

use glam::DVec3;

use crate::accel::Entry;
use crate::math::{Beam, Ray, RayOrigin, Rgb};
use crate::plan::{Plan, Scope};
use crate::surface::Hit;

use super::budget::Budget;
use super::media::Media;
use super::{Errors, Probe, RayKind, Scattering, Seed, Unfollowed};

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

/// Where a ray met a surface, and what rays that the surface sends on have to know of it.
#[derive(Debug, Clone, Copy)]
struct Meeting<'m, 'a> {
    entry: &'m Entry<'a>,
    hit: &'m Hit,
    ray: &'m Ray<'m>,
    path: &'m Path<'m>,
    /// What rounding may have done to the path up to here.
    errors: Errors,
    /// Distance from the eye to here, along all mirrors.
    travelled: f64,
    /// What light from here is divided by for that distance.
    divisor: f64,
    ray_origin: &'m RayOrigin<'m>,
}

/// A ray that a surface sends on.
#[derive(Debug, Clone, Copy)]
struct Onward<'a> {
    kind: RayKind,
    /// The share of what it brings back that the surface passes on.
    share: Rgb,
    dir: DVec3,
    turn: Scattering,
    /// What it is inside of.
    media: Media<'a>,
}

impl<'a> Tracer<'a> {
    /// A tracer that does what the plan says.
    #[must_use]
    pub fn new(plan: &'a Plan<'a>) -> Self {
        let picture = &plan.scene.settings;
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
        let span = plan.camera.limits(&ray);
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
        let mut budget = Budget::new(self.plan.scene.settings.missing_light());
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
        let span = self.plan.camera.limits(ray);
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
        let errors = if probe.follows_errors() {
            path.errors.at(ray, hit, entry.surface)
        } else {
            Errors::default()
        };
        probe.met(entry.index, hit, errors);
        let travelled = path.travelled + hit.t;
        let divisor = self.plan.scene.lighting.view_falloff.divisor(travelled);
        let sends_on = entry.sends_on || self.plan.scope == Scope::Everything;
        let color = if !sends_on && self.plan.is_unlit() {
            // No ray leaves here, so nothing has to be known of rays that would.
            let color = (entry.surface.getamb(hit) / divisor).saturated();
            probe.own_color(color, Rgb::BLACK);
            color
        } else {
            let ray_origin = &entry.ray_origin(ray, hit);
            let lit = (ray_origin, divisor, path.seed);
            let own = self.own_color(ray, (entry, hit), lit, probe);
            if sends_on {
                let meeting = Meeting {
                    entry,
                    hit,
                    ray,
                    path,
                    errors,
                    travelled,
                    divisor,
                    ray_origin,
                };
                self.with_sent_on(own, &meeting, budget, probe)
            } else {
                own
            }
        };
        probe.came_back(color);
        color
    }

    /// The colour of a surface whose own colour this is, with what comes through it and from before it.
    fn with_sent_on(
        &self,
        own: Rgb,
        meeting: &Meeting<'_, 'a>,
        budget: &mut Budget,
        probe: &mut impl Probe,
    ) -> Rgb {
        let Meeting { hit, ray, path, .. } = *meeting;
        let surface = meeting.entry.surface;
        let material = &meeting.entry.common.material;
        let boundary = path.media.boundary(material, ray.dir, hit.normal);
        let everything = self.sends_uncalled(path);
        probe.own_share(boundary.passing * (1.0 - material.transparency));
        let mut color = own * boundary.passing;
        if material.transparency > 0.0 || everything {
            // Of two rays each may cost what it weighs: in glass both go on and on.
            let is_called = material.transparency > 0.0;
            let aside = is_called.then(|| budget.put_aside(1.0 - boundary.passing));
            let through = boundary.onward.map_or(Rgb::BLACK, |dir| {
                let next = Onward {
                    kind: RayKind::Transmitted,
                    share: surface.transmits(hit) * boundary.passing,
                    dir,
                    turn: boundary.turn,
                    media: boundary.beyond,
                };
                self.follow(next, meeting, budget, probe)
            });
            if let Some(aside) = aside {
                budget.take_back(aside);
            }
            color = (color * (1.0 - material.transparency) + through).saturated();
        }
        if !boundary.mirrored.is_black() || everything {
            let next = Onward {
                kind: RayKind::Mirror,
                share: boundary.mirrored,
                dir: ray.mirrored(hit.normal),
                turn: Scattering::Mirrored,
                media: path.media,
            };
            color = (color + self.follow(next, meeting, budget, probe)).saturated();
        }
        color
    }

    /// What a ray that a surface sends on adds to the surface's colour.
    fn follow(
        &self,
        next: Onward<'_>,
        meeting: &Meeting<'_, 'a>,
        budget: &mut Budget,
        probe: &mut impl Probe,
    ) -> Rgb {
        let Meeting {
            entry,
            hit,
            ray,
            path,
            ..
        } = *meeting;
        let beam = path
            .beam
            .map(|beam| self.onward(beam, entry, (ray, hit), (next.kind, next.dir)));
        let onward = Path {
            travelled: meeting.travelled,
            weight: path.weight * next.share.largest(),
            media: next.media,
            errors: if probe.follows_errors() {
                meeting
                    .errors
                    .behind(entry.surface, next.turn, ray.dir, hit.normal)
            } else {
                meeting.errors
            },
            seed: path.seed.next(),
            beam: beam.as_ref(),
        };
        let uncalled = onward.weight == 0.0 && self.sends_uncalled(path);
        let worth = self.is_worth_following(&onward, meeting.divisor, budget);
        if let (Err(why), false) = (worth, uncalled) {
            probe.not_followed(next.kind, why);
            return Rgb::BLACK;
        }
        probe.ray(next.kind, next.share);
        // What nothing called for must not move, by so much as a rounding, what others may spend.
        let mut nothing = Budget::NOTHING;
        let budget = if uncalled { &mut nothing } else { budget };
        let ray = Ray::spawn(meeting.ray_origin, next.dir);
        next.share * self.trace(&ray, &onward, budget, probe)
    }

    /// Whether what a path meets sends on even rays that nothing calls for. Those have no weight, and what
    /// they meet sends on no others.
    fn sends_uncalled(&self, path: &Path) -> bool {
        self.plan.scope == Scope::Everything && path.weight > 0.0
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
