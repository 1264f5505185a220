//! The graph of imports: which file of a crate names which others.
//!
//! A file's name is its module: `src/math/ray.rs` is `math::ray`, `src/math/mod.rs` is `math`. A
//! path that begins with `crate`, `super`, `self` or a submodule names a file. Declarations of
//! submodules and re-exports are no imports, nor is what a file takes from the `mod.rs` of its own
//! folder or of one around it.

use std::collections::{BTreeMap, BTreeSet};

use super::code::{code_of, without_tests};

/// The files of a crate by their modules.
#[derive(Debug)]
pub(crate) struct Files {
    files: BTreeMap<Path, File>,
}

/// The names of a path, the crate's own left out.
type Path = Vec<String>;

#[derive(Debug, Default)]
struct File {
    /// All names that are said to be somewhere else: by `use`, `pub use` included.
    aliases: Vec<Alias>,
    /// Paths that are named in code or imported, but not those that are only re-exported.
    named: Vec<Path>,
    /// The items that it declares.
    items: BTreeSet<String>,
}

/// What a name stands for that a file only re-exports.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ReExports {
    /// The file that re-exports it.
    Are,
    /// The file that declares it.
    StandFor,
}

/// `use PATH as NAME`, or `use PATH::*` without a name.
#[derive(Debug, Clone)]
struct Alias {
    name: Option<String>,
    path: Path,
}

/// Words before the name of an item.
const ITEMS: [&str; 8] = [
    "fn", "struct", "enum", "trait", "const", "static", "type", "union",
];

impl Files {
    /// The files of a crate, by their places below its `src` and with their texts.
    pub(crate) fn of<'a>(sources: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let sources = sources.into_iter();
        let files = sources.filter(|(place, _)| *place != "main.rs");
        let files = files.map(|(place, text)| {
            let module = module_of(place);
            let file = File::of(&module, &without_tests(&code_of(text)));
            (module, file)
        });
        Self {
            files: files.collect(),
        }
    }

    /// The names of all files, each with those of the files that it imports from.
    pub(crate) fn imports(&self, re_exports: ReExports) -> BTreeMap<String, BTreeSet<String>> {
        // Re-exports in a circle have no file.
        let steps = match re_exports {
            ReExports::Are => 0,
            ReExports::StandFor => 20,
        };
        let files = self.files.iter().map(|(module, file)| {
            let named = file.named.iter();
            let named = named.filter_map(|path| self.file_of(path, steps));
            let others = named.filter(|other| !module.starts_with(other));
            (module.join("::"), others.map(|it| it.join("::")).collect())
        });
        files.collect()
    }

    /// The file that has what a path names.
    ///
    /// At most so many re-exports are followed.
    fn file_of(&self, path: &[String], steps: u32) -> Option<&Path> {
        let length = (0..=path.len()).rev();
        let mut length = length.filter(|length| self.files.contains_key(&path[..*length]));
        let length = length.next()?;
        let (module, file) = self.files.get_key_value(&path[..length])?;
        let Some(name) = path.get(length) else {
            return Some(module);
        };
        if file.items.contains(name) || steps == 0 {
            return Some(module);
        }
        let rest = &path[length + 1..];
        let aliases = file.aliases.iter();
        let named = aliases.filter_map(|alias| match &alias.name {
            Some(alias_name) => (alias_name == name)
                .then(|| self.file_of(&[&alias.path, rest].concat(), steps - 1))?,
            None => {
                let path = [&alias.path, &path[length..]].concat();
                let found = self.file_of(&path, steps - 1)?;
                self.files[found].items.contains(name).then_some(found)
            }
        });
        let mut named = named;
        // A macro may declare submodules and re-export what is in them.
        named
            .next()
            .or_else(|| {
                let below = self
                    .files
                    .iter()
                    .filter(|(other, _)| other.len() == length + 1 && other.starts_with(module));
                let mut below = below.filter(|(_, file)| file.items.contains(name));
                below.next().map(|(other, _)| other)
            })
            .or(Some(module))
    }
}

/// The module of a file below `src`.
fn module_of(place: &str) -> Path {
    let place = place.strip_suffix(".rs").unwrap_or(place);
    let mut names: Vec<_> = place.split('/').map(str::to_owned).collect();
    if names.last().is_some_and(|name| name == "mod") || names == ["lib"] {
        names.pop();
    }
    names
}

impl File {
    fn of(module: &[String], code: &str) -> Self {
        let tokens = tokens(code);
        let mut file = Self::default();
        let submodules: BTreeSet<_> = tokens
            .windows(3)
            .filter(|it| it[0] == "mod" && it[2] == ";")
            .map(|it| it[1])
            .collect();
        let mut at = 0;
        while at < tokens.len() {
            let token = tokens[at];
            if token == "use" {
                let end = tokens[at..].iter().position(|token| *token == ";");
                let end = at + end.unwrap_or(tokens.len() - at);
                let exports = at > 0 && (tokens[at - 1] == "pub" || tokens[at - 1] == ")");
                let mut aliases = Vec::new();
                tree(&tokens[at + 1..end], &[], &mut aliases);
                for (names, alias) in aliases {
                    let Some(path) = absolute(module, &names, &submodules) else {
                        continue;
                    };
                    if !exports {
                        file.named.push(path.clone());
                    }
                    let name = (alias != "*").then(|| alias.to_owned());
                    file.aliases.push(Alias { name, path });
                }
                at = end;
            } else if ITEMS.contains(&token) && at + 1 < tokens.len() {
                file.items.insert(tokens[at + 1].to_owned());
            } else if is_name(token)
                && tokens.get(at + 1) == Some(&"::")
                && (at == 0 || tokens[at - 1] != "::")
            {
                let mut names = vec![token];
                while let (Some(&"::"), Some(name)) = (tokens.get(at + 1), tokens.get(at + 2)) {
                    if !is_name(name) {
                        break;
                    }
                    names.push(name);
                    at += 2;
                }
                file.named.extend(absolute(module, &names, &submodules));
            }
            at += 1;
        }
        file
    }
}

/// A path from the crate's root; `None` if it does not begin in this crate, as far as one sees.
fn absolute(module: &[String], names: &[&str], submodules: &BTreeSet<&str>) -> Option<Path> {
    let (mut path, mut rest) = match *names.first()? {
        "crate" => (Vec::new(), &names[1..]),
        "self" | "super" => (module.to_vec(), names),
        name if submodules.contains(name) => (module.to_vec(), names),
        _ => return None,
    };
    while let [word @ ("self" | "super"), after @ ..] = rest {
        if *word == "super" {
            path.pop()?;
        }
        rest = after;
    }
    path.extend(rest.iter().map(|name| (*name).to_owned()));
    Some(path)
}

/// All paths of a `use`, each with the name that it gets; `*` for all names.
fn tree<'a>(tokens: &[&'a str], before: &[&'a str], found: &mut Vec<(Vec<&'a str>, &'a str)>) {
    let mut path = before.to_vec();
    let mut rest = tokens;
    while let [name, after @ ..] = rest {
        match *name {
            "::" => {}
            "{" => {
                for part in parts(&after[..after.len() - 1]) {
                    tree(part, &path, found);
                }
                return;
            }
            "*" => return found.push((path, "*")),
            "as" => return found.push((path, after.first().copied().unwrap_or("_"))),
            "self" if !path.is_empty() => {}
            name => path.push(name),
        }
        rest = after;
    }
    if let Some(name) = path.last().copied().filter(|_| !tokens.is_empty()) {
        found.push((path, name));
    }
}

/// The parts between commas that are in no braces.
fn parts<'t, 'a>(tokens: &'t [&'a str]) -> Vec<&'t [&'a str]> {
    let mut depth = 0;
    let parts = tokens.split(|token| {
        match *token {
            "{" => depth += 1,
            "}" => depth -= 1,
            _ => {}
        }
        depth == 0 && *token == ","
    });
    parts.collect()
}

fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// The words and signs of code.
fn tokens(code: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = code.trim_start();
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let length = if is_word(first) {
            rest.find(|c| !is_word(c)).unwrap_or(rest.len())
        } else if rest.starts_with("::") {
            2
        } else {
            first.len_utf8()
        };
        tokens.push(&rest[..length]);
        rest = rest[length..].trim_start();
    }
    tokens
}

/// The groups of two and more files that all lead to each other.
pub(crate) fn circles(imports: &BTreeMap<String, BTreeSet<String>>) -> Vec<Vec<&str>> {
    let reached: BTreeMap<_, _> = imports
        .keys()
        .map(|file| (file.as_str(), reached_from(file, imports)))
        .collect();
    let mut circles: Vec<Vec<&str>> = Vec::new();
    for (file, others) in &reached {
        if circles.iter().flatten().any(|known| known == file) {
            continue;
        }
        let back = others.iter().filter(|other| reached[*other].contains(file));
        let circle: Vec<_> = back.copied().collect();
        if circle.len() > 1 {
            circles.push(circle);
        }
    }
    circles
}

/// All files that a file imports from, and those that these import from, and so on.
fn reached_from<'a>(
    file: &str,
    imports: &'a BTreeMap<String, BTreeSet<String>>,
) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::new();
    let mut next: Vec<_> = imports[file].iter().map(String::as_str).collect();
    while let Some(file) = next.pop() {
        if reached.insert(file) {
            next.extend(imports[file].iter().map(String::as_str));
        }
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The circles among files with these contents.
    fn circles_of(re_exports: ReExports, sources: &[(&str, &str)]) -> Vec<Vec<String>> {
        let imports = Files::of(sources.iter().copied()).imports(re_exports);
        let circles = circles(&imports);
        let owned = circles.iter().map(|circle| {
            let files = circle.iter().map(|file| (*file).to_owned());
            files.collect()
        });
        owned.collect()
    }

    #[test]
    fn files_that_lead_back_to_themselves_are_found() {
        let sources = [
            ("lib.rs", "pub mod room;"),
            ("room/mod.rs", "mod a; mod b; mod c; mod d;"),
            ("room/a.rs", "use super::b::{self, B};"),
            ("room/b.rs", "fn f() { super::c::g() }"),
            ("room/c.rs", "use crate::{room::{a as one}};"),
            ("room/d.rs", "use super::a; // use super::d in a.rs"),
        ];
        let expected = [["room::a", "room::b", "room::c"]];
        assert_eq!(circles_of(ReExports::Are, &sources), expected);
    }

    #[test]
    fn what_is_only_in_comments_texts_and_tests_is_no_import() {
        let sources = [
            ("a.rs", "use crate::b::B;"),
            (
                "b.rs",
                "//! use crate::a;\nconst T: &str = \"crate::a\";\n\
                 #[cfg(test)]\nmod tests { use crate::a; }",
            ),
        ];
        assert!(circles_of(ReExports::Are, &sources).is_empty());
    }

    #[test]
    fn names_that_are_re_exported_lead_to_their_files_if_asked_for() {
        let sources = [
            ("room/mod.rs", "mod a; mod b; pub use a::A; pub use b::*;"),
            ("room/a.rs", "use super::B; pub struct A;"),
            ("room/b.rs", "use crate::room::A; pub struct B;"),
        ];
        assert!(circles_of(ReExports::Are, &sources).is_empty());
        let expected = [["room::a", "room::b"]];
        assert_eq!(circles_of(ReExports::StandFor, &sources), expected);
    }
}
