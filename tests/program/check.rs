//! What `check` warns of, and what it does not.

use heliodon::measure::check;
use heliodon::read::{Options, read_bytes};

/// The warnings of a scene that has a floor, a light above it and a camera, and this.
fn warnings(text: &str) -> Vec<String> {
    warnings_from("camera { viewpoint 0 2 8; look-at 0 1 0 }", text)
}

fn warnings_from(camera: &str, text: &str) -> Vec<String> {
    let scene = format!(
        r#"
        image 8 6
        {camera}
        material "m" {{ ambient 1; diffuse 1 }}
        light "sun" {{ location 0 9 5; emissivity 1 }}
        plane "floor" {{ material "m"; point 0 0 0; normal 0 1 0 }}
        {text}"#
    );
    let reading = read_bytes("scene.kdl", scene.into(), "".into(), &Options::default());
    let reading = reading.unwrap_or_else(|no| panic!("{:#?}", no.diagnostics));
    check(&reading.scene)
        .into_iter()
        .map(|problem| problem.message)
        .collect()
}

fn finite(name: &str, point: &str, normal: &str, xdir: &str) -> String {
    format!(
        r#"finite-plane "{name}" {{
            material "m"; point {point}; normal {normal}; xdir {xdir}; dimensions 1 1
        }};"#
    )
}

#[track_caller]
fn warns(text: &str, expected: &str) {
    assert_eq!(warnings(text), [expected]);
}

#[track_caller]
fn is_fine(text: &str) {
    assert_eq!(warnings(text), Vec::<String>::new());
}

#[test]
fn a_lamp_that_shines_on_no_front() {
    let lamp = |point: &str, normal: &str| {
        format!(
            "lamp \"l\" {{ point {point}; normal {normal}; xdir 1 0 0; dimensions 1 1; emissivity 1 }}"
        )
    };
    let useless = "the lamp \"l\" shines on the front of no surface";
    is_fine(&lamp("0 2 0", "0 -1 0"));
    is_fine(&lamp("0 2 0", "0 -1 0.1"));
    warns(&lamp("0 2 0", "0 1 0"), useless);
    warns(&lamp("0 -1 0", "0 1 0"), useless);
    is_fine("lamp \"l\" { center 0 -0.5 0; radius 1; emissivity 1 }");
    let under = warnings("lamp \"l\" { center 0 -2 0; radius 1; emissivity 1 }");
    assert_eq!(under, [useless]);
}

#[test]
fn an_xdir_out_of_its_plane_by_more_than_a_tenth_of_a_degree() {
    warns(
        &finite("door", "0 1 0", "0 0 1", "1 0 0.1"),
        "the finite-plane \"door\" has an xdir that points 5.7° out of its plane",
    );
    warns(
        &finite("door", "0 1 0", "0 0 1", "1 0 0.00176"),
        "the finite-plane \"door\" has an xdir that points 0.1° out of its plane",
    );
    is_fine(&finite("door", "0 1 0", "0 0 1", "1 0 0.00174"));
    // Neither the length of the normal nor that of xdir matters.
    is_fine(&finite("door", "0 1 0", "0 0 30", "7 1 0"));
}

#[test]
fn a_light_behind_every_surface() {
    warns(
        r#"light "cellar" { location 0 -1 0; emissivity 1 }"#,
        "the light \"cellar\" lies behind every surface",
    );
    let wall = r#"plane "wall" { material "m"; point 0 0 -5; normal 0 0 1 }"#;
    is_fine(&format!(
        r#"{wall}; light "cellar" {{ location 0 -1 0; emissivity 1 }}"#
    ));
}

#[test]
fn a_camera_inside_of_something() {
    warns(
        r#"sphere "fog" { material "m"; center 0 2 8; radius 1 }"#,
        "the sphere \"fog\" has the camera inside",
    );
    warns(
        r#"ellipsoid { material "m"; center 0 2 7; radius 1; scale 1 1 1.5 }"#,
        "an ellipsoid has the camera inside",
    );
    is_fine(r#"ellipsoid { material "m"; center 0 2 6.4; radius 1; scale 1 1 1.5 }"#);
}

#[test]
fn a_surface_that_is_never_in_front_of_the_camera() {
    warns(
        &finite("behind", "0 1 9", "0 0 -1", "1 0 0"),
        "the finite-plane \"behind\" is never in front of the camera",
    );
    is_fine(&finite("before", "0 1 7.9", "0 0 1", "1 0 0"));
    warns(
        r#"plane "back" { material "m"; point 0 0 9; normal 0 0 -1 }"#,
        "the plane \"back\" is never in front of the camera",
    );
    let screen = "camera { viewpoint 4 3 8; screen 8 6 }";
    let near = finite("near", "4 3 1", "0 0 1", "1 0 0");
    let expected = ["the finite-plane \"near\" is never in front of the camera"];
    assert_eq!(warnings_from(screen, &near), expected);
    let far = finite("far", "4 3 -1", "0 0 1", "1 0 0");
    assert_eq!(warnings_from(screen, &far), Vec::<String>::new());
    let moved = "camera { viewpoint 4 3 8; screen 8 6; screen-at 0 0 -2 }";
    let expected = ["the finite-plane \"far\" is never in front of the camera"];
    assert_eq!(warnings_from(moved, &far), expected);
}

#[test]
fn surfaces_in_one_plane_that_share_an_area() {
    let wall = finite("wall", "0 1 0", "0 0 1", "1 0 0");
    let expected =
        "the finite-plane \"poster\" lies in the same plane as the finite-plane \"wall\"";
    for poster in ["0.5 1.5 0", "0 1 0", "-0.9 0.1 0"] {
        warns(
            &(wall.clone() + &finite("poster", poster, "0 0 1", "1 0 0")),
            expected,
        );
        // It does not matter which way it faces.
        warns(
            &(wall.clone() + &finite("poster", poster, "0 0 -1", "0 1 0")),
            expected,
        );
    }
    // Neighbours that touch, tiles at decimals, and another plane.
    is_fine(&(wall.clone() + &finite("poster", "1 1 0", "0 0 1", "1 0 0")));
    is_fine(&(wall + &finite("poster", "0.5 1.5 0.001", "0 0 1", "1 0 0")));
    let tiles: String = (0..10)
        .map(|i| {
            finite(&format!("t{i}"), &format!("0.{i} 1 0"), "0 0 1", "1 0 0")
                .replace("dimensions 1 1", "dimensions 0.1 1")
        })
        .collect();
    is_fine(&tiles);
}

#[test]
fn rotated_neighbours_whose_boxes_overlap_are_fine() {
    let turned = |name: &str, point: &str| finite(name, point, "0 0 1", "1 1 0");
    is_fine(&(turned("a", "0 1 0") + &turned("b", "0.8 1.8 0")));
    let both = turned("a", "0 1 0") + &turned("b", "0.5 1 0");
    warns(
        &both,
        "the finite-plane \"b\" lies in the same plane as the finite-plane \"a\"",
    );
}

#[test]
fn something_that_lies_on_an_unbounded_plane() {
    warns(
        &finite("rug", "0 0 0", "0 1 0", "1 0 0"),
        "the finite-plane \"rug\" lies in the same plane as the plane \"floor\"",
    );
}

#[test]
fn planes_that_are_one_but_for_rounding() {
    let first = finite("a", "0 1 0", "1 2 3", "3 0 -1");
    let second = finite("b", "0 1 0", "0.1 0.2 0.3", "3 0 -1");
    warns(
        &(first + &second),
        "the finite-plane \"b\" lies in the same plane as the finite-plane \"a\"",
    );
}

#[test]
fn round_things_in_the_same_place() {
    let ball =
        |name: &str| format!(r#"sphere "{name}" {{ material "m"; center 0 1 0; radius 1 }};"#);
    warns(
        &(ball("a") + &ball("b")),
        "the sphere \"b\" coincides with the sphere \"a\"",
    );
}

#[test]
fn a_plane_that_the_screen_hides() {
    let screen = "camera { viewpoint 4 3 8; screen 8 6 }";
    let near = r#"plane "glass" { material "m"; point 0 0 1; normal 0 0 1 }"#;
    let expected = ["the plane \"glass\" is never in front of the camera"];
    assert_eq!(warnings_from(screen, near), expected);
    let far = r#"plane "wall" { material "m"; point 0 0 -1; normal 0 0 1 }"#;
    assert_eq!(warnings_from(screen, far), Vec::<String>::new());
    let moved = "camera { viewpoint 4 3 8; screen 8 6; screen-at 0 0 2 }";
    assert_eq!(warnings_from(moved, near), Vec::<String>::new());
}
