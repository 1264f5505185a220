//! Image files to texels.

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use image::{DynamicImage, ImageReader};

use super::Texels;

/// Why an image file cannot be a texture.
#[derive(Debug, thiserror::Error)]
pub enum DecodeError {
    /// The file is missing or cannot be opened or read.
    #[error("cannot read {path}: {source}")]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The file is not an image, or a broken one.
    #[error("{path} is not an image that can be read: {reason}")]
    Format {
        /// The file.
        path: PathBuf,
        /// What the decoder said.
        reason: String,
    },
    /// The image has no pixels.
    #[error("{path} is an image of {width} by {height} pixels")]
    Empty {
        /// The file.
        path: PathBuf,
        /// Its width.
        width: u32,
        /// Its height.
        height: u32,
    },
}

/// Looks at an image file's header only.
///
/// # Errors
/// If the file cannot be opened, is not an image, or has no pixels.
pub fn check(path: &Path) -> Result<(), DecodeError> {
    let (width, height) = open(path)?
        .into_dimensions()
        .map_err(|error| decode_error(path, error))?;
    if width == 0 || height == 0 {
        return Err(DecodeError::Empty {
            path: path.to_owned(),
            width,
            height,
        });
    }
    Ok(())
}

/// Reads an image file; the format is recognised by content. Transparency is dropped.
///
/// # Errors
/// If the file cannot be read, is not an image, is damaged, or has no pixels.
pub fn decode(path: &Path) -> Result<Texels, DecodeError> {
    check(path)?;
    let image = open(path)?
        .decode()
        .map_err(|error| decode_error(path, error))?;
    let (width, height) = (image.width() as usize, image.height() as usize);
    let deep = matches!(
        image,
        DynamicImage::ImageLuma16(_)
            | DynamicImage::ImageLumaA16(_)
            | DynamicImage::ImageRgb16(_)
            | DynamicImage::ImageRgba16(_)
    );
    let channels = if deep {
        image.into_rgb16().pixels().map(|pixel| pixel.0).collect()
    } else {
        image
            .into_rgb8()
            .pixels()
            .map(|pixel| pixel.0.map(u16::from))
            .collect()
    };
    Ok(Texels {
        width,
        height,
        channels,
        deep,
    })
}

fn open(path: &Path) -> Result<ImageReader<BufReader<File>>, DecodeError> {
    let io_error = |source| DecodeError::Io {
        path: path.to_owned(),
        source,
    };
    let file = File::open(path).map_err(io_error)?;
    let reader = ImageReader::new(BufReader::new(file));
    reader.with_guessed_format().map_err(io_error)
}

fn decode_error(path: &Path, error: image::ImageError) -> DecodeError {
    match error {
        image::ImageError::IoError(source) => DecodeError::Io {
            path: path.to_owned(),
            source,
        },
        other => DecodeError::Format {
            path: path.to_owned(),
            reason: other.to_string(),
        },
    }
}
