//! The names of the built-in functions, and how they are called.

/// What documents can call without declaring it.
pub const NAMES: [&str; 24] = [
    "sin",
    "cos",
    "tan",
    "cot",
    "sqrt",
    "angle",
    "dt",
    "d",
    "det",
    "transpose",
    "inverse",
    "adjugate",
    "trace",
    "diagonal",
    "identity",
    "zero",
    "row",
    "column",
    "submatrix",
    "kernel",
    "solve",
    "coefficient",
    "hurwitz",
    "truncate",
];

/// How many arguments a built-in function takes; the entries of `diagonal` are one or more.
pub fn arity(name: &str) -> usize {
    match name {
        "angle" | "d" | "solve" | "zero" | "row" | "column" => 2,
        "submatrix" | "coefficient" | "hurwitz" | "truncate" => 3,
        _ => 1,
    }
}

/// How a built-in function is called.
pub fn usage(name: &str) -> &'static str {
    match name {
        "sin" | "cos" | "tan" | "cot" => "write a call for each angle, such as `sin(α)`",
        "sqrt" => "write a call for each root: `sqrt(a)`",
        "angle" => "write `angle(x, y)`, with the components of the vector side by side",
        "dt" => "write `dt(a)`, or `dt([a; b])` for several",
        "d" => "write `d(f, x)`, or `d([f; g], [x; y])` for several",
        "det" | "adjugate" | "inverse" | "trace" | "transpose" | "kernel" => {
            "write one matrix between the brackets, such as `det([a, b; c, d])`"
        }
        "solve" => "write `solve(M, b)`, with a column for b, such as `[1; 2]`",
        "identity" => "write `identity(n)`: it is square",
        "zero" => "write `zero(n, k)`, for n rows and k columns",
        "row" | "column" => "write `row(M, n)` or `column(M, n)`",
        "submatrix" => "write `submatrix(M, [1, 2], [1, 3])`: the matrix, its rows, its columns",
        "coefficient" => "write `coefficient(p, λ, n)`, for the coefficient of λⁿ",
        "hurwitz" => "write `hurwitz(p, λ, n)`, for the n-th determinant",
        _ => "write `truncate(a, [x; y], n)`: the expression, the small quantities, the order",
    }
}
