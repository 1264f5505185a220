//! All that a document can refer to.

use std::collections::{BTreeMap, BTreeSet};

use support::shell::heliodon;

use super::files::{self, File};
use super::identifiers::identifiers;
use super::references::anchors;

/// What is there: files, headings, names in code, commands and options.
pub(crate) struct Known {
    /// Files and folders, from the root.
    pub(crate) paths: BTreeSet<String>,
    /// The anchors of each document.
    pub(crate) anchors: BTreeMap<String, BTreeSet<String>>,
    /// The names in each file of `src`.
    pub(crate) sources: Vec<BTreeSet<String>>,
    /// The test programs.
    pub(crate) tests: BTreeSet<String>,
    /// The names in the tests.
    pub(crate) test_names: BTreeSet<String>,
    /// The variables of the environment that tests and programs read.
    pub(crate) variables: BTreeSet<String>,
    /// The commands of Heliodon.
    pub(crate) commands: Vec<String>,
    /// The options of Heliodon and of the tools, with their dashes.
    pub(crate) options: BTreeSet<String>,
}

impl Known {
    /// What the repository has.
    pub(crate) fn collect(documents: &[File]) -> Self {
        let names = |files: &[File]| {
            files
                .iter()
                .map(|file| identifiers(&file.text))
                .collect::<Vec<_>>()
        };
        let (sources, tests) = (files::rust("src"), files::rust("tests"));
        let tools: Vec<_> = ["examples", "tools"]
            .into_iter()
            .flat_map(files::rust)
            .collect();
        let (commands, mut options) = command_line();
        options.extend(tools.iter().flat_map(|file| options_of_clap(&file.text)));
        Self {
            paths: files::all_paths(),
            anchors: documents
                .iter()
                .map(|file| (file.path.clone(), anchors(&file.text)))
                .collect(),
            sources: names(&sources),
            tests: tests
                .iter()
                .filter_map(|file| test_program(&file.path))
                .collect(),
            test_names: names(&tests).into_iter().flatten().collect(),
            variables: [&sources, &tests, &tools]
                .into_iter()
                .flatten()
                .flat_map(|file| variables(&file.text))
                .collect(),
            commands,
            options,
        }
    }

    /// A few things for a test.
    pub(crate) fn example(page: &File) -> Self {
        let set = |words: &str| words.split(' ').map(str::to_owned).collect::<BTreeSet<_>>();
        Self {
            paths: set("docs docs/page.md scenes scenes/room.kdl src src/lib.rs"),
            anchors: [(page.path.clone(), anchors(&page.text))]
                .into_iter()
                .collect(),
            sources: vec![set("Ray new"), set("other")],
            tests: set("lineage"),
            test_names: set("keeps"),
            variables: set("HELIODON_UPDATE"),
            commands: vec!["render".to_owned()],
            options: set("--size"),
        }
    }
}

/// The name of a test program, if a path is that of one.
fn test_program(path: &str) -> Option<String> {
    let name = path.strip_prefix("tests/")?.strip_suffix("/main.rs")?;
    (!name.contains('/')).then(|| name.to_owned())
}

/// The words in a source that name variables of the environment.
fn variables(source: &str) -> Vec<String> {
    let words = source.split(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_');
    words
        .filter(|word| word.starts_with("HELIODON_"))
        .map(str::to_owned)
        .collect()
}

/// The commands of the program and the options of all of them, by its own help.
fn command_line() -> (Vec<String>, BTreeSet<String>) {
    let help = |arguments: &[&str]| heliodon(arguments).stdout_text().to_owned();
    let front = help(&["--help"]);
    let commands = commands_in_help(&front);
    let mut options = options_in_help(&front);
    for command in &commands {
        options.extend(options_in_help(&help(&[command.as_str(), "--help"])));
    }
    (commands, options)
}

/// The first words of the lines below `Commands:`.
fn commands_in_help(help: &str) -> Vec<String> {
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let lines = lines.take_while(|line| !line.trim().is_empty());
    let names = lines.filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    names
        .filter(|name| !name.is_empty())
        .map(str::to_owned)
        .collect()
}

/// The options at the beginnings of lines, as in `  -q, --quiet`.
fn options_in_help(help: &str) -> BTreeSet<String> {
    let lines = help
        .lines()
        .map(str::trim)
        .filter(|line| line.starts_with('-'));
    let words = lines.flat_map(|line| line.split([' ', ',']).take(3));
    words
        .filter(|word| word.starts_with("--"))
        .map(str::to_owned)
        .collect()
}

/// The options of a source that are fields with `#[arg(long …)]`.
fn options_of_clap(source: &str) -> Vec<String> {
    let mut found = vec!["--help".to_owned()];
    let mut is_option = false;
    for line in source.lines().map(str::trim) {
        if let Some(attribute) = line.strip_prefix("#[arg(") {
            is_option = attribute.contains("long");
        } else if is_option && let Some((name, _)) = line.split_once(':') {
            let name = name.rsplit(' ').next().unwrap_or_default();
            found.push(format!("--{}", name.replace('_', "-")));
            is_option = false;
        }
    }
    found
}

#[test]
fn help_names_commands_and_options() {
    let help = "Usage: x\n\nCommands:\n  render   Renders\n  help     Print --this\n\nOptions:\n  -q, --quiet\n      \
                --color <WHEN>  When --not\n          - a: b\n";
    assert_eq!(commands_in_help(help), ["render", "help"]);
    let options = options_in_help(help);
    assert_eq!(
        options.iter().map(String::as_str).collect::<Vec<_>>(),
        ["--color", "--quiet"]
    );
}

#[test]
fn clap_names_options() {
    let source = "#[arg(required = true)]\nscenes: X,\n/// More.\n#[arg(long, default_value = \"a\")]\npub(crate) max_error: f64,\nlong: y,";
    assert_eq!(options_of_clap(source), ["--help", "--max-error"]);
}

#[test]
fn variables_and_tests_are_named() {
    assert_eq!(
        variables("var(\"HELIODON_UPDATE\") X_HELIODON_Y"),
        ["HELIODON_UPDATE"]
    );
    assert_eq!(
        test_program("tests/house/main.rs"),
        Some("house".to_owned())
    );
    assert_eq!(test_program("tests/house/layers.rs"), None);
}
