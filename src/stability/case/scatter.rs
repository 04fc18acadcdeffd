//! What a case makes of a table that scatters.

use super::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::coefficient_table::scatter::{scatter, slopes};
use crate::stability::input::{Place, Remark};
use crate::stability::interpolation::Interpolation;

impl Case {
    /// That the numbers of its table scatter more than the case allows for: curves go through all rows, or the errors of
    /// the coefficients are smaller than that.
    pub fn scatter_remark(&self, table: &CoefficientTable) -> Option<Remark> {
        let found = scatter(table);
        let of_slopes = slopes(table, found);
        let largest = |column: usize| {
            let errors = table.rows().iter().map(|row| row.errors[column]);
            errors.fold(0.0, f64::max)
        };
        let parts = ["CD", "CL", "CM"].into_iter().enumerate();
        let parts: Vec<String> = parts
            .filter(|(column, _)| found[*column] > largest(*column))
            .map(|(column, name)| {
                let (own, slope) = (found[column], of_slopes[column]);
                format!("{name} by {own:.1e}, d{name} by {slope:.1e}")
            })
            .collect();
        // Of derivatives that the table gives no scatter is known.
        if table.has_slopes() {
            return None;
        }
        let has_errors = self.errors.is_some() || table.has_errors();
        let what = match (has_errors, self.interpolation) {
            _ if parts.is_empty() => return None,
            (true, _) => {
                "more than its errors, which are the largest and no standard deviations: what is certain within \
                 them is so only if they are true"
            }
            (false, Interpolation::Smooth) => return None,
            (false, _) => {
                "and curves go through all rows: say `interpolation = \"smooth\"`, or give the `errors` of the \
                 coefficients"
            }
        };
        Some(Remark {
            place: Place::file(table.file()),
            what: format!(
                "the numbers scatter about smooth curves ({}), {what}",
                parts.join("; ")
            ),
        })
    }
}
