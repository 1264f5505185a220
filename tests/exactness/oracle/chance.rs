//! Rays that are not aimed, which rounded values decide.

use glam::DVec3;
use heliodon::math::{Point, Ray, Span, unit};

use super::equality::{SEED, cases as count};
use oracle::cases;
use oracle::tally::Tally;
use support::random::{Random, Style};

#[test]
fn random_rays_need_no_exact_arithmetic() {
    let mut tally = Tally::default();
    let mut rays = 0u64;
    for scene in 0..count().div_ceil(10) {
        let mut random = Random::of(SEED, scene);
        let surface = cases::surface(&mut random, Style::Uniform, 1.0);
        tally.observe_within(|_| {
            for _ in 0..1000 {
                let dir = unit(random.cube()).unwrap_or(DVec3::X);
                let ray = Ray::new(Point::exact(random.cube() * 4.0), dir);
                rays += u64::from(
                    surface
                        .hits(&ray, Span::AHEAD)
                        .is_none_or(|hit| hit.t > 0.0),
                );
            }
        });
    }
    println!(
        "{} of {rays} random rays were decided exactly",
        tally.exactly + tally.by_rule
    );
    assert_eq!(tally.exactly + tally.by_rule, 0, "of {rays} random rays");
}

/// One random ray in 10⁸ runs nearly along a given plane. It is decided by rounded values too,
/// unless it passes within rounding of a border.
#[test]
fn random_rays_nearly_along_a_plane_need_hardly_any_exact_arithmetic() {
    let (mut tally, mut rays) = (Tally::default(), 0);
    for scene in 0..count() / 10 {
        let mut random = Random::of(SEED, scene);
        let surface = cases::surface(&mut random, Style::Uniform, 1.0);
        let Some(flat) = surface.shape().carrier().copied() else {
            continue;
        };
        tally.observe_within(|_| {
            for _ in 0..20 {
                let way = random.cube();
                let along = unit(way - flat.normal * flat.normal.dot(way));
                let tilt = flat.normal * (random.signed() * random.power(-30, -27));
                let dir = unit(along.unwrap_or(DVec3::X) + tilt).unwrap_or(DVec3::X);
                let ray = Ray::new(Point::exact(random.cube() * 4.0), dir);
                surface.hits(&ray, Span::AHEAD);
                rays += 1;
            }
        });
    }
    let exactly = tally.exactly + tally.by_rule;
    println!("{exactly} of {rays} random rays nearly along a plane were decided exactly");
    assert!(exactly * 1000 < rays, "{exactly} of {rays}");
}
