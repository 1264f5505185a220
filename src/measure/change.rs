//! How a picture differs from another.

use serde::Serialize;

use crate::film::Film;

/// How a picture differs from another, in code values of 8 bits before they are rounded.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Change {
    /// The share of the pixels that differ by more than half a code value in some channel.
    pub pixels: f64,
    /// The largest difference of a channel, in code values.
    pub largest: f64,
}

/// The largest code value of 8 bits.
const LARGEST_CODE: f64 = 255.0;

impl Change {
    /// The change from one picture to another of the same size; none for pictures without pixels.
    ///
    /// What is brighter than the largest code value is shown as that, and compared as that.
    #[must_use]
    pub fn between(before: &Film, after: &Film) -> Self {
        let pairs = before.pixels().iter().zip(after.pixels());
        let differences = pairs.map(|(before, after)| {
            let [before, after] = [before, after].map(|pixel| pixel.channels().map(shown));
            let channels = before.iter().zip(&after);
            channels.fold(0.0, |most: f64, (before, after)| {
                most.max((before - after).abs())
            })
        });
        let (mut changed, mut largest) = (0, 0.0_f64);
        for difference in differences {
            changed += u32::from(difference > 0.5);
            largest = largest.max(difference);
        }
        #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
        let all = before.pixels().len().max(1) as f64;
        Self {
            pixels: f64::from(changed) / all,
            largest,
        }
    }
}

/// An intensity as a code value that is not rounded.
pub(super) fn shown(intensity: f64) -> f64 {
    LARGEST_CODE * intensity.clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    #[test]
    fn what_cannot_be_seen_is_no_change() {
        let mut before = Film::new(4, 1).expect("memory");
        let mut after = before.clone();
        let code = |code: f64| Rgb::new(0.0, code / 255.0, 0.0);
        let pixels = [[9.0, 9.5], [9.0, 9.501], [0.0, 40.0], [300.0, 400.0]];
        for (index, [from, to]) in pixels.into_iter().enumerate() {
            before.pixels_mut()[index] = code(from);
            after.pixels_mut()[index] = code(to);
        }
        let change = Change::between(&before, &after);
        assert_eq!(change.pixels, 0.5);
        assert!((change.largest - 40.0).abs() < 1e-9, "{change:?}");
    }
}
