//! Many rays from a seed, aimed at edges, corners, joints and walls.

use heliodon::math::Ray;
use rayon::prelude::*;
use support::random::Random;

use super::cases::Node;
use super::numbers::triple;
use super::oracle::Oracle;
use super::rays::{Answer, count, first, nudged, texel};
use super::subject::{Stage, Subject, ray};

/// The environment variable that scales the number of rays, and what it is by default.
const RAYS: (&str, u64) = ("HELIODON_HARD_CASE_RAYS", 1_000_000);

/// The steps into which edges, areas and boxes are divided.
const STEPS: u32 = 1024;

/// Random numbers as the README of the cases describes them.
struct Draws(Random);

impl Draws {
    /// A whole number below `count`.
    fn below(&mut self, count: u32) -> u32 {
        u32::try_from(self.0.bits() % u64::from(count)).unwrap_or(0)
    }

    /// One of the numbers 0, 1/1024 … 1.
    fn share(&mut self) -> f64 {
        f64::from(self.below(STEPS + 1)) / f64::from(STEPS)
    }
}

/// How rays are aimed.
struct Aim {
    seed: u64,
    /// Points, edges, areas and boxes: a corner and its neighbours.
    targets: Vec<Vec<[f64; 3]>>,
    start: Start,
    nudges: i32,
}

/// Where rays start.
enum Start {
    /// In the box between two corners.
    Box([[f64; 3]; 2]),
    /// Before the target, by 1 to 8 times this direction.
    Along([f64; 3]),
}

impl Aim {
    fn new(node: &Node) -> Self {
        let triples = |node: &Node| {
            node.values
                .iter()
                .map(|text| triple(text))
                .collect::<Vec<_>>()
        };
        let boxes = node.all("from").map(|from| {
            let corners = triples(from);
            Start::Box(
                corners
                    .try_into()
                    .unwrap_or_else(|_| panic!("`from` takes two corners")),
            )
        });
        let along = node
            .all("along")
            .map(|along| Start::Along(triple(along.value())));
        let mut starts: Vec<_> = boxes.chain(along).collect();
        assert!(starts.len() == 1, "`aimed` has {} starts", starts.len());
        let targets: Vec<_> = node.all("at").map(triples).collect();
        assert!(!targets.is_empty(), "`aimed` has no target");
        Self {
            seed: node
                .number("seed")
                .unwrap_or_else(|| panic!("`aimed` has no seed")),
            targets,
            start: starts.remove(0),
            nudges: node.number("nudges").unwrap_or(0),
        }
    }

    /// The ray with this number: its origin and its direction.
    fn ray(&self, number: u64) -> ([f64; 3], [f64; 3]) {
        let mut draws = Draws(Random::from_state((self.seed << 32).wrapping_add(number)));
        let count = u32::try_from(self.targets.len()).unwrap();
        let target = &self.targets[draws.below(count) as usize];
        let mut point = target[0];
        for corner in &target[1..] {
            let share = draws.share();
            for axis in 0..3 {
                point[axis] += share * (corner[axis] - target[0][axis]);
            }
        }
        let found = match &self.start {
            Start::Box([low, high]) => {
                let axes = [0, 1, 2];
                let origin = axes.map(|axis| {
                    let share = draws.share();
                    low[axis] + share * (high[axis] - low[axis])
                });
                (origin, axes.map(|axis| point[axis] - origin[axis]))
            }
            Start::Along(direction) => {
                let distance = f64::from(1 + draws.below(8));
                let axes = [0, 1, 2];
                (
                    axes.map(|axis| point[axis] - distance * direction[axis]),
                    *direction,
                )
            }
        };
        if self.nudges == 0 {
            return found;
        }
        let component = draws.below(6) as usize;
        let span = u32::try_from(2 * self.nudges + 1).unwrap();
        let steps = i32::try_from(draws.below(span)).unwrap() - self.nudges;
        nudged(found, component, steps)
    }
}

/// `aimed rays=… seed=… …`: the same truth for every ray.
pub(crate) fn aimed(node: &Node, subject: &Subject) -> Answer {
    let aim = Aim::new(node);
    let stage = subject.stage();
    let oracle = Oracle::new(subject);
    let asked: u64 = node
        .number("rays")
        .unwrap_or_else(|| panic!("`aimed` has no rays"));
    let rays = asked * scale() / RAYS.1;
    let wrong = (0..rays.max(1)).into_par_iter().filter_map(|number| {
        let (origin, direction) = aim.ray(number);
        let answer = ask(node, &stage, &oracle, &ray(origin, direction));
        let what = answer.err()?;
        let from = format!("from {origin:?} along {direction:?}");
        Some((number, format!("ray {number} {from} {what}")))
    });
    // One pass that counts the wrong rays and keeps the first.
    let (count, found) = wrong.map(|found| (1u64, Some(found))).reduce(
        || (0, None),
        |(a, one), (b, other)| (a + b, one.into_iter().chain(other).min()),
    );
    match found {
        None => Ok(()),
        Some((_, what)) => Err(format!("{what} ({count} of {rays} rays are wrong)")),
    }
}

fn scale() -> u64 {
    let given = std::env::var(RAYS.0).ok();
    given.map_or(RAYS.1, |count| {
        count
            .parse()
            .unwrap_or_else(|_| panic!("{}={count} is not a number", RAYS.0))
    })
}

fn ask(node: &Node, stage: &Stage, oracle: &Oracle, ray: &Ray<'static>) -> Answer {
    count(node, stage, ray)?;
    let Some(expected) = node.get("first") else {
        return Ok(());
    };
    let met = stage.first(ray);
    let Some(met) = first(expected, met.as_ref(), ray, oracle)? else {
        return Ok(());
    };
    if node.get("texel") == Some("exact") {
        let (truth, found) = (oracle.texel(met.name(), ray), met.texel().map(f64::round));
        if found.map(f64::to_bits) != truth.map(f64::to_bits) {
            return Err(format!("meets texel {found:?}, expected {truth:?}"));
        }
    } else {
        texel(node, met, 0)?;
    }
    if let Some(then) = node.get("then") {
        let next = stage.first(&met.mirrored(ray));
        let mirrored = first(then, next.as_ref(), ray, oracle);
        mirrored.map_err(|what| format!("is mirrored and {what}"))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::Random;

    /// The first numbers of the reference implementation for the seed 1234567.
    #[test]
    fn the_generator_is_the_known_one() {
        let mut draws = Random::from_state(1_234_567);
        let numbers = [0; 3].map(|_: i32| draws.bits());
        assert_eq!(
            numbers,
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423
            ]
        );
    }
}
