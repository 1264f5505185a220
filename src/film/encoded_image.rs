//! Pictures in the numbers of a file format.

use rayon::prelude::*;

use super::{Encoding, Film, Format, filled};
use crate::math::Rgb;

/// A picture in the numbers of a file format, row by row from the top.
///
/// It takes less memory than a [`Film`] of the same picture.
#[derive(Debug)]
pub struct EncodedImage {
    /// The width in pixels.
    pub(super) width: usize,
    /// The height in pixels.
    pub(super) height: usize,
    /// The file format.
    pub(super) format: Format,
    /// The map from intensities to the format's numbers.
    pub(super) encoding: Encoding,
    bytes: Vec<u8>,
    /// For each row, the columns with an infinite or NaN channel.
    non_finite: Vec<Vec<usize>>,
}

/// A row of an encoded image.
#[derive(Debug)]
pub struct EncodedRow<'a> {
    format: Format,
    encoding: Encoding,
    bytes: &'a mut [u8],
    non_finite: &'a mut Vec<usize>,
}

impl EncodedImage {
    /// A black picture of a width and a height; `None` if memory is short.
    #[must_use]
    pub fn new([width, height]: [usize; 2], format: Format, encoding: Encoding) -> Option<Self> {
        Some(Self {
            width,
            height,
            format,
            encoding,
            bytes: filled([width, height, format.pixel_size()], 0)?,
            non_finite: vec![Vec::new(); height],
        })
    }

    /// The encoded image of a film; `None` if memory is short.
    #[must_use]
    pub fn of(film: &Film, format: Format, encoding: Encoding) -> Option<Self> {
        let mut image = Self::new([film.width(), film.height()], format, encoding)?;
        let rows = image.rows().zip(film.pixels().par_chunks(film.width()));
        rows.for_each(|(mut row, colors)| row.encode_row(colors));
        Some(image)
    }

    /// The numbers of the format, row by row from the top.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The rows for writing, from the top.
    pub fn rows(&mut self) -> impl IndexedParallelIterator<Item = EncodedRow<'_>> {
        let (format, encoding) = (self.format, self.encoding);
        let rows = self.bytes.par_chunks_mut(self.width * format.pixel_size());
        let rows = rows.zip(&mut self.non_finite);
        rows.map(move |(bytes, non_finite)| EncodedRow {
            format,
            encoding,
            bytes,
            non_finite,
        })
    }

    /// Column and row of each pixel with an infinite or NaN channel.
    pub fn non_finite(&self) -> impl Iterator<Item = (usize, usize)> {
        let rows = self.non_finite.iter().enumerate();
        rows.flat_map(|(row, columns)| columns.iter().map(move |column| (*column, row)))
    }
}

impl EncodedRow<'_> {
    /// Encodes the colours of the row's pixels, from the left.
    pub fn encode_row(&mut self, colors: &[Rgb]) {
        let pixels = colors.iter().enumerate();
        let non_finite = pixels.filter(|(_, color)| !color.is_finite());
        self.non_finite.extend(non_finite.map(|(column, _)| column));
        self.format.encode(colors, self.encoding, self.bytes);
    }
}
