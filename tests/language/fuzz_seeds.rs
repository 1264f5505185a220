//! The fuzz targets run over their seed corpus, and their dictionaries are complete.
//!
//! `fuzz/seeds.txt` lists the seeds. `fuzz/README.md` tells how to run the targets for longer.

#[path = "../../fuzz/src/lib.rs"]
#[allow(unreachable_pub, reason = "it is a crate of its own elsewhere")]
mod bodies;

use std::fs;

use heliodon::language::{Attribute, Takes};
use heliodon::read::schemas;
use support::files::{files, repository};

#[test]
fn seeds_break_no_target() {
    let list = fs::read_to_string(repository("fuzz/seeds.txt")).expect("the list of seeds");
    for line in list.lines().filter(|line| !line.starts_with('#')) {
        let words: Vec<_> = line.split(' ').collect();
        let [target, folder, extension] = words[..] else {
            panic!("not a target, a folder and an extension: {line:?}");
        };
        let run = match target {
            "kdl" => bodies::kdl,
            "course" => bodies::course,
            "texture" => bodies::texture,
            "reference" => bodies::reference,
            _ => panic!("no such target: {target}"),
        };
        let seeds = files(repository(folder), extension);
        assert!(!seeds.is_empty(), "no seeds for {line:?}");
        for seed in seeds {
            let bytes = fs::read(&seed).expect("a seed");
            let result = std::panic::catch_unwind(|| run(&bytes));
            assert!(result.is_ok(), "{target} fails on {}", seed.display());
        }
    }
}

#[test]
fn the_dictionary_of_kdl_has_every_word() {
    let dictionary = fs::read_to_string(repository("fuzz/dictionaries/kdl.dict"));
    let dictionary = dictionary.expect("the dictionary");
    let entries: Vec<_> = dictionary
        .lines()
        .map(|line| line.trim_matches('"'))
        .collect();
    let mut words = Vec::new();
    for schema in schemas() {
        words.push(schema.word);
        words.extend(schema.value.into_iter().flat_map(words_of));
        let attributes = schema.all_attributes().chain(schema.properties);
        words.extend(attributes.flat_map(words_of));
    }
    words.sort_unstable();
    words.dedup();
    words.retain(|word| !entries.contains(word));
    assert!(
        words.is_empty(),
        "not in kdl.dict:\n\"{}\"",
        words.join("\"\n\"")
    );
}

/// The word of an attribute, those of its properties, and the words that they take as values.
fn words_of(attribute: &Attribute) -> Vec<&'static str> {
    let mut words = vec![attribute.word];
    if let Takes::Word(values) = attribute.takes {
        words.extend(values);
    }
    words.extend(attribute.properties.iter().flat_map(words_of));
    words
}
