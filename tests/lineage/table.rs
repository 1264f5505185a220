//! The table in `docs/lineage.md`, checked against the tests.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use support::files::{repository, sources, stem};

/// How many numbers each list of the table has.
const LISTS: [(char, u32); 4] = [('R', 45), ('G', 16), ('S', 16), ('P', 5)];

/// All names that the chapter uses, and the visibility test that it speaks of.
const WORDS: &str = "plane_t fplane_t texplane_t texture_t hits dump_obj getamb getdiff set_pixsize \
    texture_map gettexel mapdiff getdim matamb matdiff vl_mult3 hitloc testhit lasthit xdir width \
    height imagename pix_x_size pix_y_size mode light_visible";

fn page() -> String {
    fs::read_to_string(repository("docs/lineage.md")).unwrap()
}

/// The words in backticks.
fn quoted(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// Whether a word is a number of one of the lists.
fn is_number(word: &str) -> bool {
    LISTS.iter().any(|(letter, count)| {
        let number = word
            .strip_prefix(*letter)
            .and_then(|digits| digits.parse().ok());
        number.is_some_and(|number: u32| (1..=*count).contains(&number))
    })
}

/// The rows of the page that begin with a number: the number and the cells after it.
fn rows(page: &str) -> Vec<(&str, Vec<&str>)> {
    let tables = page
        .lines()
        .filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |"));
    let cells = tables.map(|line| line.split(" | ").collect::<Vec<_>>());
    cells
        .filter(|cells| is_number(cells[0]))
        .map(|cells| (cells[0], cells[1..].to_vec()))
        .collect()
}

/// The tests of this folder by name, with the numbers that their comments begin with.
fn tests() -> BTreeMap<String, BTreeSet<String>> {
    let mut tests = BTreeMap::new();
    for (path, text) in sources(repository("tests/lineage")) {
        let module = stem(&path);
        let (mut comment, mut is_test) = (String::new(), false);
        for line in text.lines().map(str::trim) {
            if let Some(more) = line.strip_prefix("///") {
                comment += more;
            } else if line == "#[test]" {
                is_test = true;
            } else if let Some(rest) = line.strip_prefix("fn ").filter(|_| is_test) {
                let name = rest.split('(').next().unwrap_or_default();
                let numbers = comment.split(':').next().unwrap_or_default();
                let numbers = numbers.split(',').map(|number| number.trim().to_owned());
                tests.insert(format!("lineage::{module}::{name}"), numbers.collect());
                (comment, is_test) = (String::new(), false);
            } else {
                comment.clear();
            }
        }
    }
    tests
}

/// R1 to R45, G1 to G16 and all others have one row each, in order.
#[test]
fn every_number_has_a_row() {
    let page = page();
    let numbers: Vec<_> = rows(&page).into_iter().map(|(number, _)| number).collect();
    let expected = LISTS
        .iter()
        .flat_map(|(letter, count)| (1..=*count).map(move |number| format!("{letter}{number}")));
    assert_eq!(numbers, expected.collect::<Vec<_>>());
}

/// Every row names a test, or says that it is decided otherwise.
#[test]
fn every_row_has_a_test_or_a_reason() {
    for (number, cells) in rows(&page()) {
        let tested = cells.last().is_some_and(|cell| cell.contains("`lineage::"));
        let reason = cells
            .iter()
            .any(|cell| cell.contains("Decided otherwise: "));
        assert!(tested || reason, "{number}");
        assert!(cells.iter().all(|cell| !cell.trim().is_empty()), "{number}");
    }
}

/// Every test that a row names exists, and its comment names the row.
#[test]
fn every_named_test_exists() {
    let tests = tests();
    for (number, cells) in rows(&page()) {
        for name in quoted(cells.last().unwrap()) {
            let numbers = tests
                .get(name)
                .unwrap_or_else(|| panic!("{number}: no test {name}"));
            assert!(
                numbers.contains(number),
                "{name} does not say that it keeps {number}"
            );
        }
    }
}

/// Every test outside of this file says first what it keeps.
#[test]
fn every_test_names_its_numbers() {
    let tests = tests();
    assert!(tests.len() > 100, "{}", tests.len());
    for (name, numbers) in tests
        .iter()
        .filter(|(name, _)| !name.starts_with("lineage::table"))
    {
        assert!(
            numbers.iter().all(|number| is_number(number)),
            "{name}: {numbers:?}"
        );
    }
}

/// R44: every name of the chapter has a place here, and the place exists.
#[test]
fn the_chapters_words_have_a_place() {
    let page = page();
    let words = page.split("## The chapter's words").nth(1).unwrap();
    let table = words.lines().filter(|line| line.starts_with("| `"));
    let (mut theirs, mut ours) = (BTreeSet::new(), BTreeSet::new());
    for line in table {
        let (left, right) = line[2..].split_once(" | ").unwrap();
        theirs.extend(quoted(left));
        ours.extend(quoted(right));
    }
    assert_eq!(theirs, WORDS.split_whitespace().collect());
    let code = sources(repository("src"));
    let code: String = code.into_iter().map(|(_, text)| text).collect();
    for place in ours.into_iter().filter(|place| *place != "*") {
        let name = place.rsplit("::").next().unwrap();
        let declared = ["fn ", "struct ", "enum ", "trait ", "pub ", "\"", "mod "]
            .iter()
            .any(|before| code.contains(&format!("{before}{name}")));
        assert!(declared, "{place}");
    }
}
