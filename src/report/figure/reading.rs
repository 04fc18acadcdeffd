//! What a figure says to who does not see it: the title and the description that SVG has for that.

use std::ops::Range;

use super::axis::tick;
use super::script;
use crate::report::markup::{escape, visible};

/// A title, and a description in sentences.
pub(super) struct Reading {
    title: String,
    sentences: Vec<String>,
}

impl Reading {
    /// What is shown, and what it is shown for.
    pub fn new(title: &str, subtitle: &str) -> Self {
        let mut reading = Reading {
            title: script::plain(title),
            sentences: Vec::new(),
        };
        if !subtitle.is_empty() {
            reading.say(subtitle);
        }
        reading
    }

    /// One more sentence.
    pub fn say(&mut self, sentence: &str) {
        self.sentences.push(script::plain(sentence));
    }

    /// What an axis shows.
    pub fn axis(&mut self, which: &str, label: &str, range: &Range<f64>) {
        let [from, to] = [range.start, range.end].map(|end| tick(&end));
        self.say(&format!("{which} axis: {label}, from {from} to {to}"));
    }

    /// A drawing as SVG with this in it.
    pub fn within(&self, svg: &str) -> String {
        let (opening, rest) = svg.split_once('>').unwrap_or((svg, ""));
        let sentences = self.sentences.iter().map(|own| format!("{own}."));
        let description = sentences.collect::<Vec<_>>().join(" ");
        let rest: String = rest.chars().map(visible).collect();
        format!(
            "{opening} role=\"img\">\n<title>{}</title>\n<desc>{}</desc>{rest}",
            escape(&self.title),
            escape(&description),
        )
    }
}
