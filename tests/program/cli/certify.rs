//! `render --certify`, and what `check` tells of shared planes and lines.

use snapbox::str;
use support::shell::Shell;

/// Two tiles that share an edge at 0.1 + 0.2 = 0.3, seen through the joint.
const TILES: &str = r#"
    image 5 3
    camera { viewpoint 0.3 0 1; look-at 0.3 0 0 }
    material "left" { ambient 1 }
    material "right" { ambient 0 1 0 }
    finite-plane "left" {
        material "left"; point 0.1 -1 0; normal 0 0 1; xdir 1 0 0; dimensions 0.2 2 }
    finite-plane "right" {
        material "right"; point 0.3 -1 0; normal 0 0 1; xdir 1 0 0; dimensions 0.2 2 }"#;

#[test]
fn a_certificate_says_how_hits_were_decided() {
    let shell = Shell::new();
    shell.write("tiles.kdl", TILES);
    let run = shell
        .run(&["render", "tiles.kdl", "--certify"])
        .ends_with(0);
    let said = run.stdout_text();
    for line in [
        // Fifteen rays, each near one tile or both; the middle column of three meets the joint, and
        // there each tile asks.
        "  tests              18, at least 12 decided in floating point with proven bounds\n",
        "  exact decisions    0 signs computed exactly, 6 decided by rule\n",
        "  shared geometry    1 plane, 1 line, at most 0 apart in the file\n",
        "  bounced hit error  about 0 (an estimate; after mirrors and refraction)\n",
        "  non-finite pixels  0\n",
    ] {
        assert!(said.contains(line), "{said}");
    }
}

#[test]
fn a_certificate_in_json_is_the_same_on_any_number_of_threads() {
    let shell = Shell::new();
    shell.write("tiles.kdl", TILES);
    let certificate = |threads: &str| {
        let arguments = [
            "render",
            "tiles.kdl",
            "--certify",
            "--json",
            "--threads",
            threads,
        ];
        let run = shell.run(&arguments).ends_with(0);
        let answer: serde_json::Value = serde_json::from_str(run.stdout_text()).expect("JSON");
        answer["certificate"].clone()
    };
    let one = certificate("1");
    assert_eq!(one["by_rule"], 6);
    assert_eq!(one["non_finite_pixels"], 0);
    assert_eq!(one["numerics"], "robust");
    assert_eq!(one, certificate("3"));
}

#[test]
fn classic_numerics_certify_nothing_but_that_all_is_finite() {
    let shell = Shell::new();
    shell.write("tiles.kdl", TILES);
    let arguments = ["render", "tiles.kdl", "--certify", "--numerics", "classic"];
    let run = shell.run(&arguments).ends_with(0);
    let said = run.stdout_text();
    assert!(
        said.contains("30, decided in floating point without bounds (classic)"),
        "{said}"
    );
    assert!(!said.contains("hit error"), "{said}");
    let json = [&arguments[..], &["--json"]].concat();
    let run = shell.run(&json).ends_with(0);
    let answer: serde_json::Value = serde_json::from_str(run.stdout_text()).expect("JSON");
    for bound in ["largest_error", "largest_bounced_error"] {
        assert!(answer["certificate"][bound].is_null(), "{answer}");
    }
}

#[test]
fn check_lists_what_is_shared() {
    let shell = Shell::new();
    shell.write("tiles.kdl", TILES);
    let run = shell.run(&["check", "tiles.kdl"]).ends_with(0);
    run.prints(str![[r#"
tiles.kdl: ok
  surfaces share 1 plane and 1 border line

"#]]);
    let run = shell.run(&["check", "tiles.kdl", "--verbose"]).ends_with(0);
    run.prints(str![[r#"
tiles.kdl: ok
  surfaces share 1 plane and 1 border line
  shared plane: finite-plane "left", finite-plane "right"
  shared line: finite-plane "left", finite-plane "right"

"#]]);
}

/// The corner of a slanting tile is irrational, so whoever writes it rounds it.
#[test]
fn check_lists_what_was_moved_to_be_shared() {
    let shell = Shell::new();
    let slanting = TILES
        .replace("xdir 1 0 0", "xdir 1 1 0")
        .replace("point 0.1 -1 0", "point 0 0 0")
        .replace(
            "point 0.3 -1 0",
            "point 0.1414213562373095 0.1414213562373095 0",
        );
    shell.write("slanting.kdl", &slanting);
    let run = shell.run(&["check", "slanting.kdl"]).ends_with(0);
    let said = run.stdout_text();
    assert!(said.contains("  shared line ("), "{said}");
    let run = shell.run(&["check", "slanting.kdl", "--json"]).ends_with(0);
    let answer: serde_json::Value = serde_json::from_str(run.stdout_text()).expect("JSON");
    let shared = answer["shared"].as_array().expect("a list");
    let line = shared
        .iter()
        .find(|shared| shared["what"] == "line")
        .expect("a line");
    let apart = line["apart"].as_f64().expect("a number");
    assert!(apart > 0.0 && apart < 1e-15, "{apart}");
}

/// Far away two borders of a strip are a few roundings apart, and still two.
#[test]
fn a_strip_does_not_share_borders_with_itself() {
    let shell = Shell::new();
    let tile = |point: &str, width: &str| {
        format!(
            "finite-plane {{ material \"left\"; point {point}; normal 0 0 1; xdir 1 0 0; \
             dimensions {width} 1 }}\n"
        )
    };
    let head = "image 5 3\ncamera { viewpoint 1e9 0.5 1; look-at 1e9 0.5 0 }\n\
                material \"left\" { ambient 1 }\n";
    let scene = [head, &tile("1e9 0 0", "8e-7"), &tile("5 7 0", "1")].concat();
    shell.write("strip.kdl", &scene);
    let run = shell.run(&["check", "strip.kdl"]).ends_with(0);
    assert!(
        run.stdout_text()
            .ends_with("share 1 plane and 0 border lines\n"),
        "{}",
        run.stdout_text()
    );
}

#[test]
fn what_nothing_bounds_is_said_to_be_unknown() {
    let shell = Shell::new();
    // Rays go round and round in the ball, near the angle of total reflection.
    let ball = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/glass-ball.kdl");
    let arguments = [
        "render",
        ball,
        "--size",
        "64x48",
        "--certify",
        "-o",
        "ball.png",
    ];
    let run = shell.run(&arguments).ends_with(0);
    let said = run.stdout_text();
    let line = "  bounced hit error  unbounded: rounding may have changed the path of a ray\n";
    assert!(said.contains(line), "{said}");
    let run = shell
        .run(&[&arguments[..], &["--json"]].concat())
        .ends_with(0);
    let answer: serde_json::Value = serde_json::from_str(run.stdout_text()).expect("JSON");
    assert!(answer["certificate"]["largest_bounced_error"].is_null());
    assert!(answer["certificate"]["largest_error"].is_f64());
}

/// A tiny pane that is round bends nothing, so it adds nothing to what is off behind it.
#[test]
fn a_pane_that_bends_nothing_leaves_errors_as_they_are() {
    let shell = Shell::new();
    shell.write(
        "pane.kdl",
        r#"image 9 7
        camera { viewpoint 0 0 5; look-at 0 0 0 }
        material "clear" { transparency 1 }
        material "wall" { ambient 1 }
        plane "wall" { material "wall"; point 0 0 -3; normal 0.1 0.2 1 }
        sphere { material "clear"; center 0 0 0; radius 1e-6 }"#,
    );
    let run = shell
        .run(&["render", "pane.kdl", "--certify", "--json"])
        .ends_with(0);
    let answer: serde_json::Value = serde_json::from_str(run.stdout_text()).expect("JSON");
    let error = answer["certificate"]["largest_bounced_error"].as_f64();
    let error = error.expect("a number");
    assert!(error > 0.0 && error < 1e-12, "{error}");
}

/// Far from the origin numbers are as coarse as they are there, but a scene of such numbers is computed
/// like one at the origin, and is said to be.
#[test]
fn a_scene_far_away_is_not_said_to_be_off_by_more() {
    let shell = Shell::new();
    let largest = |x: &str| {
        let place = |y: f64, z: f64| format!("{x} {y} {z}");
        let scene = format!(
            r#"image 16 12
            camera {{ viewpoint {eye}; look-at {middle} }}
            material "red" {{ ambient 1 0 0 }}
            plane "floor" {{ material "red"; point {floor}; normal 0 1 0 }}
            sphere "ball" {{ material "red"; center {middle}; radius 1 }}
            finite-plane "pane" {{
                material "red"; point {pane}; normal 1 1 1; xdir 1 0 -1; dimensions 1 1 }}"#,
            eye = place(2.0, 5.0),
            middle = place(0.5, 0.0),
            floor = place(-0.5, 0.0),
            pane = place(1.0, 1.0),
        );
        shell.write("scene.kdl", &scene);
        let run = shell
            .run(&["render", "scene.kdl", "--certify", "--json"])
            .ends_with(0);
        let answer: serde_json::Value = serde_json::from_str(run.stdout_text()).expect("JSON");
        answer["certificate"]["largest_error"].as_f64()
    };
    let [near, far] = ["0", "1e9"].map(|x| largest(x).expect("a number"));
    assert!(near > 0.0 && near < 1e-10, "{near}");
    assert_eq!(far, near);
}
