//! What renderers add to CommonMark must not change which blocks are seen, and where.

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag};

use super::LANGUAGE;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::Span;

/// What GitHub adds: a footnote is moved to the end, or left out where nothing refers to it.
const OF_GITHUB: Options = Options::ENABLE_TABLES
    .union(Options::ENABLE_FOOTNOTES)
    .union(Options::ENABLE_STRIKETHROUGH)
    .union(Options::ENABLE_TASKLISTS)
    .union(Options::ENABLE_GFM)
    .union(Options::ENABLE_MATH);

/// What makers of pages add: metadata is not shown.
const METADATA: Options = Options::ENABLE_YAML_STYLE_METADATA_BLOCKS
    .union(Options::ENABLE_PLUSES_DELIMITED_METADATA_BLOCKS);

const RENDERERS: [Options; 3] = [OF_GITHUB, METADATA, Options::all()];

/// The blocks of this language that stand by themselves, in no list, quotation or footnote.
fn blocks(text: &str, options: Options) -> Vec<Span> {
    let mut found = Vec::new();
    let mut depth = 0_usize;
    for (event, span) in Parser::new_ext(text, options).into_offset_iter() {
        match event {
            Event::Start(tag) => {
                if depth == 0 && is_ours(&tag) {
                    found.push(span);
                }
                depth += 1;
            }
            Event::End(_) => depth = depth.saturating_sub(1),
            _ => {}
        }
    }
    found
}

fn is_ours(tag: &Tag<'_>) -> bool {
    match tag {
        Tag::CodeBlock(CodeBlockKind::Fenced(information)) => {
            information.split_whitespace().next() == Some(LANGUAGE)
        }
        _ => false,
    }
}

/// The first block that some renderer does not show where it is executed, or shows though it is not.
///
/// Complexity: that of reading the text as often as there are renderers.
pub(super) fn difference(text: &str, plain: &[Span]) -> Option<Diagnostic> {
    let difference = |options| {
        let others = blocks(text, options);
        let missing = plain.iter().find(|block| !others.contains(block));
        missing
            .or_else(|| others.iter().find(|block| !plain.contains(block)))
            .cloned()
    };
    let block = RENDERERS.into_iter().find_map(difference)?;
    let opening = text[block.clone()].lines().next().unwrap_or_default();
    let span = block.start..block.start + opening.len();
    let message = "renderers do not agree on whether there is a block here";
    let help = "end the footnote, the list of definitions or the metadata above it, or take it away; a line of `---` may begin metadata, and `***` does not";
    Some(
        Diagnostic::new(DiagnosticKind::Hidden, span, message)
            .with_label("not shown by all of them, or shown elsewhere")
            .with_help(help),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLOCK: &str = "```sextic\nclaim (1): 1 == 1\n```\n";

    #[test]
    fn what_is_added_hides_no_block() {
        for text in [
            format!("# Title\n\n{BLOCK}"),
            format!(
                "| a | b |\n|---|---|\n| 1 | 2 |\n{BLOCK}\nA note.[^1]\n\n[^1]: Below.\n\n{BLOCK}"
            ),
            format!("***\n\n{BLOCK}\n***\n\n{BLOCK}"),
            format!("> [!NOTE]\n> Look.\n\n{BLOCK}"),
            format!("$$\na\n$$\n\n{BLOCK}\nterm\n: words\n\n{BLOCK}"),
        ] {
            let plain = blocks(&text, Options::empty());
            assert_eq!(difference(&text, &plain), None, "{text}");
        }
        for text in [
            format!("---\ntitle: a\n{BLOCK}---\n"),
            format!("+++\ntitle = 1\n{BLOCK}+++\n"),
        ] {
            let plain = blocks(&text, Options::empty());
            assert!(difference(&text, &plain).is_some(), "{text}");
        }
    }
}
