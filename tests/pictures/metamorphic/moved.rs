//! A scene in another place, with everything that has a place: surfaces, lights, camera, screen.

use heliodon::film::{Film, Rounding};
use heliodon::language::Value;

use super::exceptions::{EXCEPTIONS, Relation};
use super::rooms::rooms;
use super::subject::{Subject, difference, fail_on};

/// The grid's step is one over this.
const GRID: f64 = 1_048_576.0; // 2^20

/// The moves on the grid: every coordinate stays exact, since 2^30 / 2^-20 has no more than 53 bits.
const MOVES: [[f64; 3]; 4] = [
    [1e9, 0.0, 0.0],
    [0.5, -1e9, 3.0 / GRID],
    [0.0, -1234.0, 1e9],
    [-1e9, 1e9 - 5.0 / GRID, -1e9],
];

/// The same scene in another place.
pub(super) fn moved(subject: &Subject, way: [f64; 3]) -> Subject {
    subject.changed(|place, numbers| {
        if place.is_point() {
            for (number, way) in numbers.iter_mut().zip(way) {
                *number += way;
            }
        }
    })
}

/// The scene with all of its points on the grid.
fn snapped(subject: &Subject) -> Subject {
    subject.changed(|place, numbers| {
        if place.is_point() {
            for number in numbers {
                *number = (*number * GRID).round() / GRID;
            }
        }
    })
}

fn complaints_on_the_grid(subject: &Subject) -> Vec<String> {
    let subject = snapped(subject);
    let expected = subject.film();
    let moves = MOVES.into_iter().filter_map(|way| {
        let title = format!("{} moved by {way:?}", subject.name);
        difference(&title, &expected, &moved(&subject, way).film())
    });
    moves.collect()
}

/// The scenes that nothing ties to their place.
fn movable() -> impl Iterator<Item = Subject> {
    let fixed = |subject: &Subject| {
        let mut exceptions = EXCEPTIONS.iter();
        exceptions.any(|exception| exception.breaks(Relation::Moved, subject))
    };
    Subject::all()
        .into_iter()
        .filter(move |subject| !fixed(subject))
}

#[test]
fn every_scene_can_be_moved_on_a_grid() {
    fail_on(movable().flat_map(|subject| complaints_on_the_grid(&subject)));
}

#[test]
fn every_room_can_be_moved_on_a_grid() {
    fail_on(rooms().flat_map(|room| complaints_on_the_grid(&room.subject)));
}

/// A decimal plus a whole number, as the exact decimal: 0.1 + 10^9 is 1000000000.1.
fn plus(number: f64, whole: i128) -> String {
    let text = number.to_string();
    let (before, after) = text.split_once('.').unwrap_or((&text, ""));
    let unit = 10i128.pow(u32::try_from(after.len()).unwrap());
    let digits: i128 = format!("{before}{after}").parse().unwrap();
    let sum = digits + whole * unit;
    let sign = if sum < 0 { "-" } else { "" };
    let (whole, rest) = (sum.abs() / unit, sum.abs() % unit);
    format!("{sign}{whole}.{rest:0places$}", places = after.len().max(1))
}

#[test]
fn decimals_are_added_as_decimals() {
    for (number, whole, sum) in [
        (0.1, 1_000_000_000, "1000000000.1"),
        (-0.1, 1_000_000_000, "999999999.9"),
        (-2.5, 1, "-1.5"),
        (3.0, -1_000_000, "-999997.0"),
        (0.000_001, 0, "0.000001"),
    ] {
        assert_eq!(plus(number, whole), sum);
    }
}

/// The same scene in another place, its coordinates written as exact decimals.
fn moved_as_decimals(subject: &Subject, way: [i128; 3]) -> Subject {
    subject.with_values(|place, value| {
        if let (true, Value::Triple(numbers)) = (place.is_point(), &value) {
            let sums = [0, 1, 2].map(|axis| plus(numbers[axis], way[axis]));
            *value = Value::from(format!("={}", sums.join(" ")).as_str());
        }
    })
}

/// The same scene seen from a trifle aside.
///
/// The chapter's screen aims the rays of its edge pixels exactly at the lines between texels, and
/// no such line is where it was when its decimal has been rounded to another one.
fn aside(subject: &Subject) -> Subject {
    subject.with_values(|place, value| {
        if let (true, Value::Triple(numbers)) = (place.is_of_camera(), &value) {
            let [x, y, z] = *numbers;
            *value = Value::Triple([x + 0.001_234_567, y + 0.000_765_432, z]);
        }
    })
}

/// How many pixels differ by more than 1 code value of 8 bits.
fn unlike(expected: &Film, found: &Film) -> usize {
    let [expected, found] = [expected, found].map(|film| film.bytes(Rounding::Nearest));
    let pixels = expected.chunks(3).zip(found.chunks(3));
    let differing = pixels.filter(|(one, other)| {
        let mut channels = one.iter().zip(*other);
        channels.any(|(a, b)| a.abs_diff(*b) > 1)
    });
    differing.count()
}

/// Decimals far away are rounded to a coarser grid than near the origin, so pixels on the edges of
/// things may change; but hardly any.
#[track_caller]
fn assert_hardly_any_changes(subjects: Vec<Subject>) {
    const PIXELS_FOR_EACH_CHANGE: usize = 100_000;
    let (mut pixels, mut changed, mut complaints) = (0, 0, Vec::new());
    for subject in subjects {
        let expected = subject.film();
        for far in [1_000_000, 1_000_000_000] {
            for way in [[far, 0, -far], [-far, far, 0]] {
                let found = moved_as_decimals(&subject, way).film();
                let count = unlike(&expected, &found);
                pixels += expected.pixels().len();
                changed += count;
                if count > 0 {
                    let name = &subject.name;
                    complaints.push(format!("{name} moved by {way:?}: {count} pixels change"));
                }
            }
        }
    }
    assert!(
        changed * PIXELS_FOR_EACH_CHANGE <= pixels,
        "\n{}\n{changed} of {pixels} in all\n",
        complaints.join("\n")
    );
}

#[test]
fn every_scene_can_be_moved_as_decimals() {
    // Stripes become ever narrower, so anywhere in their distance there is a border of one.
    let stripes = |subject: &Subject| subject.says("procedural-plane", "shader", Some("stripes"));
    let subjects = movable().filter(|subject| !stripes(subject));
    assert_hardly_any_changes(subjects.map(|subject| aside(&subject)).collect());
}

#[test]
fn every_room_can_be_moved_as_decimals() {
    assert_hardly_any_changes(rooms().map(|room| room.subject).collect());
}
