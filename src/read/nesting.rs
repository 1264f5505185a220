//! How deep a KDL text is nested, found without recursion.
//!
//! The `kdl` crate descends into braces and block comments by recursion, so a text of a few
//! thousand of them would overflow the stack. No scene needs more than a handful.

/// The deepest nesting of braces and comments that is read.
pub(super) const DEEPEST: usize = 32;

/// The byte at which a text is nested too deep, if it is.
pub(super) fn too_deep(text: &str) -> Option<usize> {
    let mut scanner = Scanner {
        bytes: text.as_bytes(),
        at: 0,
    };
    let (mut braces, mut slashdashes) = (0usize, 0usize);
    while let Some(byte) = scanner.peek(0) {
        match (byte, scanner.peek(1)) {
            (b'/', Some(b'/')) => scanner.skip_line(),
            (b'/', Some(b'*')) => {
                if let Some(at) = scanner.skip_comment() {
                    return Some(at);
                }
            }
            (b'"' | b'#', _) if scanner.skip_string() => {}
            (b'/', Some(b'-')) => {
                slashdashes += 1;
                scanner.at += 2;
            }
            (b'{', _) => {
                braces += 1;
                scanner.at += 1;
            }
            (b'}', _) => {
                braces = braces.saturating_sub(1);
                scanner.at += 1;
            }
            (other, _) => {
                // A run of slashdashes nests as well: each comments out the next.
                if !other.is_ascii_whitespace() {
                    slashdashes = 0;
                }
                scanner.at += 1;
            }
        }
        if braces > DEEPEST || slashdashes > DEEPEST {
            return Some(scanner.at.saturating_sub(1));
        }
    }
    None
}

/// A place in a text.
#[derive(Debug)]
struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Scanner<'_> {
    fn peek(&self, ahead: usize) -> Option<u8> {
        self.bytes.get(self.at + ahead).copied()
    }

    fn starts_with(&self, pattern: &[u8]) -> bool {
        self.bytes[self.at..].starts_with(pattern)
    }

    fn skip_line(&mut self) {
        while self.peek(0).is_some_and(|byte| byte != b'\n') {
            self.at += 1;
        }
    }

    /// Skips a block comment and those in it; gives the place where they nest too deep.
    fn skip_comment(&mut self) -> Option<usize> {
        let mut depth = 0usize;
        while self.at < self.bytes.len() {
            if self.starts_with(b"/*") {
                depth += 1;
                if depth > DEEPEST {
                    return Some(self.at);
                }
                self.at += 2;
            } else if self.starts_with(b"*/") {
                depth -= 1;
                self.at += 2;
            } else {
                self.at += 1;
            }
            if depth == 0 {
                break;
            }
        }
        None
    }

    /// Skips a quoted string: plain, of several lines (`"""`), or raw (`#"…"#`).
    fn skip_string(&mut self) -> bool {
        let hashes = self.bytes[self.at..]
            .iter()
            .take_while(|byte| **byte == b'#')
            .count();
        let quotes = &self.bytes[self.at + hashes..];
        let quotes = quotes.iter().take_while(|byte| **byte == b'"').count();
        let quotes = match quotes {
            0 => return false,
            3.. => 3,
            _ => 1,
        };
        self.at += hashes + quotes;
        let mut end = vec![b'"'; quotes];
        end.resize(quotes + hashes, b'#');
        while self.at < self.bytes.len() {
            if self.starts_with(&end) {
                self.at += end.len();
                break;
            }
            let escaped = hashes == 0 && self.peek(0) == Some(b'\\');
            self.at += if escaped { 2 } else { 1 };
        }
        self.at = self.at.min(self.bytes.len());
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn deep(text: &str) {
        assert!(too_deep(text).is_some(), "not found too deep");
    }

    #[track_caller]
    fn shallow(text: &str) {
        assert_eq!(too_deep(text), None);
    }

    #[test]
    fn deep_braces_comments_and_slashdashes_are_found() {
        deep(&"a {".repeat(3_000));
        deep(&"/*".repeat(30_000));
        deep(&"a {/*{*/".repeat(100));
        deep(&"/-".repeat(10_000));
        deep(&"/- ".repeat(10_000));
    }

    #[test]
    fn what_is_not_nested_is_not_counted() {
        shallow(&"a {}\n".repeat(10_000));
        shallow(&"a \"{{{\"\n".repeat(10_000));
        shallow(&"a #\"{\"{\"#\n".repeat(10_000));
        shallow(&"a \"\"\"\n{{\n\"\"\"\n".repeat(10_000));
        shallow(&"a \"\\\"{\"\n".repeat(10_000));
        shallow(&"// {{\n/* { */ /-a\n".repeat(10_000));
        shallow("\"\\");
    }
}
