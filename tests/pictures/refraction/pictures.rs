//! What is seen of glass: energy, shadows, tints, and the work it takes.

use heliodon::math::Numerics;

use super::tools::{counts, film, pixel, scene};

/// Wherever one looks, in a world that is white all around clear glass takes nothing away.
#[test]
fn in_a_white_world_glass_is_white() {
    let faces = [
        ("0 0 9", "0 0 -1"),
        ("0 0 -9", "0 0 1"),
        ("9 0 0", "-1 0 0"),
        ("-9 0 0", "1 0 0"),
    ];
    let more = [("0 9 0", "0 -1 0"), ("0 -9 0", "0 1 0")];
    let walls = faces.iter().chain(&more).map(|(point, normal)| {
        format!("plane {{ material \"white\"; point {point}; normal {normal} }}\n")
    });
    let walls: String = walls.collect();
    for numerics in Numerics::ALL.map(Numerics::word) {
        let white = film(&scene(&format!(
            r#"image 24 16 cut-off=0.001 numerics="{numerics}"
            camera {{ viewpoint 0 0.3 5; look-at 0 0 0; field-of-view 40 }}
            sphere {{ material "glass"; center -1.2 0 0; radius 1 }}
            sphere {{ material "air"; center -1.2 0 0; radius 0.8 }}
            ellipsoid {{ material "water"; center 1.2 0 0; radius 1; scale 1 1.3 0.7 }}
            triangle {{ material "glass"; vertex1 -1 -2 1; vertex2 1 -2 1; vertex3 0 -1 0.5 }}
            {walls}"#
        )));
        for pixel in white.pixels() {
            assert!(
                pixel
                    .channels()
                    .iter()
                    .all(|c| (c - 1.0).abs() < 0.001 + 1e-12),
                "{pixel:?}"
            );
        }
    }
}

/// A ball of air in air, clear and white, is not there at all.
#[test]
fn a_ball_of_air_is_invisible() {
    let picture = |ball: &str| {
        film(&scene(&format!(
            r#"image 60 40
            camera {{ viewpoint 0 1 5; look-at 0 0 0; field-of-view 40 }}
            light {{ location 3 6 4; emissivity 9 }}
            material "floor" {{ ambient 1; diffuse 1; specular 0.2 }}
            texture-plane {{ material "floor"; point -5 -1 5; normal 0 1 0; xdir 1 0 0;
                dimensions 10 10; texture "bust" mode="clamp" }}
            texture "bust" "../textures/brick-128.png"
            {ball}"#
        )))
    };
    for ball in [
        r#"sphere { material "air"; center 0 0.2 0; radius 1 }"#,
        r#"ellipsoid { material "air"; center 0 0.2 0; radius 1; scale 1 0.5 2 }"#,
        r#"plane { material "air"; point 0 0 2; normal 0 1 3 }"#,
    ] {
        let (without, with) = (picture(""), picture(ball));
        for (a, b) in without.pixels().iter().zip(with.pixels()) {
            let apart = a
                .channels()
                .into_iter()
                .zip(b.channels())
                .map(|(a, b)| (a - b).abs());
            assert!(apart.fold(0.0, f64::max) < 1e-13, "{a:?} {b:?}");
        }
    }
}

/// Own colour, seen through varnish: (1 − R) own + R mirrored, from the front and from behind.
#[test]
fn varnish_mirrors_what_fresnel_says() {
    for normal in ["0 0 1", "0 0 -1"] {
        let seen = pixel(&format!(
            r#"material "varnished" {{ ambient 0 0 1; specular 1; ior 1.5 }}
            plane {{ material "varnished"; point 0 0 0; normal {normal} }}
            plane {{ material "red"; point 0 0 9; normal 0 0 -1 }}"#
        ));
        assert!(
            (seen.r - 0.04).abs() < 1e-15 && (seen.b - 0.96).abs() < 1e-15,
            "{seen:?}"
        );
    }
}

/// Each passage through a surface takes its share t, its tint, and leaves (1 − t) of its own colour.
#[test]
fn tinted_glass_tints_at_every_surface() {
    let seen = pixel(
        r#"material "tinted" { ambient 0 0 1; diffuse 1 0.5 0; transparency 0.5; ior 1 }
        plane { material "tinted"; point 0 0 0; normal 0 0 1 }
        plane { material "tinted"; point 0 0 -1; normal 0 0 -1 }
        plane { material "white"; point 0 0 -9; normal 0 0 1 }"#,
    );
    assert_eq!(seen.channels(), [0.25, 0.0625, 0.5]);
}

/// Light goes straight through glass on its way to what it lights, and is tinted once.
#[test]
fn shadows_of_glass_are_tinted() {
    let lit = |things: &str, light: &str| {
        pixel(&format!(
            r#"material "matte" {{ diffuse 1 }}
            material "rose" {{ diffuse 1 0.5 0; transparency 0.5; ior 1.5 }}
            light {{ location {light}; emissivity 1 }}
            sphere {{ material "matte"; center 0 0 0; radius 1 }}
            {things}"#
        ))
    };
    let plain = lit("", "0 0 90");
    let rose = plain * heliodon::math::Rgb::new(0.5, 0.25, 0.0);
    // Behind the eye, between the light and the lit ball.
    let beyond = r#"sphere { material "rose"; center 0 0 20; radius 2 }"#;
    assert_eq!(lit(beyond, "0 0 90"), rose);
    // Around the lit ball and the eye; then the light is inside, too.
    let around = r#"sphere { material "rose"; center 0 0 3; radius 9 }"#;
    assert_eq!(lit(around, "0 0 90"), rose);
    assert_eq!(lit(around, "0 0 11"), plain);
    let both = [beyond, "\n", around].concat();
    assert_eq!(
        lit(&both, "0 0 90"),
        plain * heliodon::math::Rgb::new(0.25, 0.0625, 0.0)
    );
}

/// Camera, shadow, mirrored and transmitted rays, and surfaces asked.
#[test]
fn the_work_is_what_the_effects_call_for() {
    let of = |text: &str| {
        let counts = counts(&scene(&format!(
            "image 1 1\n camera {{ viewpoint 0 0 4; look-at 0 0 0 }}\n{text}"
        )));
        let [camera, mirror] = [counts.camera_rays, counts.mirror_rays];
        [
            camera,
            counts.shadow_rays,
            mirror,
            counts.transmitted_rays,
            counts.hit_tests,
        ]
    };
    let wall = r#"plane { material "white"; point 0 0 -9; normal 0 0 1 }"#;
    assert_eq!(of(wall), [1, 0, 0, 0, 1]);
    // Air in air mirrors nothing. The ball is met from outside, from inside, and not again; the
    // last ray asks it, since it might have gone inside.
    let ball = |material: &str| {
        format!("sphere {{ material \"{material}\"; center 0 0 0; radius 1 }}\n{wall}")
    };
    assert_eq!(of(&ball("air")), [1, 0, 0, 2, 6]);
    // An opaque ball of glass is not entered; it is varnished, and what it mirrors is nothing.
    let varnish = "material \"varnish\" { ambient 1; ior 1.5 }\n";
    assert_eq!(of(&[varnish, &ball("varnish")].concat()), [1, 0, 1, 0, 3]);
    // Nothing is bent, nothing mirrored where no material says so.
    let thin = "material \"thin\" { transparency 1 }\n";
    assert_eq!(of(&[thin, &ball("thin")].concat()), [1, 0, 0, 1, 3]);
}
