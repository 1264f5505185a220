//! Evenly spaced lines: the borders of texels and tiles.

use dashu_ratio::RBig;

use super::Decisions;
use super::error_bounds::{CELL, GRID_LINE};

/// Lines at all whole multiples of a pitch.
///
/// Line `k` lies at the double nearest to `k` times the decimal in the scene. A surface that begins
/// there has its corner at the same number. Ten tiles of 0.1 end at 1, and the third begins at 0.3
/// although the double 3 × 0.1 is larger.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    pitch: f64,
    /// The exact pitch less the rounded one.
    rest: f64,
    /// Cells per unit; not-a-number if it is not a normal double.
    density: f64,
}

impl Grid {
    /// Lines at a pitch above zero.
    #[must_use]
    pub fn new(pitch: &RBig) -> Self {
        let rounded = pitch.to_f64().value();
        let taken = RBig::try_from(rounded).unwrap_or_default();
        let density = rounded.recip();
        Self {
            density: if density.is_normal() {
                density
            } else {
                f64::NAN
            },
            pitch: rounded,
            rest: (pitch - taken).to_f64().value(),
        }
    }

    /// The rounded distance between two lines.
    #[must_use]
    pub fn pitch(&self) -> f64 {
        self.pitch
    }

    /// The number of cells that a double can count; the cells beyond are unknown.
    pub const MOST_CELLS: f64 = 9_007_199_254_740_992.0; // 2^53

    /// The number of a point's cell: `k` from line `k` up to, not on, line `k + 1`.
    #[must_use]
    pub fn cell(&self, place: f64) -> f64 {
        if let Some(cell) = self.certain_cell(place, 0.0) {
            return cell;
        }
        let nearest = (place / self.pitch).round();
        if place >= self.line(nearest) {
            nearest
        } else {
            nearest - 1.0
        }
    }

    /// The number of the cell of a point, if its error bound leaves no other.
    #[must_use]
    #[inline]
    pub fn certain_cell(&self, place: f64, error: f64) -> Option<f64> {
        let estimate = place * self.density;
        let below = floor(estimate);
        let into = estimate - below;
        // One rounding each of the product, the density, the pitch and the line, and that of the
        // scaled error bound.
        let bound = (error * self.density) * (1.0 + CELL) + CELL * estimate.abs();
        (into > bound && 1.0 - into > bound).then_some(below)
    }

    /// The point, moved as little as possible to the exact side of the nearest line.
    ///
    /// `error` bounds the distance of the point from the `exact` one, which is computed only if the
    /// bound reaches a line.
    #[must_use]
    #[inline]
    pub fn settled(&self, place: f64, error: f64, exact: impl FnOnce() -> RBig) -> f64 {
        let estimate = place / self.pitch;
        let into = (estimate - estimate.round()).abs();
        if into * self.pitch > error + GRID_LINE * place.abs() {
            return place;
        }
        self.settled_exactly(&exact())
    }

    #[cold]
    fn settled_exactly(&self, exact: &RBig) -> f64 {
        let place = exact.to_f64().value();
        let nearest = (place / self.pitch).round();
        if !(place.is_finite() && nearest.abs() < Self::MOST_CELLS) {
            return place;
        }
        let line = self.line(nearest);
        let side = exact.cmp(&RBig::try_from(line).unwrap_or_default());
        Decisions::note(side.is_eq());
        if side.is_lt() {
            place.min(line.next_down())
        } else {
            place.max(line)
        }
    }

    /// The position of a line.
    fn line(&self, number: f64) -> f64 {
        // The rounding error of a product is itself a double.
        let product = number * self.pitch;
        let rest = number.mul_add(self.pitch, -product);
        product + (rest + number * self.rest)
    }
}

/// The largest whole number that is not above this one.
#[inline]
fn floor(number: f64) -> f64 {
    // Adding it to a number of this size or less rounds the fraction off, several times faster than
    // `floor` on processors as old as the target.
    const NO_FRACTION: f64 = 6_755_399_441_055_744.0; // 2^52 + 2^51
    if number.abs() <= NO_FRACTION / 3.0 {
        let whole = (number + NO_FRACTION) - NO_FRACTION;
        if whole > number { whole - 1.0 } else { whole }
    } else {
        number.floor()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::exact::decimal;

    #[test]
    fn the_lines_are_where_decimals_say() {
        for (pitch, decimals) in [("0.1", 1), ("0.01", 2), ("0.7", 1), ("1e-3", 3)] {
            let pitch: f64 = pitch.parse().expect("a number");
            let grid = Grid::new(&decimal(pitch));
            for number in -1000..=1000i32 {
                let tenths = f64::from(number) * pitch * 10f64.powi(decimals);
                let line: f64 = format!("{}e-{decimals}", tenths.round())
                    .parse()
                    .expect("a number");
                assert_eq!(grid.cell(line), f64::from(number), "{number} × {pitch}");
                assert_eq!(grid.cell(line.next_down()), f64::from(number) - 1.0);
            }
        }
    }

    #[test]
    fn a_place_in_doubt_goes_to_its_side() {
        let grid = Grid::new(&decimal(0.1));
        let on = || RBig::try_from(0.3).expect("finite");
        let below = || on() - decimal(1e-30);
        assert_eq!(grid.settled(0.3, 1e-16, below), 0.3f64.next_down());
        assert_eq!(grid.settled(0.3f64.next_down(), 1e-16, on), 0.3);
        let never = || unreachable!("not in doubt");
        assert_eq!(grid.settled(0.25, 1e-16, never), 0.25);
    }
}
