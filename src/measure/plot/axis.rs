//! Logarithmic axes.

/// A logarithmic axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axis {
    /// Lower end; above zero, or zero if only zeros are shown.
    pub(super) least: f64,
    /// Upper end; above the lower one, or zero too.
    pub(super) most: f64,
}

impl Axis {
    /// An axis around the numbers above zero; only a zero if there are none.
    pub(super) fn around(numbers: impl Iterator<Item = f64>) -> Self {
        let positive = numbers.filter(|number| *number > 0.0);
        let (least, most) = positive.fold((f64::INFINITY, 0.0_f64), |(least, most), number| {
            (least.min(number), most.max(number))
        });
        if least > most {
            return Self {
                least: 0.0,
                most: 0.0,
            };
        }
        Self {
            least: least / 1.4,
            most: most * 1.4,
        }
    }

    /// True if only zero is on it.
    pub(super) fn is_zero(self) -> bool {
        self.most == 0.0
    }

    /// Place of a number from 0 to 1; smaller numbers are at the lower end.
    pub(super) fn share(self, number: f64) -> f64 {
        if self.is_zero() {
            return 0.0;
        }
        let [least, most, number] =
            [self.least, self.most, number.max(self.least)].map(libm::log10);
        ((number - least) / (most - least)).clamp(0.0, 1.0)
    }

    /// Round numbers on it: 1, 2 and 5 times powers of ten; on longer axes powers alone, then every
    /// third or sixth of them.
    pub(super) fn marks(self) -> Vec<f64> {
        if self.is_zero() {
            return vec![0.0];
        }
        let decades = libm::log10(self.most / self.least);
        let (steps, every): (&[f64], usize) = match decades {
            short if short < 2.5 => (&[1.0, 2.0, 5.0], 1),
            long if long < 8.0 => (&[1.0], 1),
            long if long < 16.0 => (&[1.0], 3),
            _ => (&[1.0], 6),
        };
        let marks = (-30..=30).step_by(every).flat_map(|power| {
            let power = libm::pow(10.0, f64::from(power));
            steps.iter().map(move |step| step * power)
        });
        marks
            .filter(|mark| (self.least..=self.most).contains(mark))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_factors_are_equally_far_apart() {
        let axis = Axis::around([1.4, 0.0, 100.0 / 1.4].into_iter());
        assert!((axis.least - 1.0).abs() < 1e-12 && (axis.most - 100.0).abs() < 1e-9);
        assert!((axis.share(10.0) - 0.5).abs() < 1e-9);
        assert_eq!([0.0, 1e-9, 1e9].map(|it| axis.share(it)), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn an_axis_of_nothing_above_zero_is_a_zero() {
        for numbers in [[].as_slice(), &[0.0, 0.0]] {
            let axis = Axis::around(numbers.iter().copied());
            assert_eq!(axis.marks(), [0.0]);
            assert_eq!(axis.share(0.0), 0.0);
        }
    }

    #[test]
    fn marks_are_neither_few_nor_many() {
        for most in [3.0, 50.0, 1e3, 1e6, 1e20] {
            let marks = Axis { least: 1.0, most }.marks();
            assert!((2..=10).contains(&marks.len()), "{most}: {marks:?}");
        }
    }
}
