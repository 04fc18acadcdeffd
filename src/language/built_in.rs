//! The built-in functions, each declared once.
//!
//! A new one is an entry of [`ALL`] and a variant of [`BuiltIn`]; the compiler then says where it has no
//! meaning yet.

use super::syntax::Expression;

/// A call of a built-in function, with what each argument is.
#[derive(Clone, Copy, Debug)]
pub enum BuiltIn<'a> {
    /// `sin(α)` and its like
    Circular(Circular, &'a Expression),
    /// `sqrt(a)`
    Root(&'a Expression),
    /// `angle(x, y)`
    Direction(&'a Expression, &'a Expression),
    /// `dt(a)`
    Rate(&'a Expression),
    /// `d(f, q)`
    Jacobian(&'a Expression, &'a Expression),
    /// `det(M)`
    Determinant(&'a Expression),
    /// `transpose(M)`
    Transpose(&'a Expression),
    /// `inverse(M)`
    Inverse(&'a Expression),
    /// `adjugate(M)`
    Adjugate(&'a Expression),
    /// `trace(M)`
    Trace(&'a Expression),
    /// `diagonal(a, b, …)`
    Diagonal(&'a [Expression]),
    /// `identity(n)`
    Identity(&'a Expression),
    /// `zero(n, k)`
    Zero(&'a Expression, &'a Expression),
    /// `row(M, n)`
    Row(&'a Expression, &'a Expression),
    /// `column(M, n)`
    Column(&'a Expression, &'a Expression),
    /// `submatrix(M, rows, columns)`
    Submatrix(&'a Expression, &'a Expression, &'a Expression),
    /// `kernel(M)`
    Kernel(&'a Expression),
    /// `solve(M, b)`
    Solution(&'a Expression, &'a Expression),
    /// `coefficient(p, λ, n)`
    Coefficient(&'a Expression, &'a Expression, &'a Expression),
    /// `hurwitz(p, λ, n)`
    Hurwitz(&'a Expression, &'a Expression, &'a Expression),
    /// `truncate(a, [x; y], n)`
    Truncation(&'a Expression, &'a Expression, &'a Expression),
}

/// The circular functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Circular {
    /// sin
    Sine,
    /// cos
    Cosine,
    /// tan = sin/cos
    Tangent,
    /// cot = cos/sin
    Cotangent,
}

/// What is said of a built-in function.
#[derive(Clone, Copy, Debug)]
pub struct Declared {
    /// Its name.
    pub name: &'static str,
    /// How it is called, for who calls it otherwise.
    pub usage: &'static str,
    /// How LaTeX writes it.
    pub latex: Latex,
    read: Read,
}

/// How LaTeX writes a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Latex {
    /// By a command of this name: `\sin`.
    Command,
    /// By its name, upright.
    Upright,
    /// As the only argument with this above it: `M^{-1}`.
    Exponent(&'static str),
    /// As a root.
    Root,
    /// As a derivative by time.
    Rate,
    /// As a partial derivative.
    Partial,
}

/// How arguments are read: how many they are, and what they mean.
#[derive(Clone, Copy)]
enum Read {
    One(for<'a> fn(&'a Expression) -> BuiltIn<'a>),
    Two(for<'a> fn(&'a Expression, &'a Expression) -> BuiltIn<'a>),
    Three(for<'a> fn(&'a Expression, &'a Expression, &'a Expression) -> BuiltIn<'a>),
    Some(for<'a> fn(&'a [Expression]) -> BuiltIn<'a>),
}

impl std::fmt::Debug for Read {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{} arguments", self.count())
    }
}

impl Read {
    /// How many arguments there are, at least.
    const fn count(self) -> usize {
        match self {
            Read::One(_) | Read::Some(_) => 1,
            Read::Two(_) => 2,
            Read::Three(_) => 3,
        }
    }
}

const fn declared(name: &'static str, usage: &'static str, latex: Latex, read: Read) -> Declared {
    Declared {
        name,
        usage,
        latex,
        read,
    }
}

const ANGLE: &str = "write a call for each angle, such as `sin(α)`";
const MATRIX: &str = "write one matrix between the brackets, such as `det([a, b; c, d])`";
const LINE: &str = "write `row(M, n)` or `column(M, n)`";

/// All of them.
pub const ALL: [Declared; 24] = [
    declared(
        "sin",
        ANGLE,
        Latex::Command,
        Read::One(|a| BuiltIn::Circular(Circular::Sine, a)),
    ),
    declared(
        "cos",
        ANGLE,
        Latex::Command,
        Read::One(|a| BuiltIn::Circular(Circular::Cosine, a)),
    ),
    declared(
        "tan",
        ANGLE,
        Latex::Command,
        Read::One(|a| BuiltIn::Circular(Circular::Tangent, a)),
    ),
    declared(
        "cot",
        ANGLE,
        Latex::Command,
        Read::One(|a| BuiltIn::Circular(Circular::Cotangent, a)),
    ),
    declared(
        "sqrt",
        "write a call for each root: `sqrt(a)`",
        Latex::Root,
        Read::One(|a| BuiltIn::Root(a)),
    ),
    declared(
        "angle",
        "write `angle(x, y)`, with the components of the vector side by side",
        Latex::Upright,
        Read::Two(|a, b| BuiltIn::Direction(a, b)),
    ),
    declared(
        "dt",
        "write `dt(a)`, or `dt([a; b])` for several",
        Latex::Rate,
        Read::One(|a| BuiltIn::Rate(a)),
    ),
    declared(
        "d",
        "write `d(f, x)`, or `d([f; g], [x; y])` for several",
        Latex::Partial,
        Read::Two(|a, b| BuiltIn::Jacobian(a, b)),
    ),
    declared(
        "det",
        MATRIX,
        Latex::Command,
        Read::One(|a| BuiltIn::Determinant(a)),
    ),
    declared(
        "transpose",
        MATRIX,
        Latex::Exponent(r"\mathsf{T}"),
        Read::One(|a| BuiltIn::Transpose(a)),
    ),
    declared(
        "inverse",
        MATRIX,
        Latex::Exponent("-1"),
        Read::One(|a| BuiltIn::Inverse(a)),
    ),
    declared(
        "adjugate",
        MATRIX,
        Latex::Upright,
        Read::One(|a| BuiltIn::Adjugate(a)),
    ),
    declared(
        "trace",
        MATRIX,
        Latex::Upright,
        Read::One(|a| BuiltIn::Trace(a)),
    ),
    declared(
        "diagonal",
        "write its entries: `diagonal(a, b)`",
        Latex::Upright,
        Read::Some(|all| BuiltIn::Diagonal(all)),
    ),
    declared(
        "identity",
        "write `identity(n)`: it is square",
        Latex::Upright,
        Read::One(|a| BuiltIn::Identity(a)),
    ),
    declared(
        "zero",
        "write `zero(n, k)`, for n rows and k columns",
        Latex::Upright,
        Read::Two(|a, b| BuiltIn::Zero(a, b)),
    ),
    declared(
        "row",
        LINE,
        Latex::Upright,
        Read::Two(|a, b| BuiltIn::Row(a, b)),
    ),
    declared(
        "column",
        LINE,
        Latex::Upright,
        Read::Two(|a, b| BuiltIn::Column(a, b)),
    ),
    declared(
        "submatrix",
        "write `submatrix(M, [1, 2], [1, 3])`: the matrix, its rows, its columns",
        Latex::Upright,
        Read::Three(|a, b, c| BuiltIn::Submatrix(a, b, c)),
    ),
    declared(
        "kernel",
        MATRIX,
        Latex::Upright,
        Read::One(|a| BuiltIn::Kernel(a)),
    ),
    declared(
        "solve",
        "write `solve(M, b)`, with a column for b, such as `[1; 2]`",
        Latex::Upright,
        Read::Two(|a, b| BuiltIn::Solution(a, b)),
    ),
    declared(
        "coefficient",
        "write `coefficient(p, λ, n)`, for the coefficient of λⁿ",
        Latex::Upright,
        Read::Three(|a, b, c| BuiltIn::Coefficient(a, b, c)),
    ),
    declared(
        "hurwitz",
        "write `hurwitz(p, λ, n)`, for the n-th determinant",
        Latex::Upright,
        Read::Three(|a, b, c| BuiltIn::Hurwitz(a, b, c)),
    ),
    declared(
        "truncate",
        "write `truncate(a, [x; y], n)`: the expression, the small quantities, the order",
        Latex::Upright,
        Read::Three(|a, b, c| BuiltIn::Truncation(a, b, c)),
    ),
];

impl Declared {
    /// The built-in function of a name, if there is one.
    pub fn of(name: &str) -> Option<&'static Declared> {
        ALL.iter().find(|own| own.name == name)
    }

    /// How many arguments it takes; those of `diagonal` are one or more.
    pub const fn count(&self) -> usize {
        self.read.count()
    }

    /// What a call of it is; nothing if it does not take so many arguments.
    pub fn call<'a>(&self, arguments: &'a [Expression]) -> Option<BuiltIn<'a>> {
        match (self.read, arguments) {
            (Read::One(read), [a]) => Some(read(a)),
            (Read::Two(read), [a, b]) => Some(read(a, b)),
            (Read::Three(read), [a, b, c]) => Some(read(a, b, c)),
            (Read::Some(read), [_, ..]) => Some(read(arguments)),
            _ => None,
        }
    }
}

/// Whether a built-in function has this name.
pub fn is_built_in(name: &str) -> bool {
    Declared::of(name).is_some()
}

/// The names of all of them.
pub fn names<'a>() -> impl Iterator<Item = &'a str> {
    ALL.iter().map(|own| own.name)
}
