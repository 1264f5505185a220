//! Image files as textures: every format, depth and odd largest value.

use std::path::PathBuf;

use heliodon::image_file::ImageFileError;
use heliodon::math::Rgb;
use heliodon::texture::{Texture, check, decode};
use image::{DynamicImage, ImageFormat};

/// A folder of this test's own.
fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder")
}

fn decoded(bytes: &[u8]) -> Result<Texture, ImageFileError> {
    let folder = folder();
    let path = folder.path().join("image");
    std::fs::write(&path, bytes).expect("the file can be written");
    let checked = check(&path);
    let texels = decode(&path)?;
    checked.expect("what can be decoded passes the check");
    Ok(Texture::new(
        "image",
        "image",
        PathBuf::new(),
        texels,
        255.0,
    ))
}

/// The colours of an image, row by row from the top.
#[track_caller]
fn colors(bytes: &[u8]) -> Vec<[f64; 3]> {
    let texture = decoded(bytes).expect("an image");
    let (width, height) = (texture.texels.width, texture.texels.height);
    let places = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    places
        .map(|(column, row)| texture.texel(column, row).channels())
        .collect()
}

#[track_caller]
fn fault(bytes: &[u8]) -> ImageFileError {
    decoded(bytes).expect_err("no image")
}

/// Values that a file of this largest value is made of: the first and the last, and some between.
fn values(largest: u16) -> [u16; 6] {
    [0, 1, largest / 3, largest / 2, largest - 1, largest]
}

/// What a texel may be off by: half a step of 16 bits, and the rounding of a double.
const HALF_STEP: f64 = 0.5 / 65_535.0 + 1e-15;

#[track_caller]
fn proportional(bytes: &[u8], largest: u16) {
    let found: Vec<_> = colors(bytes).into_iter().flatten().collect();
    let gray = matches!(bytes[1], b'2' | b'5');
    let expected = values(largest).map(|value| f64::from(value) / f64::from(largest));
    let expected = expected
        .iter()
        .flat_map(|value| vec![*value; if gray { 3 } else { 1 }]);
    for (found, expected) in found.iter().zip(expected.clone()) {
        assert!(
            (found - expected).abs() <= HALF_STEP,
            "{largest}: {found} is not {expected}"
        );
        let exact = [255, 65_535].contains(&largest);
        assert!(
            !exact || (found - expected).abs() < 1e-15,
            "{largest}: {found} is not exact"
        );
    }
    assert_eq!(found.len(), expected.count());
}

const LARGEST: [u16; 12] = [1, 2, 3, 15, 100, 254, 255, 256, 1000, 4095, 65_534, 65_535];

#[test]
fn decimal_files_have_the_right_proportions() {
    for largest in LARGEST {
        let numbers = values(largest).map(|value| value.to_string()).join(" ");
        for header in [
            "P2 6 1",
            "P2\n# a comment\n3 2 # another\n",
            "P3 2 1",
            "P3\r\n1 2\r\n",
        ] {
            proportional(
                format!("{header}\n{largest}\n{numbers}\n").as_bytes(),
                largest,
            );
        }
        // Comments between the numbers, and no newline at the end.
        let numbers = numbers.replacen(' ', "#one\n", 1);
        proportional(format!("P2 6 1 {largest} {numbers}").as_bytes(), largest);
    }
}

#[test]
fn binary_files_have_the_right_proportions() {
    for largest in LARGEST {
        let bytes: Vec<u8> = values(largest)
            .iter()
            .flat_map(|value| value.to_be_bytes()[usize::from(largest <= 255)..].to_vec())
            .collect();
        for header in ["P5 6 1", "P5\n#a\n#b\n2\n3", "P6 2 1", "P6 # # #\n1 2 "] {
            let header = format!("{header} {largest}\n");
            proportional(&[header.as_bytes(), &bytes].concat(), largest);
        }
    }
}

#[test]
fn binary_values_that_look_like_spaces_or_comments_are_values() {
    let expected = [[10.0, 35.0, 32.0].map(|value| value / 255.0)];
    assert_eq!(colors(b"P6 1 1 255\n\n# "), expected);
}

#[test]
fn rows_run_from_the_top() {
    let expected = [0.0, 51.0, 102.0, 153.0].map(|value| [value / 255.0; 3]);
    assert_eq!(colors(b"P2 2 2 255 0 51 102 153"), expected);
}

#[test]
fn bitmaps_are_black_where_they_are_one() {
    assert_eq!(colors(b"P1 2 1\n0 1\n"), [[1.0; 3], [0.0; 3]]);
    assert_eq!(colors(b"P4 2 1\n\x40"), [[1.0; 3], [0.0; 3]]);
}

#[test]
fn broken_files_are_told_apart() {
    let format = |bytes: &[u8]| matches!(fault(bytes), ImageFileError::Format(_));
    let damaged = |bytes: &[u8]| matches!(fault(bytes), ImageFileError::Damaged(_));
    assert!(format(b"") && format(b"P") && format(b"P6") && format(b"P6 1") && format(b"P6 1 1"));
    assert!(format(b"P6 1 1 0 aaa") && format(b"P6 1 1 65536 aaaaaa") && format(b"P6 1 1 -1 aaa"));
    assert!(format(b"P2 1 1 255 256") && format(b"P2 1 1 99 100") && format(b"P5 1 1 99\n\xff"));
    assert!(format(b"P2 1 1 255 -1") && format(b"P2 1 1 255 0x1") && format(b"P2 1 1 255 +1"));
    assert!(format(b"P2 1 1 255 99999999999") && format(b"P2 99999999999 1 255 1"));
    assert!(
        damaged(b"P2 2 1 255 1") && damaged(b"P5 2 1 255\n1") && damaged(b"P6 1 1 65535\naaaaa")
    );
    assert!(matches!(
        fault(b"P6 0 5 255\n"),
        ImageFileError::Empty(0, 5)
    ));
    assert!(matches!(
        fault(b"P3 5 0 255\n"),
        ImageFileError::Empty(5, 0)
    ));
}

#[test]
fn an_image_of_gigantic_size_is_refused_before_memory_is_taken() {
    for header in [
        "P6 100000 100000 255\n",
        "P2 32769 1 255\n",
        "P5 32768 32768 65535\n",
    ] {
        assert!(
            matches!(fault(header.as_bytes()), ImageFileError::TooLarge(..)),
            "{header}"
        );
    }
    for header in ["P1 100000 100000\n", "P4 100000 100000\n"] {
        assert!(
            matches!(fault(header.as_bytes()), ImageFileError::TooLarge(..)),
            "{header}"
        );
    }
    // As large as is allowed, but the texels are not there.
    assert!(matches!(
        fault(b"P6 16384 8192 255\nabc"),
        ImageFileError::Damaged(_)
    ));
    assert!(matches!(
        fault(b"P2 16384 8192 255\n1 2 3"),
        ImageFileError::Damaged(_)
    ));
}

fn encoded(image: &DynamicImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    image.write_to(&mut bytes, format).expect("an image");
    bytes.into_inner()
}

#[test]
fn png_files_of_every_kind_keep_their_colors() {
    let texels = (0..6)
        .flat_map(|index| [10, 20 * (index % 3), 30, index])
        .collect();
    let rgba = image::RgbaImage::from_raw(3, 2, texels).expect("3 by 2 texels");
    let image = DynamicImage::ImageRgba8(rgba);
    let full = |x: u32| [10.0, 20.0 * f64::from(x), 30.0].map(|value| value / 255.0);
    let expected: Vec<_> = [0, 1, 2, 0, 1, 2].map(full).to_vec();
    for image in [
        image.clone(),
        DynamicImage::ImageRgb8(image.to_rgb8()),
        DynamicImage::ImageRgb16(image.to_rgb16()),
        DynamicImage::ImageRgba16(image.to_rgba16()),
    ] {
        let found = colors(&encoded(&image, ImageFormat::Png));
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 1e-15, "{:?}", image.color());
        }
    }
    let gray = image.to_luma8();
    let expected: Vec<_> = gray
        .pixels()
        .map(|pixel| [f64::from(pixel.0[0]) / 255.0; 3])
        .collect();
    assert_eq!(colors(&encoded(&gray.into(), ImageFormat::Png)), expected);
    let alpha = DynamicImage::ImageLumaA16(image.to_luma_alpha16());
    assert_eq!(colors(&encoded(&alpha, ImageFormat::Png)).len(), 6);
}

#[test]
fn png_files_of_16_bits_keep_all_of_them() {
    let image = image::ImageBuffer::from_pixel(1, 1, image::Rgb([1u16, 32_768, 65_535]));
    let found = colors(&encoded(&DynamicImage::ImageRgb16(image), ImageFormat::Png));
    let expected = Rgb::new(1.0, 32_768.0, 65_535.0) / (255.0 * 257.0);
    assert_eq!(found, [expected.channels()]);
}

#[test]
fn png_palettes_and_few_bits_are_expanded() {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 4, 1);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Two);
    encoder.set_palette(vec![255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 9, 9]);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&[0b00_01_10_11]).expect("texels");
    writer.finish().expect("an end");
    let gray = 9.0 / 255.0;
    let expected = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [gray; 3]];
    assert_eq!(colors(&bytes), expected);

    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 4, 1);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Two);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&[0b00_01_10_11]).expect("texels");
    writer.finish().expect("an end");
    let expected = [0.0, 1.0, 2.0, 3.0].map(|value| [value * 85.0 / 255.0; 3]);
    assert_eq!(colors(&bytes), expected);
}

#[test]
fn jpeg_files_are_read() {
    let image = image::RgbImage::from_pixel(8, 8, image::Rgb([200, 100, 50]));
    for [r, g, b] in colors(&encoded(&image.into(), ImageFormat::Jpeg)) {
        let near = |found: f64, expected: f64| (found * 255.0 - expected).abs() < 6.0;
        assert!(near(r, 200.0) && near(g, 100.0) && near(b, 50.0));
    }
    let gray = image::GrayImage::from_pixel(8, 8, image::Luma([77]));
    for [r, g, b] in colors(&encoded(&gray.into(), ImageFormat::Jpeg)) {
        assert!(r == g && g == b && (r * 255.0 - 77.0).abs() < 3.0);
    }
}
