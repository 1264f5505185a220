//! PGM and PPM files: `P2`, `P3`, `P5` and `P6`.
//!
//! Read here and not by the `image` crate, which rounds to 8 bits where a file's largest value is
//! not 255, and takes values above the largest one for the largest.

use super::{Texels, decode::ImageFileError};

/// What stands before the texels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) width: u32,
    pub(super) height: u32,
    /// The value that full intensity has.
    largest: u16,
    /// Three values for a texel, or one.
    color: bool,
    /// Values as bytes, or as decimal numbers.
    binary: bool,
    /// Where the values start.
    start: usize,
}

impl Header {
    /// The header of a file; `None` if it is of another kind.
    pub(super) fn read(bytes: &[u8]) -> Option<Result<Self, ImageFileError>> {
        let (color, binary) = match bytes.first_chunk()? {
            b"P2" => (false, false),
            b"P3" => (true, false),
            b"P5" => (false, true),
            b"P6" => (true, true),
            _ => return None,
        };
        Some(Self::numbers(bytes, color, binary))
    }

    fn numbers(bytes: &[u8], color: bool, binary: bool) -> Result<Self, ImageFileError> {
        let mut numbers = Numbers { bytes, at: 2 };
        let mut next = |what: &str| {
            let missing = || Err(ImageFileError::Format(format!("it has no {what}")));
            numbers.next().unwrap_or_else(missing)
        };
        let (width, height, largest) = (next("width")?, next("height")?, next("largest value")?);
        if !(1..=0xFFFF).contains(&largest) {
            let reason = format!("its largest value is {largest}, expected one from 1 to 65535");
            return Err(ImageFileError::Format(reason));
        }
        Ok(Self {
            width,
            height,
            largest: u16::try_from(largest).unwrap_or(u16::MAX),
            color,
            binary,
            // A single space or newline stands before binary values.
            start: (numbers.at + 1).min(bytes.len()),
        })
    }

    /// The texels that follow the header; its size must be one that fits into memory.
    pub(super) fn texels(self, bytes: &[u8]) -> Result<Texels, ImageFileError> {
        let (width, height) = (self.width as usize, self.height as usize);
        let wanted = width * height * if self.color { 3 } else { 1 };
        let values = if self.binary {
            self.bytes(bytes, wanted)
        } else {
            self.decimals(bytes, wanted)?
        };
        if values.len() < wanted {
            let reason = format!("it ends after {} of {wanted} values", values.len());
            return Err(ImageFileError::Damaged(reason));
        }
        if let Some(above) = values.iter().find(|value| **value > self.largest) {
            let reason = format!(
                "it has the value {above}, but its largest is {}",
                self.largest
            );
            return Err(ImageFileError::Format(reason));
        }
        let texel = |values: &[u16]| match *values {
            [r, g, b] => [r, g, b].map(|value| self.scaled(value)),
            _ => [self.scaled(values[0]); 3],
        };
        Ok(Texels {
            width,
            height,
            channels: values
                .chunks(if self.color { 3 } else { 1 })
                .map(texel)
                .collect(),
            deep: self.largest != 0xFF,
        })
    }

    /// At most this many values from bytes; those above 255 take two, the higher one first.
    fn bytes(self, bytes: &[u8], wanted: usize) -> Vec<u16> {
        let bytes = &bytes[self.start..];
        if self.largest > 0xFF {
            let pairs = bytes.as_chunks().0.iter();
            pairs
                .take(wanted)
                .map(|pair| u16::from_be_bytes(*pair))
                .collect()
        } else {
            bytes
                .iter()
                .take(wanted)
                .map(|byte| u16::from(*byte))
                .collect()
        }
    }

    /// At most this many values from decimal numbers.
    fn decimals(self, bytes: &[u8], wanted: usize) -> Result<Vec<u16>, ImageFileError> {
        let numbers = Numbers {
            bytes,
            at: self.start,
        };
        let numbers = numbers.take(wanted).map(|number| {
            let number = number?;
            u16::try_from(number).map_err(|_| {
                let largest = self.largest;
                ImageFileError::Format(format!(
                    "it has the value {number}, but its largest is {largest}"
                ))
            })
        });
        numbers.collect()
    }

    /// A value of 8 bits as it is, any other on the scale of 16 bits, rounded.
    fn scaled(self, value: u16) -> u16 {
        let (value, largest) = (u32::from(value), u32::from(self.largest));
        let scaled = match largest {
            0xFF | 0xFFFF => value,
            _ => (value * 0xFFFF + largest / 2) / largest,
        };
        u16::try_from(scaled).unwrap_or(u16::MAX)
    }
}

/// The decimal numbers of a file, with comments from `#` to the end of the line between them.
#[derive(Debug)]
struct Numbers<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Iterator for Numbers<'_> {
    type Item = Result<u32, ImageFileError>;

    fn next(&mut self) -> Option<Self::Item> {
        let mut comment = false;
        loop {
            match self.bytes.get(self.at)? {
                b'\n' | b'\r' => comment = false,
                b'#' => comment = true,
                byte if byte.is_ascii_whitespace() || comment => {}
                _ => break,
            }
            self.at += 1;
        }
        let rest = &self.bytes[self.at..];
        let end = rest
            .iter()
            .position(|byte| byte.is_ascii_whitespace() || *byte == b'#');
        let token = &rest[..end.unwrap_or(rest.len())];
        self.at += token.len();
        let text = String::from_utf8_lossy(token);
        let digits = token.iter().all(u8::is_ascii_digit);
        Some(match text.parse() {
            Ok(number) if digits => Ok(number),
            Err(_) if digits => Err(ImageFileError::Format(format!(
                "`{}…` is too large",
                shortened(&text)
            ))),
            _ => Err(ImageFileError::Format(format!(
                "`{}` is not a number",
                shortened(&text)
            ))),
        })
    }
}

/// At most the first few characters of what should have been a number.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 12;
    text.chars()
        .take(LONGEST)
        .flat_map(char::escape_default)
        .collect()
}
