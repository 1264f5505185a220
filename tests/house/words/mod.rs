//! The words of documents and comments: openings, lengths of sentences, references that lead somewhere.
//!
//! A ceiling is the number of places that break a rule today. Lower it whenever fewer do; a rule
//! without a ceiling has no exceptions.

#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot set its stage has failed"
)]

mod blocks;
mod comments;
mod files;
mod identifiers;
mod inline;
mod known;
mod openings;
mod references;
mod sentences;
mod shapes;

use blocks::{Block, blocks_of};
use inline::words_alone;

/// The most paragraphs in a thousand that may open with a question word; the goal is 10.
const OPENINGS_IN_A_THOUSAND: usize = 200;
/// The most words in a sentence of a document.
const WORDS_IN_A_SENTENCE: usize = 40;
/// How many sentences may be longer; the goal is 0.
const LONG_SENTENCES: usize = 14;
/// How many public items may break the rule for first lines; the goal is 0.
const FAULTY_FIRST_LINES: usize = 402;
/// How many files of `src` may break the rule for first lines; the goal is 0.
const FAULTY_OPENINGS_OF_FILES: usize = 2;
/// How many references may lead nowhere; the goal is 0.
const BROKEN_REFERENCES: usize = 0;

/// Fails with the list of all places that break a rule, if there are more than the ceiling.
fn check(rule: &str, ceiling: usize, places: &[String]) {
    let count = places.len();
    // `cargo test --test house words -- --nocapture` lists them without a failure.
    println!(
        "{}\n{count} places break the rule: {rule}",
        places.join("\n")
    );
    assert!(
        count <= ceiling,
        "{count} places break the rule, {ceiling} may: {rule}"
    );
}

#[test]
fn paragraphs_open_with_a_noun_or_a_verb() {
    let mut paragraphs: Vec<(String, Block)> = Vec::new();
    for file in files::pages() {
        let blocks = blocks_of(&file.text).into_iter();
        paragraphs.extend(blocks.map(|block| (file.path.clone(), block)));
    }
    for file in files::schemas() {
        let blocks = blocks::descriptions(&file.text).into_iter();
        paragraphs.extend(blocks.map(|block| (file.path.clone(), block)));
    }
    for file in files::rust("src") {
        let blocks = comments::comments(&file.text)
            .into_iter()
            .flat_map(|comment| comment.blocks());
        paragraphs.extend(blocks.map(|block| (file.path.clone(), block)));
    }
    paragraphs.retain(|(_, block)| block.kind.is_prose());
    let ceiling = paragraphs.len() * OPENINGS_IN_A_THOUSAND / 1000;
    paragraphs.retain(|(_, block)| openings::opens_badly(&block.text));
    let places = paragraphs
        .iter()
        .map(|(path, block)| format!("{path}:{}: {}", block.line, start_of(&block.text)));
    check(
        "a paragraph opens with a noun or a verb",
        ceiling,
        &places.collect::<Vec<_>>(),
    );
}

#[test]
fn sentences_of_documents_are_short() {
    let mut places = Vec::new();
    let pages = files::pages()
        .into_iter()
        .filter(|file| file.path == "README.md" || file.path.starts_with("docs/"));
    for file in pages {
        let blocks = blocks_of(&file.text)
            .into_iter()
            .filter(|block| block.kind.is_prose());
        for block in blocks {
            for sentence in sentences::sentences(&words_alone(&block.text)) {
                let words = sentences::count_words(sentence.text);
                if words > WORDS_IN_A_SENTENCE {
                    places.push(format!(
                        "{}:{}: {words} words: {}",
                        file.path,
                        block.line,
                        start_of(sentence.text)
                    ));
                }
            }
        }
    }
    check("a sentence has at most 40 words", LONG_SENTENCES, &places);
}

#[test]
fn first_lines_of_comments_are_short() {
    let mut places = Vec::new();
    for file in files::rust("src") {
        for comment in comments::comments(&file.text)
            .iter()
            .filter(|comment| comment.is_public())
        {
            places.extend(
                comment
                    .fault()
                    .map(|fault| format!("{}:{}: {fault}", file.path, comment.line)),
            );
        }
    }
    check(
        "the first line of a comment is a short statement",
        FAULTY_FIRST_LINES,
        &places,
    );
}

#[test]
fn files_open_with_a_sentence() {
    let sources = files::rust("src");
    let faults = sources
        .iter()
        .filter_map(|file| Some((file, comments::fault_of_opening(&file.text)?)));
    let places: Vec<_> = faults
        .map(|(file, fault)| format!("{}:1: {fault}", file.path))
        .collect();
    check(
        "a file opens with one sentence about it",
        FAULTY_OPENINGS_OF_FILES,
        &places,
    );
}

#[test]
fn references_of_documents_lead_somewhere() {
    let documents = files::markdown();
    let known = known::Known::collect(&documents);
    let places: Vec<_> = documents
        .iter()
        .flat_map(|file| references::faults(file, &known))
        .collect();
    check("a document names what exists", BROKEN_REFERENCES, &places);
}

/// The first words of a text, on one line.
fn start_of(text: &str) -> String {
    let words: Vec<_> = text.split_whitespace().take(12).collect();
    words.join(" ")
}
