//! A part of a picture is what the whole has there.

use heliodon::film::{Film, Region};
use heliodon::render::{Counts, Render};
use heliodon::scene::Scene;

use super::scene;

fn bits(film: &Film, part: Region) -> Vec<[u64; 3]> {
    let rows = part.top..part.top + part.height;
    let places = rows.flat_map(|row| (part.left..part.left + part.width).map(move |it| (it, row)));
    places
        .map(|(column, row)| film.pixel(column, row).channels().map(f64::to_bits))
        .collect()
}

fn assert_parts_are_as_in_the_whole(scene: &Scene, what: &str) {
    let (whole, all): (Film, Counts) = Render::new(scene).film().expect("a possible camera");
    for (from, to) in [([0, 0], [7, 5]), ([13, 9], [32, 24]), ([20, 11], [21, 12])] {
        let part = Region::between(from, to).expect("some pixels");
        for threads in [1, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            let pool = pool.build().expect("threads");
            let (film, counts): (Film, Counts) = pool
                .install(|| Render::new(scene).part(part).film())
                .expect("a possible camera");
            let its_own = Region {
                left: 0,
                top: 0,
                ..part
            };
            assert_eq!((film.width(), film.height()), (part.width, part.height));
            assert_eq!(bits(&film, its_own), bits(&whole, part), "{what} {part:?}");
            assert!(counts.camera_rays < all.camera_rays);
        }
    }
}

#[test]
fn a_part_is_as_in_the_whole_for_every_dial() {
    for file in ["saucers-textured", "lamp-room", "glass-ball"] {
        for settings in [
            &[][..],
            &[("samples", "5")],
            &[("samples", "4"), ("pattern", "sobol")],
            &[("samples", "3"), ("pattern", "grid")],
            &[("samples", "2"), ("pattern", "random")],
            &[("numerics", "classic-f32"), ("cut-off", "0.01")],
            &[("samples", "1"), ("max-error", "8/255")],
        ] {
            let scene = scene(file, [32, 24], settings);
            assert_parts_are_as_in_the_whole(&scene, &format!("{file} {settings:?}"));
        }
    }
}

#[test]
fn a_part_lies_within_the_picture() {
    let scene = scene("room", [32, 24], &[]);
    let outside = Region::between([30, 0], [33, 4]).expect("some pixels");
    let refused = Render::new(&scene).part(outside).film::<Counts>();
    let error = refused.expect_err("it is not");
    assert_eq!(
        error.reason,
        "the crop 30,0,33,4 reaches beyond the picture of 32 by 24 pixels"
    );
}
