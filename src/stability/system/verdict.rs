//! Whether an instance is stable, and whether it diverges.

use crate::algebra::budget::Budget;
use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};
use crate::stability::half_plane::{MOST_PRODUCTS, Roots, roots_of_enclosed, roots_without_pairs};
use crate::stability::verdict::{Doubt, LONGEST_POLYNOMIAL, Verdict, verdict_by_errors};

use super::arithmetic::rational;
use super::disc::Enclosed;
use super::entries::Block;
use super::evaluation::DIGITS;
use super::instance::Instance;
use super::pencil::Pencil;

impl Instance<'_> {
    /// Whether the system is stable, with proof, for its parameters as they are written: by the errors of the eigenvalues
    /// where these decide it, else as [`Instance::exact_verdict`].
    pub fn verdict(&self) -> Verdict {
        let by_errors = self.spectrum().ok().and_then(|own| verdict_by_errors(&own));
        by_errors.unwrap_or_else(|| self.exact_verdict())
    }

    /// The verdict by the determinants of the characteristic polynomial, block by block: in exact sums of sines and
    /// cosines where the matrices have such entries, so that what is exactly 0 is known to be, else in enclosures with up
    /// to 4096 binary digits.
    ///
    /// Complexity: bounded, as [`exact_verdict`](crate::stability::verdict::exact_verdict) of a section, for each block.
    pub fn exact_verdict(&self) -> Verdict {
        let found = self.blocks.iter().map(|block| self.roots_of(block));
        let mut all = Ok(Roots::Left);
        for own in found {
            all = match (all, own) {
                (Ok(Roots::Right), _) | (_, Ok(Roots::Right)) => Ok(Roots::Right),
                (Err(doubt), _) | (_, Err(doubt)) => Err(doubt),
                (Ok(Roots::OnAxis), _) | (_, Ok(Roots::OnAxis)) => Ok(Roots::OnAxis),
                _ => Ok(Roots::Left),
            };
        }
        Verdict::from(all)
    }

    /// Where the roots of the polynomial of a block lie.
    fn roots_of(&self, block: &Block) -> Result<Roots, Doubt> {
        let pencil = self.pencil(Some(block));
        let enclosed = |intervals: &Intervals| self.scaled_polynomial(block, &pencil, intervals);
        let sums = TrigonometricSums::new(Budget::new(LONGEST_POLYNOMIAL));
        let Some(polynomial) = self.exact_polynomial(block, &pencil, &sums) else {
            return roots_of_enclosed(enclosed);
        };
        let squares = self.natural_squares(block, &pencil).into_iter();
        roots_without_pairs(
            polynomial,
            squares,
            &TrigonometricSums::new(Budget::new(MOST_PRODUCTS)),
        )
        .or_else(|doubt| roots_of_enclosed(enclosed).map_err(|_| doubt))
    }

    /// ν for the divisors λ² + ν that are likely where a motion is not damped: k/m of a coordinate alone.
    fn natural_squares(&self, block: &Block, pencil: &Pencil) -> Vec<Sum> {
        let Some(exact) = &self.exact else {
            return Vec::new();
        };
        let unit = Rational::try_from(pencil.unit * pencil.unit).unwrap_or(Rational::ONE);
        let own = |place: &usize| {
            let [stiffness, mass] = [0, 2].map(|power| rational(exact.at(power, *place, *place)));
            let mass = mass.filter(|own| !own.is_zero())?;
            Some(stiffness? / mass / &unit)
        };
        let mut squares: Vec<Rational> = block.iter().filter_map(own).collect();
        squares.sort();
        squares.dedup();
        squares.into_iter().map(Sum::from).collect()
    }

    /// Whether a real eigenvalue is above 0, so that a motion leaves without oscillating: by the signs of the determinants
    /// of K and M, an odd number of them; else by the signs of the coefficients, of which there is none without a change
    /// (Descartes), or by eigenvalues that stand alone. `None` if that leaves it open.
    pub fn diverges(&self) -> Option<bool> {
        let found: Vec<Option<bool>> = self
            .blocks
            .iter()
            .map(|own| self.block_diverges(own))
            .collect();
        match found.contains(&Some(true)) {
            true => Some(true),
            false => found.iter().all(Option::is_some).then_some(false),
        }
    }

    fn block_diverges(&self, block: &Block) -> Option<bool> {
        let intervals = Intervals::new(DIGITS[1]);
        let pencil = self.pencil(Some(block));
        let polynomial = self.scaled_polynomial(block, &pencil, &intervals)?;
        let signs: Vec<KnownSign> = polynomial.iter().map(Interval::sign).collect();
        let (first, last) = (signs.first()?, signs.last()?);
        match (first, last) {
            (KnownSign::Negative, KnownSign::Positive)
            | (KnownSign::Positive, KnownSign::Negative) => return Some(true),
            _ => (),
        }
        if signs
            .iter()
            .all(|own| own == last || *own == KnownSign::Zero)
        {
            return Some(false);
        }
        let eigenvalues = self.block_eigenvalues(block, &pencil)?;
        // What stands alone and is complex has a conjugate elsewhere, so that it is not real.
        let may_be_real = |own: &&Enclosed| !own.is_alone || own.value.im == 0.0;
        let mut real = eigenvalues.iter().filter(may_be_real);
        if real
            .clone()
            .any(|own| own.is_alone && own.value.re > own.radius)
        {
            return Some(true);
        }
        real.all(|own| own.value.re < -own.radius).then_some(false)
    }
}
