//! What the rays of a pixel have brought, and how right their mean is.

use crate::film::Transfer;
use crate::math::Rgb;

/// How much the error of a border between two colours is of their difference, for one ray that is as
/// likely to meet either; it falls as the count's power of -3/4. Twice the root of the mean square, as
/// measured.
pub(super) const BORDER: f64 = 0.8;

/// How many standard errors the error of a mean is: as measured on images, where it meets the target in
/// more than 99.5 % of pixels.
const SPREAD: f64 = 1.3;

/// With so many rays, their parts look alike by chance so often that the square of their standard
/// error counts twice.
const FEW: f64 = 16.0;

/// What the rays of a pixel found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Found {
    /// Images, which vary anywhere.
    Images,
    /// Things with borders between them. Images have a filter that shows each ray its share of the pixel.
    Borders,
    /// All the same, for which this number stands; each shows its share of it.
    One(u64),
}

/// What the rays of a pixel have brought.
#[derive(Debug, Clone, Copy)]
pub(super) struct SampleAccumulator {
    /// How many rays; a power of two, at least four, or one and a half times that.
    pub(super) count: u32,
    /// The sums of equally many rays that follow each other, which are spread evenly: four or six of
    /// them, and between two steps eight.
    parts: [Rgb; 8],
    /// How many of these there are.
    filled: usize,
    /// The sum of the squares of all colours.
    squares: Rgb,
    /// What colours there are.
    range: Colors,
    /// Whether an outline runs through the pixel that is not well behind all that the first rays met.
    pub(super) outlined: bool,
    /// What its rays found.
    pub(super) found: Found,
    /// Whether no filter can be off for any of them.
    pub(super) is_exact: bool,
}

/// The darkest and the brightest of each channel of some colours.
#[derive(Debug, Clone, Copy)]
pub(super) struct Colors {
    low: Rgb,
    high: Rgb,
}

/// What the first rays of a pixel and of those around it have seen.
#[derive(Debug, Clone, Copy)]
pub(super) struct Around {
    range: Colors,
    found: Found,
}

impl Around {
    /// What one pixel's rays have seen.
    pub(super) fn of(tally: &SampleAccumulator) -> Self {
        Self {
            range: tally.range,
            found: tally.found,
        }
    }

    /// What both have seen.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            range: self.range.and(other.range),
            found: match self.found {
                Found::One(_) if other.found != self.found => Found::Borders,
                found => found,
            },
        }
    }
}

impl SampleAccumulator {
    /// No rays.
    pub(super) const NOTHING: Self = Self {
        count: 0,
        parts: [Rgb::BLACK; 8],
        filled: 0,
        squares: Rgb::BLACK,
        range: Colors::NONE,
        outlined: false,
        found: Found::Images,
        is_exact: true,
    };

    /// How far its mean is from another one's in the worst channel, as it is shown.
    pub(super) fn moved_from(&self, other: &Self, transfer: Transfer) -> f64 {
        let (mean, other) = (self.mean().channels(), other.mean().channels());
        let of_channel = |channel: usize| {
            let (mean, other): (f64, f64) = (mean[channel], other[channel]);
            transfer.error(mean, (mean - other).abs())
        };
        (0..3).map(of_channel).fold(0.0, f64::max)
    }

    /// Adds what a ray brought to the part that is being filled.
    pub(super) fn add(&mut self, color: Rgb) {
        let part = &mut self.parts[self.filled];
        *part = (*part + color).saturated();
        self.squares += color * color;
        self.range = self.range.and(Colors {
            low: color,
            high: color,
        });
        self.count += 1;
    }

    /// How many rays there are in each part.
    pub(super) fn size(&self) -> u32 {
        #[expect(clippy::cast_possible_truncation, reason = "eight at most")]
        let parts = self.filled as u32;
        self.count / parts
    }

    /// Closes the part that is being filled.
    pub(super) fn close_part(&mut self) {
        self.filled += 1;
    }

    /// Puts two parts each together if there are eight.
    pub(super) fn put_together(&mut self) {
        if self.filled == self.parts.len() {
            self.filled /= 2;
            for part in 0..self.filled {
                let [first, second] = [0, 1].map(|number| self.parts[2 * part + number]);
                self.parts[part] = (first + second).saturated();
            }
            self.parts[self.filled..].fill(Rgb::BLACK);
        }
    }

    /// The mean of all colours.
    pub(super) fn mean(&self) -> Rgb {
        let sum = self
            .parts
            .iter()
            .fold(Rgb::BLACK, |sum, part| (sum + *part).saturated());
        sum / f64::from(self.count)
    }

    /// How far off the mean probably is in its worst channel, as it is shown, for all that its rays
    /// and those around can tell. What filters are off they cannot.
    pub(super) fn error(&self, around: Around, transfer: Transfer) -> f64 {
        let count = f64::from(self.count);
        let border = BORDER / (count.sqrt() * count.sqrt().sqrt());
        let mean = self.mean().channels();
        let squares = (self.squares / count).channels();
        let parts = &self.parts[..self.filled];
        let size = f64::from(self.size());
        #[expect(clippy::cast_precision_loss, reason = "eight at most")]
        let pairs = (parts.len() * (parts.len() - 1)) as f64;
        let own = self.range.width();
        let around = match around.found {
            // There are no other colours than those of its own shares.
            Found::One(_) => own,
            _ => around.range.width(),
        };
        let of_channel = |channel: usize| {
            let (own, around, mean) = (own[channel], around[channel], mean[channel]);
            // A border that cuts off a corner only is short: its error is between the difference of
            // colours and their deviation, of which the former is at least twice the latter.
            let deviation = (squares[channel] - mean * mean).max(0.0).sqrt();
            let border = border * (own * 2.0 * deviation).sqrt();
            let off = parts
                .iter()
                .map(|part| part.channels()[channel] / size - mean);
            let spread = off.map(|off| off * off).sum::<f64>() / pairs;
            let spread = spread * (1.0 + FEW / count);
            let seen = match self.found {
                Found::Images => (border * border + SPREAD * SPREAD * spread).sqrt(),
                Found::Borders => border,
                Found::One(_) => 0.0,
            };
            // What no ray has met has about the share of one ray: a colour of the pixels around,
            // or black before white if an outline promises that there is something.
            let known = if self.outlined {
                around.max(1.0)
            } else {
                around
            };
            let unmet = (known - own) / count;
            // Rays that are brighter than white hide nothing that none of them has met.
            let unmet = transfer.error(mean.min(1.0), unmet);
            transfer.error(mean, seen).max(unmet)
        };
        (0..3).map(of_channel).fold(0.0, f64::max)
    }
}

impl Colors {
    const NONE: Self = Self {
        low: Rgb::new(f64::MAX, f64::MAX, f64::MAX),
        high: Rgb::new(f64::MIN, f64::MIN, f64::MIN),
    };

    /// The darkest and the brightest of both.
    pub(super) fn and(self, other: Self) -> Self {
        let each = |choose: fn(f64, f64) -> f64, [a, b]: [Rgb; 2]| {
            Rgb::new(choose(a.r, b.r), choose(a.g, b.g), choose(a.b, b.b))
        };
        Self {
            low: each(f64::min, [self.low, other.low]),
            high: each(f64::max, [self.high, other.high]),
        }
    }

    /// How far the brightest is above the darkest, for each channel.
    fn width(&self) -> [f64; 3] {
        let (low, high) = (self.low.channels(), self.high.channels());
        [0, 1, 2].map(|channel| (high[channel] - low[channel]).min(f64::MAX))
    }
}
