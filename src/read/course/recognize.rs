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
    let statements = statements(text);
    let mut heads = statements.iter().map(|statement| {
        let word = |index: usize| statement.get(index).copied().unwrap_or_default();
        [word(0), word(1), word(2)]
    });
    let is_kdl =
        |[word, next, _]: [&str; 3]| KDL_WORDS.contains(&word) && !next.is_empty() && next != "{";
    let is_course = |[word, next, after]: [&str; 3]| {
        let has_bare_name = !(next.is_empty() || next.starts_with(['{', '"', '#']));
        match word {
            // In KDL a camera has no name, and a texture no braces.
            "camera" => has_bare_name,
            "texture" => has_bare_name && after == "{",
            other => COURSE_WORDS.contains(&other),
        }
    };
    !heads.clone().any(is_kdl) && heads.any(is_course)
}

/// The words of each statement, without KDL comments.
///
/// A quote replaces a string, which begins no statement, and braces are words.
fn statements(text: &str) -> Vec<Vec<&str>> {
    let mut statements: Vec<Vec<&str>> = Vec::new();
    let (mut rest, mut begins) = (text, true);
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if let Some(inside) = rest.strip_prefix("\"\"\"") {
            add(&mut statements, "\"");
            inside.find("\"\"\"").map_or(rest.len(), |end| end + 6)
        } else if first == '"' {
            add(&mut statements, "\"");
            match rest[1..].find(['"', '\n']) {
                Some(end) if rest[1 + end..].starts_with('"') => end + 2,
                Some(end) => end + 1,
                None => rest.len(),
            }
        } else if first.is_whitespace() || matches!(first, '{' | '}' | ';') {
            if first == '{' {
                add(&mut statements, "{");
            }
            begins |= matches!(first, '\n' | '{' | '}' | ';');
            first.len_utf8()
        } else {
            let ends = |character: char| {
                character.is_whitespace() || matches!(character, '{' | '}' | ';' | '"')
            };
            let length = rest.find(ends).unwrap_or(rest.len());
            if begins {
                statements.push(Vec::new());
            }
            add(&mut statements, &rest[..length]);
            begins = false;
            length
        };
        rest = &rest[length..];
    }
    statements
}

/// Adds a word to the last statement, if there is one.
fn add<'a>(statements: &mut [Vec<&'a str>], word: &'a str) {
    if let Some(last) = statements.last_mut() {
        last.push(word);
    }
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
