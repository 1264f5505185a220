//! Decoding of image files; the format is recognised by content.

use std::io::{self, Cursor};

use image::error::{ImageFormatHint, UnsupportedErrorKind};
use image::{DynamicImage, ImageError, ImageReader, Limits};

use super::pnm::Header;
use super::{ImageFileError, LONGEST_SIDE, MOST_PIXELS, Pixels};

/// Checks the header of an image file.
///
/// # Errors
/// Returns an error if the bytes are no image, or if the image is empty or too large.
pub fn check(bytes: &[u8]) -> Result<(), ImageFileError> {
    if bytes.is_empty() {
        return Err(ImageFileError::Format("the file is empty".to_owned()));
    }
    let (width, height) = match (Header::read(bytes), png_size(bytes)) {
        (Some(header), _) => header.map(|header| (header.width, header.height))?,
        (None, Some(size)) => size,
        (None, None) => reader(bytes)?.into_dimensions()?,
    };
    if width == 0 || height == 0 {
        return Err(ImageFileError::Empty(width, height));
    }
    let count = u64::from(width) * u64::from(height);
    if width.max(height) > LONGEST_SIDE || count > MOST_PIXELS {
        return Err(ImageFileError::TooLarge(width, height));
    }
    Ok(())
}

/// Decodes an image file. Transparency is dropped.
///
/// # Errors
/// Returns an error if the bytes are no image, or if the image is damaged, empty or too large.
pub fn decode(bytes: &[u8]) -> Result<Pixels, ImageFileError> {
    check(bytes)?;
    if let Some(header) = Header::read(bytes) {
        return header?.pixels(bytes);
    }
    let image = reader(bytes)?.decode()?;
    let (width, height) = (image.width() as usize, image.height() as usize);
    let is_deep = matches!(
        image,
        DynamicImage::ImageLuma16(_)
            | DynamicImage::ImageLumaA16(_)
            | DynamicImage::ImageRgb16(_)
            | DynamicImage::ImageRgba16(_)
    );
    let (channels, largest) = if is_deep {
        let image = image.into_rgb16();
        (image.pixels().map(|pixel| pixel.0).collect(), u16::MAX)
    } else {
        let image = image.into_rgb8();
        let channels = image.pixels().map(|pixel| pixel.0.map(u16::from));
        (channels.collect(), u16::from(u8::MAX))
    };
    Ok(Pixels {
        width,
        height,
        channels,
        largest,
    })
}

/// Width and height from the start of a PNG file.
///
/// The decoder does not report a size that it rejects.
fn png_size(bytes: &[u8]) -> Option<(u32, u32)> {
    let header = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")?;
    let side = |at| Some(u32::from_be_bytes(*header.get(at..)?.first_chunk()?));
    Some((side(0)?, side(4)?))
}

fn reader(bytes: &[u8]) -> Result<ImageReader<Cursor<&[u8]>>, ImageFileError> {
    let reader = ImageReader::new(Cursor::new(bytes));
    let mut reader = reader.with_guessed_format().map_err(ImageFileError::Io)?;
    // `check` limits the size before anything is allocated.
    reader.limits(Limits::no_limits());
    Ok(reader)
}

impl From<ImageError> for ImageFileError {
    fn from(error: ImageError) -> Self {
        match error {
            ImageError::IoError(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
                Self::Damaged("it ends too early".to_owned())
            }
            ImageError::IoError(error) => Self::Io(error),
            ImageError::Unsupported(error) => Self::Format(match error.kind() {
                UnsupportedErrorKind::Format(ImageFormatHint::Exact(format)) => {
                    let name = format.extensions_str().first().unwrap_or(&"the format");
                    format!("{} is not supported", name.to_uppercase())
                }
                UnsupportedErrorKind::Format(_) => "unknown image format".to_owned(),
                _ => error.to_string(),
            }),
            other => {
                let text = other.to_string();
                let reason = text.split_once(": ").map_or(&*text, |(_, reason)| reason);
                // The rest describes the decoder, not the file.
                let reason = reason.split(" while decoding").next().unwrap_or_default();
                Self::Damaged(reason.to_owned())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unsupported_format_is_named() {
        for (bytes, expected) in [
            (&b"GIF89a\x01\0\x01\0"[..], "GIF is not supported"),
            (b"BM\0\0\0\0\0\0\0\0", "BMP is not supported"),
            (b"a text", "unknown image format"),
        ] {
            let error = decode(bytes).expect_err("no image that is supported");
            assert_eq!(error.to_string(), expected);
        }
    }
}
