//! Bilinear interpolation.

use glam::DVec2;

use super::Wrap;
use super::fetches::add_fetches;
use crate::math::Rgb;

/// An image whose texels count from the lower-left one.
pub(super) trait Image {
    /// Width and height in texels.
    fn sides(&self) -> [usize; 2];

    /// The colour of a texel, which does not count as a fetch.
    fn color(&self, column: usize, row: usize) -> Rgb;
}

/// The colour at a position between the four nearest texel centres.
///
/// The position is in texels from the lower-left corner of the image.
pub(super) fn bilinear(image: &impl Image, position: DVec2, wraps: [Wrap; 2]) -> Rgb {
    add_fetches(4);
    // The centre of texel k is at k + ½.
    let from_center = position - DVec2::splat(0.5);
    let low = from_center.floor();
    let fraction = from_center - low;
    let sides = image.sides();
    let index = |axis: usize, position: f64| wraps[axis].index(position, sides[axis]);
    let columns = [low.x, low.x + 1.0].map(|column| index(0, column));
    let rows = [low.y, low.y + 1.0].map(|row| index(1, row));
    let [below, above] = rows.map(|row| {
        let [left, right] = columns.map(|column| image.color(column, row));
        interpolated(left, right, fraction.x)
    });
    interpolated(below, above, fraction.y)
}

/// Linear interpolation; exact between equal colours.
pub(super) fn interpolated(from: Rgb, to: Rgb, fraction: f64) -> Rgb {
    from + (to + from * -1.0) * fraction
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three texels in a row, numbered by their red.
    struct Row;

    impl Image for Row {
        fn sides(&self) -> [usize; 2] {
            [3, 1]
        }

        fn color(&self, column: usize, _: usize) -> Rgb {
            Rgb::new([1.0, 2.0, 4.0][column], 0.0, 0.0)
        }
    }

    fn red(x: f64, wrap: Wrap) -> f64 {
        bilinear(&Row, DVec2::new(x, 0.5), [wrap; 2]).r
    }

    #[test]
    fn centers_keep_their_colors_and_borders_have_the_mean() {
        let found = [0.5, 1.0, 1.5, 2.0, 2.5].map(|x| red(x, Wrap::Clamp));
        assert_eq!(found, [1.0, 1.5, 2.0, 3.0, 4.0]);
    }

    #[test]
    fn clamp_continues_the_border_and_repeat_the_image() {
        let outside = [-7.0, 0.0, 3.0, 9.0];
        let found = outside.map(|x| red(x, Wrap::Clamp));
        assert_eq!(found, [1.0, 1.0, 4.0, 4.0]);
        let found = outside.map(|x| red(x, Wrap::Repeat));
        assert_eq!(found, [3.0, 2.5, 2.5, 2.5]);
    }
}
