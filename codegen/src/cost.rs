//! What a program costs.

use std::fmt;

use crate::program::{Operation, Program};

/// How many operations of each sort a program has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Sums, differences and changes of sign.
    pub additions: usize,
    /// Products.
    pub multiplications: usize,
    /// Quotients.
    pub divisions: usize,
    /// Square roots.
    pub roots: usize,
}

impl Cost {
    /// Counts the operations of a program.
    pub fn of(program: &Program) -> Self {
        let mut cost = Cost::default();
        for operation in program.operations() {
            match operation {
                Operation::Input(_) | Operation::Constant(_) => {}
                Operation::Add(..) | Operation::Subtract(..) | Operation::Negative(_) => {
                    cost.additions += 1;
                }
                Operation::Multiply(..) => cost.multiplications += 1,
                Operation::Divide(..) => cost.divisions += 1,
                Operation::SquareRoot(_) => cost.roots += 1,
            }
        }
        cost
    }

    /// All operations together.
    pub const fn total(&self) -> usize {
        self.additions + self.multiplications + self.divisions + self.roots
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.total() == 0 {
            return f.write_str("0 operations");
        }
        write!(f, "{} operations (", self.total())?;
        let parts = [
            (self.additions, "+"),
            (self.multiplications, "×"),
            (self.divisions, "÷"),
            (self.roots, "√"),
        ];
        let shown = parts.iter().filter(|(count, _)| *count > 0);
        for (place, (count, sign)) in shown.enumerate() {
            let separator = if place == 0 { "" } else { ", " };
            write!(f, "{separator}{count} {sign}")?;
        }
        f.write_str(")")
    }
}
