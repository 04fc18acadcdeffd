//! Why stability is not known.

/// Why there is no verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doubt {
    /// An eigenvalue is imaginary, exactly, and none has a positive real part.
    Neutral,
    /// A determinant is not told from 0 with so many binary digits, and too long to be known exactly.
    Digits(usize),
    /// Attitude and coefficients are open, by little, and it depends on what they are.
    Open,
    /// The coefficients of the characteristic polynomial have too many digits or terms.
    TooLong,
}
