//! The ranges of a quantity on which a system is stable, or not, for a terminal.

use crate::report::ranges::RangesFound;
use crate::report::stability::{bound_with, decimal, decimals};

/// Digits of the ends of ranges that nothing bounds.
const MOST_DECIMALS: i32 = 9;

/// A line for each range, and one for each value at which stability changes.
pub fn ranges(found: &RangesFound) -> String {
    let (name, own) = (&found.over, &found.ranges);
    let mut text = format!("{} along {name}\n", found.system);
    for range in &own.ranges {
        let [from, to] = [range.from, range.to].map(short);
        text += &format!("  {name} from {from} to {to}: {}\n", range.stability.name());
    }
    for value in &own.critical {
        let decimals = decimals(value.error, MOST_DECIMALS);
        text += &format!(
            "Critical: {name} = {}, within {}: {} above it\n",
            decimal(value.value, decimals),
            bound_with(value.error, decimals),
            value.becomes.name()
        );
    }
    if own.critical.is_empty() {
        text += "Nothing changes for certain between the ends\n";
    }
    text
}

/// A number without zeros at its end.
fn short(number: f64) -> String {
    if number.abs() >= 1e15 {
        return format!("{number:e}");
    }
    let digits = decimal(number, MOST_DECIMALS);
    match digits.contains('.') && !digits.contains('e') {
        true => digits
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_string(),
        false => digits,
    }
}
