//! What speaks against a closed form.

use std::fmt;
use std::sync::LazyLock;

/// Damping of a mode above this share of its frequency is not small.
pub(super) const STRONG: f64 = 0.1;

/// What speaks against a closed form for a section.
///
/// In the order in which one should look; of one kind, the greater is the worse.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub enum Limitation {
    /// A coordinate is held: they do not apply.
    NotAllFree,
    /// No modes without wind, or no roots, were found in doubles.
    NoRoots,
    /// The natural frequencies differ: they do not apply.
    NotTuned,
    /// There is structural damping, which they leave out.
    StructuralDamping,
    /// There is aerodynamic stiffness, which the form leaves out.
    AerodynamicStiffness,
    /// e ≤ δ|S|: the modes are separated by less than they are damped, and even the sign may be wrong. The damping
    /// stands first, since what is damped more is worse.
    Eccentricity {
        /// δ|S| with δ = ρ D U/(2 m ω_n) and the Frobenius norm of S_a, Eq. (18).
        damping: f64,
        /// e = L_g/r.
        eccentricity: f64,
    },
    /// |S| ≤ |S_a| (δ|S_a|/e)²: what is left out may be as large as the result, and of the other sign.
    Sign {
        /// (δ|S_a|/e)².
        second_order: f64,
    },
    /// The damping is not small beside the frequencies: what is left out may matter.
    StrongDamping {
        /// The largest |λ_R|/ω of a mode by the closed forms; by the uniform form |B|/(2ν), the damping in modal
        /// coordinates over twice the lowest frequency.
        damping: f64,
    },
}

impl Limitation {
    /// In a word, as in tables: `held`, `detuned`, `damped`, `stiffness`, `eccentricity`, `sign`,
    /// `strong` or `no-roots`.
    pub fn name(&self) -> &'static str {
        NAMES[self.place()]
    }

    /// The place of its name.
    fn place(&self) -> usize {
        match self {
            Limitation::NotAllFree => 0,
            Limitation::NoRoots => 1,
            Limitation::NotTuned => 2,
            Limitation::StructuralDamping => 3,
            Limitation::AerodynamicStiffness => 4,
            Limitation::Eccentricity { .. } => 5,
            Limitation::Sign { .. } => 6,
            Limitation::StrongDamping { .. } => 7,
        }
    }
}

/// The names of all limitations, in the order in which one should look.
const NAMES: [&str; 8] = [
    "held",
    "no-roots",
    "detuned",
    "damped",
    "stiffness",
    "eccentricity",
    "sign",
    "strong",
];

/// Which limitations there are, without their numbers: as a table of many sections has them.
///
/// ```
/// use sextic::stability::limitation::{Limitation, Limits};
///
/// let found = [Limitation::StrongDamping { damping: 0.2 }, Limitation::StructuralDamping];
/// assert_eq!(found.into_iter().collect::<Limits>().words(), "damped strong");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Limits(u8);

impl Limits {
    /// Their [names](Limitation::name) in order, with spaces between them.
    pub fn words(self) -> &'static str {
        static WORDS: LazyLock<Vec<String>> = LazyLock::new(|| (0..=u8::MAX).map(words).collect());
        &WORDS[usize::from(self.0)]
    }
}

/// The names of the limitations whose places are bits of a number.
fn words(bits: u8) -> String {
    let names = NAMES.iter().enumerate();
    let own = names.filter(|(place, _)| bits >> place & 1 == 1);
    own.map(|(_, name)| *name).collect::<Vec<_>>().join(" ")
}

impl FromIterator<Limitation> for Limits {
    fn from_iter<I: IntoIterator<Item = Limitation>>(limitations: I) -> Self {
        let bits = limitations.into_iter().map(|own| 1 << own.place());
        Limits(bits.fold(0, |all, own| all | own))
    }
}

impl fmt::Display for Limitation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Limitation::NotAllFree => {
                write!(
                    formatter,
                    "this form needs x, y and theta free, and not all are"
                )
            }
            Limitation::NotTuned => write!(
                formatter,
                "the closed form needs perfect tuning, and the natural frequencies differ"
            ),
            Limitation::StructuralDamping => {
                write!(
                    formatter,
                    "the closed form leaves the structural damping out"
                )
            }
            Limitation::AerodynamicStiffness => {
                write!(
                    formatter,
                    "aerodynamic stiffness is on, and this form leaves it out"
                )
            }
            Limitation::Eccentricity {
                eccentricity,
                damping,
            } => write!(
                formatter,
                "the eccentricity L_g/r = {} is not above the aerodynamic damping δ|S_a| = {}: the closed form may have the wrong sign",
                short(*eccentricity),
                short(*damping)
            ),
            Limitation::Sign { second_order } => write!(
                formatter,
                "the closed form leaves out what is of the order (δ|S_a| r/L_g)² = {second_order:.1e} of |S_a|, as much as its S: it may have the wrong sign"
            ),
            Limitation::StrongDamping { damping } => write!(
                formatter,
                "the damping is not small: {damping:.2} of a frequency; the form leaves out higher orders of it"
            ),
            Limitation::NoRoots => write!(
                formatter,
                "the modes without wind were not found in doubles"
            ),
        }
    }
}

/// A number that is not negative, with three decimals or a power of ten.
fn short(number: f64) -> String {
    match number {
        0.0 => "0".to_string(),
        0.01..1e3 => format!("{number:.3}"),
        _ => format!("{number:.2e}"),
    }
}
