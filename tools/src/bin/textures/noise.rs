//! Makes repeatable randomness: hashes of grid places, smooth noise and cells between them.

use crate::shape::smooth;

/// A thoroughly mixed number for a place of the grid; equal places give equal numbers.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "Only the bits matter"
)]
fn hash(place: [i64; 3], seed: u32) -> u32 {
    let mut state = seed.wrapping_mul(0x9e37_79b9) ^ 0x51ed_270b;
    for part in place {
        state ^= part as u32;
        state = (state ^ (state >> 16)).wrapping_mul(0x7feb_352d);
        state = (state ^ (state >> 15)).wrapping_mul(0x846c_a68b);
        state ^= state >> 16;
    }
    state
}

/// A random number from 0 to 1 for a place of the grid.
pub(crate) fn random(place: [i64; 3], seed: u32) -> f64 {
    f64::from(hash(place, seed)) / f64::from(u32::MAX)
}

/// The grid place at or before a coordinate.
#[expect(
    clippy::cast_possible_truncation,
    reason = "Coordinates stay far below 2^63"
)]
pub(crate) fn cell(coordinate: f64) -> i64 {
    coordinate.floor() as i64
}

/// A grid index as a coordinate.
#[expect(clippy::cast_precision_loss, reason = "Indices stay far below 2^53")]
pub(crate) fn corner(index: i64) -> f64 {
    index as f64
}

/// Wraps a grid index when a period is given (0 means none).
fn wrap(index: i64, period: i64) -> i64 {
    if period > 0 {
        index.rem_euclid(period)
    } else {
        index
    }
}

/// Smooth noise from 0 to 1 in the plane, which repeats after `period` cells (0 for never).
pub(crate) fn plane(x: f64, y: f64, seed: u32, period: [i64; 2]) -> f64 {
    let (column, row) = (cell(x), cell(y));
    let (u, v) = (
        smooth(0.0, 1.0, x - corner(column)),
        smooth(0.0, 1.0, y - corner(row)),
    );
    let at = |right: i64, down: i64| {
        random(
            [
                wrap(column + right, period[0]),
                wrap(row + down, period[1]),
                0,
            ],
            seed,
        )
    };
    let top = at(0, 0) * (1.0 - u) + at(1, 0) * u;
    let bottom = at(0, 1) * (1.0 - u) + at(1, 1) * u;
    top * (1.0 - v) + bottom * v
}

/// Plane noise summed over octaves, each twice as fine and half as strong; from 0 to 1.
pub(crate) fn fractal(x: f64, y: f64, octaves: u32, seed: u32, period: [i64; 2]) -> f64 {
    let (mut sum, mut weight, mut total, mut scale, mut repeat) = (0.0, 1.0, 0.0, 1.0, period);
    for octave in 0..octaves {
        sum += weight * plane(x * scale, y * scale, seed.wrapping_add(octave), repeat);
        total += weight;
        weight *= 0.5;
        scale *= 2.0;
        repeat = [repeat[0] * 2, repeat[1] * 2];
    }
    sum / total
}

/// Smooth noise from 0 to 1 in space.
pub(crate) fn space(point: [f64; 3], seed: u32) -> f64 {
    let base = point.map(cell);
    let [u, v, w] = [0, 1, 2].map(|axis| smooth(0.0, 1.0, point[axis] - corner(base[axis])));
    let at = |a: i64, b: i64, c: i64| random([base[0] + a, base[1] + b, base[2] + c], seed);
    let face = |c: i64| {
        let top = at(0, 0, c) * (1.0 - u) + at(1, 0, c) * u;
        let bottom = at(0, 1, c) * (1.0 - u) + at(1, 1, c) * u;
        top * (1.0 - v) + bottom * v
    };
    face(0) * (1.0 - w) + face(1) * w
}

/// Space noise summed over octaves, each twice as fine and half as strong; from 0 to 1.
pub(crate) fn fractal_space(point: [f64; 3], octaves: u32, seed: u32) -> f64 {
    let (mut sum, mut weight, mut total, mut scale) = (0.0, 1.0, 0.0, 1.0);
    for octave in 0..octaves {
        sum += weight * space(point.map(|part| part * scale), seed.wrapping_add(octave));
        total += weight;
        weight *= 0.5;
        scale *= 2.03; // Not quite 2, lest the grid lines of all octaves meet.
    }
    sum / total
}

/// The distance to the nearest of one random point per cell; about 0 to 1.
pub(crate) fn puffs(x: f64, y: f64, seed: u32) -> f64 {
    let (i, j) = (cell(x), cell(y));
    let mut nearest = 2.0_f64;
    for b in -1..=1 {
        for a in -1..=1 {
            let dx = corner(i + a) + random([i + a, j + b, 1], seed) - x;
            let dy = corner(j + b) + random([i + a, j + b, 2], seed) - y;
            nearest = nearest.min(dx * dx + dy * dy);
        }
    }
    nearest.sqrt().min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractal_noise_repeats_after_its_period() {
        for step in 0..50 {
            let (x, y) = (f64::from(step) * 0.171, f64::from(step) * 0.093);
            let here = fractal(x, y, 4, 1, [8, 4]);
            assert!((0.0..=1.0).contains(&here));
            assert!((fractal(x + 8.0, y + 4.0, 4, 1, [8, 4]) - here).abs() < 1e-9);
        }
    }
}
