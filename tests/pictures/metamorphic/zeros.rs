//! Zeros with a sign: −0 is the same number as 0.

use super::rooms::rooms;
use super::subject::{Subject, difference, fail_on};

/// The same scene with −0 for every 0.
fn with_negative_zeros(subject: &Subject) -> Subject {
    subject.changed(|_, numbers| {
        for number in numbers {
            if *number == 0.0 {
                *number = -0.0;
            }
        }
    })
}

fn complaint(subject: &Subject) -> Option<String> {
    let other = with_negative_zeros(subject);
    assert!(
        other.text().contains("-0.0"),
        "{} has no zero",
        subject.name
    );
    difference(&subject.name, &subject.film(), &other.film())
}

#[test]
fn every_scene_may_write_its_zeros_with_a_sign() {
    fail_on(Subject::all().iter().filter_map(complaint));
}

#[test]
fn every_room_may_write_its_zeros_with_a_sign() {
    fail_on(rooms().filter_map(|room| complaint(&room.subject)));
}
