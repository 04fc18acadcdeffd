//! What a document says, before anything is known of what it means.

use std::cmp::Ordering;
use std::fmt;
use std::ops::Range;

use crate::algebra::number::Rational;

/// A range of bytes of the document's text.
pub type Span = Range<usize>;

/// A name in both of its spellings; two names are equal when their ASCII spellings are.
#[derive(Clone, Debug)]
pub struct Name {
    /// `omega_n`: what JSON shows and what equality goes by.
    pub ascii: String,
    /// `ω_n`: what a person reads.
    pub unicode: String,
}

impl PartialEq for Name {
    fn eq(&self, other: &Self) -> bool {
        self.ascii == other.ascii
    }
}

impl Eq for Name {}

impl fmt::Display for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.unicode)
    }
}

/// A thing together with the place where it stands; two are equal wherever they stand.
#[derive(Clone, Debug)]
pub struct Spanned<T> {
    /// The thing.
    pub value: T,
    /// Where it stands.
    pub span: Span,
}

impl<T: PartialEq> PartialEq for Spanned<T> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

/// An expression and its place; two expressions are equal when they say the same, wherever they stand.
#[derive(Clone, Debug)]
pub struct Expression {
    /// What it says.
    pub node: Node,
    /// Where it stands (empty for an expression that the engine made).
    pub span: Span,
}

impl PartialEq for Expression {
    fn eq(&self, other: &Self) -> bool {
        self.node == other.node
    }
}

/// The forms an expression can take.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// `3`, `0.25`: exact.
    Number(Rational),
    /// `L_g`.
    Name(Name),
    /// `C_D′`, `C_D″`: a function's derivative of the given order, 1 or more, at the function's reference argument.
    Derivative(Name, u32),
    /// `-a`.
    Negative(Box<Expression>),
    /// `a + b` and its like.
    Binary(BinaryOperator, Box<Expression>, Box<Expression>),
    /// `cos(θ)`, `dt(x)`, `d(L, x)`, `C_D(α)` (order 0), `C_D′(α)` (order 1).
    Call {
        /// What is called.
        function: Name,
        /// How many primes stand behind the name.
        order: u32,
        /// What it is given.
        arguments: Vec<Expression>,
    },
    /// `[a, b; c, d]`, row by row; every row has at least one entry. Entries may be matrices (blocks).
    Matrix(Vec<Vec<Expression>>),
    /// `M[1, 3]`, `v[2]`: entries count from 1.
    Index(Box<Expression>, Vec<Expression>),
    /// `e at rest` or `e at (x = 0, y = 0)`.
    At(Box<Expression>, Place),
}

/// `+ - * / ^`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOperator {
    /// `a + b`
    Add,
    /// `a - b`
    Subtract,
    /// `a*b`
    Multiply,
    /// `a/b`
    Divide,
    /// `a^b`, also written `a**b`
    Power,
}

/// Where an expression is taken.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// A `substitution` or a `match` of the document, by name.
    Named(Spanned<Name>),
    /// Replacements on the spot.
    Replacements(Vec<Replacement>),
}

impl Place {
    /// A place by name that stands nowhere in a document.
    pub fn named(name: Name) -> Self {
        Place::Named(Spanned {
            value: name,
            span: 0..0,
        })
    }
}

/// `dt(x) = 0`.
#[derive(Clone, Debug, PartialEq)]
pub struct Replacement {
    /// What is replaced.
    pub target: Expression,
    /// By what.
    pub value: Expression,
}

/// `==`, `<` and their like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `==`
    Equal,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
}

impl Comparison {
    /// Whether it holds of two numbers in this order.
    pub fn holds(self, order: Ordering) -> bool {
        match self {
            Comparison::Equal => order == Ordering::Equal,
            Comparison::Less => order == Ordering::Less,
            Comparison::LessOrEqual => order != Ordering::Greater,
            Comparison::Greater => order == Ordering::Greater,
            Comparison::GreaterOrEqual => order != Ordering::Less,
        }
    }
}

/// `left == right`.
#[derive(Clone, Debug)]
pub struct Relation {
    /// The left side.
    pub left: Expression,
    /// How the sides are compared.
    pub comparison: Comparison,
    /// The right side.
    pub right: Expression,
}

/// What the document says of the sign of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// `> 0`
    Positive,
    /// `>= 0`
    NonNegative,
    /// `!= 0`
    NonZero,
    /// `< 0`
    Negative,
    /// `<= 0`
    NonPositive,
}

/// `(8, printed)` or `[centre of rotation]`.
#[derive(Clone, Debug)]
pub struct Label {
    /// `8, printed`: the text between the brackets.
    pub text: String,
    /// `8`: what stands before the first comma of a label in round brackets; none in square ones.
    pub equation: Option<String>,
    /// `8-printed`: lower-case ASCII letters, digits, dots and hyphens; unique in its document.
    pub id: String,
    /// Where it stands.
    pub span: Span,
}

/// What the author expects of an assertion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expectation {
    /// `claim`
    Holds,
    /// `refute`
    Refuted,
    /// `approximate`
    Approximate,
    /// `ill-formed`
    IllFormed,
}

/// `to order 1 in ρ, b_1`.
#[derive(Clone, Debug)]
pub struct Order {
    /// Terms up to this total degree must agree.
    pub order: Spanned<u32>,
    /// The small quantities, by name.
    pub small: Vec<Spanned<Name>>,
}

/// One statement of a document.
#[derive(Clone, Debug)]
pub struct Statement {
    /// What it says.
    pub kind: StatementKind,
    /// Where it stands.
    pub span: Span,
}

/// The forms a statement can take; `derivations/README.md` gives their grammar.
#[derive(Clone, Debug)]
pub enum StatementKind {
    /// `import "other.md"`
    Import {
        /// The document's path, relative to this one.
        path: Spanned<String>,
    },
    /// `parameter m : kg/m > 0 "mass per unit length"`
    Parameter {
        /// What is declared.
        names: Vec<Spanned<Name>>,
        /// `kg/m`: the text of the unit.
        unit: Spanned<String>,
        /// What is assumed of its sign.
        sign: Option<Sign>,
        /// In words.
        description: Option<String>,
    },
    /// `complex λ, μ : 1/s "eigenvalues"`: a constant that need not be real, and so has no sign
    Complex {
        /// What is declared.
        names: Vec<Spanned<Name>>,
        /// `1/s`
        unit: Spanned<String>,
        /// In words.
        description: Option<String>,
    },
    /// `angle α_g, θ_0 "…"`; the unit is rad
    Angle {
        /// What is declared.
        names: Vec<Spanned<Name>>,
        /// In words.
        description: Option<String>,
    },
    /// `coordinate x, y : m "…"`: a function of time
    Coordinate {
        /// What is declared.
        names: Vec<Spanned<Name>>,
        /// `m`
        unit: Spanned<String>,
        /// In words.
        description: Option<String>,
    },
    /// `function C_D, C_L at α_0 + θ_0 : 1 "…"`: known only through its derivatives
    Function {
        /// What is declared.
        names: Vec<Spanned<Name>>,
        /// Where the bare name is taken.
        reference: Expression,
        /// `1`
        unit: Spanned<String>,
        /// In words.
        description: Option<String>,
    },
    /// `imaginary i`: i² = −1
    Imaginary {
        /// What is declared.
        name: Spanned<Name>,
    },
    /// `assume L_g < r "…"`
    Assume {
        /// What is assumed.
        relation: Relation,
        /// Why.
        description: Option<String>,
    },
    /// `X := …`, `u, v := …, …`, `R(β) := …` (one target where there are arguments)
    Definition {
        /// What is defined.
        names: Vec<Spanned<Name>>,
        /// Its arguments, if it is a function of some.
        arguments: Vec<Spanned<Name>>,
        /// One for each name.
        values: Vec<Expression>,
    },
    /// `substitution rest: dt(x) = 0, dt(y) = 0`
    Substitution {
        /// How it is called.
        name: Spanned<Name>,
        /// What it replaces, all at once.
        replacements: Vec<Replacement>,
    },
    /// `claim`, `refute`, `approximate` or `ill-formed`
    Assertion {
        /// What the author expects.
        expectation: Expectation,
        /// How it is called.
        label: Label,
        /// What is asserted.
        relation: Relation,
        /// Of a refutation: what left − right is.
        difference: Option<Expression>,
        /// Of an approximation.
        order: Option<Order>,
        /// In words.
        description: Option<String>,
    },
    /// `eigenpair (15, mode 1) of K, M: value ω_n^2 vector [0; 1; 0] "…"`: K·v = value·M·v, v ≠ 0
    Eigenpair {
        /// How it is called.
        label: Label,
        /// K
        stiffness: Expression,
        /// M
        mass: Expression,
        /// The eigenvalue.
        value: Expression,
        /// The eigenvector, a column.
        vector: Expression,
        /// In words.
        description: Option<String>,
    },
    /// `match (20) closed_form: p with q in λ unknown b_1, b_2 at λ^3, λ neglect b_1*b_2 small ρ "…"`
    Match(Box<Matching>),
    /// `evaluator (21) closed_form: λ_R1 = λ_1, λ_R2 = λ_2 "…"`, or
    /// `evaluator (19, tuned) tuned: other at tuned "…"`
    Evaluator {
        /// How it is called in headers.
        label: Label,
        /// How it is called in programs.
        name: Spanned<Name>,
        /// What it computes.
        body: EvaluatorBody,
        /// What that is close to: `approximates real parts of section at tuned by roots`.
        approximated: Option<Approximated>,
        /// Where that means something: `where L_g > 0`.
        conditions: Vec<Relation>,
        /// In words.
        description: Option<String>,
    },
    /// `system (9) section: mass M damping structural = C_s, wind = C_a stiffness K in x, y, θ "…"`, or
    /// `system (9) section: equations [F_x; F_y] in x, y at rest "…"`
    System(Box<SystemStatement>),
    /// `domain m = [1, 50], U = [5, 40]`
    Domain(Vec<Replacement>),
    /// `show F_θ at rest "…"`
    Show {
        /// What is shown.
        expression: Expression,
        /// In words.
        description: Option<String>,
    },
}

/// Equations of motion that are to be computed.
#[derive(Clone, Debug)]
pub struct SystemStatement {
    /// How it is called in reports.
    pub label: Label,
    /// How it is called in commands.
    pub name: Spanned<Name>,
    /// What gives the matrices.
    pub body: SystemBody,
    /// The coordinates, in order.
    pub coordinates: Vec<Spanned<Name>>,
    /// In words.
    pub description: Option<String>,
}

/// What gives the matrices M, C and K of M q̈ + C q̇ + K q = 0.
#[derive(Clone, Debug)]
pub enum SystemBody {
    /// The matrices.
    Matrices {
        /// M
        mass: Expression,
        /// What C is the sum of; nothing for 0.
        damping: Vec<Part>,
        /// What K is the sum of.
        stiffness: Vec<Part>,
    },
    /// A column that is 0 as the coordinates move, linear in small motions about a state of rest.
    Equations {
        /// The column.
        equations: Expression,
        /// The state of rest.
        rest: Place,
    },
}

/// A part of a matrix.
#[derive(Clone, Debug)]
pub struct Part {
    /// How it is called, if it has a name.
    pub name: Option<Spanned<Name>>,
    /// What it is.
    pub matrix: Expression,
}

/// What an evaluator approximates.
#[derive(Clone, Debug)]
pub struct Approximated {
    /// Which numbers of the system its outputs are close to.
    pub quantities: Quantities,
    /// The system.
    pub system: Spanned<Name>,
    /// What is replaced in the system.
    pub place: Option<Place>,
    /// Whether the outputs are no such numbers but the coefficients of a polynomial whose roots are: monic, with
    /// the real parts from the power n − 1 down to 0, and then as many imaginary parts.
    pub by_roots: bool,
}

/// Numbers that a system has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantities {
    /// The real parts of its eigenvalues, one of each pair of conjugates.
    RealParts,
    /// Its eigenvalues with positive imaginary parts: as many real parts, and then the imaginary parts.
    Eigenvalues,
}

/// What an evaluator computes.
#[derive(Clone, Debug)]
pub enum EvaluatorBody {
    /// Named outputs.
    Outputs(Vec<(Spanned<Name>, Expression)>),
    /// The outputs of another evaluator after replacements.
    Special {
        /// The other evaluator.
        general: Spanned<Name>,
        /// What is replaced.
        place: Place,
    },
}

/// A matching of two polynomials, power by power.
#[derive(Clone, Debug)]
pub struct Matching {
    /// How it is called in the report.
    pub label: Label,
    /// How its solution is called as a substitution.
    pub name: Spanned<Name>,
    /// The polynomial that is known.
    pub exact: Expression,
    /// The form it is assumed to have.
    pub assumed: Expression,
    /// The variable whose powers are compared.
    pub variable: Spanned<Name>,
    /// What is solved for.
    pub unknowns: Vec<Spanned<Name>>,
    /// `λ^5, λ^3, λ, 1`: the powers whose coefficients are used, as exponents of the variable.
    pub powers: Vec<Spanned<u32>>,
    /// What is left out of the coefficients that are used.
    pub neglected: Vec<Expression>,
    /// The quantities by whose degree the residuals are ordered.
    pub small: Vec<Spanned<Name>>,
    /// In words.
    pub description: Option<String>,
}
