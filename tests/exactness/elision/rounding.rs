//! Where rounding puts surfaces, or hits on them, further from their corners than usual.

use super::{differing, scene};

fn assert_the_same(text: &str) {
    let differing = differing(&scene(text).expect("a scene"));
    assert!(differing.is_empty(), "{differing:?} in {text}");
}

/// A strip over a floor that shares a border with another one very far away, from which it is off by half of
/// a thousandth: `camera` looks at something that depends on it.
fn beside_a_far_neighbor(camera: &str, light: &str) -> String {
    format!(
        r#"
        image 150 100
        camera {{ {camera} }}
        lighting {{ falloff "none"; view-falloff "none" }}
        material "gray" {{ ambient 0.125; diffuse 0.75 }}
        {light}
        finite-plane {{ material "gray"; point -2 -2 -1; normal 0 0 1; xdir 1 0 0; dimensions 6 6 }}
        finite-plane {{ material "gray"; point 0.4 0 0; normal 0 0 1; xdir 1 0 0; dimensions 0.1 1 }}
        finite-plane {{
            material "gray"
            point 0.1 1e12 0
            normal 0 0 1
            xdir 1 0 0
            dimensions 0.2995 1
        }}
        "#
    )
}

const SHADOW: &str = "viewpoint 1 0.5 -0.5; look-at 0.81 0.5 -1; field-of-view 10";
const STRIP: &str = "viewpoint 0.41 0.5 0.3; look-at 0.4 0.5 0; field-of-view 0.5";
const LIGHT: &str = "light { location 0 0.5 1; emissivity 1 }";

#[test]
fn a_shadow_of_what_shares_a_border_with_something_far_away_is_not_cut_off() {
    assert_the_same(&beside_a_far_neighbor(SHADOW, LIGHT));
    let lamp = "lamp { point 0 0.45 1; normal 0 0 -1; xdir 0 1 0; dimensions 0.1 0.0001; \
                emissivity 2000; samples 4 }";
    assert_the_same(&beside_a_far_neighbor(SHADOW, lamp));
    assert_the_same(&beside_a_far_neighbor(STRIP, LIGHT));
}

#[test]
fn a_triangle_is_not_met_behind_the_wall_that_it_touches_however_flatly_it_is_seen() {
    for lamp in [
        "light { location 0.5 2 2; emissivity 1 }",
        "lamp { center 0.5 2 2; radius 0.2; emissivity 9; samples 4 }",
    ] {
        // The eye is 1e-12 above the triangle's plane, and every pixel is aimed at the edge on the wall.
        assert_the_same(&format!(
            r#"
            image 2001 1
            camera {{
                viewpoint 0.339999999999666 1.0000000000009277 4.799999999999835
                look-at 0.5 0.20000000000000007 0.0
                up -0.33403257563875904 0.9278682656632196 -0.16577913013182854
                field-of-view 0.01
            }}
            lighting {{ falloff "none"; view-falloff "none" }}
            material "gray" {{ ambient 0.125; diffuse 0.75 }}
            {lamp}
            triangle {{ material "gray"; vertex1 3 1.1 0; vertex2 -2 -0.7 0; vertex3 0.4 0.7 3 }}
            plane {{ material "gray"; point 0 0 0; normal 0 0 1 }}
            "#
        ));
    }
}
