//! Decisions equal the exact ones, always.

use std::collections::BTreeMap;

use oracle::cases::far_and_round;
use oracle::decisions::{self, Tallies};
use oracle::tally::Tally;
use support::random::Random;

/// How many cases of each kind.
pub(super) fn cases() -> u64 {
    let asked = std::env::var("HELIODON_ORACLE_CASES").ok();
    asked.map_or(20_000, |count| count.parse().expect("a number of cases"))
}

pub(super) const SEED: u64 = 0x48_65_6c_69;

/// Fails unless nothing was found wrong.
pub(super) fn verdict(what: &str, tally: &Tally) {
    println!(
        "{what}: {} cases, {} positive, {} exactly, {} by rule, {} wrong",
        tally.cases, tally.positive, tally.exactly, tally.by_rule, tally.mismatches
    );
    assert!(
        tally.mismatches == 0,
        "{what}: {} of {} are not as exact arithmetic has them:\n{}",
        tally.mismatches,
        tally.cases,
        tally.samples.join("\n")
    );
}

fn run(what: &str, check: impl Fn(&mut Random, &mut Tallies)) -> Tallies {
    let mut tallies = Tallies::default();
    for case in 0..cases() {
        check(&mut Random::of(SEED, case), &mut tallies);
    }
    verdict(&format!("{what}, random"), &tallies.random);
    verdict(&format!("{what}, aimed"), &tallies.aimed);
    tallies
}

#[test]
fn hits_and_misses_are_the_exact_ones() {
    let mut worst: BTreeMap<String, f64> = BTreeMap::new();
    let worst = std::cell::RefCell::new(&mut worst);
    run("hits", |random, tallies| {
        decisions::meeting(random, tallies, &mut |surface, share| {
            let kind = surface.describe().schema.word;
            let mut worst = worst.borrow_mut();
            let largest = worst.entry(kind.to_string()).or_default();
            *largest = largest.max(share);
        });
    });
    println!("{:?}", worst.borrow());
}

#[test]
fn sides_are_the_exact_ones() {
    run("sides", decisions::side);
}

#[test]
fn orders_are_the_exact_ones() {
    run("nearest", decisions::nearest);
}

#[test]
fn occlusions_are_the_exact_ones() {
    run("occlusion", decisions::occlusion);
}

#[test]
fn far_and_round_things_are_met_exactly_where_they_are() {
    let mut tally = Tally::default();
    for case in 0..cases() / 4 {
        let (surface, ray) = far_and_round(&mut Random::of(SEED, case));
        decisions::check_meeting(&*surface, &ray, &mut tally, &mut |_, _| ());
    }
    verdict("far and round", &tally);
}

#[test]
fn what_a_neighbor_decides_is_decided_exactly() {
    run("welded", decisions::welded);
}
