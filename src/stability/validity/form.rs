//! The forms whose errors are looked at.

/// A form whose errors are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The closed forms, Eqs. (21)–(23).
    Closed,
    /// The uniform form of the first order in the damping.
    UniformFirst,
    /// The uniform form of the second order.
    UniformSecond,
}

impl Form {
    /// All of them, in the order of results.
    pub const ALL: [Form; 3] = [Form::Closed, Form::UniformFirst, Form::UniformSecond];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Form::Closed => "closed form (21)–(23)",
            Form::UniformFirst => "uniform form, first order",
            Form::UniformSecond => "uniform form, second order",
        }
    }

    /// In one word, as in tables for programs.
    pub fn word(self) -> &'static str {
        match self {
            Form::Closed => "closed",
            Form::UniformFirst => "uniform_first",
            Form::UniformSecond => "uniform_second",
        }
    }

    /// The order of what it leaves out of S/|S_a|: (δ|S_a|/e)², δ|S_a| or (δ|S_a|)², by
    /// `derivations/uniform.md`.
    pub fn order(self, eccentricity: f64, damping: f64) -> f64 {
        match self {
            Form::Closed => (damping / eccentricity).powi(2),
            Form::UniformFirst => damping,
            Form::UniformSecond => damping * damping,
        }
    }
}
