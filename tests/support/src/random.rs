//! Random numbers of the kinds that find mistakes in geometry.

use glam::DVec3;
use heliodon::math::{Point, unit};

/// `SplitMix64` (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators").
///
/// Every case has a generator of its own, a function of the seed and the case's number, so any case
/// can be had again without those before it.
#[derive(Debug, Clone)]
pub struct Random(u64);

/// What the numbers of a case look like.
#[derive(Debug, Clone, Copy)]
pub enum Style {
    /// Anywhere between −1 and 1, all bits in use.
    Uniform,
    /// One, two or three digits behind the point, as people write.
    Decimal,
    /// Whole and small.
    Whole,
    /// Whole multiples of a power of two.
    Grid,
    /// Of all magnitudes.
    Wild,
}

impl Random {
    /// The generator of a case.
    #[must_use]
    pub fn of(seed: u64, case: u64) -> Self {
        let mut random = Self(seed ^ Self::state_of(case));
        random.bits();
        random
    }

    /// The state of a case's generator, without a seed.
    fn state_of(case: u64) -> u64 {
        case.wrapping_mul(0xd134_2543_de82_ef95)
    }

    /// The generator of a case that has no seed.
    #[must_use]
    pub fn of_case(case: u64) -> Self {
        Self(Self::state_of(case))
    }

    /// The generator in a state, with which its reference implementation is seeded.
    #[must_use]
    pub fn from_state(state: u64) -> Self {
        Self(state)
    }

    /// Any 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    /// A whole number from 0 to below `count`.
    pub fn below(&mut self, count: u32) -> u32 {
        let scaled = (self.bits() >> 32) * u64::from(count);
        u32::try_from(scaled >> 32).unwrap_or(0)
    }

    /// A whole number from 0 to below `count`, as the remainder of all bits.
    pub fn remainder(&mut self, count: usize) -> usize {
        usize::try_from(self.bits() % count as u64).unwrap_or(0)
    }

    /// A whole number between two others, both included.
    pub fn between(&mut self, low: i32, high: i32) -> i32 {
        let count = u32::try_from(high - low + 1).unwrap_or(1);
        low + i32::try_from(self.below(count)).unwrap_or(0)
    }

    /// True once in so many times.
    pub fn once_in(&mut self, count: u32) -> bool {
        self.below(count) == 0
    }

    /// One of these.
    pub fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(u32::try_from(choices.len()).unwrap_or(1)) as usize]
    }

    /// From 0 to below 1.
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    pub fn share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (f64::EPSILON / 2.0)
    }

    /// From −1 to 1.
    pub fn signed(&mut self) -> f64 {
        2.0 * self.share() - 1.0
    }

    /// A vector between −1 and 1.
    pub fn cube(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }

    /// A power of two with an exponent between these.
    pub fn power(&mut self, low: i32, high: i32) -> f64 {
        2f64.powi(self.between(low, high))
    }

    /// Any style.
    pub fn style(&mut self) -> Style {
        use Style::{Decimal, Grid, Uniform, Whole, Wild};
        self.pick(&[Uniform, Decimal, Whole, Grid, Wild])
    }

    /// A number in a style; zero once in four.
    pub fn number(&mut self, style: Style) -> f64 {
        if self.once_in(4) {
            return 0.0;
        }
        let whole = |random: &mut Self, most: i32| f64::from(random.between(-most, most));
        match style {
            Style::Uniform => self.signed(),
            Style::Decimal => {
                let digits = self.pick(&[10.0, 100.0, 1000.0]);
                whole(self, 20_000) / digits
            }
            Style::Whole => whole(self, 12),
            Style::Grid => whole(self, 4096) / 1024.0,
            Style::Wild => self.signed() * self.power(-40, 40),
        }
    }

    /// A vector in a style.
    pub fn vector(&mut self, style: Style) -> DVec3 {
        DVec3::new(self.number(style), self.number(style), self.number(style))
    }

    /// A vector that is not zero.
    pub fn way(&mut self, style: Style) -> DVec3 {
        loop {
            let way = self.vector(style);
            if way != DVec3::ZERO {
                return way;
            }
        }
    }

    /// A unit vector in a style.
    pub fn direction(&mut self, style: Style) -> DVec3 {
        unit(self.way(style)).unwrap_or(DVec3::X)
    }

    /// A point, with or without an offset from its anchor.
    pub fn point(&mut self, style: Style) -> Point {
        let anchor = self.vector(style);
        if self.once_in(2) {
            return Point::exact(anchor);
        }
        let offset = self.cube() * self.power(-30, 3);
        Point { anchor, offset }
    }

    /// The vector with one component moved by up to so many places of its last digit.
    pub fn nudged(&mut self, mut vector: DVec3, most: i32) -> DVec3 {
        let axis = self.below(3) as usize;
        for _ in 0..self.between(0, most) {
            vector[axis] = vector[axis].next_up();
        }
        if self.once_in(2) {
            vector
        } else {
            mirror(vector, axis, most)
        }
    }
}

/// Moves a component as far down again as it can have been moved up.
fn mirror(mut vector: DVec3, axis: usize, most: i32) -> DVec3 {
    for _ in 0..most {
        vector[axis] = vector[axis].next_down();
    }
    vector
}
