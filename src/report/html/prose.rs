//! The prose of a document as HTML, between its blocks.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};

use super::visible;

/// A part of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Section {
    /// Prose, as HTML.
    Prose(String),
    /// A block in the language of the project: its bytes.
    Block(Range<usize>),
}

/// A heading of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Heading {
    /// What it says.
    pub text: String,
    /// Its anchor.
    pub anchor: String,
}

/// The prose and the blocks of a document in order, and its chapters, whose anchors begin with `prefix`.
///
/// The first heading, the title, is left out; the others go one level down. HTML in the document is
/// shown, not obeyed; pictures and links into other files are their texts, since the page stands alone.
pub fn sections(text: &str, prefix: &str) -> (Vec<Section>, Vec<Heading>) {
    let mut sections = Vec::new();
    let mut chapters: Vec<Heading> = Vec::new();
    let (mut events, mut links) = (Vec::new(), Vec::new());
    let (mut is_block, mut has_title, mut headings) = (false, false, 0);
    // The heading that is open, and whether it is shown.
    let mut open: Option<(String, Option<HeadingLevel>)> = None;
    for (event, span) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
        if let (Some((words, _)), Event::Text(part) | Event::Code(part)) = (&mut open, &event) {
            words.push_str(part);
        }
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(ref information)))
                if information.split_whitespace().next() == Some("sextic") =>
            {
                is_block = true;
                sections.push(Section::Prose(written(std::mem::take(&mut events))));
                sections.push(Section::Block(span));
            }
            Event::End(TagEnd::CodeBlock) if is_block => is_block = false,
            _ if is_block => {}
            Event::Start(Tag::Heading { .. }) if !has_title => {
                has_title = true;
                open = Some((String::new(), None));
            }
            Event::Start(Tag::Heading { level, .. }) => {
                open = Some((String::new(), Some(level)));
                headings += 1;
                events.push(Event::Start(Tag::Heading {
                    level: below(level),
                    id: Some(format!("{prefix}-{headings}").into()),
                    classes: Vec::new(),
                    attrs: Vec::new(),
                }));
            }
            Event::End(TagEnd::Heading(_)) => {
                let Some((words, Some(level))) = open.take() else {
                    continue;
                };
                events.push(Event::End(TagEnd::Heading(below(level))));
                if level <= HeadingLevel::H2 {
                    chapters.push(Heading {
                        text: words,
                        anchor: format!("{prefix}-{headings}"),
                    });
                }
            }
            _ if matches!(open, Some((_, None))) => {}
            Event::Html(code) | Event::InlineHtml(code) => events.push(Event::Text(code)),
            Event::Start(Tag::HtmlBlock) => events.push(Event::Start(Tag::Paragraph)),
            Event::End(TagEnd::HtmlBlock) => events.push(Event::End(TagEnd::Paragraph)),
            Event::Start(Tag::Link { ref dest_url, .. }) => {
                let is_kept = is_elsewhere(dest_url);
                links.push(is_kept);
                if is_kept {
                    events.push(event);
                }
            }
            Event::End(TagEnd::Link) => {
                if links.pop() == Some(true) {
                    events.push(event);
                }
            }
            Event::Start(Tag::Image { .. }) | Event::End(TagEnd::Image) => {}
            other => events.push(other),
        }
    }
    sections.push(Section::Prose(written(events)));
    sections.retain(|section| !matches!(section, Section::Prose(html) if html.is_empty()));
    (sections, chapters)
}

/// Whether a reader of the page alone can follow a link.
fn is_elsewhere(address: &str) -> bool {
    ["https://", "http://", "mailto:"]
        .iter()
        .any(|scheme| address.starts_with(scheme))
}

fn below(level: HeadingLevel) -> HeadingLevel {
    HeadingLevel::try_from(level as usize + 1).unwrap_or(HeadingLevel::H6)
}

fn written(events: Vec<Event>) -> String {
    let mut page = String::new();
    html::push_html(&mut page, events.into_iter());
    page.chars().map(visible).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn prose(text: &str) -> String {
        let (sections, _) = sections(text, "p");
        let written = sections.into_iter().map(|section| match section {
            Section::Prose(html) => html,
            Section::Block(_) => "[block]".to_owned(),
        });
        written.collect()
    }

    #[test]
    fn prose_is_set_and_html_is_shown() {
        for (text, expected) in [
            ("# T\n\n## A *b*\n", "<h3 id=\"p-1\">A <em>b</em></h3>\n"),
            ("a <b>\n", "<p>a &lt;b&gt;</p>\n"),
            (
                "<script>alert(1)</script>\n",
                "<p>&lt;script&gt;alert(1)&lt;/script&gt;\n</p>\n",
            ),
            (
                "[a](b.md) [c](javascript:d) ![e](https://f)\n",
                "<p>a c e</p>\n",
            ),
            ("[a](https://b)\n", "<p><a href=\"https://b\">a</a></p>\n"),
            ("```sextic\nx\n```\n", "[block]"),
            ("\u{1b}\n", "<p>\u{FFFD}</p>\n"),
        ] {
            assert_eq!(prose(text), expected, "{text}");
        }
    }
}
