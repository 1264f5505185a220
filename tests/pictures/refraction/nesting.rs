//! Media within media, beside each other, and overlapping.

use super::tools::{CUT_OFF, assert_edge, pixel, solve, wall};

/// Where a ray of this slope meets a wall 2 behind the centre of concentric balls at depth 4, each
/// given by its radius and its index, from outside in.
///
/// In every shell n · p is the same, so at a radius r between two of them the ray is turned by
/// asin(p/(n₁ r)) − asin(p/(n₂ r)).
fn behind_shells(slope: f64, shells: &[(f64, f64)]) -> f64 {
    let angle = libm::atan(slope);
    let passing = 4.0 * libm::sin(angle);
    let (mut turned, mut outside) = (angle, 1.0);
    for (radius, index) in shells {
        let [before, after] = [outside, *index].map(|index| libm::asin(passing / (index * radius)));
        turned -= 2.0 * (before - after);
        outside = *index;
    }
    passing / libm::cos(turned) + 2.0 * libm::tan(turned)
}

fn balls(balls: &[(f64, &str)]) -> String {
    let node = |(radius, material): &(f64, &str)| {
        format!("sphere {{ material \"{material}\"; center 0 0 -4; radius {radius} }}\n")
    };
    balls.iter().map(node).collect()
}

#[test]
fn shells_of_media_bend_in_any_order_of_the_file() {
    let (glass, bubble, water) = ((1.0, "glass"), (0.75, "air"), (0.5, "water"));
    let indices = [(1.0, 1.5), (0.75, 1.0), (0.5, 1.25)];
    for (shells, edge) in [
        (vec![glass, bubble], 0.5),
        (vec![glass, bubble, water], -0.1),
        (vec![bubble, water], -0.1),
    ] {
        let skipped = indices.len() - if shells[0] == bubble { 2 } else { 3 };
        let indices = &indices[skipped..skipped + shells.len()];
        let slope = solve(0.24, edge, |slope| behind_shells(slope, indices));
        let mut shells = shells;
        for _ in 0..2 {
            assert_edge(&[balls(&shells), wall(6.0, edge)].concat(), slope);
            shells.reverse();
        }
    }
}

/// Of an eye inside of a ball: n · p is kept, p = e sin θ.
#[test]
fn a_ray_that_starts_inside_leaves_its_medium() {
    let seen = |slope: f64| {
        let angle = libm::atan(slope);
        let passing = 0.5 * libm::sin(angle);
        let turned = angle + libm::asin(passing) - libm::asin(passing * 1.5);
        // The eye is half a unit behind the centre.
        let turned_passing = passing * 1.5;
        turned_passing / libm::cos(turned) + 2.5 * libm::tan(turned)
    };
    let ball = "sphere { material \"glass\"; center 0 0 -0.5; radius 1 }\n";
    for edge in [0.5, 1.5] {
        let slope = solve(2.0, edge, seen);
        assert_edge(&[ball, &wall(3.0, edge)].concat(), slope);
    }
}

const BACKGROUND: &str = "plane { material \"white\"; point 0 0 -50; normal 0 0 1 }\n";

/// What passes m panes of glass, all mirror images between them included:
/// (1 − R)/(1 + (2m − 1) R) (Stokes 1862).
fn pile_of_plates(plates: f64) -> f64 {
    0.96 / (1.0 + 0.04 * (2.0 * plates - 1.0))
}

fn slab(front: f64, back: f64) -> String {
    format!(
        "plane {{ material \"glass\"; point 0 0 {front}; normal 0 0 1 }}
        plane {{ material \"glass\"; point 0 0 {back}; normal 0 0 -1 }}\n"
    )
}

#[track_caller]
fn assert_passes(text: &str, expected: f64) {
    let passed = pixel(&[text, BACKGROUND].concat());
    assert!(
        (passed.g - expected).abs() <= CUT_OFF,
        "{} for {expected}",
        passed.g
    );
}

#[test]
fn plates_pass_what_stokes_computed() {
    assert_passes("", 1.0);
    assert_passes(&slab(-1.0, -2.0), pile_of_plates(1.0));
    assert_passes(
        &[slab(-1.0, -2.0), slab(-3.0, -4.0)].concat(),
        pile_of_plates(2.0),
    );
}

#[test]
fn what_overlaps_is_one_piece() {
    assert_passes(
        &[slab(-1.0, -3.0), slab(-2.0, -4.0)].concat(),
        pile_of_plates(1.0),
    );
    assert_passes(
        &[slab(-2.0, -4.0), slab(-1.0, -3.0)].concat(),
        pile_of_plates(1.0),
    );
    let ball = |x: f64| format!("sphere {{ material \"glass\"; center 0 0 {x}; radius 1 }}\n");
    assert_passes(&[ball(-4.0), ball(-5.5)].concat(), pile_of_plates(1.0));
    assert_passes(&[ball(-5.5), ball(-4.0)].concat(), pile_of_plates(1.0));
    // A slab of air in glass makes two plates of it.
    let gap = slab(-2.0, -3.0).replace("glass", "air");
    assert_passes(&[slab(-1.0, -4.0), gap].concat(), pile_of_plates(2.0));
}

#[test]
fn balls_that_nearly_touch_are_two() {
    let ball = |z: f64| format!("sphere {{ material \"glass\"; center 0 0 {z}; radius 1 }}\n");
    let beside = (-6.0f64).next_down();
    assert_passes(&[ball(-4.0), ball(beside)].concat(), pile_of_plates(2.0));
    assert_passes(&[ball(beside), ball(-4.0)].concat(), pile_of_plates(2.0));
}
