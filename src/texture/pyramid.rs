//! Mip pyramids.

use glam::DVec2;

use super::Wrap;
use super::bilinear::{Image, bilinear, interpolated};
use crate::math::{Rgb, Spread};

/// The images of half a texture's sides, a quarter and so on, down to one texel.
///
/// Odd sides are rounded down. Three texels then contribute to one, weighted by the part of it
/// that they cover, so all images have the same mean (Guthe and Heckbert 2005, "Non-Power-of-Two
/// Mipmapping").
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pyramid {
    /// The levels, largest first.
    levels: Vec<Level>,
}

/// An image, row by row from the bottom.
#[derive(Debug, Clone, PartialEq)]
struct Level {
    sides: [usize; 2],
    colors: Vec<Rgb>,
}

impl Level {
    /// An image of half the sides of another.
    fn half_of(image: &impl Image) -> Self {
        let sides = image.sides();
        let [width, height] = sides.map(|side| (side / 2).max(1));
        let [columns, rows] = sides.map(weights);
        let mut colors = Vec::with_capacity(width * height);
        for row in &rows {
            for column in &columns {
                let mut color = Rgb::BLACK;
                for (row, high) in row.iter().filter(|(_, weight)| *weight > 0.0) {
                    for (column, wide) in column.iter().filter(|(_, weight)| *weight > 0.0) {
                        color += image.color(*column, *row) * (high * wide);
                    }
                }
                colors.push(color);
            }
        }
        Self {
            sides: [width, height],
            colors,
        }
    }
}

impl Image for Level {
    fn sides(&self) -> [usize; 2] {
        self.sides
    }

    fn color(&self, column: usize, row: usize) -> Rgb {
        self.colors[row * self.sides[0] + column]
    }
}

/// For each texel along a halved side, three texels of the side and their weights.
#[expect(clippy::cast_precision_loss, reason = "sides are short")]
fn weights(side: usize) -> Vec<[(usize, f64); 3]> {
    let half = side / 2;
    if half == 0 {
        return vec![[(0, 1.0), (0, 0.0), (0, 0.0)]];
    }
    let weights = |number: usize| {
        let weights = if side.is_multiple_of(2) {
            [0.5, 0.5, 0.0]
        } else {
            [half - number, half, number + 1].map(|part| part as f64 / side as f64)
        };
        [0, 1, 2].map(|texel| (2 * number + texel, weights[texel]))
    };
    (0..half).map(weights).collect()
}

impl Pyramid {
    pub(super) fn new(base: &impl Image) -> Self {
        let mut levels: Vec<Level> = Vec::new();
        let mut sides = base.sides();
        while sides != [1, 1] {
            let next = match levels.last() {
                None => Level::half_of(base),
                Some(last) => Level::half_of(last),
            };
            sides = next.sides;
            levels.push(next);
        }
        Self { levels }
    }

    /// The colour at a position by trilinear interpolation.
    ///
    /// Position and `size`, the diameter of the footprint, are in texels of `base`, the image that
    /// the pyramid was made from.
    pub(super) fn at(
        &self,
        base: &impl Image,
        position: DVec2,
        size: f64,
        wraps: [Wrap; 2],
    ) -> Rgb {
        #[expect(clippy::cast_precision_loss, reason = "there are few levels")]
        let last = self.levels.len() as f64;
        // A NaN size takes the last level, which holds the mean. log2(0) is below all levels.
        let level = libm::log2(size);
        let level = if level.is_nan() {
            last
        } else {
            level.clamp(0.0, last)
        };
        let low = level.floor();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to the number of levels"
        )]
        let number = low as usize;
        let fine = self.bilinear(base, number, position, wraps);
        if level > low {
            let coarse = self.bilinear(base, number + 1, position, wraps);
            return interpolated(fine, coarse, level - low);
        }
        fine
    }

    /// The interpolated colour in `base`, level 0, or in a level of the pyramid.
    fn bilinear(&self, base: &impl Image, level: usize, position: DVec2, wraps: [Wrap; 2]) -> Rgb {
        let Some(image) = level.checked_sub(1).map(|number| &self.levels[number]) else {
            return bilinear(base, position, wraps);
        };
        let whole = base.sides();
        #[expect(clippy::cast_precision_loss, reason = "sides are short")]
        let scale = |axis: usize| image.sides[axis] as f64 / whole[axis] as f64;
        let position = position * DVec2::new(scale(0), scale(1));
        bilinear(image, position, wraps)
    }
}

/// The longer step of a footprint, which is the size for a mipmap lookup.
///
/// Graphics hardware takes its level of detail from it (Segal and Akeley, "The OpenGL Graphics
/// System").
pub(super) fn longer_step(footprint: &Spread) -> f64 {
    let [right, up] = footprint.steps.map(DVec2::length);
    right.max(up)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::{Texels, Texture};

    fn texture(width: usize, height: usize) -> Texture {
        let noise = |index: usize| u16::try_from(index * 37 % 251).expect("small");
        let channels = (0..width * height)
            .map(|index| [noise(index), noise(index + 7), noise(3 * index)])
            .collect();
        let texels = Texels {
            width,
            height,
            channels,
            deep: false,
        };
        Texture::new("noise", "n.png", "n.png".into(), texels, 255.0)
    }

    #[test]
    fn every_image_has_the_mean_of_the_texture() {
        for [width, height] in [[1, 1], [1, 9], [8, 8], [7, 5], [13, 4], [3, 100]] {
            let texture = texture(width, height);
            let pyramid = Pyramid::new(&texture);
            for image in &pyramid.levels {
                let sum = image.colors.iter().fold(Rgb::BLACK, |sum, it| sum + *it);
                let mean = sum / image.colors.len() as f64;
                let pairs = mean.channels().into_iter().zip(texture.mean().channels());
                for (found, expected) in pairs {
                    assert!((found - expected).abs() < 1e-12, "{width} {height}");
                }
            }
            assert!(pyramid.levels.last().is_none_or(|it| it.sides == [1, 1]));
        }
    }

    #[test]
    fn a_footprint_of_any_size_has_a_colour() {
        let texture = texture(7, 5);
        let pyramid = Pyramid::new(&texture);
        let at = |size| {
            let position = DVec2::new(2.5, 3.5);
            pyramid.at(&texture, position, size, [Wrap::Repeat; 2])
        };
        for size in [0.0, 0.5, 1.0] {
            assert_eq!(at(size), texture.color(2, 3));
        }
        for size in [4.0, 1e9, f64::INFINITY, f64::NAN] {
            let off = at(size).r - texture.mean().r;
            assert!(off.abs() < 1e-12, "{size}: {off}");
        }
    }
}
