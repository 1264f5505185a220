//! Where nothing, or all of a lamp, is said to be hidden, no ray finds anything else.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use heliodon::language::Node;
use heliodon::math::{Point, Ray, Rgb, Segment, Span, unit};
use heliodon::surface::Lamp;
use heliodon::visibility::{Emitter, LightView, Occlusion, Silhouettes, SurfaceList};

use super::equality::{SEED, cases};
use super::shades::{Place, aimed};
use oracle::cases::common;
use support::random::Random;

/// Rays for each scene.
const EACH: u64 = 40;

/// `SamplePositions` of the lamp for each ray.
const PLACES: u64 = 4;

#[test]
fn what_is_known_of_a_lamp_without_a_ray_is_what_rays_find() {
    let (mut open, mut walls) = (0, 0);
    for scene in 0..cases().div_ceil(EACH * PLACES) {
        let mut random = Random::of(SEED ^ 1, scene);
        let place = Place {
            transparency: 0.0,
            ..Place::any(&mut random)
        };
        let mut surfaces = place.furniture(&mut random);
        let lamp = lamp(&mut random, &place);
        surfaces.push(Box::new(lamp));
        let list = SurfaceList::new(&surfaces);
        let silhouettes = Arc::new(Silhouettes::new(surfaces.len()));
        let emitter = Emitter::lamps(&list).next().expect("a lamp");
        let source = emitter.silhouette();
        let is_lit = |surface: usize| {
            let receiver = silhouettes.of(&list.primitives()[surface]);
            source.can_light(receiver)
        };
        let [all, fewer] =
            [true, false].map(|all| LightView::new(&list, &silhouettes, emitter, all, is_lit));
        let lamp = emitter.lamp().expect("a lamp");
        let eye = place.free(&mut random);
        for _ in 0..EACH {
            let light = lamp.sample(&Point::exact(eye), DVec3::Z, DVec2::splat(0.5));
            let Some(dir) = unit(aimed(&mut random, &surfaces, light.0.world()) - eye) else {
                continue;
            };
            let seen = Ray::new(Point::exact(eye), dir);
            let Some((entry, hit)) = list.nearest(&seen, Span::AHEAD, &mut 0) else {
                continue;
            };
            let (Some(all), Some(fewer)) = (all.receiver(entry), fewer.receiver(entry)) else {
                continue;
            };
            if entry.surface.lamp().is_some() {
                continue;
            }
            let ray_origin = entry.ray_origin(&seen, &hit);
            let spawn = Ray::spawn(&ray_origin, hit.normal);
            let known = fewer.occlusion(&hit, &spawn);
            match known {
                Occlusion::None => open += 1,
                Occlusion::Full => walls += 1,
                Occlusion::Partial(_) => {}
            }
            let asked = all.occlusion(&hit, &spawn);
            for _ in 0..PLACES {
                let at = DVec2::from([0; 2].map(|_| random.share()));
                let (end, weight) = lamp.sample(&hit.point, hit.normal, at);
                let segment = Segment::new(&ray_origin, end);
                let Some(segment) = segment.filter(|_| weight > 0.0) else {
                    continue;
                };
                assert_eq!(
                    passed(&known, &segment),
                    passed(&asked, &segment),
                    "scene {scene} with {surfaces:#?}\n{seen:?} {hit:?} {end:?}"
                );
            }
        }
    }
    let least = cases() / (EACH * PLACES);
    assert!(
        open > least && walls > least / 8,
        "{open} open, {walls} hidden"
    );
}

/// The share of light that passes along a segment to a lamp.
fn passed(occlusion: &Occlusion<'_, '_>, segment: &Segment<'_>) -> Rgb {
    match occlusion {
        Occlusion::None => Rgb::WHITE,
        Occlusion::Full => Rgb::BLACK,
        Occlusion::Partial(casters) => casters.transmittance(segment, &mut 0),
    }
}

/// A rectangle or a ball that shines, somewhere among the surfaces.
fn lamp(random: &mut Random, place: &Place) -> Lamp {
    let size = |random: &mut Random| f64::from(random.between(1, 4)) * place.scale;
    let at = place.free(random);
    let node = Node::new(&Lamp::SCHEMA, None);
    let node = if random.once_in(3) {
        let radius = size(random) / 8.0;
        node.with("center", at).with("radius", radius)
    } else {
        let axis = random.below(3) as usize;
        let (normal, xdir) = (DVec3::AXES[axis], DVec3::AXES[(axis + 1) % 3]);
        let dimensions = DVec2::from([0; 2].map(|_| size(random)));
        node.with("point", at)
            .with("normal", normal * random.pick(&[-1.0, 1.0]))
            .with("xdir", xdir)
            .with("dimensions", dimensions)
    };
    let node = node.with("emissivity", DVec3::ONE).with("samples", 4.0);
    Lamp::from_node(&node, common()).expect("a lamp")
}
