//! Names in Rust code, without comments and texts.

use std::collections::BTreeSet;

use crate::code::code_of;

/// All names in a piece of code.
pub(crate) fn identifiers(source: &str) -> BTreeSet<String> {
    let code = code_of(source);
    let words = code.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
    let names = words.filter(|word| {
        !word.is_empty() && !word.starts_with(|letter: char| letter.is_ascii_digit())
    });
    names.map(str::to_owned).collect()
}

#[test]
fn names_are_found_in_code_only() {
    let source = r##"
        /// Comment::of
        fn one<'a>(two: &'a str) -> char { /* three */
            let four = "five \" six"; let seven = r#"eight " nine"#; let ten = b"eleven";
            if four == '\'' || seven == '"' { twelve("thirteen", 14) } else { 'x' }
        }
    "##;
    let found = identifiers(source);
    let found: Vec<_> = found.iter().map(String::as_str).collect();
    let expected = [
        "a", "b", "char", "else", "fn", "four", "if", "let", "one", "seven", "str", "ten",
        "twelve", "two",
    ];
    assert_eq!(found, expected);
}
