//! The patterns: how evenly they are spread, and what they depend on. How fast their errors fall is
//! measured by `tests/laws.rs`.

use heliodon::camera::{Pattern, SamplePositions};

/// The largest difference between the share of places in a box at the pixel's corner and its area
/// (the star discrepancy), for boxes that end at places.
fn discrepancy(pattern: Pattern, count: u32) -> f64 {
    let places = SamplePositions::new(pattern, 3, 5, count);
    let places: Vec<_> = (0..count)
        .map(|number| places.at(number).map(|it| it + 0.5))
        .collect();
    let mut worst = 0.0f64;
    for [x, _] in &places {
        for [_, y] in &places {
            let below = places.iter().filter(|place| place[0] < *x && place[1] < *y);
            let upto = places
                .iter()
                .filter(|place| place[0] <= *x && place[1] <= *y);
            let [below, upto] =
                [below.count(), upto.count()].map(|it| it as f64 / f64::from(count));
            worst = worst.max(x * y - below).max(upto - x * y);
        }
    }
    worst
}

#[test]
fn sobol_is_spread_most_evenly_and_random_least() {
    let [sobol, stratified, random] =
        [Pattern::Sobol, Pattern::Stratified, Pattern::Random].map(|it| discrepancy(it, 64));
    assert!(
        sobol < stratified && stratified < random,
        "{sobol} {stratified} {random}"
    );
}

#[test]
fn every_power_of_two_of_a_sobol_sequence_has_one_place_in_each_cell() {
    let places = SamplePositions::new(Pattern::Sobol, 11, 4, 1 << 12);
    for power in 0..=12u32 {
        for across in 0..=power {
            let (columns, rows) = (1u32 << across, 1u32 << (power - across));
            let cells = (0..1u32 << power).map(|number| {
                let [x, y] = places.at(number).map(|it| it + 0.5);
                (
                    (x * f64::from(columns)).floor().to_bits(),
                    (y * f64::from(rows)).floor().to_bits(),
                )
            });
            let different: std::collections::HashSet<_> = cells.collect();
            assert_eq!(different.len(), 1 << power, "{columns} by {rows} cells");
        }
    }
}

#[test]
fn any_count_gives_that_many_places_inside_the_pixel() {
    for pattern in Pattern::ALL {
        for count in 1..200 {
            let places = SamplePositions::new(pattern, 3, 5, count);
            let mut all = (0..count).flat_map(|number| places.at(number));
            assert!(all.all(|place| place.abs() <= 0.5), "{pattern:?} {count}");
        }
    }
}

#[test]
fn stratified_puts_one_place_into_each_cell() {
    let cell = |place: f64| ((place + 0.5) * 4.0).floor();
    for pattern in [Pattern::Stratified, Pattern::Grid] {
        let places = SamplePositions::new(pattern, 7, 9, 16);
        let cells = (0..16).map(|number| places.at(number).map(|it| cell(it).to_bits()));
        let different: std::collections::HashSet<_> = cells.collect();
        assert_eq!(different.len(), 16);
    }
}

#[test]
fn the_mean_place_is_the_centre_for_every_count() {
    for pattern in Pattern::ALL {
        for count in [2, 3, 5, 7, 13] {
            let mut sum = [0.0; 2];
            for pixel in 0..2000 {
                let places = SamplePositions::new(pattern, pixel, 1, count);
                for number in 0..count {
                    let place = places.at(number);
                    sum = [sum[0] + place[0], sum[1] + place[1]];
                }
            }
            let mean = sum.map(|sum| sum / 2000.0 / f64::from(count));
            assert!(
                mean.iter().all(|mean| mean.abs() < 0.01),
                "{pattern:?} {count}: {mean:?}"
            );
        }
    }
}

#[test]
fn a_place_depends_on_pixel_and_number_alone() {
    for pattern in [Pattern::Stratified, Pattern::Sobol, Pattern::Random] {
        let of = |column, row| SamplePositions::new(pattern, column, row, 8);
        let all =
            |places: SamplePositions| (0..8).map(|number| places.at(number)).collect::<Vec<_>>();
        let mut backwards: Vec<_> = (0..8).rev().map(|number| of(1, 2).at(number)).collect();
        backwards.reverse();
        assert_eq!(backwards, all(of(1, 2)), "{pattern:?}");
        assert_ne!(all(of(1, 2)), all(of(2, 1)), "{pattern:?}");
    }
}
