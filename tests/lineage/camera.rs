//! From pixels to rays.

use glam::DVec3;
use heliodon::camera::Camera;
use heliodon::math::Rgb;

use super::tools::{Stage, letters};

fn camera(size: [u32; 2], text: &str) -> Camera {
    let stage = Stage::new(&format!("image 8 6\n camera {{ {text} }}"));
    stage.scene().view.camera(size[0], size[1]).unwrap()
}

/// Where the ray through a pixel, counted from the lower left, crosses the plane z = 0.
fn crosses(camera: &Camera, x: f64, y: f64) -> DVec3 {
    let (from, dir) = (camera.viewpoint(), camera.ray(x, y).dir);
    from - dir * (from.z / dir.z)
}

/// S1: edge pixels look through the edges of the window, whose lower-left corner is the world's
/// origin: a pixel's place is divided by the number of pixels less one.
#[test]
fn edge_pixels_lie_on_the_windows_edges() {
    let camera = camera([5, 3], "viewpoint 1 2 4; screen 8 6");
    for (x, y, place) in [
        (0.0, 0.0, [0.0, 0.0]),
        (4.0, 2.0, [8.0, 6.0]),
        (1.0, 1.0, [2.0, 3.0]),
    ] {
        let place = DVec3::new(place[0], place[1], 0.0);
        assert!((crosses(&camera, x, y) - place).length() < 1e-14, "{x} {y}");
    }
}

/// S1: the older grammars have the window's middle at the origin.
#[test]
fn the_window_can_be_centred() {
    let camera = camera([5, 3], "viewpoint 0 0 4; screen 8 6 origin=\"center\"");
    assert!((crosses(&camera, 0.0, 0.0) - DVec3::new(-4.0, -3.0, 0.0)).length() < 1e-14);
    assert!((crosses(&camera, 4.0, 2.0) - DVec3::new(4.0, 3.0, 0.0)).length() < 1e-14);
    assert_eq!(camera.ray(2.0, 1.0).dir, DVec3::NEG_Z);
}

/// S1: the window can stand elsewhere; then its corner or its middle stands there.
#[test]
fn the_window_can_be_moved() {
    for (origin, left) in [("corner", 3.0), ("center", -1.0)] {
        let text = "viewpoint 3 2 9; screen 8 6 origin=\"ORIGIN\"; screen-at 3 2 5";
        let camera = camera([5, 3], &text.replace("ORIGIN", origin));
        let to_corner = camera.ray(0.0, 0.0).dir * 4.0 / -camera.ray(0.0, 0.0).dir.z;
        let corner = camera.viewpoint() + to_corner;
        assert!((corner.x - left).abs() < 1e-14, "{origin}: {corner}");
        assert!((corner.z - 5.0).abs() < 1e-14, "{origin}: {corner}");
    }
}

/// S1: a picture with one pixel looks through the window's corner, and divides by nothing.
#[test]
fn a_single_pixel_looks_through_the_corner() {
    let camera = camera([1, 1], "viewpoint 0 0 4; screen 8 6");
    assert_eq!(camera.ray(0.0, 0.0).dir, DVec3::NEG_Z);
}

/// S1: an aimed camera's pixel centres lie half a pixel inside of its window.
#[test]
fn an_aimed_cameras_centres_lie_inside() {
    let camera = camera([4, 2], "viewpoint 0 0 1; look-at 0 0 -5; field-of-view 90");
    assert!((crosses(&camera, 0.0, 0.0) - DVec3::new(-1.5, -0.5, 0.0)).length() < 1e-14);
    assert!((crosses(&camera, 3.0, 1.0) - DVec3::new(1.5, 0.5, 0.0)).length() < 1e-14);
}

/// S1, S16: rows are stored from the top: what is high in the world is high in the picture, and
/// what is right is right, with both cameras.
#[test]
fn up_is_up_and_right_is_right() {
    let quarters = r#"
        finite-plane { material "red"; point -8 0 -1; normal 0 0 1; xdir 1 0 0; dimensions 8 8 }
        finite-plane { material "blue"; point 0 -8 -1; normal 0 0 1; xdir 1 0 0; dimensions 8 8 }"#;
    let drawn = |camera: &str| {
        let text = format!(
            "image 4 2\n camera {{ {camera} }}\n lighting {{ view-falloff \"none\" }}\n{quarters}"
        );
        letters(&Stage::new(&text).film())
    };
    let expected = "|RR..|\n|..BB|";
    assert_eq!(
        drawn("viewpoint 0 0 9; screen 4 2 origin=\"center\""),
        expected
    );
    assert_eq!(drawn("viewpoint 0 0 9; look-at 0 0 0"), expected);
    assert_eq!(
        drawn("viewpoint 0 0 9; look-at 0 0 0; up 0 -1 0"),
        "|BB..|\n|..RR|"
    );
    assert_eq!(drawn("viewpoint 0 0 -9; look-at 0 0 0"), "|..RR|\n|BB..|");
}

/// S2: only the chapter's screen hides what is in front of it; an aimed camera sees all.
#[test]
fn an_aimed_camera_has_no_screen() {
    let near = r#"plane { material "red"; point 0 0 3; normal 0 0 1 }"#;
    let aimed = format!("image 1 1\n camera {{ viewpoint 0 0 4; look-at 0 0 0 }}\n {near}");
    assert_eq!(Stage::new(&aimed).pixel(), Rgb::new(1.0, 0.0, 0.0));
    assert_eq!(Stage::eye(near).pixel(), Rgb::BLACK);
}

/// S1: the viewpoint lies in front of the screen.
#[test]
fn an_eye_behind_its_screen_is_refused() {
    for z in ["0", "-1"] {
        let stage = Stage::new(&format!(
            "image 8 6\n camera {{ viewpoint 4 3 {z}; screen 8 6 }}"
        ));
        assert_eq!(stage.error(), "the viewpoint is not in front of the screen");
    }
}
