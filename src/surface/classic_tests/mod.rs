//! That the classic algorithm does what it should.

mod weaknesses;

use std::sync::Arc;

use glam::DVec2;

use super::*;
use crate::material::Material;
use crate::math::{Point, direction, unit};
use crate::surface::{
    Ellipsoid, FinitePlane, Plane, ProceduralPlane, Shader, Sphere, TileStart, TiledPlane, Triangle,
};

fn material(name: &str, ambient: f64) -> Arc<Material> {
    Arc::new(Material {
        name: name.to_owned(),
        ambient: Rgb::new(ambient, ambient, ambient),
        diffuse: Rgb::WHITE,
        specular: Rgb::BLACK,
        shininess: 0.0,
        transparency: 0.0,
        ior: None,
    })
}

fn common() -> Common {
    Common::new(material("main", 2.0))
}

fn rectangle(corner: DVec3, normal: DVec3, xdir: DVec3, size: f64) -> FinitePlane {
    FinitePlane::new(common(), corner, normal, xdir, DVec2::splat(size)).expect("a rectangle")
}

fn ray(origin: DVec3, dir: DVec3) -> Ray<'static> {
    Ray::new(Point::exact(origin), unit(dir).expect("a direction"))
}

fn distance<T: Scalar>(asked: &dyn Surface, ray: &Ray) -> Option<f64> {
    let hit = surface::<T>(asked).hits(ray, Span::AHEAD);
    hit.map(|hit| hit.t)
}

/// Numbers from −1 to 1 without rhyme, the same on every run (Weyl 1916).
fn scatter(index: u32) -> [f64; 3] {
    [2f64.sqrt(), 3f64.sqrt(), 5f64.sqrt()]
        .map(|root| (f64::from(index) * root).fract() * 2.0 - 1.0)
}

#[test]
fn every_shape_is_met_where_the_robust_one_is() {
    let plane = || {
        Plane::new(
            common(),
            DVec3::new(0.0, -4.0, 0.0),
            DVec3::new(1.0, 5.0, 2.0),
        )
    };
    let corners = [[-1.0, -3.0, 1.0], [3.0, 2.0, 0.0], [-2.0, 3.0, 3.0]].map(DVec3::from);
    let scale = DVec3::new(2.0, 0.3, 1.1);
    let all: [Box<dyn Surface>; 5] = [
        Box::new(plane().expect("a plane")),
        Box::new(rectangle(
            DVec3::splat(-2.0),
            DVec3::new(1.0, 2.0, 3.0),
            DVec3::Y,
            4.0,
        )),
        Box::new(Triangle::new(common(), corners).expect("a triangle")),
        Box::new(Sphere::new(common(), DVec3::X, 1.5, None).expect("a sphere")),
        Box::new(Ellipsoid::new(common(), DVec3::Y, 1.2, scale, None).expect("an ellipsoid")),
    ];
    for robust in &all {
        let wide = surface::<f64>(&**robust);
        let narrow = surface::<f32>(&**robust);
        let mut met = 0;
        for index in 1..2000 {
            let ray = ray(
                DVec3::from(scatter(index)) * 6.0,
                scatter(index + 7000).into(),
            );
            let Some(hit) = robust.hits(&ray, Span::AHEAD.until(50.0)) else {
                continue;
            };
            met += 1;
            for (classic, rounding) in [(&wide, 1e-9), (&narrow, 1e-2)] {
                let found = classic.hits(&ray, Span::AHEAD).expect("the same hit");
                assert!((found.t - hit.t).abs() < rounding, "{robust:?}");
                assert!((found.point.world() - hit.point.world()).length() < rounding);
                assert!((found.normal - hit.normal).length() < rounding);
                assert!((found.uv - hit.uv).length() < rounding);
            }
        }
        assert!(met > 40, "{robust:?} was met {met} times");
    }
}

#[test]
fn a_ray_along_a_plane_misses_it() {
    let square = rectangle(DVec3::ZERO, DVec3::Z, DVec3::X, 1.0);
    for height in [0.0, -1.0] {
        let along = ray(DVec3::new(-5.0, 0.5, height), DVec3::X);
        assert_eq!(distance::<f64>(&square, &along), None);
        assert_eq!(distance::<f32>(&square, &along), None);
    }
}

/// E5, E6: what is behind a light or at it casts no shadow; what is before it does, from both
/// sides.
#[test]
fn a_shadow_lies_between_the_ends() {
    let square = rectangle(DVec3::ZERO, DVec3::Z, DVec3::X, 1.0);
    let occludes = |asked: &dyn Surface, from: f64, to: f64| {
        let at = |height: f64| DVec3::new(0.5, 0.5, height);
        let segment = Segment::free(Point::exact(at(from)), at(to));
        asked.occludes(&segment.expect("a segment"), Side::Back)
    };
    let classic = &*surface::<f64>(&square);
    assert!(occludes(classic, 1.0, -1.0) && occludes(classic, -1.0, 1.0));
    assert!(!occludes(classic, 1.0, 0.5) && !occludes(classic, 1.0, 0.0));
    assert!(!occludes(classic, 0.0, 1.0));
    // A light that is nearer behind the square than the offset.
    assert!(occludes(&square, 1.0, -5e-10) && !occludes(classic, 1.0, -5e-10));
}

#[test]
fn tiles_alternate_as_the_robust_ones_do() {
    for start in [TileStart::Point, TileStart::Course] {
        let plane = Plane::new(common(), DVec3::new(0.3, 0.0, 0.1), DVec3::Y).expect("a plane");
        let tile = DVec2::new(1.5, 0.5);
        let tiled = TiledPlane::new(plane, DVec3::X, tile, start, material("other", 3.0));
        let tiled = tiled.expect("tiles");
        for index in 0..1000 {
            let [x, z, _] = scatter(index).map(|place| place * 20.0);
            let down = ray(DVec3::new(x, 1.0, z), DVec3::NEG_Y);
            let ambient = |asked: &dyn Surface| {
                let hit = asked.hits(&down, Span::AHEAD).expect("a hit");
                asked.getamb(&hit)
            };
            assert_eq!(
                ambient(&tiled),
                ambient(&*surface::<f64>(&tiled)),
                "{start:?}"
            );
        }
    }
}

#[test]
fn a_formula_gets_the_offset_from_the_point() {
    let plane = Plane::new(common(), DVec3::new(5.0, 4.0, -1.0), DVec3::Z).expect("a plane");
    let wheel = ProceduralPlane::new(plane, Shader::ColorWheel);
    let ahead = ray(DVec3::new(7.0, 4.5, 3.0), DVec3::NEG_Z);
    let ambient = |asked: &dyn Surface| {
        let hit = asked.hits(&ahead, Span::AHEAD).expect("a hit");
        asked.getamb(&hit)
    };
    assert_eq!(ambient(&wheel), ambient(&*surface::<f64>(&wheel)));
}

/// A surface of which nothing is known but its own `hits`.
#[derive(Debug)]
struct Unknown(Plane);

impl Surface for Unknown {
    fn hits(&self, ray: &Ray, span: Span) -> Option<Hit> {
        self.0.hits(ray, span)
    }

    fn common(&self) -> &Common {
        self.0.common()
    }

    fn describe(&self) -> Node {
        self.0.describe()
    }
}

#[test]
fn an_unknown_surface_keeps_its_own_way_but_for_the_offset() {
    let plane = Plane::new(common(), DVec3::ZERO, DVec3::Y).expect("a plane");
    let unknown = Unknown(plane);
    let from = |height: f64| ray(DVec3::new(0.0, height, 0.0), DVec3::NEG_Y);
    assert_eq!(distance::<f64>(&unknown, &from(1.0)), Some(1.0));
    assert_eq!(distance::<f64>(&unknown, &from(5e-10)), None);
    let segment = |to: f64| {
        let start = Point::exact(DVec3::Y);
        Segment::free(start, DVec3::new(0.0, to, 0.0)).expect("a segment")
    };
    assert!(surface::<f64>(&unknown).occludes(&segment(-1.0), Side::Back));
    assert!(!surface::<f64>(&unknown).occludes(&segment(0.0), Side::On));
}

#[test]
fn robust_surfaces_are_left_alone() {
    let all: [Box<dyn Surface>; 1] = [Box::new(
        Plane::new(common(), DVec3::ZERO, DVec3::Y).expect("a plane"),
    )];
    assert!(surfaces(&all, Numerics::Robust).is_none());
    for numerics in [Numerics::Classic, Numerics::ClassicF32] {
        let classic = surfaces(&all, numerics).expect("other surfaces");
        assert_eq!(classic[0].describe(), all[0].describe());
        assert_eq!(classic[0].common(), all[0].common());
    }
}
