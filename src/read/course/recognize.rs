//! Recognition of the course's block grammar.

/// Attributes and entities that only the course's scenes have.
const COURSE_WORDS: &[&str] = &[
    "pixeldim",
    "worlddim",
    "fplane",
    "tiled_plane",
    "texplane",
    "pplane",
    "psphere",
    "pfplane",
    "hplane",
    "revsurf",
    "tri",
    "altmaterial",
    "texname",
    "filename",
];

/// Nodes of which each KDL scene has at least one.
const KDL_WORDS: &[&str] = &["image", "include"];

/// True if a text is written in the block grammar.
///
/// It depends on words that begin a statement: after the start of a line, a brace or a semicolon.
pub(in crate::read) fn looks_like(text: &str) -> bool {
    let words = words(text);
    let begins_with = |known: &[&str], [word, next, _]: [&str; 3]| {
        known.contains(&word) && !next.is_empty() && next != "{"
    };
    if statements(&words).any(|statement| begins_with(KDL_WORDS, statement)) {
        return false;
    }
    statements(&words).any(|[word, next, after]| {
        let has_bare_name = !(next.is_empty() || next.starts_with(['{', '"', '#']));
        match word {
            // In KDL a camera has no name, and a texture no braces.
            "camera" => has_bare_name,
            "texture" => has_bare_name && after == "{",
            other => COURSE_WORDS.contains(&other),
        }
    })
}

/// The first three words of each statement, empty if there are fewer.
fn statements<'a>(words: &'a [Word<'a>]) -> impl Iterator<Item = [&'a str; 3]> {
    words
        .iter()
        .enumerate()
        .filter(|(_, word)| word.begins)
        .map(|(index, word)| {
            let same_statement = |index: usize| {
                let word = words.get(index).filter(|word| !word.begins);
                word.map_or("", |word| word.text)
            };
            [
                word.text,
                same_statement(index + 1),
                same_statement(index + 2),
            ]
        })
}

/// A word, a brace, or a quote in place of a string.
#[derive(Debug, Clone, Copy)]
struct Word<'a> {
    text: &'a str,
    /// True if it begins a statement of KDL.
    begins: bool,
}

impl Word<'_> {
    const STRING: Self = Self {
        text: "\"",
        begins: false,
    };
    const BRACE: Self = Self {
        text: "{",
        begins: false,
    };
}

/// The words of a text, without KDL comments and the contents of strings.
fn words(text: &str) -> Vec<Word<'_>> {
    let mut words = Vec::new();
    let (mut rest, mut begins) = (text, true);
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if let Some(inside) = rest.strip_prefix("\"\"\"") {
            words.push(Word::STRING);
            inside.find("\"\"\"").map_or(rest.len(), |end| end + 6)
        } else if first == '"' {
            words.push(Word::STRING);
            match rest[1..].find(['"', '\n']) {
                Some(end) if rest[1 + end..].starts_with('"') => end + 2,
                Some(end) => end + 1,
                None => rest.len(),
            }
        } else if first.is_whitespace() || matches!(first, '{' | '}' | ';') {
            if first == '{' {
                words.push(Word::BRACE);
            }
            begins |= matches!(first, '\n' | '{' | '}' | ';');
            first.len_utf8()
        } else {
            let ends = |character: char| {
                character.is_whitespace() || matches!(character, '{' | '}' | ';' | '"')
            };
            let length = rest.find(ends).unwrap_or(rest.len());
            words.push(Word {
                text: &rest[..length],
                begins,
            });
            begins = false;
            length
        };
        rest = &rest[length..];
    }
    words
}

#[cfg(test)]
mod tests {
    use super::looks_like;

    #[track_caller]
    fn course(text: &str) {
        assert!(looks_like(text), "taken for KDL: {text}");
    }

    #[track_caller]
    fn kdl(text: &str) {
        assert!(!looks_like(text), "taken for a course scene: {text}");
    }

    #[test]
    fn course_scenes_are_recognised_even_with_mistakes() {
        course("camera cam1 {");
        course("camera cam1\n{\n pixeldim 8 6\n}");
        course("camera{pixeldim 800 600}");
        course("cammera c {\n  viewpoint 4 3 8\n  worlddim 8 6\n}");
        course("light l { location 0 0 0 }\ntexture oak {\n}");
        course("fplane f{");
        course("# a comment\ncamera cam1 { viewpoint 4 3 8 worlddim 8 6 pixeldim 8 6 }");
        course("material \"oak {\ncamera cam1 {");
    }

    #[test]
    fn kdl_scenes_are_never_mistaken() {
        kdl("");
        kdl("image 8 6\ncamera { viewpoint 4 3 8; screen 8 6 }");
        kdl("// camera cam1 { pixeldim 8 6 }\nmaterial oak {\n ambient 1\n}");
        kdl("/* pixeldim */ camera { screen 8 6 }");
        kdl("camera {\n    screen 8 6\n}\nmaterial fplane {\n}\nplane texplane {\n}");
        kdl("texture \"oak\" \"oak.ppm\"\ntexture brick brick.png divisor=256");
        kdl("material \"a\ntexplane\" {\n}\ncamera /* none */ {\n}\nimage 8 6");
        kdl("image 8 6\ncamera { pixeldim 8 6 }");
        kdl("include \"parts.kdl\"\ncamera cam1 {\n}");
        kdl("light l \"\"\"\npixeldim\n\"\"\"");
    }
}
