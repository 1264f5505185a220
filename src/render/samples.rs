//! Where in a pixel the rays go.

/// The places of a pixel's rays, from −½ to ½ around its centre along x and y.
///
/// The pixel is cut into as many cells of equal area as there are samples, for any number: rows of
/// cells, each row as high as its share. One place is drawn in each cell by a hash of pixel,
/// sample and axis alone, so a picture is the same on every run and every number of threads.
pub fn samples(column: usize, row: usize, count: u32) -> impl Iterator<Item = (f64, f64)> {
    let rows = f64::from(count).sqrt().round().max(1.0);
    #[expect(clippy::cast_possible_truncation, reason = "at most 256")]
    #[expect(clippy::cast_sign_loss, reason = "at least 1")]
    let rows = rows as u32;
    let seed = scramble((column as u64) << 32 ^ row as u64);
    (0..rows).flat_map(move |band| {
        // The first and the past-the-end sample of this row of cells.
        let start = u64::from(count) * u64::from(band) / u64::from(rows);
        let end = u64::from(count) * (u64::from(band) + 1) / u64::from(rows);
        (start..end).map(move |sample| {
            #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
            let (cell, cells, start) =
                ((sample - start) as f64, (end - start) as f64, start as f64);
            let x = (cell + fraction(seed, 2 * sample)) / cells;
            let y = (start + cells * fraction(seed, 2 * sample + 1)) / f64::from(count);
            (x - 0.5, y - 0.5)
        })
    })
}

/// A number from 0 up to but not including 1.
fn fraction(seed: u64, index: u64) -> f64 {
    const STEPS: f64 = 9_007_199_254_740_992.0; // 2^53
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    let bits = (scramble(seed ^ index.wrapping_mul(0x9E37_79B9_7F4A_7C15)) >> 11) as f64;
    bits / STEPS
}

/// A bijection that turns neighbouring numbers into unrelated ones: the finalizer of `SplitMix64`
/// (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators", variant 13).
pub(super) fn scramble(number: u64) -> u64 {
    let mixed = number.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    mixed ^ (mixed >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_count_gives_that_many_places_inside_the_pixel() {
        for count in 1..200 {
            let places: Vec<_> = samples(3, 5, count).collect();
            assert_eq!(places.len(), count as usize);
            assert!(places.iter().all(|(x, y)| x.abs() <= 0.5 && y.abs() <= 0.5));
        }
    }

    #[test]
    fn square_counts_put_one_place_into_each_cell() {
        let cell = |place: f64| ((place + 0.5) * 4.0).floor();
        let mut cells: Vec<_> = samples(7, 9, 16)
            .map(|(x, y)| (4.0 * cell(y) + cell(x)).to_bits())
            .collect();
        cells.sort_unstable();
        cells.dedup();
        assert_eq!(cells.len(), 16);
    }

    #[test]
    fn the_mean_place_is_the_centre_for_every_count() {
        for count in [2, 3, 5, 7, 13] {
            let mut sum = (0.0, 0.0);
            for pixel in 0..2000 {
                for (x, y) in samples(pixel, 1, count) {
                    sum = (sum.0 + x, sum.1 + y);
                }
            }
            let mean = (
                sum.0 / 2000.0 / f64::from(count),
                sum.1 / 2000.0 / f64::from(count),
            );
            assert!(
                mean.0.abs() < 0.01 && mean.1.abs() < 0.01,
                "{count}: {mean:?}"
            );
        }
    }

    #[test]
    fn neighbours_differ_and_repeats_do_not() {
        assert!(samples(1, 2, 4).eq(samples(1, 2, 4)));
        assert!(samples(1, 2, 4).ne(samples(2, 1, 4)));
    }
}
