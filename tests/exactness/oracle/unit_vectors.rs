//! Vectors of unit length, as close to it as bounds take them to be.

use glam::DVec3;
use heliodon::math::{Flat, Frame, UNIT, unit};

use super::equality::{SEED, cases as count};
use oracle::rational::{Vector, number, rounded};
use support::random::Random;

#[test]
fn unit_vectors_are_unit() {
    let mut worst = [0f64; 2];
    let far = |random: &mut Random| {
        let exponent = f64::from(random.between(-300, 300));
        let decimal: f64 = format!("{:e}", 10f64.powf(exponent))
            .parse()
            .expect("a number");
        random.cube() * decimal
    };
    for case in 0..count() / 10 {
        let mut random = Random::of(SEED, case);
        let given = [far(&mut random), far(&mut random)];
        let Ok(frame) = Frame::new(given[0], given[1]) else {
            continue;
        };
        let flat = Flat::new(DVec3::ZERO, given[0]).expect("a normal that is not zero");
        let axes = [flat.normal, frame.x, frame.y];
        let dot = |a: DVec3, b: DVec3| Vector::of(a).dot(&Vector::of(b));
        for (index, axis) in axes.into_iter().enumerate() {
            let next = axes[(index + 1) % 3];
            let length = rounded(&(dot(axis, axis) - number(1.0))).abs() / UNIT;
            let right = rounded(&dot(axis, next)).abs() / UNIT;
            worst = [worst[0].max(length), worst[1].max(right)];
        }
        let any = unit(given[0]).expect("a vector that is not zero");
        let length = rounded(&(dot(any, any) - number(1.0))).abs() / UNIT;
        worst[0] = worst[0].max(length);
    }
    println!(
        "|n|² − 1 is up to {} u, the axes' products up to {} u",
        worst[0], worst[1]
    );
    assert!(worst[0] <= 8.0, "a length is off by more than 4 u");
    assert!(worst[1] <= 2.0, "axes are not at right angles");
}
