//! PGM and PPM files: `P2`, `P3`, `P5` and `P6`.
//!
//! The `image` crate rounds to 8 bits if the largest value is not 255, and clamps values above the
//! largest. This reader returns the values of the file, and an error for values that are too large.

use super::{ImageFileError, Pixels};

/// The header of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) width: u32,
    pub(super) height: u32,
    /// The value of full intensity.
    largest: u16,
    /// Values of a pixel: 1 or 3.
    channels: usize,
    /// True if values are bytes, false if they are decimal numbers.
    binary: bool,
    /// Index of the first byte after the header.
    start: usize,
}

impl Header {
    /// The header of a file; `None` for another format.
    pub(super) fn read(bytes: &[u8]) -> Option<Result<Self, ImageFileError>> {
        let (channels, binary) = match bytes.first_chunk()? {
            b"P2" => (1, false),
            b"P3" => (3, false),
            b"P5" => (1, true),
            b"P6" => (3, true),
            _ => return None,
        };
        Some(Self::numbers(bytes, channels, binary))
    }

    fn numbers(bytes: &[u8], channels: usize, binary: bool) -> Result<Self, ImageFileError> {
        let mut numbers = Numbers { bytes, at: 2 };
        let mut next = |name: &str| {
            let missing = || Err(ImageFileError::Format(format!("the header has no {name}")));
            numbers.next().unwrap_or_else(missing)
        };
        let (width, height, largest) = (next("width")?, next("height")?, next("largest value")?);
        let fitting = u16::try_from(largest).ok().filter(|largest| *largest > 0);
        let error = || format!("the largest value is {largest}, expected 1 to 65535");
        Ok(Self {
            width,
            height,
            largest: fitting.ok_or_else(|| ImageFileError::Format(error()))?,
            channels,
            binary,
            // A single space or newline precedes binary values.
            start: (numbers.at + 1).min(bytes.len()),
        })
    }

    /// The pixels after a header that has passed [`check`](super::check).
    pub(super) fn pixels(self, bytes: &[u8]) -> Result<Pixels, ImageFileError> {
        let (width, height) = (self.width as usize, self.height as usize);
        let count = width * height * self.channels;
        let values: Vec<u16> = match (self.binary, &bytes[self.start..]) {
            (true, bytes) if self.largest > 0xFF => {
                let pairs = bytes.as_chunks().0.iter().take(count);
                pairs.map(|pair| u16::from_be_bytes(*pair)).collect()
            }
            (true, bytes) => bytes.iter().take(count).map(|it| u16::from(*it)).collect(),
            (false, _) => self.decimals(bytes, count)?,
        };
        if values.len() < count {
            let reason = format!("it ends after {} of {count} values", values.len());
            return Err(ImageFileError::Damaged(reason));
        }
        if let Some(above) = values.iter().find(|value| **value > self.largest) {
            return Err(self.too_large((*above).into()));
        }
        Ok(Pixels {
            width,
            height,
            channels: match self.channels {
                3 => values.as_chunks().0.to_vec(),
                _ => values.into_iter().map(|value| [value; 3]).collect(),
            },
            largest: self.largest,
        })
    }

    /// At most `count` decimal numbers.
    fn decimals(self, bytes: &[u8], count: usize) -> Result<Vec<u16>, ImageFileError> {
        let at = self.start;
        let numbers = Numbers { bytes, at }.take(count).map(|number| {
            let number = number?;
            u16::try_from(number).map_err(|_| self.too_large(number))
        });
        numbers.collect()
    }

    fn too_large(self, value: u32) -> ImageFileError {
        let largest = self.largest;
        ImageFileError::Format(format!("the value {value} is above the largest, {largest}"))
    }
}

/// The decimal numbers of a file; comments reach from `#` to the end of the line.
#[derive(Debug)]
struct Numbers<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Iterator for Numbers<'_> {
    type Item = Result<u32, ImageFileError>;

    fn next(&mut self) -> Option<Self::Item> {
        let mut in_comment = false;
        loop {
            match self.bytes.get(self.at)? {
                b'\n' | b'\r' => in_comment = false,
                b'#' => in_comment = true,
                byte if byte.is_ascii_whitespace() || in_comment => {}
                _ => break,
            }
            self.at += 1;
        }
        let rest = &self.bytes[self.at..];
        let ends = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'#';
        let token = &rest[..rest.iter().position(ends).unwrap_or(rest.len())];
        self.at += token.len();
        let text = String::from_utf8_lossy(token);
        let is_number = token.iter().all(u8::is_ascii_digit);
        Some(match text.parse() {
            Ok(number) if is_number => Ok(number),
            _ => {
                let shown: String = text
                    .chars()
                    .take(12)
                    .flat_map(char::escape_default)
                    .collect();
                Err(ImageFileError::Format(if is_number {
                    format!("the number `{shown}…` is too large")
                } else {
                    format!("`{shown}` is not a number")
                }))
            }
        })
    }
}
