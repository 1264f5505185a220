//! Markdown as blocks: paragraphs, list items, headings, table rows and code.

/// The kinds of blocks that the rules tell apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Paragraph,
    Item,
    Heading,
    TableRow,
    /// A fenced block; its text begins with the line that names the language.
    Code,
}

impl Kind {
    /// Whether the block is running text.
    pub(crate) fn is_prose(self) -> bool {
        matches!(self, Self::Paragraph | Self::Item)
    }
}

/// Lines that belong together, without the marks in front of them.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Block {
    pub(crate) kind: Kind,
    /// The number of its first line, from 1.
    pub(crate) line: usize,
    /// Its lines, joined by line ends.
    pub(crate) text: String,
}

impl Block {
    /// The number of the line on which a byte of the text stands.
    pub(crate) fn line_at(&self, offset: usize) -> usize {
        self.line + self.text[..offset].matches('\n').count()
    }
}

/// The blocks of numbered lines; line numbers must be consecutive.
pub(crate) fn blocks<'a>(lines: impl IntoIterator<Item = (usize, &'a str)>) -> Vec<Block> {
    let mut reader = Reader::default();
    for (line, text) in lines {
        reader.read(line, text);
    }
    reader.blocks
}

/// The blocks of a whole file.
pub(crate) fn blocks_of(text: &str) -> Vec<Block> {
    blocks(
        text.lines()
            .enumerate()
            .map(|(index, line)| (index + 1, line)),
    )
}

/// The descriptions in a JSON schema.
pub(crate) fn descriptions(schema: &str) -> Vec<Block> {
    let lines = schema.lines().enumerate();
    let texts = lines.filter_map(|(index, line)| {
        let text = line.trim().strip_prefix("\"description\": \"")?;
        Some((index + 1, text.trim_end_matches(['"', ','])))
    });
    let blocks = texts.map(|(line, text)| Block {
        kind: Kind::Paragraph,
        line,
        text: text.to_owned(),
    });
    blocks.collect()
}

#[derive(Default)]
struct Reader {
    blocks: Vec<Block>,
    /// Whether the next line can continue the last block.
    open: bool,
    in_code: bool,
    in_comment: bool,
    in_list: bool,
}

impl Reader {
    fn read(&mut self, line: usize, text: &str) {
        let bare = text.trim();
        let is_fence = bare.starts_with("```") || bare.starts_with("~~~");
        if self.in_code {
            self.add(bare.trim_end_matches('`'));
            self.in_code = !is_fence;
            self.open = self.in_code;
        } else if self.in_comment || bare.starts_with("<!--") {
            self.in_comment = !bare.ends_with("-->");
            self.open = false;
        } else if is_fence {
            self.start(Kind::Code, line, bare.trim_start_matches('`'));
            self.in_code = true;
        } else if bare.is_empty() {
            self.open = false;
        } else if bare.starts_with('#') {
            self.start(Kind::Heading, line, bare.trim_start_matches('#').trim());
            self.open = false;
        } else if bare.starts_with('|') {
            self.start(Kind::TableRow, line, bare);
            self.open = false;
        } else if let Some(item) = after_bullet(bare) {
            self.in_list = true;
            self.start(Kind::Item, line, item);
        } else if is_html(bare) || is_definition(bare) {
            self.open = false;
        } else if self.open {
            self.add(bare);
        } else {
            let indented = text.starts_with("    ");
            self.in_list &= text.starts_with(' ');
            if !indented || self.in_list {
                self.start(Kind::Paragraph, line, bare.trim_start_matches("> "));
            }
        }
    }

    fn start(&mut self, kind: Kind, line: usize, text: &str) {
        let text = text.to_owned();
        self.blocks.push(Block { kind, line, text });
        self.open = true;
    }

    fn add(&mut self, text: &str) {
        let last = self.blocks.last_mut().expect("an open block");
        last.text.push('\n');
        last.text += text;
    }
}

/// The text of a list item, if a line begins one.
fn after_bullet(line: &str) -> Option<&str> {
    let digits = line.trim_start_matches(|letter: char| letter.is_ascii_digit());
    let rest = if digits.len() < line.len() {
        digits.strip_prefix(['.', ')'])
    } else {
        line.strip_prefix(['-', '*', '+'])
    };
    rest?.strip_prefix(' ').map(str::trim)
}

/// Whether a line is a tag; `<https://…>` is text.
fn is_html(line: &str) -> bool {
    let name = line.strip_prefix('<');
    name.is_some_and(|name| {
        !name.starts_with("http")
            && name.starts_with(|letter: char| letter == '/' || letter.is_ascii_alphabetic())
    })
}

/// Whether a line is `[name]: target`.
fn is_definition(line: &str) -> bool {
    line.starts_with('[')
        && line
            .split_once("]: ")
            .is_some_and(|(name, _)| !name.contains(' '))
}

#[test]
fn a_page_is_cut_into_blocks() {
    let page = "# Title\n\nOne\ntwo.\n- three\n  four\n12. five\n\n    six\n\n| a | b |\n```sh\n- code\n\n# code\n```\n\
                <!-- no\ntext -->\nSeven\n\n    let code = 1;\n\n<img>\n[x]: y\n";
    let blocks = blocks_of(page);
    let found: Vec<_> = blocks
        .iter()
        .map(|block| (block.kind, block.line, block.text.as_str()))
        .collect();
    let expected = [
        (Kind::Heading, 1, "Title"),
        (Kind::Paragraph, 3, "One\ntwo."),
        (Kind::Item, 5, "three\nfour"),
        (Kind::Item, 7, "five"),
        (Kind::Paragraph, 9, "six"),
        (Kind::TableRow, 11, "| a | b |"),
        (Kind::Code, 12, "sh\n- code\n\n# code\n"),
        (Kind::Paragraph, 19, "Seven"),
    ];
    assert_eq!(found, expected);
    assert_eq!(blocks[1].line_at(0), 3);
    assert_eq!(blocks[1].line_at(4), 4);
}

#[test]
fn descriptions_are_found() {
    let schema = "{\n  \"title\": \"no\",\n  \"description\": \"some text\",\n}";
    let found = descriptions(schema);
    assert_eq!((found.len(), found[0].line), (1, 3));
    assert_eq!(found[0].text, "some text");
}
