//! Pseudorandom numbers.

/// A bijection that maps neighbouring numbers to unrelated ones.
///
/// The finalizer of `SplitMix64` (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number
/// generators", variant 13).
#[must_use]
pub fn scramble(number: u64) -> u64 {
    let mixed = number.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    mixed ^ (mixed >> 31)
}
