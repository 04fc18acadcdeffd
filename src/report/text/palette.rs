//! The colours of the terminal.

use anstyle::{AnsiColor, Color, Style};

use crate::report::words::is_surprise;
use crate::verdict::claim::{Claim, Verdict};

/// Titles, labels.
pub const STRONG: Style = Style::new().bold();
/// Keywords, paths, hints.
pub const FAINT: Style = Style::new().dimmed();
/// Text.
pub const PLAIN: Style = Style::new();
/// What holds.
pub const GOOD: Style = AnsiColor::Green.on_default();
/// What nobody expected.
pub const ALARM: Style = Style::new()
    .fg_color(Some(Color::Ansi(AnsiColor::BrightWhite)))
    .bg_color(Some(Color::Ansi(AnsiColor::Red)))
    .bold();

/// A claim's verdict: only what its author did not expect is alarming.
pub fn of_claim(claim: &Claim) -> Style {
    if is_surprise(claim) {
        ALARM
    } else {
        of_verdict(claim.verdict)
    }
}

/// A verdict that is expected, or none.
pub fn of_verdict(verdict: Verdict) -> Style {
    match verdict {
        Verdict::Holds | Verdict::HoldsWhere => GOOD,
        Verdict::Approximate => AnsiColor::Cyan.on_default(),
        Verdict::Refuted | Verdict::IllFormed => AnsiColor::Magenta.on_default(),
        Verdict::Undecided | Verdict::Skipped => AnsiColor::Yellow.on_default(),
    }
}
