//! Where a surface cannot put another one into shadow it is not asked, and does not.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use heliodon::geometry::{Hit, Rectangle};
use heliodon::math::{Point, Ray, Rgb, Segment, Side, Span, unit};
use heliodon::surface::{Plain, share};
use heliodon::visibility::{Emitter, LightView, Occlusion, Receiver, Silhouettes, SurfaceList};

use super::equality::{SEED, cases};
use oracle::cases::{Boxed, letting_through, rectangle, rim, round, triangle};
use support::random::{Random, Style};

/// Rays for each scene.
const EACH: u64 = 60;

#[test]
fn what_is_not_asked_hides_nothing() {
    let mut spared = 0;
    for scene in 0..cases().div_ceil(EACH) {
        let mut random = Random::of(SEED, scene);
        let place = Place::any(&mut random);
        let surfaces = place.furniture(&mut random);
        let list = SurfaceList::new(&surfaces);
        let [light, eye] = [0; 2].map(|_| place.free(&mut random));
        let is_before = |surface: usize| {
            let surface = &surfaces[surface];
            surface.shape().carrier().is_none()
                || surface.shape().side(&Point::exact(light)) == Side::Front
        };
        let silhouettes = Arc::new(Silhouettes::new(surfaces.len()));
        let emitter = Emitter::Point(light);
        let view = |all| LightView::new(&list, &silhouettes, emitter, all, is_before);
        let (all, fewer) = (view(true), view(false));
        for _ in 0..EACH {
            let Some(dir) = unit(aimed(&mut random, &surfaces, light) - eye) else {
                continue;
            };
            let seen = Ray::new(Point::exact(eye), dir);
            let Some((entry, hit)) = list.nearest(&seen, Span::AHEAD, &mut 0) else {
                continue;
            };
            let ray_origin = entry.ray_origin(&seen, &hit);
            let Some(segment) = Segment::new(&ray_origin, light) else {
                continue;
            };
            if segment.ray.dir.dot(hit.normal) <= 0.0 {
                continue;
            }
            let (Some(all), Some(fewer)) = (all.receiver(entry), fewer.receiver(entry)) else {
                continue;
            };
            let (mut tests, mut fewer_tests) = (0, 0);
            let passes = passed(&all, &hit, &segment, &mut tests);
            let passed = passed(&fewer, &hit, &segment, &mut fewer_tests);
            assert_eq!(
                passed, passes,
                "scene {scene} with {surfaces:#?}\n{light:?} {seen:?} {hit:?}"
            );
            spared += tests - fewer_tests;
        }
    }
    assert!(spared > cases() / 10, "only {spared} questions were spared");
}

/// The share of light that passes what is before it.
fn passed(receiver: &Receiver<'_, '_>, hit: &Hit, segment: &Segment, tests: &mut u64) -> Rgb {
    match receiver.occlusion(hit, &segment.ray) {
        Occlusion::None => Rgb::WHITE,
        Occlusion::Full => Rgb::BLACK,
        Occlusion::Partial(occluders) => occluders.transmittance(segment, tests),
    }
}

/// Where a scene is and how large.
pub(super) struct Place {
    pub(super) far: f64,
    pub(super) scale: f64,
    /// The share of light that passes its sheets.
    pub(super) transparency: f64,
}

impl Place {
    pub(super) fn any(random: &mut Random) -> Self {
        let power = |random: &mut Random| random.pick(&[2f64.powi(-60), 2f64.powi(60)]);
        Self {
            far: random.pick(&[0.0, 0.0, 1e9]),
            scale: if random.once_in(4) {
                power(random)
            } else {
                1.0
            },
            transparency: 0.5,
        }
    }

    /// Somewhere in the scene; half of the coordinates are shared with others.
    pub(super) fn free(&self, random: &mut Random) -> DVec3 {
        let style = random.pick(&[Style::Whole, Style::Whole, Style::Decimal]);
        self.moved(random.vector(style))
    }

    fn moved(&self, point: DVec3) -> DVec3 {
        (point + self.far) * self.scale
    }

    /// A few surfaces: boxes that meet in edges and corners and at Ts, or anything.
    pub(super) fn furniture(&self, random: &mut Random) -> Vec<Boxed> {
        if random.once_in(3) {
            let style = random.style();
            let kinds = [rectangle, rectangle, triangle, round];
            return (0..random.between(2, 6))
                .map(|_| random.pick(&kinds)(random, style, self.scale))
                .collect();
        }
        let sheets = (0..random.between(2, 9)).map(|_| self.sheet(random));
        let mut surfaces: Vec<_> = sheets.collect();
        if self.far == 0.0 && random.once_in(2) {
            surfaces.push(round(random, Style::Whole, self.scale));
        }
        share(&mut surfaces);
        surfaces
    }

    /// A rectangle along the world's axes with corners at whole numbers.
    fn sheet(&self, random: &mut Random) -> Boxed {
        let axis = random.below(3) as usize;
        let mut corner = [0; 3].map(|_| f64::from(random.between(-4, 4)));
        corner[axis] = f64::from(random.between(-2, 2));
        let size = DVec2::from([0; 2].map(|_| f64::from(random.between(1, 6)))) * self.scale;
        let (normal, xdir) = (DVec3::AXES[axis], DVec3::AXES[(axis + 1) % 3]);
        let facing = random.pick(&[-1.0, 1.0]);
        let corner = self.moved(corner.into());
        let made = Rectangle::new(corner, normal * facing, xdir, size);
        let common = letting_through(self.transparency);
        Box::new(Plain::new(common, made.expect("a rectangle")))
    }
}

/// A place on a surface, or where the shadow of one's border falls, or a little beside either.
pub(super) fn aimed(random: &mut Random, surfaces: &[Boxed], light: DVec3) -> DVec3 {
    let any = |random: &mut Random| {
        &surfaces[random.below(u32::try_from(surfaces.len()).unwrap_or(1)) as usize]
    };
    let (caster, receiver) = (any(random), any(random));
    let place = border(random, caster, light);
    let place = match receiver.shape().carrier() {
        Some(flat) if random.once_in(2) => {
            let (height, fall) = (
                flat.normal.dot(light - flat.point),
                flat.normal.dot(light - place),
            );
            light + (place - light) * (height / fall)
        }
        _ => place,
    };
    if random.once_in(2) {
        place
    } else {
        place + random.cube() * (place - light).length() * random.power(-52, -2)
    }
}

/// A place on the border of a surface, as seen from a light.
fn border(random: &mut Random, surface: &Boxed, light: DVec3) -> DVec3 {
    if let Some([center, axes]) = surface.shape().round() {
        return rim(random, center, axes, light);
    }
    let corners = surface.shape().outline();
    let index = random.below(u32::try_from(corners.len()).unwrap_or(1)) as usize;
    let next = corners[(index + 1) % corners.len()];
    corners[index].lerp(next, random.pick(&[0.0, 0.5, random.clone().share()]))
}
