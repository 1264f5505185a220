//! What is known of many neighbouring rays at once changes neither the picture nor what is counted.

use heliodon::camera::PixelSpan;
use heliodon::film::Film;
use heliodon::plan::{Plan, Scope};
use heliodon::read::{Options, read_bytes};
use heliodon::render::{Both, Certificate, Counts, Probe, Render, Tracer, pixel_color};
use heliodon::scene::Scene;
use heliodon::visibility::Visible;

const WIDTH: u64 = 75;
const HEIGHT: u64 = 40;

fn scene(nodes: &str) -> Scene {
    let text = format!(
        "image {WIDTH} {HEIGHT}\nmaterial \"chalk\" {{ ambient 2 3 4; diffuse 1 }}\n\
         texture \"bricks\" \"textures/brick-128.png\"\n{nodes}"
    );
    let reading = read_bytes(
        "stretches",
        text.into_bytes(),
        "".into(),
        &Options::default(),
    );
    reading
        .unwrap_or_else(|no| panic!("{:#?}", no.diagnostics))
        .scene
}

fn drawn<P: Probe + Default + Send + std::iter::Sum>(
    scene: &Scene,
    scope: Scope,
) -> (Vec<[u64; 3]>, P) {
    let (film, seen): (Film, P) = Render::new(scene).scope(scope).film().expect("a camera");
    let bits = film
        .pixels()
        .iter()
        .map(|color| color.channels().map(f64::to_bits));
    (bits.collect(), seen)
}

/// The picture pixel by pixel, as nothing is drawn in stretches then, and what is asked for it.
fn pixel_by_pixel(scene: &Scene) -> (Vec<[u64; 3]>, u64) {
    let plan = Plan::new(scene, Scope::CalledFor).expect("a camera");
    let [width, height] = [WIDTH, HEIGHT].map(|it| usize::try_from(it).expect("a side"));
    let mut counts = Counts::default();
    let places = (0..height).flat_map(|row| (0..width).map(move |column| [column, row]));
    let colors = places.map(|[column, row]| {
        let color = pixel_color(Tracer::new(&plan), scene, column, row, &mut counts);
        color.channels().map(f64::to_bits)
    });
    (colors.collect(), counts.hit_tests)
}

const CAMERAS: [&str; 4] = [
    "camera { viewpoint 4 3 8; screen 8 6 }",
    // The plane of the screen cuts what is seen.
    "camera { viewpoint 4 3 8; screen 8 6; screen-at 0 0 -5 }",
    "camera { viewpoint 1 2 9; look-at 0 0 0; up 0.3 1 0 }",
    "camera { viewpoint 0 5 0; look-at 0 0 0; up 0 0 1 }",
];

const SURFACES: [&str; 6] = [
    r#"plane { material "chalk"; point 0 -1 0; normal 0 1 0 }"#,
    // Its horizon crosses the picture askew.
    r#"plane { material "chalk"; point 0 -1 0; normal -0.2 1 0.1 }"#,
    // Along the screen, and across the view.
    r#"plane { material "chalk"; point 0 0 -5; normal 0 0 1 }"#,
    r#"finite-plane { material "chalk"; point 1 -1 0; normal 0 1 0.2; xdir 1 0 0; dimensions 5 7 }"#,
    r#"texture-plane { material "chalk"; point -3 -1 0; normal 0 1 0.2; xdir 1 0 0; dimensions 9 7
        texture "bricks" mode="repeat" texel=0.01 }"#,
    r#"sphere { material "chalk"; center 2 2 -5; radius 3 }"#,
];

const LIGHTINGS: [&str; 4] = [
    "",
    "lighting { view-falloff \"none\" }",
    "lighting { view-falloff \"inverse-square\" }",
    "light { location 3 9 3; emissivity 9 }",
];

#[test]
fn beside_all_that_can_be_seen_of_a_surface_a_stretch_has_nothing_ahead() {
    let card = r#"finite-plane { material "chalk"; point -1 -1 0; normal 0 0 1; xdir 1 0 0
        dimensions 2 2 }"#;
    let scene = scene(&format!(
        "camera {{ viewpoint 0 0 9; look-at 0 0 0 }}\n{card}"
    ));
    let plan = Plan::new(&scene, Scope::CalledFor).expect("a camera");
    let sight = plan
        .screen_bounds
        .as_ref()
        .expect("one surface has no tree");
    let ahead = |y: f64, first: u32| {
        let row = &plan.camera.row(y);
        let count = 5;
        match sight.along(&PixelSpan { row, first, count }) {
            Visible::Nothing => 0,
            Visible::One(_) => 1,
            Visible::Several => 2,
        }
    };
    // The card is in the middle 11 columns and rows or so.
    assert_eq!([10, 35, 60].map(|first| ahead(19.5, first)), [0, 1, 0]);
    assert_eq!([5.0, 35.0].map(|y| ahead(y, 35)), [0, 0]);
    assert_eq!([28, 42].map(|first| ahead(19.5, first)), [2, 2]);
}

#[test]
fn one_surface_is_drawn_as_if_each_ray_were_asked() {
    for camera in CAMERAS {
        for surface in SURFACES {
            for lighting in LIGHTINGS {
                let nodes = format!("{camera}\n{lighting}\n{surface}");
                let scene = scene(&nodes);
                let (film, counts) = drawn::<Counts>(&scene, Scope::CalledFor);
                let (each, _) = drawn::<Counts>(&scene, Scope::Everything);
                assert!(film == each, "{nodes}");
                let (certified, Both(counted, _)) =
                    drawn::<Both<Counts, Certificate>>(&scene, Scope::CalledFor);
                assert!(film == certified, "{nodes}");
                assert_eq!(counts, counted, "{nodes}");
                assert_eq!(counts.camera_rays, WIDTH * HEIGHT, "{nodes}");
                assert!(
                    (film, counts.hit_tests) == pixel_by_pixel(&scene),
                    "{nodes}"
                );
            }
        }
    }
}
