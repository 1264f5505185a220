//! Pictures as their files hold them.

use std::io::{self, Write};

use rayon::prelude::*;

use super::{Encoding, Film, Format, Notes, blank, pfm, png, ppm};
use crate::math::Rgb;

/// A picture in the numbers of a file format. They take less room than those of a [`Film`], so what
/// is drawn only to be written need not be kept in full.
#[derive(Debug)]
pub struct EncodedImage {
    /// The width in pixels.
    pub(super) width: usize,
    /// The height in pixels.
    pub(super) height: usize,
    format: Format,
    /// How intensities have become the format's numbers.
    pub(super) encoding: Encoding,
    /// Row by row from the top.
    bytes: Vec<u8>,
    /// For each row the columns with an infinite or not-a-number channel.
    odd: Vec<Vec<usize>>,
}

/// A row of a print.
#[derive(Debug)]
pub struct EncodedRow<'a> {
    format: Format,
    encoding: Encoding,
    bytes: &'a mut [u8],
    odd: &'a mut Vec<usize>,
}

impl EncodedImage {
    /// A picture of this width and height, black in every format; `None` if there is no memory for
    /// it.
    #[must_use]
    pub fn new([width, height]: [usize; 2], format: Format, encoding: Encoding) -> Option<Self> {
        Some(Self {
            width,
            height,
            format,
            encoding,
            bytes: blank([width, height, format.pixel_size()], 0)?,
            odd: vec![Vec::new(); height],
        })
    }

    /// The print of a film; `None` if there is no memory for it.
    #[must_use]
    pub fn of(film: &Film, format: Format, encoding: Encoding) -> Option<Self> {
        let mut print = Self::new([film.width(), film.height()], format, encoding)?;
        let rows = film.pixels().par_chunks(film.width());
        print.rows().zip(rows).for_each(|(mut row, colors)| {
            row.encode_row(colors);
        });
        Some(print)
    }

    /// The numbers of the format, row by row from the top.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The rows from the top.
    pub fn rows(&mut self) -> impl IndexedParallelIterator<Item = EncodedRow<'_>> {
        let (format, encoding) = (self.format, self.encoding);
        let rows = self.bytes.par_chunks_mut(self.width * format.pixel_size());
        rows.zip(&mut self.odd).map(move |(bytes, odd)| EncodedRow {
            format,
            encoding,
            bytes,
            odd,
        })
    }

    /// Column and row of every pixel that got an infinite or not-a-number channel.
    pub fn non_finite(&self) -> impl Iterator<Item = (usize, usize)> {
        let rows = self.odd.iter().enumerate();
        rows.flat_map(|(row, odd)| odd.iter().map(move |column| (*column, row)))
    }

    /// Writes the picture's file.
    ///
    /// # Errors
    /// Whatever the writer fails with.
    pub fn write(&self, out: &mut dyn Write, notes: &Notes) -> io::Result<()> {
        match self.format {
            Format::Png8 => png::write(self, out, ::png::BitDepth::Eight, notes),
            Format::Png16 => png::write(self, out, ::png::BitDepth::Sixteen, notes),
            Format::Ppm => ppm::write(self, out),
            Format::Pfm => pfm::write(self, out),
        }
    }
}

impl EncodedRow<'_> {
    /// Gives the row's pixels these colours, from the left.
    pub fn encode_row(&mut self, colors: &[Rgb]) {
        let colored = colors.iter().enumerate();
        let odd = colored.filter(|(_, color)| !color.is_finite());
        self.odd.extend(odd.map(|(column, _)| column));
        self.format.store(colors, self.encoding, self.bytes);
    }
}
