//! A floor of black and white squares up to the horizon: how bright each pixel is, by integration.

use super::numbers::words;

/// A floor y = −1 of squares of side 1, white where ⌊x⌋ + ⌊−z⌋ is even, seen through the chapter's
/// screen in the plane z = 0, behind which it begins.
#[derive(Debug)]
pub(crate) struct Floor {
    eye: [f64; 3],
    /// Width and height of the screen.
    screen: [f64; 2],
}

/// Beyond so many rows of squares a pixel is taken to be grey.
const ROWS: u32 = 4000;

/// Places across each row of squares, between which the border of a square is taken to be straight.
const STEPS: u32 = 64;

impl Floor {
    /// Seen from an eye, three numbers, through a screen, two.
    pub(crate) fn new(eye: &str, screen: &str) -> Self {
        Self {
            eye: words(eye).map(|word: &str| word.parse().unwrap()),
            screen: words(screen).map(|word: &str| word.parse().unwrap()),
        }
    }

    /// The mean over the area of a pixel, in a picture of this size; rows count from the top, and the
    /// middles of the outermost pixels lie on the borders of the screen.
    pub(crate) fn mean(&self, [column, row]: [u32; 2], size: [u32; 2]) -> f64 {
        let place = [column, size[1] - 1 - row];
        let [across, up] = [0, 1].map(|axis| {
            let pitch = self.screen[axis] / f64::from(size[axis] - 1);
            let middle = f64::from(place[axis]) * pitch;
            [middle - 0.5 * pitch, middle + 0.5 * pitch]
        });
        // Below the horizon, and above the floor's beginning at the screen itself.
        let [low, high] = up.map(|y| y.clamp(-1.0, self.eye[1]));
        let mut sum = 0.0;
        for number in 0..ROWS {
            let [from, to] =
                [number, number + 1].map(|number| self.seen_at(number).clamp(low, high));
            let white = number.is_multiple_of(2);
            sum += self.row(across, [from, to], white);
        }
        let far = self.seen_at(ROWS).clamp(low, high);
        sum += 0.5 * (high - far) * (across[1] - across[0]);
        sum / ((up[1] - up[0]) * (across[1] - across[0]))
    }

    /// How high on the screen the beginning of a row of squares is seen.
    fn seen_at(&self, number: u32) -> f64 {
        let [_, height, before] = self.eye;
        let behind = f64::from(number);
        (height * behind - before) / (before + behind)
    }

    /// The white area on the screen of the part of a row of squares that is seen between two heights.
    fn row(&self, across: [f64; 2], [from, to]: [f64; 2], white: bool) -> f64 {
        let step = (to - from) / f64::from(STEPS);
        if step <= 0.0 {
            return 0.0;
        }
        let heights = (0..STEPS).map(|number| from + (f64::from(number) + 0.5) * step);
        let widths = heights.map(|y| {
            let farther = (self.eye[1] + 1.0) / (self.eye[1] - y);
            let [left, right] = across.map(|x| self.eye[0] + farther * (x - self.eye[0]));
            let even = even_part(right) - even_part(left);
            let part = if white { even } else { right - left - even };
            part / farther
        });
        widths.sum::<f64>() * step
    }
}

/// How much of the way from 0 to a place lies between an even number and the next one.
fn even_part(place: f64) -> f64 {
    let pairs = (place / 2.0).floor();
    pairs + (place - 2.0 * pairs).min(1.0)
}
