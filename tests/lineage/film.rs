//! From intensities to files.

use heliodon::film::{BitDepth, Film, Format, Notes, Rounding};
use heliodon::math::Rgb;
use heliodon::texture::decode;

use super::tools::{Stage, letters};

fn file(film: &Film, format: Format, rounding: Rounding) -> Vec<u8> {
    let mut bytes = Vec::new();
    film.write(&mut bytes, format, rounding, &Notes::default())
        .unwrap();
    bytes
}

fn film(width: usize, pixels: &[Rgb]) -> Film {
    let mut film = Film::new(width, pixels.len() / width).expect("memory");
    film.pixels_mut().copy_from_slice(pixels);
    film
}

/// S16: a P6 file: one header, then three bytes for each pixel, the top row first.
#[test]
fn a_pixmap_is_written_from_the_top() {
    let picture = film(
        2,
        &[Rgb::new(1.0, 0.0, 0.0), Rgb::BLACK, Rgb::BLACK, Rgb::WHITE],
    );
    let expected = b"P6\n2 2\n255\n\xff\0\0\0\0\0\0\0\0\xff\xff\xff";
    assert_eq!(file(&picture, Format::Ppm, Rounding::Nearest), expected);
}

/// S16: intensities are clamped only when they are stored; 1 is the largest code value.
#[test]
fn intensities_are_clamped_when_stored() {
    let picture = film(1, &[Rgb::new(-3.0, 1.0, 17.0)]);
    assert_eq!(picture.pixel(0, 0).b, 17.0);
    assert!(file(&picture, Format::Ppm, Rounding::Nearest).ends_with(&[0, 255, 255]));
}

/// S16: the nearest code value, or the next lower one as in the course's programs.
#[test]
fn codes_are_rounded_or_truncated() {
    let picture = film(1, &[Rgb::new(0.5, 254.9 / 255.0, 99.4 / 255.0)]);
    assert!(file(&picture, Format::Ppm, Rounding::Nearest).ends_with(&[128, 255, 99]));
    assert!(file(&picture, Format::Ppm, Rounding::Truncate).ends_with(&[127, 254, 99]));
}

/// S16: the scene says which.
#[test]
fn the_scene_chooses_the_rounding() {
    let rounding = |property: &str| {
        let text = format!("image 1 1 {property}\n camera {{ viewpoint 0 0 4; screen 1 1 }}");
        Stage::new(&text).scene().settings.rounding
    };
    assert_eq!(rounding(""), Rounding::Nearest);
    assert_eq!(rounding("quantize=\"truncate\""), Rounding::Truncate);
}

/// S16: code values have 8 bits unless the scene asks for more.
#[test]
fn the_scene_chooses_the_depth() {
    let depth = |property: &str| {
        let text = format!("image 1 1 {property}\n camera {{ viewpoint 0 0 4; screen 1 1 }}");
        Stage::new(&text).scene().settings.depth
    };
    assert_eq!(depth(""), BitDepth::Eight);
    assert_eq!(depth("depth=8"), BitDepth::Eight);
    assert_eq!(depth("depth=16"), BitDepth::Sixteen);
    assert_eq!(depth("depth=\"16\""), BitDepth::Sixteen);
    assert_eq!(depth("depth=float"), BitDepth::Float);
}

/// S16: the chapter has no curve; the scene may ask for one, and a PNG tells of it.
#[test]
fn a_curve_is_applied_if_the_scene_asks_for_it() {
    let encoding = |property: &str| {
        let text = format!("image 1 1 {property}\n camera {{ viewpoint 0 0 4; screen 1 1 }}");
        Stage::new(&text).scene().settings.encoding()
    };
    let picture = film(1, &[Rgb::new(0.5, 0.002, 2.0)]);
    let written = |format, property| {
        let mut bytes = Vec::new();
        picture
            .write(&mut bytes, format, encoding(property), &Notes::default())
            .unwrap();
        bytes
    };
    let has = |bytes: &[u8], chunk: &[u8]| bytes.windows(4).any(|four| four == chunk);
    let curve = "transfer=\"srgb\"";
    assert!(written(Format::Ppm, "").ends_with(&[128, 1, 255]));
    assert!(written(Format::Ppm, curve).ends_with(&[188, 7, 255]));
    let truncated = "transfer=\"srgb\" quantize=\"truncate\"";
    assert!(written(Format::Ppm, truncated).ends_with(&[187, 6, 255]));
    assert_eq!(written(Format::Pfm, curve), written(Format::Pfm, ""));
    for format in [Format::Png8, Format::Png16] {
        for chunk in [b"sRGB", b"gAMA"] {
            assert!(has(&written(format, curve), chunk));
            assert!(!has(&written(format, ""), chunk));
        }
    }
}

/// R34, S16: a picture that was written is read back as a texture, every texel in its place.
#[test]
fn a_picture_is_read_back_as_a_texture() {
    let pixels = (0..6u8).map(|i| Rgb::new(f64::from(i), f64::from(40 * i), 255.0) / 255.0);
    let picture = film(3, &pixels.collect::<Vec<_>>());
    let folder = tempfile::tempdir().unwrap();
    for format in [Format::Ppm, Format::Png8, Format::Png16] {
        let path = folder.path().join("picture");
        std::fs::write(&path, file(&picture, format, Rounding::Nearest)).unwrap();
        let texels = decode(&path).unwrap();
        assert_eq!((texels.width, texels.height), (3, 2));
        let step = if texels.deep { 257 } else { 1 };
        let expected = (0..6u16).map(|i| [i * step, 40 * i * step, 255 * step]);
        assert_eq!(texels.channels, expected.collect::<Vec<_>>(), "{format:?}");
    }
}

/// S15: more samples are averaged unclamped: a pixel half covered by a very bright surface is
/// still half as bright as it.
#[test]
fn samples_are_averaged_unclamped() {
    let text = r#"
        image 1 1 samples=256
        camera { viewpoint 0 0 1000000; look-at 0 0 0; field-of-view 0.0001 }
        lighting { view-falloff "none" }
        material "bright" { ambient 8 }
        finite-plane { material "bright"; point 0 -9 -1; normal 0 0 1; xdir 1 0 0; dimensions 9 18 }"#;
    let pixel = Stage::new(text).pixel();
    assert!((pixel.r - 4.0).abs() < 0.25, "{pixel:?}");
}

/// S15: samples are a function of pixel and number alone: two pictures are the same.
#[test]
fn samples_repeat() {
    let text = r#"
        sphere { material "red"; center 15.5 7.5 -9; radius 7 }"#;
    let draw = || {
        let mut scene = Stage::grid(text).scene();
        scene.settings.samples = 7;
        super::tools::film(&scene)
    };
    let (first, second) = (draw(), draw());
    assert_eq!(first, second);
    assert!(letters(&first).contains('r') || letters(&first).contains('R'));
    assert!(
        first
            .pixels()
            .iter()
            .any(|pixel| pixel.r > 0.0 && pixel.r < 1.0),
        "soft edges"
    );
}
