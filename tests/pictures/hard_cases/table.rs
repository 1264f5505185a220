//! All answers, and the table that shows them.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};

use rayon::prelude::*;

use super::cases::{Case, Node};
use super::rays::Answer;
use super::subject::BackEnd;
use super::{aimed, codes, loading, pictures, pile, rays};

/// How a case ended under a back end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Every question was answered rightly.
    Pass,
    /// What is wrong with the answers.
    Fail(Vec<String>),
}

/// What every case gave, in the order of the back ends.
pub(crate) type Row = (Case, [Outcome; 3]);

/// Asks every case under every back end that exists.
pub(crate) fn run(cases: Vec<Case>) -> Vec<Row> {
    let asked = cases.into_par_iter().map(|case| {
        let outcomes = BackEnd::ALL.map(|back_end| outcome(&case, back_end));
        (case, outcomes)
    });
    asked.collect()
}

fn outcome(case: &Case, back_end: BackEnd) -> Outcome {
    let complaints = case.questions.iter().filter_map(|question| {
        let answer = catch_unwind(AssertUnwindSafe(|| answer(question, case, back_end)));
        let answer = answer.unwrap_or_else(|panic| {
            let text = panic.downcast_ref::<String>().cloned();
            let text = text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()));
            Err(format!("panics: {}", text.unwrap_or_default()))
        });
        let what = answer.err()?;
        let values: Vec<_> = question.values.iter().map(|value| value.trim()).collect();
        let scene = question
            .get("in")
            .map_or(String::new(), |name| format!(" in {name:?}"));
        let asked = format!("{} {}{scene}", question.word, values.join(" | "));
        Some(format!("{}: {}: {what}", case.id, asked.trim()))
    });
    let complaints: Vec<_> = complaints.collect();
    if complaints.is_empty() {
        Outcome::Pass
    } else {
        Outcome::Fail(complaints)
    }
}

fn answer(node: &Node, case: &Case, back_end: BackEnd) -> Answer {
    let subject = || pictures::subject(node, case, back_end);
    match node.word.as_str() {
        "ray" => rays::single(node, &subject()?),
        "pile" => pile::pile(node, back_end),
        "path" => rays::path(node, &subject()?),
        "aimed" => aimed::aimed(node, &subject()?),
        "look" => pictures::look(node, case, back_end),
        "picture" => pictures::picture(node, case, back_end),
        "unchanged" => pictures::unchanged(node, case, back_end),
        "kept" => pictures::kept(node, case, back_end),
        "refused" => loading::refused(node, back_end),
        "accepted" => loading::accepted(node, back_end),
        "warned" => loading::warned(node, case, back_end),
        "thresholds" => codes::thresholds(node),
        "code" => codes::one_code(node),
        other => panic!("there is no question `{other}`"),
    }
}

/// The words that each kind of question may have: properties, then children.
pub(crate) fn vocabulary() -> BTreeMap<&'static str, [&'static [&'static str]; 2]> {
    BTreeMap::from([
        (
            "ray",
            [
                &[
                    "in",
                    "first",
                    "t",
                    "within",
                    "normal",
                    "color",
                    "texel",
                    "texel-step",
                    "texel-size",
                    "count",
                    "repeat",
                    "step",
                    "nudges",
                ][..],
                &[],
            ],
        ),
        (
            "path",
            [
                &["in", "most", "bounces", "unit", "direction", "within"],
                &[],
            ],
        ),
        (
            "aimed",
            [
                &[
                    "in", "rays", "seed", "nudges", "first", "count", "texel", "then",
                ],
                &["at", "from", "along"],
            ],
        ),
        ("pile", [&["count"], &[]]),
        ("look", [&["in", "lit", "up"], &[]]),
        (
            "picture",
            [
                &[
                    "in",
                    "color",
                    "within",
                    "lit",
                    "white",
                    "changes",
                    "same-as",
                    "floor-from",
                    "screen",
                    "mirror-rays",
                    "shadow-rays",
                    "transmitted-rays",
                ],
                &["drawn"],
            ],
        ),
        (
            "unchanged",
            [
                &[
                    "in", "scaled", "moved", "zeros", "split", "into", "threads", "found-by",
                    "parts",
                ],
                &[],
            ],
        ),
        ("kept", [&["in", "robust", "classic", "classic-f32"], &[]]),
        ("refused", [&["names"], &[]]),
        ("accepted", [&[], &[]]),
        ("warned", [&["in", "names"], &[]]),
        (
            "thresholds",
            [&["nudges", "transfer", "quantize", "bits"], &[]],
        ),
        ("code", [&["is", "transfer", "quantize", "bits"], &[]]),
    ])
}

/// The table as it stands in `docs/hard-cases.md`.
pub(crate) fn table(rows: &[Row]) -> String {
    let mut text = format!("\n{}\n\n", totals(rows));
    text += "| | Case | Truth | robust | classic | classic-f32 | Remark |\n";
    text += "|---|---|---|---|---|---|---|\n";
    for (case, outcomes) in rows {
        let words = outcomes.each_ref().map(|outcome| match outcome {
            Outcome::Pass => "pass",
            Outcome::Fail(_) => "**fail**",
        });
        let remark = case.remark.as_deref().unwrap_or_default();
        let cells = [&case.id, &case.title, &case.truth].map(|cell| cell.replace('|', "\\|"));
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "| {} | {} | {remark} |",
            cells.join(" | "),
            words.join(" | ")
        );
    }
    text + "\n"
}

fn totals(rows: &[Row]) -> String {
    let mut lines = vec![format!("{} cases:\n", rows.len())];
    lines.push("| | pass | fail |\n|---|---|---|".to_owned());
    for (index, back_end) in BackEnd::ALL.into_iter().enumerate() {
        let count = |wanted: fn(&Outcome) -> bool| {
            rows.iter()
                .filter(|(_, outcomes)| wanted(&outcomes[index]))
                .count()
        };
        let pass = count(|outcome| *outcome == Outcome::Pass);
        let fail = count(|outcome| matches!(outcome, Outcome::Fail(_)));
        lines.push(format!("| {} | {pass} | {fail} |", back_end.word()));
    }
    lines.join("\n")
}
