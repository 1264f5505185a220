//! As many rays through each pixel as its error asks for.

use super::{Both, Probe, Seed, Tracer, watch::Watch};
use crate::camera::{Pattern, Places};
use crate::film::{Region, Transfer};
use crate::math::Rgb;
use crate::plan::{Outlines, Plan};
use crate::scene::Picture;

/// Sends rays through pixels until their errors are probably within the picture's `max-error`.
///
/// Each pixel takes the first places of its Sobol sequence: four at first, or as many as `samples`
/// says, then twice as many, and so on. Whether it goes on depends on its own rays, on the first
/// ones of the pixels around it, and on the outlines through it; so a pixel is the same in any part
/// of the picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Adaptive<'a> {
    tracer: Tracer<'a>,
    picture: &'a Picture,
    outlines: &'a Outlines,
}

/// How much the error of a border between two colours is of their difference, for one ray; it falls
/// as the count's power of -3/4. Twice the root of the mean square, as measured.
const BORDER: f64 = 0.7;

/// How much the error of a mean is of the largest difference to the mean of a quarter: as measured on
/// images, where it meets the target in more than 99.5 % of pixels.
const SPREAD: f64 = 0.7;

/// What the rays of a pixel have brought.
#[derive(Debug, Clone, Copy)]
struct Tally {
    /// How many rays; a power of two, at least four.
    count: u32,
    /// The sums of the first quarter of them and so on; each quarter is spread evenly.
    quarters: [Rgb; 4],
    range: Colors,
    /// How deep into the picture they went before they met something.
    farthest: f64,
}

/// The darkest and the brightest of each channel of some colours.
#[derive(Debug, Clone, Copy)]
struct Colors {
    low: Rgb,
    high: Rgb,
}

impl<'a> Adaptive<'a> {
    /// `None` if the picture asks for the same number of rays everywhere.
    pub(super) fn new(tracer: Tracer<'a>, plan: &'a Plan<'a>) -> Option<Self> {
        Some(Self {
            tracer,
            picture: &plan.scene.picture,
            outlines: plan.outlines.as_ref()?,
        })
    }

    /// Draws a part of the picture.
    pub(super) fn draw(&self, part: Region, pixels: &mut [Rgb], probe: &mut impl Probe) {
        let size = [self.picture.width, self.picture.height];
        let wide = part.grown_within(size);
        let pilots: Vec<_> = wide
            .places()
            .map(|[column, row]| self.pilot(column, row, probe))
            .collect();
        let pilot = |column: usize, row: usize| {
            &pilots[(row - wide.top) * wide.width + (column - wide.left)]
        };
        for ([column, row], pixel) in part.places().zip(pixels) {
            let around = Region::around([column, row], size);
            let around = around
                .places()
                .map(|[column, row]| pilot(column, row).range);
            let around = around.fold(pilot(column, row).range, Colors::and);
            *pixel = self.refined(*pilot(column, row), around, column, row, probe);
        }
    }

    /// The colour of one pixel; onlookers do not see the rays of those around it.
    pub(super) fn color(&self, column: usize, row: usize, probe: &mut impl Probe) -> Rgb {
        let own = self.pilot(column, row, probe);
        let size = [self.picture.width, self.picture.height];
        let around = Region::around([column, row], size);
        let others = around.places().filter(|place| *place != [column, row]);
        let others = others.map(|[column, row]| self.pilot(column, row, &mut ()).range);
        let around = others.fold(own.range, Colors::and);
        self.refined(own, around, column, row, probe)
    }

    /// The first rays of a pixel.
    fn pilot(&self, column: usize, row: usize, probe: &mut impl Probe) -> Tally {
        let mut tally = Tally {
            count: 0,
            quarters: [Rgb::BLACK; 4],
            range: Colors::NONE,
            farthest: 0.0,
        };
        let count = self.picture.samples.next_power_of_two();
        self.send(
            &mut tally,
            count.max(Picture::FEWEST_ADAPTIVE),
            column,
            row,
            probe,
        );
        tally
    }

    /// The colour of a pixel, after as many more rays as it takes.
    fn refined(
        &self,
        mut tally: Tally,
        around: Colors,
        column: usize,
        row: usize,
        probe: &mut impl Probe,
    ) -> Rgb {
        // An outline that is well behind all that was met is not seen.
        const NEAR: f64 = 1.0 + 1.0 / 64.0;
        let outline = self.outlines.nearest(column, self.camera_row(row));
        while tally.count < Picture::MOST_ADAPTIVE {
            let outlined = outline.is_finite() && outline <= tally.farthest * NEAR;
            let transfer = self.picture.transfer;
            if tally.error(around, outlined, transfer) <= self.picture.max_error {
                break;
            }
            let [first, second, third, fourth] = tally.quarters;
            tally.quarters = [
                (first + second).saturated(),
                (third + fourth).saturated(),
                Rgb::BLACK,
                Rgb::BLACK,
            ];
            let count = 2 * tally.count;
            self.send(&mut tally, count, column, row, probe);
        }
        tally.mean()
    }

    /// Sends rays until there are as many as this.
    fn send(
        &self,
        tally: &mut Tally,
        count: u32,
        column: usize,
        row: usize,
        probe: &mut impl Probe,
    ) {
        let row = self.camera_row(row);
        let places = Places::new(Pattern::Sobol, column, row, count);
        let camera = &self.tracer.plan.camera;
        #[expect(clippy::cast_precision_loss, reason = "sides are far below 2^53")]
        let (x, y) = (column as f64, row as f64);
        for number in tally.count..count {
            let [dx, dy] = places.at(number);
            let onlooker: &mut dyn Probe = probe;
            let mut both = Both(onlooker, Watch::new(camera));
            let seed = Seed::shared(places.seed, number);
            let color = self.tracer.sees_as(x + dx, y + dy, seed, &mut both);
            tally.farthest = tally.farthest.max(both.1.depth);
            tally.range = tally.range.and(Colors {
                low: color,
                high: color,
            });
            let quarter = &mut tally.quarters[(number / (count / 4)) as usize];
            *quarter = (*quarter + color).saturated();
        }
        tally.count = count;
    }

    /// The camera's number of a row, which counts from the bottom.
    fn camera_row(&self, row: usize) -> usize {
        self.picture.height as usize - 1 - row
    }
}

impl Tally {
    fn mean(&self) -> Rgb {
        let [first, second, third, fourth] = self.quarters;
        let sum = ((first + second).saturated() + (third + fourth).saturated()).saturated();
        sum / f64::from(self.count)
    }

    /// How far off the mean probably is in its worst channel, as it is shown.
    fn error(&self, around: Colors, outlined: bool, transfer: Transfer) -> f64 {
        let count = f64::from(self.count);
        let border = BORDER / (count.sqrt() * count.sqrt().sqrt());
        let mean = self.mean().channels();
        let quarters = self
            .quarters
            .map(|quarter| (quarter / (count / 4.0)).channels());
        let (own, around) = (self.range.width(), around.width());
        let of_channel = |channel: usize| {
            let (own, around, mean) = (own[channel], around[channel], mean[channel]);
            let far = quarters
                .iter()
                .map(|quarter| (quarter[channel] - mean).abs());
            let spread = far.fold(0.0, f64::max);
            // What no ray has met has about the share of one ray: a colour of the pixels around,
            // or black before white if an outline promises that there is something.
            let known = if outlined { around.max(1.0) } else { around };
            let unmet = (known - own) / count;
            let error = (border * own).max(SPREAD * spread).max(unmet);
            transfer.error(mean, error)
        };
        (0..3).map(of_channel).fold(0.0, f64::max)
    }
}

impl Colors {
    const NONE: Self = Self {
        low: Rgb::new(f64::MAX, f64::MAX, f64::MAX),
        high: Rgb::new(f64::MIN, f64::MIN, f64::MIN),
    };

    fn and(self, other: Self) -> Self {
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
