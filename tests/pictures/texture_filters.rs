//! Texture filters: what each shows, the exact one against very many samples, and the pictures in
//! `docs/texture-filters.md`, which `SNAPSHOTS=overwrite` rewrites.

use std::path::Path;

use heliodon::film::Film;
use heliodon::plan::Scope;
use heliodon::render::{Counts, Render};
use heliodon::scene::{Scene, Setting};
use heliodon::texture::Filter;
use image::{Rgb, RgbImage, imageops};
use rayon::ThreadPoolBuilder;
use support::files::repository;
use support::floors::{
    self, HORIZON, LEVEL, Painter, TURNED, checker, floor, folder, head, noise, squares,
};
use support::golden::compare;

fn plain(_: u32, _: u32) -> [u8; 3] {
    [200, 100, 50]
}

/// A scene whose texture lies in a folder.
fn scene(text: &str, folder: &Path, filter: Filter, samples: u32) -> Scene {
    let samples = samples.to_string();
    let settings = [("texture-filter", filter.word()), ("samples", &samples)];
    floors::scene(text, folder, &settings)
}

fn drawn(scene: &Scene) -> (Film, Counts) {
    Render::new(scene).film().expect("a picture")
}

fn film(text: &str, folder: &Path, filter: Filter) -> Film {
    drawn(&scene(text, folder, filter, 1)).0
}

/// The largest difference of two films in a channel, in code values.
fn largest_difference(one: &Film, other: &Film) -> f64 {
    let channels = |film: &Film| -> Vec<f64> {
        let pixels = film.pixels().iter();
        pixels.flat_map(|pixel| pixel.channels()).collect()
    };
    let (one, other) = (channels(one), channels(other));
    let pairs = one.iter().zip(&other);
    let off = pairs.map(|(one, other)| (one - other).abs() * 255.0);
    off.fold(0.0, f64::max)
}

/// By how much a pixel is off at most where its middle shows the floor, in code values: from the mean
/// over the part of it that does, by 65,536 samples in each of its quarters.
///
/// At the horizon each sample is as good as random, so that a quarter as many would be off by half a
/// code value themselves, and by more in a hundred pixels. Where few of them meet the floor, they are
/// off as well; the error of such a pixel counts as much less as they are fewer.
fn error_of_exact(camera: &str, texel: f64, image: ([u32; 2], Painter)) -> f64 {
    let folder = folder(image.0, image.1);
    let text = |size| head(size, camera) + &floor(texel, HORIZON);
    let reference = scene(&text([24, 16]), folder.path(), Filter::Nearest, 65_536);
    let reference = drawn(&reference).0;
    let (film, counts) = drawn(&scene(&text([12, 8]), folder.path(), Filter::Exact, 1));
    // A strip takes far less time than a ray.
    assert_eq!(counts.camera_rays, 12 * 8);
    assert!(counts.texel_fetches < 1024 * 12 * 8, "{counts:?}");
    let mut most = 0.0f64;
    for (x, y) in (0..8).flat_map(|y| (0..12).map(move |x| (x, y))) {
        let found = film.pixel(x, y);
        let quarters = [0, 1].map(|right| [0, 1].map(|down| (2 * x + right, 2 * y + down)));
        let quarters = quarters.as_flattened().iter();
        let sum = quarters.fold(heliodon::math::Rgb::BLACK, |sum, (x, y)| {
            sum + reference.pixel(*x, *y)
        });
        if found.b == 0.0 {
            continue;
        }
        for (found, expected) in [(found.r, sum.r), (found.g, sum.g)] {
            let off = (found - expected / sum.b).abs() * 255.0;
            most = most.max(off * (sum.b / 4.0).sqrt());
        }
    }
    most
}

#[test]
fn exact_is_the_mean_up_to_the_horizon() {
    for (camera, texel, image) in [
        (LEVEL, 1.0, ([2, 2], checker as Painter)),
        (TURNED, 1.0, ([13, 7], noise as Painter)),
        (TURNED, 1.0 / 32.0, ([64, 64], squares as Painter)),
    ] {
        let error = error_of_exact(camera, texel, image);
        assert!(error <= 1.0, "{error} code values at {camera}");
    }
}

#[test]
fn one_colour_stays_one_colour() {
    let folder = folder([5, 3], plain);
    let things = "sphere { material \"paint\"; center 0.6 0.8 -2; radius 0.5; texture \"image\" }
        ellipsoid { material \"paint\"; center -0.4 0.8 -2; radius 0.3; scale 1 2 1; texture \"image\" }
        sphere { material \"mirror\"; center 0.3 1.6 -2; radius 0.2 }\n";
    let text = head([40, 30], TURNED) + &floor(0.1, HORIZON) + things;
    let nearest = film(&text, folder.path(), Filter::Nearest);
    for filter in Filter::ALL {
        let off = largest_difference(&nearest, &film(&text, folder.path(), filter));
        assert!(off < 1e-9, "{}: {off}", filter.word());
    }
}

/// A picture on a wall, which just fills what is seen.
fn poster(sides: [u32; 2]) -> String {
    head(sides, "viewpoint 0 0 1; look-at 0 0 0; field-of-view 90")
        + "texture-plane { material \"paint\"; point -1 -1 0; normal 0 0 1; xdir 1 0 0
            dimensions 2 2; texture \"image\" }\n"
}

#[test]
fn where_a_pixel_shows_one_texel_exact_is_nearest() {
    let folder = folder([5, 5], noise);
    let (sides, text) = (64usize, poster([64, 64]));
    let [nearest, exact] =
        [Filter::Nearest, Filter::Exact].map(|filter| film(&text, folder.path(), filter));
    let mut inside = 0;
    for (x, y) in (1..sides - 1).flat_map(|y| (1..sides - 1).map(move |x| (x, y))) {
        let around = (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| (x, y)));
        let here = nearest.pixel(x, y);
        if around.into_iter().all(|(x, y)| nearest.pixel(x, y) == here) {
            assert_eq!(exact.pixel(x, y), here);
            inside += 1;
        }
    }
    assert!(inside > 2500, "{inside}");
}

#[test]
fn a_mirror_image_of_a_texture_looks_like_its_mirror_image() {
    let (there, back): (Painter, Painter) = (noise, |x, y| noise(4 - x, y));
    let folders = [there, back].map(|painter| folder([5, 3], painter));
    for filter in Filter::ALL {
        // 15 pixels to a texel, and three texels to a pixel.
        for sides in [75, 2] {
            let text = poster([sides, sides]);
            let [there, back] = folders.each_ref().map(|it| film(&text, it.path(), filter));
            for (x, y) in (0..sides).flat_map(|y| (0..sides).map(move |x| (x, y))) {
                let [x, y, last] = [x, y, sides - 1].map(|it| it as usize);
                let (one, other) = (there.pixel(x, y), back.pixel(last - x, y));
                let pairs = one.channels().into_iter().zip(other.channels());
                let equal = pairs
                    .into_iter()
                    .all(|(one, other)| (one - other).abs() < 1e-12);
                assert!(equal, "{} {x} {y}: {one:?} {other:?}", filter.word());
            }
        }
    }
}

#[test]
fn a_mirror_shows_the_floor_as_it_is_seen_from_the_other_side() {
    let folder = folder([13, 7], noise);
    let floor = floor(0.3, -1.0);
    let wall = "plane { material \"mirror\"; point 0 0 -1; normal 0 0 1 }\n";
    // No ray of these goes to the border of a texel, which rounding would move.
    let [there, behind] = [0.173, -2.173].map(|z| {
        let camera = format!("viewpoint 0.317 1.013 {z}; look-at 0.317 1.013 -1; field-of-view 40");
        head([30, 20], &camera)
    });
    let (mirrored, seen) = (there + wall + &floor, behind + &floor);
    for filter in Filter::ALL {
        let [mirrored, seen] = [&mirrored, &seen].map(|text| film(text, folder.path(), filter));
        let mut bright = 0;
        for (x, y) in (0..20).flat_map(|y| (0..30).map(move |x| (x, y))) {
            let (one, other) = (mirrored.pixel(x, y), seen.pixel(29 - x, y));
            let pairs = one.channels().into_iter().zip(other.channels());
            let equal = pairs
                .into_iter()
                .all(|(one, other)| (one - other).abs() < 1e-6);
            assert!(equal, "{} {x} {y}: {one:?} {other:?}", filter.word());
            bright += i32::from(one.b > 0.5);
        }
        assert_eq!(bright, 300);
    }
}

/// The eye on the floor, nearly and truly; mirrors that spread beams; a floor of unimaginable size.
#[test]
fn every_pixel_is_a_number() {
    let folder = folder([13, 7], noise);
    let balls = "sphere { material \"mirror\"; center 0 1 -3; radius 1 }
        ellipsoid { material \"paint\"; center 2 1 -3; radius 1; scale 1 2 1; texture \"image\" }\n";
    for height in ["0", "1e-300", "1e-9", "1", "1e9"] {
        let camera = format!("viewpoint 0 {height} 0; look-at 0 {height} -1");
        for texel in [1e-12, 1.0, 1e6] {
            let text = head([20, 14], &camera) + &floor(texel, HORIZON) + balls;
            for filter in Filter::ALL {
                let film = film(&text, folder.path(), filter);
                let all = film.pixels().iter().flat_map(|pixel| pixel.channels());
                for channel in all {
                    let about = (filter.word(), height, texel);
                    assert!((0.0..=1.0 + 1e-9).contains(&channel), "{channel} {about:?}");
                }
            }
        }
    }
}

#[test]
fn threads_and_what_is_left_out_change_nothing() {
    let folder = folder([13, 7], noise);
    let ball = "sphere { material \"mirror\"; center 0.3 1 -3; radius 0.5 }\n";
    let text = head([30, 20], TURNED) + &floor(0.3, HORIZON) + ball;
    let bits = |film: &Film| -> Vec<_> {
        let pixels = film.pixels().iter();
        pixels
            .map(|pixel| pixel.channels().map(f64::to_bits))
            .collect()
    };
    for filter in Filter::ALL {
        let draw = |threads, scope| {
            let scene = scene(&text, folder.path(), filter, 2);
            let pool = ThreadPoolBuilder::new().num_threads(threads).build();
            let pool = pool.expect("threads");
            pool.install(|| {
                Render::new(&scene)
                    .scope(scope)
                    .film::<Counts>()
                    .expect("a picture")
            })
        };
        let (one, counts) = draw(1, Scope::CalledFor);
        let nearest = filter == Filter::Nearest;
        assert_eq!(counts.texel_fetches <= counts.rays(), nearest);
        let (three, same) = draw(3, Scope::CalledFor);
        assert_eq!(counts, same);
        let (everything, _) = draw(2, Scope::Everything);
        assert!(bits(&one) == bits(&three) && bits(&one) == bits(&everything));
    }
}

/// A floor of squares to the horizon under each filter, and with 1,024 samples.
#[test]
fn the_pictures_in_the_documentation() {
    const GAP: u32 = 4;
    let board: Painter = |x, y| {
        if (x / 32 + y / 32).is_multiple_of(2) {
            [242, 236, 220]
        } else {
            [36, 52, 71]
        }
    };
    let folder = folder([64, 64], board);
    let camera = "viewpoint 0 1 0; look-at 0.45 0.86 -1; field-of-view 32";
    let text = head([160, 120], camera) + &floor(0.4 / 32.0, HORIZON);
    let mut looks = Filter::ALL.map(|filter| (filter, 1)).to_vec();
    looks.push((Filter::Nearest, 1024));
    let mut sheet =
        RgbImage::from_pixel(3 * (320 + GAP) - GAP, 2 * (240 + GAP) - GAP, Rgb([255; 3]));
    for (number, (filter, samples)) in (0u32..).zip(looks) {
        let scene = scene(&text, folder.path(), filter, samples);
        let bytes = drawn(&scene).0.bytes(scene.settings.encoding());
        let picture = RgbImage::from_raw(160, 120, bytes).expect("all pixels");
        let picture = imageops::resize(&picture, 320, 240, imageops::FilterType::Nearest);
        let (column, row) = (number % 3, number / 3);
        let place = [column * (320 + GAP), row * (240 + GAP)].map(i64::from);
        imageops::replace(&mut sheet, &picture, place[0], place[1]);
    }
    let kept = repository("docs/texture-filters/horizon.png");
    let comparison = repository("target/texture-filters/horizon.png");
    compare(&kept, &sheet, &comparison).unwrap_or_else(|complaint| panic!("{complaint}"));
}

#[test]
fn exact_stays_exact_with_more_rays() {
    let folder = folder([64, 64], noise);
    let camera = "viewpoint 0.3 1 0.2; look-at 1.1 -0.5 -1; up 0.2 1 0.1; field-of-view 40";
    let text = head([24, 16], camera) + &floor(0.05, HORIZON);
    let drawn_with = |settings: &[(&str, &str)]| {
        let mut scene = scene(&text, folder.path(), Filter::Exact, 1);
        for (word, value) in settings {
            let setting = Setting::new(word, value).expect("a setting");
            scene.settings = scene.settings.with(&setting);
        }
        drawn(&scene).0
    };
    let once = drawn_with(&[]);
    for settings in [
        &[("samples", "5")][..],
        &[("samples", "16")],
        &[("samples", "8"), ("pattern", "sobol")],
        &[("samples", "9"), ("pattern", "grid")],
        &[("max-error", "0.03")],
        &[("samples", "8"), ("max-error", "0.03")],
    ] {
        let off = largest_difference(&drawn_with(settings), &once);
        assert!(off < 1.0, "{settings:?}: {off}");
    }
}
