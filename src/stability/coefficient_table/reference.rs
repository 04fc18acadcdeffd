//! The lengths with which the coefficients of a table were made dimensionless.

use std::fmt;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

use super::row::Row;

/// The lengths, in m, that stand below the forces in the coefficients of a table, where a case says so: else D.
///
/// C_D = F_D/(½ρU² L), C_L = F_L/(½ρU² L) and C_M = M/(½ρU² L L′) with the forces F_D and F_L and the moment M of a unit
/// of length; the sections of this program have L = L′ = D.
///
/// ```
/// use sextic::stability::coefficient_table::reference::Reference;
///
/// let reference = Reference { lift: Some(0.3), moment: Some([0.3, 0.05]), ..Reference::default() };
/// assert_eq!(reference.factors(0.1), [1.0, 0.3 / 0.1, 0.3 / 0.1 * (0.05 / 0.1)]);
/// assert_eq!(reference.to_string(), "CL over 0.3 m, CM over 0.3 m × 0.05 m");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reference {
    /// That of C_D.
    #[serde(rename = "CD", skip_serializing_if = "Option::is_none")]
    pub drag: Option<f64>,
    /// That of C_L.
    #[serde(rename = "CL", skip_serializing_if = "Option::is_none")]
    pub lift: Option<f64>,
    /// Those of C_M, whose product counts.
    #[serde(
        default,
        rename = "CM",
        skip_serializing_if = "Option::is_none",
        deserialize_with = "two"
    )]
    pub moment: Option<[f64; 2]>,
}

impl Reference {
    /// Whether all coefficients have D.
    pub fn is_usual(&self) -> bool {
        *self == Reference::default()
    }

    /// The lengths that are given, with the names of the coefficients.
    pub fn lengths(&self) -> Vec<(&'static str, f64)> {
        let one = |name, own: Option<f64>| own.map(|own| (name, own));
        let [first, second] = self.moment.map_or([None; 2], |own| own.map(Some));
        [
            one("CD", self.drag),
            one("CL", self.lift),
            one("CM", first),
            one("CM", second),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// By what C_D, C_L and C_M are multiplied so that they stand over D and D².
    pub fn factors(&self, dimension: f64) -> [f64; 3] {
        let over = |own: f64| own / dimension;
        let moment = self.moment.map(|[one, other]| over(one) * over(other));
        [self.drag.map(over), self.lift.map(over), moment].map(|own| own.unwrap_or(1.0))
    }
}

/// Two numbers, no more and no fewer: the reader of TOML takes the first two of any.
fn two<'a, D: Deserializer<'a>>(deserializer: D) -> Result<Option<[f64; 2]>, D::Error> {
    let all = Vec::<f64>::deserialize(deserializer).unwrap_or_default();
    let both = <[f64; 2]>::try_from(all).map(Some);
    both.map_err(|_| D::Error::custom("CM is not two lengths, expected an array of length 2"))
}

impl fmt::Display for Reference {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let one = |name: &str, own: Option<f64>| own.map(|own| format!("{name} over {own} m"));
        let moment = self.moment.map(|[a, b]| format!("CM over {a} m × {b} m"));
        let all = [one("CD", self.drag), one("CL", self.lift), moment];
        formatter.write_str(&all.into_iter().flatten().collect::<Vec<_>>().join(", "))
    }
}

impl Row {
    /// The row with its coefficients, their errors and their slopes times these factors.
    pub(super) fn times(&self, factors: [f64; 3]) -> Self {
        let [drag, lift, moment] = factors;
        let mut row = Row {
            drag: self.drag * drag,
            lift: self.lift * lift,
            moment: self.moment * moment,
            ..*self
        };
        for ((error, slope), factor) in row.errors.iter_mut().zip(&mut row.slopes).zip(factors) {
            *error *= factor;
            *slope = slope.map(|own| own * factor);
        }
        row
    }
}
