//! Smaller and smaller images of a texture.

use glam::DVec2;

use super::bilinear::{between, bilinear};
use super::fetches::note;
use super::{Texels, Texture, Wrap};
use crate::math::{Rgb, Spread};

/// A texture's images of half its sides, a quarter and so on, down to one texel.
///
/// Sides are rounded down. Where one is odd, three texels go into one, each with the share of it that
/// it covers (Guthe and Heckbert 2005, "Non-Power-of-Two Mipmapping"), so every image has the
/// same mean.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pyramid {
    /// From the largest on.
    images: Vec<Image>,
}

/// An image, row by row from the bottom.
#[derive(Debug, Clone, PartialEq)]
struct Image {
    sides: [usize; 2],
    colors: Vec<Rgb>,
}

impl Image {
    /// An image of half the sides, of what `texel` says.
    fn halved(sides: [usize; 2], texel: impl Fn(usize, usize) -> Rgb) -> Self {
        let [width, height] = sides.map(|side| (side / 2).max(1));
        let [columns, rows] = sides.map(shares);
        let mut colors = Vec::with_capacity(width * height);
        for row in &rows {
            for column in &columns {
                let mut color = Rgb::BLACK;
                for (row, high) in row.iter().filter(|(_, share)| *share > 0.0) {
                    for (column, wide) in column.iter().filter(|(_, share)| *share > 0.0) {
                        color += texel(*column, *row) * (high * wide);
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

    fn texel(&self, column: usize, row: usize) -> Rgb {
        self.colors[row * self.sides[0] + column]
    }
}

/// For each texel along a halved side, up to three of the side's own and their shares.
#[expect(clippy::cast_precision_loss, reason = "sides are short")]
fn shares(side: usize) -> Vec<[(usize, f64); 3]> {
    let half = side / 2;
    if half == 0 {
        return vec![[(0, 1.0), (0, 0.0), (0, 0.0)]];
    }
    let shares = |number: usize| {
        let weights = if side.is_multiple_of(2) {
            [0.5, 0.5, 0.0]
        } else {
            [half - number, half, number + 1].map(|part| part as f64 / side as f64)
        };
        let texel = |place: usize| (2 * number + place, weights[place]);
        [texel(0), texel(1), texel(2)]
    };
    (0..half).map(shares).collect()
}

impl Pyramid {
    pub(super) fn new(texture: &Texture) -> Self {
        let Texels { width, height, .. } = texture.texels;
        let mut images: Vec<Image> = Vec::new();
        let mut sides = [width, height];
        while sides != [1, 1] {
            let next = match images.last() {
                None => Image::halved(sides, |column, row| texture.uncounted(column, row)),
                Some(last) => Image::halved(sides, |column, row| last.texel(column, row)),
            };
            sides = next.sides;
            images.push(next);
        }
        Self { images }
    }

    /// The colour at a place in texels of the texture, of things as large as this many texels: between
    /// the images whose texels are next to that.
    pub(super) fn at(&self, texture: &Texture, place: DVec2, size: f64, wraps: [Wrap; 2]) -> Rgb {
        #[expect(clippy::cast_precision_loss, reason = "there are few images")]
        let last = self.images.len() as f64;
        // Of a size that no number can tell, there is only the mean; log2(0) is below all levels.
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
            reason = "from 0 to the number of images"
        )]
        let number = low as usize;
        let fine = self.bilinear(texture, number, place, wraps);
        if level > low {
            let coarse = self.bilinear(texture, number + 1, place, wraps);
            return between(fine, coarse, level - low);
        }
        fine
    }

    /// The colour in the texture itself, or in one of the images, counted from 1.
    fn bilinear(&self, texture: &Texture, level: usize, place: DVec2, wraps: [Wrap; 2]) -> Rgb {
        let whole = [texture.texels.width, texture.texels.height];
        let Some(image) = level.checked_sub(1).map(|number| &self.images[number]) else {
            return bilinear(place, whole, wraps, |column, row| {
                texture.texel_upwards(column, row)
            });
        };
        #[expect(clippy::cast_precision_loss, reason = "sides are short")]
        let scale = |axis: usize| image.sides[axis] as f64 / whole[axis] as f64;
        let place = place * DVec2::new(scale(0), scale(1));
        note(4);
        bilinear(place, image.sides, wraps, |column, row| {
            image.texel(column, row)
        })
    }
}

/// What is seen with as many texels as the longer step of the pixel has: the level of detail that
/// graphics hardware has (Segal and Akeley, "The OpenGL Graphics System").
pub(super) fn longer_step(spread: &Spread) -> f64 {
    let [right, up] = spread.steps.map(DVec2::length);
    right.max(up)
}

#[cfg(test)]
mod tests {
    use super::*;

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
            for image in &pyramid.images {
                let sum = image.colors.iter().fold(Rgb::BLACK, |sum, it| sum + *it);
                let mean = sum / image.colors.len() as f64;
                let pairs = mean.channels().into_iter().zip(texture.mean().channels());
                for (found, expected) in pairs {
                    assert!((found - expected).abs() < 1e-12, "{width} {height}");
                }
            }
            assert!(pyramid.images.last().is_none_or(|it| it.sides == [1, 1]));
        }
    }

    #[test]
    fn a_pixel_of_any_size_sees_a_colour() {
        let texture = texture(7, 5);
        let pyramid = Pyramid::new(&texture);
        let at = |size| {
            let place = DVec2::new(2.5, 3.5);
            pyramid.at(&texture, place, size, [Wrap::Repeat; 2])
        };
        for size in [0.0, 0.5, 1.0] {
            assert_eq!(at(size), texture.texel_upwards(2, 3));
        }
        for size in [4.0, 1e9, f64::INFINITY, f64::NAN] {
            let off = at(size).r - texture.mean().r;
            assert!(off.abs() < 1e-12, "{size}: {off}");
        }
    }
}
