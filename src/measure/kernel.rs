//! Separable filters of pictures.

use rayon::prelude::*;

/// Numbers in rows of equal length.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Plane {
    pub values: Vec<f64>,
    pub width: usize,
}

/// Weights around a value in the middle; positive ones add up to 1, negative ones to −1.
#[derive(Debug, Clone)]
pub(super) struct Kernel {
    weights: Vec<f64>,
    border: Border,
}

/// Values beyond the borders of a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Border {
    /// The outermost values.
    Same,
    Zero,
}

impl Kernel {
    /// Kernel with weights in proportion to these.
    pub(super) fn new(weights: &[f64], border: Border) -> Self {
        let sum = |sign: f64| weights.iter().map(|it| (sign * it).max(0.0)).sum::<f64>();
        let [above, below] = [1.0, -1.0].map(sum);
        let scaled = |weight: &f64| weight / if *weight < 0.0 { below } else { above };
        Self {
            weights: weights.iter().map(scaled).collect(),
            border,
        }
    }

    /// Filters the rows of a plane.
    pub(super) fn across(&self, plane: &Plane) -> Plane {
        let reach = self.weights.len() / 2;
        plane.mapped(|row, sums| {
            let row = plane.row(row);
            let [first, last] = match self.border {
                Border::Same => [row[0], row[row.len() - 1]],
                Border::Zero => [0.0; 2],
            };
            let padded = [&vec![first; reach], row, &vec![last; reach]].concat();
            let shifted: Vec<_> = padded.windows(row.len()).collect();
            self.add_up(&shifted, sums);
        })
    }

    /// Filters the columns of a plane.
    pub(super) fn down(&self, plane: &Plane) -> Plane {
        let (reach, zeros) = (self.weights.len() / 2, vec![0.0; plane.width]);
        let last = (plane.values.len() / plane.width.max(1)).saturating_sub(1);
        plane.mapped(|row, sums| {
            let near = (row..row + self.weights.len()).map(|at| {
                let is_inside = (reach..=reach + last).contains(&at);
                match self.border {
                    Border::Zero if !is_inside => &zeros,
                    _ => plane.row(at.saturating_sub(reach).min(last)),
                }
            });
            self.add_up(&near.collect::<Vec<_>>(), sums);
        })
    }

    /// Adds up weighted rows, one for each weight.
    fn add_up(&self, rows: &[&[f64]], sums: &mut [f64]) {
        /// Sums that fit in the registers of a processor.
        const BLOCK: usize = 16;
        let (blocks, rest) = sums.as_chunks_mut::<BLOCK>();
        let done = BLOCK * blocks.len();
        for (number, sums) in blocks.iter_mut().enumerate() {
            let mut block = [0.0; BLOCK];
            for (weight, row) in self.weights.iter().zip(rows) {
                let row = &row[BLOCK * number..][..BLOCK];
                for (sum, value) in block.iter_mut().zip(row) {
                    *sum += weight * value;
                }
            }
            *sums = block;
        }
        for (at, sum) in rest.iter_mut().enumerate() {
            let products = self.weights.iter().zip(rows);
            *sum = products.map(|(weight, row)| weight * row[done + at]).sum();
        }
    }
}

impl Plane {
    fn row(&self, row: usize) -> &[f64] {
        &self.values[row * self.width..][..self.width]
    }

    /// A plane of the same size with rows filled in parallel.
    fn mapped(&self, fill: impl Fn(usize, &mut [f64]) + Sync) -> Self {
        let mut values = vec![0.0; self.values.len()];
        let rows = values.par_chunks_mut(self.width.max(1)).enumerate();
        rows.for_each(|(row, values)| fill(row, values));
        Self {
            values,
            width: self.width,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plane with 35 columns, two blocks and a rest, and with 7 rows.
    fn plane(value: impl Fn(usize, usize) -> f64) -> Plane {
        let places = (0..7).flat_map(|row| (0..35).map(move |column| (column, row)));
        Plane {
            values: places.map(|(column, row)| value(column, row)).collect(),
            width: 35,
        }
    }

    #[test]
    fn weights_are_scaled_by_sign() {
        let kernel = Kernel::new(&[-1.0, 0.0, 6.0, 2.0, -3.0], Border::Same);
        assert_eq!(kernel.weights, [-0.25, 0.0, 0.75, 0.25, -0.75]);
    }

    #[test]
    fn each_value_is_the_weighted_sum_of_those_beside_it() {
        let number = |column: usize, row: usize| {
            let number = (column * column * 7 + row * row * 13) % 31;
            #[expect(clippy::cast_precision_loss, reason = "below 31")]
            let number = number as f64;
            number
        };
        let kernel = Kernel::new(&[1.0, 2.0, 5.0], Border::Same);
        let [across, down] = [Kernel::across, Kernel::down].map(|way| way(&kernel, &plane(number)));
        let sum = |[one, two, three]: [f64; 3]| 0.125 * one + 0.25 * two + 0.625 * three;
        let expected = plane(|column, row| {
            let columns = [column.saturating_sub(1), column, (column + 1).min(34)];
            sum(columns.map(|column| number(column, row)))
        });
        assert_eq!(across, expected);
        let expected = plane(|column, row| {
            let rows = [row.saturating_sub(1), row, (row + 1).min(6)];
            sum(rows.map(|row| number(column, row)))
        });
        assert_eq!(down, expected);
    }

    #[test]
    fn beyond_a_border_are_zeros_if_asked_for() {
        let kernel = Kernel::new(&[1.0, 2.0, 1.0], Border::Zero);
        let flat = plane(|_, _| 8.0);
        let expected = plane(|column, _| if column % 34 == 0 { 6.0 } else { 8.0 });
        assert_eq!(kernel.across(&flat), expected);
        let expected = plane(|_, row| if row % 6 == 0 { 6.0 } else { 8.0 });
        assert_eq!(kernel.down(&flat), expected);
    }
}
