//! Sums of texels.

use glam::{DVec2, DVec3};

use super::fetches::note;
use super::{Texels, Texture};
use crate::math::Rgb;

/// The sums of all texels to the left of and below each corner of a texel (Crow 1984, "Summed-Area Tables
/// for Texture Mapping").
///
/// Sums of channels are whole numbers below 2⁴³, which a double holds exactly.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sums {
    /// The texture's sides in texels.
    sides: DVec2,
    /// Sums in a row: one more than texels.
    stride: usize,
    /// Row by row from the bottom.
    sums: Vec<DVec3>,
    /// What a channel is divided by.
    unit: f64,
}

impl Sums {
    #[expect(clippy::cast_precision_loss, reason = "sides are short")]
    pub(super) fn new(texels: &Texels, unit: f64) -> Self {
        let Texels { width, height, .. } = *texels;
        let stride = width + 1;
        let mut sums = vec![DVec3::ZERO; stride * (height + 1)];
        // Images are stored from the top.
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

    /// The sides of the texture, after which it is repeated.
    pub(super) fn sides(&self) -> DVec2 {
        self.sides
    }

    /// The intensity that a mean of channels stands for.
    pub(super) fn color(&self, mean: DVec3) -> Rgb {
        // What rounding can add to black and white is not seen.
        let channels = mean / self.unit;
        Rgb::from(channels.clamp(DVec3::ZERO, DVec3::ONE))
    }

    /// The channels summed up over the strip from 0 to `right` and from `bottom` to `top`, in texels;
    /// parts of texels count as such, and the texture is repeated. No place is below zero, but for
    /// rounding.
    pub(super) fn strip(&self, right: f64, bottom: f64, top: f64) -> DVec3 {
        note(1);
        let right = Place::new(right, self.sides.x);
        let [bottom, top] = [bottom, top].map(|place| Place::new(place, self.sides.y));
        self.corner(&right, &top) - self.corner(&right, &bottom)
    }

    /// The channels summed up from 0 to the place's x, over the row of texels that the place lies in.
    #[inline]
    pub(super) fn row(&self, place: DVec2) -> DVec3 {
        note(1);
        let (right, row) = (
            Place::new(place.x, self.sides.x),
            Place::new(place.y, self.sides.y),
        );
        self.below(&right, row.cell + 1) - self.below(&right, row.cell)
    }

    /// The sum over the rectangle from the origin to this corner.
    fn corner(&self, x: &Place, y: &Place) -> DVec3 {
        let low = self.below(x, y.cell);
        let sum = low + (self.below(x, y.cell + 1) - low) * y.share;
        if y.whole == 0.0 {
            return sum;
        }
        sum + self.below(x, self.sums.len() / self.stride - 1) * y.whole
    }

    /// The sum over so many rows from the bottom, from 0 to a place along them.
    #[inline]
    fn below(&self, x: &Place, rows: usize) -> DVec3 {
        let row = &self.sums[rows * self.stride..][..self.stride];
        let left = row[x.cell];
        left + (row[x.cell + 1] - left) * x.share + row[self.stride - 1] * x.whole
    }
}

/// A place along one side of a texture that is repeated.
#[derive(Debug)]
struct Place {
    /// How many whole textures lie before it.
    whole: f64,
    /// The texel in which it lies.
    cell: usize,
    /// How far it lies in there.
    share: f64,
}

impl Place {
    #[inline]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "places are far below 2^53; what rounding put below zero is in the first texel"
    )]
    fn new(place: f64, side: f64) -> Self {
        let whole = (place / side) as u64 as f64;
        let inside = place - whole * side;
        let cell = (inside as usize).min(side as usize - 1);
        Self {
            whole,
            cell,
            share: inside - cell as f64,
        }
    }
}

impl Texture {
    /// The sums of texels, made when they are first asked for.
    pub(super) fn sums(&self) -> &Sums {
        self.sums.get_or_init(|| Sums::new(&self.texels, self.unit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_the_texels_and_go_on() {
        let texels = Texels {
            width: 3,
            height: 2,
            channels: [1, 2, 3, 4, 5, 6].map(|red| [red, 0, 1]).to_vec(),
            deep: false,
        };
        let sums = Sums::new(&texels, 255.0);
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
