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
        Self {
            pixels: share(differences(before, after), |difference| difference > 0.5),
            largest: differences(before, after).fold(0.0, f64::max),
        }
    }
}

/// The share of the pixels of two pictures that differ by no more than this, where 1 is the largest
/// code value; none for pictures without pixels.
#[must_use]
pub(super) fn share_within(before: &Film, after: &Film, limit: f64) -> f64 {
    let codes = LARGEST_CODE * limit;
    share(differences(before, after), |difference| difference <= codes)
}

/// By how many code values the worst channel of each pixel differs.
fn differences(before: &Film, after: &Film) -> impl Iterator<Item = f64> {
    let pairs = before.pixels().iter().zip(after.pixels());
    pairs.map(|(before, after)| {
        let [before, after] = [before, after].map(|pixel| pixel.channels().map(shown));
        let channels = before.iter().zip(&after);
        let channels = channels.map(|(before, after)| (before - after).abs());
        channels.fold(0.0, f64::max)
    })
}

fn share(differences: impl Iterator<Item = f64>, counts: impl Fn(f64) -> bool) -> f64 {
    let [mut counted, mut all] = [0.0, 0.0];
    for difference in differences {
        counted += f64::from(counts(difference));
        all += 1.0;
    }
    counted / f64::max(all, 1.0)
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
        for (codes, share) in [(0.0, 0.25), (0.5001, 0.5), (39.0, 0.75), (41.0, 1.0)] {
            assert_eq!(share_within(&before, &after, codes / 255.0), share);
        }
    }
}
