//! Nodes in another order; only that of the lights and of coinciding surfaces means anything.

use heliodon::language::Schema;
use heliodon::measure::check;

use super::rooms::{Dice, rooms};
use super::subject::{Subject, difference, fail_on};

fn is_light(schema: &Schema) -> bool {
    ["light", "spotlight", "projector", "lamp"].contains(&schema.word)
}

/// The same nodes in another order, lights among themselves in the same (Fisher and Yates 1938,
/// "Statistical tables", in the version of Durstenfeld 1964).
fn permuted(subject: &Subject, dice: &mut Dice) -> Subject {
    let mut other = subject.clone();
    for last in (1..other.nodes.len()).rev() {
        other.nodes.swap(last, dice.below(last + 1));
    }
    let lights = subject.nodes.iter().filter(|node| is_light(node.schema));
    let places = other.nodes.iter_mut().filter(|node| is_light(node.schema));
    for (place, light) in places.zip(lights) {
        *place = light.clone();
    }
    other
}

/// Whether some surfaces share a plane and an area, so that their order means something.
fn overlaps(subject: &Subject) -> bool {
    let warnings = check(&subject.scene());
    let mut messages = warnings.iter().map(|warning| warning.message.as_str());
    messages.any(|message| {
        message.contains("lies in the same plane as") || message.contains("coincides with")
    })
}

fn complaints(subject: &Subject) -> Vec<String> {
    let expected = subject.film();
    let shuffles = (1..=2).filter_map(|shuffle| {
        let title = format!("{}, shuffle {shuffle}", subject.name);
        let other = permuted(subject, &mut Dice::new(shuffle));
        difference(&title, &expected, &other.film())
    });
    shuffles.collect()
}

#[test]
fn every_scene_without_overlaps_can_be_shuffled() {
    let mut exempt = Vec::new();
    let mut found = Vec::new();
    for subject in Subject::all() {
        if overlaps(&subject) {
            exempt.push(subject.name);
        } else {
            found.extend(complaints(&subject));
        }
    }
    fail_on(found);
    assert_eq!(exempt, [""; 0], "these scenes have overlaps");
}

#[test]
fn every_room_can_be_shuffled() {
    fail_on(rooms().flat_map(|room| {
        assert!(
            !overlaps(&room.subject),
            "{} has overlaps",
            room.subject.name
        );
        complaints(&room.subject)
    }));
}
