//! Summed-area tables.

use glam::{DVec2, DVec3};

use super::Texels;
use super::fetches::add_fetches;
use crate::math::Rgb;

/// For each texel corner, the sum of the texels to the left of it and below it.
///
/// Source: Crow 1984, "Summed-Area Tables for Texture Mapping". Sums of channels are whole numbers
/// below 2⁴³, so doubles hold them exactly.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SummedAreaTable {
    /// Width and height of the texture in texels.
    sides: DVec2,
    /// Sums in a row: the texels in a row plus one.
    stride: usize,
    /// Row by row from the bottom.
    sums: Vec<DVec3>,
    /// The channel value of intensity 1.
    unit: f64,
}

impl SummedAreaTable {
    #[expect(clippy::cast_precision_loss, reason = "sides are short")]
    pub(super) fn new(texels: &Texels, unit: f64) -> Self {
        let Texels { width, height, .. } = *texels;
        let stride = width + 1;
        let mut sums = vec![DVec3::ZERO; stride * (height + 1)];
        // Texels are stored from the top.
        for (row, channels) in texels.channels.chunks_exact(width).rev().enumerate() {
            let mut sum = DVec3::ZERO;
            for (column, channels) in channels.iter().enumerate() {
                sum += DVec3::from_array(channels.map(f64::from));
                let below = sums[row * stride + column + 1];
                sums[(row + 1) * stride + column + 1] = below + sum;
            }
        }
        Self {
            sides: DVec2::new(width as f64, height as f64),
            stride,
            sums,
            unit,
        }
    }

    /// Width and height of the texture in texels, the periods of its repetition.
    pub(super) fn sides(&self) -> DVec2 {
        self.sides
    }

    /// The colour of mean channels, clamped to remove rounding beyond black and white.
    pub(super) fn color(&self, mean: DVec3) -> Rgb {
        let channels = mean / self.unit;
        Rgb::from(channels.clamp(DVec3::ZERO, DVec3::ONE))
    }

    /// The sum over x from 0 to `right` and y from `bottom` to `top`, in texels.
    ///
    /// The texture repeats, and a part of a texel counts by its area. Coordinates are not
    /// negative, except by rounding.
    pub(super) fn strip(&self, right: f64, bottom: f64, top: f64) -> DVec3 {
        add_fetches(1);
        let right = Coordinate::new(right, self.sides.x);
        let [bottom, top] = [bottom, top].map(|y| Coordinate::new(y, self.sides.y));
        self.corner(&right, &top) - self.corner(&right, &bottom)
    }

    /// The sum over x from 0 to that of a position, in the position's row of texels.
    #[inline]
    pub(super) fn row(&self, position: DVec2) -> DVec3 {
        add_fetches(1);
        let right = Coordinate::new(position.x, self.sides.x);
        let row = Coordinate::new(position.y, self.sides.y).texel;
        self.below(&right, row + 1) - self.below(&right, row)
    }

    /// The sum over the rectangle from the origin to a corner.
    fn corner(&self, x: &Coordinate, y: &Coordinate) -> DVec3 {
        let low = self.below(x, y.texel);
        let sum = low + (self.below(x, y.texel + 1) - low) * y.fraction;
        if y.periods == 0.0 {
            return sum;
        }
        sum + self.below(x, self.sums.len() / self.stride - 1) * y.periods
    }

    /// The sum over a number of rows from the bottom, from 0 to a coordinate in x.
    #[inline]
    fn below(&self, x: &Coordinate, rows: usize) -> DVec3 {
        let row = &self.sums[rows * self.stride..][..self.stride];
        let left = row[x.texel];
        left + (row[x.texel + 1] - left) * x.fraction + row[self.stride - 1] * x.periods
    }
}

/// A coordinate along one side of a repeated texture.
#[derive(Debug)]
struct Coordinate {
    /// Whole textures before it.
    periods: f64,
    /// Index of its texel.
    texel: usize,
    /// Its position in the texel, from 0 to 1.
    fraction: f64,
}

impl Coordinate {
    #[inline]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "coordinates are far below 2^53; those below zero by rounding saturate to 0"
    )]
    fn new(coordinate: f64, side: f64) -> Self {
        let periods = (coordinate / side) as u64 as f64;
        let inside = coordinate - periods * side;
        let texel = (inside as usize).min(side as usize - 1);
        Self {
            periods,
            texel,
            fraction: inside - texel as f64,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_equal_those_of_the_texels_and_repeat() {
        let texels = Texels {
            width: 3,
            height: 2,
            channels: [1, 2, 3, 4, 5, 6].map(|red| [red, 0, 1]).to_vec(),
            deep: false,
        };
        let sums = SummedAreaTable::new(&texels, 255.0);
        let red = |x, y| sums.strip(x, 0.0, y).x;
        // The lower row is 4 5 6.
        let found = [red(1.0, 1.0), red(2.5, 1.0), red(3.0, 2.0), red(0.5, 1.5)];
        assert_eq!(found, [4.0, 12.0, 21.0, 2.25]);
        // Another period to the right, and one upwards.
        assert_eq!([red(4.0, 1.0), red(6.0, 4.0)], [19.0, 84.0]);
        assert_eq!(sums.strip(1.5, 1.0, 1.5).x, 1.0);
        assert_eq!(sums.row(DVec2::new(4.5, 3.9)).x, 6.0 + 1.0 + 1.0);
    }
}
