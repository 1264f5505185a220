//! A scene turned by half a turn about an axis of the world, with its camera.
//!
//! Two of the three axes change their sign, and no arithmetic rounds −x in another way than x. Right
//! stays right and up stays up in the picture, so it is the same for any aimed camera. The chapter's
//! screen cannot be turned: it lies across the z axis, and the eye is on its positive side.

use super::exceptions::{EXCEPTIONS, Relation};
use super::rooms::rooms;
use super::subject::{Subject, difference, fail_on};

/// The axis to turn about.
#[derive(Debug, Clone, Copy)]
pub(super) enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    pub(super) const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    fn signs(self) -> [f64; 3] {
        match self {
            Self::X => [1.0, -1.0, -1.0],
            Self::Y => [-1.0, 1.0, -1.0],
            Self::Z => [-1.0, -1.0, 1.0],
        }
    }
}

/// The same scene after half a turn.
pub(super) fn turned(subject: &Subject, axis: Axis) -> Subject {
    subject.changed(|place, numbers| {
        if place.is_point() || place.is_direction() {
            for (number, sign) in numbers.iter_mut().zip(axis.signs()) {
                *number *= sign;
            }
        }
    })
}

fn can_be_turned(subject: &Subject) -> bool {
    let mut exceptions = EXCEPTIONS.iter();
    !subject.says("camera", "screen", None)
        && !exceptions.any(|exception| exception.breaks(Relation::Turned, subject))
}

fn complaints(subject: &Subject) -> Vec<String> {
    let expected = subject.film();
    let turns = Axis::ALL.into_iter().filter_map(|axis| {
        let title = format!("{} turned about {axis:?}", subject.name);
        difference(&title, &expected, &turned(subject, axis).film())
    });
    turns.collect()
}

#[test]
fn every_scene_with_an_aimed_camera_can_be_turned() {
    let subjects: Vec<_> = Subject::all().into_iter().filter(can_be_turned).collect();
    assert!(subjects.len() >= 5, "only {} scenes", subjects.len());
    fail_on(subjects.iter().flat_map(complaints));
}

#[test]
fn every_room_with_an_aimed_camera_can_be_turned() {
    let subjects = rooms().map(|room| room.subject).filter(can_be_turned);
    fail_on(subjects.flat_map(|subject| complaints(&subject)));
}
