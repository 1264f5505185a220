//! The colour along one ray.

use glam::DVec3;

use crate::geometry::{Hit, Resolved};
use crate::math::{Beam, Ray, RayOrigin, Rgb};
use crate::plan::{Plan, Scope};
use crate::visibility::Primitive;

use super::budget::Budget;
use super::media::Media;
use super::{Errors, Event, Probe, RayKind, Scattering, Seed, Unfollowed};

/// The tracer of a planned scene: it finds the colours along rays.
#[derive(Debug, Clone, Copy)]
pub struct Tracer<'a> {
    pub(super) plan: &'a Plan<'a>,
    /// The number of camera rays in the pixel, each of which shows a share of it.
    pub(super) rays: u32,
}

/// The history of a ray: the path from the eye to its origin.
#[derive(Debug)]
pub(super) struct Path<'a> {
    /// The length of the path.
    travelled: f64,
    /// The largest share of the ray's colour that reaches the pixel.
    weight: f64,
    /// The media that the ray is inside of.
    media: Media<'a>,
    /// The errors at the ray's origin.
    errors: Errors,
    /// The seed of random choices along the path.
    pub(super) seed: Seed,
    /// The rays around it, if a texture filter needs them.
    pub(super) beam: Option<&'a Beam>,
}

/// A resolved hit in its context: all that shading and further rays depend on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Interaction<'m, 'a> {
    pub(super) primitive: &'m Primitive<'a>,
    pub(super) hit: &'m Hit,
    pub(super) ray: &'m Ray<'m>,
    pub(super) path: &'m Path<'m>,
    /// The origin of rays that start here.
    pub(super) ray_origin: &'m RayOrigin<'m>,
    /// The errors of the hit.
    errors: Errors,
    /// The length of the path from the eye to here.
    travelled: f64,
    /// The divisor of light from here, for that length.
    pub(super) divisor: f64,
}

/// A ray that a surface reflects or transmits.
#[derive(Debug, Clone, Copy)]
struct Onward<'a> {
    kind: RayKind,
    /// The share of its colour that the surface passes on.
    share: Rgb,
    dir: DVec3,
    scattering: Scattering,
    /// The media that it is inside of.
    media: Media<'a>,
}

impl<'a> Tracer<'a> {
    /// A tracer of a planned scene.
    #[must_use]
    pub fn new(plan: &'a Plan<'a>) -> Self {
        let settings = &plan.scene.settings;
        let rays = match plan.outlines {
            Some(_) => settings.first_rays(),
            None => settings.samples,
        };
        Self { plan, rays }
    }

    /// The colour at a raster position, in pixels from the lower-left pixel's centre.
    #[inline]
    pub fn sees(&self, x: f64, y: f64, probe: &mut impl Probe) -> Rgb {
        self.sees_as(x, y, Seed::of_place(x, y), probe)
    }

    /// The colour at a raster position, with this seed of random choices.
    #[inline]
    pub(super) fn sees_as(&self, x: f64, y: f64, seed: Seed, probe: &mut impl Probe) -> Rgb {
        probe.on(Event::Ray(RayKind::Camera, Rgb::WHITE));
        let plan = self.plan;
        let (ray, mut tests) = (plan.camera.ray(x, y), 0);
        let span = plan.camera.limits(&ray);
        let found = match &plan.screen_bounds {
            Some(bounds) => bounds.nearest([x, y], &ray, span, &mut tests),
            None => plan.surfaces.nearest(&ray, span, &mut tests),
        };
        probe.on(Event::HitTests(tests));
        match &found {
            Some((primitive, hit)) => self.shown([x, y], &ray, (primitive, hit), seed, probe),
            None => nothing(probe),
        }
    }

    /// The colour of the hit of a camera ray through a raster position.
    #[inline]
    pub(super) fn shown(
        &self,
        [x, y]: [f64; 2],
        ray: &Ray,
        found: (&Primitive<'a>, &Hit),
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
        let color = self.color_of(found, ray, &path, &mut budget, probe);
        // Adding zero turns −0 into +0, which is the same colour.
        color + Rgb::BLACK
    }

    /// The colour along a ray; black if it hits nothing.
    fn trace(&self, ray: &Ray, path: &Path, budget: &mut Budget, probe: &mut impl Probe) -> Rgb {
        let mut tests = 0;
        let span = self.plan.camera.limits(ray);
        let found = self.plan.surfaces.nearest(ray, span, &mut tests);
        probe.on(Event::HitTests(tests));
        match &found {
            Some((primitive, hit)) => self.color_of((primitive, hit), ray, path, budget, probe),
            None => nothing(probe),
        }
    }

    /// The colour along a ray from the surface that it hits.
    fn color_of(
        &self,
        (primitive, hit): (&Primitive<'a>, &Hit),
        ray: &Ray,
        path: &Path,
        budget: &mut Budget,
        probe: &mut impl Probe,
    ) -> Rgb {
        let hit = &self.resolve(primitive, hit, ray, path);
        let errors = if probe.follows_errors() {
            path.errors.at(ray, hit, primitive.surface.shape())
        } else {
            Errors::default()
        };
        probe.on(Event::Hit(primitive.index, hit, errors));
        let travelled = path.travelled + hit.t;
        let divisor = self.plan.scene.lighting.view_falloff.divisor(travelled);
        let sends_on = primitive.sends_on || self.plan.scope == Scope::Everything;
        let color = if !sends_on && self.plan.is_unlit() {
            // No ray starts here, so nothing has to be computed for one.
            let color = (primitive.surface.getamb(hit) / divisor).saturated();
            let of_lamps = Rgb::BLACK;
            probe.on(Event::OwnColor { color, of_lamps });
            color
        } else {
            let interaction = Interaction {
                primitive,
                hit,
                ray,
                path,
                ray_origin: &primitive.ray_origin(ray, hit),
                errors,
                travelled,
                divisor,
            };
            let own = self.own_color(&interaction, probe);
            if sends_on {
                self.with_sent_on(own, &interaction, budget, probe)
            } else {
                own
            }
        };
        probe.on(Event::Returned(color));
        color
    }

    /// The hit at its exact texel or tile, with the image's colour.
    ///
    /// The colour is the texel's, or the mean over the footprint.
    #[inline(always)]
    fn resolve(&self, primitive: &Primitive<'a>, hit: &Hit, ray: &Ray, path: &Path) -> Hit {
        let Resolved { uv, mut texel } = primitive.resolve(hit, ray);
        if let Some(beam) = path.beam {
            texel = self.texel_over(primitive, &Hit { uv, texel, ..*hit }, beam);
        }
        Hit { uv, texel, ..*hit }
    }

    /// The colour of a surface: its own, transmitted and reflected.
    fn with_sent_on(
        &self,
        own: Rgb,
        at: &Interaction<'_, 'a>,
        budget: &mut Budget,
        probe: &mut impl Probe,
    ) -> Rgb {
        let Interaction { hit, ray, path, .. } = *at;
        let common = at.primitive.common;
        let material = &common.material;
        let boundary = path.media.boundary(material, ray.dir, hit.normal);
        let everything = self.sends_uncalled(path);
        let own_share = boundary.passing * (1.0 - material.transparency);
        probe.on(Event::OwnShare(own_share));
        let mut color = own * boundary.passing;
        if material.transparency > 0.0 || everything {
            // Each of two rays gets a share of the budget, because in glass both continue to split.
            let is_called = material.transparency > 0.0;
            let aside = is_called.then(|| budget.put_aside(1.0 - boundary.passing));
            let through = boundary.onward.map_or(Rgb::BLACK, |dir| {
                let next = Onward {
                    kind: RayKind::Transmitted,
                    share: common.transmits(hit.texel) * boundary.passing,
                    dir,
                    scattering: boundary.scattering,
                    media: boundary.beyond,
                };
                self.follow(next, at, budget, probe)
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
                scattering: Scattering::Reflected,
                media: path.media,
            };
            color = (color + self.follow(next, at, budget, probe)).saturated();
        }
        color
    }

    /// The colour that a reflected or transmitted ray adds to the surface's.
    fn follow(
        &self,
        next: Onward<'_>,
        at: &Interaction<'_, 'a>,
        budget: &mut Budget,
        probe: &mut impl Probe,
    ) -> Rgb {
        let path = at.path;
        let beam = path
            .beam
            .map(|beam| self.onward(beam, at, next.kind, next.dir));
        let onward = Path {
            travelled: at.travelled,
            weight: path.weight * next.share.largest(),
            media: next.media,
            errors: if probe.follows_errors() {
                let shape = at.primitive.surface.shape();
                let scattering = next.scattering;
                at.errors
                    .behind(shape, scattering, at.ray.dir, at.hit.normal)
            } else {
                at.errors
            },
            seed: path.seed.next(),
            beam: beam.as_ref(),
        };
        let uncalled = onward.weight == 0.0 && self.sends_uncalled(path);
        let worth = self.is_worth_following(&onward, at.divisor, budget);
        if let (Err(why), false) = (worth, uncalled) {
            probe.on(Event::NotFollowed(next.kind, why));
            return Rgb::BLACK;
        }
        probe.on(Event::Ray(next.kind, next.share));
        // A ray without weight must not change the budget of others, not even by rounding.
        let mut nothing = Budget::NOTHING;
        let budget = if uncalled { &mut nothing } else { budget };
        let ray = Ray::spawn(at.ray_origin, next.dir);
        next.share * self.trace(&ray, &onward, budget, probe)
    }

    /// Returns whether surfaces on a path scatter even rays without weight.
    ///
    /// The surfaces that such rays hit scatter no others.
    fn sends_uncalled(&self, path: &Path) -> bool {
        self.plan.scope == Scope::Everything && path.weight > 0.0
    }

    /// Decides whether a path goes on; if not, it spends the light that it could add.
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

/// The colour along a ray that hits nothing.
pub(super) fn nothing(probe: &mut impl Probe) -> Rgb {
    probe.on(Event::Returned(Rgb::BLACK));
    Rgb::BLACK
}
