//! A quantity and its values.

use super::variable::Variable;

/// A quantity and its values, in order.
#[derive(Clone, Debug)]
pub struct Axis {
    /// The quantity.
    pub variable: Variable,
    values: Vec<f64>,
}

/// The most values of an axis.
pub const MOST_VALUES: usize = 1_000_000;

impl Axis {
    /// Evenly spaced values of a quantity, as [`spaced`] gives them.
    ///
    /// # Errors
    ///
    /// Those of [`spaced`].
    ///
    /// ```
    /// use sextic::stability::axis::Axis;
    /// use sextic::stability::variable::Variable;
    ///
    /// let speed = Variable::named("U").expect("a variable");
    /// assert_eq!(Axis::new(speed, 0.0, 0.3, 4)?.values(), [0.0, 0.1, 0.2, 0.3]);
    /// # Ok::<(), String>(())
    /// ```
    pub fn new(variable: Variable, from: f64, to: f64, count: usize) -> Result<Self, String> {
        let values = spaced(variable.name, from, to, count)?;
        Ok(Axis { variable, values })
    }

    /// A quantity at these values.
    pub(super) fn at(variable: Variable, values: Vec<f64>) -> Self {
        Axis { variable, values }
    }

    /// The values, at least one.
    pub fn values(&self) -> &[f64] {
        &self.values
    }
}

/// `count` values of a quantity of this name from the first to the last, evenly spaced; those between are
/// rounded to twelve digits, so that tables have no long tails.
///
/// # Errors
///
/// What is wrong, in words: a value that is not finite, no values or too many, one value from two ends.
///
/// ```
/// use sextic::stability::axis::spaced;
///
/// assert_eq!(spaced("U", 0.0, 0.3, 4)?, [0.0, 0.1, 0.2, 0.3]);
/// # Ok::<(), String>(())
/// ```
pub fn spaced(name: &str, from: f64, to: f64, count: usize) -> Result<Vec<f64>, String> {
    if !from.is_finite() || !to.is_finite() {
        return Err(format!("{name} from {from} to {to} is not finite"));
    }
    if count == 0 || count > MOST_VALUES {
        return Err(format!(
            "{name} has {count} values; 1 to {MOST_VALUES} are possible"
        ));
    }
    if count == 1 && from != to {
        return Err(format!(
            "{name} has one value but two ends, {from} and {to}"
        ));
    }
    let value = |place: usize| match place {
        0 => from,
        last if last == count - 1 => to,
        _ => {
            let share = place as f64 / (count - 1) as f64;
            rounded(from * (1.0 - share) + to * share)
        }
    };
    Ok((0..count).map(value).collect())
}

/// A number with twelve digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}
