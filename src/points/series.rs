//! Series of nodes in one small quantity ε.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use crate::algebra::number::Rational;

use super::derivative::By;
use super::graph::{FunctionId, Made, Node, NodeId, VariableId};
use super::sheet::Sheet;
use super::substitution::Substitution;
use super::{Failure, NoValue, Unknown};

/// Σ tₖ εⁿ⁺ᵏ; of one that is not exact nothing is known behind its last term.
#[derive(Clone, Debug)]
pub struct Series {
    /// n
    pub first: i64,
    /// tₖ
    pub terms: Vec<NodeId>,
    /// Whether all other terms are 0.
    pub is_exact: bool,
}

/// f⁽ᵏ⁾(a)
type Value = (FunctionId, u32, NodeId);

/// A series, or why there is none.
type Expanded = Result<Series, Failure>;

impl Series {
    /// A series of one term, t εⁿ.
    pub fn single(term: NodeId, power: i64) -> Self {
        Series {
            first: power,
            terms: vec![term],
            is_exact: true,
        }
    }

    /// 0
    fn zero() -> Self {
        Series {
            first: 0,
            terms: Vec::new(),
            is_exact: true,
        }
    }

    /// The power behind the last that is known.
    fn end(&self) -> i64 {
        self.first + self.terms.len() as i64
    }

    /// The term of a power; nothing where it is 0.
    ///
    /// # Errors
    ///
    /// [`Unknown::NoExpansion`] where it is not known.
    pub fn term(&self, power: i64) -> Result<Option<NodeId>, Failure> {
        let place = usize::try_from(power - self.first).ok();
        match place {
            None => Ok(None),
            Some(place) if place < self.terms.len() => Ok(Some(self.terms[place])),
            Some(_) if self.is_exact => Ok(None),
            Some(_) => Err(Unknown::NoExpansion.into()),
        }
    }

    fn shortened(mut self, length: usize) -> Self {
        if self.terms.len() > length {
            self.terms.truncate(length);
            self.is_exact = false;
        }
        self
    }
}

/// An expansion of nodes, each found once.
#[derive(Debug)]
pub struct Expansion {
    /// What becomes of variables.
    small: BTreeMap<VariableId, Series>,
    /// What becomes of values of functions; those without a series are multiplied by ε.
    functions: Vec<(Value, Option<Series>)>,
    /// How many terms are followed.
    length: usize,
    /// Whether negative powers of ε may occur on the way.
    allows_poles: bool,
    known: FxHashMap<NodeId, Series>,
}

impl Expansion {
    /// An expansion in variables and values of functions that are multiplied by ε, up to an order.
    pub fn small(
        variables: &[VariableId],
        functions: &[Value],
        order: u32,
        sheet: &mut Sheet,
    ) -> Result<Self, Failure> {
        let mut small = BTreeMap::new();
        for variable in variables {
            small.insert(*variable, Series::single(sheet.graph.free(*variable)?, 1));
        }
        Ok(Expansion {
            small,
            functions: functions.iter().map(|value| (*value, None)).collect(),
            length: order as usize + 1,
            allows_poles: false,
            known: FxHashMap::default(),
        })
    }

    /// An expansion in a variable that is a power of ε: by its powers for 1, by their falling order for −1.
    pub fn by_powers(
        by: By,
        power: i64,
        length: usize,
        sheet: &mut Sheet,
    ) -> Result<Self, Failure> {
        let series = Series::single(sheet.graph.integer(1)?, power);
        let (mut small, mut functions) = (BTreeMap::new(), Vec::new());
        match by {
            By::Variable(variable) => drop(small.insert(variable, series)),
            By::Function(function, order, place) => {
                functions.push(((function, order, place), Some(series)));
            }
            By::Time => return Err(Unknown::NoVariable.into()),
        }
        Ok(Expansion {
            small,
            functions,
            length,
            allows_poles: true,
            known: FxHashMap::default(),
        })
    }

    /// The series of a node.
    ///
    /// # Errors
    ///
    /// [`Unknown::NoExpansion`] where it has none of the wanted length.
    pub fn of(&mut self, root: NodeId, sheet: &mut Sheet) -> Expanded {
        for id in sheet.graph.unknown(root, |id| self.known.contains_key(&id)) {
            let series = self.rule(id, sheet);
            let series = series.map_err(|failure| sheet.graph.failure_within(root, failure));
            self.known.insert(id, series?.shortened(self.length));
        }
        Ok(self.known[&root].clone())
    }

    fn rule(&self, id: NodeId, sheet: &mut Sheet) -> Expanded {
        let node = sheet.graph.node(id).clone();
        let mut changes = false;
        node.visit(&mut |part| changes |= !self.stays(part));
        let of = |part: &NodeId| self.known.get(part).ok_or(Unknown::Unsupported);
        match &node {
            Node::Variable(variable) => Ok(match self.small.get(variable) {
                Some(series) => series.clone(),
                None => Series::single(id, 0),
            }),
            Node::Cosine(variable) | Node::Sine(variable) => match self.small.get(variable) {
                Some(turn) => self.circular(&node, turn, sheet),
                None => Ok(Series::single(id, 0)),
            },
            Node::Function {
                function,
                order,
                argument,
                reference,
            } => {
                for ((small, k, place), series) in &self.functions {
                    if (small, k) == (function, order) && sheet.is_same(*argument, *place)? {
                        let usual = || Series::single(id, 1);
                        return Ok(series.clone().unwrap_or_else(usual));
                    }
                }
                if !changes {
                    return Ok(Series::single(id, 0));
                }
                let argument = of(argument)?.clone();
                self.composed(&argument, sheet, |sheet, k, base| {
                    sheet.graph.function(*function, order + k, base, *reference)
                })
            }
            _ if !changes => Ok(match sheet.graph.is_zero(id) {
                true => Series::zero(),
                false => Series::single(id, 0),
            }),
            Node::Number(_) | Node::ImaginaryUnit => Ok(Series::single(id, 0)),
            Node::Sum(a, b) => self.sum(of(a)?, of(b)?, sheet),
            Node::Product(a, b) => self.product(of(a)?, of(b)?, sheet),
            Node::Quotient(a, b) => {
                let inverse = self.inverse(of(b)?, sheet)?;
                self.product(of(a)?, &inverse, sheet)
            }
            Node::Power(a, exponent) => self.power(of(a)?, *exponent, sheet),
            Node::Root(a) => self.root(of(a)?, sheet),
            Node::Direction { x, y, .. } => self.direction(of(x)?, of(y)?, sheet),
            Node::Guarded { value, .. } => Ok(of(value)?.clone()),
            Node::Detour(value) => {
                let mut series = of(value)?.clone();
                for term in &mut series.terms {
                    *term = sheet.graph.by_detour(*term)?;
                }
                Ok(series)
            }
        }
    }

    /// Whether a node does not depend on ε.
    fn stays(&self, id: NodeId) -> bool {
        let series = self.known.get(&id);
        series.is_some_and(|series| {
            series.is_exact
                && (series.terms.is_empty() || series.terms == [id])
                && series.first == 0
        })
    }

    /// A series of terms from a power to before another one.
    fn collected(
        &self,
        range: std::ops::Range<i64>,
        is_exact: bool,
        mut term: impl FnMut(i64) -> Made,
    ) -> Expanded {
        let end = range.end.min(range.start + self.length as i64);
        let terms: Result<Vec<NodeId>, Failure> = (range.start..end).map(&mut term).collect();
        Ok(Series {
            first: range.start,
            terms: terms?,
            is_exact: is_exact && end == range.end,
        })
    }

    fn sum(&self, a: &Series, b: &Series, sheet: &mut Sheet) -> Expanded {
        if a.terms.is_empty() && a.is_exact {
            return Ok(b.clone());
        }
        if b.terms.is_empty() && b.is_exact {
            return Ok(a.clone());
        }
        let end = match (a.is_exact, b.is_exact) {
            (true, true) => a.end().max(b.end()),
            (true, false) => b.end(),
            (false, true) => a.end(),
            (false, false) => a.end().min(b.end()),
        };
        let first = a.first.min(b.first);
        self.collected(first..end.max(first), a.is_exact && b.is_exact, |power| {
            let terms = [a.term(power)?, b.term(power)?];
            sheet.total(terms.into_iter().flatten())
        })
    }

    fn product(&self, a: &Series, b: &Series, sheet: &mut Sheet) -> Expanded {
        let first = a.first + b.first;
        let (n, m) = (a.terms.len(), b.terms.len());
        let is_zero = |series: &Series| series.is_exact && series.terms.is_empty();
        let length = match (a.is_exact, b.is_exact) {
            _ if is_zero(a) || is_zero(b) => 0,
            (true, true) => n + m - 1,
            (true, false) => m,
            (false, true) => n,
            (false, false) => n.min(m),
        };
        let is_exact = (a.is_exact && b.is_exact) || is_zero(a) || is_zero(b);
        self.collected(first..first + length as i64, is_exact, |power| {
            let place = (power - first) as usize;
            let mut sum = sheet.graph.integer(0)?;
            for i in place.saturating_sub(m.saturating_sub(1))..=place.min(n.saturating_sub(1)) {
                let (left, right) = (a.terms[i], b.terms[place - i]);
                if sheet.graph.is_zero(left) || sheet.graph.is_zero(right) {
                    continue;
                }
                let term = sheet.graph.product(left, right)?;
                sum = sheet.graph.sum(sum, term)?;
            }
            Ok(sum)
        })
    }

    /// The series from its first term on that is not 0 everywhere; nothing where it is 0.
    pub fn leading(&self, a: &Series, sheet: &mut Sheet) -> Result<Option<Series>, Failure> {
        let mut zeros = 0;
        while zeros < a.terms.len() && sheet.vanishes(a.terms[zeros])? {
            zeros += 1;
        }
        let found = Series {
            first: a.first + zeros as i64,
            terms: a.terms[zeros..].to_vec(),
            is_exact: a.is_exact,
        };
        match found.terms.is_empty() {
            true if a.is_exact => Ok(None),
            true => Err(Unknown::NoExpansion.into()),
            false => Ok(Some(found)),
        }
    }

    fn inverse(&self, a: &Series, sheet: &mut Sheet) -> Expanded {
        let a = self.leading(a, sheet)?.ok_or(NoValue::DivisionByZero)?;
        if a.first != 0 && !self.allows_poles {
            return Err(NoValue::DivisionByZero.into());
        }
        let one = sheet.graph.integer(1)?;
        let leading = sheet.graph.quotient(one, a.terms[0])?;
        let mut terms = vec![leading];
        let length = match a.is_exact {
            true if a.terms.len() == 1 => 1,
            true => self.length,
            false => a.terms.len().min(self.length),
        };
        for place in 1..length {
            let known = (1..=place.min(a.terms.len() - 1)).map(|j| (a.terms[j], terms[place - j]));
            let known: Vec<(NodeId, NodeId)> = known.collect();
            let sum = self.products(&known, sheet)?;
            let minus = sheet.graph.negative(sum)?;
            terms.push(sheet.graph.product(minus, leading)?);
        }
        Ok(Series {
            first: -a.first,
            is_exact: a.is_exact && a.terms.len() == 1,
            terms,
        })
    }

    /// Σ aᵢ bᵢ, without the products of what is 0.
    fn products(&self, pairs: &[(NodeId, NodeId)], sheet: &mut Sheet) -> Made {
        let mut sum = sheet.graph.integer(0)?;
        for (a, b) in pairs {
            if !sheet.graph.is_zero(*a) && !sheet.graph.is_zero(*b) {
                let term = sheet.graph.product(*a, *b)?;
                sum = sheet.graph.sum(sum, term)?;
            }
        }
        Ok(sum)
    }

    fn power(&self, a: &Series, exponent: u32, sheet: &mut Sheet) -> Expanded {
        let mut result = Series::single(sheet.graph.integer(1)?, 0);
        let (mut square, mut rest) = (a.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.product(&result, &square, sheet)?;
            }
            rest /= 2;
            if rest > 0 {
                square = self.product(&square, &square, sheet)?;
            }
        }
        Ok(result)
    }

    /// r with r² = a: 2 r₀ rₖ = aₖ − Σ rⱼ rₖ₋ⱼ.
    fn root(&self, a: &Series, sheet: &mut Sheet) -> Expanded {
        let Some(a) = self.leading(a, sheet)? else {
            return Ok(Series::zero());
        };
        match (a.first, self.allows_poles) {
            (0, _) => {}
            (_, false) => return Err(NoValue::NotSmooth.into()),
            (_, true) => return Err(Unknown::NoExpansion.into()),
        }
        let leading = sheet.graph.root(a.terms[0])?;
        let twice = sheet.graph.scaled(leading, Rational::from(2))?;
        let mut terms = vec![leading];
        let length = if a.is_exact {
            self.length
        } else {
            a.terms.len()
        };
        for place in 1..length {
            let known: Vec<(NodeId, NodeId)> =
                (1..place).map(|j| (terms[j], terms[place - j])).collect();
            let squares = self.products(&known, sheet)?;
            let own = match a.terms.get(place) {
                Some(term) => *term,
                None => sheet.graph.integer(0)?,
            };
            let rest = sheet.graph.difference(own, squares)?;
            terms.push(match sheet.surely_vanishes(rest) {
                true => sheet.graph.integer(0)?,
                false => sheet.graph.quotient(rest, twice)?,
            });
        }
        Ok(Series {
            first: 0,
            terms,
            is_exact: false,
        })
    }

    /// Σ f⁽ᵏ⁾(a₀) (a − a₀)ᵏ/k!
    fn composed(
        &self,
        argument: &Series,
        sheet: &mut Sheet,
        derivative: impl Fn(&mut Sheet, u32, NodeId) -> Made,
    ) -> Expanded {
        if argument.first < 0 {
            return Err(Unknown::NoExpansion.into());
        }
        let base = match argument.term(0)? {
            Some(base) => base,
            None => sheet.graph.integer(0)?,
        };
        let skipped = usize::try_from(1 - argument.first)
            .unwrap_or(0)
            .min(argument.terms.len());
        let step = Series {
            first: argument.first.max(1),
            terms: argument.terms[skipped..].to_vec(),
            is_exact: argument.is_exact,
        };
        let mut sum = Series {
            first: 0,
            terms: vec![derivative(sheet, 0, base)?],
            is_exact: true,
        };
        let mut power = Series::single(sheet.graph.integer(1)?, 0);
        let mut factorial = Rational::ONE;
        for k in 1..self.length as u32 {
            power = self.product(&power, &step, sheet)?;
            factorial *= Rational::from(k);
            let slope = derivative(sheet, k, base)?;
            let slope = sheet.graph.scaled(slope, Rational::ONE / &factorial)?;
            let term = self.product(&Series::single(slope, 0), &power, sheet)?;
            sum = self.sum(&sum, &term, sheet)?;
        }
        Ok(Series {
            is_exact: false,
            ..self.filled(sum, sheet)?
        })
    }

    /// A series with zeros behind its last term, up to the wanted length.
    fn filled(&self, mut series: Series, sheet: &mut Sheet) -> Expanded {
        let zero = sheet.graph.integer(0)?;
        if series.is_exact {
            let length = self.length.max(series.terms.len());
            series.terms.resize(length, zero);
        }
        Ok(series)
    }

    /// cos h or sin h of a small angle h.
    fn circular(&self, node: &Node, turn: &Series, sheet: &mut Sheet) -> Expanded {
        if turn.first < 1 {
            return Err(Unknown::NotAnAngle.into());
        }
        let first = u32::from(matches!(node, Node::Sine(_))) * 3;
        self.composed(turn, sheet, |sheet, k, _| {
            sheet
                .graph
                .integer([1, 0, -1, 0][((k + first) % 4) as usize])
        })
    }

    /// β with β′ = (x y′ − y x′)/(x² + y²).
    fn direction(&self, x: &Series, y: &Series, sheet: &mut Sheet) -> Expanded {
        if x.first < 0 || y.first < 0 {
            return Err(Unknown::NoExpansion.into());
        }
        let zero = sheet.graph.integer(0)?;
        let start = [x.term(0)?.unwrap_or(zero), y.term(0)?.unwrap_or(zero)];
        let start = sheet.direction(start[0], start[1])?;
        let (dx, dy) = (self.slope(x, sheet)?, self.slope(y, sheet)?);
        let (one, other) = (self.product(x, &dy, sheet)?, self.product(y, &dx, sheet)?);
        let minus = Series::single(sheet.graph.integer(-1)?, 0);
        let other = self.product(&minus, &other, sheet)?;
        let across = self.sum(&one, &other, sheet)?;
        let (x, y) = (self.product(x, x, sheet)?, self.product(y, y, sheet)?);
        let square = self.sum(&x, &y, sheet)?;
        let inverse = self.inverse(&square, sheet)?;
        let slope = self.product(&across, &inverse, sheet)?;
        let slope = self.filled(slope, sheet)?;
        let mut terms = vec![start];
        for power in 0..slope.end() {
            let term = slope.term(power)?.unwrap_or(zero);
            let share = Rational::ONE / Rational::from(power + 1);
            terms.push(sheet.graph.scaled(term, share)?);
        }
        Ok(Series {
            first: 0,
            terms,
            is_exact: false,
        }
        .shortened(self.length))
    }

    /// da/dε
    fn slope(&self, a: &Series, sheet: &mut Sheet) -> Expanded {
        let mut terms = Vec::new();
        for (power, term) in (a.first..).zip(&a.terms) {
            terms.push(sheet.graph.scaled(*term, Rational::from(power))?);
        }
        Ok(Series {
            first: a.first - 1,
            terms,
            is_exact: a.is_exact,
        })
    }
}

impl Sheet {
    /// The terms of total degree 0, …, `order` of a node in small variables and values of functions.
    ///
    /// # Errors
    ///
    /// [`Unknown::NoExpansion`] where there is none.
    pub fn parts(
        &mut self,
        node: NodeId,
        variables: &[VariableId],
        functions: &[Value],
        order: u32,
    ) -> Result<Vec<NodeId>, Failure> {
        let mut expansion = Expansion::small(variables, functions, order, self)?;
        let series = expansion.of(node, self)?;
        let zero = self.graph.integer(0)?;
        let mut at_zero = Substitution::default();
        at_zero.variables = variables.iter().map(|variable| (*variable, zero)).collect();
        at_zero.functions = functions.iter().map(|function| (*function, zero)).collect();
        let needed = at_zero.of(node, self)?;
        let mut parts = Vec::new();
        for power in 0..=i64::from(order) {
            let part = series.term(power)?.unwrap_or(zero);
            parts.push(self.graph.guarded(part, needed)?);
        }
        Ok(parts)
    }
}
