//! The same scene on any number of threads.
//!
//! The renderer hands out whole rows and has no other way of cutting up a picture. Should it get
//! tiles, their sizes and orders belong into `every_way_of_sharing_the_work`.

use heliodon::film::Film;
use heliodon::scene::Scene;
use rayon::ThreadPoolBuilder;

use super::rooms::rooms;
use super::subject::{Subject, difference, fail_on, film};

/// The film of a scene for every way of sharing the work, with its title.
fn every_way_of_sharing_the_work(scene: &Scene) -> Vec<(String, Film)> {
    let ways = [1, 2, 5, 64].map(|threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        let film = pool.unwrap().install(|| film(scene));
        (format!("{threads} threads"), film)
    });
    ways.into()
}

fn complaints(subject: &Subject) -> Vec<String> {
    let scene = subject.scene();
    let expected = film(&scene);
    let ways = every_way_of_sharing_the_work(&scene).into_iter();
    let unlike = ways.filter_map(|(way, film)| {
        difference(&format!("{} with {way}", subject.name), &expected, &film)
    });
    unlike.collect()
}

#[test]
fn every_scene_can_be_shared_among_threads() {
    fail_on(Subject::all().iter().flat_map(complaints));
}

#[test]
fn every_room_can_be_shared_among_threads() {
    fail_on(rooms().flat_map(|room| complaints(&room.subject)));
}
