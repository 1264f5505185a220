//! Neighbours share their seams, and rooms are closed.

use heliodon::visibility::{Accelerator, SurfaceList};

use super::equality::{SEED, cases, verdict};
use oracle::floors::Floor;
use oracle::rooms::Room;
use oracle::tally::Tally;
use support::random::Random;

/// Rays for each scene.
const EACH: u64 = 100;

/// Every other scene is asked through a tree.
fn either(scene: u64) -> Accelerator {
    [Accelerator::List, Accelerator::Tree][(scene % 2) as usize]
}

#[test]
fn a_ray_at_a_seam_meets_exactly_one_tile() {
    let mut tally = Tally::default();
    for scene in 0..cases().div_ceil(EACH) {
        let mut random = Random::of(SEED, scene);
        let mut floor = Floor::any(&mut random);
        floor.share(&mut tally);
        for _ in 0..EACH {
            tally.observe_within(|tally| floor.ask(&mut random, tally));
        }
    }
    verdict("seams", &tally);
    assert!(
        tally.by_rule > tally.cases / 1000,
        "no ray met a seam itself"
    );
}

#[test]
fn no_ray_leaves_a_closed_room() {
    for (what, make) in [
        (
            "rooms of planes",
            Room::of_planes as fn(&mut Random, f64) -> Room,
        ),
        ("rooms of rectangles", Room::of_rectangles),
    ] {
        let mut tally = Tally::default();
        for scene in 0..cases().div_ceil(EACH) {
            let mut random = Random::of(SEED, scene);
            let room = make(&mut random, 1.0);
            let list = SurfaceList::with(&room.surfaces, either(scene));
            for _ in 0..EACH {
                tally.observe_within(|tally| room.ask(&list, &mut random, tally));
            }
        }
        verdict(what, &tally);
    }
}

#[test]
fn no_mirrored_ray_leaves_a_room_or_meets_its_own_sheet() {
    const BOUNCES: u32 = 100;
    for (what, make) in [
        (
            "mirrors of planes",
            Room::scaled_planes as fn(&mut Random) -> Room,
        ),
        ("mirrors of rectangles", Room::scaled_rectangles),
    ] {
        let mut tally = Tally::default();
        for scene in 0..cases().div_ceil(100) {
            let mut random = Random::of(SEED, scene);
            let room = make(&mut random);
            let list = SurfaceList::with(&room.surfaces, either(scene));
            tally.observe_within(|tally| {
                for _ in 0..20 {
                    room.follow(&list, &mut random, BOUNCES, tally);
                }
            });
        }
        verdict(what, &tally);
    }
}

#[test]
fn no_ray_leaves_through_the_corner_that_it_starts_in() {
    let mut tally = Tally::default();
    for scene in 0..cases().div_ceil(EACH) {
        let mut random = Random::of(SEED, scene);
        let room = Room::of_rectangles(&mut random, 1.0);
        let list = SurfaceList::with(&room.surfaces, either(scene));
        for _ in 0..EACH {
            tally.observe_within(|tally| room.ask_in_corner(&list, &mut random, tally));
        }
    }
    verdict("corners", &tally);
    assert!(tally.cases > cases() / 2, "no ray started in a corner");
}
