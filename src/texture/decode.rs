//! Image files as textures.

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

use super::Texels;
use crate::image_file::{self, ImageFileError};

/// Checks the header of an image file.
///
/// # Errors
/// Returns an error if the file cannot be read, is no image, or if the image is empty or too large.
pub fn check(path: &Path) -> Result<(), ImageFileError> {
    image_file::check(&read(path)?)
}

/// Reads the texels of an image file.
///
/// # Errors
/// Returns an error if the file cannot be read, is no image, or if the image is damaged, empty or
/// too large.
pub fn decode(path: &Path) -> Result<Texels, ImageFileError> {
    image_file::decode(&read(path)?).map(Texels::from)
}

fn read(path: &Path) -> Result<Vec<u8>, ImageFileError> {
    const MOST: u64 = 1 << 30;
    // Reading from a pipe could block forever.
    let kind = fs::metadata(path).map_err(ImageFileError::Io)?;
    if !kind.is_file() && !kind.is_dir() {
        let reason = "it is not a regular file".to_owned();
        return Err(ImageFileError::Format(reason));
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(ImageFileError::Io)?;
    let read = file.take(MOST + 1).read_to_end(&mut bytes);
    read.map_err(ImageFileError::Io)?;
    if bytes.len() as u64 > MOST {
        let reason = format!("the file has more than {} MiB", MOST >> 20);
        return Err(ImageFileError::Format(reason));
    }
    Ok(bytes)
}
