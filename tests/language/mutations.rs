//! Broken scene files by the thousand: none may panic or hang, and next to none draw a pixel
//! that is no number.
//!
//! `HELIODON_MUTATIONS` is the number of cases; `HELIODON_MUTATION` runs one case again, and
//! prints it.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use heliodon::language::render_diagnostics;
use heliodon::read::{Options, read_bytes};
use heliodon::render::render;
use heliodon::scene::Setting;
use rayon::prelude::*;
use support::files::{files, repository};
use support::random::Random;

const CASES: u64 = 20_000;

/// Far more than any case needs, on a machine that does much else.
const PATIENCE: Duration = Duration::from_secs(20);

/// A scene that mutations start from.
struct Seed {
    text: Vec<u8>,
    directory: PathBuf,
    good: bool,
}

/// All scenes of the project, good and bad; large textures are replaced by a small one.
fn seeds() -> Vec<Seed> {
    let folders = [
        ("scenes", "kdl"),
        ("tests/good", "kdl"),
        ("tests/bad", "kdl"),
    ];
    let mut paths: Vec<_> = [folders.as_slice(), &[("tests/course", "txt")]]
        .concat()
        .into_iter()
        .flat_map(|(folder, ending)| files(repository(folder), ending))
        .collect();
    paths.sort();
    let seed = |path: &PathBuf| {
        let mut text = std::fs::read_to_string(path).expect("a text");
        // What a good scene includes has large textures, too.
        while let Some((before, rest)) = text.split_once("\ninclude \"parts/") {
            let (part, after) = rest.split_once('"').expect("a closing quote");
            let part = std::fs::read_to_string(repository("scenes/parts").join(part));
            let part = part
                .expect("a text")
                .replace("../../textures/", "../textures/");
            text = format!("{before}\n{part}{after}");
        }
        let words: Vec<_> = text.split('"').collect();
        let small = words
            .iter()
            .map(|word| match word.split_once("/textures/") {
                Some((before, _)) => format!("{before}/textures/arrow-8x8.png"),
                None => (*word).to_owned(),
            });
        Seed {
            text: small.collect::<Vec<_>>().join("\"").into_bytes(),
            directory: path.parent().expect("a folder").to_owned(),
            good: !path.starts_with(repository("tests/bad")),
        }
    };
    paths.iter().map(seed).collect()
}

/// Random numbers, and things picked by them.
struct Dice(Random);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0.remainder(limit.max(1))
    }

    fn pick<'a, T>(&mut self, things: &'a [T]) -> &'a T {
        &things[self.below(things.len())]
    }
}

const NUMBERS: &[&str] = &[
    "3",
    "-2.5",
    "0.1",
    "10",
    "100",
    "255",
    "1e-9",
    "1e9",
    "1e75",
    "-1e75",
    "1.8e75",
    "1e-60",
    "1e76",
    "0",
    "-0.0",
    "-1",
    "1",
    "2",
    "0.5",
    "1e300",
    "-1e300",
    "1e308",
    "1e-300",
    "5e-324",
    "-5e-324",
    "1e155",
    "1e-155",
    "1e17",
    "1e999",
    "#nan",
    "#inf",
    "#-inf",
    "4294967296",
    "32768",
    "65536",
    "170141183460469231731687303715884105727",
    "9999999999999999999999999999999999999999999",
    ".5",
];

const SCRAPS: &[&str] = &[
    "{", "}", "\"", "\"\"\"", "#\"", "\"#", "/*", "*/", "//", "/-", "\\", ";", "\n", "=", "(", ")",
    "#", "#true", "#false", "#null", "\u{feff}", "\u{2028}", "\0", "é", " ", "\r\n", "{}", "/- {",
    ",",
];

fn mutated(seeds: &[Seed], index: u64) -> (Vec<u8>, &Path) {
    let mut dice = Dice(Random::of_case(index));
    // Two thirds of the cases start from the few good scenes; half of these get other numbers only,
    // so that many of them are still scenes.
    let (good, only_numbers) = (dice.below(3) > 0, dice.below(2) == 0);
    let (goods, bads): (Vec<_>, Vec<_>) = seeds.iter().partition(|seed| seed.good);
    let seed = *dice.pick(if good { &goods } else { &bads });
    let mut text = seed.text.clone();
    for _ in 0..1 + dice.below(5) {
        if good && only_numbers {
            replace_number(&mut text, &mut dice);
        } else {
            mutate(&mut text, seeds, &mut dice);
        }
    }
    (text, &seed.directory)
}

fn mutate(text: &mut Vec<u8>, seeds: &[Seed], dice: &mut Dice) {
    let at = dice.below(text.len() + 1);
    let scrap: Vec<u8> = match dice.below(12) {
        0 => {
            if let Some(byte) = text.get_mut(at) {
                *byte ^= 1 << dice.below(8);
            }
            return;
        }
        1 => {
            let end = (at + 1 + dice.below(8)).min(text.len());
            text.drain(at..end);
            return;
        }
        // A line or a word, somewhere else again or gone.
        2 | 3 => {
            let separator = *dice.pick::<&[u8]>(&[b"\n", b" \n"]);
            let range = around(text, at, separator);
            if dice.below(3) == 0 {
                text.drain(range);
                return;
            }
            let copy = [b"\n", &text[range]].concat();
            let to = dice.below(text.len() + 1);
            text.splice(to..to, copy);
            return;
        }
        // The end of another file.
        4 => {
            let other = &dice.pick(seeds).text;
            let from = dice.below(other.len() + 1);
            text.truncate(at);
            text.extend_from_slice(&other[from..]);
            return;
        }
        5 => dice.pick(SCRAPS).repeat(1 + dice.below(200)).into_bytes(),
        6 | 7 => dice.pick(SCRAPS).as_bytes().to_vec(),
        _ => {
            replace_number(text, dice);
            return;
        }
    };
    text.splice(at..at, scrap);
}

fn replace_number(text: &mut Vec<u8>, dice: &mut Dice) {
    let number = dice.pick(NUMBERS).as_bytes().to_vec();
    let numbers: Vec<_> = (0..text.len())
        .filter(|at| starts_number(text, *at))
        .collect();
    if !numbers.is_empty() {
        let range = around(text, *dice.pick(&numbers), b" \n;}=\"");
        text.splice(range, number);
    }
}

/// The bytes around a place up to the next separators.
fn around(text: &[u8], at: usize, separators: &[u8]) -> Range<usize> {
    let separates = |byte: &u8| separators.contains(byte);
    let start = text[..at]
        .iter()
        .rposition(separates)
        .map_or(0, |before| before + 1);
    let length = text[at..].iter().position(separates);
    start..length.map_or(text.len(), |length| at + length)
}

fn starts_number(text: &[u8], at: usize) -> bool {
    let starts = text[at].is_ascii_digit() || text[at] == b'-';
    starts && at > 0 && matches!(text[at - 1], b' ' | b'=')
}

/// What became of one case.
#[derive(Debug, Clone, Copy, Default)]
struct Outcome {
    accepted: usize,
    non_finite: usize,
    slowest: (Duration, u64),
}

impl Outcome {
    fn and(self, other: Self) -> Self {
        Self {
            accepted: self.accepted + other.accepted,
            non_finite: self.non_finite + other.non_finite,
            slowest: self.slowest.max(other.slowest),
        }
    }
}

/// Reads one case, and renders it if it is a scene.
fn run(seeds: &[Seed], index: u64) -> Outcome {
    let start = Instant::now();
    let (text, directory) = mutated(seeds, index);
    let options = Options {
        size: Some([8, 6]),
        settings: vec![Setting::new("samples", "1").expect("a setting")],
        ..Options::default()
    };
    let mut outcome = Outcome::default();
    match read_bytes("scene", text, directory.to_owned(), &options) {
        Ok(reading) => {
            outcome.accepted = 1;
            if let Ok((film, _)) = render(&reading.scene, &|_| {}) {
                outcome.non_finite = usize::from(film.non_finite().count() > 0);
            }
        }
        Err(scene_error) => {
            assert!(
                !scene_error.diagnostics.is_empty(),
                "refused without a reason"
            );
            let said =
                render_diagnostics(&scene_error.diagnostics, &scene_error.sources, false, 100);
            assert!(
                !said.contains(" `` "),
                "an empty word in a message:\n{said}"
            );
        }
    }
    outcome.slowest = (start.elapsed(), index);
    outcome
}

/// Threads like those of the program.
fn pool() -> rayon::ThreadPool {
    const STACK: usize = 16 << 20;
    let pool = rayon::ThreadPoolBuilder::new().stack_size(STACK).build();
    pool.expect("a thread pool")
}

fn number(variable: &str) -> Option<u64> {
    let text = std::env::var(variable).ok()?;
    Some(
        text.parse()
            .unwrap_or_else(|_| panic!("{variable} is not a number: {text:?}")),
    )
}

#[test]
fn no_broken_scene_panics_hangs_or_draws_what_is_no_number() {
    let seeds = seeds();
    assert!(seeds.len() > 100, "only {} seeds", seeds.len());
    if let Some(index) = number("HELIODON_MUTATION") {
        let (text, directory) = mutated(&seeds, index);
        eprintln!(
            "{}\n{}",
            directory.display(),
            String::from_utf8_lossy(&text)
        );
        eprintln!("{:?}", pool().install(|| run(&seeds, index)));
        return;
    }
    let cases = number("HELIODON_MUTATIONS").unwrap_or(CASES);
    let start = Instant::now();
    let caught = |index| {
        let case = std::panic::AssertUnwindSafe(|| run(&seeds, index));
        std::panic::catch_unwind(case).map_err(|_| index)
    };
    let outcomes: Vec<_> = pool().install(|| (0..cases).into_par_iter().map(caught).collect());
    let panicked: Vec<_> = outcomes
        .iter()
        .filter_map(|outcome| outcome.err())
        .collect();
    let odd: Vec<_> = (0..)
        .zip(&outcomes)
        .filter(|(_, outcome)| outcome.is_ok_and(|outcome| outcome.non_finite > 0))
        .map(|(index, _): (u64, _)| index)
        .collect();
    let all = outcomes
        .iter()
        .flatten()
        .fold(Outcome::default(), |all, one| all.and(*one));
    eprintln!("{cases} cases in {:?}: {all:?}", start.elapsed());
    let again = "run one again with HELIODON_MUTATION=index";
    assert!(panicked.is_empty(), "panics in {panicked:?}; {again}");
    assert!(
        odd.is_empty(),
        "{} pictures are not finite: {odd:?}; {again}",
        odd.len()
    );
    assert!(
        all.slowest.0 < PATIENCE,
        "too slow: {:?}; {again}",
        all.slowest
    );
}
