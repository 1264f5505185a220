//! Code in documents: paths, names and commands, told apart by their looks.

/// Folders of the repository in which a path can begin.
const FOLDERS: [&str; 10] = [
    "src", "tests", "docs", "scenes", "benches", "examples", "oracle", "tools", "textures", ".ci",
];

/// Endings of files that a document can name.
const ENDINGS: [&str; 8] = [
    ".rs", ".md", ".kdl", ".png", ".ppm", ".svg", ".toml", ".json",
];

/// The kinds of code that are checked.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// A file or folder.
    Path,
    /// A command, or options alone.
    Command,
    /// A name in Rust code, or a path of such names.
    Name,
    /// Anything else, such as a word of the scene language.
    Other,
}

/// The kind of a code span; `commands` are the words that can follow `heliodon`.
pub(crate) fn shape(code: &str, commands: &[String]) -> Shape {
    let first = code.split(' ').next().unwrap_or_default();
    let is_command = first.starts_with("--") || commands.iter().any(|command| command == first);
    if first == "heliodon" || code.contains(" --") && is_command || first.starts_with("--") {
        Shape::Command
    } else if code.contains([' ', '<', '"', '…', '{', '=', '[']) {
        Shape::Other
    } else if is_path(code) {
        Shape::Path
    } else if is_name(code) {
        Shape::Name
    } else {
        Shape::Other
    }
}

/// Whether a word is a file or a folder: by its ending, or by the folder that it begins with.
fn is_path(word: &str) -> bool {
    is_below_root(word) || has_ending(word)
}

/// Whether a word is a path that begins with a folder of the repository.
pub(crate) fn is_below_root(word: &str) -> bool {
    FOLDERS
        .iter()
        .any(|folder| word.starts_with(&format!("{folder}/")))
}

/// Whether a word ends as a file does; an ending alone is no file.
pub(crate) fn has_ending(word: &str) -> bool {
    let stems = ENDINGS
        .iter()
        .filter_map(|ending| word.strip_suffix(ending));
    stems
        .into_iter()
        .any(|stem| !stem.is_empty() && !stem.ends_with('/'))
}

/// The names that a path such as `Hit.uv`, `Wrap::index` or `hits()` is made of.
pub(crate) fn names(code: &str) -> Vec<&str> {
    let path = code.trim_end_matches("()");
    path.split("::").flat_map(|part| part.split('.')).collect()
}

fn is_name(code: &str) -> bool {
    let parts = names(code);
    let is_word = |part: &&str| {
        let all = part
            .chars()
            .all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
        all && !part.is_empty() && !part.starts_with(|letter: char| letter.is_ascii_digit())
    };
    let is_upper = code.len() > 2 && code.starts_with(|letter: char| letter.is_ascii_uppercase());
    parts.iter().all(is_word)
        && (is_upper || code.contains("::") || code.contains('_') || code.ends_with("()"))
}

/// The options in a command, each with the byte at which it begins; those of cargo do not count.
pub(crate) fn options(command: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut at = match command.find(" -- ") {
        Some(at) => at + " -- ".len(),
        None if command.starts_with("cargo ") => command.len(),
        None => 0,
    };
    while let Some(start) = command[at..].find("--").map(|found| at + found) {
        let is_start = start == 0 || command[..start].ends_with([' ', '(', '[', '|', '\n']);
        let rest = &command[start + 2..];
        let is_end = |letter: char| !letter.is_ascii_alphanumeric() && letter != '-';
        at = start + 2 + rest.find(is_end).unwrap_or(rest.len());
        if is_start && at > start + 2 {
            found.push((start, &command[start..at]));
        }
    }
    found
}

#[test]
fn code_is_told_apart_by_its_looks() {
    let commands = ["render".to_owned()];
    for (code, expected) in [
        ("src/lib.rs", Shape::Path),
        ("tests/plan", Shape::Path),
        ("band.rs", Shape::Path),
        (".png", Shape::Other),
        ("math/exact", Shape::Other),
        ("Surface", Shape::Name),
        ("Hit.uv", Shape::Name),
        ("Wrap::index", Shape::Name),
        ("hits()", Shape::Name),
        ("dump_obj", Shape::Name),
        ("FOOT", Shape::Name),
        ("u", Shape::Other),
        ("E", Shape::Other),
        ("texture-filter", Shape::Other),
        ("getamb", Shape::Other),
        ("--size 80x60", Shape::Command),
        ("render --stats", Shape::Command),
        ("heliodon check", Shape::Command),
        ("git log --all", Shape::Other),
        ("camera { … }", Shape::Other),
    ] {
        assert_eq!(shape(code, &commands), expected, "{code}");
    }
    assert_eq!(names("a::B::c()"), ["a", "B", "c"]);
    assert_eq!(names("Hit.uv"), ["Hit", "uv"]);
}

#[test]
fn options_are_found() {
    let words = |command| {
        options(command)
            .into_iter()
            .map(|(_, word)| word)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        words("render a--b.kdl --size 80x60 [--cut-off=1]"),
        ["--size", "--cut-off"]
    );
    assert_eq!(words("cargo run --release -- render --stats"), ["--stats"]);
    assert_eq!(words("cargo test --release"), [""; 0]);
    assert_eq!(words("a -- b"), [""; 0]);
    assert_eq!(options("x --y")[0].0, 2);
}
