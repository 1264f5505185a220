//! Between the middles of texels.

use glam::DVec2;

use super::Wrap;
use crate::math::Rgb;

/// The colour at a place between the four texels whose middles are nearest; the place is counted in
/// texels from the lower-left corner of an image with these sides, and `texel` takes columns from the
/// left and rows from the bottom.
pub(super) fn bilinear(
    place: DVec2,
    sides: [usize; 2],
    wraps: [Wrap; 2],
    texel: impl Fn(usize, usize) -> Rgb,
) -> Rgb {
    // Texel k has its middle at k + ½.
    let from = place - DVec2::splat(0.5);
    let low = from.floor();
    let share = from - low;
    let index = |axis: usize, place: f64| wraps[axis].index(place, sides[axis]);
    let columns = [low.x, low.x + 1.0].map(|column| index(0, column));
    let rows = [low.y, low.y + 1.0].map(|row| index(1, row));
    let [below, above] = rows.map(|row| {
        let [left, right] = columns.map(|column| texel(column, row));
        between(left, right, share.x)
    });
    between(below, above, share.y)
}

/// A colour on the way from one to another; one colour is exactly between itself and itself.
pub(super) fn between(from: Rgb, to: Rgb, share: f64) -> Rgb {
    from + (to + from * -1.0) * share
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row of three texels, counted by their red.
    fn row(place: f64, wrap: Wrap) -> f64 {
        let texel = |column, _| Rgb::new([1.0, 2.0, 4.0][column], 0.0, 0.0);
        bilinear(DVec2::new(place, 0.5), [3, 1], [wrap; 2], texel).r
    }

    #[test]
    fn middles_are_kept_and_borders_are_halfway() {
        let seen = [0.5, 1.0, 1.5, 2.0, 2.5].map(|place| row(place, Wrap::Clamp));
        assert_eq!(seen, [1.0, 1.5, 2.0, 3.0, 4.0]);
    }

    #[test]
    fn clamp_keeps_the_border_and_repeat_goes_on() {
        let outside = [-7.0, 0.0, 3.0, 9.0];
        let seen = outside.map(|place| row(place, Wrap::Clamp));
        assert_eq!(seen, [1.0, 1.0, 4.0, 4.0]);
        let seen = outside.map(|place| row(place, Wrap::Repeat));
        assert_eq!(seen, [3.0, 2.5, 2.5, 2.5]);
    }
}
