//! Nearest hits, the path from the eye, and mirrors.

use heliodon::math::Rgb;

use super::tools::{Stage, assert_color, assert_drawn, letters};

/// S3: where nothing is hit, the picture is black.
#[test]
fn the_background_is_black() {
    assert_eq!(
        Stage::eye("light { location 0 0 0; emissivity 9 }").pixel(),
        Rgb::BLACK
    );
}

/// S3: the nearest of all surfaces is seen, in whichever order they stand.
#[test]
fn the_nearest_is_seen() {
    let near = r#"finite-plane {
        material "red"; point 3.5 3.5 -2; normal 0 0 1; xdir 1 0 0; dimensions 14 8
    }"#;
    let middle = r#"sphere { material "green"; center 17.5 8.5 -8; radius 5 }"#;
    let far = r#"plane { material "blue"; point 0 0 -20; normal 0 0 1 }"#;
    let drawn = |order: [&str; 3]| letters(&Stage::grid(&order.join("\n")).film());
    let picture = drawn([near, middle, far]);
    assert_drawn(
        &picture,
        "
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBGGGGBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBGGGGGGGGBBBBBBBBBB|
        |BBBBRRRRRRRRRRRRRRGGGGBBBBBBBBBB|
        |BBBBRRRRRRRRRRRRRRGGGGGBBBBBBBBB|
        |BBBBRRRRRRRRRRRRRRGGGGGBBBBBBBBB|
        |BBBBRRRRRRRRRRRRRRGGGGGBBBBBBBBB|
        |BBBBRRRRRRRRRRRRRRGGGGGBBBBBBBBB|
        |BBBBRRRRRRRRRRRRRRGGGGBBBBBBBBBB|
        |BBBBRRRRRRRRRRRRRRGGGGBBBBBBBBBB|
        |BBBBRRRRRRRRRRRRRRGGBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        ",
    );
    for order in [
        [far, middle, near],
        [middle, far, near],
        [far, near, middle],
    ] {
        assert_eq!(drawn(order), picture);
    }
}

/// P4: of surfaces that coincide, the first in the file is seen, whole and without a seam.
#[test]
fn of_coincident_planes_the_first_is_seen() {
    let finite = r#"finite-plane {
        material "red"; point 3.5 3.5 -3; normal 0 0 1; xdir 3 1 0; dimensions 14 5
    }"#;
    let turned = r#"finite-plane {
        material "green"; point 23.5 12.5 -3; normal 0 0 -1; xdir -1 -1 0; dimensions 9 9
    }"#;
    let plane = r#"plane { material "blue"; point 100 -20 -3; normal 0 0 5 }"#;
    let drawn = letters(&Stage::grid(&[finite, turned, plane].join("\n")).film());
    assert_drawn(
        &drawn,
        "
        |BBBBBBBBBBBBBBGGGGGGGBBBBBBBBBBB|
        |BBBBBBBBBBBBBGGGGGGGGGBBBBBBBBBB|
        |BBBBBBBBBBBBGGGGGGGGGGGBBBBBBBBB|
        |BBBBBBBBBBBBGGRRGGGGGGGBBBBBBBBB|
        |BBBBBBBBBBBRRRRRGGGGGGBBBBBBBBBB|
        |BBBBBBBBRRRRRRRRRGGGGBBBBBBBBBBB|
        |BBBBBRRRRRRRRRRRRGGGBBBBBBBBBBBB|
        |BBBRRRRRRRRRRRRRRGGBBBBBBBBBBBBB|
        |BBBRRRRRRRRRRRRBBGBBBBBBBBBBBBBB|
        |BBBRRRRRRRRBBBBBBBBBBBBBBBBBBBBB|
        |BBBBRRRRRBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBRRBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        |BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBB|
        ",
    );
    let all_blue = letters(&Stage::grid(&[plane, turned, finite].join("\n")).film());
    assert!(!all_blue.contains(['R', 'G', '.']), "{all_blue}");
}

/// S4: what is seen is divided by the length of the path from the eye, or as the scene says.
#[test]
fn the_path_from_the_eye_divides() {
    let pixel = |lighting: &str| {
        let text = format!(
            r#"lighting {{ {lighting} }}
            material "wall" {{ ambient 16 }}
            plane {{ material "wall"; point 0 0 -4; normal 0 0 1 }}"#
        );
        Stage::eye(&text).pixel()
    };
    assert_eq!(pixel(""), Rgb::WHITE * 2.0);
    assert_eq!(pixel("view-falloff \"none\""), Rgb::WHITE * 16.0);
    assert_eq!(pixel("view-falloff \"inverse-square\""), Rgb::WHITE * 0.25);
}

/// A mirror at 45°, met after 8, that shows a ceiling 3 above it, and what else is given.
fn mirror(mirror: &str, more: &str) -> Rgb {
    let text = format!(
        r#"material "mirror" {{ {mirror} }}
        material "ceiling" {{ ambient 22 11 0 }}
        plane {{ material "mirror"; point 0 0 -4; normal 0 1 1 }}
        plane {{ material "ceiling"; point 0 3 0; normal 0 -1 0 }}
        {more}"#
    );
    Stage::eye(&text).pixel()
}

/// S4, S5: a mirror adds specular × what it shows, divided by the whole path, 8 + 3, once.
#[test]
fn a_mirror_divides_by_the_whole_path() {
    assert_color(mirror("specular 0.5", ""), [1.0, 0.5, 0.0]);
    assert_color(
        mirror("specular 0.5 1 0; ambient 0 0 4", ""),
        [1.0, 1.0, 0.5],
    );
}

/// S4: with the chapter's reach, a ray that has come too far is black; the hit that takes it
/// beyond still counts.
#[test]
fn rays_end_at_the_reach() {
    let reached = |reach: &str| {
        mirror(
            "ambient 8; specular 0.5",
            &format!("lighting {{ reach {reach} }}"),
        )
    };
    assert_color(reached("8.01"), [2.0, 1.5, 1.0]);
    assert_color(reached("7.99"), [1.0; 3]);
    assert_color(reached("1"), [1.0; 3]);
}

/// S5: two mirrors show each other, and the path grows at each: 8, 8 + 3, 8 + 3 + 5.
#[test]
fn mirrors_show_mirrors() {
    // Down −z, up from the first mirror, and then −z again from the second one.
    let text = r#"
        material "mirror" { specular 0.5 }
        material "wall" { ambient 16 }
        finite-plane { material "mirror"; point -1 -1 -3; normal 0 1 1; xdir 1 0 0; dimensions 2 2 }
        finite-plane { material "mirror"; point -1 4 -5; normal 0 -1 -1; xdir 1 0 0; dimensions 2 2 }
        plane { material "wall"; point 0 0 -9; normal 0 0 1 }"#;
    assert_color(Stage::eye(text).pixel(), [0.25; 3]);
}

/// S5: a mirror on the floor shows the wall behind it upside down.
#[test]
fn a_mirror_turns_its_image_over() {
    let text = r#"
        image 32 16
        camera { viewpoint 15.5 7.5 31; screen 31 15 }
        lighting { falloff "none"; view-falloff "none" }
        texture "letter" "letter.ppm"
        material "mirror" { specular 0.4 }
        plane { material "mirror"; point 0 0 0; normal 0 1 0 }
        texture-plane {
            material "white"; point -0.5 0 -31; normal 0 0 1; xdir 1 0 0; dimensions 32 20
            texture "letter"
        }"#;
    let stage = Stage::new(text).image("letter", &["RRR", "R.G", "RR.", "B.Y"]);
    assert_drawn(
        &letters(&stage.film()),
        "
        |................................|
        |................................|
        |........RRRRRRRRRRRRRRRR........|
        |........RRRRRRRRRRRRRRRR........|
        |........RRRRR......GGGGG........|
        |........RRRRR......GGGGG........|
        |........RRRRR......GGGGG........|
        |........RRRRRRRRRRR.............|
        |........RRRRRRRRRRR.............|
        |........BBBBB......YYYYY........|
        |........BBBBB......YYYYY........|
        |........BBBBB......YYYYY........|
        |........bbbbb......yyyyy........|
        |........bbbbb......yyyyy........|
        |........rrrrrrrrrrr.............|
        |........rrrrrrrrrrr.............|
        ",
    );
}

/// S5: a mirror does not show itself, and sees from its back as from its front.
#[test]
fn a_mirror_works_on_both_sides() {
    let text = |normal: &str| {
        format!(
            r#"material "mirror" {{ specular 0.5 }}
            material "ceiling" {{ ambient 11 }}
            plane {{ material "mirror"; point 0 0 -4; normal {normal} }}
            plane {{ material "ceiling"; point 0 3 0; normal 0 -1 0 }}"#
        )
    };
    let [front, back] = ["0 1 1", "0 -1 -1"].map(|normal| Stage::eye(&text(normal)).pixel());
    assert_color(front, [0.5; 3]);
    assert_eq!(front, back);
}

/// S2: hits on the viewer's side of the screen are misses, for rays from the eye, from mirrors,
/// and to lights.
#[test]
fn nothing_counts_in_front_of_the_screen() {
    let wall = r#"material "wall" { ambient 8; diffuse 8 }
        plane { material "wall"; point 0 0 -4; normal 0 0 1 }
        light { location 0 0 2; emissivity 6 }"#;
    let open = Stage::eye(wall).pixel();
    assert_color(open, [2.0; 3]);
    for z in ["1", "0.0000001", "3.9"] {
        let shade = format!(r#"plane {{ material "red"; point 0 0 {z}; normal 0 0 1 }}"#);
        assert_eq!(Stage::eye(&[wall, &shade].join("\n")).pixel(), open, "{z}");
    }
    // A mirror that throws the ray back up the z axis, slightly aside.
    let mirror = r#"material "mirror" { specular 1 }
        plane { material "mirror"; point 0 0 -4; normal 0 1 8 }"#;
    let before = r#"sphere { material "red"; center 0 2 3; radius 1.5 }"#;
    assert_eq!(Stage::eye(&[mirror, before].join("\n")).pixel(), Rgb::BLACK);
    let behind = r#"finite-plane {
        material "red"; point -1 0.2 -1; normal 0 0 1; xdir 1 0 0; dimensions 9 9 }"#;
    assert!(
        Stage::eye(&[mirror, behind].join("\n")).pixel().r > 0.0,
        "behind the screen"
    );
}

/// S2: a screen that stands elsewhere cuts there, on both sides of z = 0.
#[test]
fn a_moved_screen_cuts_where_it_stands() {
    for (place, eye, inside, outside) in [(3, 5, 2, 4), (-6, -2, -7, -5)] {
        let pixel = |z| {
            let scene = format!(
                "image 1 1
                camera {{ viewpoint 0 0 {eye}; screen 1 1; screen-at 0 0 {place} }}
                plane {{ material \"red\"; point 0 0 {z}; normal 0 0 1 }}"
            );
            Stage::new(&scene).pixel()
        };
        let distance = f64::from(eye - inside);
        assert_eq!(pixel(inside), Rgb::new(1.0 / distance, 0.0, 0.0), "{place}");
        assert_eq!(pixel(place).r, 1.0 / f64::from(eye - place), "{place}");
        assert_eq!(pixel(outside), Rgb::BLACK, "{place}");
    }
}

/// S2: it is the exact place that counts, to the last bit, for flat surfaces of every kind: for rays from
/// the eye, from mirrors, and to lights.
#[test]
fn one_unit_in_the_last_place_before_the_screen_is_before_it() {
    let screen = 0.3f64;
    let surfaces = |z: f64| {
        [
            format!("plane {{ material \"red\"; point 7.1 0.3 {z:?}; normal 0 0 1 }}"),
            format!("plane {{ material \"red\"; point 7.1 0.3 {z:?}; normal 0 0 -3 }}"),
            format!(
                "finite-plane {{ material \"red\"; point -901 -902 {z:?}; normal 0 0 1
                xdir 1 0 0; dimensions 1900 1900 }}"
            ),
            format!(
                "triangle {{ material \"red\"; vertex1 -900 -950.1 {z:?}
                vertex2 900.7 -950 {z:?}; vertex3 0.1 930.7 {z:?} }}"
            ),
        ]
    };
    // Beside the way of the rays from the eye.
    let beside = |z: f64| {
        format!(
            "finite-plane {{ material \"red\"; point 3 -902 {z:?}; normal 0 0 1
            xdir 1 0 0; dimensions 1900 1900 }}"
        )
    };
    let mirror = r#"material "mirror" { specular 1 }
        plane { material "mirror"; point 0 0 -4.7; normal 0.5 0 1 }"#;
    let lit = r#"material "wall" { diffuse 1 }
        plane { material "wall"; point 0 0 -4.3; normal 0 0 1 }
        light { location 12 0.7 5; emissivity 1 }"#;
    for (z, counts) in [
        (screen, true),
        (screen.next_up(), false),
        (screen.next_down(), true),
    ] {
        for step in 0..40 {
            let [x, y] = [0.037, 0.023].map(|pace| pace * f64::from(step) - 0.9);
            let seen = |eye: f64, scene: &[&str]| {
                let camera = format!(
                    "image 1 1
                    camera {{ viewpoint {x:?} {y:?} {eye:?}
                    screen 1 1; screen-at 0.1 0.2 {screen:?} }}"
                );
                Stage::new(&[&[&*camera], scene].concat().join("\n"))
                    .pixel()
                    .r
                    > 0.0
            };
            let [near, far] = [0.7, 9.3].map(|eye| eye + 0.9 * f64::from(step));
            for surface in surfaces(z) {
                assert_eq!(seen(near, &[&surface]), counts, "{z:?} {step} {surface}");
            }
            let beside = beside(z);
            assert_eq!(
                seen(far, &[mirror, &beside]),
                counts,
                "{z:?} {step}, in a mirror"
            );
            assert_eq!(
                seen(far, &[lit, &beside]),
                !counts,
                "{z:?} {step}, a shadow"
            );
        }
    }
}

/// S2: a floor that begins at the screen's lower edge, or a wall at its left, is seen in all of the
/// outermost pixels, though the rays to them are rounded.
#[test]
fn what_begins_at_the_edge_of_the_screen_is_seen_there() {
    for step in 0..60 {
        let number = |pace: f64| f64::from(step) * pace + 0.1;
        let [x, y, z] = [0.37, 0.23, 0.71].map(number);
        let [at_x, at_y, at_z] = [0.3 - x, 0.9 - y, z - 0.05 - 0.17 * f64::from(step % 4)];
        let text = format!(
            "image 9 7
            camera {{ viewpoint {x:?} {y:?} {z:?}; screen 12.3 9.1
                screen-at {at_x:?} {at_y:?} {at_z:?} }}
            plane {{ material \"red\"; point 0 {at_y:?} 0; normal 0 1 0 }}
            plane {{ material \"red\"; point {at_x:?} 0 0; normal 1 0 0 }}"
        );
        let film = Stage::new(&text).film();
        for place in 0..9 {
            let bottom = film.pixel(place, 6).r;
            let left = film.pixel(0, place.min(6)).r;
            assert!(bottom > 0.0 && left > 0.0, "{step}: {place} of {text}");
        }
    }
}

/// S2: a surface exactly in the screen is seen.
#[test]
fn the_screen_itself_belongs_to_the_scene() {
    for normal in ["0 0 1", "0 0 -3"] {
        let text = format!(r#"plane {{ material "red"; point 7 7 0; normal {normal} }}"#);
        assert_eq!(Stage::eye(&text).pixel(), Rgb::new(0.25, 0.0, 0.0));
    }
}
