//! Round things that touch a lamp, or nearly do.

use std::sync::Arc;

use glam::DVec3;
use heliodon::math::{Point, Ray, RayOrigin, Segment, Side, unit};
use heliodon::plan::Scope;
use heliodon::read::{Options, read_bytes};
use heliodon::scene::Scene;
use heliodon::visibility::{Emitter, LightView, Occlusion, Silhouettes, SurfaceList};

use super::{bits, picture};

/// A floor of 6 by 6 below a lamp and something, seen from above past both.
fn above_a_floor(things: &str) -> String {
    format!(
        "image 24 24\ncamera {{ viewpoint 0 2 9; look-at 0 0 0 }}\n\
         material \"chalk\" {{ diffuse 0.5 }}\nmaterial \"black\" {{ }}\n\
         finite-plane \"floor\" {{ material \"chalk\"; point -3 0 3; normal 0 1 0; xdir 1 0 0
             dimensions 6 6 }}\n{things}"
    )
}

/// The rays to lamps that are sent, and what they would be if nothing were left out, which changes no
/// bit.
fn lamp_rays(things: &str) -> [u64; 2] {
    let scene = above_a_floor(things);
    let [(film, counts), (whole, all)] =
        [Scope::CalledFor, Scope::Everything].map(|scope| picture(&scene, scope));
    assert!(bits(&film) == bits(&whole), "{things}");
    [counts.lamp_rays, all.lamp_rays]
}

const GLOBE: &str = "lamp { center 0 4 0; radius 0.5; emissivity 3; samples 16 }\n";
const PANE: &str = "lamp { point -1 4 -1; normal 0 -1 0; xdir 1 0 0; dimensions 2 2
    emissivity 3; samples 16 }\n";

/// Things that hide nothing of a lamp from the floor, and touch it; the last ones nearly do.
const BEYOND: [[&str; 2]; 7] = [
    [
        GLOBE,
        "sphere { material \"black\"; center 0 5 0; radius 0.5 }",
    ],
    // Five is the length of 3, 4 and 0: the plane between both slopes down to beyond the floor.
    [
        "lamp { center 0 6 0; radius 2.5; emissivity 3; samples 16 }\n",
        "sphere { material \"black\"; center 3 10 0; radius 2.5 }",
    ],
    [
        GLOBE,
        "ellipsoid { material \"black\"; center 0 5.5 0; radius 1; scale 0.25 1 0.5 }",
    ],
    [
        PANE,
        "sphere { material \"black\"; center 0.5 5 0; radius 1 }",
    ],
    [
        PANE,
        "ellipsoid { material \"black\"; center 0 4.5 0; radius 1; scale 2 0.5 0.25 }",
    ],
    [
        GLOBE,
        "sphere { material \"black\"; center 0 5.00000000000001 0; radius 0.5 }",
    ],
    // A slope that leaves out the ball, but not the box around it.
    [
        GLOBE,
        "plane { material \"black\"; point 0.4 4.4 0; normal -1 -1 0; shadows receive=#false }",
    ],
];

#[test]
fn what_touches_a_lamp_from_beyond_is_not_asked() {
    for [lamp, thing] in BEYOND {
        let [sent, all] = lamp_rays(&format!("{lamp}{thing}"));
        assert_eq!(sent, 0, "{lamp}{thing}");
        assert!(all > 1000, "{lamp}{thing}");
    }
}

#[test]
fn what_touches_a_lamp_from_below_is_asked_and_casts_its_shadow() {
    let below = "sphere { material \"black\"; center 0 3 0; radius 0.5 }";
    let before = "sphere { material \"black\"; center 0 3.5 0; radius 0.5 }";
    for [lamp, thing] in [[GLOBE, below], [PANE, before]] {
        let [sent, _] = lamp_rays(&format!("{lamp}{thing}"));
        assert!(sent > 1000, "{lamp}{thing}");
        let [open, dark] = ["", thing].map(|thing| {
            let scene = above_a_floor(&format!("{lamp}{thing}"));
            picture(&scene, Scope::CalledFor).0.pixel(12, 13).r
        });
        assert!(dark < 0.9 * open, "{lamp}{thing}: {dark} {open}");
    }
}

#[test]
fn of_things_that_overlap_a_lamp_all_is_asked() {
    let through = [
        [
            GLOBE,
            "sphere { material \"black\"; center 0 4.75 0; radius 0.5 }",
        ],
        [
            PANE,
            "sphere { material \"black\"; center 0.5 4.75 0; radius 1 }",
        ],
    ];
    for [lamp, thing] in through {
        let [sent, _] = lamp_rays(&format!("{lamp}{thing}"));
        assert!(sent > 1000, "{lamp}{thing}");
    }
}

fn scene(text: &str) -> Scene {
    let reading = read_bytes("touching", text.into(), "".into(), &Options::default());
    reading
        .unwrap_or_else(|no| panic!("{:#?}", no.diagnostics))
        .scene
}

/// The lowest of the places from which it is said that nothing stands before a lamp, and whether what is
/// asked says so, too, for the points of the lamp that touch what is next to it, but for rounding.
#[test]
fn from_the_lowest_place_that_is_said_to_see_all_of_a_lamp_all_of_it_is_seen() {
    // Both touch in `touch`, and the plane between them rises there along `up`.
    let cases = [
        (GLOBE, BEYOND[0][1], [0.0, 4.5, 0.0], [0.0, -1.0, 0.0]),
        (
            BEYOND[1][0],
            BEYOND[1][1],
            [1.5, 8.0, 0.0],
            [-3.0, -4.0, 0.0],
        ),
        (PANE, BEYOND[3][1], [0.5, 4.0, 0.0], [0.0, -1.0, 0.0]),
        (PANE, BEYOND[4][1], [0.0, 4.0, 0.0], [0.0, -1.0, 0.0]),
    ];
    for (lamp, thing, touch, up) in cases {
        // Of a plane without end all that is said is said of each place.
        let floor = "image 1 1\ncamera { viewpoint 0 2 9; look-at 0 0 0 }\n\
            material \"black\" { }\nplane { material \"black\"; point 0 0 0; normal 0 1 0 }";
        let scene = scene(&format!("{floor}\n{lamp}{thing}"));
        let surfaces = SurfaceList::new(&scene.surfaces);
        let silhouettes = Arc::new(Silhouettes::new(scene.surfaces.len()));
        let emitter = Emitter::lamps(&surfaces).next().expect("a lamp");
        let view = LightView::new(&surfaces, &silhouettes, emitter, false, |_| true);
        let floor = &surfaces.primitives()[0];
        let caster = &scene.surfaces[2];
        assert_eq!(caster.shape().side(&Point::exact(touch.into())), Side::On);
        let (touch, up) = (DVec3::from(touch), unit(up.into()).expect("a direction"));
        let along = unit(up.cross(DVec3::new(0.3, 0.1, 1.0))).expect("a direction");
        // A ray that arrives from above, and leaves the floor for the lamp.
        let arriving = Ray::new(Point::exact(DVec3::splat(-9.0)), DVec3::Y);
        let ray_origin = |height: f64, aside: f64| {
            let place = Point::exact(touch + along * aside + up * height);
            RayOrigin::new((floor.carrier, floor.plane), &arriving, place, 0.0)
        };
        let is_open = |ray_origin: &RayOrigin| {
            let ray = Ray::spawn(ray_origin, DVec3::Y);
            let receiver = view.receiver(floor).expect("a floor before the lamp");
            let hit = heliodon::geometry::Hit {
                t: 1.0,
                error: 0.0,
                point: ray_origin.point,
                normal: DVec3::Y,
                uv: glam::DVec2::ZERO,
                texel: heliodon::math::Rgb::WHITE,
            };
            matches!(receiver.occlusion(&hit, &ray), Occlusion::None)
        };
        for aside in [0.0, 0.7, -1.5, 3.0, 40.0] {
            let (mut low, mut high) = (0.0, 400.0);
            assert!(is_open(&ray_origin(high, aside)), "{thing} {aside}");
            assert!(!is_open(&ray_origin(low, aside)), "{thing} {aside}");
            for _ in 0..80 {
                let middle = f64::midpoint(low, high);
                if is_open(&ray_origin(middle, aside)) {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            assert!(high < 0.1 + aside.abs() / 8.0, "{thing} {aside}: {high}");
            let ray_origin = ray_origin(high, aside);
            for power in 3..60 {
                for sign in [1.0, -1.0] {
                    // Within what rounding can make of a point of the lamp.
                    let off = along * sign * libm::exp2(-f64::from(power));
                    for sunk in [0.0, 1.0, 4.0, 16.0] {
                        let end = touch + off - up * sunk * f64::EPSILON * touch.length();
                        let segment = Segment::new(&ray_origin, end).expect("a way");
                        let hides = caster.shape().occludes(&segment, Side::Front);
                        assert!(!hides, "{thing} {aside} {power} {sunk}");
                    }
                }
            }
        }
    }
}
