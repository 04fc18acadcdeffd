//! How far a long computation is, on a terminal.

use indicatif::{ProgressBar, ProgressFinish, ProgressStyle};

/// A bar on the standard error stream, where that is a terminal, for so many of something.
pub(super) fn bar(count: u64, of: &str) -> ProgressBar {
    let bar = ProgressBar::new(count).with_finish(ProgressFinish::AndClear);
    let style = ProgressStyle::with_template(&format!(
        "{{bar:40}} {{percent}} %  {{human_pos}} of {{human_len}} {of}, {{eta}} left"
    ));
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
