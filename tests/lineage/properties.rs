//! What is true of any ray.

use std::sync::LazyLock;

use glam::DVec3;
use heliodon::math::{Point, Ray, Side, Span, unit};
use heliodon::surface::Surface;
use heliodon::visibility::{SurfaceList, carriers};
use proptest::prelude::*;

use super::tools::{Stage, ray};

/// Surfaces of every kind; the flat ones are turned any way, and some lie in one plane.
static SURFACES: LazyLock<Vec<Box<dyn Surface>>> = LazyLock::new(|| {
    let text = r#"
        plane { material "red"; point 0 -4 0; normal 1 5 2 }
        finite-plane { material "red"; point -2 -2 -2; normal 1 2 3; xdir 3 1 -1; dimensions 3 2 }
        finite-plane { material "red"; point 1 0 -1; normal 0 0 1; xdir 3 4 0; dimensions 3 2 }
        finite-plane { material "red"; point -3 1 -1; normal 0 0 -1; xdir -5 1 0; dimensions 4 4 }
        plane { material "red"; point 9 9 -1; normal 0 0 4 }
        tiled-plane {
            material "red"; alternate "blue"; point 4 0 0; normal 7 1 2; xdir 0 1 0; dimensions 1 2
        }
        procedural-plane { material "red"; point 0 4 0; normal 0 1 0; shader "stripes" }
        sphere { material "red"; center 1 -1 2; radius 1.5 }
        ellipsoid { material "red"; center -2 1 2; radius 1; scale 2 0.3 1.1 }
        triangle { material "red"; vertex1 -1 -3 1; vertex2 3 2 0; vertex3 -2 3 3 }"#;
    Stage::eye(text).scene().surfaces
});

fn direction() -> impl Strategy<Value = DVec3> {
    let cube = prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from);
    cube.prop_filter("a direction", |vector| vector.length() > 0.1)
}

fn place() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-6.0..6.0f64).prop_map(DVec3::from)
}

/// How far computed places may lie off, for a scene of about 100 units.
const ROUNDING: f64 = 1e-12;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// R9, S12: a hit lies on the ray, on its surface, and inside of its bounds; `t` is above zero
    /// and the normal is unit.
    #[test]
    fn a_hit_lies_on_ray_and_surface(origin in place(), dir in direction()) {
        let ray = ray(origin.into(), dir.into());
        for surface in SURFACES.iter() {
            let Some(hit) = surface.hits(&ray, Span::AHEAD) else { continue };
            prop_assert!(hit.t > 0.0);
            prop_assert!((hit.normal.length() - 1.0).abs() < ROUNDING);
            prop_assume!(hit.t < 100.0);
            let place = hit.point.world();
            prop_assert!((place - ray.at(hit.t).world()).length() < ROUNDING * 100.0);
            if let Some(flat) = surface.shape().carrier() {
                prop_assert!(flat.normal.dot(hit.point.from(flat.point)).abs() < ROUNDING);
            }
            let (nudge, one) = (hit.normal * 1e-6, Point::exact);
            prop_assert_eq!(surface.shape().side(&one(place + nudge)), Side::Front);
            prop_assert_eq!(surface.shape().side(&one(place - nudge)), Side::Back);
            if let Some(bounds) = surface.shape().bounds() {
                let slack = DVec3::splat(ROUNDING);
                prop_assert!(place.cmpge(bounds.min - slack).all(), "{} {:?}", place, bounds);
                prop_assert!(place.cmple(bounds.max + slack).all(), "{} {:?}", place, bounds);
            }
        }
    }

    /// S3: a ray that leaves a hit meets no flat surface of the same plane, nor its own ball.
    #[test]
    fn a_ray_does_not_meet_what_it_leaves(
        origin in place(), dir in direction(), onward in direction(),
    ) {
        let list = SurfaceList::new(&SURFACES);
        let ray = ray(origin.into(), dir.into());
        let Some((left, hit)) = list.nearest(&ray, Span::AHEAD, &mut 0) else { return Ok(()) };
        let ray_origin = left.ray_origin(&ray, &hit);
        let onward = Ray::spawn(&ray_origin, unit(onward).unwrap());
        if let Some((met, _)) = list.nearest(&onward, Span::AHEAD, &mut 0) {
            prop_assert_ne!(met.carrier, left.carrier);
            prop_assert_ne!(met.index, left.index);
            if let (Some(a), Some(b)) = (met.surface.shape().carrier(), left.surface.shape().carrier()) {
                prop_assert_ne!(a.decisive(), b.decisive());
            }
        }
    }

    /// S3: of all hits of a ray, the list finds the nearest.
    #[test]
    fn the_nearest_hit_is_the_smallest(origin in place(), dir in direction()) {
        let list = SurfaceList::new(&SURFACES);
        let ray = ray(origin.into(), dir.into());
        let all = SURFACES.iter().filter_map(|surface| surface.hits(&ray, Span::AHEAD));
        let smallest = all.map(|hit| hit.t).reduce(f64::min);
        let nearest = list.nearest(&ray, Span::AHEAD, &mut 0).map(|(_, hit)| hit.t);
        match (nearest, smallest) {
            // Of surfaces in one plane the first is taken, though rounding may put it behind.
            (Some(nearest), Some(smallest)) => {
                prop_assert!((nearest - smallest).abs() <= ROUNDING * smallest);
            }
            (nearest, smallest) => prop_assert_eq!(nearest, smallest),
        }
    }

    /// S3: a wider span finds the same hit, a narrower one does not invent another.
    #[test]
    fn a_span_only_takes_away(origin in place(), dir in direction(), far in 0.0..20.0f64) {
        let ray = ray(origin.into(), dir.into());
        for surface in SURFACES.iter() {
            let whole = surface.hits(&ray, Span::AHEAD);
            let near = surface.hits(&ray, Span::AHEAD.until(far));
            prop_assert_eq!(near, whole.filter(|hit| hit.t <= far));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// P4: surfaces in one plane lie on one sheet, however their points and normals are given, and
    /// of them the first in the file is seen.
    #[test]
    fn one_plane_is_one_sheet(
        normal in prop::array::uniform3(-9i32..=9),
        corner in prop::array::uniform3(-99i32..=99),
        aside in prop::array::uniform3(-9i32..=9),
        factor in 1i32..9,
        dir in direction(),
    ) {
        let [normal, corner, aside] = [normal, corner, aside].map(|v| DVec3::from(v.map(f64::from)));
        prop_assume!(normal != DVec3::ZERO);
        let plane = |point: DVec3, normal: DVec3| {
            let [p, n] = [point, normal].map(|v| format!("{} {} {}", v.x, v.y, v.z));
            format!("plane {{ material \"red\"; point {p}; normal {n} }}\n")
        };
        let (other, factor) = (corner + normal.cross(aside), f64::from(factor));
        let text = [
            plane(corner, normal),
            plane(other, normal),
            plane(other, normal * -factor),
            plane(other + normal, normal),
        ];
        let surfaces = Stage::eye(&text.concat()).scene().surfaces;
        let sheets = carriers(&surfaces);
        prop_assert_eq!(sheets[0], sheets[1]);
        prop_assert_eq!(sheets[0], sheets[2]);
        prop_assert_ne!(sheets[0], sheets[3]);
        let ray = ray((corner + normal * 0.3).into(), dir.into());
        if let Some((seen, ..)) = SurfaceList::new(&surfaces).nearest(&ray, Span::AHEAD, &mut 0) {
            prop_assert!(!std::ptr::addr_eq(seen, &*surfaces[1]));
            prop_assert!(!std::ptr::addr_eq(seen, &*surfaces[2]));
        }
    }

    /// S12: a ray aimed at a ball's centre hits it, and turned round misses.
    #[test]
    fn a_ray_at_the_centre_hits(origin in place(), center in place(), radius in 0.001..2.0f64) {
        prop_assume!((origin - center).length() > 2.5 * radius);
        let text = format!(
            "sphere {{ material \"red\"; center {0}; radius {radius} }}
            ellipsoid {{ material \"red\"; center {0}; radius {radius}; scale 2 0.5 1 }}",
            [center.x, center.y, center.z].map(|number| format!("{number:?}")).join(" "),
        );
        for ball in Stage::eye(&text).scene().surfaces {
            let aimed = ball.hits(&ray(origin.into(), (center - origin).into()), Span::AHEAD);
            prop_assert!(aimed.is_some_and(|hit| hit.normal.dot(origin - center) > 0.0));
            let turned = ball.hits(&ray(origin.into(), (origin - center).into()), Span::AHEAD);
            prop_assert_eq!(turned, None);
        }
    }
}
