//! Rectangles of pixels.

use crate::language::ValueError;

/// A rectangle of at least one pixel.
///
/// Columns and rows count from 0 at the top left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Region {
    /// The first column.
    pub left: usize,
    /// The first row.
    pub top: usize,
    /// The number of columns.
    pub width: usize,
    /// The number of rows.
    pub height: usize,
}

impl Region {
    /// All pixels of a picture of a size.
    #[must_use]
    pub fn whole([width, height]: [u32; 2]) -> Self {
        Self {
            left: 0,
            top: 0,
            width: width as usize,
            height: height as usize,
        }
    }

    /// The pixels from a first column and row to an exclusive last column and row.
    ///
    /// # Errors
    /// Returns an error if the region is empty.
    pub fn between([left, top]: [u32; 2], [right, bottom]: [u32; 2]) -> Result<Self, ValueError> {
        if left >= right || top >= bottom {
            return Err(ValueError::new(
                "image",
                format!("the region from {left},{top} to {right},{bottom} has no pixels"),
                "the last column and row are exclusive: give larger ones",
            ));
        }
        Ok(Self {
            left: left as usize,
            top: top as usize,
            width: (right - left) as usize,
            height: (bottom - top) as usize,
        })
    }

    /// A pixel and its neighbours within a picture of a size.
    #[must_use]
    pub fn around([column, row]: [usize; 2], [width, height]: [u32; 2]) -> Self {
        let pixel = Self {
            left: column,
            top: row,
            width: 1,
            height: 1,
        };
        pixel.grown_within([width, height])
    }

    /// The region grown by one pixel on each side, within a picture of a size.
    #[must_use]
    pub fn grown_within(self, [width, height]: [u32; 2]) -> Self {
        let [left, top, right, bottom] = self.bounds();
        let (left, right) = (left.saturating_sub(1), (right + 1).min(width as usize));
        let (top, bottom) = (top.saturating_sub(1), (bottom + 1).min(height as usize));
        Self {
            left,
            top,
            width: right - left,
            height: bottom - top,
        }
    }

    /// Column and row of each pixel, row by row.
    pub fn pixels(self) -> impl Iterator<Item = [usize; 2]> {
        let [left, top, right, bottom] = self.bounds();
        (top..bottom).flat_map(move |row| (left..right).map(move |column| [column, row]))
    }

    /// First column and row, and exclusive last column and row: `0,0,80,60`.
    #[must_use]
    pub fn bounds(&self) -> [usize; 4] {
        let Self {
            left,
            top,
            width,
            height,
        } = *self;
        [left, top, left + width, top + height]
    }

    /// Checks that the region lies in a picture of a size.
    ///
    /// # Errors
    /// Returns an error if it does not.
    pub fn check_within(&self, [width, height]: [u32; 2]) -> Result<(), ValueError> {
        let [left, top, right, bottom] = self.bounds();
        if right <= width as usize && bottom <= height as usize {
            return Ok(());
        }
        Err(ValueError::new(
            "image",
            format!(
                "the crop {left},{top},{right},{bottom} reaches beyond the picture of {width} by \
                 {height} pixels"
            ),
            format!("give one within 0,0,{width},{height}"),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_region_has_pixels_and_lies_in_the_picture() {
        let region = Region::between([2, 1], [4, 6]).expect("2 by 5 pixels");
        assert_eq!((region.width, region.height), (2, 5));
        assert_eq!(region.bounds(), [2, 1, 4, 6]);
        assert!(region.check_within([4, 6]).is_ok());
        assert!(region.check_within([3, 6]).is_err());
        assert!(region.check_within([4, 5]).is_err());
        assert!(Region::between([2, 1], [2, 6]).is_err());
        assert!(Region::between([2, 6], [4, 1]).is_err());
    }
}
