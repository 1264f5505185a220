//! A part of a picture.

use crate::language::ValueError;

/// A rectangle of pixels, at least one; columns and rows are counted from the top left, from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Region {
    /// The first column.
    pub left: usize,
    /// The first row.
    pub top: usize,
    /// How many columns.
    pub width: usize,
    /// How many rows.
    pub height: usize,
}

impl Region {
    /// A whole picture of this width and height.
    #[must_use]
    pub fn whole([width, height]: [u32; 2]) -> Self {
        Self {
            left: 0,
            top: 0,
            width: width as usize,
            height: height as usize,
        }
    }

    /// From a column and a row up to but not including others.
    ///
    /// # Errors
    /// Refuses a region without pixels.
    pub fn between([left, top]: [u32; 2], [right, bottom]: [u32; 2]) -> Result<Self, ValueError> {
        if left >= right || top >= bottom {
            return Err(ValueError::new(
                "image",
                format!(
                    "there is no pixel from {left},{top} up to but not including {right},{bottom}"
                ),
                "give the first column and row, and those behind the last",
            ));
        }
        Ok(Self {
            left: left as usize,
            top: top as usize,
            width: (right - left) as usize,
            height: (bottom - top) as usize,
        })
    }

    /// One pixel.
    #[must_use]
    pub fn pixel(column: usize, row: usize) -> Self {
        Self {
            left: column,
            top: row,
            width: 1,
            height: 1,
        }
    }

    /// A pixel and those around it, of those that a picture of this width and height has.
    #[must_use]
    pub fn around([column, row]: [usize; 2], [width, height]: [u32; 2]) -> Self {
        Self::pixel(column, row).grown_within([width, height])
    }

    /// It with the pixels around it, of those that a picture of this width and height has.
    #[must_use]
    pub fn grown_within(self, [width, height]: [u32; 2]) -> Self {
        let [left, top, right, bottom] = self.corners();
        let (first, last) = (left.saturating_sub(1), (right + 1).min(width as usize));
        let (upper, lower) = (top.saturating_sub(1), (bottom + 1).min(height as usize));
        Self {
            left: first,
            top: upper,
            width: last - first,
            height: lower - upper,
        }
    }

    /// Column and row of each of its pixels, row by row.
    pub fn places(self) -> impl Iterator<Item = [usize; 2]> {
        let [left, top, right, bottom] = self.corners();
        (top..bottom).flat_map(move |row| (left..right).map(move |column| [column, row]))
    }

    /// The first column and row, and those behind the last: `0,0,80,60`.
    #[must_use]
    pub fn corners(&self) -> [usize; 4] {
        let Self {
            left,
            top,
            width,
            height,
        } = *self;
        [left, top, left + width, top + height]
    }

    /// Whether it lies in a picture of this width and height.
    ///
    /// # Errors
    /// Refuses a region that reaches beyond it.
    pub fn check_within(&self, [width, height]: [u32; 2]) -> Result<(), ValueError> {
        let [left, top, right, bottom] = self.corners();
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
        assert_eq!(region.corners(), [2, 1, 4, 6]);
        assert!(region.check_within([4, 6]).is_ok());
        assert!(region.check_within([3, 6]).is_err());
        assert!(region.check_within([4, 5]).is_err());
        assert!(Region::between([2, 1], [2, 6]).is_err());
        assert!(Region::between([2, 6], [4, 1]).is_err());
    }
}
