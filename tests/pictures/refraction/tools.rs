//! What the tests are written with: scenes from text, the place of an edge in a picture.

use heliodon::film::Film;
use heliodon::math::Rgb;
use heliodon::plan::{Plan, Scope};
use heliodon::read::{Options, read_bytes};
use heliodon::render::{Counts, Tracer, render};
use heliodon::scene::Scene;

/// A scene in which nothing fades, with a few materials, from this text.
#[track_caller]
pub(super) fn scene(text: &str) -> Scene {
    let text = format!(
        r#"lighting {{ falloff "none"; view-falloff "none" }}
        material "white" {{ ambient 1 }}
        material "red" {{ ambient 1 0 0 }}
        material "glass" {{ diffuse 1; transparency 1; ior 1.5 }}
        material "water" {{ diffuse 1; transparency 1; ior 1.25 }}
        material "air" {{ diffuse 1; transparency 1; ior 1 }}
        {text}"#
    );
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes").into();
    match read_bytes("stage", text.into_bytes(), path, &Options::default()) {
        Ok(reading) => reading.scene,
        Err(scene_error) => panic!("{:#?}", scene_error.diagnostics),
    }
}

pub(super) fn film(scene: &Scene) -> Film {
    render(scene, &|_| ()).unwrap().0
}

pub(super) fn counts(scene: &Scene) -> Counts {
    render(scene, &|_| ()).unwrap().1
}

/// How much light a [`pixel`] may lack.
pub(super) const CUT_OFF: f64 = 0.00001;

/// The colour of the one pixel of a picture.
#[track_caller]
pub(super) fn pixel(text: &str) -> Rgb {
    let film = film(&scene(&format!(
        "image 1 1 cut-off={CUT_OFF}\n camera {{ viewpoint 0 0 4; look-at 0 0 0 }}\n{text}"
    )));
    assert_eq!(film.pixels().len(), 1);
    film.pixel(0, 0)
}

/// A camera at the origin that looks along −z; [`assert_edge`] asks it for single rays.
pub(super) const EYE: &str = "image 1 1 cut-off=0.01\n
    camera { viewpoint 0 0 0; look-at 0 0 -1; field-of-view 90 }\n";

/// A wall across the z axis at this depth, white where x is above `edge`, red elsewhere.
pub(super) fn wall(depth: f64, edge: f64) -> String {
    let half = |material: &str, x: f64| {
        format!(
            "finite-plane {{ material \"{material}\"; point {x} -50 {z}; normal 0 0 1; xdir 1 0 0;
            dimensions 100 100 }}\n",
            z = -depth
        )
    };
    [half("white", edge), half("red", edge - 100.0)].concat()
}

/// The ray from the eye along (slope, 0, −1) is the one at which what is seen steps from red to
/// white, to twelve digits.
#[track_caller]
pub(super) fn assert_edge(text: &str, slope: f64) {
    let scene = scene(&[EYE, text].concat());
    let plan = Plan::new(&scene, Scope::CalledFor).unwrap();
    let tracer = Tracer::new(&plan);
    // The window reaches from −1 to 1 at depth 1, and its one pixel's centre is place 0.
    let bright = |slope: f64| tracer.sees(slope / 2.0, 0.0, &mut ()).g > 0.5;
    let near = 1e-12;
    let around = [slope - near, slope + near].map(bright);
    assert!(
        around[0] != around[1],
        "the edge is not at {slope}: {around:?}"
    );
}

/// The smallest argument below `high` at which a function has this value.
#[track_caller]
pub(super) fn solve(high: f64, value: f64, function: impl Fn(f64) -> f64) -> f64 {
    const STEPS: u32 = 1000;
    let above = |place: f64| function(place) > value;
    for step in 1..STEPS {
        let [mut low, mut end] =
            [step, step + 1].map(|step| high * f64::from(step) / f64::from(STEPS));
        if above(low) == above(end) {
            continue;
        }
        for _ in 0..60 {
            let middle = f64::midpoint(low, end);
            if above(middle) == above(low) {
                low = middle;
            } else {
                end = middle;
            }
        }
        // A function may also jump.
        if (function(low) - value).abs() < 1e-9 {
            return low;
        }
    }
    panic!("no solution");
}
