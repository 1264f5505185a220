//! References from documents to files, headings, names in code, commands and options.

use std::collections::BTreeSet;

use super::blocks::{Block, Kind, blocks_of};
use super::files::File;
use super::inline::{code_spans, targets, words_alone};
use super::known::Known;
use super::shapes::{Shape, has_ending, is_below_root, names, options, shape};

/// Names that documents use though the code has none such: the chapter's, and those of libraries.
const KNOWN_NAMES: [&str; 14] = [
    // The chapter's own.
    "CLAMP",
    "REPEAT",
    "dump_obj",
    "fplane_t",
    "light_visible",
    "pix_x_size",
    "pix_y_size",
    "plane_t",
    "set_pixsize",
    "texplane_t",
    "texture_t",
    "vl_mult3",
    // Of the standard library and of file formats.
    "NaN",
    "std",
];

/// Files that a reader would have or make.
const READERS_FILES: [&str; 2] = ["scene.kdl", "room.png"];

/// The faults of a document, each with its place.
pub(crate) fn faults(file: &File, known: &Known) -> Vec<String> {
    let blocks = blocks_of(&file.text);
    let page = Page {
        path: &file.path,
        made: files_in_code(&blocks),
        known,
    };
    let mut faults = Vec::new();
    for block in &blocks {
        let found = if block.kind == Kind::Code {
            page.in_code(block)
        } else {
            page.in_text(block)
        };
        let lines = found
            .into_iter()
            .map(|(at, what)| format!("{}:{}: {what}", file.path, block.line_at(at)));
        faults.extend(lines);
    }
    faults
}

/// A fault and the byte of the block's text at which it stands.
type Fault = (usize, String);

/// A document that is checked.
struct Page<'a> {
    path: &'a str,
    /// Files that the page's own commands make or read.
    made: BTreeSet<String>,
    known: &'a Known,
}

impl Page<'_> {
    fn in_text(&self, block: &Block) -> Vec<Fault> {
        let links = targets(&block.text).into_iter();
        let links = links.filter_map(|link| Some((link.offset, self.fault_of_link(link.text)?)));
        let spans = code_spans(&block.text).into_iter();
        let spans = spans.filter_map(|span| {
            Some((
                span.offset,
                self.fault_of_span(&span.text.replace('\n', " "))?,
            ))
        });
        links.chain(spans).collect()
    }

    /// The faults in commands of Heliodon that a block for a shell shows.
    fn in_code(&self, block: &Block) -> Vec<Fault> {
        let mut faults = Vec::new();
        let mut start = 0;
        let language = block.text.lines().next().unwrap_or_default().trim();
        let is_shell = ["sh", "bash", "console"].contains(&language);
        for line in block.text.split_inclusive('\n').filter(|_| is_shell) {
            let command = line.trim_start_matches("$ ");
            if command.starts_with("heliodon ") || command.starts_with("cargo run ") {
                faults.extend(self.fault_of_command(command).map(|fault| (start, fault)));
            }
            start += line.len();
        }
        faults
    }

    fn fault_of_link(&self, target: &str) -> Option<String> {
        if target.contains("://") || target.starts_with("mailto:") {
            return None;
        }
        let (path, anchor) = match target.split_once('#') {
            Some((path, anchor)) => (path, Some(anchor)),
            None => (target, None),
        };
        let path = if path.is_empty() {
            self.path.to_owned()
        } else {
            beside(self.path, path)
        };
        if !self.known.paths.contains(path.trim_end_matches('/')) {
            return Some(format!("the link to {target} leads nowhere"));
        }
        let anchor = anchor?;
        let has = self
            .known
            .anchors
            .get(&path)
            .is_some_and(|anchors| anchors.contains(anchor));
        (!has).then(|| format!("{path} has no heading for #{anchor}"))
    }

    fn fault_of_span(&self, code: &str) -> Option<String> {
        match shape(code, &self.known.commands) {
            Shape::Path => self.fault_of_path(code),
            Shape::Command => self.fault_of_command(code),
            Shape::Name => self.fault_of_name(code),
            Shape::Other => None,
        }
    }

    fn fault_of_path(&self, path: &str) -> Option<String> {
        let bare = path.trim_end_matches('/');
        let places = [bare.to_owned(), beside(self.path, bare)];
        let paths = &self.known.paths;
        let exists = match bare.split_once('*') {
            Some((_, end)) => places.iter().any(|place| {
                let start = place.split('*').next().unwrap_or_default();
                paths
                    .iter()
                    .any(|path| path.starts_with(start) && path.ends_with(end))
            }),
            None => {
                let anywhere = format!("/{bare}");
                places.iter().any(|place| paths.contains(place))
                    || !bare.contains('/') && paths.iter().any(|path| path.ends_with(&anywhere))
            }
        };
        let is_readers = READERS_FILES.contains(&bare) || self.made.contains(bare);
        (!exists && !is_readers).then(|| format!("there is no file `{path}`"))
    }

    fn fault_of_command(&self, command: &str) -> Option<String> {
        let mut words = command.split_whitespace();
        let (first, second) = (words.next().unwrap_or_default(), words.next());
        if first == "heliodon"
            && let Some(word) = second.filter(|word| word.chars().all(char::is_alphabetic))
            && !self.known.commands.iter().any(|command| command == word)
        {
            return Some(format!("there is no command `heliodon {word}`"));
        }
        let mut options = options(command).into_iter();
        if let Some((_, option)) = options.find(|(_, option)| !self.known.options.contains(*option))
        {
            return Some(format!("there is no option `{option}`"));
        }
        let mut paths = command
            .split_whitespace()
            .filter(|word| is_below_root(word));
        paths.find_map(|path| self.fault_of_path(path))
    }

    fn fault_of_name(&self, code: &str) -> Option<String> {
        if code.starts_with("HELIODON_") {
            let known = self.known.variables.contains(code);
            return (!known).then(|| format!("no program reads `{code}`"));
        }
        let parts = names(code);
        let sources = &self.known.sources;
        let is_known = |name: &&str| {
            KNOWN_NAMES.contains(name) || sources.iter().any(|names| names.contains(*name))
        };
        let is_of_tests = self.known.tests.contains(parts[0]);
        let unknown = if is_of_tests {
            parts[1..]
                .iter()
                .find(|name| !self.known.test_names.contains(**name))
        } else {
            parts.iter().find(|name| !is_known(name))
        };
        if let Some(unknown) = unknown {
            return Some(format!("`{code}`: there is no `{unknown}` in the code"));
        }
        // What belongs to a type stands in a file that names the type.
        let [.., owner, member] = parts.as_slice() else {
            return None;
        };
        let is_type = owner.starts_with(|letter: char| letter.is_ascii_uppercase());
        let together = sources
            .iter()
            .any(|names| names.contains(*owner) && names.contains(*member));
        (is_type && !together)
            .then(|| format!("`{code}`: no file has both `{owner}` and `{member}`"))
    }
}

/// The anchors of a page: those that are written out, and those that GitHub makes of headings.
pub(crate) fn anchors(text: &str) -> BTreeSet<String> {
    let written = text.split("<a id=\"").skip(1);
    let written = written.filter_map(|rest| Some(rest.split_once('"')?.0.to_owned()));
    let mut anchors: BTreeSet<_> = written.collect();
    for block in blocks_of(text)
        .iter()
        .filter(|block| block.kind == Kind::Heading)
    {
        let heading = words_alone(&block.text.replace('`', "")).to_lowercase();
        let kept = heading
            .chars()
            .filter(|letter| letter.is_alphanumeric() || "-_ ".contains(*letter));
        let anchor = kept.collect::<String>().replace(' ', "-");
        let mut free = anchor.clone();
        let mut number = 0;
        while anchors.contains(&free) {
            number += 1;
            free = format!("{anchor}-{number}");
        }
        anchors.insert(free);
    }
    anchors
}

/// The words in a page's code that end as files do.
fn files_in_code(blocks: &[Block]) -> BTreeSet<String> {
    let code = blocks.iter().filter(|block| block.kind == Kind::Code);
    let is_end = |letter: char| letter.is_whitespace() || "\"',".contains(letter);
    let words = code.flat_map(|block| block.text.split(is_end));
    words
        .filter(|word| has_ending(word))
        .map(str::to_owned)
        .collect()
}

/// The path from the root of what a page names.
fn beside(page: &str, path: &str) -> String {
    let mut parts: Vec<_> = page.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            ".." => {
                parts.pop();
            }
            "." => {}
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[test]
fn paths_are_taken_from_the_page() {
    assert_eq!(beside("docs/a.md", "../src/b.rs"), "src/b.rs");
    assert_eq!(beside("a.md", "./b.md"), "b.md");
}

#[test]
fn headings_make_anchors() {
    let anchors = anchors("<a id=\"own\"></a>\n# The `camera`, moved\n\n## A – b\n\n## A – b\n");
    let anchors: Vec<_> = anchors.iter().map(String::as_str).collect();
    assert_eq!(anchors, ["a--b", "a--b-1", "own", "the-camera-moved"]);
}

#[test]
fn references_that_lead_nowhere_are_found() {
    let page = "# A page\n\n`src/lib.rs`, `gone.rs`, `lib.rs`, `scenes/*.kdl`, `scenes/*.txt`\n\
        `Ray`, `Gone`, `Ray::new`, `Ray::gone`, `Ray::other()`, `lineage::keeps`, `lineage::gone`\n\
        `--size`, `render --gone`, `heliodon gone`, `HELIODON_UPDATE`, `HELIODON_GONE`, `new.png`\n\
        [a](#a-page) [b](#gone) [c](../src) [d](gone.md) [e](https://x.y)\n\n\
        ```console\n$ heliodon render --gone -o new.png\n```\n";
    let file = File {
        path: "docs/page.md".to_owned(),
        text: page.to_owned(),
    };
    let found = faults(&file, &Known::example(&file));
    let expected = [
        "6: docs/page.md has no heading for #gone",
        "6: the link to gone.md leads nowhere",
        "3: there is no file `gone.rs`",
        "3: there is no file `scenes/*.txt`",
        "4: `Gone`: there is no `Gone` in the code",
        "4: `Ray::gone`: there is no `gone` in the code",
        "4: `Ray::other()`: no file has both `Ray` and `other`",
        "4: `lineage::gone`: there is no `gone` in the code",
        "5: there is no option `--gone`",
        "5: there is no command `heliodon gone`",
        "5: no program reads `HELIODON_GONE`",
        "9: there is no option `--gone`",
    ];
    let expected: Vec<_> = expected
        .iter()
        .map(|fault| format!("docs/page.md:{fault}"))
        .collect();
    assert_eq!(found, expected);
}
