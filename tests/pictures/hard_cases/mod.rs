//! The hard cases: 108 scenes and questions on which ray tracers go wrong, and their truths.
//!
//! The cases are data, in `tests/hard_cases/*.kdl`; `tests/hard_cases/README.md` tells how to ask
//! them of another renderer. `docs/hard-cases.md` shows what each back end answers. To accept a new
//! table, run with `SNAPSHOTS=overwrite`, and read what has changed.

#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot set its stage has failed"
)]

mod aimed;
mod cases;
mod codes;
mod floor;
mod loading;
mod numbers;
mod oracle;
mod pictures;
mod pile;
mod rays;
mod scenes;
mod subject;
mod table;

use std::sync::OnceLock;
use std::sync::atomic::Ordering;

use support::texts::compare_section;
use table::Outcome;

const DOCUMENT: &str = "docs/hard-cases.md";
const MARKS: [&str; 2] = ["<!-- The table is written by", "<!-- The end of the table"];

/// How many cases each back end fails: `robust` few, in the end none; the baselines many, or the
/// cases would not be hard.
const FAILURES: [std::ops::RangeInclusive<usize>; 3] = [0..=0, 40..=108, 41..=108];

#[test]
fn each_back_end_fails_as_many_cases_as_it_may() {
    for (index, back_end) in subject::BackEnd::ALL.into_iter().enumerate() {
        let outcomes = rows().iter().map(|(_, outcomes)| &outcomes[index]);
        let count = outcomes
            .filter(|outcome| matches!(outcome, Outcome::Fail(_)))
            .count();
        let (word, allowed) = (back_end.word(), &FAILURES[index]);
        assert!(
            allowed.contains(&count),
            "{word} fails {count} cases, expected {allowed:?}"
        );
    }
}

/// What every case gave; asked once for all tests.
fn rows() -> &'static [table::Row] {
    static ROWS: OnceLock<Vec<table::Row>> = OnceLock::new();
    ROWS.get_or_init(|| table::run(cases::all()))
}

#[test]
fn the_table_shows_what_each_back_end_answers() {
    let rows = rows();
    for (_, outcomes) in rows {
        for (outcome, back_end) in outcomes.iter().zip(subject::BackEnd::ALL) {
            if let Outcome::Fail(complaints) = outcome {
                for what in complaints {
                    println!("{}: {what}", back_end.word());
                }
            }
        }
    }
    let compared = compare_section(DOCUMENT, MARKS, &table::table(rows));
    compared.unwrap_or_else(|differs| panic!("{differs}"));
    let rewritten = cases::REWRITTEN.load(Ordering::Relaxed);
    assert!(
        !rewritten,
        "a case file was rewritten; look at it and run the test again"
    );
}

#[test]
fn every_case_of_the_catalogue_is_there_and_well_formed() {
    let cases = cases::all();
    let expected = cases::GROUPS.iter().flat_map(|(file, count)| {
        let letter = file.to_uppercase().remove(0);
        (1..=*count).map(move |number| format!("{letter}{number}"))
    });
    let ids = cases.iter().map(|case| case.id.clone());
    assert_eq!(ids.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
    let vocabulary = table::vocabulary();
    for case in &cases {
        let id = &case.id;
        assert!(!case.questions.is_empty(), "{id} asks nothing");
        assert!(!case.why.is_empty() && !case.truth.is_empty(), "{id}");
        for question in &case.questions {
            let word = question.word.as_str();
            let known = vocabulary.get(word);
            let [properties, children] =
                known.unwrap_or_else(|| panic!("{id}: no question {word}"));
            for (name, _) in &question.properties {
                assert!(
                    properties.contains(&name.as_str()),
                    "{id}: {word} has no {name}="
                );
            }
            for child in &question.children {
                assert!(
                    children.contains(&child.word.as_str()),
                    "{id}: {word}: {}",
                    child.word
                );
            }
        }
    }
}
