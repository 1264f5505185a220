//! What a lamp gives, and how it is seen.

use std::f64::consts::PI;

use glam::DVec3;
use heliodon::math::form_factor;
use heliodon::plan::Scope;

use super::{bits, drawn, picture};

/// Where a pixel's centre looks at the floor from above: a camera at (0, 9, 0) that sees 4 × 4 units of
/// it in 32 × 32 pixels, x to the right and z downward.
const FROM_ABOVE: &str = "image 32 32\n\
    camera { viewpoint 0 9 0; look-at 0 0 0; up 0 0 -1; field-of-view 25.057615418303023 }\n\
    material \"chalk\" { diffuse 0.5 }\n\
    plane \"floor\" { material \"chalk\"; point 0 0 0; normal 0 1 0 }\n";

fn seen_by(x: usize, y: usize) -> DVec3 {
    let along = |pixel: usize| (pixel as f64 - 15.5) / 8.0;
    DVec3::new(along(x), 0.0, along(y))
}

#[test]
fn an_unhidden_lamp_gives_its_form_factor_and_asks_nothing() {
    // A ball behind each lamp, and a wall beside it, hide nothing.
    let rest = "lamp \"l\" { point 3 1 -3; normal -1 0 0; xdir 0 0 1; dimensions 2 1.5; emissivity 4 }\n\
        lamp \"g\" { center -4 0.5 0; radius 0.75; emissivity 3 }\n\
        material \"black\" { }\n\
        sphere \"ball\" { material \"black\"; center 5 2 -2; radius 1 }\n\
        sphere \"moon\" { material \"black\"; center -6 1 0; radius 1 }\n\
        finite-plane \"wall\" { material \"black\"; point -9 0 -5; normal 0 0 1; xdir 1 0 0; dimensions 18 3 }";
    let (film, counts) = drawn(&format!("{FROM_ABOVE}{rest}"));
    assert_eq!(counts.lamp_rays, 0);
    let corners = [[1.0, -3.0], [1.0, -1.0], [2.5, -1.0], [2.5, -3.0]];
    for (x, y) in (0..32).flat_map(|x| (0..32).map(move |y| (x, y))) {
        let place = seen_by(x, y);
        let corners = corners.map(|[y, z]| DVec3::new(3.0, y, z) - place);
        let pane = form_factor::of_polygon(&corners, DVec3::Y);
        let globe = form_factor::of_ball(DVec3::new(-4.0, 0.5, 0.0) - place, 0.75, DVec3::Y);
        let expected = 0.5 * (4.0 * pane + 3.0 * globe);
        let found = film.pixel(x, y).r;
        assert!(
            (found / expected - 1.0).abs() < 1e-12,
            "{x} {y}: {found} {expected}"
        );
    }
}

#[test]
fn a_lamp_is_seen_from_its_front_and_in_mirrors() {
    let look = |eye: &str, lamp: &str| {
        let scene = format!(
            "image 1 1\ncamera {{ viewpoint {eye}; look-at 0 0 0 }}\n\
             material \"mirror\" {{ specular 0.5 }}\n\
             lamp {{ {lamp}; emissivity 3 2 1 }}\n\
             finite-plane \"mirror\" {{ material \"mirror\"; point -1 -1 -4; normal 0 0 1; xdir 1 0 0; dimensions 2 2 }}"
        );
        drawn(&scene).0.pixel(0, 0).channels()
    };
    let pane = "point -1 -1 0; xdir 1 0 0; dimensions 2 2; normal 0 0 1";
    assert_eq!(look("0 0 5", pane), [3.0, 2.0, 1.0]);
    let away = "point 1 -1 0; xdir -1 0 0; dimensions 2 2; normal 0 0 -1";
    assert_eq!(look("0 0 5", away), [0.0; 3]);
    assert_eq!(look("0 0 -3", away), [3.0, 2.0, 1.0]);
    assert_eq!(look("0 0 5", "center 0 0 0; radius 1"), [3.0, 2.0, 1.0]);
    // By way of the mirror, past the lamp.
    let beside = "point 1 -1 2; xdir -1 0 0; dimensions 2 2; normal 0 0 -1";
    let scene = format!(
        "image 1 1\ncamera {{ viewpoint 0 0 1; look-at 0 0 0 }}\n\
         material \"mirror\" {{ specular 0.5 }}\n\
         lamp {{ {beside}; emissivity 3 2 1 }}\n\
         plane {{ material \"mirror\"; point 0 0 -4; normal 0 0 1 }}"
    );
    assert_eq!(drawn(&scene).0.pixel(0, 0).channels(), [1.5, 1.0, 0.5]);
}

#[test]
fn a_far_lamp_is_a_light() {
    let floor = "image 1 1\ncamera { viewpoint 0 1 0; look-at 0 0 0; up 0 0 1 }\n\
        lighting { falloff \"inverse-square\"; view-falloff \"none\" }\n\
        material \"chalk\" { diffuse 1 }\n\
        plane { material \"chalk\"; point 0 0 0; normal 0 1 0 }";
    for power in 4..60 {
        let far = 2f64.powi(power);
        let DVec3 { x, y, z } = DVec3::new(0.75, 1.0, 0.25) * far;
        let (left, back) = (x - 0.5, z - 1.0);
        let bright = far * far;
        let light = pixel(&format!(
            "{floor}\nlight {{ location {x} {y} {z}; emissivity {bright} }}"
        ));
        let ball = pixel(&format!(
            "{floor}\nlamp {{ center {x} {y} {z}; radius 1; emissivity {bright} }}"
        ));
        let pane = pixel(&format!(
            "{floor}\nlamp {{ point {left} {y} {back}; normal 0 -1 0; xdir 1 0 0; dimensions 1 2; \
             emissivity {bright} }}"
        ));
        assert!((ball / light - 1.0).abs() < 1e-12, "{power}");
        // A ball of radius 1 looks as large as a disc of π.
        let cosine = y / DVec3::new(x, y, z).length();
        let off = (pane / (light * cosine * 2.0 / PI) - 1.0).abs();
        assert!(off < 4.0 / far / far + 1e-10, "{power}: {off}");
    }
}

/// The one pixel of a scene that says itself how light fades.
fn pixel(text: &str) -> f64 {
    let options = heliodon::read::Options::default();
    let reading = heliodon::read::read_bytes("far", text.as_bytes().to_vec(), "".into(), &options);
    let reading = reading.unwrap_or_else(|no| panic!("{:#?}", no.diagnostics));
    let (film, _) = heliodon::render::render(&reading.scene, &|_| ()).expect("a picture");
    film.pixel(0, 0).r
}

#[test]
fn what_receives_no_shadows_gets_the_whole_lamp() {
    let scene = |receive: &str, roof: &str| {
        format!(
            "image 8 8\ncamera {{ viewpoint 0 1 2; look-at 0 0 0 }}\nmaterial \"chalk\" {{ diffuse 1 }}\n\
             plane {{ material \"chalk\"; point 0 0 0; normal 0 1 0; shadows receive={receive} }}\n\
             lamp {{ point -1 4 -1; normal 0 -1 0; xdir 1 0 0; dimensions 2 2; emissivity 3 }}\n{roof}"
        )
    };
    let roof = "finite-plane { material \"chalk\"; point -9 3 9; normal 0 1 0; xdir 1 0 0; dimensions 18 18 }";
    let open = drawn(&scene("#true", "")).0;
    assert_eq!(bits(&drawn(&scene("#false", roof)).0), bits(&open));
    let dark = drawn(&scene("#true", roof));
    assert!(bits(&dark.0).iter().all(|pixel| *pixel == [0; 3]));
    assert_eq!(
        dark.1.lamp_rays, 0,
        "what is hidden for certain is not asked"
    );
}

#[test]
fn no_ray_goes_to_a_lamp_that_could_add_nothing() {
    let scene = |emissivity: f64, material: &str| {
        let text = format!(
            r#"
            image 9 7
            camera {{ viewpoint 0 0 9; look-at 0 0 0 }}
            material "wall" {{ ambient 0.5; {material} }}
            material "card" {{ diffuse 1 }}
            plane {{ material "wall"; point 0 0 0; normal 0 0 1 }}
            finite-plane {{
                material "card"; point 0 0 10; normal 0 0 1; xdir 1 0 0; dimensions 1 1 }}
            lamp {{
                point 2 -2 12; normal 0 0 -1; xdir -1 0 0; dimensions 4 4
                emissivity {emissivity}; samples 4 }}
            "#
        );
        let [(film, counts), (whole, all)] =
            [Scope::CalledFor, Scope::Everything].map(|scope| picture(&text, scope));
        assert_eq!(bits(&film), bits(&whole), "{emissivity} {material}");
        assert!(all.lamp_rays >= 63 * 4 || material.is_empty());
        counts.lamp_rays
    };
    assert!(scene(2.0, "diffuse 1") > 0);
    assert_eq!(scene(0.0, "diffuse 1"), 0);
    assert_eq!(scene(2.0, ""), 0);
    assert_eq!(scene(2.0, "diffuse 1; transparency 1"), 0);
}
