//! The samples of a pixel, and the estimated error of their mean.

use crate::film::Transfer;
use crate::math::Rgb;

/// The error of an edge for one ray, as a share of the colours' difference.
///
/// It is twice the measured root mean square for a ray that hits either colour with equal
/// probability. The error falls with the count to the power of −3/4.
pub(super) const EDGE_ERROR: f64 = 0.8;

/// The error of a mean in units of its standard error.
///
/// As measured on images: with it, more than 99.5 % of pixels reach the target.
const STANDARD_ERRORS: f64 = 1.3;

/// The number of rays at which the squared standard error counts twice.
///
/// With few rays, the parts are often equal by chance, which underestimates the error.
const FEW_RAYS: f64 = 16.0;

/// The content of a pixel, as its rays found it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Content {
    /// Unfiltered images, which vary anywhere.
    Images,
    /// Surfaces with edges between them; images are filtered over each ray's share.
    Edges,
    /// The same path for all rays, with this hash; each ray shows its share of it.
    Uniform(u64),
}

/// The accumulated samples of a pixel.
#[derive(Debug, Clone, Copy)]
pub(super) struct SampleAccumulator {
    /// The number of rays: a power of two, at least four, or 1.5 times that.
    pub(super) count: u32,
    /// The sums of equally many consecutive rays, each of which are well distributed.
    ///
    /// There are four or six of them, and eight between two steps.
    parts: [Rgb; 8],
    /// The number of closed parts.
    filled: usize,
    /// The sum of the squares of all colours.
    squares: Rgb,
    /// The range of all colours.
    range: ColorRange,
    /// True if an outline in the pixel is not well behind all first hits.
    pub(super) has_outline: bool,
    /// The content as its rays found it.
    pub(super) content: Content,
    /// True if the filter is exact for all rays.
    pub(super) is_exact: bool,
}

/// The least and the largest value of each channel of some colours.
#[derive(Debug, Clone, Copy)]
pub(super) struct ColorRange {
    low: Rgb,
    high: Rgb,
}

/// The colours and content of the first rays of a pixel and its neighbours.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighborhood {
    range: ColorRange,
    content: Content,
}

impl Neighborhood {
    /// The colours and content of one pixel.
    pub(super) fn of(samples: &SampleAccumulator) -> Self {
        Self {
            range: samples.range,
            content: samples.content,
        }
    }

    /// The union of two neighbourhoods.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            range: self.range.and(other.range),
            content: match self.content {
                Content::Uniform(_) if other.content != self.content => Content::Edges,
                content => content,
            },
        }
    }
}

impl SampleAccumulator {
    /// An accumulator without samples.
    pub(super) const NOTHING: Self = Self {
        count: 0,
        parts: [Rgb::BLACK; 8],
        filled: 0,
        squares: Rgb::BLACK,
        range: ColorRange::NONE,
        has_outline: false,
        content: Content::Images,
        is_exact: true,
    };

    /// The difference from another mean in the worst channel, in displayed values.
    pub(super) fn change_from(&self, other: &Self, transfer: Transfer) -> f64 {
        let (mean, other) = (self.mean().channels(), other.mean().channels());
        let of_channel = |channel: usize| {
            let (mean, other): (f64, f64) = (mean[channel], other[channel]);
            transfer.error(mean, (mean - other).abs())
        };
        (0..3).map(of_channel).fold(0.0, f64::max)
    }

    /// Adds the colour of a ray to the open part.
    pub(super) fn add(&mut self, color: Rgb) {
        let part = &mut self.parts[self.filled];
        *part = (*part + color).saturated();
        self.squares += color * color;
        self.range = self.range.and(ColorRange {
            low: color,
            high: color,
        });
        self.count += 1;
    }

    /// The number of rays in each part.
    pub(super) fn size(&self) -> u32 {
        #[expect(clippy::cast_possible_truncation, reason = "eight at most")]
        let parts = self.filled as u32;
        self.count / parts
    }

    /// Closes the open part.
    pub(super) fn close_part(&mut self) {
        self.filled += 1;
    }

    /// Merges pairs of parts if there are eight.
    pub(super) fn merge_parts(&mut self) {
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

    /// The estimated error of the mean in the worst channel, in displayed values.
    ///
    /// It is estimated from the pixel's own rays and those of its neighbours. Errors of filters are
    /// not included.
    pub(super) fn error(&self, neighborhood: Neighborhood, transfer: Transfer) -> f64 {
        let count = f64::from(self.count);
        let edge = EDGE_ERROR / (count.sqrt() * count.sqrt().sqrt());
        let mean = self.mean().channels();
        let squares = (self.squares / count).channels();
        let parts = &self.parts[..self.filled];
        let size = f64::from(self.size());
        #[expect(clippy::cast_precision_loss, reason = "eight at most")]
        let pairs = (parts.len() * (parts.len() - 1)) as f64;
        let own = self.range.width();
        let neighborhood = match neighborhood.content {
            // All colours are those of the pixel's own shares.
            Content::Uniform(_) => own,
            _ => neighborhood.range.width(),
        };
        let of_channel = |channel: usize| {
            let (own, neighborhood, mean) = (own[channel], neighborhood[channel], mean[channel]);
            // An edge that cuts off only a corner is short. Its error lies between the difference
            // of the colours and their deviation; the former is at least twice the latter.
            let deviation = (squares[channel] - mean * mean).max(0.0).sqrt();
            let edge = edge * (own * 2.0 * deviation).sqrt();
            let deviations = parts
                .iter()
                .map(|part| part.channels()[channel] / size - mean);
            let variance = deviations
                .map(|deviation| deviation * deviation)
                .sum::<f64>()
                / pairs;
            let variance = variance * (1.0 + FEW_RAYS / count);
            let sampled = match self.content {
                Content::Images => {
                    (edge * edge + STANDARD_ERRORS * STANDARD_ERRORS * variance).sqrt()
                }
                Content::Edges => edge,
                Content::Uniform(_) => 0.0,
            };
            // A surface that no ray has hit covers about the share of one ray. Its colour is one of
            // the neighbours'; behind an outline, it may differ by as much as black from white.
            let possible = if self.has_outline {
                neighborhood.max(1.0)
            } else {
                neighborhood
            };
            let missed = (possible - own) / count;
            // The mean is limited to white, because samples above white would hide this error.
            let missed = transfer.error(mean.min(1.0), missed);
            transfer.error(mean, sampled).max(missed)
        };
        (0..3).map(of_channel).fold(0.0, f64::max)
    }
}

impl ColorRange {
    const NONE: Self = Self {
        low: Rgb::new(f64::MAX, f64::MAX, f64::MAX),
        high: Rgb::new(f64::MIN, f64::MIN, f64::MIN),
    };

    /// The union of two ranges.
    pub(super) fn and(self, other: Self) -> Self {
        let each = |choose: fn(f64, f64) -> f64, [a, b]: [Rgb; 2]| {
            Rgb::new(choose(a.r, b.r), choose(a.g, b.g), choose(a.b, b.b))
        };
        Self {
            low: each(f64::min, [self.low, other.low]),
            high: each(f64::max, [self.high, other.high]),
        }
    }

    /// The width of the range, for each channel.
    fn width(&self) -> [f64; 3] {
        let (low, high) = (self.low.channels(), self.high.channels());
        [0, 1, 2].map(|channel| (high[channel] - low[channel]).min(f64::MAX))
    }
}
