//! The figures in `docs/laws` show the numbers beside them, and those are what is measured.
//!
//! `cargo run --release --bin laws` writes both anew.

use std::fs::read_to_string;

use heliodon::measure::exponent;
use heliodon::render::STACK;
use heliodon_tools::laws::figures::LAWS;
use heliodon_tools::laws::series::{self, Series};
use rayon::ThreadPoolBuilder;

/// The series that are kept of a law.
fn kept(name: &str) -> Vec<Series> {
    let law = LAWS.iter().find(|law| law.name == name).expect("a law");
    series::read(&read_to_string(law.file("csv")).expect("numbers")).expect("series")
}

#[test]
fn every_figure_shows_the_numbers_beside_it() {
    for law in LAWS {
        let text = read_to_string(law.file("csv")).expect("numbers");
        let series = series::read(&text).expect("series");
        assert_eq!(series::written(law.columns, &series).expect("text"), text);
        let shown = read_to_string(law.file("svg")).expect("a figure");
        assert!(
            (law.figure)(&series).svg() == shown,
            "{} is out of date",
            law.name
        );
    }
}

#[test]
fn what_is_kept_is_what_is_measured() {
    let pool = ThreadPoolBuilder::new().stack_size(STACK).build();
    let pool = pool.expect("threads");
    for law in LAWS {
        let measured = pool.install(law.measured).expect("a measurement");
        assert_eq!(measured, kept(law.name), "{}", law.name);
    }
}

#[test]
fn borders_fall_by_three_quarters_and_at_random_by_half() {
    for series in kept("edges") {
        let far = series.points.iter().filter(|point| point[0] >= 16.0);
        let power = exponent(far.copied()).expect("a power");
        let expected = if series.name == "random" { -0.5 } else { -0.75 };
        assert!((power - expected).abs() < 0.03, "{}: {power}", series.name);
    }
}

#[test]
fn the_exact_filter_is_right_everywhere_and_robust_never_wrong() {
    let series = kept("filters");
    let exact = series.iter().find(|series| series.name == "exact");
    let worst = exact.expect("a series").points.iter().map(|point| point[1]);
    assert!(worst.fold(0.0, f64::max) < 0.5 / 255.0);
    for series in kept("numerics") {
        let wrong = series.points.iter().any(|point| point[1] > 0.0);
        assert_eq!(
            wrong,
            series.name != "robust",
            "{} {}",
            series.panel,
            series.name
        );
    }
}

#[test]
fn no_mirror_lacks_more_than_the_cut_off() {
    for series in kept("cut-off") {
        // In the glass ball a ray from the eye can cause more others than are followed.
        let bounded = series.name != "glass-ball";
        let kept = series
            .points
            .iter()
            .all(|[cut_off, error]| error <= cut_off);
        assert_eq!(kept, bounded, "{}", series.name);
    }
}
