//! What a page tells its reader to do: files to write, commands to give, and what these print.

use super::page::{Block, Page};

/// What stands in a block.
#[derive(Debug, PartialEq)]
pub enum Step {
    /// A file, in a block of any language below a paragraph that ends in its name and a colon.
    File { name: String, text: String },
    /// Commands, in a block of `sh`; what they print is not shown.
    Commands(String),
    /// A command in a block of `console`, behind `$`, and what it prints.
    Shown { command: String, output: String },
}

/// The steps of a page, from its beginning to its end.
pub fn steps(page: &Page) -> Vec<Step> {
    page.blocks.iter().flat_map(steps_of).collect()
}

fn steps_of(block: &Block) -> Vec<Step> {
    match (&*block.language, &block.name) {
        ("sh", _) => vec![Step::Commands(block.text.clone())],
        ("console", _) => shown(&block.text),
        (_, Some(name)) => vec![Step::File {
            name: name.clone(),
            text: block.text.clone(),
        }],
        _ => Vec::new(),
    }
}

fn shown(text: &str) -> Vec<Step> {
    let mut steps: Vec<(String, String)> = Vec::new();
    let mut goes_on = false;
    for line in text.lines() {
        match (line.strip_prefix("$ "), steps.last_mut()) {
            (_, Some((command, _))) if goes_on => *command += &format!("\n{line}"),
            (Some(command), _) => steps.push((command.to_owned(), String::new())),
            (None, Some((_, output))) => {
                *output += &format!("{line}\n");
                continue;
            }
            (None, None) => panic!("of no command is this output:\n{text}"),
        }
        goes_on = line.ends_with('\\');
    }
    let step = |(command, output)| Step::Shown { command, output };
    steps.into_iter().map(step).collect()
}

/// Where a shown output differs from a printed one; a line `⋮` stands for any lines. A space that does not break is a
/// space.
pub fn difference(shown: &str, printed: &str) -> Option<String> {
    let printed = printed.replace('\u{a0}', " ");
    let printed: Vec<&str> = printed.trim_matches('\n').lines().collect();
    let shown: Vec<&str> = shown.trim_matches('\n').lines().collect();
    let chunks: Vec<&[&str]> = shown.split(|line| *line == "⋮").collect();
    let last = chunks.len() - 1;
    let mut from = 0;
    for (place, chunk) in chunks.iter().enumerate() {
        if chunk.is_empty() && 0 < place && place < last {
            return Some("nothing stands between two ⋮".into());
        }
        let mut fitting = (from..=printed.len()).filter(|&start| {
            printed[start..].starts_with(chunk)
                && (place > 0 || start == 0)
                && (place < last || start + chunk.len() == printed.len())
        });
        let Some(start) = fitting.next() else {
            return Some(format!("not printed, or not there:\n{}", chunk.join("\n")));
        };
        from = start + chunk.len();
    }
    None
}

#[test]
fn what_is_not_printed_is_found() {
    let printed = "a\nb\n\nc\nd\n";
    for (shown, agrees) in [
        ("a\nb\n\nc\nd\n", true),
        ("a\n⋮\nd\n", true),
        ("⋮\nb\n⋮\nd\n", true),
        ("⋮\nb\n\nc\n⋮\n", true),
        ("a\nb\n⋮\n", true),
        ("⋮\n", true),
        ("", false),
        ("a\nb\n", false),
        ("b\n⋮\n", false),
        ("⋮\nc\n", false),
        ("⋮\nc\n⋮\nb\n⋮\n", false),
        ("⋮\nb\nc\n⋮\n", false),
        ("⋮\nb\n⋮\n⋮\nd\n", false),
        ("a\n⋮\nD\n", false),
        ("a\nb \n\nc\nd\n", false),
        ("a\nb\n\nc\nd\ne\n", false),
    ] {
        let found = difference(shown, printed);
        assert_eq!(found.is_none(), agrees, "{shown:?}: {found:?}");
    }
    assert_eq!(difference("", ""), None);
    assert_eq!(difference("1 m\n", "1\u{a0}m\n"), None);
}

#[test]
fn steps_are_read_in_their_order() {
    let page = Page::parse(
        "Write this as `a.c`:\n\n```c\nint a;\n```\n\nAs `b` has it.\n\n```c\nint b;\n```\n\n\
         ```sh\ncc a.c\n```\n\n```console\n$ ./a \\\n    --all\n1\n$ ./b\n```\n",
    );
    let file = Step::File {
        name: "a.c".into(),
        text: "int a;\n".into(),
    };
    let shown = |command: &str, output: &str| Step::Shown {
        command: command.into(),
        output: output.into(),
    };
    let expected = [
        file,
        Step::Commands("cc a.c\n".into()),
        shown("./a \\\n    --all", "1\n"),
        shown("./b", ""),
    ];
    assert_eq!(steps(&page), expected);
}
