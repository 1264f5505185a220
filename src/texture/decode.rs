//! Image files to texels.

use std::fs::{self, File};
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};

use image::{DynamicImage, ImageError, ImageReader, Limits};

use super::{Texels, pnm::Header};

/// The longest side of a texture in texels.
pub const LONGEST_SIDE: u32 = 32_768;

/// The most texels that a texture may have; they take six bytes each.
pub const MOST_TEXELS: u64 = 1 << 27;

/// Why an image file cannot be a texture.
#[derive(Debug, thiserror::Error)]
#[error("cannot use {path} as a texture: {fault}")]
pub struct DecodeError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it.
    #[source]
    pub fault: ImageFileError,
}

/// What is wrong with an image file.
#[derive(Debug, thiserror::Error)]
pub enum ImageFileError {
    /// It is missing or cannot be opened or read.
    #[error("it cannot be read: {0}")]
    Io(io::Error),
    /// It is not an image, or breaks the rules of its format.
    #[error("{0}")]
    Format(String),
    /// It ends too early, or its contents do not fit together.
    #[error("{0}")]
    Damaged(String),
    /// It has no texels.
    #[error("it has {0} by {1} texels")]
    Empty(u32, u32),
    /// It has more texels than [`LONGEST_SIDE`] and [`MOST_TEXELS`] allow.
    #[error("it has {0} by {1} texels")]
    TooLarge(u32, u32),
}

/// Looks at an image file's header only.
///
/// # Errors
/// If the file cannot be read, is not an image, or has no texels or too many.
pub fn check(path: &Path) -> Result<(), DecodeError> {
    let bytes = read(path);
    let checked = bytes.and_then(|bytes| size(&bytes));
    checked.map_err(|fault| fault.of(path))
}

/// Reads an image file; the format is recognised by content. Transparency is dropped.
///
/// # Errors
/// If the file cannot be read, is not an image, is damaged, or has no texels or too many.
pub fn decode(path: &Path) -> Result<Texels, DecodeError> {
    let bytes = read(path);
    let texels = bytes.and_then(|bytes| texels(&bytes));
    texels.map_err(|fault| fault.of(path))
}

/// The bytes of a file.
fn read(path: &Path) -> Result<Vec<u8>, ImageFileError> {
    const MOST: u64 = 1 << 30;
    // A pipe would be waited for, perhaps for ever.
    let kind = fs::metadata(path).map_err(ImageFileError::Io)?;
    if !kind.is_file() && !kind.is_dir() {
        return Err(ImageFileError::Format(
            "it is not a regular file".to_owned(),
        ));
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(ImageFileError::Io)?;
    file.take(MOST + 1)
        .read_to_end(&mut bytes)
        .map_err(ImageFileError::Io)?;
    if bytes.len() as u64 > MOST {
        let reason = format!("the file has more than {} MiB", MOST >> 20);
        return Err(ImageFileError::Format(reason));
    }
    Ok(bytes)
}

/// Refuses a size that a texture cannot have.
fn size(bytes: &[u8]) -> Result<(), ImageFileError> {
    if bytes.is_empty() {
        return Err(ImageFileError::Format("the file is empty".to_owned()));
    }
    let (width, height) = match (Header::read(bytes), png_size(bytes)) {
        (Some(header), _) => header.map(|header| (header.width, header.height))?,
        (None, Some(size)) => size,
        (None, None) => reader(bytes)?
            .into_dimensions()
            .map_err(ImageFileError::from)?,
    };
    if width == 0 || height == 0 {
        return Err(ImageFileError::Empty(width, height));
    }
    let count = u64::from(width) * u64::from(height);
    if width.max(height) > LONGEST_SIDE || count > MOST_TEXELS {
        return Err(ImageFileError::TooLarge(width, height));
    }
    Ok(())
}

/// Width and height from the start of a PNG file, which the decoder does not tell if it refuses
/// them.
fn png_size(bytes: &[u8]) -> Option<(u32, u32)> {
    let header = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")?;
    let side = |at| Some(u32::from_be_bytes(*header.get(at..)?.first_chunk()?));
    Some((side(0)?, side(4)?))
}

fn texels(bytes: &[u8]) -> Result<Texels, ImageFileError> {
    size(bytes)?;
    if let Some(header) = Header::read(bytes) {
        return header?.texels(bytes);
    }
    let image = reader(bytes)?.decode().map_err(ImageFileError::from)?;
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

fn reader(bytes: &[u8]) -> Result<ImageReader<Cursor<&[u8]>>, ImageFileError> {
    let reader = ImageReader::new(Cursor::new(bytes));
    let mut reader = reader.with_guessed_format().map_err(ImageFileError::Io)?;
    // The size is checked here, before anything is allocated.
    reader.limits(Limits::no_limits());
    Ok(reader)
}

impl ImageFileError {
    fn of(self, path: &Path) -> DecodeError {
        DecodeError {
            path: path.to_owned(),
            fault: self,
        }
    }
}

impl From<ImageError> for ImageFileError {
    fn from(error: ImageError) -> Self {
        match error {
            ImageError::IoError(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
                Self::Damaged("it ends too early".to_owned())
            }
            ImageError::IoError(error) => Self::Io(error),
            ImageError::Unsupported(_) => Self::Format("it is not an image".to_owned()),
            other => {
                let said = other.to_string();
                let said = said
                    .split_once(": ")
                    .map_or(said.as_str(), |(_, said)| said);
                // What follows is about the decoder rather than about the file.
                let said = said.split(" while decoding").next().unwrap_or_default();
                Self::Damaged(said.to_owned())
            }
        }
    }
}
