//! The shadows of lamps.

use glam::DVec3;
use heliodon::math::form_factor;

use super::{bits, drawn};

/// A scene of which 32 × 32 pixels look at very nearly the same place of a floor, at the origin, under a
/// lamp of which a slanted edge hides a part.
fn half_hidden(samples: u32, slant: f64) -> String {
    format!(
        "image 32 32\ncamera {{ viewpoint 3 2 -1; look-at 0 0 0; field-of-view 1e-7 }}\n\
         material \"chalk\" {{ diffuse 1 }}\n\
         plane {{ material \"chalk\"; point 0 0 0; normal 0 1 0 }}\n\
         lamp {{ point -1 2 -1; normal 0 -1 0; xdir 1 0 0; dimensions 2 2; emissivity 1; samples {samples} }}\n\
         finite-plane {{ material \"chalk\"; point {left} 1 {back}; normal 0 -1 0; xdir 1 0 {slant}; \
         dimensions 299 99 }}",
        left = 0.1 - 99.0,
        back = -99.0 * slant,
    )
}

#[test]
fn a_half_hidden_lamp_converges_to_what_is_seen_of_it() {
    for slant in [0.0, 0.3, 1.0] {
        // On the lamp the edge runs through (0.2, 2, 0) along (1, 0, slant); normal × xdir is hidden.
        let z = |x: f64| (x - 0.2) * slant;
        let seen = [[-1.0, -1.0], [-1.0, z(-1.0)], [1.0, z(1.0)], [1.0, -1.0]];
        let cut = seen.map(|[x, z]| [x, z.clamp(-1.0, 1.0)]);
        let mut corners: Vec<_> = cut.iter().map(|[x, z]| DVec3::new(*x, 2.0, *z)).collect();
        if slant == 1.0 {
            // The edge leaves through z = −1, not through x = −1.
            corners = vec![
                DVec3::new(-0.8, 2.0, -1.0),
                DVec3::new(1.0, 2.0, 0.8),
                DVec3::new(1.0, 2.0, -1.0),
            ];
        }
        corners.reverse();
        let one = form_factor::of_polygon(&corners, DVec3::Y);
        corners.reverse();
        let expected = one.max(form_factor::of_polygon(&corners, DVec3::Y));
        for samples in [4, 16, 64, 256, 4096] {
            let (film, counts) = drawn(&half_hidden(samples, slant));
            let places = || (0..32).flat_map(|x| (0..32).map(move |y| (x, y)));
            assert!(counts.lamp_rays == 1024 * u64::from(samples));
            let off = places().map(|(x, y)| film.pixel(x, y).r / expected - 1.0);
            let off: Vec<f64> = off.collect();
            let mean = off.iter().sum::<f64>() / 1024.0;
            let rms = (off.iter().map(|off| off * off).sum::<f64>() / 1024.0).sqrt();
            println!("slant {slant}, {samples}: mean {mean:.2e}, rms {rms:.2e}");
            // As fast as a sum over an even grid of which an edge cuts a row of cells.
            let bound = 1.5 / f64::from(samples).powf(0.75);
            assert!(
                rms < bound,
                "slant {slant}, {samples} samples: {rms} above {bound}"
            );
            assert!(
                mean.abs() < bound / 8.0,
                "slant {slant}, {samples} samples: {mean}"
            );
        }
    }
}

#[test]
fn the_ceiling_around_a_lamp_hides_nothing_of_it() {
    let scene = |ceiling: &str| {
        format!(
            "image 16 16\ncamera {{ viewpoint 0 1.5 3; look-at 0 0.5 0 }}\nmaterial \"chalk\" {{ diffuse 1 }}\n\
             lamp {{ point -1 2.7 -1; normal 0 -1 0; xdir 1 0 0.3; dimensions 2 1; emissivity 3 }}\n\
             plane {{ material \"chalk\"; point 0 0 0; normal 0 1 0 }}\n\
             sphere {{ material \"chalk\"; center 0 0.5 0; radius 0.5 }}\n{ceiling}"
        )
    };
    let ceiling = "plane { material \"chalk\"; point 0 2.7 0; normal 0 -1 0 }";
    let (open, closed) = (drawn(&scene("")), drawn(&scene(ceiling)));
    for y in 8..16 {
        for x in 0..16 {
            assert_eq!(open.0.pixel(x, y), closed.0.pixel(x, y), "{x} {y}");
        }
    }
}

#[test]
fn glass_tints_a_lamp_and_a_lamp_is_opaque() {
    let scene = |between: &str| {
        format!(
            "image 8 8\ncamera {{ viewpoint 0 1 2; look-at 0 0 0; field-of-view 10 }}\n\
             material \"chalk\" {{ diffuse 1 }}\nmaterial \"glass\" {{ diffuse 1 0.5 0; transparency 0.5 }}\n\
             plane {{ material \"chalk\"; point 0 0 0; normal 0 1 0 }}\n\
             lamp {{ point -1 4 -1; normal 0 -1 0; xdir 1 0 0; dimensions 2 2; emissivity 3 }}\n{between}"
        )
    };
    let open = drawn(&scene("")).0;
    let pane = "finite-plane { material \"glass\"; point -5 3 5; normal 0 1 0; xdir 1 0 0; dimensions 10 10 }";
    let tinted = drawn(&scene(pane)).0;
    let back = "lamp { point -5 3 5; normal 0 1 0; xdir 1 0 0; dimensions 10 10; emissivity 9 }";
    let dark = drawn(&scene(back)).0;
    for (x, y) in (0..8).flat_map(|x| (0..8).map(move |y| (x, y))) {
        let [r, g, b] = tinted.pixel(x, y).channels();
        let whole = open.pixel(x, y).r;
        assert!((r / whole - 0.5).abs() < 1e-12 && (g / whole - 0.25).abs() < 1e-12 && b == 0.0);
        assert!(dark.pixel(x, y).is_black());
    }
}

#[test]
fn what_is_before_the_screen_hides_no_lamp() {
    let seen = |ball: &str| {
        let scene = format!(
            "image 41 41\ncamera {{ viewpoint 2 2 8; screen 4 4 }}\nmaterial \"chalk\" {{ diffuse 1 }}\n\
             finite-plane {{ material \"chalk\"; point -5 -5 -2; normal 0 0 1; xdir 1 0 0; dimensions 15 15 }}\n\
             lamp {{ center 3.5 2 4; radius 0.5; emissivity 3 }}\n\
             sphere {{ material \"chalk\"; {ball} }}"
        );
        drawn(&scene).0.pixel(18, 20).r
    };
    let open = seen("center 20 20 -20; radius 0.4");
    assert_eq!(seen("center 2.9 2 2; radius 0.4"), open);
    assert!(seen("center 2 2 -1; radius 0.2") < 0.5 * open);
}

#[test]
fn classic_numerics_draw_the_same_lamps() {
    let scene = |numerics: &str| {
        format!(
            "image 40 30 numerics=\"{numerics}\"\ncamera {{ viewpoint 0 2 5; look-at 0 0.5 0 }}\n\
             material \"chalk\" {{ diffuse 1 }}\n\
             lamp {{ point -1 3 -1; normal 0 -1 0; xdir 1 0 0; dimensions 2 2; emissivity 3 }}\n\
             lamp {{ center 1.5 0.4 1.5; radius 0.3; emissivity 2 }}\n\
             plane {{ material \"chalk\"; point 0 0 0; normal 0 1 0 }}\n\
             sphere {{ material \"chalk\"; center 0 0.75 0; radius 0.7 }}"
        )
    };
    let [robust, classic] = ["robust", "classic"].map(|numerics| drawn(&scene(numerics)).0);
    let places = || (0..40).flat_map(|x| (0..30).map(move |y| (x, y)));
    let differ =
        |(x, y): &(usize, usize)| (robust.pixel(*x, *y).r - classic.pixel(*x, *y).r).abs() > 1e-6;
    assert!(places().filter(differ).count() < 12);
    assert!(bits(&robust).iter().any(|pixel| *pixel != [0; 3]));
}
