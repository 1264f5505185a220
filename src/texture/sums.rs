//! Sums of texels.

use glam::{DVec2, DVec3};

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
    /// parts of texels count as such, and the texture is repeated.
    pub(super) fn strip(&self, right: f64, bottom: f64, top: f64) -> DVec3 {
        self.corner(right, top) - self.corner(right, bottom)
    }

    /// The sum over the rectangle from the origin to this corner.
    fn corner(&self, x: f64, y: f64) -> DVec3 {
        let whole = DVec2::new((x / self.sides.x).floor(), (y / self.sides.y).floor());
        let inside = DVec2::new(x, y) - whole * self.sides;
        let mut sum = self.within(inside);
        if whole.x != 0.0 {
            sum += self.within(DVec2::new(self.sides.x, inside.y)) * whole.x;
        }
        if whole.y != 0.0 {
            let row = self.within(DVec2::new(inside.x, self.sides.y));
            sum += (row + self.total() * whole.x) * whole.y;
        }
        sum
    }

    /// The sum of all texels.
    fn total(&self) -> DVec3 {
        self.sums[self.sums.len() - 1]
    }

    /// The sum over the rectangle from the origin to a corner inside of the texture.
    fn within(&self, corner: DVec2) -> DVec3 {
        let last = self.sides - DVec2::ONE;
        let cell = corner.floor().clamp(DVec2::ZERO, last);
        let share = corner - cell;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to the texture"
        )]
        let place = cell.y as usize * self.stride + cell.x as usize;
        let below = &self.sums[place..place + 2];
        let above = &self.sums[place + self.stride..place + self.stride + 2];
        let low = below[0] + (below[1] - below[0]) * share.x;
        let high = above[0] + (above[1] - above[0]) * share.x;
        low + (high - low) * share.y
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
        let red = |x, y| sums.corner(x, y).x;
        // The lower row is 4 5 6.
        let found = [red(1.0, 1.0), red(2.5, 1.0), red(3.0, 2.0), red(0.5, 1.5)];
        assert_eq!(found, [4.0, 12.0, 21.0, 2.25]);
        // Another period to the right, and one upwards; and one to the left.
        assert_eq!([red(4.0, 1.0), red(6.0, 4.0)], [19.0, 84.0]);
        assert_eq!([red(-1.0, 1.0), red(-3.0, 2.0)], [-6.0, -21.0]);
        assert_eq!(sums.strip(1.5, 1.0, 1.5).x, 1.0);
    }
}
