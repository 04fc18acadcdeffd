//! What a matching leaves, power by power.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::substitution::{Replacing, Substitution};
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::algebra;
use crate::derivation::elaboration::limit::check_residuals;
use crate::language::diagnostic::Diagnostic;
use crate::language::syntax::Matching;

use super::{Coefficients, Row};

/// How far beyond the linear terms the order of a residual is looked for.
const HIGHEST_ORDER: u32 = 6;

impl Elaborator {
    /// Every power with what remains of it when the solution is put in, the highest first.
    pub(super) fn residuals(
        &mut self,
        matching: &Matching,
        coefficients: &Coefficients,
        solution: &Substitution,
    ) -> Result<Vec<Row>, Diagnostic> {
        let mut terms = 0;
        let mut solution = Replacing::by(solution);
        let rows = (0..=coefficients.degree()).rev();
        rows.map(|power| self.residual(power, matching, coefficients, &mut solution, &mut terms))
            .collect()
    }

    fn residual(
        &mut self,
        power: u32,
        matching: &Matching,
        coefficients: &Coefficients,
        solution: &mut Replacing,
        terms: &mut usize,
    ) -> Result<Row, Diagnostic> {
        let wrap = |error| algebra(error, &matching.exact.span);
        let (exact, assumed) = coefficients.at(power);
        let solved = solution.image(&assumed, &mut self.ring).map_err(wrap)?;
        let residual = self.ring.difference(&exact, &solved).map_err(wrap)?;
        *terms += residual.numerator().len() + residual.denominator().len();
        check_residuals(*terms, &matching.assumed.span)?;
        let leading = match &coefficients.small[..] {
            [] => None,
            small => {
                let leading = self.ring.leading_part(&residual, small, 0, HIGHEST_ORDER);
                leading.map_err(wrap)?
            }
        };
        let span = &matching.exact.span;
        Ok(Row {
            power,
            exact: self.present(&exact, span)?,
            assumed: self.present(&assumed, span)?,
            residual: self.present(&residual, span)?,
            order: leading.map(|(degree, _)| degree),
            used: matching.powers.iter().any(|used| used.value == power),
        })
    }
}
