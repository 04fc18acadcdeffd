//! A page of the documentation: its blocks of code, tables, headings, pictures and links.

use std::path::{Path, PathBuf};

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// A fenced block.
pub struct Block {
    /// What stands behind its fence.
    pub language: String,
    /// The lines between its fences.
    pub text: String,
    /// What the paragraph before it ends in, if it ends in code and a colon: the name of a file.
    pub name: Option<String>,
}

/// A cell of a table.
#[derive(Clone, Default)]
pub struct Cell {
    /// Its text.
    pub text: String,
    /// The code in it.
    pub code: Vec<String>,
}

/// What a page contains besides its prose.
#[derive(Default)]
pub struct Page {
    pub blocks: Vec<Block>,
    /// Blocks that are indented and have no fence.
    pub indented: Vec<String>,
    /// Tables by rows, the heads first.
    pub tables: Vec<Vec<Vec<Cell>>>,
    pub headings: Vec<String>,
    pub pictures: Vec<String>,
    pub links: Vec<String>,
}

/// The folder of the project.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The text of a file of the project.
pub fn read(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

impl Page {
    /// The page in a file of the project.
    pub fn of(path: &str) -> Page {
        Page::parse(&read(path))
    }

    pub fn parse(text: &str) -> Page {
        let mut page = Page::default();
        let (mut name, mut block, mut is_indented, mut is_heading) = (None, None, false, false);
        for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
            let cell = |page: &mut Page, part: &str, code: bool| {
                let row = page.tables.last_mut().and_then(|table| table.last_mut());
                if let Some(cell) = row.and_then(|row| row.last_mut()) {
                    cell.text.push_str(part);
                    cell.code.extend(code.then(|| part.to_owned()));
                }
            };
            let heading = |page: &mut Page, part: &str| {
                page.headings.last_mut().unwrap().push_str(part);
            };
            match event {
                Event::Start(Tag::Paragraph) => name = None,
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
                    block = Some(Block {
                        language: language.into_string(),
                        text: String::new(),
                        name: name.take(),
                    });
                }
                Event::Start(Tag::CodeBlock(CodeBlockKind::Indented)) => {
                    is_indented = true;
                    page.indented.push(String::new());
                }
                Event::End(TagEnd::CodeBlock) => {
                    is_indented = false;
                    page.blocks.extend(block.take());
                }
                Event::Start(Tag::Heading { .. }) => {
                    is_heading = true;
                    page.headings.push(String::new());
                }
                Event::End(TagEnd::Heading(_)) => is_heading = false,
                Event::Start(Tag::Table(_)) => page.tables.push(Vec::new()),
                Event::Start(Tag::TableHead | Tag::TableRow) => {
                    page.tables.last_mut().unwrap().push(Vec::new());
                }
                Event::Start(Tag::TableCell) => {
                    let row = page.tables.last_mut().and_then(|table| table.last_mut());
                    row.unwrap().push(Cell::default());
                }
                // What follows is not in it.
                Event::End(TagEnd::Table) => {
                    page.tables.last_mut().unwrap().push(Vec::new());
                }
                Event::Start(Tag::Link { dest_url, .. }) => {
                    page.links.push(dest_url.into_string());
                }
                Event::Start(Tag::Image { dest_url, .. }) => {
                    page.pictures.push(dest_url.into_string());
                }
                Event::Text(part) => match &mut block {
                    Some(block) => block.text.push_str(&part),
                    None if is_indented => page.indented.last_mut().unwrap().push_str(&part),
                    None if is_heading => heading(&mut page, &part),
                    None => {
                        name = name.filter(|_| &*part == ":");
                        cell(&mut page, &part, false);
                    }
                },
                Event::Code(part) if is_heading => heading(&mut page, &part),
                Event::Code(part) => {
                    name = Some(part.to_string());
                    cell(&mut page, &part, true);
                }
                _ => {}
            }
        }
        for table in &mut page.tables {
            table.retain(|row| !row.is_empty());
        }
        page
    }

    /// What a link leads to that ends in such a word behind `#`, as code hosts make them of headings.
    pub fn anchors(&self) -> Vec<String> {
        let anchor = |heading: &String| {
            let kept = heading.chars().filter_map(|own| match own {
                ' ' => Some('-'),
                '-' | '_' => Some(own),
                _ if own.is_alphanumeric() => Some(own),
                _ => None,
            });
            kept.flat_map(char::to_lowercase).collect()
        };
        self.headings.iter().map(anchor).collect()
    }

    /// The blocks in a language.
    pub fn blocks_in(&self, language: &str) -> impl Iterator<Item = &Block> {
        self.blocks
            .iter()
            .filter(move |block| block.language == language)
    }

    /// The rows of the one table with such a head, without the head.
    pub fn table(&self, head: &[&str]) -> &[Vec<Cell>] {
        let has_head = |table: &&Vec<Vec<Cell>>| {
            let own = table[0].iter().map(|cell| cell.text.trim());
            own.eq(head.iter().copied())
        };
        let mut found = self.tables.iter().filter(has_head);
        let table = found
            .next()
            .unwrap_or_else(|| panic!("no table has the head {head:?}"));
        assert!(found.next().is_none(), "two tables have the head {head:?}");
        assert!(table.len() > 1, "the table {head:?} is empty");
        &table[1..]
    }

    /// The code in a column of the one table with such a head.
    pub fn code(&self, head: &[&str], column: usize) -> Vec<&str> {
        let cells = self.table(head).iter().map(|row| &row[column]);
        cells
            .flat_map(|cell| &cell.code)
            .map(String::as_str)
            .collect()
    }
}
