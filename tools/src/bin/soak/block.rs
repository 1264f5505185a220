//! One block of rays: what a thread does at a time.

use glam::DVec3;
use heliodon::math::{Point, Ray, Span, unit};
use heliodon::visibility::SurfaceList;

use super::options::{Kind, Options};
use oracle::cases;
use oracle::decisions::{self, Tallies};
use oracle::floors::Floor;
use oracle::rooms::Room;
use oracle::tally::Tally;
use support::random::{Random, Style};

/// Rays in a block.
pub(crate) const BLOCK: u64 = 1 << 16;

/// Mirrors that a ray is followed through.
const BOUNCES: u32 = 127;

/// Sends the rays of a block.
pub(crate) fn run(options: &Options, block: u64) -> Tally {
    let mut random = Random::of(options.seed, block);
    match options.kind {
        Kind::Edges => edges(&mut random),
        Kind::Rooms => rooms(&mut random),
        Kind::Bounces => bounces(&mut random),
        Kind::Oracle => oracle(&mut random),
        Kind::Spheres => spheres(&mut random),
        Kind::Random => undirected(&mut random),
    }
}

/// Scenes in a block, so that as many rays go to each as a scene takes time to make.
const SCENES: u64 = 8;

fn edges(random: &mut Random) -> Tally {
    let mut tally = Tally::default();
    for _ in 0..SCENES {
        let mut floor = Floor::any(random);
        floor.share(&mut tally);
        tally.observe_within(|tally| {
            for _ in 0..BLOCK / SCENES {
                floor.ask(random, tally);
            }
        });
    }
    tally
}

fn rooms(random: &mut Random) -> Tally {
    let mut tally = Tally::default();
    for scene in 0..SCENES {
        let make = [Room::of_planes, Room::of_rectangles][usize::from(scene % 2 == 1)];
        let room = make(random, 1.0);
        let list = SurfaceList::new(&room.surfaces);
        tally.observe_within(|tally| {
            for _ in 0..BLOCK / SCENES {
                room.ask(&list, random, tally);
                if scene % 2 == 1 && random.once_in(16) {
                    room.ask_in_corner(&list, random, tally);
                }
            }
        });
    }
    tally
}

fn bounces(random: &mut Random) -> Tally {
    let mut tally = Tally::default();
    for scene in 0..SCENES {
        let make = [Room::scaled_planes, Room::scaled_rectangles][usize::from(scene % 2 == 1)];
        let room = make(random);
        let list = SurfaceList::new(&room.surfaces);
        tally.observe_within(|tally| {
            for _ in 0..BLOCK / SCENES / u64::from(BOUNCES + 1) {
                room.follow(&list, random, BOUNCES, tally);
            }
        });
    }
    tally
}

fn oracle(random: &mut Random) -> Tally {
    let mut tallies = Tallies::default();
    for _ in 0..BLOCK / 4 {
        decisions::meeting(random, &mut tallies, &mut |_, _| ());
        decisions::side(random, &mut tallies);
        decisions::nearest(random, &mut tallies);
        decisions::occlusion(random, &mut tallies);
        if random.once_in(16) {
            decisions::welded(random, &mut tallies);
        }
    }
    let mut tally = tallies.random;
    tally += tallies.aimed;
    tally
}

fn spheres(random: &mut Random) -> Tally {
    let mut tally = Tally::default();
    for _ in 0..BLOCK {
        let (surface, ray) = cases::far_and_round(random);
        decisions::check_meeting(&*surface, &ray, &mut tally, &mut |_, _| ());
    }
    tally
}

fn undirected(random: &mut Random) -> Tally {
    let mut tally = Tally::default();
    for _ in 0..SCENES {
        let surface = cases::surface(random, Style::Uniform, 1.0);
        tally.observe_within(|tally| {
            for _ in 0..BLOCK / SCENES {
                let dir = unit(random.cube()).unwrap_or(DVec3::X);
                let ray = Ray::new(Point::exact(random.cube() * 4.0), dir);
                tally.cases += 1;
                tally.positive += u64::from(surface.hits(&ray, Span::AHEAD).is_some());
            }
        });
    }
    tally
}
