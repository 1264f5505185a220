//! No number in geometry or shading stands for "nearly zero", and every bound is documented.
//!
//! The classic back ends are the chapter's own algorithm and need such numbers; they are let off.

use std::fs;

use support::files::{self, repository, with_slashes};

use super::code::{code_of, without_tests};

/// Where rays, hits and colours are computed.
const ROOMS: [&str; 10] = [
    "math",
    "geometry",
    "surface",
    "visibility",
    "light",
    "camera",
    "render",
    "texture",
    "material",
    "scene",
];

/// The file with all bounds.
const BOUNDS: &str = "math/error_bounds.rs";

/// Literals above this are lengths, shares and counts; below it they could be tolerances.
const SMALLEST: f64 = 1e-3;

/// Names and calls that make small numbers without a literal.
const SMALL_WORDS: [&str; 8] = [
    "EPSILON",
    "MIN_POSITIVE",
    "from_bits(",
    "powi(-",
    "powf(-",
    "exp(-",
    "exp2(-",
    "pow(10.0, -",
];

/// A line that may hold a small number.
struct Allowed {
    file: &'static str,
    line: &'static str,
    /// Why it is not an epsilon.
    reason: &'static str,
}

const ALLOWED: [Allowed; 9] = [
    Allowed {
        file: "math/error_bounds.rs",
        line: "pub const UNIT: f64 = f64::EPSILON / 2.0;",
        reason: "the largest relative rounding: all proven bounds are multiples of it",
    },
    Allowed {
        file: "math/error_bounds.rs",
        line: "pub(crate) const UNDERFLOW: f64 = f64::MIN_POSITIVE;",
        reason: "below it products lose bits; such values are always decided exactly",
    },
    Allowed {
        file: "math/ray.rs",
        line: "(dir.length_squared() - 1.0).abs() < 16.0 * f64::EPSILON",
        reason: "a debug assertion about the caller; release builds do not ask",
    },
    Allowed {
        file: "math/crossing.rs",
        line: "const SMALLEST: f64 = f64::from_bits(1);",
        reason: "a distance that is known to be above zero stays so when it is rounded",
    },
    Allowed {
        file: "geometry/chord.rs",
        line: "t.max(f64::from_bits(1))",
        reason: "a distance that is known to be above zero stays so when it is rounded",
    },
    Allowed {
        file: "math/vector.rs",
        line: "let middle = 2f64.powi(-400)..2f64.powi(400);",
        reason: "outside of it squares overflow; vectors are scaled by a power of two first",
    },
    Allowed {
        file: "math/vector.rs",
        line: "vector * 2f64.powi(-600)",
        reason: "that power of two; scaling by it is exact",
    },
    Allowed {
        file: "scene/lighting.rs",
        line: "divisor.max(f64::MIN_POSITIVE)",
        reason: "a light on the surface is as bright as a number can be, not infinite",
    },
    Allowed {
        file: "scene/render_settings.rs",
        line: "cut_off: 0.000_98,",
        reason: "the default of `cut-off`, a setting of the user",
    },
];

#[test]
fn no_number_stands_for_nearly_zero() {
    let mut complaints = Vec::new();
    let mut used = [false; ALLOWED.len()];
    for (file, source) in sources() {
        for line in small_numbers(&source) {
            let allowed = |allowed: &Allowed| file == allowed.file && line == allowed.line;
            match ALLOWED.iter().position(allowed) {
                Some(index) => used[index] = true,
                None => complaints.push(format!("src/{file}: {line}")),
            }
        }
    }
    for (allowed, used) in ALLOWED.iter().zip(used) {
        if !used {
            let Allowed { file, line, reason } = allowed;
            complaints.push(format!("src/{file} has no longer: {line} ({reason})"));
        }
    }
    let count = complaints.len();
    assert!(count == 0, "\n{}\n{count} in all\n", complaints.join("\n"));
}

#[test]
fn the_scan_knows_small_numbers_in_any_dress() {
    for small in [
        "if t > 1e-9 {",
        "t > 1E-9",
        "let nearly = 0.000_1;",
        "t - 0.0005_f64",
        "1.0e-4f64",
        "t.abs() < f64::EPSILON",
        "x.max(f64::MIN_POSITIVE)",
        "2f64.powi(-20)",
        "t < 1.0 / 4096.0",
        "1f64/1e6",
        "f64::from_bits(7)",
        "x < 1e-30 // it's \"nothing\"",
        "let a: &'static str = \"\"; let b = 1e-9;",
        "let c = '\"'; let d = 1e-9;",
        "let c = ['\\'', '\\\\', '\"']; let d = 1e-9;",
    ] {
        assert_eq!(small_numbers(small).len(), 1, "{small}");
    }
    for harmless in [
        "// below 1e-9",
        "/* 1e-9 */",
        "let text = \"1e-9\";",
        "let text = r#\"a \"1e-9\" b\"#;",
        "x * 0.5 - 0.0",
        "tuple.0.1e",
        "x / 1e9",
        "0.25..1.0",
        "let mask = 0x1e9;",
        "#[cfg(test)]\nmod tests {\n fn f() { if 1e-9 > 0.0 {} }\n}",
    ] {
        assert!(small_numbers(harmless).is_empty(), "{harmless}");
    }
    let behind = "#[cfg(test)]\nmod tests {\n { 1e-9; }\n}\nconst NEARLY: f64 = 1e-9;";
    assert_eq!(small_numbers(behind), ["const NEARLY: f64 = 1e-9;"]);
}

/// The table in `docs/numerics.md` has every bound of `math/error_bounds.rs` with its factor.
#[test]
fn the_document_has_all_bounds() {
    let page = fs::read_to_string(repository("docs/numerics.md")).expect("the page");
    let bounds = fs::read_to_string(repository("src/math/error_bounds.rs")).expect("the bounds");
    let mut count = 0;
    for line in bounds.lines() {
        let Some((name, factor)) = line
            .strip_prefix("pub(crate) const ")
            .and_then(|rest| rest.strip_suffix(".0 * UNIT;"))
            .and_then(|rest| rest.split_once(": f64 = "))
        else {
            continue;
        };
        count += 1;
        let told = page.lines().any(|row| {
            row.starts_with('|') && row.contains(&format!("`{name}`")) && {
                row.contains(&format!("| {factor} u "))
            }
        });
        assert!(
            told,
            "docs/numerics.md does not say that {name} is {factor} u"
        );
    }
    assert!(count >= 5, "only {count} bounds were found");
}

/// Every multiple of the unit roundoff has a name in one file.
#[test]
fn all_bounds_stand_in_one_file() {
    let root = repository("src");
    let mut complaints = Vec::new();
    for (path, source) in files::sources(&root) {
        let place = with_slashes(path.strip_prefix(&root).expect("a path in src"));
        if place == BOUNDS {
            continue;
        }
        let code = without_tests(&code_of(&source));
        let multiples = code.lines().filter(|line| has_multiple_of_unit(line));
        complaints.extend(multiples.map(|line| format!("src/{place}: {}", line.trim())));
    }
    assert!(
        complaints.is_empty(),
        "bounds outside of src/{BOUNDS}:\n{}",
        complaints.join("\n")
    );
}

#[test]
fn the_scan_finds_multiples_of_the_unit_roundoff() {
    for multiple in [
        "const BOUND: f64 = 4.0 * UNIT;",
        "size * 4.0 * crate::math::UNIT",
        "bound + UNIT * size",
        "size / UNIT",
    ] {
        assert!(has_multiple_of_unit(multiple), "{multiple}");
    }
    for harmless in [
        "pub use error_bounds::UNIT;",
        "const UNITS: [&str; 6] = [];",
        "4.0 * UNITS",
        "SUB_UNIT * 4.0",
    ] {
        assert!(!has_multiple_of_unit(harmless), "{harmless}");
    }
}

/// Whether a line of code multiplies or divides by the unit roundoff.
fn has_multiple_of_unit(line: &str) -> bool {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    line.match_indices("UNIT").any(|(start, name)| {
        let (before, after) = (&line[..start], &line[start + name.len()..]);
        if before.ends_with(is_word) || after.starts_with(is_word) {
            return false;
        }
        // Without the path that may stand before the name.
        let before = before.trim_end_matches(|c: char| is_word(c) || c == ':');
        let times = |c: char| c == '*' || c == '/';
        before.trim_end().ends_with(times) || after.trim_start().starts_with(times)
    })
}

/// The sources of all rooms but the classic back ends, by their places below `src`.
fn sources() -> Vec<(String, String)> {
    let root = repository("src");
    let sources = ROOMS
        .iter()
        .flat_map(|room| files::sources(root.join(room)));
    let sources = sources.map(|(path, text)| {
        let place = path.strip_prefix(&root).expect("a path in src");
        (with_slashes(place), text)
    });
    let sources: Vec<_> = sources
        .filter(|(place, _)| !place.contains("/classic/"))
        .collect();
    assert!(sources.len() > 40, "the sources were not found");
    sources
}

/// The lines of a source's code, trimmed, that hold a small number.
fn small_numbers(source: &str) -> Vec<String> {
    let code = without_tests(&code_of(source));
    let small = code.lines().filter(|line| {
        SMALL_WORDS.iter().any(|word| line.contains(word)) || has_small_literal(line)
    });
    small.map(|line| line.trim().to_owned()).collect()
}

/// Whether a line of code has a small literal, or a quotient of two that is small.
fn has_small_literal(line: &str) -> bool {
    let is_small = |number: f64| number > 0.0 && number < SMALLEST;
    let mut rest = line;
    let mut dividend = None;
    while let Some(start) = rest.find(|c: char| c.is_ascii_alphanumeric() || c == '_') {
        let between = rest[..start].trim();
        let (word, number, after) = next_word(&rest[start..]);
        // After a dot comes a field of a tuple.
        let number =
            number.filter(|_| !rest[..start].ends_with('.') || rest[..start].ends_with(".."));
        if let Some(number) = number {
            let quotient = dividend
                .filter(|_| between == "/")
                .map(|dividend: f64| dividend / number);
            if is_small(number) || quotient.is_some_and(is_small) {
                return true;
            }
        }
        debug_assert!(!word.is_empty(), "a word has letters");
        dividend = number;
        rest = after;
    }
    false
}

/// The word or number that a text starts with, the number's value, and what follows.
fn next_word(text: &str) -> (&str, Option<f64>, &str) {
    let bytes = text.as_bytes();
    let is_word = |c: u8| c.is_ascii_alphanumeric() || c == b'_';
    let mut end = bytes.iter().take_while(|c| is_word(**c)).count();
    let is_number = bytes[0].is_ascii_digit();
    let digit_at = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    if is_number {
        if bytes.get(end) == Some(&b'.') && digit_at(end + 1) {
            end += 1;
            end += bytes[end..].iter().take_while(|c| is_word(**c)).count();
        }
        // The sign of an exponent.
        let exponent = matches!(bytes[end - 1], b'e' | b'E') && !text.starts_with("0x");
        if exponent && bytes.get(end) == Some(&b'-') && digit_at(end + 1) {
            end += 1;
            end += bytes[end..].iter().take_while(|c| is_word(**c)).count();
        }
    }
    let (word, after) = text.split_at(end);
    let plain = word.replace('_', "");
    let plain = plain.trim_end_matches("f64").trim_end_matches("f32");
    let number = plain.parse().ok().filter(|_| is_number);
    (word, number, after)
}
