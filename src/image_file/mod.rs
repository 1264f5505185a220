//! Image files to pixels: PNG, JPEG and PNM.

mod decode;
mod pnm;

pub use decode::{check, decode};

use std::io;

/// The longest side of an image in pixels.
pub const LONGEST_SIDE: u32 = 32_768;

/// The most pixels of an image. Each takes six bytes.
pub const MOST_PIXELS: u64 = 1 << 27;

/// The pixels of an image file, row by row from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pixels {
    /// Width in pixels, at least 1.
    pub width: usize,
    /// Height in pixels, at least 1.
    pub height: usize,
    /// Red, green and blue of each pixel, as the file has them.
    pub channels: Vec<[u16; 3]>,
    /// The channel value of full intensity.
    pub largest: u16,
}

/// An error in an image file.
#[derive(Debug, thiserror::Error)]
pub enum ImageFileError {
    /// The file is missing or cannot be read.
    #[error("{0}")]
    Io(io::Error),
    /// The format is not supported, or the file breaks the rules of its format.
    #[error("{0}")]
    Format(String),
    /// The file ends too early, or its contents contradict each other.
    #[error("the file is damaged: {0}")]
    Damaged(String),
    /// The image of this width and height has no pixels.
    #[error("the image has {0} by {1} pixels")]
    Empty(u32, u32),
    /// The image of this width and height exceeds [`LONGEST_SIDE`] or [`MOST_PIXELS`].
    #[error("an image of {0} by {1} pixels is too large")]
    TooLarge(u32, u32),
}
